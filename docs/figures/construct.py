#!/usr/bin/env python3
"""Draws the figures of docs/construct.md."""

import csv
import json

import draw
import numpy as np
from draw import plt

import phrame

PATHS = draw.ROOT / "examples/paths"
HERMITE = json.loads((PATHS / "hermite.json").read_text(encoding="utf-8"))
with open(PATHS / "trefoil.csv", newline="", encoding="utf-8") as table:
    TREFOIL = [[row["x"], row["y"], row["z"]] for row in csv.DictReader(table)]


def plotted(axis, curve, label, samples, **style):
    """Seen along z."""
    x, y, _ = curve.points(np.linspace(0, 1, samples)).T
    draw.note(x, y)
    axis.plot(x, y, label=label, **style)


def rules():
    """The quintics of one pair of ends and derivatives, by rule, and the helical ones."""
    (p0, p1), (d0, d1) = HERMITE["points"], HERMITE["derivatives"]
    figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.2))
    for name in ("minimal", "auto", "shortest", "longest"):
        plotted(axes[0], phrame.Curve.hermite(p0, d0, p1, d1, select=name), name, 31)
    plotted(axes[0], phrame.Curve.hermite(p0, d0, p1, d1, kind="rmf"), "rmf", 31)
    axes[0].set(title="quintics, and the septic rmf", xlabel="x", ylabel="y")
    for k in range(1, 6):
        plotted(axes[1], phrame.Curve.hermite(p0, d0, p1, d1, kind="helical", solution=k), k, 41)
    axes[1].set(title="helical, by --solution", xlabel="x")
    for axis in axes:
        axis.set_aspect("equal", "datalim")
        axis.locator_params(nbins=5)
        axis.legend(fontsize=7)
    draw.save(figure, "construct-hermite.svg")


def trefoil():
    """A closed spline with h = 0 and its frame, and what C1 and C2 are to curvatures."""
    figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.2), width_ratios=(1, 1.4))
    path = phrame.Curve.through(TREFOIL, closed=True, kind="rmf")
    ts = np.linspace(0, path.end, 97)
    (x, y, _), normals = path.points(ts).T, path.frames(ts)[:, 1]
    draw.note(x, y, normals)
    axes[0].plot(x, y)
    axes[0].quiver(
        x[::3], y[::3], *normals[::3, :2].T,
        color="C1", angles="xy", scale_units="xy", scale=1.6, width=0.004, headwidth=1, headlength=0.1,
    )
    axes[0].set(title="rmf, with $f_2$", xlabel="x", ylabel="y")
    axes[0].set_aspect("equal", "datalim")
    axes[0].margins(0.12)  # for f₂
    for kind in ("quintic", "c2"):
        path = phrame.Curve.through(TREFOIL, closed=True, kind=kind)
        ts = np.linspace(0, path.end, 20 * path.end + 1)
        lengths, curvatures = ([float(f(t)) for t in ts] for f in (path.arc_length, path.curvature))
        draw.note(lengths, curvatures)
        axes[1].plot(lengths, curvatures, label=kind)
    axes[1].set(title="curvatures", xlabel="arc length", xlim=(0, lengths[-1]))
    axes[1].legend(fontsize=7)
    draw.save(figure, "construct-trefoil.svg")


if __name__ == "__main__":
    rules()
    trefoil()
