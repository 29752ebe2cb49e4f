"""What the figures of the documents have in common. gallery.py, twist.py and construct.py draw them by the package phrame;
./dev figures calls these.

A figure is left as it is while this file, the one that draws it and what it shows, to four digits, are those it was drawn from:
another release of matplotlib writes another SVG of the same picture, and another compiler other last digits.

For a paper: gallery.py FOLDER writes its figures there as PDF, with their fonts."""

import hashlib
import inspect
import pathlib
import re
import sys

import matplotlib
import numpy as np
from cycler import cycler

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

plt.rcParams.update(
    {
        "font.size": 9,
        "font.sans-serif": ["DejaVu Sans"],
        "svg.fonttype": "path",  # the same letters everywhere
        "pdf.fonttype": 42,  # fonts that journals take
        "svg.hashsalt": "phrame",  # the same names every time
        "legend.frameon": False,
        "lines.linewidth": 1.2,
        # Told apart in grey and without red and green, too: Okabe, Ito, Color universal design (2008).
        "axes.prop_cycle": cycler(color=["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000"])
        + cycler(linestyle=["-", "--", "-.", (0, (5, 1, 1, 1, 1, 1)), ":"]),
    }
)

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parents[1]

shown = []  # in the figure that is being drawn: numbers, to four digits of the largest of each list


def note(*arrays):
    """What a figure shows."""
    for array in arrays:
        array = np.asarray(array, dtype=float)
        shown.append([round(x, 4) + 0.0 for x in (array / (np.abs(array).max() or 1)).ravel().tolist()])


def tenth(number):
    return f"{float(number[0]):.1f}".removesuffix(".0")


def rounded(svg):
    """Numbers of tags to a tenth; what is between tags is for people, as 0.25 below an axis."""
    number = r"scale\([^)]*\)|\d+\.\d{2,}"  # but letters keep their size
    return re.sub(r"<[^!>][^>]*>", lambda tag: re.sub(number, lambda x: x[0] if x[0][0] == "s" else tenth(x), tag[0]), svg)


def fill(ax, points, view):
    """Looks from (elevation, azimuth) such that points fill the axes."""
    elevation, azimuth = np.radians(view)
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0])
    away = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    axes = np.stack([right, np.cross(away, right), away])
    low, high = (points @ axes.T).min(axis=0), (points @ axes.T).max(axis=0)
    # A cube of side 1.1 is seen in a window of 1.85, both of Matplotlib's units.
    half, middle = 1.1 / 1.85 / 2 * 1.06 * (high - low)[:2].max(), (low + high) / 2 @ axes
    ax.set(**{f"{name}lim": (x - half, x + half) for name, x in zip("xyz", middle)})
    ax.set_box_aspect((1, 1, 1))
    ax.set_proj_type("ortho")
    ax.view_init(*view)
    ax.set_axis_off()


def save(figure, name, legend_of=None):
    """By the file that calls, with a tenth of a point as the smallest unit."""
    sources = [pathlib.Path(file).read_bytes() for file in (__file__, inspect.stack()[1].filename)]
    origin = "drawn from " + hashlib.sha256(b"".join(sources) + repr(shown).encode()).hexdigest()
    shown.clear()
    if len(sys.argv) == 2:
        path, origin = pathlib.Path(sys.argv[1], name).with_suffix(".pdf"), None
    else:
        path = HERE / name
    if origin and path.exists() and origin in path.read_text(encoding="utf-8"):
        print(f"{name}: as it was")
        plt.close(figure)
        return
    if legend_of:
        figure.legend(*legend_of.get_legend_handles_labels(), loc="lower center", ncol=4, fontsize=8)
    figure.tight_layout(rect=(0, 0.1 if legend_of else 0, 1, 1))
    figure.savefig(path, metadata={"Date": None, "Description": origin} if origin else {"CreationDate": None})
    plt.close(figure)
    if origin:
        path.write_text(rounded(path.read_text(encoding="utf-8")), encoding="utf-8")
    print(f"{name}: drawn")
