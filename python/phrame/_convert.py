"""Conversions to other packages, which are imported when they are asked for."""

from __future__ import annotations

from fractions import Fraction
from typing import Any


def mpf(x: Any, bits: Any = None) -> Any:
    """The mpmath.mpf nearest to x."""
    import mpmath
    from mpmath.libmp import from_rational

    wanted = mpmath.mp.prec if bits is None else int(bits)
    more = wanted + 16
    while True:
        low, high = (from_rational(end.numerator, end.denominator, wanted, "n") for end in x.ball(more))
        if low == high:
            return mpmath.mp.make_mpf(low)
        more *= 2


def sympy_float(x: Any, digits: int = 17) -> Any:
    """A sympy.Float with the digits of x."""
    import sympy

    return sympy.Float(str(x.digits(digits)), digits)


def sympy_polynomial(p: Any, symbol: Any = "t") -> Any:
    """p as a sympy.Poly over QQ."""
    import sympy

    t = sympy.Symbol(symbol, real=True) if isinstance(symbol, str) else symbol
    coefficients = [sympy.Rational(c.numerator, c.denominator) for c in reversed(p.coefficients)]
    return sympy.Poly(coefficients or [0], t, domain=sympy.QQ)


def polynomial_for_flint(p: Any) -> Any:
    """p as a flint.fmpq_poly."""
    import flint

    return flint.fmpq_poly([flint.fmpq(c.numerator, c.denominator) for c in p.coefficients])


def _arb(x: Fraction) -> Any:
    """A dyadic fraction as a flint.arb, exactly."""
    import flint

    return flint.arb((x.numerator, 1 - x.denominator.bit_length()))


def arb(x: Any, bits: int = 53) -> Any:
    """A flint.arb around x."""
    import flint

    low, high = x.ball(bits)
    middle = (low + high) / 2
    return flint.arb(_arb(middle), _arb(high - middle))


def run_script(script: str) -> Any:
    """The antiderivative that a script for SymPy defines."""
    names: dict[str, Any] = {}
    exec(script, names)
    return names["antiderivative"]
