"""How objects are made again when they are read by pickle: functions of the extension have no pickles."""

from __future__ import annotations

from types import BuiltinFunctionType
from typing import Any, Dict, Tuple

from . import _phrame


def rebuild(name: str, *arguments: Any) -> Any:
    """What the extension's function of this name makes of the arguments."""
    return getattr(_phrame, name)(*arguments)


def component(thing: Any, method: str, at: Any, k: int, *more: Any) -> Any:
    """One number of a vector that a method answers."""
    return getattr(thing, method)(at, *more)[k]


def extreme(thing: Any, axis: int, end: int) -> Any:
    """One number of the box around a path."""
    return thing.bounding_box[axis][end]


def element(thing: Any, attribute: str, k: int) -> Any:
    """One of those that an object has."""
    return getattr(thing, attribute)[k]


def within(thing: Any, *way: Any) -> Any:
    """What lies in it by names and numbers, one after the other."""
    for step in way:
        thing = getattr(thing, step) if isinstance(step, str) else thing[step]
    return thing


def kept_offset(given: Any) -> Any:
    """A path, or numbers, as they are now, or a list of such."""
    if isinstance(given, _phrame.Path):
        return given
    if isinstance(given, (list, tuple)):
        return tuple(kept_offset(x) if isinstance(x, (list, tuple, _phrame.Path)) or hasattr(x, "dtype") else x for x in given)
    return kept(given)


def kept(numbers: Any) -> Any:
    """Numbers, or rows of them, as they are now: a list or an array may change later."""
    if hasattr(numbers, "copy") and hasattr(numbers, "dtype"):
        return numbers.copy()
    return tuple(kept(x) if isinstance(x, (list, tuple)) or hasattr(x, "dtype") else x for x in numbers)


_by_identity: Any = object.__eq__


def same(a: Any, b: Any) -> bool:
    """Are these, what numbers are pickled by, the same all the way down? Then the numbers are equal."""
    try:
        return _same(a, b, {})
    except Exception:  # too deep, or of objects that are not compared
        return False


def _same(a: Any, b: Any, seen: Dict[Tuple[int, int], Tuple[Any, Any]]) -> bool:
    if a is b or (id(a), id(b)) in seen:
        return True
    seen[id(a), id(b)] = a, b  # found equal, or all is over; kept, so that no other gets its id
    if isinstance(a, (tuple, list)) and isinstance(b, (tuple, list)):
        return len(a) == len(b) and all(_same(x, y, seen) for x, y in zip(a, b))
    if isinstance(a, str) and a == b:
        return True
    if type(a) is not type(b) or isinstance(a, str):  # 0.5, Fraction(1, 2) and "1/2" are one number
        number = rebuild("_exact", a)
        return number is not None and bool(number == rebuild("_exact", b))
    if isinstance(a, BuiltinFunctionType):
        return False
    if isinstance(a, dict):
        return list(a) == list(b) and _same(list(a.values()), list(b.values()), seen)
    if hasattr(a, "dtype"):
        return bool(a.dtype == b.dtype and a.shape == b.shape and (a == b).all())
    if type(a).__eq__ is not _by_identity and not isinstance(a, _phrame.Real):
        return bool(a == b)
    return _same(a.__reduce__(), b.__reduce__(), seen)
