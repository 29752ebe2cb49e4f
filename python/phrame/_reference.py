"""The reference collection that is installed with the package: docs/reference.md."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from pathlib import Path as File
from typing import TYPE_CHECKING, Any, Dict, List, Optional

from . import _phrame
from ._errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_FOLDER = File(__file__).parent / "reference"


@dataclass(frozen=True)
class ReferenceCurve:
    """A curve of the reference collection with its values."""

    name: str
    group: str
    json: str  #: its line of the collection, as parse() reads it

    def __copy__(self) -> ReferenceCurve:
        return self

    def __deepcopy__(self, memo: Dict[int, Any]) -> ReferenceCurve:
        return self

    @property
    def expected(self) -> Dict[str, Any]:
        """The values: decimals with 50 digits, as texts."""
        values: Dict[str, Any] = json.loads(self.json)["expected"]
        return values

    @property
    def path(self) -> _phrame.Path:
        """The curve, exactly."""
        return _phrame.parse(self.json)

    @property
    def at(self) -> List[Fraction]:
        """The t of the values."""
        return [Fraction(t) for t in self.expected["at"]]

    @property
    def frames(self) -> NDArray[np.float64]:
        """(n, 4, 3): r, e1, f2, f3 at these t, the doubles nearest to the exact numbers."""
        import numpy as np  # when it is wanted: the package is imported, for its stub, where NumPy is not

        rows = [[float(x) for x in row] for row in self.expected["frames"]]
        return np.array(rows).reshape(-1, 4, 3)


@lru_cache(maxsize=None)
def _groups() -> Dict[str, List[ReferenceCurve]]:
    groups: Dict[str, List[ReferenceCurve]] = {}
    for file in sorted(_FOLDER.glob("*.jsonl"), key=lambda file: file.stem):
        lines = file.read_text(encoding="utf-8").splitlines()
        groups[file.stem] = [ReferenceCurve(json.loads(line)["name"], file.stem, line) for line in lines]
    return groups


def reference(group: Optional[str] = None) -> List[ReferenceCurve]:
    """The curves of the reference collection, or of one group of it, such as "near-cusp"."""
    groups = _groups()
    if group is None:
        return [curve for curves in groups.values() for curve in curves]
    if group not in groups:
        reason = f"{group!r} is not one of {', '.join(groups)}"
        raise InputError(f"group: {reason}", "group", reason, group)
    return list(groups[group])
