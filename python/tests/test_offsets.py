"""Offsets of plane PH paths."""

import json
import math
from decimal import Decimal
from fractions import Fraction

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
    assert list(triangle.offset(-1, trim=True)) == [] and not triangle.offset(-1, trim=True)
    assert len(triangle.offset(2, "open", trim=True)) == 3
    (outside,) = triangle.offset(2, "mitre", trim=True)
    assert outside.length == 36


def test_a_pocket():
    corners = [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 0, 0]]
    triangle = phrame.Path([phrame.Path.from_control_points([a, b]) for a, b in zip(corners, corners[1:])])
    # Similar to it, with the inradius 1 − k/4.
    assert [path.length for path in triangle.offset("-1/4", pocket=True)] == [9, 6, 3]
    with pytest.raises(phrame.InputError, match="the path is open"):
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


TRIANGLE = phrame.Path.polyline([[0, 0, 0], [4, 0, 0], [4, 3, 0]], closed=True)


def test_an_offset_knows_what_the_report_has():
    found = CUBIC.offset(-1)
    (cusp,) = found.cusps
    assert cusp.turns_back and cusp.t == (phrame.root([-2, 0, 1], 1, 2) - 1).sqrt()
    # r = (t - t^3/3, t^2), n = (2t, t^2 - 1)/(t^2 + 1), r - n there.
    t = math.sqrt(math.sqrt(2) - 1)
    assert np.allclose([float(x) for x in cusp.point], [t - t**3 / 3 - 2 * t / (t * t + 1), t * t - (t * t - 1) / (t * t + 1)], rtol=1e-15)
    # PLANE's lengths, of the two parts and of both.
    assert [str(phrame.digits(part.length, 16)) for part in found.stretches] == ["0.4112616647572138", "0.1737986712956506"]
    assert found.stretches[0].end == cusp.t == found.stretches[1].start
    assert str(phrame.digits(found.length, 16)) == "0.5850603360528644" and found.area is None
    assert found.distance == -1 and found.self_intersections == () and found.is_complete
    assert len(found) == 1 and found[0] == found.paths[0] and found[:] == found.paths
    assert repr(found) == "<Offset by -1: 1 path>"
    assert json.loads(found.json()) == phrame.ask("offset", CUBIC, distance=-1)


def test_where_an_offset_meets_itself():
    found = SEPTIC.offset(-15)
    assert len(found.cusps) == 4 and len(found.self_intersections) == 6
    (path,) = found
    for meeting in found.self_intersections:
        for t in meeting.t:
            assert np.allclose(path.points([float(t)])[0, :2], [float(x) for x in meeting.point], rtol=1e-9, atol=1e-9)
        assert meeting.on_joins == (False, False) and meeting.t[0] < meeting.t[1]
    marks = found.marks()
    assert [marks[name].shape for name in ("cusps", "self_intersections", "cuts")] == [(4, 2), (6, 2), (0, 2)]
    (outline,) = found.outlines()
    for x, y in [*marks["cusps"], *marks["self_intersections"]]:
        assert np.hypot(*(outline - (x, y)).T).min() < 1


# As in tests/ph/offset/offset_test.cpp: at d = -1/24 the halves touch at t = 1/4 and 3/4, farther out they cross twice.
def test_where_an_offset_touches_itself():
    mirrored = phrame.Path.from_json('{"phrame": "curve/1", "basis": "power", "preimage": {"u": ["1/2"], "v": [0], "p": [0], "q": [-1, 2]}}')
    found = mirrored.offset("-1/24")
    (meeting,) = found.self_intersections
    assert meeting.touches and meeting.t == (Decimal("0.25"), Decimal("0.75"))
    assert "touches itself" in found._repr_html_()
    assert [x.touches for x in mirrored.offset("-1/25").self_intersections] == [False, False]


# A cubic, around three sides to its middle, and on along it to the end a second time.
def test_where_an_offset_runs_along_itself():
    cubic = [["-11/24", "1/4"], ["-1/12", "-1/4"], ["2/3", 0], ["2/3", 1]]
    part = [[0, 0], ["1/6", 0], ["1/3", "1/12"], ["11/24", "1/4"]]
    way = [["2/3", 1], ["2/3", 2], [0, 2], [0, 0]]
    points = [cubic, *([a, b] for a, b in zip(way, way[1:])), part]
    path = phrame.Path.from_json(json.dumps({"phrame": "spline/1", "segments": [{"control_points": p} for p in points]}))
    offset = path.offset("1/5")
    (found,) = offset.coincident
    assert [round(float(t), 12) for t in found.first] == [0.333333333333, 0.666666666667]
    assert found.second == (4, 5) and found.on_joins == (False, False)
    answer = json.loads(offset.json())["offsets"][0]["self_intersections"]
    assert answer["complete"] and len(answer["coincident"]) == 1


