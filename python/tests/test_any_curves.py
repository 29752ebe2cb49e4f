"""Curves of any kind, against mpmath's quadrature and derivatives, and against the program."""

import copy
import math
import os
import pickle
import random
import re
import subprocess
from fractions import Fraction

import mpmath
import numpy as np
import pytest

import phrame
from common import MULTIPLIER, PROGRAM, QUINTIC, ROOT

CURVE = phrame.Curve
CUBIC = CURVE.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
HELIX = CURVE.expressions("cos(s)", "sin(s)", "s", 0, "2*pi", name="helix")
QUARTER = CURVE.bezier([[1, 0, 0], [1, 1, 0], [0, 1, 0]], [1, 1, 2])
NURBS = CURVE.nurbs([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2], [5, 5, 5]], [1, 2, 1, "1/2", 1], degree=3)
CAMERA = phrame.read(ROOT / "examples/any/camera.csv")


def near(x, exact, digits=28):
    return abs(mpmath.mpf(str(x.digits(digits + 2))) - exact) <= abs(exact) * mpmath.mpf(10) ** -digits


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Sampled:
    """r′, r″, r‴ of X/W, with coefficients from the lowest on, and what follows from them."""

    def __init__(self, numerators, weight):
        self.lists = [self.derivatives(p) for p in (*numerators, weight)]

    @staticmethod
    def derivatives(p):
        """p^(k)/k! for k ≤ 3, each from the highest coefficient on."""
        return [[math.comb(j, k) * c for j, c in enumerate(p) if j >= k][::-1] for k in range(4)]

    def rates(self, t):
        *numerators, w = ([mpmath.polyval(p, t) for p in of] for of in self.lists)
        columns = []
        for x in numerators:
            r = []
            for k in range(4):
                r.append((x[k] - sum(r[j] * w[k - j] for j in range(k))) / w[0])
            columns.append([r[1], 2 * r[2], 6 * r[3]])
        return list(map(list, zip(*columns)))

    def speed(self, t):
        return mpmath.norm(self.rates(t)[0])

    def curvature(self, t):
        first, second, _ = self.rates(t)
        return mpmath.norm(cross(first, second)) / mpmath.norm(first) ** 3

    def torsion(self, t):
        first, second, third = self.rates(t)
        return dot(cross(first, second), third) / mpmath.norm(cross(first, second)) ** 2

    def turning(self, v):
        def rate(t):
            first, second, _ = self.rates(t)
            return -dot(v, first) * dot(v, cross(first, second)) / (
                mpmath.norm(first) * mpmath.norm(cross(v, first)) ** 2)

        return rate


def sampled_bezier(points, weights):
    """Σ binom(3, i) t^i (1 − t)^(3 − i)·wᵢ(Pᵢ, 1), expanded by hand."""
    basis = [[1, -3, 3, -1], [0, 3, -6, 3], [0, 0, 3, -3], [0, 0, 0, 1]]
    lists = [[w * p[c] for p, w in zip(points, weights)] for c in range(3)] + [weights]
    *numerators, weight = ([sum(x * b[k] for x, b in zip(values, basis)) for k in range(4)] for values in lists)
    return Sampled(numerators, weight)


@pytest.mark.parametrize("seed", range(2 * MULTIPLIER))
def test_lengths_and_angles_agree_with_quadrature(seed):
    rng = random.Random(seed)
    points = [[rng.randint(-9, 9) for _ in range(3)] for _ in range(4)]
    weights = [rng.randint(1, 3) for _ in range(4)] if seed % 2 else [1] * 4
    curve = CURVE.bezier(points, weights)
    v = curve.up
    with mpmath.workdps(15):
        exact = sampled_bezier(points, weights)

        def integral(f, *ends):
            return mpmath.quad(f, ends, method="gauss-legendre", maxdegree=5)

        assert near(curve.length, integral(exact.speed, 0, 0.5, 1), 9)
        assert near(curve.angle().value(1), integral(exact.turning([int(x) for x in v]), 0, 0.5, 1), 9)
        t = mpmath.mpf(1) / 4
        assert near(curve.curvature("1/4"), exact.curvature(t), 12)
        assert abs(float(curve.torsion("1/4")) - float(exact.torsion(t))) < 1e-12
        assert near(curve.arc_length("1/4"), integral(exact.speed, 0, 0.25), 9)
        s = Fraction(float(curve.length)) / 3
        assert abs(curve.arc_length(Fraction(str(curve.parameter_at(s).digits(20)))) - s) < Fraction(1, 10**15)


