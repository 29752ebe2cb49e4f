"""Exact rotation-minimizing frames of Pythagorean-hodograph curves.

>>> import phrame
>>> curve = phrame.Curve([2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2])
>>> curve.angle().value(1, digits=20)
Decimal('0.28585653009834106200')
"""

from __future__ import annotations

import numbers
from collections.abc import Sequence
from importlib import import_module
from typing import Any

from . import _signatures
from ._ask import ask
from ._errors import DomainError, Error, InputError, Undecided
from ._map import map
from ._phrame import (
    Angle,
    Certificate,
    CheckResult,
    Classification,
    Envelope,
    Gauge,
    Integral,
    MinimalTwist,
    Offset,
    OffsetCheck,
    Path,
    PathTwist,
    Polynomial,
    RationalFunction,
    RationalTwist,
    RationalTwistPiece,
    Real,
    SweptBody,
    digits,
    envelope,
    integrate,
    parse,
    read,
    root,
    sweep,
)
from ._phrame import version as __version__
from ._reference import ReferenceCurve, reference
from ._threads import set_threads, set_time_limit

numbers.Real.register(Real)
Sequence.register(Offset)
Sequence.register(Envelope)

Curve = Path  # what a path of one segment is called, too

__all__ = [
    "Angle",
    "Certificate",
    "CheckResult",
    "Classification",
    "Curve",
    "DomainError",
    "Envelope",
    "Error",
    "Gauge",
    "InputError",
    "Integral",
    "MinimalTwist",
    "Offset",
    "OffsetCheck",
    "Path",
    "PathTwist",
    "Polynomial",
    "RationalFunction",
    "RationalTwist",
    "RationalTwistPiece",
    "Real",
    "ReferenceCurve",
    "SweptBody",
    "Undecided",
    "__version__",
    "ask",
    "digits",
    "envelope",
    "integrate",
    "map",
    "parse",
    "read",
    "reference",
    "root",
    "set_threads",
    "set_time_limit",
    "sweep",
]

_signatures.install()

# What needs other packages, and is imported when it is named.
_BRIDGES = ("dask", "spark", "sympy")


def __getattr__(name: str) -> Any:
    if name in _BRIDGES:
        return import_module("." + name, __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
