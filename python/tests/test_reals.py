"""Arithmetic, order, equality and texts of Real: decided by algebra, or said to be undecided."""

import math
import numbers
import pickle
import random
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest

import phrame
from common import MULTIPLIER, QUINTIC

TWO = phrame.root([-2, 0, 1], 1, 2)
THREE = phrame.root([-3, 0, 1], 1, 2)
THETA = QUINTIC.angle().value(1)


def near(x, digits=30):
    """The number as mpmath has it, from its digits."""
    return mpmath.mpf(str(x.digits(digits))) if isinstance(x, phrame.Real) else mpmath.mpf(x.numerator) / x.denominator


def test_equal_numbers_are_equal():
    for x in (THETA, TWO, QUINTIC.erf_twist, THETA * 2 - 1, 1 / THETA, abs(-THETA), np.sin(THETA), QUINTIC.curvature("1/3")):
        again = pickle.loads(pickle.dumps(x))
        assert again == x and x == again and hash(again) == hash(x) and again is not x and not again != x
        assert not again < x and again <= x and again - x == 0 == abs(x - again) and {x: 1}[again] == 1
        assert x != x + Fraction(1, 10**50) and x < x + Fraction(1, 10**50)
    assert QUINTIC.angle().value(1) == THETA == QUINTIC.angle().value("1") and THETA != QUINTIC.angle().value(2)


def test_numbers_made_of_equal_arguments_are_equal():
    half = [phrame.integrate("1/(x^2+1)", lower, 1).value() for lower in (0.5, Fraction(1, 2), "1/2", Decimal("0.5"), np.float32(0.5), np.array(0.5))]
    assert all(x == half[0] for x in half) and len(set(half)) == 1
    starts = [QUINTIC.angle(start=start).value(1) for start in (0.5, "0.5", Fraction(1, 2), "1/2")]
    assert all(x == starts[0] for x in starts) and QUINTIC.angle(start=0.25).value(1) != starts[0]
    along = [1, -1, 3]
    before = QUINTIC.angle(start=None, start_normal=along)
    value = before.value(1)
    along[0] = 5
    assert pickle.loads(pickle.dumps(before)).value(1) == value


def test_what_changes_nothing_changes_nothing():
    assert all(x is THETA for x in (THETA + 0, 0 + THETA, THETA - 0, THETA * 1, Fraction(1) * THETA, THETA / 1, THETA**1, 0.0 + THETA))
    assert (0 - THETA) == -THETA and 1 / THETA != THETA and 1**THETA == 1


def test_a_number_used_many_times_is_computed_once():
    """Of x + 1/x again and again, as by mpmath: there are 2**60 ways to the first x."""
    with mpmath.workdps(90):
        x, (y, exact) = THETA, (THETA + 0, near(THETA, 90))
        for _ in range(60):
            x, y, exact = x + 1 / x, y + 1 / y, exact + 1 / exact
        assert abs(near(x, 50) - exact) < 1e-45
    assert x == y


def test_long_sums():
    x = THETA
    for _ in range(4000):
        x = x + TWO
    with mpmath.workdps(40):
        assert abs(near(x, 30) - near(THETA, 40) - 4000 * mpmath.sqrt(2)) < 1e-22
    with pytest.raises(phrame.Undecided, match="in pairs"):
        for _ in range(4000):
            x = x + TWO
    del x


def test_algebra_decides():
    assert TWO * TWO == 2 and isinstance(TWO * TWO, Fraction) and hash(TWO * TWO) == hash(2)
    assert TWO * THREE == phrame.root([-6, 0, 1], 2, 3) and hash(TWO * THREE) == hash(phrame.root([-6, 0, 1], 2, 3))
    assert (TWO + THREE) ** 2 - 2 * TWO * THREE == 5 and TWO**-2 == Fraction(1, 2) and 1 / TWO == TWO / 2
    golden = phrame.root([-1, -1, 1], 1, 2)
    assert golden**2 == golden + 1 and golden ** 20 == 6765 * golden + 4181 and ((5 ** Fraction(1)) - 5) == 0
    assert np.sqrt(np.sqrt(TWO)) ** 4 == TWO and (2 * TWO).sqrt() ** 2 == 2 * TWO
    roots = [phrame.root([1, -3, 0, 1], *ends) for ends in ((-2, -1), (0, 1), (1, 2))]
    assert sum(roots) == 0 and roots[0] * roots[1] * roots[2] == -1
    assert roots[0] * roots[1] + roots[1] * roots[2] + roots[2] * roots[0] == -3
    assert TWO != Fraction(TWO.digits(300)) and TWO != float(TWO) and (TWO < float(TWO)) == (Fraction(float(TWO)) ** 2 > 2)
    assert float(TWO * TWO + Fraction(1, 2**52)) == 2  # half way between doubles
    assert len({TWO * THREE, phrame.root([-6, 0, 1], 2, 3), THREE * TWO}) == 1


