"""reference/: `phrame reference` has all curves, `phrame batch` reads them as they are, and the program gives the values that are there, of
some curves; a few are computed by tools/foreign_frames.py, too, which shares no formula with the program. All are, both ways, with
PHRAME_REFERENCE=all, and all by the program with PHRAME_TEST_MULTIPLIER above 1.
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

ALL = os.environ.get("PHRAME_REFERENCE") == "all"
EVERY = 1 if ALL or float(os.environ.get("PHRAME_TEST_MULTIPLIER", 1)) > 1 else 17
FOREIGN = ["tame-01", "formulas-01", "minimal-twist-01", "hard-rounding-01", "plane-offsets-01", "plane-01", "power-basis-01", "ph-splines-01", "turning-multiplier-01",
           "rational-ph-01", "rational-ph-05", "signed-frenet-06"]


def phrame(*arguments, text=None):
    run = subprocess.run([os.environ["PHRAME_PROGRAM"], *arguments], input=text, capture_output=True, text=True)
    return run.stdout if run.returncode == 0 else sys.exit(run.stderr)


def main():
    files = sorted((ROOT / "reference").glob("*.jsonl"), key=lambda file: file.stem)
    text = "".join(file.read_text() for file in files)
    curves = [json.loads(line) for line in text.splitlines()]
    problems = []
    if phrame("reference") != text:
        problems.append("phrame reference has other lines")
    if [json.loads(line)["id"] for line in phrame("batch", "--question", "frames", "--at", "0", text=text).splitlines()] != [c["name"] for c in curves]:
        problems.append("phrame batch does not read all curves")
    some = [curve for k, curve in enumerate(curves)
            if k % EVERY == 0 and (EVERY == 1 or curve["family"] != "knots") or curve["name"] in FOREIGN]  # of knots each takes seconds
    answers = reference.asked([(curve["family"], curve) for curve in some])
    for curve in some:
        if reference.expected(curve, answers[curve["name"]]) != curve["expected"]:
            problems.append("%s: the program has other values" % curve["name"])
        if ALL or curve["name"] in FOREIGN:
            problems += ["%s: %s" % (curve["name"], problem) for problem in reference.disagreements(curve)]
    print("%d of %d curves" % (len(some), len(curves)))
    if problems or len(curves) < 400 or len({curve["name"] for curve in curves}) < len(curves):
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
