"""Offsets of plane PH paths."""

import json
import math

import numpy as np
import pytest

import phrame
from common import QUINTIC

CUBIC = phrame.Curve([1], [0], [0], [0, 1])
CORNER = phrame.Path([phrame.Curve([1], [0], [0], [0]), phrame.Curve([1], [0], [0], [1], multiplier=["1/2"], start=[1, 0, 0])])


def test_the_offset_is_a_rational_curve_at_that_distance():
    (path,) = CUBIC.offset("1/2")
    assert path.kind == "rational"
    for t in (0, "1/3", 1):
        gap = [a - b for a, b in zip(path.point(t), CUBIC.point(t))]
        assert sum(x * x for x in gap) == 0.25
    assert abs(float(path.length) - (4 / 3 + math.pi / 4)) < 1e-15


def test_joins_at_corners():
    assert [len(CORNER.offset(1, join)) for join in ("round", "mitre", "open")] == [1, 1, 2]
    assert len(CORNER.offset(-1)) == 2


def test_what_is_nearer_to_the_path_is_trimmed():
    corners = [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 0, 0]]
    triangle = phrame.Path([phrame.Path.from_control_points([a, b]) for a, b in zip(corners, corners[1:])])
    (inside,) = triangle.offset("-1/2", trim=True)
    assert inside.length == 6
    assert triangle.offset(-1, trim=True) == ()
    assert len(triangle.offset(2, "open", trim=True)) == 3
    (outside,) = triangle.offset(2, "mitre", trim=True)
    assert outside.length == 36


def test_a_pocket():
    corners = [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 0, 0]]
    triangle = phrame.Path([phrame.Path.from_control_points([a, b]) for a, b in zip(corners, corners[1:])])
    # Similar to it, with the inradius 1 − k/4.
    assert [path.length for path in triangle.offset("-1/4", pocket=True)] == [9, 6, 3]
    with pytest.raises(phrame.DomainError, match="the path is open"):
        CORNER.offset(1, pocket=True)


def test_a_check_by_ask():
    found = phrame.ask("offset", CUBIC, distance="1/2", check=json.loads(CUBIC.offset("1/2")[0].json()), tol="1e-9")
    assert found["passes"] and found["missing"]["count"] == 0


def test_the_report_by_ask():
    (offset,) = phrame.ask("offset", CUBIC, distance="-1")["offsets"]
    assert [cusp["t"]["polynomial"] for cusp in offset["cusps"]] == [["-1", "0", "2", "0", "1"]]
    assert offset["self_intersections"] == {"complete": True, "count": 0, "places": [], "undecided": []}


# 4 cusps and 6 places where it meets itself: counted on a polyline of 6000 points as well.
SEPTIC = phrame.Path.from_json(json.dumps({
    "phrame": "curve/1", "basis": "bernstein", "preimage": {"u": [2, -6, 8, -7], "v": [0, 0, 0, 0], "p": [0, 0, 0, 0], "q": [9, -9, -3, 7]}}))


def test_a_plot_marks_cusps_crossings_and_cuts():
    pyplot = pytest.importorskip("matplotlib.pyplot")
    path, line, cusps, crossings = SEPTIC.plot_offset(-15).lines
    distances = np.abs(np.array(line.get_xydata())[:, None] - SEPTIC.points(np.linspace(0, 1, 2001))[None, :, :2])
    assert np.hypot(*distances.T).min(axis=0).max() < 15.001  # no point is farther than that from the path, and near cusps some are nearer
    assert np.isclose(np.hypot(*(line.get_xydata()[[0, -1]] - path.get_xydata()[[0, -1]]).T), 15).all()
    assert (cusps.get_marker(), crossings.get_marker()) == ("o", "x")
    assert len(cusps.get_xdata()) == 4 and len(crossings.get_xdata()) == 6
    # The offset turns back at a cusp: before and behind it are on the same side of it.
    for x, y in zip(*cusps.get_data()):
        k = np.argmin(np.hypot(line.get_xdata() - x, line.get_ydata() - y))
        before, after = (line.get_xydata()[j] - (x, y) for j in (k - 2, k + 2))
        assert np.dot(before, after) > 0
    assert np.hypot(*np.diff(line.get_xydata(), axis=0).T).max() < 1  # of 40
    ax = pyplot.figure().add_subplot()
    corners = [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 0, 0]]
    triangle = phrame.Path([phrame.Path.from_control_points([a, b]) for a, b in zip(corners, corners[1:])])
    assert triangle.plot_offset(["-1/2", "-1/4"], trim=True, ax=ax) is ax
    inside, cuts, _, _ = ax.lines
    assert inside.get_color() == cuts.get_color() and cuts.get_marker() == "s"
    assert {(x, y) for x, y in np.transpose(cuts.get_data())} == {(1.5, 0.5), (3.5, 0.5), (3.5, 2)}
    pyplot.close("all")


def test_a_gauge_by_ask():
    circle = {"phrame": "curve/1", "basis": "power", "position": {"x": [1, 0, -1], "y": [0, 2], "w": [1, 0, 1]}}
    found = phrame.ask("offset", CUBIC, distance="1/2", gauge=circle)
    assert found["without"] == []
    assert found["offsets"][0]["paths"] == phrame.ask("offset", CUBIC, distance="1/2")["offsets"][0]["paths"]
    with pytest.raises(phrame.InputError, match="not symmetric"):
        phrame.ask("offset", CUBIC, distance="1/2", gauge={**circle, "position": {"x": [2], "y": [0, 2], "w": [1, 0, 1]}})


def test_an_envelope_by_ask():
    axis = {"phrame": "mph/1", "control_points": [[0, 0, 1], ["3/2", 0, 1], [3, 1, 2]]}
    answer = phrame.ask("envelope", axis, trim=True)
    assert answer["segments"][0]["sigma"] == ["3"]  # (3, 2t, 2t)
    (boundary,) = answer["branches"]
    assert boundary["closed"] and len(boundary["parts"]) == 7
    with pytest.raises(phrame.InputError, match="no Minkowski PH curve"):
        phrame.ask("envelope", {"phrame": "mph/1", "control_points": [[0, 0, 1], [1, 1, 1], [2, 0, 1]]})


def test_curves_with_radii_by_ask():
    found = phrame.ask("construct", {"phrame": "points/1", "points": [[0, 0, 1], [3, 1, 2], [6, 0, 1]]}, kind="minkowski")
    axis = {"phrame": "mph/1", "segments": found["segments"]}
    assert [part["degree"] for part in phrame.ask("envelope", axis)["segments"]] == [5, 5]


def test_what_has_no_offset():
    with pytest.raises(ValueError, match="0 is no distance"):
        CUBIC.offset(0)
    with pytest.raises(ValueError, match="not one of round, mitre, open"):
        CUBIC.offset(1, "bevel")
    with pytest.raises(phrame.DomainError, match="no plane z = const"):
        QUINTIC.offset(1)
