#!/usr/bin/env python3
"""Random C1 Hermite data: how many septics of the kind rmf are found, and their energy beside that of
the quintic auto; what phrame classify says of rmf, helical and rrmf curves.

    bench/hermite.py PROGRAM [COUNT]

The figures of docs/construct.md are those of 1000 data of each sort."""

import json
import random
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

SORTS = {
    "near the chord, σ = 1/2": lambda r: [[1 + r(0.5), r(0.5), r(0.5)] for _ in range(2)],
    "far from it, σ = 2": lambda r: [[1 + r(2), r(2), r(2)] for _ in range(2)],
    "all three random": lambda r: [[r(1), r(1), r(1)] for _ in range(2)],
}
CLAIMS = {"rmf": "erf_is_rmf", "helical": "helical", "rrmf": "rrmf"}


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


def energy(report):
    return sum(float(segment["energy"]) for segment in report["segments"])


def construct(program, folder, kind):
    """The report, and why there is none."""
    done = run(program, "construct", f"{folder}/data.json", "--kind", kind, "--print", "json", "-o",
               f"{folder}/{kind}.json")
    return (json.loads(done.stdout), "") if done.returncode == 0 else (None, done.stderr.strip())


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    for sort, derivatives in SORTS.items():
        engine = random.Random(sort)

        def normal(sigma, engine=engine):
            return round(engine.gauss(0, sigma), 6)

        ratios, reasons, claimed, agreed = [], Counter(), Counter(), Counter()
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(count):
                end = [normal(1) for _ in range(3)] if sort.startswith("all") else [1, 0, 0]
                data = {"phrame": "points/1", "points": [[0, 0, 0], end],
                        "derivatives": derivatives(normal)}
                Path(folder, "data.json").write_text(json.dumps(data))
                quintic, _ = construct(program, folder, "quintic")
                for kind, claim in CLAIMS.items():
                    report, why = construct(program, folder, kind)
                    if report is None:
                        reasons[kind, why] += 1
                        continue
                    if kind == "rmf":
                        ratios.append(energy(report) / energy(quintic))
                    claimed[kind] += 1
                    said = run(program, "classify", f"{folder}/{kind}.json", "--print", "json")
                    agreed[kind] += json.loads(said.stdout)[claim]["answer"] is True
        ratios.sort()
        quantiles = {q: ratios[min(int(q * len(ratios)), len(ratios) - 1)]
                     for q in (0, 0.01, 0.1, 0.5, 0.9, 0.99, 1)}
        print(f"{sort}: rmf {len(ratios)} of {count}; energy over auto: "
              + ", ".join(f"{q:.0%} {x:.3g}" for q, x in quantiles.items()))
        print("  classify agrees: " + ", ".join(f"{k} {agreed[k]} of {claimed[k]}" for k in CLAIMS))
        for (kind, why), times in reasons.items():
            print(f"  {times} × {kind}: {why}")


if __name__ == "__main__":
    main()
