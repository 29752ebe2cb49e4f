"""One question about many curves."""

from __future__ import annotations

import itertools
from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from threading import Event
from typing import Callable, Deque, Iterable, Iterator, List, Literal, Optional, TypeVar, Union, overload

from ._convert import count
from ._errors import Error, InputError
from ._phrame import Path, parse
from ._threads import limit

C = TypeVar("C")
A = TypeVar("A")

_CHUNK = 16  # curves that a thread takes at a time


def refuse_errors(errors: str) -> None:
    if not isinstance(errors, str):
        raise TypeError(f"errors: a str is wanted, not {type(errors).__name__}")
    if errors not in ("raise", "return"):
        reason = f'"{errors}" is not one of raise, return'
        raise InputError(f"errors: {reason}", "errors", reason, errors)


def refuse_count(n: Optional[int], place: str) -> None:
    if n is not None:
        count(n, place, 1_000_000)


def refuse_curves(curves: object) -> None:
    if isinstance(curves, (str, bytes)) or not hasattr(curves, "__iter__"):
        raise TypeError(f"curves: paths are wanted, not {type(curves).__name__}")


def refuse_question(question: object) -> None:
    if not callable(question):
        raise TypeError(f"question: a callable is wanted, not {type(question).__name__}")


def curve_of(x: Union[str, Path]) -> Path:
    """The curve of a line with a curve file, or itself."""
    return parse(x) if isinstance(x, str) else x


def refuse_column(column: object) -> None:
    if not isinstance(column, str):
        raise TypeError(f"column: a str is wanted, not {type(column).__name__}")


def answers(curves: Iterable[C], question: Callable[[C], A], errors: str = "raise") -> List[Union[A, Error]]:
    """One after the other."""
    found: List[Union[A, Error]] = []
    for curve in curves:
        try:
            found.append(question(curve))
        except Error as error:
            if errors == "raise":
                raise
            found.append(error)
    return found


@overload
def map(
    curves: Iterable[C], question: Callable[[C], A], *, threads: Optional[int] = None, errors: Literal["raise"] = "raise"
) -> Iterator[A]: ...
@overload
def map(
    curves: Iterable[C], question: Callable[[C], A], *, threads: Optional[int] = None, errors: str
) -> Iterator[Union[A, Error]]: ...
def map(
    curves: Iterable[C], question: Callable[[C], A], *, threads: Optional[int] = None, errors: str = "raise"
) -> Iterator[Union[A, Error]]:
    """question(curve) for each of the curves, in their order, by threads (default: as many as set_threads() says, one a core).

    The curves are read as they are needed, and what has been answered is not kept. With errors="return" a
    curve that the question has no answer for gives its phrame.Error in its place; else the first one is raised.

    >>> import phrame
    >>> curves = [phrame.Curve([1, k], [0, 1], [2, 0], [1, 1]) for k in range(3)]
    >>> [float(length) for length in phrame.map(curves, lambda curve: curve.length)]
    [7.666666666666667, 9.0, 11.0]
    """
    refuse_errors(errors)
    refuse_count(threads, "threads")
    refuse_curves(curves)
    refuse_question(question)
    return _map(iter(curves), question, threads or limit(), errors)


def _map(curves: Iterator[C], question: Callable[[C], A], threads: int, errors: str) -> Iterator[Union[A, Error]]:
    waiting: Deque[Future[List[Union[A, Error]]]] = deque()
    stopped = Event()

    def ask(chunk: List[C]) -> List[Union[A, Error]]:
        return answers(itertools.takewhile(lambda curve: not stopped.is_set(), chunk), question, "return")

    pool = ThreadPoolExecutor(threads)
    try:
        while True:
            chunk = list(itertools.islice(curves, _CHUNK))
            if chunk:
                waiting.append(pool.submit(ask, chunk))
            if waiting and (not chunk or len(waiting) > 4 * threads):
                for answer in waiting.popleft().result():
                    if errors == "raise" and isinstance(answer, Error):
                        raise answer
                    yield answer
            elif not chunk:
                return
    finally:
        stopped.set()
        pool.shutdown(wait=False, cancel_futures=True)
