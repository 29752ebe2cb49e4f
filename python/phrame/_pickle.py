"""How objects are made again when they are read by pickle: functions of the extension have no pickles."""

from __future__ import annotations

from typing import Any

from . import _phrame


def rebuild(name: str, *arguments: Any) -> Any:
    """What the extension's function of this name makes of the arguments."""
    return getattr(_phrame, name)(*arguments)
