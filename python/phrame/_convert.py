"""Conversions to other packages, which are imported when they are asked for."""

from __future__ import annotations

import json
import operator
from fractions import Fraction
from typing import Any

from ._errors import InputError, Undecided


def count(n: Any, place: str, most: int) -> int:
    """A whole number from 1 to `most`."""
    if isinstance(n, bool) or not hasattr(n, "__index__"):
        raise TypeError(f"{place}: an int is wanted, not {type(n).__name__}")
    try:
        found = int(operator.index(n))
    except TypeError:  # an array
        raise TypeError(f"{place}: an int is wanted, not {type(n).__name__}") from None
    if not 1 <= found <= most:
        reason = f"{found if found.bit_length() < 100 else 'an int'} is not in 1 … {most}"
        raise InputError(f"{place}: {reason}", place, reason, n)
    return found


def mpf(x: Any, bits: Any = None) -> Any:
    """The mpmath.mpf nearest to x."""
    import mpmath
    from mpmath.libmp import from_rational

    wanted = mpmath.mp.prec if bits is None else count(bits, "bits", 10_000_000)
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

    bits = dps_to_prec(count(digits, "digits", 1_000_000))
    return sympy.Float(mpf(x, bits), precision=bits)


def named_symbol(symbol: Any) -> Any:
    """symbol, if it is one of SymPy."""
    import sympy

    if not isinstance(symbol, sympy.Symbol):
        raise TypeError(f"symbol: a sympy.Symbol or its name is wanted, not {type(symbol).__name__}")
    return symbol


def sympy_polynomial(p: Any, symbol: Any = "t") -> Any:
    """p as a sympy.Poly over QQ."""
    import sympy

    t = sympy.Symbol(symbol, real=True) if isinstance(symbol, str) and symbol else named_symbol(symbol)
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


def run_script(script: str, variable: str, symbol: Any = None, wanted: str = "antiderivative") -> Any:
    """What a script for SymPy defines, of `symbol` or a real one."""
    import sympy

    x = sympy.Symbol(variable, real=True) if symbol is None else named_symbol(symbol)
    root = sympy.Symbol("w" if x.name == "z" else "z")
    names = {**vars(sympy), "w" if variable == "z" else "z": root, variable: x}
    if not x.is_real:
        names["Abs"] = lambda f: f  # log f and log |f| have one derivative; that of |f| is for real x only
    for line in script.splitlines():
        if line.startswith(wanted + " = "):
            exec(line, names)
    return names[wanted]


def sympy_angle(script: str, symbol: Any, half_turns: Fraction, radians: Fraction, re: int, im: int) -> Any:
    """π·half_turns + radians + arg(re + im·i) at t = 0, and the antiderivative of the script from there."""
    import sympy

    t = sympy.Symbol("t", real=True) if symbol is None else named_symbol(symbol)
    found = run_script(script, "t", t)
    start = sympy.Rational(half_turns) * sympy.pi + sympy.Rational(radians) + sympy.atan2(im, re)
    return start + found - found.subs(t, 0)


def at_pi(f: Any) -> Any:
    """f(π)."""
    import sympy

    t = sympy.Symbol("t", real=True)
    return f.sympy(t).subs(t, sympy.pi)


def _reciprocal(f: Any) -> Any:
    """f(1/u)/u²: ∫ f(x) dx from a to b is that of it du from 1/b to 1/a, 0 not between them."""
    from ._phrame import RationalFunction

    n, d = list(f.numerator.coefficients), list(f.denominator.coefficients)
    shift = len(d) - len(n) - 2
    return RationalFunction([0] * shift + n[::-1], [0] * -shift + d[::-1])


def sympy_integral(f: Any, lower: Any, upper: Any, style: str) -> Any:
    """∫ f from lower to upper by antiderivatives, which are continuous but at real poles.

    Over those the imaginary part of a logarithm jumps, the principal value is a real part. What is beyond
    −c and c where an end is infinite is the integral of _reciprocal(f) over [−1/c, 1/c] or a half of it.
    """
    import sympy

    x = sympy.Symbol("x", real=True)

    def between(g: Any, a: Any, b: Any) -> Any:
        from ._phrame import integrate

        form = "auto" if style in ("textbook", "real") else "partial-fractions"
        found = integrate(g, style=style, form=form).sympy(x)
        return found.subs(x, b) - found.subs(x, a)

    if upper < lower:
        return -sympy_integral(f, upper, lower, style)
    finite = [int(sympy.floor(abs(end))) for end in (lower, upper) if not end.is_infinite]
    c = max(finite, default=0) + 1
    while 0 in (f.denominator(c), f.denominator(-c)):
        c += 1
    a, b = max(lower, sympy.Integer(-c)), min(upper, sympy.Integer(c))
    total = between(f, a, b)
    if lower.is_infinite or upper.is_infinite:
        low, high = (sympy.Rational(sign * end.is_infinite, c) for sign, end in ((-1, lower), (1, upper)))
        total += between(_reciprocal(f), low, high)
    return sympy.re(total) if total.has(sympy.RootSum, sympy.I) else total


def _exact(x: Any) -> Any:
    """Numbers as text that has all of them, whatever lists or arrays they are in."""
    from . import _numbers  # by NumPy

    if hasattr(x, "tolist"):
        x = x.tolist()
    if isinstance(x, (list, tuple)):
        return [_exact(item) for item in x]
    if isinstance(x, bool) or not hasattr(x, "__float__"):
        raise TypeError(f"curve: numbers are wanted in it, not {type(x).__name__}")
    return _numbers.decimal(x) if isinstance(x, int) else float(x).hex()


def _degree(k: Any) -> int:
    if isinstance(k, bool) or not hasattr(k, "__index__"):
        raise TypeError(f"curve: an int is wanted for the degree k, not {type(k).__name__}")
    return operator.index(k)


def scipy_text(curve: Any) -> str:
    """The JSON of a curve of scipy.interpolate, or of what has the same attributes."""
    if isinstance(curve, (list, tuple)):
        if len(curve) == 2 and isinstance(curve[0], (list, tuple)):  # (tck, u)
            curve = curve[0]
        if len(curve) == 3:
            t, c, k = curve
            return json.dumps([_exact(t), _exact(c), _degree(k)])
    elif any(base.__name__ == "BPoly" for base in type(curve).__mro__):
        raise TypeError("curve: a BPoly is not read; PPoly.from_bernstein_basis(curve) is")
    elif all(hasattr(curve, name) for name in ("t", "c", "k")):
        return json.dumps({"t": _exact(curve.t), "c": _exact(curve.c), "k": _degree(curve.k)})
    elif all(hasattr(curve, name) for name in ("c", "x")):
        return json.dumps({"c": _exact(curve.c), "x": _exact(curve.x)})
    raise TypeError(
        "curve: an object with t, c and k or with c and x is wanted, or (t, c, k), not "
        f"{type(curve).__name__}"
    )
