"""The package phrame: numbers in and out, objects, arrays, errors, pickles.

Expected values come from fractions, from mpmath's quadrature of the rate that is written here, and from the
program, which is C++ throughout.
"""

import copy
import doctest
import json
import os
import pickle
import random
import resource
import signal
import subprocess
import threading
import time
from decimal import Decimal
from fractions import Fraction
from pathlib import Path as File

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import phrame

ROOT = File(__file__).parents[2]
PROGRAM = os.environ.get("PHRAME_PROGRAM", "")
MULTIPLIER = int(os.environ.get("PHRAME_TEST_MULTIPLIER", "1"))

# Farouki's quintic of 2003, in the power basis.
QUINTIC = phrame.Curve([2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2])


def random_curve(rng, degree=2, size=9):
    return phrame.Curve(*([rng.randint(-size, size) for _ in range(degree + 1)] for _ in range(3)),
                        [rng.randint(1, size)] + [rng.randint(-size, size) for _ in range(degree)])


def theta_by_quadrature(curve, t, digits):
    """−2∫h/σ by mpmath, from the components of A alone."""
    with mpmath.workdps(digits + 15):
        u, v, p, q = ([mpmath.mpf(c.numerator) / c.denominator for c in part.coefficients][::-1] or [0]
                      for part in curve.preimage)

        def rate(x):
            (a, da), (b, db), (c, dc), (d, dd) = (mpmath.polyval(f, x, derivative=1) for f in (u, v, p, q))
            return -2 * (a * db - da * b - c * dd + dc * d) / (a * a + b * b + c * c + d * d)

        t = Fraction(t)
        return mpmath.quad(rate, mpmath.linspace(0, mpmath.mpf(t.numerator) / t.denominator, 9))


# ---- numbers


@pytest.mark.parametrize(
    "x, exact",
    [
        (3, Fraction(3)),
        (-(10**400), Fraction(-(10**400))),
        (1 << 63, Fraction(1 << 63)),
        (-(1 << 63), Fraction(-(1 << 63))),
        (Fraction(3, 7), Fraction(3, 7)),
        (Decimal("0.1"), Fraction(1, 10)),
        ("0.1", Fraction(1, 10)),
        ("-3/7", Fraction(-3, 7)),
        (0.1, Fraction(0.1)),
        (np.float64(0.1), Fraction(0.1)),
        (np.float32(0.1), Fraction(float(np.float32(0.1)))),
        (np.int16(-5), Fraction(-5)),
        (mpmath.mpf("0.5"), Fraction(1, 2)),
    ],
)
def test_numbers_are_taken_exactly(x, exact):
    assert phrame.Polynomial([x]).coefficients == (exact,)
    assert phrame.Polynomial([0, 1])(x) == exact


@given(st.fractions(), st.integers(), st.floats(allow_nan=False, allow_infinity=False))
@settings(max_examples=60 * MULTIPLIER, deadline=None)
def test_a_number_goes_in_and_comes_out(fraction, integer, double):
    for x in (fraction, integer, double):
        assert phrame.Polynomial([x, 1]).coefficients[0] == Fraction(x)


def test_other_packages_numbers():
    sympy = pytest.importorskip("sympy")
    assert phrame.Polynomial([sympy.Rational(3, 7), sympy.Integer(-2)]).coefficients == (Fraction(3, 7), -2)
    flint = pytest.importorskip("flint")
    assert phrame.Polynomial([flint.fmpq(3, 7), flint.fmpz(-2)]).coefficients == (Fraction(3, 7), -2)


@given(st.lists(st.fractions(max_denominator=99), max_size=5), st.lists(st.fractions(max_denominator=99), max_size=5),
       st.fractions(max_denominator=99))
@settings(max_examples=50 * MULTIPLIER, deadline=None)
def test_polynomials_are_a_ring(a, b, t):
    p, q = phrame.Polynomial(a), phrame.Polynomial(b)

    def value(c):
        return sum((x * t**k for k, x in enumerate(c)), Fraction(0))

    assert p(t) == value(a)
    assert (p + q)(t) == value(a) + value(b)
    assert (p - q)(t) == value(a) - value(b)
    assert (p * q)(t) == value(a) * value(b)
    assert (-p)(t) == -value(a)
    assert phrame.Polynomial(p.coefficients) == p and hash(phrame.Polynomial(p.coefficients)) == hash(p)