# Along a line with x = 3t + 2t^3, round, and again with x = 2t^2 + 6t - 3.
def test_lines_along_each_other_up_to_irrational_parameters():
    way = [[5, 0], [5, 4], [-3, 4], [-3, 0]]
    points = [[[0, 0], [1, 0], [2, 0], [5, 0]], *([a, b] for a, b in zip(way, way[1:])), [[-3, 0], [0, 0], [5, 0]]]
    path = phrame.Path.from_json(json.dumps({"phrame": "spline/1", "segments": [{"control_points": p} for p in points]}))
    (found,) = path.offset("1/2").coincident
    assert found.first == (0, 1)
    assert [round(float(t), 12) for t in found.second] == [round(4 + (math.sqrt(15) - 3) / 2, 12), 5]
    (branch,) = path.offset("1/2", trim=True).branches
    assert branch.is_closed and round(float(branch.length), 12) == round(24 + math.pi, 12)


def test_branches_of_what_is_trimmed():
    found = TRIANGLE.offset("-1/2", trim=True)
    (branch,) = found.branches
    assert branch.is_closed and (branch.length, branch.area, branch.distance) == (6, 1.5, -0.5)
    assert [(str(part.start), str(part.end), part.kind) for part in branch.parts] == [("3/8", "7/8", "offset"), ("7/6", "5/3", "offset"), ("11/5", "27/10", "offset")]
    assert (found.length, found.area) == (6, 1.5) and found.cusps == ()
    assert {tuple(x) for x in found.marks()["cuts"]} == {(1.5, 0.5), (3.5, 0.5), (3.5, 2)}
    rooms = TRIANGLE.offset("-1/4", pocket=True).branches
    assert [(room.distance, room.length) for room in rooms] == [(-0.25, 9), (-0.5, 6), (-0.75, 3)]
    (half,) = CUBIC.offset(-1, trim=True).branches
    assert not half.is_closed and half.area is None and half.parts[0].is_cut_at_start and not half.parts[0].is_cut_at_end


def test_offsets_of_both_sides():
    found = phrame.Path.bezier([[0, 0, 0], ["1/2", 0, 0], [1, 1, 0]]).offset("1/3")
    x, y, w, t = found.two_sided.x, found.two_sided.y, found.two_sided.weight, found.two_sided.t
    for m in (-3, "1/2", 5):
        at = t[0](m) / t[1](m)
        gap = (x(m) / w(m) - at) ** 2 + (y(m) / w(m) - at * at) ** 2
        assert gap * 9 == 1
    with pytest.raises(phrame.DomainError, match="length"):
        found.length


def test_gauges():
    circle = phrame.Path.polynomial([1, 0, -1], [0, 2], [], [1, 0, 1])
    gauge = phrame.Gauge.of(circle)
    assert gauge.degree == 2 and gauge == phrame.Gauge.of(circle) and repr(gauge) == "<Gauge of degree 2>"
    assert (gauge.x(2), gauge.y(2), gauge.weight(2)) == (-3, 4, 5)
    assert CUBIC.offset("1/2", gauge=gauge).paths == CUBIC.offset("1/2").paths == CUBIC.offset("1/2", gauge=circle).paths
    ellipse = phrame.Path.polynomial([3, 0, -3], [0, 4], [], [1, 0, 1])
    corners = [[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0], [0, 0, 0]]
    box = phrame.Path([phrame.Path.from_control_points([a, b]) for a, b in zip(corners, corners[1:])])
    # By 3/7 to the sides and by 2/7 up and down, and so on.
    areas = [branch.area for branch in box.offset("-1/7", pocket=True, gauge=ellipse).branches]
    assert areas == [(4 - Fraction(6 * k, 7)) * (2 - Fraction(4 * k, 7)) for k in (1, 2, 3)]
    both = phrame.Path.bezier([[0, 0, 0], ["1/2", 0, 0], [1, 1, 0]]).offset("1/3", gauge=ellipse).two_sided
    for m in (-3, "1/2", 5):
        at = both.t[0](m) / both.t[1](m)
        x, y = both.x(m) / both.weight(m) - at, both.y(m) / both.weight(m) - at * at
        assert (x / 3) ** 2 + (y / 2) ** 2 == Fraction(1, 9) and x * 4 + y * 9 * 2 * at == 0
    with pytest.raises(phrame.DomainError, match="rational to each side over ℚ"):
        phrame.Path.bezier([[0, 0, 0], [1, 1, 0]]).offset(1, gauge=ellipse)
    beside = circle.translated([1, 0, 0])
    with pytest.raises(phrame.InputError, match="^path: gauge: it is not symmetric"):
        phrame.Gauge.of(beside)
    with pytest.raises(phrame.InputError, match="^gauge: it is not symmetric"):
        CUBIC.offset(1, gauge=beside)
    with pytest.raises(TypeError, match="gauge: a Gauge or a Path is wanted"):
        CUBIC.offset(1, gauge=3)


