#!/usr/bin/env python3
"""Frames for all curves of the reference collection by double reflection (Wang, Jüttler, Zheng, Liu 2008), to be judged by
phrame check --suite. Put your own method in the place of next_normal().

    phrame reference --export collection --samples 51,101,201
    python3 double_reflection.py collection/frames mine
    phrame check --suite mine
"""
import csv
import sys
import time
from pathlib import Path


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, k, b):
    return [x - k * y for x, y in zip(a, b)]


def next_normal(r, e1, f2, r_next, e1_next):
    """f2 at the next point: reflected in the plane between the points, then so that the tangent becomes e1_next."""
    way = minus(r_next, 1, r)
    c = dot(way, way)
    if c > 0:  # else it is the same point
        f2 = minus(f2, 2 * dot(way, f2) / c, way)
        e1 = minus(e1, 2 * dot(way, e1) / c, way)
    turn = minus(e1_next, 1, e1)
    c = dot(turn, turn)
    return minus(f2, 2 * dot(turn, f2) / c, turn) if c > 0 else f2


def main(source, target):
    times = ["name,seconds"]
    for file in sorted(Path(source).rglob("*.csv")):
        with open(file) as table:
            rows = [{key: float(x) for key, x in row.items()} for row in csv.DictReader(table)]
        points = [[row["x"], row["y"], row["z"]] for row in rows]
        tangents = [[row["e1x"], row["e1y"], row["e1z"]] for row in rows]
        start = time.perf_counter()
        normals = [[rows[0]["f2x"], rows[0]["f2y"], rows[0]["f2z"]]]  # where the exact frame starts
        for k in range(1, len(rows)):
            normals.append(next_normal(points[k - 1], tangents[k - 1], normals[-1], points[k], tangents[k]))
        seconds = time.perf_counter() - start
        name = file.relative_to(source)
        times.append("%s,%.9f" % (name.with_suffix("").as_posix(), seconds))
        out = Path(target) / name
        out.parent.mkdir(parents=True, exist_ok=True)
        with open(out, "w") as table:
            print("t,f2x,f2y,f2z", file=table)
            for row, f2 in zip(rows, normals):
                print(row["t"], *f2, sep=",", file=table)
    (Path(target) / "times.csv").write_text("\n".join(times) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
