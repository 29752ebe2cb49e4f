"""Every argument of everything public is replaced by what it does not take."""

import inspect
import time
from decimal import Decimal
from pathlib import Path as File

import numpy as np
import pytest

import phrame
from api import ALL, API, CURVE, LISTS, OF_ANY_KIND, public_functions
from common import MULTIPLIER, QUINTIC

WRONG = [None, object(), 1j, float("nan"), float("inf"), Decimal("NaN"), "no such", "", "1/0", "\ud800", b"x", True, -1, 0,
         2.5, 10**400, -(10**30), [], [[]], [1], [float("nan")] * 3, [[1, "x", 3]], [[1, 2]], {}, np.array([]),
         np.zeros((2, 2, 2)), np.array([np.nan, 1]), np.array(["a"]), QUINTIC, len]
NOT_HERE = {"ax", "file"}  # whose types are others' to judge, and which are tried on their own


def test_the_list_is_complete():
    assert {name: set(arguments) for name, (_, arguments) in API.items()} == public_functions()
    assert all(set(arguments) == set(API[name][1]) for name, (_, arguments) in OF_ANY_KIND.items())
    for name in phrame.__all__:
        thing = getattr(phrame, name)
        assert name == "__version__" or thing.__doc__, name
        for member in vars(thing) if inspect.isclass(thing) else ():
            assert member.startswith("_") or getattr(thing, member).__doc__, f"{name}.{member} says nothing"


@pytest.mark.parametrize("name", ALL)
def test_a_signature_is_that_of_the_stub(name):
    call, arguments = ALL[name]
    signature = inspect.signature(call)
    assert {p.name for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD} == set(arguments)
    assert signature.bind(**arguments).arguments == arguments
    needed = {p.name for p in signature.parameters.values() if p.default is p.empty and p.kind is not p.VAR_KEYWORD}
    for argument in needed:
        with pytest.raises(TypeError):
            call(**{k: x for k, x in arguments.items() if k != argument})


def test_everything_public_has_a_signature():
    for kind in vars(phrame).values():
        if inspect.isclass(kind):
            for name, member in vars(kind).items():
                if callable(member) and not name.startswith("_"):
                    assert list(inspect.signature(member).parameters)[:1] == ["self"] or isinstance(member, type(phrame.integrate))
    assert list(inspect.signature(phrame.Polynomial([1, 2])).parameters) == ["t"]  # and not that of the class
    assert inspect.signature(QUINTIC.frames).parameters["kind"].default == "rmf"
    assert str(inspect.signature(phrame.root)) == (
        "(polynomial: 'Polynomial | collections.abc.Sequence[Number]', lower: 'Number', upper: 'Number')"
        " -> 'fractions.Fraction | Real'")


@pytest.fixture(autouse=True)
def no_window(monkeypatch):
    monkeypatch.setenv("MPLBACKEND", "agg")


@pytest.mark.parametrize("name", [*ALL, "Curve"])
def test_a_wrong_argument_is_named(name):
    call, arguments = (phrame.Curve, {**LISTS, **CURVE}) if name == "Curve" else ALL[name]
    name = name.replace(" of any kind", "")
    for k, argument in enumerate(sorted(set(arguments) - NOT_HERE)):
        values = WRONG[: -1 if argument in ("progress", "question") else None]
        for wrong in values if MULTIPLIER > 1 else values[k % 3 :: 3]:  # every third one for every day
            given = {**arguments, argument: wrong}
            if argument == "start_normal":
                given["start"] = None
            elif argument == "select":
                given["kind"] = "quintic"
            if name.endswith("page"):
                given["file"] = File("/nowhere/at/all")
            begin = time.process_time()
            try:
                found = call(**given)
                list(found) if name == "map" else None
            except (phrame.DomainError, phrame.Undecided) as error:
                assert "\n" not in str(error)
            except OSError:
                assert name.endswith(("page", "read", "ask", "envelope"))
            except (phrame.InputError, TypeError) as error:
                message = f"{name}({argument}={str(wrong)[:30]!r}): {error}"
                if argument == "text" and isinstance(error, phrame.InputError):
                    continue  # whose places are in the text
                # Two that exclude or need each other are told by either.
                names = (argument,) if isinstance(error, TypeError) else tuple(arguments)
                assert str(error).startswith(names) and "\n" not in str(error), message
                assert isinstance(error, TypeError) or error.place.startswith(names), message
            except Exception as error:
                raise AssertionError(f"{name}({argument}={str(wrong)[:30]!r}): {error!r}") from error
            assert time.process_time() - begin < 2, (name, argument, wrong)


@pytest.mark.parametrize("name", [name for name in ALL if "file" in ALL[name][1]])
def test_files(name, tmp_path):
    call, arguments = ALL[name]
    for wrong in (object(), 3, 1.5, None, [], "", "a\0b", "\ud800"):
        with pytest.raises((TypeError, phrame.InputError), match="^file: "):
            call(**{**arguments, "file": wrong})
    if not name.startswith(("SweptBody.save", "Path.page")):
        with pytest.raises(FileNotFoundError):
            call(**{**arguments, "file": tmp_path / "none"})
        with pytest.raises(IsADirectoryError):
            call(**{**arguments, "file": str(tmp_path)})
        (tmp_path / "x").write_bytes(b"\xff\xfe\0\0")
        with pytest.raises(phrame.InputError):
            call(**{**arguments, "file": tmp_path / "x"})
