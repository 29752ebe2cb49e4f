"""What is taken for numbers, parameters and vectors."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Sequence, SupportsIndex, Union

if TYPE_CHECKING:
    import numpy

    Number = Union[int, Fraction, Decimal, str, float, numpy.floating[Any], SupportsIndex]
    Array = numpy.ndarray[Any, Any]
else:
    Number = Union[int, Fraction, Decimal, str, float, SupportsIndex]
    Array = Any

Numbers = Union[Sequence[Number], Array]
Vector = Union[Sequence[Number], Array]
Vectors = Union[Sequence[Vector], Array]
