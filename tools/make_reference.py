#!/usr/bin/env python3
"""Makes reference/*.jsonl: curves of all kinds with values to 50 digits (docs/reference.md), found by phrame and by
tools/foreign_frames.py, which share nothing; a value on which they do not agree stops it. Needs python-flint.

    PHRAME_PROGRAM=build/dev/bin/phrame tools/make_reference.py [--check [--every N]]

With --check the files stay, and their values are computed anew by the foreign way alone, of every Nth curve.
"""
import argparse
import decimal
import json
import math
import os
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

try:
    import foreign_frames as foreign
except ImportError:
    print("python-flint is not installed")
    sys.exit(77)

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "reference"
DIGITS = 50
AGREEMENT = Fraction(1, 10 ** 49)  # of the two ways, relative to 1 or to the value if that is greater
CHANCE = random.Random(2026)


def some(n, most=9, below=1):
    return [str(Fraction(CHANCE.randint(-most, most), below)) for _ in range(n)]


def ph(m, most=9, below=1, **more):
    """e1(0) is not -x, where the rule of the first frame jumps."""
    while True:
        preimage = {key: some(m + 1, most, below) for key in "uvpq"}
        if preimage["u"][0] != "0" or preimage["v"][0] != "0":
            return {"phrame": "curve/1", "basis": "power", "preimage": preimage, **more}


def quaternion(**parts):
    return {"phrame": "curve/1", "basis": "power", "preimage": {key: [str(Fraction(x)) for x in parts[key]] for key in "uvpq"}}


def points(n, below=7):
    return [some(3, 30, below) for _ in range(n)]


def near_cusp(epsilon, c):
    """A = (t - c) B + epsilon C."""
    B, C = {"u": (2, -1), "v": (1, 4), "p": (-3, 1), "q": (5, -2)}, {"u": 3, "v": -2, "p": 1, "q": 4}
    return quaternion(**{key: (-c * b[0] + epsilon * C[key], b[0] - c * b[1], b[1]) for key, b in B.items()})


def formula(x, y, z, end):
    return {"phrame": "curve/1", "expressions": {"x": x, "y": y, "z": z}, "variable": "s", "from": "0", "to": end}


def spline(corners):
    """Cubic segments; without corners the tangent goes on."""
    last, tangent, segments = [Fraction(0)] * 3, [Fraction(x) for x in (1, 1, 1)], []
    for _ in range(3):
        p = [[Fraction(x) for x in q] for q in points(3)]
        if not corners:
            p[0] = [a + b for a, b in zip(last, tangent)]
        segments.append({"control_points": [[str(x) for x in q] for q in [last, *p]]})
        last, tangent = p[2], [a - b for a, b in zip(p[2], p[1])]
    return {"phrame": "spline/1", "segments": segments}


def polyline(n):
    corner = [[Fraction(x) for x in q] for q in points(n)]
    return {"phrame": "spline/1", "segments": [{"control_points": [[str(x) for x in p] for p in pair]}
                                               for pair in zip(corner, corner[1:] + corner[:1])]}


def groups():
    """{group: curves}"""
    yield "tame", [ph(m, below=b) for m in (1, 2, 3, 4) for b in (1, 3, 7)]
    yield "high-degree", [ph(m, below=5) for m in (6, 8)]
    yield "near-cusp", [near_cusp(Fraction(1, 10 ** k), c) for k in (1, 2) for c in (Fraction(1, 3), Fraction(1))]
    yield "turning-multiplier", [ph(2, below=3, multiplier=["1", "-1/2"]), ph(1, below=3, multiplier=["-2", "1/3"]),
                                 ph(2, multiplier=["3", "1", "1/7"])]
    yield "long-numbers", [ph(2, 10 ** 15, 10 ** 14), ph(3, 10 ** 15, 10 ** 15), ph(2, 10 ** 60, 10 ** 59)]
    yield "inflections", [quaternion(u=[1], v=[0], p=[0, Fraction(1, 3)], q=[0, 0, 1, -1]),
                          quaternion(u=[1, 2], v=[0, 1], p=[0, 0, 1], q=[0, 0, Fraction(-1, 7)]),
                          {"phrame": "curve/1", "control_points": [["0", "0", "0"], ["1", "2", "0"], ["2", "-2", "1/3"], ["3", "1/7", "1"]]}]
    yield "plane", [quaternion(u=[1], v=[0], p=[0], q=[1, 3, Fraction(1, 3)]),
                    {"phrame": "curve/1", "control_points": [["0", "0", "0"], ["1/3", "2", "0"], ["2", "2", "0"], ["3", "1/7", "0"]]},
                    quaternion(u=[1, 2], v=[0], p=[0], q=[0])]
    yield "rational-frames", [quaternion(u=[1, 0, -6], v=[0, 4, 3], p=[0, -2, -12], q=[0, 6, -4]),
                              quaternion(u=[1], v=[0, 1], p=[0, 1], q=[0, 0, 1])]
    yield "bezier", [{"phrame": "curve/1", "control_points": points(n)} for n in (4, 4, 4, 5, 6, 8)]
    yield "rational", [{"phrame": "curve/1", "control_points": points(n), "weights": [str(Fraction(CHANCE.randint(3, 12), 7)) for _ in range(n)]}
                       for n in (3, 4, 4, 5)]
    yield "formulas", [formula("3*cos(s)", "3*sin(s)", "4*s/7", "5"), formula("s", "sin(s)", "cos(2*s)/3", "3"),
                       formula("exp(s)", "s^2", "s/3", "1"), formula("s", "s^2/2", "sqrt(1+s^2)", "2")]
    yield "closed", [formula("sin(s)+2*sin(2*s)", "cos(s)-2*cos(2*s)", "-sin(3*s)", "2*pi"),
                     formula("(3+cos(3*s))*cos(2*s)", "(3+cos(3*s))*sin(2*s)", "sin(3*s)/3", "2*pi"),
                     formula("2*cos(s)", "sin(s)", "cos(2*s)/7", "2*pi"), formula("cos(s)", "2*sin(s)", "sin(2*s)/3", "2*pi")]
    yield "splines", [spline(corners=False) for _ in range(4)]
    yield "corners", [spline(corners=True) for _ in range(2)] + [polyline(n) for n in (3, 5)]