def test_polynomials_for_others():
    sympy = pytest.importorskip("sympy")
    p = phrame.Polynomial([1, Fraction(-1, 2), 3])
    t = sympy.Symbol("t", real=True)
    assert p.sympy() == sympy.Poly(3 * t**2 - t / 2 + 1, t, domain="QQ")
    assert p._repr_latex_() == r"$3t^{2} - \frac{1}{2}t + 1$"
    flint = pytest.importorskip("flint")
    assert p.flint() == flint.fmpq_poly([1, flint.fmpq(-1, 2), 3])


def test_a_real_rounds_correctly():
    theta = QUINTIC.angle().value(1)
    exact = theta_by_quadrature(QUINTIC, 1, 80)
    with mpmath.workdps(95):
        assert str(theta.digits(60)) == mpmath.nstr(exact, 60)
        assert float(theta) == float(exact)
        low, high = (mpmath.mpf(x.numerator) / x.denominator for x in theta.ball(200))
        assert low <= exact <= high and high - low <= mpmath.mpf(2) ** -199
        assert abs(theta.mpmath(200) - exact) <= mpmath.ldexp(1, -201)
    with mpmath.workprec(100):
        assert mpmath.mpf(theta) == +exact  # rounded once more, to the same
    assert Decimal("0.28") < theta.digits(5) < Decimal("0.29")
    assert Fraction(28, 100) < theta < "0.29" and theta > 0 and theta >= 0 and not theta < 0
    assert float(theta + theta - theta * 2) == 0
    assert theta * 0 == 0 and isinstance(theta * 0, Fraction)
    assert theta.digits(30) == (-(-theta)).digits(30) == (1 - (1 - theta)).digits(30)


def test_a_real_for_others():
    theta = QUINTIC.angle().value(1)
    sympy = pytest.importorskip("sympy")
    assert theta.sympy(30) == sympy.Float(str(theta.digits(30)), 30)
    flint = pytest.importorskip("flint")
    ball = theta.flint(100)
    assert ball.contains(flint.arb(flint.fmpq(*theta.ball(300)[0].as_integer_ratio())).mid()) or ball.rad() > 0
    assert abs(float(ball.mid()) - float(theta)) < 1e-15 and float(ball.rad()) < 1e-29


def test_roots():
    root = phrame.root([-2, 0, 1], 1, 2)
    assert str(root.digits(30)) == "1.41421356237309504880168872421"
    assert phrame.root([-4, 0, 1], 1, 3) == 2 and isinstance(phrame.root([-4, 0, 1], 1, 3), Fraction)


# ---- curves


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
    assert isinstance(curve, phrame.Curve) and curve.degree == 5
    assert all(abs(x - 1) < Fraction(1, 10**14) for x in curve.point(1))
    assert all(abs(r(1) - d) < Fraction(1, 10**14) for r, d in zip(curve.hodograph, (0, 1, 1)))
    points = np.array([[0, 0, 0], [1, 0.5, 0], [2, 0, 1], [3, 1, 1]])
    path = phrame.Curve.through(points)
    assert isinstance(path, phrame.Path) and not isinstance(path, phrame.Curve) and path.end == 3
    assert np.abs(path.points([0, 1, 2, 3]) - points).max() < 1e-14
    assert phrame.Path(path.segments) == path
    closed = phrame.Curve.through(points, closed=True)
    assert closed.is_closed and closed.point(0) == closed.point(closed.end) and closed.holonomy is not None
    rounded = [[float(x) + 1e-17 for x in point] for point in QUINTIC.control_points]
    near = phrame.Curve.near(rounded, "1e-12")
    off = max(abs(a - Fraction(b)) for p, q in zip(near.control_points, rounded) for a, b in zip(p, q))
    assert off <= Fraction(1, 10**12)


