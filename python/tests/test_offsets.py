"""Offsets of plane PH paths."""

import json
import math

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


def test_an_envelope_by_ask():
    axis = {"phrame": "mph/1", "control_points": [[0, 0, 1], ["3/2", 0, 1], [3, 1, 2]]}
    answer = phrame.ask("envelope", axis, trim=True)
    assert answer["segments"][0]["sigma"] == ["3"]  # (3, 2t, 2t)
    (boundary,) = answer["branches"]
    assert boundary["closed"] and len(boundary["parts"]) == 7
    with pytest.raises(phrame.InputError, match="no Minkowski PH curve"):
        phrame.ask("envelope", {"phrame": "mph/1", "control_points": [[0, 0, 1], [1, 1, 1], [2, 0, 1]]})


def test_what_has_no_offset():
    with pytest.raises(ValueError, match="0 is no distance"):
        CUBIC.offset(0)
    with pytest.raises(ValueError, match="not one of round, mitre, open"):
        CUBIC.offset(1, "bevel")
    with pytest.raises(phrame.DomainError, match="no plane z = const"):
        QUINTIC.offset(1)
