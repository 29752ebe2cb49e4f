#!/usr/bin/env python3
"""Writes poses.json: a path with orientations at its joints, and how the frame through them turns, by mpmath.

Nothing of the way of phrame is in it: a vector is carried along the tangent by the ordinary differential equation
f' = -(f.T')T, by Taylor series of 40 digits; lengths are quadratures; and the cubic spline is that of second derivatives.
"""

import json
from fractions import Fraction
from pathlib import Path

from mpmath import atan2, cos, lu_solve, matrix, mp, mpf, odefun, pi, quad, sin, sqrt

mp.dps = 40
# A = u + vi + pj + qk on [0, 3], one polynomial in three segments.
PREIMAGE = {"u": [2, 1, 0], "v": [0, -1, Fraction(1, 2)], "p": [1, 0, Fraction(-1, 3)], "q": [-1, 1, 0]}
F2 = [[0, 0, 1], [1, 2, -1], [-3, 1, 1], [0, 1, 4]]
TURNS = [0, 0, 1, 0]
AT = ["1/2", "5/4", "3/2", "2", "9/4", "3"]


def shifted(c, k):
    return [c[0] + c[1] * k + c[2] * k * k, c[1] + 2 * c[2] * k, c[2]]


def value(c, t):
    return sum((mpf(Fraction(x).numerator) / Fraction(x).denominator) * t**n for n, x in enumerate(c))


def slope(c, t):
    return value([c[1], 2 * c[2]], t)


def hodograph(t):
    u, v, p, q = (value(PREIMAGE[key], t) for key in "uvpq")
    return [u * u + v * v - p * p - q * q, 2 * (u * q + v * p), 2 * (v * q - u * p)]


def hodograph_rate(t):
    u, v, p, q = (value(PREIMAGE[key], t) for key in "uvpq")
    du, dv, dp, dq = (slope(PREIMAGE[key], t) for key in "uvpq")
    return [2 * (u * du + v * dv - p * dp - q * dq), 2 * (du * q + u * dq + dv * p + v * dp),
            2 * (dv * q + v * dq - du * p - u * dp)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    size = sqrt(dot(v, v))
    return [x / size for x in v]


def speed(t):
    h = hodograph(t)
    return sqrt(dot(h, h))


def tangent(t):
    return unit(hodograph(t))


def tangent_rate(t):
    h, d, s = hodograph(t), hodograph_rate(t), speed(t)
    along = dot(h, d) / s**2
    return [(x - along * y) / s for x, y in zip(d, h)]


def projected(v, t):
    e1 = tangent(t)
    along = dot(v, e1)
    return unit([x - along * y for x, y in zip(v, e1)])


def turned(f, t, angle):
    g = cross(tangent(t), f)
    return [cos(angle) * x + sin(angle) * y for x, y in zip(f, g)]


def carried(f, t0):
    def rate(t, y):
        c = dot(y, tangent_rate(t))
        return [-c * x for x in tangent(t)]

    return odefun(rate, t0, f)


joints = [mpf(k) for k in range(4)]
lengths = [quad(speed, [k, k + 1]) for k in joints[:-1]]
carry = [carried(projected([mpf(x) for x in F2[k]], joints[k]), joints[k]) for k in range(3)]
turns = []
for k in range(3):
    f, wanted = carry[k](joints[k + 1]), projected([mpf(x) for x in F2[k + 1]], joints[k + 1])
    turns.append(atan2(dot(wanted, cross(tangent(joints[k + 1]), f)), dot(wanted, f)) + 2 * pi * TURNS[k + 1])

# Second derivatives of the natural cubic spline of the angle over the length.
knots = [mpf(0)]
angles = [mpf(0)]
for k in range(3):
    knots.append(knots[-1] + lengths[k])
    angles.append(angles[-1] + turns[k])
a = matrix(4, 4)
b = matrix(4, 1)
a[0, 0] = a[3, 3] = 1
for k in (1, 2):
    a[k, k - 1], a[k, k], a[k, k + 1] = lengths[k - 1], 2 * (lengths[k - 1] + lengths[k]), lengths[k]
    b[k] = 6 * (turns[k] / lengths[k] - turns[k - 1] / lengths[k - 1])
second = list(lu_solve(a, b))


def smooth(k, s):
    """Angle, rate and its derivative on leg k, s from its start."""
    h, m, n = lengths[k], second[k], second[k + 1]
    c = turns[k] / h - h * (2 * m + n) / 6
    return (c * s + m * s**2 / 2 + (n - m) / (6 * h) * s**3, c + m * s + (n - m) / (2 * h) * s**2, m + (n - m) / h * s)


def text(x):
    return mp.nstr(x, 30)


def at(t, is_smooth):
    k = min(int(t), 2)
    s = quad(speed, [joints[k], t])
    angle, rate, rate_slope = smooth(k, s) if is_smooth else (turns[k] * s / lengths[k], turns[k] / lengths[k], mpf(0))
    f = carry[k](t) if t != joints[k] else projected([mpf(x) for x in F2[k]], t)
    return {"f2": [text(x) for x in turned(f, t, angle)], "rate": text(rate), "slope": text(rate_slope)}


even_rates = [turns[k] / lengths[k] for k in range(3)]
segments = [{"preimage": {key: [str(Fraction(x)) for x in shifted(c, k)] for key, c in PREIMAGE.items()}, "basis": "power"}
            for k in range(3)]
through = [{"t": k, "f2": F2[k]} | ({"turns": TURNS[k]} if TURNS[k] else {}) for k in range(4)]
result = {
    "path": {"phrame": "spline/1", "segments": segments, "frame": {"through": through}},
    "lengths": [text(x) for x in lengths],
    "turns": [text(x) for x in turns],
    "even": {"squared_rate": text(sum(x * y for x, y in zip(turns, even_rates))),
             "at": {t: at(mpf(Fraction(t).numerator) / Fraction(t).denominator, False) for t in AT}},
    "smooth": {"squared_rate": text(sum(quad(lambda s, k=k: smooth(k, s)[1] ** 2, [0, lengths[k]]) for k in range(3))),
               "squared_slope": text(sum(quad(lambda s, k=k: smooth(k, s)[2] ** 2, [0, lengths[k]]) for k in range(3))),
               "at": {t: at(mpf(Fraction(t).numerator) / Fraction(t).denominator, True) for t in AT}},
}
Path(__file__).with_name("poses.json").write_text(json.dumps(result, indent=1) + "\n")
