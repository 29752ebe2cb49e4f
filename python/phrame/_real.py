"""What Real has by what it has: remainders, rounding to places, format()."""

from __future__ import annotations

import math
import operator
import re
from decimal import Decimal
from fractions import Fraction
from typing import Any, Optional, Tuple, Union

from ._convert import count
from ._phrame import Real

_SPEC = re.compile(r"((?:.?[<>=^])?)([-+ ]?z?#?0?\d*)([,_]?)(?:\.(\d+))?([eEfFgGn%]?)", re.DOTALL)


def _float_like(x: Any) -> float:
    """Of a Real a float with the same sign, on the same side of 1 and −1, as others beside an infinity decide; others as floats."""
    if not isinstance(x, Real):
        return float(x)
    return (2.0 if abs(x) > 1 else 0.5) * (-1 if x < 0 else 1)


def beside_infinity(name: str, x: Any, y: Any) -> float:
    """x ∘ y where one of them is an infinity or NaN: as floats have it."""
    return float(getattr(operator, name)(_float_like(x), _float_like(y)))


def floordiv(x: Any, y: Any) -> Any:
    """x // y"""
    try:
        quotient = x / y
    except TypeError:
        return NotImplemented
    if isinstance(quotient, float):
        return beside_infinity("floordiv", x, y)
    return math.floor(quotient) if hasattr(quotient, "__floor__") else NotImplemented


def rfloordiv(x: Any, y: Any) -> Any:
    return floordiv(y, x)


def divmod(x: Any, y: Any) -> Any:  # noqa: A001
    """divmod(x, y)"""
    whole = floordiv(x, y)
    if whole is NotImplemented:
        return whole
    if isinstance(whole, float):
        return whole, x if whole == 0 else beside_infinity("mod", x, y)
    return whole, x - whole * y


def rdivmod(x: Any, y: Any) -> Any:
    return divmod(y, x)


def mod(x: Any, y: Any) -> Any:
    """x % y"""
    both = divmod(x, y)
    return both if both is NotImplemented else both[1]


def rmod(x: Any, y: Any) -> Any:
    return mod(y, x)


def _scaled(x: Any, places: int) -> int:
    """The integer nearest to x·10**places, the even one of two."""
    scaled = x * Fraction(10) ** places
    return round(scaled) if isinstance(scaled, Fraction) else math.floor(scaled + Fraction(1, 2))


def rounded(x: Any, ndigits: Optional[int] = None) -> Union[int, Fraction]:
    """round(x), round(x, ndigits)"""
    if ndigits is None:
        return _scaled(x, 0)
    places = int(ndigits.__index__())
    return _scaled(x, places) / Fraction(10) ** places


def formatted(x: Any, spec: str) -> str:
    """format(x, spec) as float has it, of the number itself: all digits are right."""
    if not spec:
        return str(x)
    found = _SPEC.fullmatch(spec)
    if found is None:
        raise ValueError(f"invalid format specifier {spec!r} for a Real")
    align, head, comma, precision, kind = found.groups()
    if comma == "_" and align[:-1] != ",":  # which Decimal does not know in all releases
        return formatted(x, f"{align}{head},{spec[found.end(3):]}").replace(",", "_")
    head = align + head + comma
    if precision is None and not kind:
        return format(x.digits(17), head)
    places = 6 if precision is None else int(precision)
    if places:
        count(places, "precision", 1_000_000)
    if kind in ("f", "F", "%"):
        places_kept = places + 2 if kind == "%" else places
        # What rounds to 0 keeps its sign, as elsewhere in Python.
        number = Decimal((int(x < 0), Decimal(abs(_scaled(x, places_kept))).as_tuple().digits, -places_kept))
    else:
        number = x.digits(places + 1 if kind in ("e", "E") else max(places, 1))
    return format(number, f"{head}.{places}{kind}")