# What came after the first edition has a CHANCE of its own in each group, so that no curve changes when one is added.

def turned(curve, a, b, c, d):
    """U A for the quaternion U = a + bi + cj + dk: the curve turned and scaled."""
    u, v, p, q = (curve["preimage"][key] for key in "uvpq")

    def combined(*factors):
        n = max(len(x) for x in (u, v, p, q))
        rows = [[Fraction(x) for x in list(part) + [0] * (n - len(part))] for part in (u, v, p, q)]
        return [sum((f * row[k] for f, row in zip(factors, rows)), Fraction(0)) for k in range(n)]
    return quaternion(u=combined(a, -b, -c, -d), v=combined(b, a, -d, c), p=combined(c, d, a, -b), q=combined(d, -c, b, a))


def ph_spline(n, below):
    """Quintics whose preimages go on, so that the tangent does."""
    last, start, segments = None, ["0", "0", "0"], []
    for _ in range(n):
        curve = {**ph(2, 5, below), "start": start}
        if last is not None:
            for key, x in zip("uvpq", last):
                curve["preimage"][key][0] = str(x)
        last = [sum(map(Fraction, curve["preimage"][key])) for key in "uvpq"]
        start = [str(sum(c)) for c in foreign.Segment(curve).lists]
        segments.append({key: x for key, x in curve.items() if key != "phrame"})
    return {"phrame": "spline/1", "segments": segments}


BENDS = [(Fraction(4, 5), Fraction(3, 5)), (Fraction(12, 13), Fraction(5, 13)), (Fraction(15, 17), Fraction(8, 17)), (Fraction(3, 5), Fraction(4, 5))]


def pipe(bends):
    """Straight lines with arcs between them; half of an arc's angle, and the turn of its plane, have a rational cosine and sine."""
    at, frame, segments = [Fraction(0)] * 3, [[Fraction(i == k) for k in range(3)] for i in range(3)], []

    def go(way, direction):
        return [a + way * d for a, d in zip(at, direction)]
    for k in range(bends + 1):
        ahead, left, up = frame
        end = go(Fraction(CHANCE.randint(1, 9), 2), ahead)
        segments.append({"control_points": [[str(x) for x in p] for p in (at, end)]})
        if k == bends:
            return {"phrame": "spline/1", "segments": segments}
        at = end
        c, s = CHANCE.choice(BENDS)
        left, up = ([c * a + s * b for a, b in zip(left, up)], [c * b - s * a for a, b in zip(left, up)])
        c, s = CHANCE.choice(BENDS)
        cos, sin, way = c * c - s * s, 2 * c * s, Fraction(CHANCE.randint(1, 4), 2)
        turned_ahead = [cos * a + sin * b for a, b in zip(ahead, left)]
        corner = go(way, ahead)
        start, at = at, corner
        end = go(way, turned_ahead)
        segments.append({"control_points": [[str(x) for x in p] for p in (start, corner, end)], "weights": ["1", str(c), "1"]})
        at, frame = end, [turned_ahead, [cos * b - sin * a for a, b in zip(ahead, left)], up]