def test_what_is_not_decided_says_so():
    """θ + θ is 2θ, but nothing here knows."""
    same = THETA + THETA, 2 * THETA
    with pytest.raises(phrame.Undecided):
        same[0] == same[1]
    with pytest.raises(phrame.Undecided):
        math.floor(same[0] / same[1])
    assert abs(same[0] - same[1]).ball(100)[0] <= 0  # and its absolute value is a number


def test_beside_other_things():
    assert THETA != "0.3" and THETA != None and THETA != [1] and not THETA == object()  # noqa: E711
    assert THETA < math.inf and THETA > -math.inf and THETA != math.nan and not THETA < math.nan and THETA != math.inf
    assert THETA < np.float32(0.5) and THETA > mpmath.mpf(-1) and np.float64(0.25) < THETA
    for wrong in (lambda: THETA + "1/2", lambda: THETA < [1], lambda: THETA + None, lambda: THETA % "x"):
        with pytest.raises(TypeError):
            wrong()
    with pytest.raises(ZeroDivisionError):
        THETA % 0
    with pytest.raises(ZeroDivisionError):
        THETA // 0
    with pytest.raises(ZeroDivisionError):
        0**-TWO
    assert 0**TWO == 0 == 0 ** (TWO / 2) and type(0**TWO) is Fraction


def test_beside_infinity_and_nan():
    """As floats have it."""
    inf, small = math.inf, TWO / 10**400
    for x, like in ((TWO, 1.5), (-TWO, -1.5), (TWO / 2, 0.75), (-TWO / 2, -0.75), (small, 0.5), (-small, -0.5)):
        for y in (inf, -inf, math.nan, np.float32("inf"), Decimal("-Infinity"), mpmath.inf, -mpmath.inf, np.float64("nan")):
            z = float(y)
            for f in (lambda a, b: a + b, lambda a, b: a - b, lambda a, b: a * b, lambda a, b: a / b, lambda a, b: a // b,
                      lambda a, b: a**b, lambda a, b: divmod(a, b)[0]):
                for found, wanted in ((f(x, y), f(like, z)), (f(y, x), f(z, like)) if isinstance(y, float) else (0, 0)):
                    assert found == wanted or (math.isnan(found) and math.isnan(wanted)), (x, y)
            assert (x < y, x > y, x == y, x != y) == (like < z, like > z, False, True)
    assert TWO % inf is TWO and TWO % -inf == -inf and (-TWO) % inf == inf and math.isnan(TWO % math.nan) and math.isnan(inf % TWO)
    assert divmod(TWO, inf) == (0, TWO)
    huge = mpmath.mpf(10) ** 400  # beyond doubles, and a number
    assert TWO < huge and isinstance(TWO + huge, phrame.Real)


def test_it_is_a_number():
    assert isinstance(THETA, numbers.Real) and THETA.real is THETA.conjugate() is THETA and THETA.imag == 0
    assert complex(THETA) == complex(float(THETA), 0)
    rng = random.Random(5)
    for _ in range(20 * MULTIPLIER):
        x = (rng.randint(-50, 50) * TWO + Fraction(rng.randint(-999, 999), 7)) * Fraction(rng.randint(1, 99), 5)
        y = Fraction(rng.randint(1, 999), 13) * rng.choice((-1, 1))
        with mpmath.workdps(40):
            m, n = near(x, 40), near(y, 40)
            assert (math.floor(x), math.ceil(x), math.trunc(x), int(x), round(x)) == \
                (mpmath.floor(m), mpmath.ceil(m), int(m), int(m), mpmath.nint(m))
            assert x // y == mpmath.floor(m / n) and divmod(x, y)[0] == x // y and divmod(x, y)[1] == x % y == x - x // y * y
            assert abs(near(x % y, 40) - (m - n * mpmath.floor(m / n))) < 1e-25 and y // TWO == mpmath.floor(n / mpmath.sqrt(2))
            assert round(x, 3) == Fraction(int(mpmath.nint(m * 1000)), 1000) and round(x, -1) == 10 * int(mpmath.nint(m / 10))
            assert isinstance(round(x, 3), Fraction) and isinstance(round(x), int)


