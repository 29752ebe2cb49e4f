"""Curves in all forms, their polynomials, totals and kinds; constructions."""

import json
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import QUINTIC, ROOT


def test_the_same_curve_in_all_forms():
    by_quaternions = phrame.Curve.from_quaternions(
        [[2, 1, 0, 1], [0, 1, -2, 2], [2, 0, 0, 1]], basis="bernstein")
    by_hopf = phrame.Curve.from_hopf([(2, 1), (-4, 0), (4, -1)], [1 + 0j, 2 - 4j, (-2, 4)])
    assert by_quaternions == by_hopf == QUINTIC and hash(by_hopf) == hash(QUINTIC)
    again = phrame.Curve.from_control_points(QUINTIC.control_points)
    assert again.hodograph == QUINTIC.hodograph and again.control_points == QUINTIC.control_points
    assert phrame.Curve.from_json(QUINTIC.json()) == QUINTIC
    file = ROOT / "examples/curves/farouki-2003-quintic.json"
    assert phrame.Curve.read(file) == phrame.Path.read(str(file)) == QUINTIC


def test_a_curve_is_what_it_says():
    x, y, z = QUINTIC.hodograph
    assert x * x + y * y + z * z == QUINTIC.sigma * QUINTIC.sigma
    assert QUINTIC.degree == 5 and QUINTIC.end == 1 and QUINTIC.segments == (QUINTIC,)
    assert QUINTIC.length == sum(c / (k + 1) for k, c in enumerate(QUINTIC.sigma.coefficients))
    assert QUINTIC.point("1/3") == tuple(r(Fraction(1, 3)) for r in QUINTIC.position)
    u, v, p, q = QUINTIC.preimage
    assert QUINTIC.h == u * v.derivative() - u.derivative() * v - p * q.derivative() + p.derivative() * q
    g_re, g_im = QUINTIC.g
    four = phrame.Polynomial([4])
    assert QUINTIC.rho == four * (g_re * g_re + g_im * g_im)
    assert QUINTIC.squared_curvature("1/3") * QUINTIC.sigma("1/3") ** 4 == QUINTIC.rho("1/3")
    assert QUINTIC.angle().rate()(2) == -2 * QUINTIC.h(2) / QUINTIC.sigma(2)
    moved = QUINTIC.translated([1, 2, 3]).scaled(2)
    assert moved.point(1) == tuple(2 * (x + n) for x, n in zip(QUINTIC.point(1), (1, 2, 3)))
    assert QUINTIC.segment("1/4", 1).point(1) == QUINTIC.reversed().point(0) == QUINTIC.point(1)


def test_constructions():
    curve = phrame.Curve.hermite([0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 1])
    assert curve.is_ph and curve.degree == 5
    assert all(abs(x - 1) < Fraction(1, 10**14) for x in curve.point(1))
    assert all(abs(r(1) - d) < Fraction(1, 10**14) for r, d in zip(curve.hodograph, (0, 1, 1)))
    points = np.array([[0, 0, 0], [1, 0.5, 0], [2, 0, 1], [3, 1, 1]])
    path = phrame.Curve.through(points)
    assert path.is_ph and path.end == 3
    assert np.abs(path.points([0, 1, 2, 3]) - points).max() < 1e-14
    assert phrame.Path(path.segments) == path
    closed = phrame.Curve.through(points, closed=True)
    assert closed.is_closed and closed.point(0) == closed.point(closed.end) and closed.holonomy is not None
    rounded = [[float(x) + 1e-17 for x in point] for point in QUINTIC.control_points]
    near = phrame.Curve.near(rounded, "1e-12")
    off = max(abs(a - Fraction(b)) for p, q in zip(near.control_points, rounded) for a, b in zip(p, q))
    assert off <= Fraction(1, 10**12)


def test_all_kinds_of_constructions():
    points = [[0, 0, 0], [1, 0.5, 0], [2, 0, 1], [3, 1, 1]]
    slopes = [[1, 1, 0], [1, 0, 1], [1, 0, 0], [0, 1, 1]]
    bends = [[0, 0, 1], [0, 1, 0], [0, 0, 0], [1, 0, 0]]
    for kind, more in {"quintic": {}, "helical": {"derivatives": slopes}, "rrmf": {},
                       "rmf": {"derivatives": slopes}, "c2": {},
                       "c2-hermite": {"derivatives": slopes, "accelerations": bends}}.items():
        path = phrame.Curve.through(points, kind=kind, **more)
        met = min(np.abs(path.points([t]) - points[-1]).max() for t in (path.end,))
        assert met < 1e-14 and path.point(0) is not None, kind
        if kind == "rmf":
            assert path.classify().erf_is_rotation_minimizing
        if kind == "helical":
            assert path.segments[0].classify().helix
    cubic = phrame.Curve([1], [0, 1], [0], [0, 1])
    ends = [cubic.point(0), cubic.point(1)]
    rates = [[r(t) for r in cubic.hodograph] for t in (0, 1)]
    again = phrame.Curve.through(ends, tangents=rates, kind="cubic")
    assert again.degree == 3 and np.abs(again.points([0.5]) - cubic.points([0.5])).max() < 1e-14
    plane = phrame.Curve.through([[0, 0, 0], [1, 1, 0], [2, 0, 0]], kind="planar")
    assert plane.classify().normal == (0, 0, 1)
    exact = phrame.Curve.through(points, exact=True)
    assert exact.point(exact.end) == (3, 1, 1) and {exact.point(k) for k in range(exact.end + 1)} >= {(2, 0, 1)}


