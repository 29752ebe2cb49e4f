#!/usr/bin/env python3
"""Writes the preimages of the examples of Farouki and Moon (2018) to 60 digits: they are Hermite
interpolants by PH quintics with r'(0) = d_i, r'(1) = d_f, r(1) - r(0) = delta_p and the angles
phi = pi/4, 0, -7 pi/20, after R. T. Farouki, C. Giannelli, C. Manni, A. Sestini, Identification of
spatial PH quintic Hermite interpolants with near-optimal shape measures, CAGD 25 (2008). The paper
prints their first four decimals. Prints JSON: {"example1": [A0, A1, A2], ...}."""

import json

from mpmath import cos, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 80

DATA = {
    "example1": (("3/2", "3/2", "0"), ("0", "3/2", "-7/2"), ("1", "1", "0")),
    "example2": (("7/2", "-3/2", "-3/2"), ("7/2", "5/2", "-3/2"), ("1", "1", "1")),
    "example3": (("2", "-1", "7/2"), ("2", "2", "7/2"), ("1", "1", "1")),
}


def number(text):
    numerator, _, denominator = text.partition("/")
    return mpf(numerator) / mpf(denominator or 1)


def product(a, b):
    return [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]


def conjugate(a):
    return [a[0], -a[1], -a[2], -a[3]]


def turned(a, b):
    """The vector part of a i b*."""
    return product(product(a, [0, 1, 0, 0]), conjugate(b))[1:]


def root(d, phi):
    """A with A i A* = d; one for each angle phi."""
    length = sqrt(sum(x * x for x in d))
    x, y, z = (c / length for c in d)
    scale = sqrt((1 + x) * length / 2)
    return [
        -scale * sin(phi),
        scale * cos(phi),
        scale * (y * cos(phi) + z * sin(phi)) / (1 + x),
        scale * (z * cos(phi) - y * sin(phi)) / (1 + x),
    ]


def preimage(d_i, d_f, delta_p):
    first = root(d_i, pi / 4)
    last = root(d_f, -7 * pi / 20)
    mixed = [a + b for a, b in zip(turned(first, last), turned(last, first))]
    c = [120 * p - 15 * (a + b) + 5 * m for p, a, b, m in zip(delta_p, d_i, d_f, mixed)]
    middle = [-3 * (a + b) / 4 + r / 4 for a, b, r in zip(first, last, root(c, mpf(0)))]
    return [first, middle, last]


print(
    json.dumps(
        {
            name: [[nstr(x, 60) for x in a] for a in preimage(*([number(x) for x in v] for v in data))]
            for name, data in DATA.items()
        },
        indent=1,
    )
)
