#!/usr/bin/env python3
"""Instructions of single stages, by callgrind: free of the noise of a clock.

    count.py PROGRAM                    the table of bench/instructions.md
    count.py PROGRAM --expected FILE    compares: status 1 where a stage has become dearer by more than a tenth, or one of a kind of
                                        curves grows faster than n^3.5
    count.py PROGRAM --write FILE       makes the counts of this build those that are expected

PROGRAM is phrame_instructions. FILE holds counts by what the program was built by, since another compiler, another optimisation
and another FLINT give other ones; for a build without counts the exit status is 77, skipped.
"""
import argparse
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import report

SIZES = 2, 5
# Curves that once grew faster than random ones, by a size n that is m times the least.
KINDS = {
    "symmetric": lambda m: report.symmetric(2 * m),
    "composed": lambda m: report.composed(report.peers.preimage(2), report.chebyshev(m)),
    "clustered": lambda m: report.clustered(m),
    "near-cusp": lambda m: report.near_cusp(20 * m),
    "long-numbers": lambda m: report.long_numbers(20 * m),
    "multiplier": lambda m: report.curve(report.peers.preimage(2), multiplier=report.chebyshev(4 * m)),
}
GROWTH = 3.5
REPETITIONS = 2  # as in main.cpp
TOLERANCE = 1.1  # other processors have other code of GMP and glibc, which makes some hundredths


def counts(program, sizes, kinds):
    """Instructions of each stage, once, by size in the order of the program; with a stage for each kind of curves. One process counts them
    all, since valgrind translates a program anew in each."""
    with tempfile.TemporaryDirectory() as folder:
        out, arguments = pathlib.Path(folder, "out"), []
        for m in sizes:
            arguments.append(str(m))
            for name, make in kinds.items():
                file = pathlib.Path(folder, f"{name}-{m}")
                file.write_text(json.dumps(make(m)))
                arguments += [name, file]
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", "--toggle-collect=counted",
             "--dump-after=counted", program, *arguments],
            capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"{program} {sizes}: {run.stderr}")
        stages = run.stdout.split()
        totals = [int(re.search(r"^summary: (\d+)", out.with_name(f"out.{k}").read_text(), re.M).group(1)) / REPETITIONS
                  for k in range(1, len(stages) + 1)]
    n = len(stages) // len(sizes)
    return {m: dict(zip(stages[k * n:(k + 1) * n], totals[k * n:(k + 1) * n])) for k, m in enumerate(sizes)}


def table(program, sizes):
    found = list(counts(program, sizes, {}).values())
    print("| stage |", *(f"m = {m} |" for m in sizes))
    print("|---|" + "---|" * len(sizes))
    for stage in found[0]:
        cells = (f[stage] / 1000 for f in found)
        print(f"| {stage} |", *(f"{n:.3f} |" if n < 10 else f"{n:.1f} |" for n in cells))


def compare(found, expected):
    """What each stage takes beside what it took, and how it grows; whether some takes more than it should."""
    dearer = False
    for m, stages in found.items():
        for stage, count in stages.items():
            before = expected.get(m, {}).get(stage)
            ratio = count / before if before else float("inf")
            dearer = dearer or ratio > TOLERANCE
            note = "  dearer" if ratio > TOLERANCE else "  cheaper: write it down" if ratio < 1 / TOLERANCE else ""
            print(f"m = {m:2} {stage:15} {count:12.0f}  x {ratio:.3f}{note}")
    for kind in KINDS:
        first, last = (found[str(m)][kind] for m in SIZES)
        exponent = math.log(last / first) / math.log(SIZES[1] / SIZES[0])
        dearer = dearer or exponent > GROWTH
        print(f"{kind:15} n^{exponent:.1f}{'  too steep' if exponent > GROWTH else ''}")
    return dearer


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    group = parser.add_mutually_exclusive_group()
    group.add_argument("--expected", type=pathlib.Path)
    group.add_argument("--write", type=pathlib.Path)
    given = parser.parse_args()
    if shutil.which("valgrind") is None:
        print("valgrind is not installed")
        return 77
    file = given.expected or given.write
    if file is None:
        table(given.program, (2, 10, 40))
        return 0
    built = subprocess.run([given.program], capture_output=True, text=True, check=True).stdout.strip()
    all_expected = json.loads(file.read_text()) if file.exists() else {}
    if given.expected and built not in all_expected:
        print(f"no counts are known for {built}")
        return 77
    found = {str(m): stages for m, stages in counts(given.program, SIZES, KINDS).items()}
    if given.expected:
        return 1 if compare(found, all_expected[built]) else 0
    all_expected[built] = {m: {stage: round(n) for stage, n in stages.items()} for m, stages in found.items()}
    file.write_text(json.dumps(all_expected, indent=1, sort_keys=True) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
