"""Any question of the program, by the same table of options and the same code as a line of `phrame batch`."""

from __future__ import annotations

import json
import os
import re
from fractions import Fraction
from functools import lru_cache
from typing import Any, Dict, Optional

from . import _phrame
from ._errors import InputError

_extension: Any = _phrame  # whose stub has what is public


@lru_cache(maxsize=None)
def _questions() -> Dict[str, Dict[str, Any]]:
    """What `phrame help --json` says of each option, by its key."""
    commands = json.loads(_extension._question_table())["commands"]
    return {
        command["command"]: {option["key"]: option for option in command["options"] if option["key"]}
        for command in commands
    }


def _refuse(place: str, reason: str, value: Any) -> InputError:
    return InputError(f"{place}: {reason}", place, reason, value)


def _text_of(file: Any, place: str) -> str:
    try:
        with open(file, "rb") as opened:
            return opened.read().decode()
    except ValueError:  # of the name, too
        raise _refuse(place, "a file of text is wanted", file) from None


def _json(x: Any, place: str, is_file: bool = False) -> Any:
    """Numbers exactly, as JSON has them or as texts."""
    import numpy as np  # when it is wanted: the package is imported, for its stub, where NumPy is not

    from . import _numbers

    if isinstance(x, os.PathLike) or (is_file and isinstance(x, str)):
        return _text_of(x, place)
    if isinstance(x, str):
        try:
            x.encode()
        except UnicodeEncodeError:
            raise _refuse(place, "it is no text of Unicode", x) from None
        return x
    if isinstance(x, bool):
        return x
    if isinstance(x, np.bool_):
        return bool(x)
    if isinstance(x, dict):
        return {str(key): _json(value, f"{place}[{key!r}]") for key, value in x.items()}
    if isinstance(x, (list, tuple)):
        return [_json(value, f"{place}[{k}]") for k, value in enumerate(x)]
    found = _numbers.number(x, place)
    if isinstance(found, tuple):
        exact = Fraction(*found)
        if exact.denominator == 1 and abs(exact) < 10**3000:
            return int(exact)
        return _numbers.decimal(exact.numerator) + ("" if exact.denominator == 1 else "/" + _numbers.decimal(exact.denominator))
    if found is not None:
        return _json(found, place)
    many = _numbers.numbers(x, place)
    if isinstance(many, (list, np.ndarray)):
        return [_json(value, f"{place}[{k}]") for k, value in enumerate(many)]
    raise TypeError(f"{place}: a number, a text, a list or a dict is wanted, not {type(x).__name__}")


def ask(question: str, path: Any, **options: Any) -> Dict[str, Any]:
    """What the program answers in JSON: ask("totals", path, digits=30) is `phrame totals FILE --digits 30 --print json`.

    `path` is a Path, the name of a file or a dict with what is in one; of "construct" it is the points, of "verify" the
    certificate, of "integrate" the expression, of "envelope" the curves with radii. `options` are those of the command,
    without dashes in front and with _ for -, and for a word of Python with _ behind: from_="pi/8". None is as if not given.
    An answer that is no JSON is {"output": "…"}, with "status": 1 where it is no.
    """
    questions = _questions()
    if not isinstance(question, str):
        raise TypeError(f"question: a text is wanted, not {type(question).__name__}")
    if question not in questions:
        raise _refuse("question", f"{question!r} is not one of {', '.join(questions)}", question)
    known = questions[question]
    subject = next(iter(known))
    line = {"question": question}
    given: Optional[_phrame.Path] = None
    if isinstance(path, _phrame.Path):
        given = path
    else:
        line[subject] = _json(path, "path", known[subject]["file"])
    for name, value in options.items():
        key = name[:-1] if name.endswith("_") else name
        if key not in known or key == subject:
            others = [other for other in known if other != subject]
            raise _refuse(name, f"{question} has no such option; it has {', '.join(others)}", value)
        if value is not None:
            line[key] = _json(value, name, known[key]["file"])
    try:
        answer: Dict[str, Any] = json.loads(_extension._ask(json.dumps(line), given))
    except InputError as error:
        raise _named(error, subject, {"path": path, **options}) from None
    return answer


def _named(error: InputError, subject: str, arguments: Dict[str, Any]) -> InputError:
    """The same with the argument's name for the place in the line."""
    if error.place == "/":
        return InputError(error.reason, "", error.reason)
    key, rest = re.fullmatch("/?([^/:]*)(.*)", error.place, re.DOTALL).groups()  # type: ignore[union-attr]
    name = "path" if key == subject else f"{key}_" if f"{key}_" in arguments else key
    if name not in arguments:
        return error
    return _refuse(name + rest, error.reason, arguments[name])
