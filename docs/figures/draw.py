"""What the figures of the documents have in common. gallery.py, twist.py and construct.py draw them by the package phrame;
./dev figures calls these.

A figure is left as it is while this file, the one that draws it and what it shows, to four digits, are those it was drawn from:
another release of matplotlib writes another SVG of the same picture, and another compiler other last digits."""

import hashlib
import inspect
import pathlib
import re

import matplotlib
import numpy as np

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

plt.rcParams.update(
    {
        "font.size": 9,
        "font.sans-serif": ["DejaVu Sans"],
        "svg.fonttype": "none",  # for small files
        "svg.hashsalt": "phrame",  # the same names every time
        "legend.frameon": False,
        "lines.linewidth": 1.2,
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
    return re.sub(r"<[^>]*>", lambda tag: re.sub(r"\d+\.\d{2,}", tenth, tag[0]), svg)


def save(figure, name, legend_of=None):
    """By the file that calls, with a tenth of a point as the smallest unit."""
    sources = [pathlib.Path(file).read_bytes() for file in (__file__, inspect.stack()[1].filename)]
    origin = "drawn from " + hashlib.sha256(b"".join(sources) + repr(shown).encode()).hexdigest()
    shown.clear()
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
    path.write_text(rounded(path.read_text(encoding="utf-8")), encoding="utf-8")
    print(f"{name}: drawn")