def power_basis_curve(degree, is_rational):
    position = {key: some(degree + 1, 9, 7) for key in "xyz"}
    if is_rational:
        position["w"] = ["3", *some(degree, 1, 4)]
    return {"phrame": "curve/1", "basis": "power", "position": position}


def torus_knot(p, q, height):
    return formula("(3+cos(%d*s))*cos(%d*s)" % (q, p), "(3+cos(%d*s))*sin(%d*s)" % (q, p), "sin(%d*s)*%s" % (q, height), "2*pi")


def with_twist(curve):
    """From a vector to another: the frame of minimal twist."""
    curve["expected"] = {"minimal_twist": {key: some(3, 9) for key in ("from_vector", "to_vector")}}
    return curve


def offset_curve(m, distance, below=2):
    u = some(m + 1, 9, below)
    u[0] = str(abs(Fraction(u[0])) + 1)
    return {**quaternion(u=u, v=[0], p=[0], q=some(m + 1, 9, below)), "expected": {"offset": {"distance": distance}}}


def near_tie(curve, what, digits, t):
    """At a t of 40 digits near the one given a value is 10^-35 or so from a tie of decimals with 17 digits, or of doubles.

    what is "theta_erf" or the number of a component of a frame; f2x is 6."""
    path = foreign.Path(curve)

    def value(x):
        if what == "theta_erf":
            return foreign.angle_to_erf(path.segments[0], x)
        (row,), _, _ = path.frames([x])
        return [c for vector in row[:4] for c in vector][what]
    goal, a = None, Fraction(t)
    b = a + Fraction(1, 10 ** 6)
    for _ in range(9):  # the secant method
        x, y = fraction(value(a)), fraction(value(b))
        if goal is None:
            ulp = ulp_of(x, digits)
            goal = (x // ulp + Fraction(1, 2)) * ulp
        if abs(y - goal) < Fraction(1, 10 ** 39) or x == y:
            break
        a, b = b, Fraction(round((b - (y - goal) * (b - a) / (y - x)) * 10 ** 40), 10 ** 40)
    name = what if isinstance(what, str) else COMPONENTS[what]
    curve["expected"] = {"at": ["0", str(b)], "near_tie": {"value": name, "of": "decimals" if digits == 10 else "doubles"}}
    return curve


def fraction(x):
    """Of the middle of an arb."""
    mantissa, exponent = foreign.middle(x).man_exp()
    return int(mantissa) * Fraction(2) ** int(exponent)


def ulp_of(x, base):
    """A unit in the last place of a double, or of 17 decimals."""
    digits, k = (53, 0) if base == 2 else (17, 0)
    while abs(x) >= Fraction(base) ** k:
        k += 1
    while abs(x) < Fraction(base) ** (k - 1):
        k -= 1
    return Fraction(base) ** (k - digits)


COMPONENTS = [v + axis for v in ("r", "e1", "f2", "f3") for axis in "xyz"]


def more_groups(only=None):
    def begin(group):
        CHANCE.seed("2 " + group)
        return group
    yield begin("tame"), [ph(m, below=b) for m in (1, 2, 3, 4) for b in (2, 5, 9, 11)]
    yield begin("high-degree"), [ph(m, below=b) for m, b in ((5, 3), (7, 2), (9, 4), (10, 3), (12, 7))]
    yield begin("near-cusp"), [near_cusp(Fraction(1, 10 ** k), c) for k in (1, 2, 3) for c in (Fraction(0), Fraction(1, 2), Fraction(5, 7))]
    yield begin("turning-multiplier"), [ph(m, below=3, multiplier=f) for m, f in
                                        ((1, ["1", "1/3"]), (2, ["2", "-1"]), (1, ["1", "0", "1"]), (3, ["-1", "1/2", "-1"]), (2, ["1/3", "1/2", "1/7"]))]
    yield begin("long-numbers"), [ph(m, 10 ** k, 10 ** (k - 1)) for m, k in ((1, 20), (2, 30), (3, 40), (2, 100))]
    yield begin("inflections"), [quaternion(u=[1], v=[0], p=[0, Fraction(1, k)], q=[0, 0, 1, -1]) for k in (2, 5, 11)] + [
        {"phrame": "curve/1", "control_points": [["0", "0", "0"], ["1", y, "0"], ["2", "-2", z], ["3", "1/7", "1"]]}
        for y, z in (("1", "1/5"), ("2", "1/20"), ("3", "1/100"))]
    yield begin("plane"), [quaternion(u=some(3), v=[0], p=[0], q=some(3)) for _ in range(3)] + [
        {"phrame": "curve/1", "control_points": [[x, y, "0"] for x, y, _ in points(n)]} for n in (4, 5)]
    rational_frame = quaternion(u=[1, 0, -6], v=[0, 4, 3], p=[0, -2, -12], q=[0, 6, -4])
    yield begin("rational-frames"), [turned(rational_frame, *u) for u in ((1, 2, 0, 1), (2, -1, 1, 3), (1, 1, 1, 1), (3, 0, -2, 1))]
    yield begin("bezier"), [{"phrame": "curve/1", "control_points": points(n, b)} for n in (4, 5, 6) for b in (3, 5, 11)]
    yield begin("rational"), [{"phrame": "curve/1", "control_points": points(n), "weights": [str(Fraction(CHANCE.randint(3, 12), 7)) for _ in range(n)]}
                              for n in (3, 3, 4, 4, 5, 5, 6)]
    yield begin("formulas"), [formula("%d*cos(s)" % a, "%d*sin(s)" % b, "%d*s/7" % c, end)
                              for a, b, c, end in ((2, 2, 1, "6"), (1, 3, 2, "5"), (5, 1, 3, "4"), (1, 1, 7, "9"))] + [
        formula("s", "sin(%d*s)/3" % k, "cos(s)/%d" % (k + 1), "3") for k in (2, 3, 5)] + [
        formula("exp(s/%d)*cos(s)" % k, "exp(s/%d)*sin(s)" % k, "exp(s/%d)/2" % k, "4") for k in (3, 5)] + [
        formula("s", "s^%d/3" % k, "sqrt(%d+s^2)" % k, "2") for k in (2, 3, 4)]
    yield begin("closed"), [torus_knot(p, q, h) for p, q, h in ((1, 2, "1/2"), (1, 3, "1"), (2, 5, "1"), (3, 2, "1/3"), (3, 4, "1/2"))] + [
        formula("%d*cos(s)" % a, "%d*sin(s)" % b, "cos(%d*s)/%d" % (k, c), "2*pi") for a, b, c, k in ((2, 3, 4, 2), (1, 1, 3, 3), (3, 2, 5, 4), (1, 2, 2, 3))]
    yield begin("splines"), [spline(corners=False) for _ in range(8)]
    yield begin("corners"), [spline(corners=True) for _ in range(5)] + [polyline(n) for n in (3, 4, 6, 7)]
    yield begin("ph-splines"), [ph_spline(n, b) for n, b in ((2, 1), (3, 1), (2, 3), (3, 2), (4, 3), (5, 2))]
    yield begin("pipes"), [pipe(n) for n in (1, 1, 2, 2, 3, 3, 4, 5, 6, 8)]
    yield begin("power-basis"), [power_basis_curve(n, is_rational) for is_rational in (False, True) for n in (2, 3, 3, 4, 5, 6, 8)]
    yield begin("minimal-twist"), [with_twist(ph(m, below=b)) for m in (1, 2, 3) for b in (1, 4, 7)] + [
        with_twist({"phrame": "curve/1", "control_points": points(n)}) for n in (4, 4, 5, 6)] + [
        with_twist(formula("2*cos(s)", "2*sin(s)", "%d*s/5" % k, "4")) for k in (1, 3)]
    yield begin("plane-offsets"), [offset_curve(m, d) for m in (1, 2, 3) for d in ("1/7", "-1/3", "2", "-2", "7")]
    if only in (None, "hard-rounding"):  # which takes a while
        yield begin("hard-rounding"), [near_tie(ph(m, below=b), what, digits, t) for m, b, t in ((1, 2, "1/3"), (2, 3, "2/3"), (3, 5, "3/5"))
                                       for what in ("theta_erf", 6, 10) for digits in (2, 10)] + [
            near_tie({"phrame": "curve/1", "control_points": points(4)}, what, digits, "2/5") for what in (8, 9) for digits in (2, 10)]


# The third edition, with a CHANCE of its own in each group again.

def quaternion_product(a, b):
    return [a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]]


