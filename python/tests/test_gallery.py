"""The numbers of docs/gallery.md: what papers print, and what is computed."""

import importlib
import re
import sys

import numpy as np
import pytest

import phrame
from common import ROOT

DIGITS, POWERS = "0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"


@pytest.fixture(scope="module")
def gallery():
    matplotlib = pytest.importorskip("matplotlib")
    before = matplotlib.rcParams.copy()
    sys.path.insert(0, str(ROOT / "docs/figures"))
    try:
        yield importlib.import_module("gallery")
    finally:
        sys.path.remove(str(ROOT / "docs/figures"))
        matplotlib.rcParams.update(before)
        matplotlib.use("agg")


def test_the_tables_are_what_is_computed(gallery):
    text = gallery.PAGE.read_text(encoding="utf-8")
    assert gallery.page(text) == text  # which refuses numbers that are not as printed
    assert sum(len(list(rows())) for rows in gallery.NUMBERS.values()) > 25


def test_what_is_not_as_printed_is_refused(gallery):
    for rows in gallery.NUMBERS.values():
        for _, printed, found, *units in rows():
            assert gallery.agrees(printed, found, *units)
            # The last digit, or the last but one where the last is not the paper's own, is another.
            places = [k for k, digit in enumerate(printed) if digit in DIGITS or digit in POWERS]
            at = places[-2 if units else -1]
            digits = DIGITS if printed[at] in DIGITS else POWERS
            other = digits[(digits.index(printed[at]) + 6) % 10]
            assert not gallery.agrees(printed[:at] + other + printed[at + 1 :], found, *units), printed


def test_the_figures_are_there_and_small(gallery):
    text = gallery.PAGE.read_text(encoding="utf-8")
    names = {line.split("](figures/")[1].rstrip(")") for line in text.splitlines() if line.startswith("![")}
    assert len(names) == 6
    for name in names:
        svg = (ROOT / "docs/figures" / name).read_text(encoding="utf-8")
        assert svg.startswith("<?xml") and "drawn from" in svg and "<dc:date>" not in svg and len(svg) < 150_000


def test_numbers_along_axes_are_what_they_were(gallery):
    """Steps between them are equal: places on paper are rounded, and labels, which comments repeat, are not."""
    seen = 0
    for file in sorted((ROOT / "docs/figures").glob("*.svg")):
        for axis in file.read_text(encoding="utf-8").split('id="matplotlib.axis_')[1:]:
            ticks = axis.split('<g id="patch_')[0]
            labels = [float(label.replace("−", "-")) for label in re.findall(r"<!-- (−?[0-9.]+) -->", ticks)]
            seen += len(labels)
            assert not labels or np.allclose(np.diff(labels), labels[1] - labels[0]), (file.name, labels)
    assert seen > 100


def test_the_printed_pairs_are_near_the_exact_angle(gallery):
    """[Peng, Pang, Pan 2023] figure 5: for the weight 1 the two curves are close to each other all along."""
    ts = np.linspace(0, 1, 65)
    exact = gallery.PENG.angle()(ts)
    worst = [np.abs(gallery.printed_angle(a, b, ts) - exact).max() for a, b in gallery.PENG_PAIRS]
    assert worst[0] < 0.05 < worst[1] < 0.2


def test_frames_of_minimal_twist_end_where_they_should(gallery):
    for curve, twist, (start, end) in zip(gallery.MOON, gallery.TWISTS, gallery.MOON_ENDS):
        ts = np.array([0.0, 1.0])
        normals = gallery.turned(curve, np.array([float(twist.value(0)), float(twist.value(1))]), ts)
        for t, normal, angle in zip(ts, normals, (start, end)):
            _, e2, e3 = curve.frames([t], kind="erf")[0]
            theta = float(phrame.Curve([1], [0], [0], [1]).angle(start=angle).value(0))
            assert np.abs(np.cos(theta) * e2 + np.sin(theta) * e3 - normal).max() < 1e-14


def test_pictures_are_what_a_journal_takes(gallery, tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["gallery.py", str(tmp_path)])
    gallery.farouki_rates()
    pdf = (tmp_path / "farouki-2003-rates.pdf").read_bytes()
    assert b"/FontFile2" in pdf and b"/Type3" not in pdf
    for picture in (ROOT / "docs/figures").glob("*.svg"):
        assert "<text" not in picture.read_text(encoding="utf-8"), picture.name  # letters are where they were drawn
    figure, axes = gallery.plt.subplots()
    for k in range(5):
        axes.plot([0, k])
    assert len({repr(line._dash_pattern) for line in axes.lines}) == 5
    gallery.plt.close(figure)


def test_curves_fill_their_pictures(gallery):
    from mpl_toolkits.mplot3d import proj3d

    ts = np.linspace(0, 1, 9)
    for curve in (gallery.FAROUKI, gallery.SEPTIC, *gallery.MOON):
        figure, (ax, _) = gallery.panels(2)
        gallery.ribbon(ax, curve, "", ts)
        figure.canvas.draw()
        x, y, _ = proj3d.proj_transform(*curve.points(ts).T, ax.get_proj())
        inside = ax.transAxes.inverted().transform(ax.transData.transform(np.stack([x, y], axis=1)))
        assert inside.min() > 0 and inside.max() < 1 and np.ptp(inside, axis=0).max() > 0.7
        gallery.plt.close(figure)
