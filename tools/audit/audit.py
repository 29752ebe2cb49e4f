#!/usr/bin/env python3
"""What widely used programs answer on the reference collection: asks them, has phrame judge the tables, and writes docs/audit/log.json and
the tables of docs/audit.md, every number of which is from that log.

    python3 -m venv audit && audit/bin/pip install -r tools/audit/requirements.txt && npm install --prefix audit three @babylonjs/core
    PHRAME_PROGRAM=build/dev/bin/phrame audit/bin/python tools/audit/audit.py --work /tmp/audit --node audit/node_modules
    … --only trimesh          one program again; the rest of the log stays
    … --missing               the curves that are not in the log, which came into the collection since
    … --render                the tables of docs/audit.md from the log, without asking anybody
"""
import argparse
import json
import os
import platform
import re
import shutil
import statistics
import subprocess
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LOG, PAGE = ROOT / "docs/audit/log.json", ROOT / "docs/audit.md"
STEPS = (51, 101, 201)
NODE = ["three", "babylon"]  # scripts beside this one
COLUMNS = [*("error at %d steps" % (n - 1) for n in STEPS), "order", "flips", "cosine of f2 and the tangent", "holonomy"]
FIRST = ["double-reflection", "three", "babylon", "vtk", "blender", "occ-discrete", "occ-corrected-frenet", "splipy", "trimesh"]


def phrame(*arguments):
    run = subprocess.run([os.environ["PHRAME_PROGRAM"], *map(str, arguments)], capture_output=True, text=True)
    return run.stdout if run.returncode in (0, 1) else sys.exit(run.stderr)


def curves(collection):
    return [json.loads(line) for line in (collection / "curves.jsonl").read_text().splitlines()]


def ask(name, collection, target, wanted):
    """{curve: why there is no answer}"""
    import numpy as np
    import programs
    silent = {}
    for curve in curves(collection):
        if curve["name"] not in wanted:
            continue
        for steps in STEPS:
            table = np.loadtxt(collection / "frames" / str(steps) / (curve["name"] + ".csv"), delimiter=",", skiprows=1)
            try:
                f2 = programs.answer(name, programs.Sampled(curve, table))
            except programs.NoAnswer as reason:
                silent[curve["name"]] = str(reason)
                for other in STEPS:
                    (target / str(other) / (curve["name"] + ".csv")).unlink(missing_ok=True)
                break
            file = target / str(steps) / (curve["name"] + ".csv")
            file.parent.mkdir(parents=True, exist_ok=True)
            np.savetxt(file, np.column_stack([table[:, 0], f2]), fmt="%.17g", delimiter=",", header="t,f2x,f2y,f2z", comments="")
    return silent


def ask_node(name, collection, target, modules, wanted):
    script = target.parent / (name + ".mjs")  # where node finds the modules
    shutil.copy(Path(__file__).with_name(name + ".mjs"), script)
    link = target.parent / "node_modules"
    if not link.exists():
        link.symlink_to(Path(modules).resolve())
    run = subprocess.run(["node", script, collection / "frames", target], input="\n".join(sorted(wanted)), capture_output=True, text=True)
    if run.returncode:
        sys.exit(run.stderr)
    return run.stdout.strip()


def record(found, silent, version, wanted):
    """The curves with COLUMNS, where there is an answer; elsewhere why there is none."""
    def short(x):
        return None if x is None else float("%.3g" % x)

    def value(x):
        return None if x is None else short(float(x["value"]))

    def size(x):
        return None if x is None else abs(x)
    rows = {row["name"]: row for row in found["curves"] if row["name"] in wanted}
    refused = {name: row["failure"] for name, row in rows.items() if "failure" in row}
    return {"version": version, "no_answer": {**refused, **silent}, "curves": {
        name: [*(short(float(step["error"]["upper"])) for step in row["steps"]), value(row["order"]), row["flips"],
               short(float(row["orthogonality"])), size(value(row["holonomy"]))]
        for name, row in rows.items() if "failure" not in row}}


def write(log, file=LOG):
    """A curve a line."""
    text = json.dumps(log, indent=1, ensure_ascii=False)
    file.parent.mkdir(exist_ok=True)
    for brackets in (r"\[[^\[\]]*\]", r'\{\s*"family"[^{}]*\}'):
        text = re.sub(brackets, lambda row: re.sub(r"(?<=[\[{]) | (?=[\]}])", "", " ".join(row[0].split())), text)
    file.write_text(text + "\n")


