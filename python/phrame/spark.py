"""Many curves on a Spark cluster: docs/cluster.md.

A question is pickled with what it refers to, lambdas too; phrame must be installed where the executors' Python
is. Answers depend on their curve alone, so that what is computed again after an executor was lost is the same.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any, Callable, Iterable, Iterator, List

from ._errors import Error, InputError
from ._map import answers, curve_of, refuse_column, refuse_errors, refuse_question

__all__ = ["map"]


def _name_and_type(returns: Any) -> List[str]:
    if not isinstance(returns, str):
        raise TypeError(f"returns: a str is wanted, not {type(returns).__name__}")
    words = returns.split(None, 1)
    if len(words) != 2:
        reason = f'a name and a type are wanted, as in "length double", not "{returns[:40]}"'
        raise InputError(f"returns: {reason}", "returns", reason, returns)
    return words


def _answer(text: Any, question: Callable[[Any], Any], errors: str) -> Any:
    """Of one row; null where there is no curve, and where there is no answer, unless that is raised."""
    if text is None:
        return None
    (found,) = answers([text], lambda x: question(curve_of(x)), errors)
    return None if isinstance(found, Error) else found


def map(
    curves: Any, question: Callable[[Any], Any], *, errors: str = "raise", column: str = "curve", returns: str = "answer string"
) -> Any:
    """An RDD of question(curve), in the order of the RDD `curves`: of curves, or of lines with a curve file each.

    With errors="return" a curve without an answer, or a line without a curve, gives its phrame.Error in its place;
    else Spark tries its partition again, in vain, and raises.

    Of a DataFrame it is the DataFrame with one column more. `column` is the one that has curve files, as text, and
    `returns` is the name and the type, of Spark, of what the question answers: "length double". With errors="return"
    it is null where there is no answer.
    """
    refuse_errors(errors)
    refuse_question(question)
    refuse_column(column)
    if hasattr(curves, "withColumn"):
        name, type_ = _name_and_type(returns)
        udf: Any = import_module("pyspark.sql.functions").udf
        return curves.withColumn(name, udf(lambda text: _answer(text, question, errors), type_)(curves[column]))
    if not hasattr(curves, "mapPartitions"):
        raise TypeError(f"curves: an RDD is wanted, not {type(curves).__name__}")

    def of_partition(part: Iterable[Any]) -> Iterator[Any]:
        for one in part:
            yield from answers([one], lambda x: question(curve_of(x)), errors)

    return curves.mapPartitions(of_partition)