def test_classification_and_totals():
    helix = phrame.Curve([1], [0, 1], [0], [0, 1])
    assert QUINTIC.classify().is_regular and QUINTIC.classify().helix is None
    plane = phrame.Curve([1, 1], [0], [0], [0, 2]).classify()
    assert plane.normal == (0, 0, 1) and plane.rational_frame is not None and plane.erf_is_rotation_minimizing
    cusp = phrame.Curve([-1, 2], [0], [0], [0])
    assert cusp.classify().cusps == ((Fraction(1, 2), 2),) and not cusp.classify().is_regular
    assert cusp.bending_energy == 0 and cusp.classify().line == (1, 0, 0)
    assert helix.total_curvature is None or float(helix.total_curvature) > 0
    assert float(QUINTIC.erf_twist) == -QUINTIC.angle()(1.0)


# ---- the angle


@pytest.mark.parametrize("seed", range(12 * MULTIPLIER))
def test_angles_agree_with_quadrature(seed):
    rng = random.Random(seed)
    curve = random_curve(rng, rng.randint(1, 3))
    t = Fraction(rng.randint(1, 16), 8)
    theta = curve.angle().value(t, digits=25)
    exact = theta_by_quadrature(curve, t, 60)
    with mpmath.workdps(60):
        assert abs(mpmath.mpf(str(theta)) - exact) <= abs(exact) * mpmath.mpf(10) ** -24


def test_one_angle_is_a_float():
    theta = float(QUINTIC.angle().value("1/2"))
    for t in (0.5, Fraction(1, 2), Decimal("0.5"), np.float64(0.5), "1/2"):
        assert QUINTIC.angle()(t) == theta and isinstance(QUINTIC.angle()(t), float)


def test_angles_start_where_they_are_asked_to():
    angle = QUINTIC.angle(start="pi/4")
    assert abs(float(angle.value(0)) - np.pi / 4) < 1e-15
    assert QUINTIC.angle(start=1).value(0) == 1
    e1, f2, f3 = QUINTIC.frames([0.0], start_normal=[0, 0, 1])[0]
    assert np.abs(np.cross(e1, np.cross([0, 0, 1], e1)) / np.linalg.norm(np.cross(e1, [0, 0, 1])) - f2).max() < 1e-15
    frenet = QUINTIC.angle("frenet")
    assert frenet.rate() != QUINTIC.angle().rate()


def corpus():
    with open(ROOT / "tests/data/curves.jsonl", encoding="utf-8") as file:
        lines = [line for line in file if line.strip()]
    return lines if MULTIPLIER > 1 else lines[::6]


@pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")
def test_the_corpus_gives_what_the_program_gives():
    lines = corpus()
    at = ["1/3", "1"]
    questions = "".join(
        json.dumps({"id": k, "curve": json.loads(line), "at": at, "digits": 40}) + "\n"
        for k, line in enumerate(lines))
    run = subprocess.run([PROGRAM, "batch", "-"], input=questions, capture_output=True, text=True, check=False)
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    assert len(answers) == len(lines)
    values = 0
    for line, answer in zip(lines, answers):
        if "error" in answer:
            with pytest.raises(phrame.Error):
                angle = phrame.Path.from_json(line).angle()
                for t in at:
                    angle.value(t, digits=40)
            continue
        angle = phrame.Path.from_json(line).angle()
        for t, value in zip(at, answer["values"]):
            assert str(angle.value(t, digits=40)) == str(Decimal(value["theta"])), answer["curve"]
            values += 1
        rate = angle.rate()
        assert rate.numerator == phrame.Polynomial(answer["integrand"]["numerator"])
    assert values > len(lines)


@pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")
@pytest.mark.parametrize("by, option", [("parameter", []), ("arc_length", ["--by", "arc-length"])])
def test_frames_are_those_of_the_program_to_the_bit(tmp_path, by, option):
    file = tmp_path / "curve.json"
    file.write_text(QUINTIC.json())
    subprocess.run([PROGRAM, "frames", str(file), "--samples", "33", *option, "--format", "npy", "-o",
                    str(tmp_path / "frames.npy")], check=True)
    table = np.load(tmp_path / "frames.npy")
    if table.dtype.names:
        table = np.array(table.tolist())
    ts = [Fraction(k, 32) * (QUINTIC.length if by == "arc_length" else 1) for k in range(33)]
    assert (QUINTIC.frames(ts, by=by).reshape(33, 9) == table[:, 4:13]).all()
    assert (QUINTIC.points(ts, by=by) == table[:, 1:4]).all()
    assert (QUINTIC.matrices(ts, by=by)[:, :3, 3] == table[:, 1:4]).all()


# ---- arrays


def test_many_frames_are_those_one_by_one():
    """Those of arrays come from approximations with a proof, single ones from the closed form."""
    rng = random.Random(5)
    plane = phrame.Curve([1, 1], [0], [0], [0, 2])
    for curve in (QUINTIC, plane, phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)])):
        ts = np.array([rng.random() * curve.end for _ in range(200)])
        for start in (0, Fraction(1, 7)):
            many = curve.frames(ts, start=start)
            quaternions = curve.quaternions(ts, start=start)
            for k in range(0, 200, 12):
                assert (curve.frames([ts[k]], start=start)[0] == many[k]).all()
                assert (curve.quaternions([ts[k]], start=start)[0] == quaternions[k]).all()
            x, y, z, w = quaternions.T
            matrix = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                               [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                               [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
            assert np.abs(matrix.transpose(2, 1, 0) - many).max() < 4e-16 * 4
            assert (curve.matrices(ts, start=start)[:, :3, :3].transpose(0, 2, 1) == many).all()
        angle = curve.angle(start=Fraction(1, 7))
        assert (angle(ts) == [float(angle.value(t)) for t in ts]).all()


def test_quaternions_are_continuous():
    path = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)])
    q = path.quaternions(np.linspace(0, 2, 2001))
    assert (np.sum(q[1:] * q[:-1], axis=1) > 0.99).all()
    assert np.abs(np.linalg.norm(q, axis=1) - 1).max() < 1e-15


def test_points_round_correctly():
    ts = [Fraction(k, 7) for k in range(8)]
    expected = [[float(x) for x in QUINTIC.point(t)] for t in ts]
    assert (QUINTIC.points(ts) == expected).all()


def test_arrays_of_all_kinds_are_parameters():
    exact = QUINTIC.frames([0, Fraction(1, 2), 1])
    for ts in ((0, 0.5, 1), np.array([0, 0.5, 1]), np.array([0, 0.5, 1], dtype=np.float32),
               np.array([0, 0, 0.5, 0, 1])[::2], ["0", "1/2", "1"],
               np.array([0, Fraction(1, 2), 1], dtype=object)):
        assert (QUINTIC.frames(ts) == exact).all() and QUINTIC.frames(ts).shape == (3, 3, 3)
    assert (QUINTIC.points(np.array([0, 1])) == QUINTIC.points([0, 1])).all()


def test_other_kinds_of_frames():
    erf = QUINTIC.frames([0.25], kind="erf")[0]
    frenet = QUINTIC.frames([0.25], kind="frenet")[0]
    assert (erf[0] == frenet[0]).all() and abs(np.linalg.det(erf) - 1) < 1e-15
    acceleration = np.array([float(r.derivative()(Fraction(1, 4))) for r in QUINTIC.hodograph])
    assert abs(acceleration @ frenet[2]) < 1e-14 and acceleration @ frenet[1] > 0


def test_progress_is_reported_and_can_stop():
    seen = []
    QUINTIC.frames(np.linspace(0, 1, 50_000), progress=lambda done, n: seen.append((done, n)))
    assert seen[-1] == (50_000, 50_000)

    def stop(done, n):
        raise KeyError("enough")

    with pytest.raises(KeyError):
        QUINTIC.frames(np.linspace(0, 1, 50_000), progress=stop)


