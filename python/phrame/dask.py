"""Many curves and many parameters on a Dask cluster: docs/python.md.

A question is pickled with what it refers to: a function of a module, or a lambda where the workers have
cloudpickle, as those of dask.distributed do. Answers depend on their curve alone, so that what is computed
again after a worker was lost is the same.
"""

from __future__ import annotations

from typing import Any, Callable, Iterable, Optional, Tuple, Union

import dask.array
import dask.bag
import numpy as np

from ._errors import InputError
from ._map import answers, curve_of, refuse_column, refuse_count, refuse_curves, refuse_errors, refuse_question
from ._phrame import Angle, Path

__all__ = ["angles", "frames", "map", "matrices", "points", "quaternions"]


def map(
    curves: Union[Iterable[Any], Any],
    question: Callable[[Any], Any],
    *,
    partitions: Optional[int] = None,
    errors: str = "raise",
    column: str = "curve",
) -> Any:
    """A dask.bag.Bag of question(curve), in the order of the curves, which are a Bag or any iterable.

    Of a DataFrame of Dask it is a Series with its index: of the column that has curves, or texts of curve files;
    of a Series of these likewise.
    """
    refuse_errors(errors)
    refuse_count(partitions, "partitions")
    refuse_question(question)
    refuse_column(column)
    if hasattr(curves, "to_dask_array"):
        table: Any = curves
        series = table[column] if table.ndim == 2 else table
        name = getattr(question, "__name__", "answer")
        return series.map_partitions(_of_series, question, errors, name, meta=(name, object))
    if isinstance(curves, dask.bag.Bag):
        bag: Any = curves
    else:
        refuse_curves(curves)
        make: Any = dask.bag.from_sequence
        bag = make(curves, npartitions=partitions)
    return bag.map_partitions(answers, question, errors)


def _of_series(curves: Any, question: Callable[[Any], Any], errors: str, name: str) -> Any:
    found = np.empty(len(curves), dtype=object)
    found[:] = answers(curves, lambda x: question(curve_of(x)), errors)
    return type(curves)(found, index=curves.index, name=name, dtype=object)


def _of_block(ts: Any, thing: Any, method: str, options: Any) -> Any:
    return getattr(thing, method)(ts, **options)


def _parameters(ts: Any) -> Any:
    """ts in blocks."""
    if hasattr(ts, "to_dask_array"):  # a column of a DataFrame
        ts = ts.to_dask_array(lengths=True)
    if not isinstance(ts, dask.array.Array):
        if isinstance(ts, (str, bytes)) or not hasattr(ts, "__len__") or not hasattr(ts, "__getitem__"):
            raise TypeError(f"ts: a list of parameters is wanted, not {type(ts).__name__}")
        make: Any = dask.array.from_array
        found = np.array(ts, dtype=None if hasattr(ts, "dtype") else object)
        ts = make(found, chunks=100_000 if found.dtype == object else "auto")
    if ts.ndim != 1:
        reason = f"one dimension is wanted, there are {ts.ndim}"
        raise InputError(f"ts: {reason}", "ts", reason, ts)
    return ts


def _blocks(thing: Any, method: str, ts: Any, shape: Tuple[int, ...], options: Any) -> Any:
    kind, place = (Angle, "angle") if method == "__call__" else (Path, "path")
    if not isinstance(thing, kind):
        raise TypeError(f"{place}: {'an angle' if place == 'angle' else 'a path'} is wanted, not {type(thing).__name__}")
    ts = _parameters(ts)
    return ts.map_blocks(
        _of_block,
        thing,
        method,
        options,
        dtype=np.float64,
        chunks=ts.chunks + tuple((n,) for n in shape),
        new_axis=[k + 1 for k in range(len(shape))] or None,
        meta=np.empty((0,) * (1 + len(shape))),
    )


def frames(path: Path, ts: Any, **options: Any) -> Any:
    """path.frames(ts) as a dask.array.Array (n, 3, 3), block by block of ts."""
    return _blocks(path, "frames", ts, (3, 3), options)


def matrices(path: Path, ts: Any, **options: Any) -> Any:
    """path.matrices(ts): (n, 4, 4)."""
    return _blocks(path, "matrices", ts, (4, 4), options)


def quaternions(path: Path, ts: Any, **options: Any) -> Any:
    """path.quaternions(ts): (n, 4)."""
    return _blocks(path, "quaternions", ts, (4,), options)


def points(path: Path, ts: Any, **options: Any) -> Any:
    """path.points(ts): (n, 3)."""
    return _blocks(path, "points", ts, (3,), options)


def angles(angle: Angle, ts: Any) -> Any:
    """angle(ts): (n,)."""
    return _blocks(angle, "__call__", ts, (), {})
