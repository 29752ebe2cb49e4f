#!/usr/bin/env python3
"""What computer-algebra systems answer when they are asked for antiderivatives of 500 rational functions (functions.py): asks those that are
installed (systems.py), judges the answers (judge.py), and writes docs/audit/integrals.json and the tables of docs/audit.md from it.

    apt-get install maxima fricas xcas pari-gp && python3 -m venv audit && audit/bin/pip install sympy==1.14.0 python-flint==0.9.0
    PHRAME_PROGRAM=build/dev/bin/phrame audit/bin/python tools/audit/integrals.py --work /tmp/audit/integrals
    … --only giac             one system again; the rest of the log stays
    … --show rioboo           what they answer to one function; the log stays
    … --render                the tables of docs/audit.md from the log

Answers that are in the folder already are not asked for again.
"""
import argparse
import json
import statistics
import sys
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import audit

LOG, PAGE = audit.ROOT / "docs/audit/integrals.json", audit.PAGE


def ask(name, rows, file):
    """A line for each function, in the file."""
    import systems
    done = {json.loads(line)[0] for line in file.read_text().splitlines()} if file.exists() else set()
    system = systems.SYSTEMS[name]()
    with file.open("a") as out:
        for label, _, f in rows:
            if label not in done:
                out.write(json.dumps([label, *system.ask(f)]) + "\n")
                out.flush()
    system.stop()
    return system.version()


def verdict(f, answer, why, seconds):
    """A cell of the log: the verdict, the seconds, and what is to be said of it."""
    import judge
    import systems
    if why == "time" or seconds is not None and seconds > systems.LIMIT:
        return "time"
    if answer is None:
        word = "unread" if why == "to print it" or why.endswith(" letters") else "none"
        return word if seconds is None else "%s %.2g" % (word, seconds)
    word, more = judge.judged(f, answer)
    return " ".join(["%s %.2g" % (word, seconds), *([str(more)] if more is not None else [])])


def measure(options):
    import functions
    import judge
    import systems
    rows = functions.functions()
    options.work.mkdir(exist_ok=True, parents=True)
    log = json.loads(LOG.read_text()) if LOG.exists() else {"systems": {}, "functions": {}}
    if log.setdefault("digest", functions.digest()) != functions.digest():
        sys.exit("the log is of other functions: begin a new one")
    log["limit"] = systems.LIMIT
    names = [name for name in systems.SYSTEMS if options.only is None or name in options.only]
    answers = {}
    for name in names:
        if not systems.is_there(name):
            print(name, "is not installed")
            continue
        file = options.work / (name + ".jsonl")
        log["systems"][name] = ask(name, rows, file)
        answers[name] = {label: cell for label, *cell in map(json.loads, file.read_text().splitlines())}
        print(name, log["systems"][name], flush=True)
    for label, family, text in rows:
        f = judge.Rational(text)
        cells = log["functions"].setdefault(label, {"family": family})
        cells.update({name: verdict(f, *found[label]) for name, found in answers.items()})
    audit.write(log, LOG)


def show(label):
    import functions
    import judge
    import systems
    text = next(f for name, _, f in functions.functions() if name == label)
    print(text)
    for name in systems.SYSTEMS:
        if systems.is_there(name):
            system = systems.SYSTEMS[name]()
            found = system.ask(text)
            system.stop()
            print("%s: %s\n    %s" % (name, verdict(judge.Rational(text), *found), found[0] or found[1]))


WORDS = ["right", "jump", "wrong", "none", "time", "unread"]


def rendered(log):
    """{mark: table}"""
    rows, families = list(log["functions"].values()), {}
    for row in rows:
        families.setdefault(row["family"], []).append(row)
    whole = []
    for name, version in log["systems"].items():
        cells = [row[name].split() for row in rows]
        count, seconds = Counter(cell[0] for cell in cells), [float(cell[1]) for cell in cells if len(cell) > 1]
        whole.append([name, version, *(str(count[word]) for word in WORDS), "%.0f ms" % (1000 * statistics.median(seconds)), "%.1f s" % max(seconds)])
    head = ["system", "version", "right", "jumps", "wrong", "none", "> %d s" % log["limit"], "not read", "median time", "longest"]
    by_family = [["%s (%d)" % (family, len(some)), *(str(sum(row[name].startswith("right") for row in some)) for name in log["systems"])]
                 for family, some in families.items()]
    faults = {}
    for label, row in log["functions"].items():
        for name in log["systems"]:
            word = row[name].split()[0]
            if word in ("jump", "wrong"):
                faults.setdefault((name, word), []).append(label)
    lines = [[name, word, ", ".join(labels[:12]) + (" and %d more" % (len(labels) - 12) if len(labels) > 12 else "")] for (name, word), labels in faults.items()]
    return {"integrals": audit.table(head, whole), "families": audit.table(["family", *log["systems"]], by_family),
            "faults": audit.table(["system", "what", "functions"], sorted(lines))}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--work", type=Path, help="a folder for answers")
    parser.add_argument("--only", action="append")
    parser.add_argument("--show", metavar="FUNCTION")
    parser.add_argument("--render", action="store_true")
    options = parser.parse_args()
    if options.show:
        return show(options.show)
    if not options.render:
        measure(options)
    audit.render(rendered(json.loads(LOG.read_text())))


if __name__ == "__main__":
    main()