def test_control_c_ends_at_once():
    rng = random.Random(1)
    curve = random_curve(rng, 30)
    ts = [Fraction(k, 1_000_003) for k in range(20_000)]  # no doubles: each takes its time
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.15, interrupt)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        curve.frames(ts)
    assert time.monotonic() - sent[0] < 2  # 0.06 s where there is a free core
    assert QUINTIC.frames([0.5]).shape == (1, 3, 3)


def test_threads_share_one_angle():
    angle = random_curve(random.Random(3), 6).angle()
    ts = [Fraction(k, 13) for k in range(14)]
    expected = [angle.value(t, digits=30) for t in ts]
    fresh = random_curve(random.Random(3), 6).angle()
    found = {}

    def ask(name):
        found[name] = [fresh.value(t, digits=30) for t in ts]

    threads = [threading.Thread(target=ask, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(values == expected for values in found.values()) and len(found) == 4


# ---- answers


def test_integrals():
    assert phrame.integrate("1/(x^2+1)", 0, "inf").exact == "π/2"
    assert phrame.integrate("1/(x^2+1)", 0, float("inf")).value(30) == Decimal("1.57079632679489661923132169164")
    assert phrame.integrate("x^2", 0, 3).value() == 9
    sympy = pytest.importorskip("sympy")
    found = phrame.integrate("1/(x^3 + x)")
    x = sympy.Symbol("x")
    difference = sympy.diff(found.sympy(), *found.sympy().free_symbols) - 1 / (x**3 + x)
    assert sympy.simplify(difference.subs({s: x for s in difference.free_symbols})) == 0
    with pytest.raises(phrame.DomainError, match="pole"):
        phrame.integrate("1/x", -1, 1)
    assert phrame.integrate("1/x", -1, 1, principal_value=True).value() == 0


def test_minimal_twist():
    twist = QUINTIC.minimal_twist(0, "pi/3")
    assert twist.length == QUINTIC.length and twist.value(0) == 0
    turn = (float(twist.value(1)) - np.pi / 3) / (2 * np.pi)
    assert abs(turn - round(turn)) < 1e-14
    assert float(twist.nominal_twist) == pytest.approx(float(twist.erf_twist) + np.pi / 3, abs=1e-14)


def test_check():
    ts = np.linspace(0, 1, 9)
    frames = QUINTIC.frames(ts)
    good = QUINTIC.check(ts, frames[:, 1], frames[:, 2], start=0)
    assert good and good.passes and good.max_error[1] < Fraction(1, 10**15)
    erf = QUINTIC.frames(ts, kind="erf")
    bad = QUINTIC.check(ts, erf[:, 1], start=0)
    assert not bad and "Euler" in bad.text()
    low, high = bad.max_error
    assert low <= Fraction(float(QUINTIC.angle().value(1))) + Fraction(1, 10**15) and high < 1


def test_certificates():
    certificate = QUINTIC.certify(at=[1], digits=30)
    assert certificate.is_proved() and certificate.objections() == []
    wrong = json.loads(certificate.json())
    value = wrong["claims"][0]["theta"] if "claims" in wrong else wrong["values"][0]["theta"]
    text = certificate.json().replace(value, value[:-3] + ("1" if value[-3] != "1" else "2") + value[-2:])
    assert not phrame.Certificate.from_json(text).is_proved()


# ---- errors


@pytest.mark.parametrize(
    "place, kind, ask",
    [
        ("u[1]", TypeError, lambda: phrame.Curve([1, None], [0], [0], [1])),
        ("u", TypeError, lambda: phrame.Curve(3, [0], [0], [1])),
        ("v[0]", phrame.InputError, lambda: phrame.Curve([1], [float("nan")], [0], [1])),
        ("v[0]", phrame.InputError, lambda: phrame.Curve([1], [Decimal("Infinity")], [0], [1])),
        ("v[0]", phrame.InputError, lambda: phrame.Curve([1], [Decimal("1e999999999")], [0], [1])),
        ("p[0]", phrame.InputError, lambda: phrame.Curve([1], [0], ["1/0"], [1])),
        ("q[0]", TypeError, lambda: phrame.Curve([1], [0], [0], [True])),
        ("q[0]", TypeError, lambda: phrame.Curve([1], [0], [0], [1j])),
        ("basis", phrame.InputError, lambda: phrame.Curve([1], [0], [0], [1], basis="bézier")),
        ("start", phrame.InputError, lambda: phrame.Curve([1], [0], [0], [1], start=[1, 2])),
        ("quaternions[1]", phrame.InputError, lambda: phrame.Curve.from_quaternions([[1, 0, 0, 0], [1]])),
        ("points", phrame.InputError, lambda: phrame.Curve.from_control_points([[0, 0, 0]])),
        ("points[1][2]", phrame.InputError, lambda: phrame.Curve.through([[0, 0, 0], [1, 1, "x"]])),
        ("tangents", phrame.InputError, lambda: phrame.Curve.through([[0, 0, 0], [1, 1, 1]], tangents=[[1, 0, 0]])),
        ("kind", phrame.InputError, lambda: phrame.Curve.through([[0, 0, 0], [1, 1, 1]], kind="septic")),
        ("eps", phrame.InputError, lambda: phrame.Curve.near([[0, 0, 0], [1, 1, 1]], 0)),
        ("digits", phrame.InputError, lambda: QUINTIC.angle().value(1, digits=-3)),
        ("digits", TypeError, lambda: QUINTIC.angle().value(1, digits=2.5)),
        ("n", phrame.InputError, lambda: QUINTIC.angle().value(1).digits(0)),
        ("bits", phrame.InputError, lambda: QUINTIC.angle().value(1).ball(10**100)),
        ("t", phrame.InputError, lambda: QUINTIC.angle().value("one")),
        ("frame", phrame.InputError, lambda: QUINTIC.angle("bishop")),
        ("start", phrame.InputError, lambda: QUINTIC.angle(start="pi/4/2")),
        ("start_normal", phrame.InputError, lambda: QUINTIC.frames([0], start_normal=[0, 0, 0])),
        ("ts", phrame.InputError, lambda: QUINTIC.frames([])),
        ("ts", phrame.InputError, lambda: QUINTIC.frames(np.array([]))),
        ("ts", phrame.InputError, lambda: QUINTIC.frames(np.zeros((2, 2)))),
        ("ts[1]", phrame.InputError, lambda: QUINTIC.frames(np.array([0, np.nan]))),
        ("ts", TypeError, lambda: QUINTIC.frames(0.5)),
        ("ts", TypeError, lambda: QUINTIC.points("0,1")),
        ("ts[1]", phrame.InputError, lambda: phrame.Path([QUINTIC.segment(0, 1), QUINTIC.segment(1, 2)]).points([0, 3])),
        ("by", phrame.InputError, lambda: QUINTIC.frames([0], by="time")),
        ("f2", phrame.InputError, lambda: QUINTIC.check([0, 1], [[1, 0, 0]])),
        ("curves[0]", TypeError, lambda: phrame.Path([1])),
        ("curves", phrame.InputError, lambda: phrame.Path([])),
        ("lower", phrame.InputError, lambda: phrame.integrate("x", "one", 2)),
        ("f", phrame.InputError, lambda: phrame.integrate("x +")),
    ],
)
def test_an_exception_names_the_argument(place, kind, ask):
    with pytest.raises(kind) as raised:
        ask()
    message = str(raised.value)
    assert message.startswith(place + ":") and "\n" not in message
    if kind is phrame.InputError:
        assert raised.value.place == place and raised.value.reason in message
        assert isinstance(raised.value, (ValueError, phrame.Error))


def test_kinds_of_errors():
    line = phrame.Curve([1], [0], [0], [0])
    with pytest.raises(phrame.DomainError) as raised:
        line.angle("frenet")
    assert isinstance(raised.value, ArithmeticError) and isinstance(raised.value, phrame.Error)
    assert str(pickle.loads(pickle.dumps(raised.value))) == str(raised.value)
    with pytest.raises(phrame.DomainError):
        phrame.Curve([0], [0], [0], [0])
    with pytest.raises(phrame.InputError) as raised:
        phrame.Path.from_json('{"phrame": "curve/1", "basis": "power", "preimage": {"u": ["x"]}}')
    assert raised.value.place.startswith("/preimage")
    assert issubclass(phrame.Undecided, (ArithmeticError, phrame.Error))


# ---- values


def values():
    path = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)], "two")
    return [QUINTIC, path, QUINTIC.sigma, QUINTIC.torsion, QUINTIC.certify(at=["1/2"], digits=20)]


