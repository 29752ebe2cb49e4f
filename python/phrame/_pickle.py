"""How objects are made again when they are read by pickle: functions of the extension have no pickles."""

from __future__ import annotations

from typing import Any

from . import _phrame


def rebuild(name: str, *arguments: Any) -> Any:
    """What the extension's function of this name makes of the arguments."""
    return getattr(_phrame, name)(*arguments)


def component(thing: Any, method: str, at: Any, k: int) -> Any:
    """One number of a vector that a method answers."""
    return getattr(thing, method)(at)[k]


def element(thing: Any, attribute: str, k: int) -> Any:
    """One of those that an object has."""
    return getattr(thing, attribute)[k]


def kept(numbers: Any) -> Any:
    """Numbers, or rows of them, as they are now: a list or an array may change later."""
    if hasattr(numbers, "copy") and hasattr(numbers, "dtype"):
        return numbers.copy()
    return tuple(kept(x) if isinstance(x, (list, tuple)) or hasattr(x, "dtype") else x for x in numbers)
