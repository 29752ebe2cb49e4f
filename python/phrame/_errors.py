"""The exceptions of phrame: three kinds under one base."""

from __future__ import annotations

from typing import Any, Tuple


class Error(Exception):
    """What every exception of phrame derives from.

    `place` is where something is wrong (an argument, "points[3]", a JSON pointer), `reason` what,
    `value` the object given, where there is one.
    """

    def __init__(self, message: str = "", place: str = "", reason: str = "", value: Any = None) -> None:
        super().__init__(message)
        self.place = place
        self.reason = reason or message
        self.value = value

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (str(self), self.place, self.reason, self.value)


class InputError(Error, ValueError):
    """What was given is not what is asked for."""


class DomainError(Error, ArithmeticError):
    """The question has no answer: a pole on the path, a Frenet frame of a straight line."""


class MissingPart(DomainError, AttributeError):
    """What this path does not have, as the preimage of one that is not PH: hasattr() says so."""


class Undecided(Error, ArithmeticError):
    """There is an answer, but a limit was reached before it was proved."""