def test_points_of_the_plane():
    flat, space = [[0, 0], [1, "1/2"], [2, 0]], [[0, 0, 0], [1, "1/2", 0], [2, 0, 0]]
    for make in (CURVE.bezier, CURVE.polyline, CURVE.cubic_spline, CURVE.through, lambda points: CURVE.nurbs(points, degree=2), lambda points: CURVE.near(points, 1)):
        assert make(flat) == make(space)
    assert CURVE.hermite([0, 0], [1, 0], [1, 1], [0, 1]) == CURVE.hermite([0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0])


def test_a_helix():
    with mpmath.workdps(40):
        assert near(HELIX.length, 2 * mpmath.pi * mpmath.sqrt(2))
        assert near(HELIX.total_curvature, mpmath.pi * mpmath.sqrt(2))
        assert near(HELIX.total_torsion, mpmath.pi * mpmath.sqrt(2))
        assert near(HELIX.bending_energy, mpmath.pi / mpmath.sqrt(2))
        assert near(HELIX.frenet_energy, mpmath.pi * mpmath.sqrt(2))
        frenet = HELIX.angle("frenet").value(1)
        assert near(frenet, -mpmath.pi * mpmath.sqrt(2))  # −∫ τ ds
    assert HELIX.curvature("1/3").ball(80)[0] <= Fraction(1, 2) <= HELIX.torsion("1/3").ball(80)[1]
    assert not HELIX.is_closed and HELIX.holonomy is None and HELIX.name == "helix"
    assert HELIX.point(0) == (1, 0, 0) and float(HELIX.point("1/2")[2]) == np.pi
    turn = float(HELIX.angle(up=[0, 0, 1]).value(1)) / float(frenet)  # e₂ of z is −n, turning as n does
    assert abs(turn - 1) < 1e-15


def test_circles():
    with mpmath.workdps(40):
        assert near(QUARTER.length, mpmath.pi / 2) and near(QUARTER.total_curvature, mpmath.pi / 2)
    assert QUARTER.curvature("1/3") == 1 and QUARTER.torsion("1/3") == 0 and QUARTER.total_torsion == 0
    assert QUARTER.up == (0, 0, 1) and QUARTER.angle().is_zero and QUARTER.angle().value(1) == 0
    circle = CURVE.expressions("cos(s)", "sin(s)", 0, 0, "2*pi")
    assert circle.is_closed and circle.holonomy == 0
    x, y, z = QUARTER.point("1/3")
    assert x * x + y * y == 1 and z == 0


def test_b_splines_are_sums_of_basis_functions():
    """Cox's and de Boor's recursion, in fractions."""
    points = [[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2], [5, 5, 5]]
    weights = [1, 2, 1, Fraction(1, 2), 1]
    knots = [Fraction(k) for k in (0, 0, 0, 0, 1, 2, 2, 2, 2)]

    def basis(k, p, u):
        if p == 0:
            return Fraction(knots[k] <= u < knots[k + 1])
        result = Fraction(0)
        if knots[k + p] > knots[k]:
            result += (u - knots[k]) / (knots[k + p] - knots[k]) * basis(k, p - 1, u)
        if knots[k + p + 1] > knots[k + 1]:
            result += (knots[k + p + 1] - u) / (knots[k + p + 1] - knots[k + 1]) * basis(k + 1, p - 1, u)
        return result

    assert CURVE.nurbs(points, weights, knots) == CURVE.nurbs(points, weights, knots[1:-1]) == NURBS
    for u in (Fraction(0), Fraction(1, 3), Fraction(1), Fraction(13, 7)):
        terms = [basis(k, 3, u) * w for k, w in enumerate(weights)]
        assert NURBS.point(u) == tuple(dot(terms, [p[c] for p in points]) / sum(terms) for c in range(3))


