"""Numbers in and out, polynomials, reals and roots."""

from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import phrame
from common import MULTIPLIER, QUINTIC, theta_by_quadrature


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


def test_a_list_may_change_while_it_is_read():
    class Clears:
        def as_integer_ratio(self):
            numbers.clear()
            return 1, 2

    numbers = [Clears(), *map(Fraction, range(1, 99))]
    assert phrame.Polynomial(numbers).coefficients == (Fraction(1, 2), *range(1, 99)) and not numbers


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
    assert (theta / 2).digits(30) == (theta - theta * Fraction(1, 2)).digits(30) and abs(float(1 / theta) * float(theta) - 1) < 1e-15
    assert abs(theta) is theta is +theta and abs(-theta).digits(30) == theta.digits(30)
    with pytest.raises(ZeroDivisionError):
        theta / 0
    assert theta * 0 == 0 and isinstance(theta * 0, Fraction)
    assert theta.digits(30) == (-(-theta)).digits(30) == (1 - (1 - theta)).digits(30)


def test_a_real_for_others():
    """Each is the number of its kind that is nearest, or a ball around it."""
    theta = QUINTIC.angle().value(1)
    exact = theta_by_quadrature(QUINTIC, 1, 80)
    sympy = pytest.importorskip("sympy")
    for digits in (5, 15, 30, 50):
        number = theta.sympy(digits)
        with mpmath.workprec(number._prec):
            assert number._mpf_ == (+exact)._mpf_ and sympy.Float(1, digits)._prec == number._prec
    assert sympy.sympify(theta) == theta.sympy(17)
    flint = pytest.importorskip("flint")
    with mpmath.workdps(95), flint.ctx.workprec(600):
        near = [flint.arb(mpmath.nstr(exact + sign * mpmath.mpf("1e-75"), 85)) for sign in (-1, 1)]
        for bits in (20, 53, 200):
            ball = theta.flint(bits)
            assert all(ball.contains(x) for x in near) and ball.rad() <= flint.arb(2) ** -bits


def test_roots():
    root = phrame.root([-2, 0, 1], 1, 2)
    assert str(root.digits(30)) == "1.41421356237309504880168872421"
    assert phrame.root([-4, 0, 1], 1, 3) == 2 and isinstance(phrame.root([-4, 0, 1], 1, 3), Fraction)
