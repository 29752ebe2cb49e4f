"""reference/: the program answers all curves of a file as `phrame batch` reads it, and gives the values that are there; some of them, all with
PHRAME_REFERENCE=all, are computed by tools/foreign_frames.py, too, which shares no formula with the program.
"""
import json
import os
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import make_reference as reference

EVERY = 1 if os.environ.get("PHRAME_REFERENCE") == "all" else 31


def main():
    files = sorted((ROOT / "reference").glob("*.jsonl"))
    number, problems = 0, []
    for file in files:
        curves = [json.loads(line) for line in file.read_text().splitlines()]
        answers = reference.asked([(file.stem, curve) for curve in curves])
        for curve in curves:
            if reference.expected(curve, answers[curve["name"]]) != curve["expected"]:
                problems.append("%s: the program has other values" % curve["name"])
            number += 1
            if number % EVERY == 0:
                problems += ["%s: %s" % (curve["name"], problem) for problem in reference.disagreements(curve)]
        run = subprocess.run([os.environ["PHRAME_PROGRAM"], "batch", str(file), "--question", "info"], capture_output=True, text=True)
        if run.returncode or len(run.stdout.splitlines()) != len(curves):
            problems.append("%s is not read by phrame batch: %s" % (file.name, run.stderr))
    print("%d curves" % number)
    if problems or number < 90:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