FUNCTIONS = {"sqrt": "sqrt", "exp": "exp", "expm1": "expm1", "log": "log", "log1p": "log1p", "sin": "sin", "cos": "cos", "tan": "tan",
             "arcsin": "asin", "arccos": "acos", "arctan": "atan", "sinh": "sinh", "cosh": "cosh", "tanh": "tanh", "arcsinh": "asinh",
             "arccosh": "acosh", "arctanh": "atanh"}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_of_numpy(name):
    """Against mpmath; also of arrays of objects."""
    f = getattr(np, name)
    for x in (THETA, TWO / 2, TWO):
        if (name in ("arcsin", "arccos", "arctanh") and x == TWO) or (name == "arccosh" and x != TWO):
            with pytest.raises(phrame.DomainError):
                f(x)
            continue
        with mpmath.workdps(60):
            exact = getattr(mpmath, FUNCTIONS[name])(near(x, 60))
            assert abs(near(f(x), 50) - exact) < mpmath.mpf(10) ** -48
        assert f(np.array([x, x], dtype=object))[1] == f(x)
        assert pickle.loads(pickle.dumps(f(x))) == f(x)


def test_arctan2_and_powers():
    with mpmath.workdps(60):
        s, t = mpmath.sqrt(2), near(THETA, 60)
        for y, x in ((TWO, -1), (-TWO, -3), (THETA, TWO)):
            assert abs(near(np.arctan2(y, x), 50) - mpmath.atan2(near(y, 60), near(x, 60) if isinstance(x, phrame.Real) else x)) < 1e-48
        for found, exact in ((TWO**TWO, s**s), (2**THETA, 2**t), (THETA**7, t**7), (THETA**-7, t**-7), (THETA ** Fraction(1, 3), t ** (mpmath.mpf(1) / 3)),
                             (THETA**1.5, t**1.5), (np.power(THETA, 2), t * t)):
            assert abs(near(found, 50) - exact) < 1e-48 * max(1, abs(exact))
    with pytest.raises(phrame.DomainError):
        (-2) ** TWO
    assert TWO**0 == 1 and TWO**1 is TWO and (-TWO) ** 3 == -2 * TWO


def test_arrays_take_part():
    found = np.array([1.0, 2.0]) * TWO
    assert found.dtype == object and found[1] == 2 * TWO and (TWO * np.array([1, 2]))[1] == 2 * TWO
    assert (np.array([1.0, 2.0]) < TWO).tolist() == [True, False] and (TWO > np.array([1.0, 2.0])).tolist() == [True, False]
    matrix = np.array([[TWO / 2, TWO / 2], [-TWO / 2, TWO / 2]], dtype=object)
    assert (matrix @ matrix.T == np.eye(2)).all() and matrix.astype(float)[0, 0] == float(TWO / 2)


SPECS = [".20f", ".30g", ".0f", ".3e", "20.5f", "<12.2f|"[:-1], "+.4f", "010.3f", ".2%", ",.3f", "e", "f", "g", ".1E", "^+20.10G", "_.2f", ".60f"]


@pytest.mark.parametrize("spec", SPECS)
def test_formats_are_those_of_all_digits(spec):
    """Of a Decimal with 200 digits by mpmath."""
    values = {TWO * 123456: lambda: 123456 * mpmath.sqrt(2), -TWO / 10**8: lambda: -mpmath.sqrt(2) / 10**8, THREE: lambda: mpmath.sqrt(3),
              phrame.root([-(10**12 - 1), 0, 1], 0, 10**6): lambda: mpmath.sqrt(10**12 - 1)}
    for x, exact in values.items():
        with mpmath.workdps(220):
            # Without a precision floats have six places, where a Decimal has all of its digits.
            alike = spec if "." in spec else f".6{spec}"
            wanted = format(Decimal(mpmath.nstr(exact(), 200)), alike.replace("_", ","))
            assert format(x, spec) == (wanted.replace(",", "_") if "_" in spec else wanted), spec


def test_formats_of_other_kinds():
    assert f"{THETA}" == str(THETA) and f"{THETA:>30}" == str(THETA).rjust(30) and "%.3f" % THETA == "0.286"
    for wrong in ("d", "x", ".f", "s", ".3q", "..3f"):
        with pytest.raises(ValueError):
            format(THETA, wrong)


def test_random_expressions_of_roots():
    """Sums, products and quotients in ℚ(√2, √3), which are also computed by their coordinates."""
    rng = random.Random(7)

    def times(a, b):  # of 1, √2, √3, √6
        product = [Fraction(0)] * 4
        for i, x in enumerate(a):
            for k, y in enumerate(b):
                factor = (2 if i & k & 1 else 1) * (3 if i & k & 2 else 1)
                product[i ^ k] += factor * x * y
        return product

    def number(a):
        return a[0] + a[1] * TWO + a[2] * THREE + a[3] * (TWO * THREE)

    for _ in range(10 * MULTIPLIER):
        a, b = ([Fraction(rng.randint(-3, 3), rng.randint(1, 3)) for _ in range(4)] for _ in range(2))
        assert number(a) + number(b) == number([x + y for x, y in zip(a, b)])
        assert number(a) * number(b) == number(times(a, b))
        assert hash(number(a) * number(b)) == hash(number(times(a, b)))