def test_cubic_splines_have_two_continuous_derivatives():
    points = [[0, 0, 0], [1, "1/2", 0], [2, 0, 1], [3, 1, 1]]
    for ends in ("natural", "periodic"):
        path = CURVE.cubic_spline(points, spacing="uniform", ends=ends)
        assert [path.point(k) for k in range(4)] == [tuple(map(Fraction, p)) for p in points]

        def bends(segment):
            """r″ at both ends, of a cubic by its differences."""
            r = [segment.point(Fraction(k, 3)) for k in range(4)]
            return [[9 * x for x in (a[0], a[1])] for a in (
                (2 * p - 5 * q + 4 * s - t, -p + 4 * q - 5 * s + 2 * t) for p, q, s, t in zip(*r))]

        inner = [bends(segment) for segment in path.segments]
        for before, after in zip(inner, inner[1:] + (inner[:1] if ends == "periodic" else [])):
            assert [b[1] for b in before] == [a[0] for a in after]
        assert path.is_closed == (ends == "periodic")
        if ends == "natural":
            assert not any(b[0] for b in inner[0]) and not any(b[1] for b in inner[-1])
    clamped = CURVE.cubic_spline(points, parameters=[0, 1, 3, 4], ends="clamped", start_derivative=[1, 0, 0],
                                 end_derivative=[0, 1, 0])
    r = clamped.segments[0]
    slope = [-Fraction(11, 2) * a + 9 * b - Fraction(9, 2) * c + d
             for a, b, c, d in zip(*(r.point(Fraction(k, 3)) for k in range(4)))]
    assert slope == [1, 0, 0]


def test_frenet_angles_of_splines():
    """Of C² splines the Frenet frame goes on through the joints: θ = −∫τ ds."""
    points = [[0, 0, 0], [3, 0, 1], [4, 3, -1], [1, 4, 0], [-1, 2, 2]]
    path = CURVE.cubic_spline(points, ends="periodic")
    assert float(path.angle(frame="frenet").value(5)) == pytest.approx(-float(path.total_torsion), abs=1e-13)
    corner = phrame.Path([CURVE.bezier([[0, 0, 0], [1, 0, 0], [1, 1, 0]]),
                                       CURVE.bezier([[1, 1, 0], [1, 2, 0], [1, 2, 1]])])
    with pytest.raises(phrame.DomainError, match="at the joint t = 1 it jumps, by 1.57 radians"):
        corner.angle(frame="frenet")


def test_columns_of_tables():
    rows = "0,0,0,0,a\n1,1,2,0,b\n5,3,1,1,c\n"
    with pytest.warns(UserWarning, match="the column time is taken|skipped is the column label") as told:
        timed = phrame.parse("time,x,y,z,label\n" + rows)
    assert len(told) == 2
    with pytest.warns(UserWarning, match="skipped is the column label"):
        assert phrame.parse("t,x,y,z,label\n" + rows) == timed


def test_lengths_that_are_sums_of_roots():
    curve = CURVE.polynomial([0, 0, "9/32"], [0, 0, 0, "9/64"], [0])
    assert curve.length == Fraction(61, 192) and curve.parameter_at(Fraction(61, 192)) == 1
    eight = CURVE.expressions("sin(s)", "sin(2*s)", 0, 0, "2*pi")
    assert eight.writhe == 0


def test_ph_curves_are_found():
    again = CURVE.bezier(QUINTIC.control_points)
    assert again.is_ph and again.kind == "ph" and again.control_points == QUINTIC.control_points
    assert CURVE.polynomial(*QUINTIC.position).hodograph == QUINTIC.hodograph
    assert not CURVE.polynomial([0, 1], [0, 0, 1]).is_ph
    assert CURVE.polynomial([0, "1/2", 1], [0, 0, 1], [0, 0, 0], basis="bernstein") == CURVE.expressions("s", "s^2", 0, 0, 1)
    assert phrame.parse(QUINTIC.json()) == QUINTIC
    straight = phrame.Path([CURVE.bezier([[0, 0, 0], [1, 0, 0]]), CURVE.bezier([[1, 0, 0], [2, 0, 0], [4, 0, 5]])])
    assert straight.end == 2 and straight.point(1) == (1, 0, 0)


