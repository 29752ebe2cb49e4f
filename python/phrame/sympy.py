"""Integrals of rational functions for SymPy: phrame.sympy.integrate in the place of sympy.integrate.

>>> import sympy
>>> from phrame.sympy import integrate
>>> x = sympy.Symbol("x")
>>> integrate(1 / (x**2 + x + 1), x)
2*sqrt(3)*atan(2*sqrt(3)*x/3 + sqrt(3)/3)/3
>>> integrate(1 / (x**2 + 2), (x, 0, sympy.oo))
sqrt(2)*pi/4
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Tuple

import sympy

from . import _phrame
from ._errors import InputError
from ._phrame import Integral, Polynomial, RationalFunction

__all__ = ["integral", "integrate", "rational_function"]

_MAX_DEGREE = 10_000
_Quotient = Tuple[Polynomial, Polynomial]
_X = Polynomial([0, 1])
_ONE = Polynomial([1])


def _refused(reason: str, value: Any) -> InputError:
    return InputError(f"expr: {reason}", "expr", reason, value)


def _power(p: Polynomial, n: int) -> Polynomial:
    if p.degree * n > _MAX_DEGREE or (p.degree <= 0 and n > _MAX_DEGREE):
        raise _refused(f"a power of degree over {_MAX_DEGREE}", n)
    result = _ONE
    while n:
        if n & 1:
            result = result * p
        n >>= 1
        if n:
            p = p * p
    return result


def _sum(terms: Any) -> _Quotient:
    n, d = next(terms)
    for m, e in terms:
        if d == e:
            n = n + m
        elif e == _ONE:
            n = n + m * d
        else:
            f = RationalFunction(n * e + m * d, d * e)
            n, d = f.numerator, f.denominator
    return n, d


def _quotient(e: Any, x: Any) -> _Quotient:
    """e as a numerator and a denominator, polynomials in x."""
    if e == x:
        return _X, _ONE
    if e.is_Rational or (e.is_Float and e.is_finite):
        number = sympy.Rational(e)  # of a Float, the dyadic number that it is
        return Polynomial([Fraction(int(number.p), int(number.q))]), _ONE
    if e.is_Add:
        return _sum(_quotient(term, x) for term in e.args)
    if e.is_Mul:
        n, d = _ONE, _ONE
        for factor in e.args:
            m, f = _quotient(factor, x)
            n, d = n * m, d * f
        return n, d
    if e.is_Pow and e.exp.is_Integer:
        n, d = _quotient(e.base, x)
        k = int(e.exp)
        if k < 0 and n.degree < 0:
            raise _refused(f"{e} divides by zero", e)
        return (_power(n, k), _power(d, k)) if k >= 0 else (_power(d, -k), _power(n, -k))
    raise _refused(f"{e} is no rational function of {x} with rational coefficients", e)


def rational_function(expr: Any, x: Any) -> RationalFunction:
    """A SymPy expression as a RationalFunction, exactly."""
    if not isinstance(x, sympy.Symbol):
        raise TypeError(f"x: a sympy.Symbol is wanted, not {type(x).__name__}")
    try:
        f = sympy.sympify(expr, strict=True)
    except (sympy.SympifyError, ValueError, TypeError):
        f = None
    if not isinstance(f, sympy.Expr):
        raise TypeError(f"expr: an expression of SymPy is wanted, not {type(expr).__name__}")
    return RationalFunction(*_quotient(f, x))


def _end(x: Any) -> Any:
    """An end as text that phrame.integrate reads."""
    return str(x) if isinstance(x, sympy.Basic) and not x.is_Float else x


def integral(expr: Any, x: Any, *, principal_value: bool = False, style: str = "textbook", form: str = "auto") -> Integral:
    """The same as an Integral, with its poles and all forms; x is a symbol or (x, a, b)."""
    ends: Tuple[Any, ...] = ()
    if isinstance(x, (tuple, list, sympy.Tuple)):
        if len(x) != 3:
            raise InputError("x: a symbol or (symbol, a, b) is wanted", "x", "a symbol or (symbol, a, b) is wanted", x)
        x, *ends_given = x
        ends = tuple(_end(end) for end in ends_given)
    if not isinstance(x, sympy.Symbol):
        raise TypeError(f"x: a sympy.Symbol is wanted, not {type(x).__name__}")
    return _phrame.integrate(
        rational_function(expr, x), *ends, variable="x", principal_value=principal_value, style=style, form=form
    )


def integrate(expr: Any, x: Any, *, principal_value: bool = False, style: str = "textbook", form: str = "auto") -> Any:
    """∫ expr dx of a rational function: a SymPy expression, continuous between its poles.

    With (x, a, b) for x the value between these ends, an exact number of SymPy; a pole between them
    is a DomainError. `style` and `form` are those of phrame.integrate.
    """
    found = integral(expr, x, principal_value=principal_value, style=style, form=form)
    return found.sympy(x if isinstance(x, sympy.Symbol) else None)
