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


def mpf(end):
    return mpmath.mpf("inf") * int(sympy.sign(end)) if end.is_infinite else mpmath.mpmathify(sympy.N(end, 40))


def quadrature(f, a, b):
    """∫ f by mpmath, on both sides of each real number −1, 0, 1 … that is not an end."""
    inside = [k for k in range(-5, 6) if a < k < b]
    return mpmath.quad(sympy.lambdify(x, f, "mpmath"), [a, *inside, b])


DEFINITE = [
    (1 / (x**5 + 1), 0, 3),
    (1 / (x**6 - 2), 0, 1),  # SymPy 1.14: −0.2668…, which is no value of it
    (1 / (x**3 + x + 1), 0, sympy.sqrt(2)),
    (x**2 / (x**4 + x + 1), -sympy.pi, sympy.Rational(1, 3)),
    (x / (x**4 + x + 1), sympy.oo, 2),
    ((x + 1) / (x**4 + x + 1), -sympy.oo, sympy.oo),
    (1 / (x**3 - 3 * x - 3), -sympy.oo, 2),
    (1 / (x**2 + 1) ** 2 + 1 / (x**2 + 2), -1, sympy.Rational(1, 2)),
]


@pytest.mark.parametrize("f, a, b", DEFINITE if MULTIPLIER > 1 else DEFINITE[1::2])
def test_definite_integrals(f, a, b):
    value = integrate(f, (x, a, b))
    assert isinstance(value, sympy.Expr) and not value.has(sympy.Float)
    with mpmath.workdps(30):
        expected = quadrature(f, *(mpf(end) for end in sorted(map(sympy.sympify, (a, b))))) * (1 if a < b else -1)
        assert abs(expected - mpf(value)) < mpmath.mpf(10) ** -20
    assert abs(float(value) - float(integral(f, (x, a, b)).value())) < 1e-14


@pytest.mark.parametrize("seed", range(2 * MULTIPLIER))
def test_random_definite_integrals(seed):
    rng = random.Random(seed)
    f = sum(rng.randint(-9, 9) * x**k for k in range(4)) / ((x**2 + rng.randint(1, 9)) * (x**2 + x + rng.randint(1, 9)) * (x - 9))
    a, b = sorted(rng.sample([-sympy.oo, sympy.Rational(-22, 7), -sympy.sqrt(3), sympy.Integer(0), sympy.pi / 3, sympy.Integer(5)], 2))
    for style in ("textbook", "real", "logarithms", "radicals"):
        assert abs(integrate(f, (x, a, b), style=style).n() - quadrature(f, mpf(a), mpf(b))) < 1e-9


def test_principal_values():
    """The poles are simple: ∫ (f − Σ c/(x − p)) dx + Σ c·log|(b − p)/(a − p)|, by mpmath."""
    f = x / (x**3 - 3 * x - 1)
    poles = [float(p) for p in mpmath.polyroots([1, 0, -3, -1])]
    residues = [p / (3 * p**2 - 3) for p in poles]

    def smooth(t):
        return t / (t**3 - 3 * t - 1) - sum(c / (t - p) for c, p in zip(residues, poles))

    expected = mpmath.quad(smooth, [-1.7, 0.1, 1.5, 2]) + sum(
        c * mpmath.log(abs((2 - p) / (-1.7 - p))) for c, p in zip(residues, poles)
    )
    assert abs(integrate(f, (x, sympy.Rational(-17, 10), 2), principal_value=True).n() - expected) < 1e-8


def test_ends():
    assert integrate(x**2, (x, 0, 3)) == 9 and isinstance(integrate(x**2, (x, 0, 3)), sympy.Integer)
    assert integrate(1 / (x**2 + 1), (x, -sympy.oo, sympy.oo)) == sympy.pi
    assert integral(1 / (x**2 + 1), (x, -sympy.oo, sympy.oo)).exact == "π"
    cubic = phrame.integrate("1/(x^2+1)", "root(x^3-2, 1, 2)", "pi/2").sympy()
    assert abs(float(cubic) - float(mpmath.atan(mpmath.pi / 2) - mpmath.atan(mpmath.cbrt(2)))) < 1e-15
    with pytest.raises(phrame.DomainError):  # SymPy 1.14: a complex number
        integrate(1 / (x**5 - x - 1), (x, 0, 2))
    assert integrate(1 / x, (x, -1, 1), principal_value=True) == 0
    with pytest.raises(phrame.InputError, match="^symbol: a definite integral is a number"):
        phrame.integrate("1/x", 1, 2).sympy(x)


def angles(kinds):
    """Of random curves, from random starts."""
    rng = random.Random(41)
    for kind in kinds:
        for degree in (1, 2) * MULTIPLIER:
            curve = phrame.Curve(*([rng.randint(-5, 5) for _ in range(degree)] + [rng.randint(1, 5)] for _ in range(4)))
            start = rng.choice([{}, {"start": Fraction(1, 3)}, {"start": "pi/4"}, {"start_normal": [3, 1, -2]}])
            yield curve.angle(kind, form=rng.choice(["auto", "partial-fractions", "rothstein-trager"]), **start)


@pytest.mark.parametrize("style", ["textbook", "real", "logarithms"])
def test_an_angle_is_itself_with_its_start(style):
    """Against mpmath's quadrature of its rate from what it is at 0."""
    t = sympy.Symbol("t")
    for angle in angles(["erf", "frenet"]):
        formula = angle.sympy(t, style)
        rate = sympy.lambdify(t, angle.rate().sympy(t), "mpmath")
        for at in (Fraction(-3, 2), Fraction(1)):
            expected = mpmath.mpf(str(angle.value(0, 17))) + mpmath.quad(rate, mpmath.linspace(0, float(at), 9))
            assert abs(complex(formula.subs(t, sympy.Rational(at)).n()) - expected) < 1e-8


def test_an_angle_that_is_an_arctangent():
    t = sympy.Symbol("t", real=True)
    curve = phrame.Curve([1], [0, 1], [0], [1])
    assert curve.angle().sympy() == -sympy.sqrt(2) * sympy.atan(sympy.sqrt(2) * t / 2)
    assert curve.angle(start="pi/4").sympy(t) == sympy.pi / 4 + curve.angle().sympy(t)


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