def test_a_check():
    good = CUBIC.check_offset(CUBIC.offset("1/2")[0], "1/2", tolerance="1e-9")
    assert good and good.passes and good.missing.number == 0 and good.missing.distance[1] < 1e-9
    points = CUBIC.offset("1/2")[0].points(np.linspace(0, 1, 20))
    for given in (points, points[:, :2], [points[:, :2]]):
        found = CUBIC.check_offset(given, "1/2", tolerance="1e-6")
        assert not found and found.is_decided and found.missing.number == len(found.missing.stretches) > 0
        low, high = found.too_much.distance
        assert 0 < low <= high < 2e-3  # of chords of 1/9
    assert repr(found).startswith("<OffsetCheck: not within")
    stretch = found.missing.stretches[0]
    assert stretch.is_proved and stretch.start.t < stretch.farthest.t < stretch.end.t and stretch.distance <= high * 2
    with pytest.raises(ValueError, match="two points are wanted"):
        CUBIC.check_offset([[0, 0]], 1)


def test_an_envelope():
    rows = [[0, 0, 1], ["3/2", 0, 1], [3, 1, 2]]
    whole = phrame.envelope(rows)
    (segment,) = whole.segments
    assert segment.degree == 2 and segment.sigma == phrame.Polynomial([3]) and segment.lightlike == ()
    a, b, c, d = segment.null_factors
    assert (a, b, c, d) == tuple(map(phrame.Polynomial, ([3, 2], [3, -2], [1], [1])))
    # Each point of a side touches its disc: at the distance r from the center.
    for t in (0, "1/3", 1):
        x, y, r = 3 * Fraction(t), Fraction(t) ** 2, 1 + Fraction(t) ** 2
        px, py, _ = segment.left.point(t)
        assert (px - x) ** 2 + (py - y) ** 2 == r * r
    found = phrame.envelope({"phrame": "mph/1", "control_points": rows}, trim=True)
    (branch,) = found.branches
    assert branch.is_closed and len(branch.parts) == 7 and {part.kind for part in branch.parts} == {"left", "right", "arc"}
    assert repr(found) == "<Envelope of 1 curve with radii, 1 loop>"
    assert json.loads(found.json()) == phrame.ask("envelope", {"phrame": "mph/1", "control_points": rows}, trim=True)
    assert len(phrame.envelope([rows, [[0, 0, 1], [1, 0, 1]]]).segments) == 2
    for wrong, message in (([[0, 0, 1], [1, 1, 1], [2, 0, 1]], "axis.*no Minkowski PH curve"), ([[0, 0, -1], [1, 0, -1]], "radius")):
        with pytest.raises(phrame.Error, match=message):
            phrame.envelope(wrong)


def test_what_has_no_offset():
    with pytest.raises(ValueError, match="0 is no distance"):
        CUBIC.offset(0)
    with pytest.raises(ValueError, match="not one of round, mitre, open"):
        CUBIC.offset(1, "bevel")
    parabola = phrame.Path.bezier([[0, 0, 0], ["1/2", 0, 0], [1, 1, 0]])
    for path, reason in (
        (QUINTIC, "^path: the curve is in no plane z = const$"),
        (phrame.Path([CUBIC, phrame.Curve([1], [0], [1], [1], start=CUBIC.point(1))]), "^path: segment 2 is in no plane z = const$"),
        (phrame.Path.bezier([[0, 0, 0], [1, 0, 0], [1, 1, 0], [3, 1, 0]]), "^path: (it is not Pythagorean-hodograph|the path is not PH, so that its offset is not rational)$"),
    ):
        for ask in (
            lambda path: path.offset(1),
            lambda path: path.offset(1, trim=True),
            lambda path: path.offset(1, pocket=True),
            lambda path: path.check_offset([[0, 0, 0], [1, 0, 0]], 1),
            lambda path: path.plot_offset(1),
        ):
            with pytest.raises(phrame.InputError, match=reason):
                ask(path)
    with pytest.raises(phrame.InputError, match="^path: the path is not PH: its offset is rational for both sides together, which is not trimmed$"):
        parabola.offset(1, trim=True)
    with pytest.raises(phrame.InputError, match="^path: segment 1 is not in a plane z = const$"):
        phrame.Path.bezier([[0, 0, 0], [1, 0, 0], [1, 1, 1]]).near_ph("1e-3")
    with pytest.raises(phrame.InputError, match="^path: the curve is in no plane z = const$"):
        QUINTIC.offset(1, gauge=phrame.Path.polynomial([1, 0, -1], [0, 2], [], [1, 0, 1]))
    with pytest.raises(phrame.DomainError, match="nothing but points is left"):  # the center of an arc
        phrame.Path.polynomial([1, 0, -1], [0, 2], [], [1, 0, 1]).offset(-1).length
