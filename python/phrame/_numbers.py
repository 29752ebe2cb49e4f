"""What other packages have for a number, and for many: units, masks and names of columns are seen, not dropped."""

from __future__ import annotations

import operator
from fractions import Fraction
from typing import Any, NoReturn, Optional, Sequence, Tuple

import numpy as np

from ._errors import InputError

_MOST_BITS = 400_000  # of an exponent: 10**100000, the greatest that is taken as text, has 332193

# The angles that units stand for: of π, or of 1 radian.
_OF_PI = {
    **dict.fromkeys(("deg", "degree", "degrees", "°"), Fraction(1, 180)),
    **dict.fromkeys(("arcmin", "arcminute", "minute of arc"), Fraction(1, 180 * 60)),
    **dict.fromkeys(("arcsec", "arcsecond", "second of arc"), Fraction(1, 180 * 3600)),
    **dict.fromkeys(("mas", "milliarcsecond"), Fraction(1, 180 * 3600 * 1000)),
    **dict.fromkeys(("turn", "cycle", "cy", "revolution"), Fraction(2)),
    **dict.fromkeys(("grad", "grade", "gon", "gradian"), Fraction(1, 200)),
    **dict.fromkeys(("hourangle",), Fraction(1, 12)),
}
_OF_RADIAN = {
    **dict.fromkeys(("rad", "radian", "radians"), Fraction(1)),
    **dict.fromkeys(("mrad", "milliradian"), Fraction(1, 1000)),
    **dict.fromkeys(("urad", "µrad", "μrad", "microradian"), Fraction(1, 1_000_000)),
}
_NO_UNIT = ("", "dimensionless", "1")  # of pint, astropy, unyt and quantities


def _refuse(place: str, reason: str, value: Any) -> NoReturn:
    raise InputError(f"{place}: {reason}", place, reason, value)


def _attribute(x: Any, name: str) -> Any:
    """x.name, which for classes that forward what they do not know may raise anything."""
    try:
        return getattr(x, name, None)
    except Exception:
        return None


def _magnitude(x: Any) -> Any:
    """Of a quantity, the number or array in its unit."""
    for name in ("magnitude", "value"):  # pint and quantities; astropy and unyt
        found = _attribute(x, name)
        if found is not None and not callable(found):
            return found
    return None


def _unit(x: Any) -> Optional[str]:
    """The name of its unit, where x is a quantity."""
    for name in ("units", "unit"):
        unit = _attribute(x, name)
        if unit is not None and not callable(unit) and _magnitude(x) is not None:
            return str(unit).strip().removeprefix("1.0 ")  # of the package quantities, "1.0 deg"
    return None


def _plain(x: Any, place: str) -> Any:
    """The number or array that a quantity without a unit is, and all else as it is."""
    unit = _unit(x)
    if unit is None:
        return x
    if unit not in _NO_UNIT:
        _refuse(place, f"its unit is {unit}, and plain numbers are wanted, all in one unit: as its {_named(x)}", x)
    return _magnitude(x)


def _named(x: Any) -> str:
    return "magnitude" if _attribute(x, "magnitude") is not None else "value"


def angle(x: Any, place: str) -> Tuple[Any, Fraction, bool]:
    """(number, factor, is it of π?) for an angle: number·factor·π or number·factor radians."""
    unit = _unit(x)
    if unit is None or unit in _NO_UNIT:
        return x, Fraction(1), False
    if unit in _OF_PI:
        return _magnitude(x), _OF_PI[unit], True
    if unit in _OF_RADIAN:
        return _magnitude(x), _OF_RADIAN[unit], False
    _refuse(place, f"its unit, {unit}, is none of an angle that is known", x)


def _dyadic(mantissa: Any, exponent: Any, x: Any, place: str) -> Tuple[int, int]:
    n, e = operator.index(mantissa), operator.index(exponent)
    if abs(e) > _MOST_BITS:
        _refuse(place, f"its exponent is beyond {_MOST_BITS} bits", x)
    return (n << e, 1) if e >= 0 else (n, 1 << -e)


def _binary(x: Any, place: str) -> Optional[Tuple[int, int]]:
    """Of mpmath's and SymPy's floating-point numbers, of gmpy2's, and of python-flint's balls that are points."""
    for method in ("as_mantissa_exp", "man_exp"):  # of mpmath the latter is no method
        of = _attribute(x, method)
        if callable(of):
            if not getattr(x, "is_exact", lambda: True)():
                _refuse(place, f"it is known up to a radius only: {x}", x)
            if not getattr(x, "is_finite", lambda: True)():
                _refuse(place, f"not a finite number: {x}", x)
            mantissa, exponent = of()
            return _dyadic(mantissa, exponent, x, place)
    parts = _attribute(x, "_mpf_")
    if isinstance(parts, tuple) and len(parts) == 4:
        sign, mantissa, exponent, _ = parts  # the mantissa has no sign
        if not mantissa and exponent:
            _refuse(place, f"not a finite number: {x}", x)
        return _dyadic(-mantissa if sign else mantissa, exponent, x, place)
    return None


def _quotient(x: Any) -> Optional[Tuple[int, int]]:
    for names in (("numerator", "denominator"), ("p", "q")):
        pair = [_attribute(x, name) for name in names]
        if all(hasattr(part, "__index__") or hasattr(part, "__int__") for part in pair):
            n, d = pair
            return (operator.index(n), operator.index(d)) if hasattr(n, "__index__") else (int(n), int(d))
    return None


def decimal(n: int) -> str:
    """Its decimal digits, however many: of more than some 4000 Python itself makes none."""
    parts, rest = [], abs(n)
    while rest >= 10**3000:
        rest, low = divmod(rest, 10**3000)
        parts.append(f"{low:03000d}")
    return "-" * (n < 0) + str(rest) + "".join(reversed(parts))


