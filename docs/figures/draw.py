#!/usr/bin/env python3
"""Draws the figures of docs/minimal-twist.md: draw.py FOLDER, with what examples/minimal_twist wrote
into FOLDER. ./dev figures does both.

A figure is left as it is while this file and what it shows, to four digits, are those it was drawn from: another
release of matplotlib writes another SVG of the same picture, and another compiler other last digits."""

import csv
import hashlib
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

matplotlib.rcParams.update(
    {
        "font.size": 9,
        "axes.grid": True,
        "grid.color": "#dddddd",
        "svg.hashsalt": "phrame",  # the same names every time
        "legend.frameon": False,
        "lines.linewidth": 1.2,
    }
)

HERE = pathlib.Path(__file__).parent


shown = []  # in the figure that is being drawn: columns, to four digits of the largest number


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    data = {name: [float(row[name]) for row in rows] for name in rows[0]}
    for name, column in data.items():
        unit = max(map(abs, column)) or 1
        shown.append((name, f"{unit:.3e}", [round(x / unit, 4) + 0.0 for x in column]))
    return data


def save(figure, name, legend_of=None):
    source = pathlib.Path(__file__).read_bytes() + repr(shown).encode()
    shown.clear()
    origin = "drawn from " + hashlib.sha256(source).hexdigest()
    path = HERE / name
    if path.exists() and origin in path.read_text(encoding="utf-8"):
        print(f"{name}: as it was")
        plt.close(figure)
        return
    if legend_of:
        figure.legend(*legend_of.get_legend_handles_labels(), loc="lower center", ncol=4, fontsize=8)
    figure.tight_layout(rect=(0, 0.1 if legend_of else 0, 1, 1))
    figure.savefig(path, metadata={"Date": None, "Description": origin})
    plt.close(figure)
    print(f"{name}: drawn")


def errors(folder):
    """Figures 3, 7 and 10: the error as a function of gamma."""
    figure, axes = plt.subplots(1, 3, figsize=(9, 2.6))
    for number, axis in enumerate(axes, start=1):
        data = read(folder / f"errors-{number}.csv")
        for side in (-1, 1):
            points = [(g, r) for g, r in zip(data["gamma"], data["rms"]) if g * side > 0]
            axis.plot(*zip(*points), color="C0")
        axis.set(title=f"example {number}", xlabel="γ", yscale="log", xlim=(-2, 2))
    axes[0].set_ylabel("rms of $\\Omega_1 - \\bar\\Omega_1$ over $|\\bar\\Omega_1|$")
    save(figure, "minimal-twist-errors.svg")


def draw_rates(axis, data, title, x="t"):
    for name, label in (
        ("omega", "$\\omega_1$, ERF"),
        ("theta", "$\\theta'/\\sigma$, rotation"),
        ("Omega", "$\\Omega_1$, rational frame"),
    ):
        axis.plot(data[x], data[name], label=label)
    axis.plot(data[x], data["mean"], "k--", linewidth=0.9, label="$\\bar\\Omega_1$")
    axis.set(title=title, xlabel="t", xlim=(min(data[x]), max(data[x])))


def rates(folder):
    """Figures 4, 8 and 11: the rates about the tangent, for the best gamma."""
    figure, axes = plt.subplots(1, 3, figsize=(9, 3))
    for number, axis in enumerate(axes, start=1):
        draw_rates(axis, read(folder / f"rates-{number}.csv"), f"example {number}")
    save(figure, "minimal-twist-rates.svg", axes[0])


def poor(folder):
    """Figures 6 and 12: a poor choice of gamma, and a division at the sharp extremum."""
    figure, axes = plt.subplots(1, 2, figsize=(7, 3))
    draw_rates(axes[0], read(folder / "rates-1-poor.csv"), "example 1, γ = −1")
    data = read(folder / "rates-3-divided.csv")
    draw_rates(axes[1], data, "example 3 in two pieces")
    joint = next(t for t, following in zip(data["t"], data["t"][1:]) if t == following)
    axes[1].axvline(joint, color="k", linestyle=":", linewidth=0.9)
    save(figure, "minimal-twist-choices.svg", axes[0])


def exact(folder):
    """Figure 2: the exact frame turns evenly."""
    figure, axis = plt.subplots(figsize=(4, 2.6))
    data = read(folder / "rates-1.csv")
    axis.plot(data["s"], data["omega"], label="Euler–Rodrigues frame")
    axis.plot(data["s"], data["mean"], label="exact frame of minimal twist")
    axis.set(xlabel="arc length", ylabel="rate about the tangent")
    axis.legend(fontsize=7)
    save(figure, "minimal-twist-exact.svg")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for draw in (errors, rates, poor, exact):
        draw(pathlib.Path(sys.argv[1]))
