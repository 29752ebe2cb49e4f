"""What several of these tests use: a curve, random ones, and the angle by mpmath."""

import os
from fractions import Fraction
from pathlib import Path as File

import mpmath

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
