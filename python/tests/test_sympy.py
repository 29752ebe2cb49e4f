"""Integrals for SymPy, against SymPy's derivatives and mpmath's quadrature."""

import random
from fractions import Fraction

import mpmath
import pytest
import sympy

import phrame
from common import MULTIPLIER
from phrame.sympy import integral, integrate, rational_function

x = sympy.Symbol("x")


def assert_is_antiderivative(found, f, symbol, at):
    """At numbers: sums over roots are evaluated by SymPy."""
    rate = sympy.diff(found, symbol)
    for t in at:
        expected = f.subs(symbol, t)
        assert abs(sympy.N(rate.subs(symbol, t) - expected, 40)) <= abs(sympy.N(expected)) * sympy.Float("1e-25")


@pytest.mark.parametrize(
    "f",
    [
        1 / (x**2 + x + 1),
        1 / (x**5 + x + 1),
        (x**4 - 3 * x**2 + 6) / (x**6 - 5 * x**4 + 5 * x**2 + 4),
        (3 * x**4 - x + 7) / ((x**2 + 1) * (x**3 - 2 * x + 5)),
        x**2 / 3 + 1 / (x - 1) + 1 / (x - 1) ** 2 + (1 - 1 / x) ** -2,
        (x + 1) / (x**5 - 3 * x**2 + 2) ** 2,
        x / 2 + sympy.Rational(1, 7),
    ],
)
@pytest.mark.parametrize("style", ["textbook", "logarithms", "real"])
def test_the_derivative_is_the_integrand(f, style):
    assert_is_antiderivative(integrate(f, x, style=style), f, x, [sympy.Rational(1, 3), sympy.Rational(-27, 10)])


@pytest.mark.parametrize("seed", range(6 * MULTIPLIER))
def test_random_integrands(seed):
    rng = random.Random(seed)

    def polynomial(n):
        return sum(rng.randint(-9, 9) * x**k for k in range(n)) + x**n

    f = polynomial(rng.randint(0, 5)) / (polynomial(rng.randint(1, 3)) * polynomial(rng.randint(1, 2)) ** 2)
    assert_is_antiderivative(integrate(f, x), f, x, [sympy.Rational(1, 3), sympy.Rational(22, 7)])


def test_expressions_are_read_exactly():
    t = sympy.Rational(5, 3)
    for f in (x, sympy.Integer(2), (x + 1 / x) ** 3 / (1 - x) ** 2 - 1 / (x - 1) - 1 / (x - 1), 1 / (1 / x + 1 / (1 + x))):
        value = f.subs(x, t)
        assert rational_function(f, x)(Fraction(5, 3)) == Fraction(int(value.p), int(value.q))
    assert rational_function(0.1, x)(0) == Fraction(0.1)
    y = sympy.Symbol("z")
    assert integrate(1 / (y**3 + y + 1), y).free_symbols == {y}
    assert_is_antiderivative(integrate(1 / (y**3 + y + 1), y), 1 / (y**3 + y + 1), y, [sympy.Rational(1, 2)])
    real = sympy.Symbol("t", real=True)
    assert integrate(1 / (real - 1), real, style="real") == sympy.log(sympy.Abs(real - 1))
    assert integrate(1 / (x - 1), x, style="real") == sympy.log(x - 1)  # whose derivative is right for complex x, too


@pytest.mark.parametrize(
    "f, a, b",
    [
        (1 / (x**5 + 1), 0, 3),
        (1 / (x**6 - 2), 0, 1),  # SymPy 1.14: −0.2668…, which is no value of it
        (1 / (x**3 + x + 1), 0, sympy.sqrt(2)),
        (x**2 / (x**6 + x + 1), -sympy.pi, sympy.Rational(1, 3)),
    ],
)
def test_definite_integrals(f, a, b):
    value = integrate(f, (x, a, b))
    assert isinstance(value, phrame.Real)
    with mpmath.workdps(30):
        ends = mpmath.linspace(mpmath.mpmathify(sympy.N(a, 40)), mpmath.mpmathify(sympy.N(b, 40)), 9)
        assert abs(mpmath.quad(sympy.lambdify(x, f, "mpmath"), ends) - value.mpmath()) < mpmath.mpf(10) ** -22


def test_ends():
    assert integrate(x**2, (x, 0, 3)) == 9 and isinstance(integrate(x**2, (x, 0, 3)), Fraction)
    assert integral(1 / (x**2 + 1), (x, -sympy.oo, sympy.oo)).exact == "π"
    with pytest.raises(phrame.DomainError):  # SymPy 1.14: a complex number
        integrate(1 / (x**5 - x - 1), (x, 0, 2))
    assert integrate(1 / x, (x, -1, 1), principal_value=True) == 0


@pytest.mark.parametrize(
    "kind, f, over",
    [
        (phrame.InputError, sympy.sqrt(2) * x, x),
        (phrame.InputError, sympy.Symbol("a") / x, x),
        (phrame.InputError, sympy.sin(x), x),
        (phrame.InputError, x ** sympy.Rational(1, 2), x),
        (phrame.InputError, sympy.Pow(sympy.Add(x, -x, evaluate=False), -1, evaluate=False), x),
        (phrame.InputError, sympy.nan, x),
        (phrame.InputError, (x + 1) ** 10**9, x),
        (phrame.InputError, x, (x, 1)),
        (TypeError, x, "x"),
    ],
)
def test_what_is_refused(kind, f, over):
    with pytest.raises(kind):
        integrate(f, over)
