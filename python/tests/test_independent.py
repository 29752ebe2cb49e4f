"""Random curves: what python-flint and mpmath find from the coefficients of the preimage alone, by formulas written here."""

import math
import random
from fractions import Fraction

import mpmath
import numpy as np
import pytest

import phrame
from common import MULTIPLIER, theta_by_quadrature

flint = pytest.importorskip("flint")


class Independent:
    """A PH curve by integers u, v, p, q from the lowest coefficient on."""

    def __init__(self, parts):
        self.parts = [flint.fmpz_poly(part) for part in parts]
        u, v, p, q = self.parts
        du, dv, dp, dq = (part.derivative() for part in self.parts)
        self.sigma = u * u + v * v + p * p + q * q
        self.twist = u * dv - du * v - p * dq + dp * q  # h
        # α = u + iv, β = q + ip, g = αβ′ − α′β
        re = u * dq - v * dp - du * q + dv * p
        im = u * dp + v * dq - du * p - dv * q
        self.rho = 4 * (re * re + im * im)

    def integral(self, numerator, power, a, b):
        """∫ numerator/σ^power."""
        over, under = flint.acb_poly(numerator), flint.acb_poly(self.sigma)
        return flint.acb.integral(lambda z, _: over(z) / under(z) ** power, a, b).real

    def length(self):
        return sum(flint.fmpq(c, k + 1) for k, c in enumerate(self.sigma.coeffs()))

    def frame(self, t, theta):
        """A i A* and A j A*, A k A* turned by θ, in numbers of mpmath."""
        u, v, p, q = (mpmath.polyval(list(map(int, part.coeffs()))[::-1] or [0], t) for part in self.parts)
        size = u * u + v * v + p * p + q * q
        e1 = [u * u + v * v - p * p - q * q, 2 * (u * q + v * p), 2 * (v * q - u * p)]
        e2 = [2 * (v * p - u * q), u * u - v * v + p * p - q * q, 2 * (u * v + p * q)]
        e3 = [2 * (u * p + v * q), 2 * (p * q - u * v), u * u - v * v - p * p + q * q]
        c, s = mpmath.cos(theta), mpmath.sin(theta)
        f2 = [c * x + s * y for x, y in zip(e2, e3)]
        f3 = [c * y - s * x for x, y in zip(e2, e3)]
        return [[x / size for x in e] for e in (e1, f2, f3)]


def fraction(x):
    return flint.arb(flint.fmpq(x.numerator, x.denominator))


def random_parts(rng):
    """Without a common zero."""
    while True:
        degree, size = rng.randint(1, 4), rng.choice([3, 9, 100, 10**12])
        parts = [[rng.randint(-size, size) for _ in range(degree + 1)] for _ in range(4)]
        common = flint.fmpz_poly([])
        for part in parts:
            common = common.gcd(flint.fmpz_poly(part))
        if common.degree() == 0:
            return parts


def agree(found, exact, digits):
    """Is a number of phrame in python-flint's ball, as far as that goes?"""
    assert exact.rad() <= abs(exact) * flint.arb(10) ** -digits + flint.arb(10) ** -digits
    ball = found.flint(200) if isinstance(found, phrame.Real) else fraction(found)
    return bool(exact.overlaps(ball))


@pytest.mark.parametrize("part", range(4))
def test_random_curves(part):
    rng = random.Random(part)
    for _ in range(6 if MULTIPLIER == 1 else 125):
        parts = random_parts(rng)
        exact, curve = Independent(parts), phrame.Curve(*parts)
        t = Fraction(rng.randint(1, 16), 16)
        with flint.ctx.workprec(160):
            end = fraction(t)
            theta = exact.integral(-2 * exact.twist, 1, 0, end)
            found = curve.angle().value(t)
            assert agree(found, theta, 35), parts
            assert agree(curve.erf_twist, exact.integral(2 * exact.twist, 1, 0, 1), 35), parts
            assert agree(curve.bending_energy, exact.integral(exact.rho, 3, 0, 1), 30), parts
        assert curve.length == Fraction(*map(int, (exact.length().p, exact.length().q)))
        with mpmath.workdps(40):
            at = mpmath.mpf(t.numerator) / t.denominator
            by_hand = np.array(exact.frame(at, mpmath.mpf(str(found.digits(38) if isinstance(found, phrame.Real) else found))),
                               dtype=float)
        assert (curve.frames([t], start="erf")[0] == by_hand).all(), parts  # to the bit: 40 digits round as all do


@pytest.mark.parametrize("seed", range(2 * MULTIPLIER))
def test_angles_agree_with_quadrature(seed):
    """By mpmath, which knows nothing of balls either."""
    rng = random.Random(seed)
    curve = phrame.Curve(*random_parts(rng))
    t = Fraction(rng.randint(1, 16), 16)
    theta = curve.angle().value(t, digits=25)
    with mpmath.workdps(45):
        exact = theta_by_quadrature(curve, t, 40)
        assert abs(mpmath.mpf(str(theta)) - exact) <= abs(exact) * mpmath.mpf(10) ** -24


def test_the_formulas_are_those_of_curves():
    """(1, t, 0, t): σ = 1 + 2t², h = 1, r′ = (1, 2t, 2t²)."""
    helix = Independent([[1], [0, 1], [0], [0, 1]])
    assert helix.twist == flint.fmpz_poly([1]) and helix.sigma == flint.fmpz_poly([1, 0, 2])
    e1 = helix.frame(mpmath.mpf(1), 0)[0]
    assert all(math.isclose(a, b) for a, b in zip(e1, (1 / 3, 2 / 3, 2 / 3)))
