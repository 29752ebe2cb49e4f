"""Many curves on a Spark cluster: docs/cluster.md.

A question is pickled with what it refers to, lambdas too; phrame must be installed where the executors' Python
is. Answers depend on their curve alone, so that what is computed again after an executor was lost is the same.
"""

from __future__ import annotations

from typing import Any, Callable, Iterable, Iterator, Union

from ._map import answers, refuse_errors, refuse_question
from ._phrame import Path, SmoothPath, parse

__all__ = ["map"]


def _curve(x: Union[str, Path, SmoothPath]) -> Union[Path, SmoothPath]:
    return parse(x) if isinstance(x, str) else x


def map(curves: Any, question: Callable[[Any], Any], *, errors: str = "raise") -> Any:
    """An RDD of question(curve), in the order of the RDD `curves`: of curves, or of lines with a curve file each.

    With errors="return" a curve without an answer, or a line without a curve, gives its phrame.Error in its place;
    else Spark tries its partition again, in vain, and raises.
    """
    refuse_errors(errors)
    refuse_question(question)
    if not hasattr(curves, "mapPartitions"):
        raise TypeError(f"curves: an RDD is wanted, not {type(curves).__name__}")

    def of_partition(part: Iterable[Any]) -> Iterator[Any]:
        for one in part:
            yield from answers([one], lambda x: question(_curve(x)), errors)

    return curves.mapPartitions(of_partition)