def test_which_of_several_quintics():
    data = [0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 1]
    found = {select: phrame.Curve.hermite(*data, select=select, name=select)
             for select in ("auto", "minimal", "bv", "cc", "shortest", "longest", "energy")}
    lengths = {select: float(curve.length) for select, curve in found.items()}
    assert lengths["shortest"] <= min(lengths.values()) + 1e-12 and lengths["longest"] >= max(lengths.values()) - 1e-12
    assert float(found["energy"].bending_energy) <= float(found["auto"].bending_energy) and found["bv"].name == "bv"
    assert float(phrame.Curve.hermite(*data, angles=[0, 0]).length) == lengths["minimal"]
    assert phrame.Curve.hermite(*data, angles=["pi/2", 0]) != found["minimal"]
    turned = phrame.Curve.hermite(*data, angles=[0.1, 0.2, 0.3])  # the same for all does not count
    assert np.abs(turned.points([0.5]) - phrame.Curve.hermite(*data, angles=[1.1, 1.2, 1.3]).points([0.5])).max() < 1e-12
    first, second = (phrame.Curve.hermite(*data, kind="helical", solution=k) for k in (1, 2))
    assert first != second
    bent = phrame.Curve.hermite(*data, kind="c2-hermite", a0=[0, 0, 1], a1=[1, 0, 0])
    assert [abs(float(r.derivative()(0)) - x) < 1e-13 for r, x in zip(bent.hodograph, (0, 0, 1))] == [True] * 3
    assert abs(float(phrame.Curve.hermite(*data, kind="length", length=2).length) - 2) < 1e-14
    long = phrame.Curve.through([[0, 0, 0], [1, 1, 1], [2, 1, 0]], kind="length", lengths=["2", 3])
    assert [round(float(segment.length), 13) for segment in long.segments] == [2, 3]
    for wrong in ({"lengths": [1, 2]}, {}, {"lengths": -1}):
        with pytest.raises(phrame.Error, match="length"):
            phrame.Curve.through([[0, 0, 0], [1, 1, 1], [2, 1, 0]], kind="length", **wrong)


def test_closed_curves():
    """The writhe is Gauss's integral, here by midpoints."""
    trefoil = phrame.Curve.expressions("(2 + cos(3*s))*cos(2*s)", "(2 + cos(3*s))*sin(2*s)", "sin(3*s)", 0, "2*pi")
    n = 300
    s = (np.arange(n) + 0.5) * 2 * np.pi / n
    t = s + np.pi / n
    radius, slope = (lambda s: 2 + np.cos(3 * s)), (lambda s: -3 * np.sin(3 * s))
    at = lambda s: np.stack([radius(s) * np.cos(2 * s), radius(s) * np.sin(2 * s), np.sin(3 * s)], axis=1)
    rate = lambda s: np.stack([slope(s) * np.cos(2 * s) - 2 * radius(s) * np.sin(2 * s),
                               slope(s) * np.sin(2 * s) + 2 * radius(s) * np.cos(2 * s), 3 * np.cos(3 * s)], axis=1)
    off = at(s)[:, None] - at(t)[None]
    gauss = np.sum(off * np.cross(rate(s)[:, None], rate(t)[None]), axis=2) / np.linalg.norm(off, axis=2) ** 3
    assert abs(float(trefoil.writhe) - gauss.sum() * (2 * np.pi / n) ** 2 / (4 * np.pi)) < 1e-3
    linking = float(trefoil.writhe) + float(trefoil.total_torsion) / (2 * np.pi)
    assert trefoil.self_linking_number == round(linking) and abs(linking - round(linking)) < 1e-12
    assert trefoil.helicity() == -3 and phrame.Curve.expressions(
        "(1-cos(2*p)/5)*cos(p)", "(1-cos(2*p)/5)*sin(p)", "3/10*sin(2*p)", 0, "2*pi", variable="p").helicity([0, 0, 1]) == 1
    through = phrame.read(ROOT / "examples/curves/inflected-quintic.json").frames(np.linspace(0, 1, 9), kind="frenet-signed")
    assert ((through[1:, 1] * through[:-1, 1]).sum(axis=1) > 0.9).all() and (through[4, 1] == [0, -1, 0]).all()
    assert QUINTIC.writhe is None and QUINTIC.self_linking_number is None and QUINTIC.holonomy is None
    closed = phrame.Curve.through([[0, 0, 0], [2, 0, 1], [2, 2, 0], [0, 2, 1]], closed=True)
    whole = float(closed.writhe) - float(closed.holonomy) / (2 * np.pi)
    assert abs(whole - round(whole)) < 1e-12


def test_classification_and_totals():
    helix = phrame.Curve([1], [0, 1], [0], [0, 1])
    assert QUINTIC.classify().is_regular and QUINTIC.classify().helix is None
    plane = phrame.Curve([1, 1], [0], [0], [0, 2]).classify()
    assert plane.normal == (0, 0, 1) and plane.rational_frame is not None and plane.erf_is_rotation_minimizing
    cusp = phrame.Curve([-1, 2], [0], [0], [0])
    assert cusp.classify().cusps == ((Fraction(1, 2), 2),) and not cusp.classify().is_regular
    assert cusp.bending_energy == 0 and cusp.classify().line == (1, 0, 0)
    assert float(helix.total_curvature) > 0
    assert float(QUINTIC.erf_twist) == -QUINTIC.angle()(1.0)
