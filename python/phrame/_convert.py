"""Conversions to other packages, which are imported when they are asked for."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from ._errors import Undecided


def mpf(x: Any, bits: Any = None) -> Any:
    """The mpmath.mpf nearest to x."""
    import mpmath
    from mpmath.libmp import from_rational

    wanted = mpmath.mp.prec if bits is None else int(bits)
    more, most = wanted + 16, 16 * wanted + 100_000
    while more <= most:
        low, high = (from_rational(end.numerator, end.denominator, wanted, "n") for end in x.ball(more))
        if low == high:
            return mpmath.mp.make_mpf(low)
        more *= 2
    raise Undecided(f"mpmath: {most} bits do not tell how to round to {wanted}")


def sympy_float(x: Any, digits: int = 17) -> Any:
    """The sympy.Float nearest to x, of the bits that SymPy has for so many digits."""
    import sympy
    from mpmath.libmp import dps_to_prec

    bits = dps_to_prec(int(digits))
    return sympy.Float(mpf(x, bits), precision=bits)


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


def run_script(script: str, variable: str, symbol: Any = None) -> Any:
    """The antiderivative that a script for SymPy defines, of `symbol` or a real one."""
    import sympy

    x = sympy.Symbol(variable, real=True) if symbol is None else symbol
    root = sympy.Symbol("w" if x.name == "z" else "z")
    names = {**vars(sympy), "w" if variable == "z" else "z": root, variable: x}
    if not x.is_real:
        names["Abs"] = lambda f: f  # log f and log |f| have one derivative; that of |f| is for real x only
    for line in script.splitlines():
        if line.startswith("antiderivative = "):
            exec(line, names)
    return names["antiderivative"]