@pytest.mark.parametrize("name", ["CUBIC", "NURBS", "HELIX", "CAMERA"])
def test_arrays(name):
    """Approximations with a proof, the values one by one, and quaternions that turn into the frames."""
    path = globals()[name]
    n = 9 if path is HELIX else 16 * path.end + 1  # few are computed one by one
    ts = np.linspace(0, path.end, n)
    theta = path.angle(start="pi/8")
    at = list(ts[:: n // 5])
    many = path.frames(ts, start="up+pi/8")
    assert (path.frames(at, start="up+pi/8") == many[:: n // 5]).all()
    assert (theta(ts)[:: n // 5] == [float(theta.value(t)) for t in at]).all() and theta(0) == np.pi / 8
    up = path.frames(at, kind="up")
    c, s = (f(theta(np.array(at)))[:, None] for f in (np.cos, np.sin))
    assert np.abs(c * up[:, 1] + s * up[:, 2] - many[:: n // 5, 1]).max() < 1e-15
    x, y, z, w = path.quaternions(ts, start="up + pi/8").T
    matrix = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                       [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                       [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
    assert np.abs(matrix.transpose(2, 1, 0) - many).max() < 2e-15
    q = path.quaternions(ts)
    assert (np.sum(q[1:] * q[:-1], axis=1) > 0).all() and (path.quaternions(at) == q[:: n // 5]).all()
    poses = path.matrices(at, start="up+pi/8")
    assert (poses[:, :3, :3].transpose(0, 2, 1) == many[:: n // 5]).all()
    assert (poses[:, :3, 3] == path.points(at)).all() and (poses[:, 3] == [0, 0, 0, 1]).all()
    assert (path.points(at) == [[float(x) for x in path.point(t)] for t in at]).all()
    assert bool(path.check(at, path.frames(at)[:, 1])) and not path.check(at, many[:: n // 5, 1], start=0)


def test_by_arc_length():
    s = [0, Fraction(1, 2), 2]
    for path in (CUBIC, QUINTIC):
        t = [float(x) for x in (0, *(path.parameter_at(x) for x in s[1:]))]
        for name in ("points", "frames", "quaternions", "matrices"):
            by_length = getattr(path, name)(s, by="arc-length")
            assert np.abs(by_length - getattr(path, name)(t)).max() < 1e-14, name
    for kind in ("rmf", "erf", "frenet"):
        x, y, z, w = QUINTIC.quaternions(s, kind=kind, by="arc-length").T
        e1 = np.array([1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)]).T
        f2 = np.array([2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)]).T
        frames = QUINTIC.frames(s, kind=kind, by="arc-length")
        assert np.abs(e1 - frames[:, 0]).max() < 1e-15 and np.abs(f2 - frames[:, 1]).max() < 2e-15


def test_where_a_frame_starts():
    e1, f2, _ = CUBIC.frames([0.0], start_normal=[0, 0, 1])[0]
    projected = np.cross(e1, np.cross([0, 0, 1], e1))
    assert np.abs(projected / np.linalg.norm(projected) - f2).max() < 1e-15
    twist = CUBIC.minimal_twist([0, 0, 1], "pi/3")
    assert float(twist.length) == float(CUBIC.length)
    assert abs(float(twist.rate) * float(CUBIC.length) - float(twist.twist)) < 1e-15
    turn = (float(twist.value(1)) - np.pi / 3) / (2 * np.pi)
    assert abs(turn - round(turn)) < 1e-14


def test_values_are_pickled_and_copied():
    for path in (CUBIC, NURBS, HELIX, QUARTER, *CAMERA.segments[:2]):
        again = pickle.loads(pickle.dumps(path))
        assert again == path and hash(again) == hash(path) and again.name == path.name
        assert copy.copy(path) is path and copy.deepcopy(path) is path
        assert pickle.loads(pickle.dumps(path.angle(start=1))).json() == path.angle(start=1).json()
        for x in (path.length, path.angle().value("1/3"), path.curvature("1/3"), path.point("1/3")[0],
                  path.minimal_twist(0, 1).twist):
            assert float(pickle.loads(pickle.dumps(x))) == float(x)
    assert CUBIC != HELIX and CUBIC != QUINTIC
    f2 = CUBIC.frames([0, 1])[:, 1].copy()
    check = CUBIC.check([0, 1], f2)
    before = check.json()
    f2[:] = 0
    assert pickle.loads(pickle.dumps(check)).json() == before


@pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")
def test_files_of_all_kinds_give_what_the_program_gives():
    files = sorted((ROOT / "examples/any").iterdir())
    for file in files if MULTIPLIER > 1 else files[:: 3]:
        if file.suffix not in (".json", ".csv", ".svg", ".npy"):
            continue
        run = subprocess.run([PROGRAM, "angle", str(file), "--print", "json"], capture_output=True, text=True, check=False)
        if run.returncode:
            with pytest.raises(phrame.Error):
                phrame.read(file).angle().json()
            continue
        path = phrame.read(file)
        assert path == phrame.parse(file.read_bytes())
        assert path.angle().json() == run.stdout, file.name


def test_what_is_shown():
    assert repr(HELIX) == "<Path helix: (cos(s), sin(s), s), s from 0 to 2*pi>"
    assert repr(CAMERA).endswith(f": {CAMERA.end} segments>")
    assert repr(CUBIC.angle(up=[0, 0, 1])) == "<Angle to the frame of (0, 0, 1)>"
    assert "Pythagorean" in CUBIC.angle().text() and "align" in CUBIC.angle().latex() or CUBIC.angle().latex()


def test_what_is_refused():
    for place, ask in [
        ("weights", lambda: CURVE.bezier([[0, 0, 0], [1, 1, 1]], [1])),
        ("weights[1]", lambda: CURVE.bezier([[0, 0, 0], [1, 1, 1]], [1, -1])),
        ("points", lambda: CURVE.bezier([[1, 1, 1], [1, 1, 1]])),
        ("knots[4]", lambda: CURVE.nurbs([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]], knots=[0, 0, 0, 0, -1, 1, 1, 1])),
        ("degree", lambda: CURVE.nurbs([[0, 0, 0], [1, 2, 0]])),
        ("w", lambda: CURVE.polynomial([0, 1], [0, 0, 1], w=["-1/2", 1])),
        ("x", lambda: CURVE.expressions("cos(s", "s", 0, 0, 1)),
        ("y", lambda: CURVE.expressions("cos(s)", "t", 0, 0, 1)),
        ("upper", lambda: CURVE.expressions("cos(s)", "s", 0, 0, "s")),
        ("x", lambda: CURVE.expressions("1/(s - 1/2)", "sin(s)", 0, 0, 1)),
        ("z", lambda: CURVE.expressions("s", "s", "1/(s - 1)", 0, 2)),
        ("points[1]", lambda: CURVE.polyline([[0, 0], [1, 1, 0]])),
        ("ends", lambda: CURVE.cubic_spline([[0, 0, 0], [1, 1, 1]], ends="free")),
        ("end_derivative", lambda: CURVE.cubic_spline([[0, 0, 0], [1, 1, 1]], end_derivative=[1, 0, 0])),
        ("parameters[1]", lambda: CURVE.cubic_spline([[0, 0, 0], [1, 1, 1]], parameters=[1, 1])),
        ("curves[1]", lambda: phrame.Path([CUBIC, CUBIC])),
        ("up", lambda: CUBIC.angle(up=[1, 2, 0])),
        ("kind", lambda: CUBIC.frames([0], kind="erf")),
        ("frame", lambda: CUBIC.angle("erf")),
    ]:
        with pytest.raises(phrame.InputError) as raised:
            ask()
        assert raised.value.place == place and str(raised.value).startswith(place + ": ")
    for place, ask in [
        ("t", lambda: CUBIC.point(2)),
        ("ts[1]", lambda: CUBIC.points([0, 2])),
        ("ts[0]", lambda: CUBIC.frames([2], by="fraction")),
        ("about", lambda: CUBIC.helicity([0, 0, 0])),
    ]:
        with pytest.raises(phrame.DomainError, match=re.escape(place)) as raised:
            ask()
        assert raised.value.place == place
    pipe = str(ROOT / "examples/any/pipe.dxf")
    with pytest.raises(phrame.InputError, match="there are 5 curves, and pick= names one") as raised:
        phrame.read(pipe)
    assert raised.value.place.startswith(pipe + ":line ")
    with pytest.raises(TypeError, match="text"):
        phrame.parse(3)


def _paths(rng):
    """Some of every kind."""
    def points(n):
        return [[rng.randint(-9, 9) for _ in range(3)] for _ in range(n)]

    yield phrame.Curve.through(points(4))
    yield phrame.Curve([rng.randint(1, 9), 2], [rng.randint(-9, 9), 1], [0, 3], [1, rng.randint(-9, 9)])
    yield phrame.Curve.bezier(points(4))
    yield phrame.Curve.nurbs(points(5), [1, 2, 3, 2, 1], degree=2) if rng.random() < 0.5 else phrame.Curve.nurbs(points(5))
    yield phrame.Curve.cubic_spline(points(4))
    yield phrame.Curve.expressions("cos(s)", "sin(s)", f"s*{rng.randint(1, 9)}/7", 0, f"sqrt({rng.randint(2, 9)})")


def test_a_length_that_is_rounded_up_is_the_end():
    rng = random.Random(2)
    beyond = 0
    for _ in range(2 * MULTIPLIER):
        for path in _paths(rng):
            length, end = float(path.length), path.end
            t = path.parameter_at(length)
            assert end - 1e-12 < t <= end
            if path.length < Fraction(length):
                beyond += 1
                assert t == end and path.parameter_at(repr(length)) == end
                assert (path.frames([length], by="arc-length") == path.frames([end])).all()
                assert (path.points([length], by="arc-length") == path.points([end])).all()
            too_long = length * (1 + 2**-50)
            with pytest.raises(phrame.DomainError, match=rf"^s: .*{too_long!r} is outside \[0, "):
                path.parameter_at(too_long)
            with pytest.raises(phrame.DomainError, match=rf"^ts\[1\]: .*{too_long!r} is outside \[0, "):
                path.points([0, too_long], by="arc-length")
    assert beyond


def test_frames_start_by_the_tangent():
    """f₂(0) by Rodrigues' formula; the same whatever the curve is given by."""
    points = [[0, 0, 0], ["4/5", "4/5", "2/5"], ["3/5", "6/5", "9/5"], ["-2/15", "14/15", "12/5"], ["-8/15", "26/15", "17/5"], ["1/15", "38/15", "17/5"]]
    exact = phrame.Curve.bezier(points)
    rounded = phrame.Curve.bezier([[float(Fraction(x)) for x in p] for p in points])
    assert exact.is_ph and not rounded.is_ph
    ts = np.linspace(0, 1, 9)
    assert np.abs(exact.frames(ts) - rounded.frames(ts)).max() < 4e-15
    e = np.array([2, 2, 1]) / 3
    n = np.cross([1, 0, 0], e)
    assert np.abs(exact.frames([0])[0, 1] - (np.array([0, 1, 0]) + np.cross(n, [0, 1, 0]) + np.cross(n, np.cross(n, [0, 1, 0])) / (1 + e[0]))).max() < 1e-15
    assert (exact.frames(ts, start="least") == exact.frames(ts)).all() and (exact.frames([0], start="erf") == exact.frames([0], kind="erf")).all()
    assert (rounded.frames([0], start="up") == rounded.frames([0], kind="up")).all()
    turned = exact.frames(ts, start="pi/2")
    assert (turned[:, 1] == exact.frames(ts)[:, 2]).all()
    assert (exact.frames(ts, start="up") == exact.frames(ts, start="up", up=exact.up)).all() and (exact.frames([0], start="up") == exact.frames([0], kind="up")).all()
    for path, word in ((rounded, "erf"), (exact, "frenet"), (exact, "erfx")):
        with pytest.raises(phrame.InputError, match="start"):
            path.frames([0], start=word)