def test_values_are_pickled_and_copied():
    for x in values():
        again = pickle.loads(pickle.dumps(x))
        assert again == x and hash(again) == hash(x) and type(again) is type(x)
        assert copy.copy(x) is x and copy.deepcopy(x) is x
    theta = QUINTIC.angle("frenet", start="pi/4").value("1/3")
    for x in (theta, QUINTIC.erf_twist, 2 * theta, -theta, theta - 1, phrame.root([-2, 0, 1], 1, 2),
              QUINTIC.minimal_twist(0, 1).twist, QUINTIC.minimal_twist(0, 1).value("1/2"),
              phrame.integrate("1/(x^2+1)", 0, 1).value()):
        assert pickle.loads(pickle.dumps(x)).digits(40) == x.digits(40)
        assert copy.deepcopy(x) is x
    ts = [0, "1/2", 1]
    check = QUINTIC.check(ts, QUINTIC.frames(ts)[:, 1])
    for x in (QUINTIC.angle(), QUINTIC.classify(), check, phrame.integrate("1/(x^5+1)", variable="x")):
        assert pickle.loads(pickle.dumps(x)).json() == x.json()
    with pytest.raises(AttributeError):
        QUINTIC.name = "other"


def test_objects_outlive_what_they_came_from():
    theta = phrame.Curve([2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2]).angle().value(1)
    frames = phrame.Curve([1, 1], [0], [0], [0, 2]).frames(np.linspace(0, 1, 1000))
    rubbish = [random_curve(random.Random(k)) for k in range(100)]
    assert theta.digits(20) == QUINTIC.angle().value(1, digits=20) and len(rubbish) == 100
    assert (frames[:, 2] == [0, 0, 1]).all()


