"""What Real has by what it has: remainders, rounding to places, format()."""

from __future__ import annotations

import math
import re
from decimal import Decimal
from fractions import Fraction
from typing import Any, Optional, Tuple, Union

from ._convert import count

_SPEC = re.compile(r"((?:.?[<>=^])?[-+ ]?z?#?0?\d*[,_]?)(?:\.(\d+))?([eEfFgGn%]?)", re.DOTALL)


def floordiv(x: Any, y: Any) -> Any:
    """x // y"""
    try:
        quotient = x / y
    except TypeError:
        return NotImplemented
    return math.floor(quotient) if hasattr(quotient, "__floor__") else NotImplemented


def rfloordiv(x: Any, y: Any) -> Any:
    return floordiv(y, x)


def divmod(x: Any, y: Any) -> Any:  # noqa: A001
    """divmod(x, y)"""
    whole = floordiv(x, y)
    return whole if whole is NotImplemented else (whole, x - whole * y)


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
    head, precision, kind = found.groups()
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
