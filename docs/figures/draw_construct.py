#!/usr/bin/env python3
"""Draws the figures of docs/construct.md: draw_construct.py PHRAME, of what the program PHRAME makes of
examples/paths. ./dev figures does so. Like draw.py it leaves figures that are as they were."""

import csv
import hashlib
import pathlib
import re
import subprocess
import sys

import draw
from draw import plt

# For small files.
plt.rcParams.update({"axes.grid": False, "svg.fonttype": "none", "font.sans-serif": ["DejaVu Sans"]})

PATHS = pathlib.Path(__file__).parents[2] / "examples" / "paths"


def constructed(program, points, options, samples):
    """Points, curvatures and f2 along the curve that is constructed, as columns."""
    command = [program, "construct", PATHS / points, "--print", "curve", *options]
    curve = subprocess.run(command, capture_output=True, check=True).stdout
    command = [program, "frames", "-", "--samples", str(samples), "--columns", "curvature"]
    table = subprocess.run(command, input=curve, capture_output=True, check=True).stdout.decode()
    rows = list(csv.DictReader(table.splitlines()))
    data = {name: [float(row[name]) for row in rows] for name in rows[0]}
    draw.shown.append((options, {name: [round(x, 4) for x in column] for name, column in data.items()}))
    return data


def save(figure, name, legend_of=None):
    """With a tenth of a point as the smallest unit."""
    draw.shown.append(hashlib.sha256(pathlib.Path(__file__).read_bytes()).hexdigest())
    draw.save(figure, name, legend_of)
    path = draw.HERE / name
    text = path.read_text(encoding="utf-8")
    path.write_text(re.sub(r"\d+\.\d{2,}", lambda x: f"{float(x[0]):.1f}".removesuffix(".0"), text), encoding="utf-8")


def rules(program):
    """The quintics of one pair of ends and derivatives, by rule, and the helical ones."""
    figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.2))
    for name in ("minimal", "auto", "shortest", "longest"):
        data = constructed(program, "hermite.json", ["--select", name], 31)
        axes[0].plot(data["x"], data["y"], label=name)
    data = constructed(program, "hermite.json", ["--kind", "rmf"], 31)
    axes[0].plot(data["x"], data["y"], "k:", label="rmf")
    axes[0].set(title="quintics, and the septic rmf", xlabel="x", ylabel="y")
    for solution in ("1", "2", "3", "4", "5"):
        data = constructed(program, "hermite.json", ["--kind", "helical", "--solution", solution], 41)
        axes[1].plot(data["x"], data["y"], label=solution)
    axes[1].set(title="helical, by --solution", xlabel="x")
    for axis in axes:
        axis.set_aspect("equal", "datalim")
        axis.legend(fontsize=7)
    save(figure, "construct-hermite.svg")


def trefoil(program):
    """A closed spline with h = 0 and its frame, and what C1 and C2 are to curvatures."""
    figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.2), width_ratios=(1, 1.4))
    data = constructed(program, "trefoil.csv", ["--closed", "--kind", "rmf"], 97)
    axes[0].plot(data["x"], data["y"])
    every = slice(None, None, 3)
    axes[0].quiver(
        *(data[name][every] for name in ("x", "y", "f2x", "f2y")),
        color="C1", angles="xy", scale_units="xy", scale=1.6, width=0.004, headwidth=1, headlength=0.1,
    )
    axes[0].set(title="rmf, with $f_2$", xlabel="x", ylabel="y")
    axes[0].set_aspect("equal", "datalim")
    for kind, segments in (("quintic", 13), ("c2", 17)):
        data = constructed(program, "trefoil.csv", ["--closed", "--kind", kind], 20 * segments + 1)
        length = [0.0]
        points = list(zip(data["x"], data["y"], data["z"]))
        for a, b in zip(points, points[1:]):
            length.append(length[-1] + sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5)
        axes[1].plot(length, data["curvature"], label=kind)
    axes[1].set(title="curvatures", xlabel="arc length", xlim=(0, length[-1]))
    axes[1].legend(fontsize=7)
    save(figure, "construct-trefoil.svg")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for figure_of in (rules, trefoil):
        figure_of(sys.argv[1])
