"""How many threads work at once, and how long."""

from __future__ import annotations

import os
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from pathlib import Path
from typing import List, Optional

from ._convert import count
from ._errors import InputError

_MOST = 1_000_000
_limit: Optional[int] = None
_seconds: Optional[float] = None


def _quota(numbers: List[str]) -> float:
    """Of a group of processes: cores, from what it may use in which time."""
    if len(numbers) != 2 or not numbers[0].isdigit() or not numbers[1].isdigit() or int(numbers[1]) == 0:
        return float("inf")  # "max", −1
    return int(numbers[0]) / int(numbers[1])


def _words(*files: Path) -> List[str]:
    try:
        return [word for file in files for word in file.read_text(encoding="ascii").split()]
    except (OSError, ValueError):
        return []


@lru_cache(maxsize=None)
def _cores_of_group(root: str = "/") -> float:
    """What Linux lets this group of processes, and those around it, use: a container's --cpus."""
    least = float("inf")
    top = Path(root, "sys/fs/cgroup")
    for line in _words(Path(root, "proc/self/cgroup")):
        _, controllers, path = (line.split(":", 2) + ["", ""])[:3]
        if "cpu" not in controllers.split(",") and controllers:
            continue
        for base in (top, top / controllers):
            group = base / path.lstrip("/")
            for place in (group, *group.parents):
                if place == base.parent:
                    break
                least = min(least, _quota(_words(place / "cpu.max")))
                least = min(least, _quota(_words(place / "cpu.cfs_quota_us", place / "cpu.cfs_period_us")))
    return least


def limit() -> int:
    """That of set_threads(), else of PHRAME_THREADS, else the cores that this process may use."""
    if _limit is not None:
        return _limit
    given = os.environ.get("PHRAME_THREADS", "")
    if given:
        if not (given.isascii() and given.isdigit() and 1 <= int(given[:9]) <= _MOST):
            reason = f'"{given[:40]}" is no number from 1 on'
            raise InputError(f"PHRAME_THREADS: {reason}", "PHRAME_THREADS", reason, given)
        return int(given)
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return max(1, int(min(cores, -(-_cores_of_group() // 1))))


def time_limit() -> Optional[float]:
    """That of set_time_limit()."""
    return _seconds


def set_time_limit(seconds: Optional[float]) -> None:
    """So many seconds may be computed for each call from now on, in all threads; what has no answer by then raises Undecided.

    None, as at the start, is as long as it takes. Numbers as `Real` are computed, too, when their digits are asked for. What was computed
    is kept; some memory of what was interrupted may be lost.
    """
    global _seconds
    if seconds is not None and (isinstance(seconds, bool) or not isinstance(seconds, (int, float, Fraction, Decimal))):
        raise TypeError(f"seconds: a number is wanted, not {type(seconds).__name__}")
    is_nan = isinstance(seconds, Decimal) and seconds.is_nan()  # which is not compared
    if seconds is not None and (is_nan or not 0 < seconds < float("inf")):
        reason = f"{str(seconds)[:40]} is no time above 0"
        raise InputError(f"seconds: {reason}", "seconds", reason, seconds)
    _seconds = None if seconds is None else float(min(seconds, 10**9))


def set_threads(n: Optional[int]) -> None:
    """So many threads may work at once in this process, of arrays and of phrame.map.

    None, as at the start, is as many as PHRAME_THREADS says, else one for each core that the process may use: of
    its affinity, and of the quota of a container.
    """
    global _limit
    _limit = None if n is None else count(n, "n", _MOST)