def primitive(u):
    """A multiple of a quaternion with integers without a common factor."""
    u = [Fraction(x) for x in u]
    u = [int(x * math.lcm(*(y.denominator for y in u))) for x in u]
    return [x // math.gcd(*u) for x in u]


def turn(u, v):
    """U v U*/|U|^2"""
    u = [Fraction(x) for x in u]
    w = quaternion_product(quaternion_product(u, [Fraction(0), *v]), [u[0], -u[1], -u[2], -u[3]])
    return [x / sum(c * c for c in u) for x in w[1:]]


def texts(rows):
    return [[str(x) for x in row] for row in rows]


def some_rotation():
    return primitive([CHANCE.randint(1, 4), *(CHANCE.randint(-3, 3) for _ in range(3))])


def over(lists, w):
    return {"phrame": "curve/1", "basis": "power", "position": {**{key: [str(c) for c in x] for key, x in zip("xyz", lists)}, "w": [str(c) for c in w]}}


def with_denominator(m, c):
    """A PH curve with the multiplier 1/(1 + ct)^(2m + 2): of that order at its only pole, r has no logarithm."""
    w = [Fraction(1)]
    for _ in range(2 * m + 2):
        w = foreign.product(w, [Fraction(1), c])
    return ph(m, 5, 2, multiplier={"numerator": ["1"], "denominator": [str(x) for x in w]})


def arc():
    """Of a circle in space: a rational quadratic with equal legs."""
    c, s = CHANCE.choice(BENDS)
    u, way, at = some_rotation(), Fraction(CHANCE.randint(1, 9), 2), [Fraction(x) for x in some(3, 9, 2)]
    legs = [[Fraction(0)] * 3, [way, Fraction(0), Fraction(0)], [way + way * (c * c - s * s), way * 2 * c * s, Fraction(0)]]
    return {"phrame": "curve/1", "control_points": texts([a + b for a, b in zip(at, turn(u, leg))] for leg in legs), "weights": ["1", str(c), "1"]}


def rational_offset(m, distance):
    """The offset of a plane PH curve, turned into space: (r sigma + d (y', -x'))/sigma."""
    flat = foreign.Segment(quaternion(u=["2", *some(m, 5)], v=[0], p=[0], q=some(m + 1, 5)))
    x, y, _ = flat.lists
    sigma = foreign.padded_sum(*((1, foreign.product(c, c)) for c in flat.A))
    dx, dy = ([k * c for k, c in enumerate(row)][1:] for row in (x, y))
    columns = [foreign.padded_sum((1, foreign.product(row, sigma)), (sign * distance, other)) for row, sign, other in ((x, 1, dy), (y, -1, dx))]
    u = some_rotation()
    axes = [turn(u, [Fraction(i == k) for i in range(3)]) for k in range(2)]
    return over([foreign.padded_sum((axes[0][k], columns[0]), (axes[1][k], columns[1])) for k in range(3)], sigma)


def inverted(m):
    """A PH curve in the unit sphere as a mirror, r/|r|^2: it stays one, and its rotation-minimizing frames are mirrored."""
    while True:
        curve = ph(m, 4)
        start = [Fraction(CHANCE.randint(20, 40)), Fraction(CHANCE.randint(-9, 9)), Fraction(CHANCE.randint(-9, 9))]
        lists = foreign.Segment({**curve, "start": [str(x) for x in start]}).lists
        square = foreign.padded_sum(*((1, foreign.product(c, c)) for c in lists))
        if all(sum(c * Fraction(k, 50) ** i for i, c in enumerate(square)) > 1 for k in range(51)):
            return over(lists, square)


def long_spline(n):
    """Lines, arcs, PH quintics and cubics in turns, with continuous tangents."""
    at, u, segments = [Fraction(0)] * 3, [1, 0, 0, 0], []
    axis = [[Fraction(i == k) for i in range(3)] for k in range(3)]

    def go(way, direction):
        return [a + way * d for a, d in zip(at, direction)]
    for _ in range(n):
        kind, ahead = CHANCE.choice(("line", "arc", "arc", "cubic", "ph")), turn(u, axis[0])
        if kind == "line":
            end = go(Fraction(CHANCE.randint(1, 6), 2), ahead)
            segments.append({"control_points": texts([at, end])})
        elif kind == "arc":
            c, s = CHANCE.choice(BENDS)
            u = primitive(quaternion_product(u, [CHANCE.randint(1, 3), CHANCE.randint(-2, 2), 0, 0]))
            way = Fraction(CHANCE.randint(1, 4), 2)
            corner = go(way, ahead)
            u = primitive(quaternion_product(u, [c, 0, 0, s]))
            end = [a + way * d for a, d in zip(corner, turn(u, axis[0]))]
            segments.append({"control_points": texts([at, corner, end]), "weights": ["1", str(c), "1"]})
        elif kind == "cubic":
            u = primitive(quaternion_product(u, [3, *(CHANCE.randint(-1, 1) for _ in range(3))]))
            end = [a + Fraction(CHANCE.randint(2, 4)) * d + Fraction(CHANCE.randint(-1, 1)) for a, d in zip(at, ahead)]
            segments.append({"control_points": texts([at, go(1, ahead), [a - d for a, d in zip(end, turn(u, axis[0]))], end])})
        else:
            steps = [u, *([Fraction(CHANCE.randint(-3, 3), 6) for _ in range(4)] for _ in range(2))]
            size = max(map(abs, u))
            steps = [[Fraction(x, size) for x in u], *steps[1:]]
            curve = {"basis": "power", "preimage": {key: [str(step[k]) for step in steps] for k, key in enumerate("uvpq")}, "start": [str(x) for x in at]}
            segments.append(curve)
            end = [sum(c) for c in foreign.Segment(curve).lists]
            u = primitive([sum(column) for column in zip(*steps)])
        at = end
    return {"phrame": "spline/1", "segments": segments}


def asking(what, curve):
    return {**curve, "expected": {what: True}}


def inflected(a, y, z):
    """x = t, y = (t - a)^m, z = c (t - a)^n, turned: an inflection at a, where the normal goes on, with the curvature's sign changed or not."""
    def power(m, c=1):
        row = [Fraction(c)]
        for _ in range(m):
            row = foreign.product(row, [-a, Fraction(1)])
        return row
    rows, u = [[Fraction(0), Fraction(1)], power(y), power(*z)], some_rotation()
    axes = [turn(u, [Fraction(i == k) for i in range(3)]) for k in range(3)]
    return {"phrame": "curve/1", "basis": "power", "position": {
        key: [str(x) for x in foreign.padded_sum(*((axes[j][k], rows[j]) for j in range(3)))] for k, key in enumerate("xyz")}}


def newest_groups():
    def begin(group):
        CHANCE.seed("3 " + group)
        return group
    yield begin("rational-ph"), [with_denominator(m, c) for m, c in ((1, Fraction(1)), (2, Fraction(1, 2)), (2, Fraction(-1, 3)), (3, Fraction(1, 4)))] + [
        arc() for _ in range(3)] + [rational_offset(m, d) for m, d in ((1, Fraction(1, 3)), (1, Fraction(-2)), (2, Fraction(1, 2)))] + [
        inverted(m) for m in (1, 1, 2)]
    yield begin("long-splines"), [long_spline(n) for n in (8, 12, 16, 20, 24, 32)]
    yield begin("knots"), [asking("writhe", curve) for curve in (
        torus_knot(2, 3, "1"), torus_knot(2, 7, "1"), torus_knot(3, 5, "1/2"), torus_knot(1, 5, "1"),
        formula("(2+cos(2*s))*cos(3*s)", "(2+cos(2*s))*sin(3*s)", "sin(4*s)", "2*pi"),
        formula("cos(3*s+7/10)", "cos(2*s+1/5)", "cos(7*s)", "2*pi"), formula("cos(2*s+3/2)", "cos(3*s+1/5)", "cos(5*s)", "2*pi"),
        formula("4*cos(s)+cos(5*s)", "4*sin(s)+sin(5*s)", "sin(6*s)/2", "2*pi"), formula("cos(s)+2*cos(2*s)", "sin(s)-2*sin(2*s)", "2*sin(3*s)/3", "2*pi"))]
    yield begin("signed-frenet"), [asking("signed_frenet", curve) for curve in (
        inflected(Fraction(2, 5), 3, (4, 1)), inflected(Fraction(3, 7), 3, (5, 2)), inflected(Fraction(1, 7), 3, (4, Fraction(1, 3))),
        inflected(Fraction(5, 7), 5, (6, 3)), inflected(Fraction(2, 7), 4, (5, 1)),
        quaternion(u=[1, 1], v=[0], p=[0], q=[2, -4, 3]), formula("s", "sin(s)", "s/2+cos(s)", "3"), formula("s", "cos(s)", "2*s", "5"))]
    yield begin("minimal-twist"), [with_twist(curve) for curve in (
        {"phrame": "curve/1", "control_points": points(4), "weights": ["1", "3/7", "9/7", "1"]}, spline(corners=False), pipe(3), long_spline(5),
        formula("cos(s)", "sin(s)", "s/9", "9"), formula("exp(s/5)*cos(s)", "exp(s/5)*sin(s)", "s", "6"))]
    yield begin("formulas"), [formula(*four) for four in (
        ("s", "cosh(s)", "s^2/5", "2"), ("s", "log(1+s)", "s^2", "3"), ("sinh(s)", "cosh(s)", "s", "1"), ("tan(s)", "s", "cos(s)", "1"),
        ("s-tanh(s)", "1/cosh(s)", "s/3", "4"), ("atan(s)", "log(1+s^2)/2", "s/4", "3"), ("s*cos(s)", "s*sin(s)", "s", "9"),
        ("(1+s)*cos(log(1+s))", "(1+s)*sin(log(1+s))", "s/2", "8"))]


def rounded(value):
    """With the nearest double in place of each number, exactly."""
    if isinstance(value, dict):
        return {key: x if key in ("phrame", "basis", "expressions", "variable", "from", "to", "expected") else rounded(x)
                for key, x in value.items()}
    return [rounded(x) for x in value] if isinstance(value, list) else str(Fraction(float(Fraction(value))))


# Of which the doubles join, close or are PH no longer.
NO_DOUBLES = ("splines", "corners", "hard-rounding", "ph-splines", "pipes", "rational-ph", "long-splines", "signed-frenet")


def named(only=None):
    """(group, curve); where something is to be asked beside the usual, that is in its "expected"."""
    last = {}
    for group, curves in [*groups(), *more_groups(only), *newest_groups()]:
        for curve in curves:
            last[group] = last.get(group, 0) + 1
            name, note = "%s-%02d" % (group, last[group]), {"family": group}
            yield group, {"phrame": curve["phrame"], "name": name, **note, **curve}
            near = rounded(curve)
            if near != curve and group not in NO_DOUBLES and "segments" not in curve:
                yield group, {"phrame": curve["phrame"], "name": name + "-doubles", **note, "note": "the numbers of %s as doubles" % name, **near}


def parameters(curve):
    if "at" in curve.get("expected", {}):
        return [Fraction(t) for t in curve["expected"]["at"]]
    n = len(curve.get("segments", [1]))
    return [Fraction(0), Fraction(n, 3), Fraction(n, 2), Fraction(n)]


def questions(curve):
    """What phrame is asked."""
    at = [str(t) for t in parameters(curve)]
    yield "frames", {"question": "frames", "at": at}
    yield "totals", {"question": "totals"}
    if "preimage" in curve:
        yield "angle", {"question": "angle", "frame": "erf", "at": at, "values_only": True}
    wanted = curve.get("expected", {})
    if "minimal_twist" in wanted:
        ends = {key: wanted["minimal_twist"][key] for key in ("from_vector", "to_vector")}
        yield "twist_frames", {"question": "frames", "frame": ["mtf-exact"], "at": at, **ends}
        yield "twist", {"question": "mtf", **ends}
    if "offset" in wanted:
        yield "offset", {"question": "offset", "distance": wanted["offset"]["distance"]}
    if "signed_frenet" in wanted:
        yield "signed_frenet", {"question": "frames", "frame": ["frenet-signed"], "columns": ["signed_curvature"], "at": at}


def asked(curves):
    """What phrame answers: {name: {what: answer}}."""
    lines = []
    for _, curve in curves:
        for what, question in questions(curve):
            lines.append({"id": "%s %s" % (what, curve["name"]), "curve": curve, "digits": DIGITS, **question})
    run = subprocess.run([os.environ["PHRAME_PROGRAM"], "batch", "--threads", "1"], input="".join(json.dumps(x) + "\n" for x in lines),
                         capture_output=True, text=True)
    answers = {}
    for line in run.stdout.splitlines():
        answer = json.loads(line)
        what, name = answer["id"].split()
        if "error" in answer:
            sys.exit("%s: %s" % (answer["id"], answer["error"]))
        answers.setdefault(name, {})[what] = answer
    return answers


def value_of(x):
    return x["value"] if isinstance(x, dict) else x


def point_of(curve, t):
    """Of a rational Bezier curve, or x, y, z over w: exactly."""
    def at(c):
        if "weights" not in curve:
            return sum((Fraction(x) * t ** k for k, x in enumerate(c)), Fraction(0))
        c = [Fraction(x) for x in c]
        while len(c) > 1:
            c = [a + (b - a) * t for a, b in zip(c, c[1:])]
        return c[0]
    if "weights" in curve:
        w = [Fraction(x) for x in curve["weights"]]
        lists = [[x * Fraction(p[k]) for x, p in zip(w, curve["control_points"])] for k in range(3)]
    else:
        lists, w = [curve["position"].get(key, ["0"]) for key in "xyz"], curve["position"].get("w", ["1"])
    return [at(c) / at(w) for c in lists]


def decimal_of(x):
    with decimal.localcontext() as context:
        context.prec = DIGITS
        return str(decimal.Decimal(x.numerator) / decimal.Decimal(x.denominator))


def offset_of(curve, answer):
    (offset,) = answer["offsets"]
    (path,) = offset["paths"]
    return {"distance": offset["distance"], "points": [[decimal_of(x) for x in point_of(path, t)] for t in parameters(curve)],
            "length": value_of(offset["length"]), "cusps": [value_of(cusp["t"]) for cusp in offset["cusps"]]}


def expected(curve, answers):
    total, wanted = answers["totals"], curve.get("expected", {})
    out = {"at": [str(t) for t in parameters(curve)], "frames": [row[1:] for row in answers["frames"]["rows"]]}
    if "angle" in answers:
        out["theta_erf"] = [v["theta"] for v in answers["angle"]["values"]]
    out["length"] = value_of(total["length"])
    if total.get("holonomy"):
        out["holonomy"] = value_of(total["holonomy"])
    if "twist" in answers:
        out["minimal_twist"] = {**{key: wanted["minimal_twist"][key] for key in ("from_vector", "to_vector")},
                                "twist": value_of(answers["twist"]["twist"]["minimal"]),
                                "frames": [row[7:] for row in answers["twist_frames"]["rows"]]}
    if "offset" in answers:
        out["offset"] = offset_of(curve, answers["offset"])
    if "near_tie" in wanted:
        out["near_tie"] = wanted["near_tie"]
    if "writhe" in wanted:
        out["writhe"] = value_of(total["writhe"])
    if "signed_frenet" in answers:
        rows = answers["signed_frenet"]["rows"]
        out["signed_frenet"] = {"frames": [row[7:13] for row in rows], "curvature": [row[13] for row in rows]}
    return out


def disagreements(curve):
    """Of what is expected with what is found here: texts. Only values within AGREEMENT are none."""
    path, want = foreign.Path(curve), curve["expected"]
    found, length, _ = path.frames(parameters(curve))
    pairs = [("length", want["length"], length)]
    for t, row, (r, e1, f2, f3, _) in zip(want["at"], want["frames"], found):
        pairs += [("frame at %s, %d" % (t, k), x, y) for k, (x, y) in enumerate(zip(row, [*r, *e1, *f2, *f3]))]
    if len(want["frames"]) != len(found):
        yield "%d frames" % len(found)
    if "theta_erf" in want:
        pairs += [("theta at %s" % t, x, foreign.angle_to_erf(path.segments[0], Fraction(t))) for t, x in zip(want["at"], want["theta_erf"])]
    if "holonomy" in want:
        pairs.append(("holonomy", want["holonomy"], path.holonomy()))
    if "minimal_twist" in want:
        twist = want["minimal_twist"]
        ends = [[foreign.number(x) for x in twist[key]] for key in ("from_vector", "to_vector")]
        turn, frames = path.minimal_twist(*ends, parameters(curve))
        pairs.append(("twist", twist["twist"], turn))
        for t, row, (f2, f3) in zip(want["at"], twist["frames"], frames):
            pairs += [("frame of minimal twist at %s, %d" % (t, k), x, y) for k, (x, y) in enumerate(zip(row, [*f2, *f3]))]
    if "offset" in want:
        offset = want["offset"]
        length, there, count = path.segments[0].offset(Fraction(offset["distance"]), [Fraction(t) for t in offset["cusps"]], parameters(curve))
        pairs.append(("length of the offset", offset["length"], length))
        for t, row, point in zip(want["at"], offset["points"], there):
            pairs += [("offset at %s, %d" % (t, k), x, y) for k, (x, y) in enumerate(zip(row, point))]
        if count != len(offset["cusps"]):
            yield "%d cusps of the offset" % count
    if "writhe" in want:
        pairs.append(("writhe", want["writhe"], path.writhe()))
    if "signed_frenet" in want:
        for t, row, kappa, (n, b, k) in zip(want["at"], want["signed_frenet"]["frames"], want["signed_frenet"]["curvature"],
                                            path.segments[0].signed_frenet(parameters(curve))):
            pairs += [("signed Frenet frame at %s, %d" % (t, i), x, y) for i, (x, y) in enumerate(zip([*row, kappa], [*n, *b, k]))]
    for what, text, x in pairs:
        y = foreign.number(text)
        most = foreign.number(AGREEMENT) * max(1.0, float(abs(y).mid()))
        if not abs(foreign.middle(y - x)) <= most:
            yield "%s: %s, here %s" % (what, text, x.str(DIGITS, radius=False))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--every", type=int, default=1, metavar="N")
    parser.add_argument("--group", help="this one only")
    options = parser.parse_args()
    if options.check:
        curves = [json.loads(line) for file in sorted(FOLDER.glob("*.jsonl")) for line in file.read_text().splitlines()][::options.every]
    else:
        pairs = [pair for pair in named(options.group) if options.group in (None, pair[0])]
        answers = asked(pairs)
        curves = [{**curve, "expected": expected(curve, answers[curve["name"]])} for _, curve in pairs]
    wrong = []
    for curve in curves:
        for problem in disagreements(curve):
            wrong.append("%s: %s" % (curve["name"], problem))
            print(wrong[-1], flush=True)
    print("%d curves, %d values differ" % (len(curves), len(wrong)))
    if wrong or not curves:
        sys.exit(1)
    if not options.check:
        for group in dict.fromkeys(group for group, _ in pairs):
            lines = [json.dumps(c) for c in curves if c["family"] == group]
            (FOLDER / ("%s.jsonl" % group)).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