def measure(options):
    import numpy as np
    import programs
    work = Path(options.work)
    collection = work / "collection"
    if not collection.exists():
        phrame("reference", "--export", collection, "--samples", ",".join(map(str, STEPS)))
    log = json.loads(LOG.read_text()) if LOG.exists() else {"programs": {}}
    log["phrame"] = phrame("--version").split()[-1]
    log["steps"] = [n - 1 for n in STEPS]
    log["curves"] = len(curves(collection))
    log["python"], log["numpy"], log["columns"] = platform.python_version(), np.__version__, COLUMNS
    for name in FIRST:
        if options.only and name not in options.only:
            continue
        target = work / name
        shutil.rmtree(target, ignore_errors=True)
        target.mkdir(parents=True)
        before = log["programs"].get(name) if options.missing else None
        known = {**before["curves"], **before["no_answer"]} if before else {}
        wanted = {curve["name"] for curve in curves(collection)} - set(known)
        if name in NODE:
            version, silent = ask_node(name, collection, target, options.node, wanted), {}
        else:
            version, silent = programs.version_of(name) or "–", ask(name, collection, target, wanted)
        found = json.loads(phrame("check", "--suite", target, "--print", "json"))
        new = record(found, silent, version, wanted)
        if before and before["version"] != version:
            sys.exit("%s is %s here, in the log %s: ask it for all curves" % (name, version, before["version"]))
        for part in ("curves", "no_answer"):
            new[part] = dict(sorted({**(before[part] if before else {}), **new[part]}.items()))
        log["programs"][name] = new
        write(log)
        print(name, version, len(log["programs"][name]["curves"]), flush=True)


def number(x):
    """Angles that no double tells from 0 are 0."""
    return "–" if x is None else "%.1e" % x if x > 1e-17 else "0"


def middle(numbers):
    numbers = [x for x in numbers if x is not None]
    return statistics.median(numbers) if numbers else None


OWN_STEPS = ["occ-discrete", "occ-corrected-frenet", "splipy"]  # what takes the curve does not know ours


def table(head, rows):
    return "\n".join(["| %s |" % " | ".join(row) for row in [head, ["---"] * len(head), *rows]])


def rendered(log):
    """{mark: table}"""
    programs_there = [name for name in FIRST if name in log["programs"]]
    whole, groups = [], {}
    for name in programs_there:
        found = log["programs"][name]
        rows = found["curves"].values()
        errors, orders = [row[len(STEPS) - 1] for row in rows], [row[len(STEPS)] for row in rows]
        whole.append([name, found["version"], str(len(rows)), number(middle(errors)), str(sum(x <= 1e-6 for x in errors)),
                      str(sum(x > 0.1 for x in errors)), "–" if name in OWN_STEPS or middle(orders) is None else "%.1f" % max(0.0, middle(orders)),
                      str(sum(row[-3] > 0 for row in rows)), number(middle(row[-1] for row in rows))])
        for curve, row in found["curves"].items():
            groups.setdefault(re.sub(r"-[0-9]+(-doubles)?$", "", curve), {}).setdefault(name, []).append(row[len(STEPS) - 1])
    head = ["program", "version", "curves", "median error", "≤ 10⁻⁶", "> 0.1", "order", "with flips", "holonomy off by"]
    by_group = [[group] + [number(middle(groups[group].get(name, []))) for name in programs_there] for group in sorted(groups)]
    silent = [[name, str(count), reason.replace("|", "\\|")] for name in programs_there
              for reason, count in Counter(log["programs"][name]["no_answer"].values()).most_common()]
    return {"whole": table(head, whole), "groups": table(["group", *programs_there], by_group),
            "silent": table(["program", "curves", "why"], silent) if silent else "All answered."}


def render(tables):
    page = PAGE.read_text()
    for mark, text in tables.items():
        begin, end = "<!-- %s -->\n" % mark, "\n<!-- end -->"
        before, rest = page.split(begin, 1)
        page = before + begin + text + rest[rest.index(end):]
    PAGE.write_text(page)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--work", help="a folder for tables")
    parser.add_argument("--node", help="node_modules with three.js")
    parser.add_argument("--only", action="append", choices=FIRST)
    parser.add_argument("--missing", action="store_true")
    parser.add_argument("--render", action="store_true")
    options = parser.parse_args()
    if not options.render:
        measure(options)
    render(rendered(json.loads(LOG.read_text())))


if __name__ == "__main__":
    main()