def resident():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="no /proc")
def test_no_memory_is_lost():
    def use(n):
        for k in range(n):
            curve = phrame.Curve([2, -4, 4], [1, k, -1], [0, -4, 4], [10**40 + k, 2, -2])
            curve.sigma, curve.control_points[1], pickle.dumps(curve.h)
        for _ in range(n // 100):
            curve.angle().value(1, digits=20), QUINTIC.frames([0.25, "1/3"])
            with pytest.raises(phrame.InputError):
                phrame.Curve([1], [0], ["x"], [0])

    n = 2000 * MULTIPLIER
    use(n)
    before = resident()
    use(2 * n)
    assert resident() - before < 4 << 20


def test_examples_in_documents_and_docstrings():
    assert doctest.testmod(phrame).failed == 0
    found = doctest.testfile(str(ROOT / "docs/python.md"), module_relative=False, encoding="utf-8")
    assert found.failed == 0 and found.attempted > 20


def test_the_first_page_does_what_it_shows(capsys):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    block = text.split("```python\n")[1].split("```")[0]
    names = {}
    exec(block, names)
    assert names["frames"].shape == (1000, 3, 3)
    assert capsys.readouterr().out.endswith("0.28585653009834106200165626280309220136381867044677\n")


def test_reprs():
    assert repr(QUINTIC).startswith("<Curve") and "4*t^2" in repr(QUINTIC)
    assert repr(QUINTIC.angle().value(1)) == "Real('0.28585653009834106…')"
    assert r"\theta" in QUINTIC.angle()._repr_latex_() and "θ′" in str(QUINTIC.angle())
    assert "Classification" in repr(QUINTIC.classify()) and "2π" not in repr(QUINTIC.minimal_twist(0, 1))
    assert phrame.integrate("1/(x^2+1)")._repr_latex_() == r"$\displaystyle \arctan x$" or \
        "arctan" in phrame.integrate("1/(x^2+1)")._repr_latex_()