def number(x: Any, place: str) -> Any:
    """What x is: a pair (numerator, denominator), or another number; None where it is none."""
    x = _plain(x, place)
    if _attribute(x, "mask") is not None and not callable(x.mask):
        if bool(x.mask):
            _refuse(place, "it is masked", x)
        x = x.unmasked if hasattr(x, "unmasked") else x.data
    if isinstance(x, np.generic):
        if x.dtype.kind not in "iuf":  # a truth value, a time, a complex number
            return None
    elif isinstance(x, np.ndarray):
        return x[()] if x.ndim == 0 else None
    elif getattr(x, "ndim", None) == 0 and hasattr(x, "item"):  # a tensor of one number
        return x.item()
    if hasattr(x, "as_py"):  # a scalar of pyarrow
        return x.as_py()
    found = _binary(x, place)
    if found is not None:
        return found
    if hasattr(x, "__index__"):
        try:
            return operator.index(x), 1
        except TypeError:  # an array
            return None
    if hasattr(x, "as_integer_ratio"):
        try:
            n, d = x.as_integer_ratio()
        except (ValueError, OverflowError):
            _refuse(place, f"not a finite number: {x}", x)
        return operator.index(n), operator.index(d)
    return _quotient(x)


def _columns(x: Any) -> Optional[Sequence[Any]]:
    """The names of the columns of a table: of pandas, polars, pyarrow, xarray, or a structured array."""
    if hasattr(x, "dtype"):
        names = getattr(x.dtype, "names", None)
        return None if names is None else list(names)
    if hasattr(x, "data_vars"):
        return list(x.data_vars)
    for name in ("column_names", "columns"):
        names = _attribute(x, name)
        if names is not None and not callable(names) and len(getattr(x, "shape", ())) == 2:
            return list(names)
    return None


def _column(x: Any, name: Any) -> Any:
    column = x[name]
    return column.to_pylist() if hasattr(column, "to_pylist") else column.values if hasattr(column, "dims") else column


def _by_label(x: Any, known: Sequence[str]) -> Any:
    """An array of xarray that has the known names along one of its two axes, with these as columns."""
    dims = _attribute(x, "dims")
    if dims is None or not hasattr(x, "sel") or len(dims) != 2:
        return x
    for dim, other in (dims, dims[::-1]):
        if dim in x.coords and sorted(map(str, x.coords[dim].values)) == sorted(known):
            return x.transpose(other, dim).sel({dim: list(known)}).values
    return x


def _unmasked(x: Any, place: str) -> Any:
    """An array of which nothing is masked, as a plain one."""
    mask = _attribute(x, "mask")
    if mask is None or callable(mask):
        return x
    if mask.dtype.names is not None:
        mask = np.stack([mask[name] for name in mask.dtype.names], axis=-1)
    masked = np.argwhere(mask)
    if len(masked):
        _refuse(place + "".join(f"[{k}]" for k in masked[0]), "it is masked", x)
    return x.unmasked if hasattr(x, "unmasked") else x.data


def _array(x: Any, place: str) -> Any:
    """An array or a tensor of another package as one of NumPy, exactly; all else, and columns of tables, as it is."""
    if not isinstance(x, np.ndarray):
        if hasattr(x, "to_list") or not (hasattr(x, "__array__") or hasattr(x, "__dlpack__")):
            return x
        found: Any = None
        # Of what has no memory that NumPy reads (a GPU's, a gradient's) or a dtype that it does not know, the list.
        for read in (np.asarray, getattr(np, "from_dlpack", np.asarray), lambda x: x.tolist()):
            try:
                found = read(x)
            except Exception as error:
                problem = error
            else:
                if not isinstance(found, np.ndarray) or found.ndim:
                    break
        else:
            _refuse(place, f"a {type(x).__name__} that NumPy cannot read: {str(problem)[:200]}", x)
        if not isinstance(found, np.ndarray):
            return found
        x = found
    if x.dtype.kind == "V" and x.dtype.names is None:  # bfloat16 and the like, all of which are doubles
        try:
            return x.astype(np.float64)
        except (TypeError, ValueError):
            _refuse(place, f"its dtype {x.dtype} is none of numbers", x)
    return x.view(np.ndarray)  # of a class of its own, too


def _shown(names: Sequence[Any]) -> str:
    return ", ".join(str(name) for name in names[:9]) + (", …" if len(names) > 9 else "")


def numbers(x: Any, place: str) -> Any:
    """A list, or what can be read like one: an array, a column, a table of one column."""
    x = _unmasked(_plain(x, place), place)
    names = _columns(x)
    if names is not None:
        if len(names) != 1:
            _refuse(place, f"a list of numbers is wanted, not a table with the columns {_shown(names)}", x)
        return list(_column(x, names[0]))
    return _array(x, place)


def rows(x: Any, place: str, known: Sequence[str]) -> Any:
    """Rows of numbers. The columns of a table are taken by name, where they have the known ones, else in their order."""
    x = _by_label(_unmasked(_plain(x, place), place), known)
    names = _columns(x)
    if names is None:
        return _array(x, place)
    if len(names) == 2 and list(known) == ["x", "y", "z"]:  # of a plane, z = 0
        known = known[:2]
    found = {str(name).strip().lower(): name for name in names}
    if len(names) != len(known) or len(found) != len(names) or (set(found) != set(known) and set(found) & set(known)):
        _refuse(place, f"the columns {', '.join(known)} are wanted, not {_shown(names)}", x)
    order = [found[name] for name in known] if set(found) == set(known) else names
    return list(zip(*(_column(x, name) for name in order)))
