"""What there is on offsets and envelopes, and what they are made of when they are asked for."""

from __future__ import annotations

import json
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple, Union

if TYPE_CHECKING:
    from ._phrame import Path, Polynomial, RationalFunction, Real

    Exact = Union[Fraction, Real]

Point = Tuple[Decimal, Decimal]


class OffsetCusp(NamedTuple):
    """A zero of 1 + dκ; under a gauge, one of the speed of the offset."""

    t: Exact  #: of the path
    turns_back: bool
    point: Point  #: of the offset


class OffsetMeeting(NamedTuple):
    """Two places of an offset that are one point."""

    t: Tuple[Decimal, Decimal]  #: of the path, the earlier one first
    on_joins: Tuple[bool, bool]  #: are they on what joins the offsets at the corner there?
    point: Point
    touches: bool  #: do the branches touch there, without crossing?


class OffsetCoincidence(NamedTuple):
    """Two parts of an offset that are one set of points."""

    first: Tuple[Decimal, Decimal]  #: from t to t, the earlier one
    second: Tuple[Decimal, Decimal]  #: the same points; backwards where it goes the other way
    on_joins: Tuple[bool, bool]  #: are they on what joins the offsets at the corner there?


class OffsetStretch(NamedTuple):
    """A part of an offset between neighbouring ends and cusps where it turns back."""

    start: Exact  #: t of the path
    end: Exact
    length: Exact


class OffsetPart(NamedTuple):
    """What is left of the offset of one segment, or of what joins those at a corner; or of a side of an envelope, or an arc of it."""

    start: Exact  #: t of the path, at a corner that of the corner
    end: Exact
    start_point: Point
    end_point: Point
    kind: str  #: "offset" or "join"; of an envelope "right", "left" or "arc"
    is_cut_at_start: bool
    is_cut_at_end: bool


class OffsetBranch(NamedTuple):
    """What is left of an offset that is trimmed, as long as it goes on."""

    distance: Fraction
    is_closed: bool
    parts: Tuple[OffsetPart, ...]
    paths: Tuple[Path, ...]  #: it, in several where it turns back at a cut
    length: Exact
    area: Optional[Exact]  #: of a closed one, > 0 where it goes round to the left


class TwoSidedOffset(NamedTuple):
    """The offset of a curve that is not PH: one curve X/W, Y/W of a parameter m for both sides."""

    t: Tuple[Polynomial, Polynomial]  #: of the curve, by m: numerator and denominator; or s, where there is one
    x: Polynomial
    y: Polynomial
    weight: Polynomial
    s: Optional[RationalFunction]  #: of t, of a curve that is traced several times, as another one is by s once


class CheckedPlace(NamedTuple):
    """A place on an offset, or on what is checked."""

    t: Decimal
    point: Point


class CheckedStretch(NamedTuple):
    """A stretch that is not within the tolerance, or, where that is not proved, may not be."""

    start: CheckedPlace
    end: CheckedPlace
    farthest: CheckedPlace
    distance: Fraction  #: at least that there
    is_proved: bool


class CheckedSide(NamedTuple):
    """From all points of one to the nearest ones of the other."""

    distance: Tuple[Fraction, Fraction]  #: bounds of the greatest of these
    farthest: CheckedPlace
    stretches: Tuple[CheckedStretch, ...]  #: those that are farthest, at most a hundred
    number: int  #: of these


class EnvelopeBranch(NamedTuple):
    """A loop of the boundary of a union of discs."""

    is_closed: bool
    parts: Tuple[OffsetPart, ...]
    paths: Tuple[Path, ...]


class EnvelopeSegment(NamedTuple):
    """A curve with radii, x′ = f(u² + v² − p² − q²), y′ = 2f(up − vq), r′ = 2f(uv − pq)."""

    degree: int
    preimage: Tuple[Polynomial, Polynomial, Polynomial, Polynomial]
    multiplier: Polynomial
    null_factors: Tuple[Polynomial, Polynomial, Polynomial, Polynomial]  #: a, b, c, d
    sigma: Polynomial
    lightlike: Tuple[Exact, ...]  #: t where σ = 0, and both sides touch one point of the disc
    right: Optional[Path]  #: None where it is one point
    left: Optional[Path]


def axis_file(axis: Any) -> str:
    """An mph/1 file as text: of a file, a dict with what is in one, or rows x, y, r, the control points of one curve, or a list of such."""
    from ._ask import _json

    given = _json(axis, "axis", is_file=True)
    if isinstance(given, str):
        return given
    if isinstance(given, dict):
        return json.dumps(given)
    if not isinstance(given, list):
        raise TypeError(f"axis: a file, a dict or rows of x, y, r are wanted, not {type(axis).__name__}")
    curves = given if _depth(given) == 3 else [given]
    return json.dumps({"phrame": "mph/1", "segments": [{"control_points": rows} for rows in curves]})


def _depth(x: Any) -> int:
    return 1 + _depth(x[0]) if isinstance(x, list) and x else 0
