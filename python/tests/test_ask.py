"""phrame.ask() is what the program answers, about whatever a path is."""

import json
import subprocess
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import PROGRAM, QUINTIC

MIXED = phrame.Path([phrame.Path.bezier([[0, 0, 0], [1, 0, 0], [2, 1, 0]]), phrame.Path.bezier([[2, 1, 0], [3, 2, 0], [4, 2, 5]])])


def printed(*arguments):
    return json.loads(subprocess.run([PROGRAM, *arguments], capture_output=True, check=True).stdout)


@pytest.fixture
def file(tmp_path):
    found = tmp_path / "curve.json"
    found.write_text(QUINTIC.json())
    return found


def test_it_is_what_the_program_prints(file):
    for question, options, words in (
        ("angle", {"at": [0, 0.5, Fraction(1, 3)], "digits": 30}, ["--at", "0,1/2,1/3", "--digits", "30"]),
        ("totals", {}, []),
        ("mtf", {"from_": "pi/8", "to": 1, "exact_only": True}, ["--from", "pi/8", "--to", "1", "--exact-only"]),
        ("angle", {"start_normal": np.array([0, 0.5, 1]), "values_only": True, "up": None},
         ["--start-normal", "0,1/2,1", "--values-only"]),
    ):
        expected = printed(question, file, *words, "--print", "json")
        for path in (QUINTIC, file, str(file), json.loads(file.read_text())):
            assert phrame.ask(question, path, **options) == expected, (question, path)


def test_paths_of_every_kind_are_asked_about_as_they_are():
    assert phrame.ask("info", MIXED)["arc_length"]["value"] == str(phrame.digits(MIXED.length, 17))
    assert phrame.ask("angle", MIXED, at=2)["values"][0]["theta"] == str(MIXED.angle().digits(2, 17))
    with pytest.raises(phrame.InputError, match="path: .*needs a Pythagorean-hodograph curve") as refused:
        phrame.ask("prove", MIXED, at=1)
    assert refused.value.place == "path" and refused.value.value is MIXED
    with pytest.raises(phrame.InputError, match="path: it is made already"):
        phrame.ask("identify", MIXED)


def test_what_is_not_about_a_path():
    assert phrame.ask("integrate", "1/(x^2+1)", from_=0, to=Decimal("0.5"))["definite"]["exact"] == "atan(1/2)"
    assert phrame.ask("construct", np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0.5]]))["phrame"] == "construct/1"
    assert phrame.ask("verify", json.loads(QUINTIC.certify(at=[1]).json()))["output"].endswith("proved\n")
    frames = QUINTIC.frames([0, 0.5, 1])
    table = np.c_[[0, 0.5, 1], frames[:, 1]]
    assert phrame.ask("check", QUINTIC, frames=table, header=["t", "f2x", "f2y", "f2z"])["verdict"] == "pass"
    table[2, 1:] = [1, 0, 0]
    assert phrame.ask("check", QUINTIC, frames=table, header="t,f2x,f2y,f2z")["verdict"] == "fail"


@pytest.mark.parametrize(
    ("question", "options", "place", "message"),
    [
        ("angle", {"digits": 0}, "digits", "is not a whole number from 1 to"),
        ("angle", {"digit": 5}, "digit", "angle has no such option; it has near"),
        ("mtf", {"from_": "x", "to": 1}, "from_", "is not an angle"),
        ("mtf", {"weight": "one"}, "weight", "needs --wronskian"),
        ("angle", {"at": ["1", "x"]}, "at", "is not a number"),
        ("angle", {"at": float("nan")}, "at", "not a finite number"),
        ("angle", {"output": "x"}, "output", "no such option"),
        ("angle", {"curve": {}}, "curve", "no such option"),
        ("batch", {}, "question", "is not one of angle"),
        ("frames", {}, "", "is needed"),
    ],
)
def test_an_exception_names_the_argument(question, options, place, message):
    with pytest.raises(phrame.InputError, match=message) as refused:
        phrame.ask(question, QUINTIC, **options)
    assert refused.value.place == place


def test_numbers_longer_than_python_prints():
    for move in (10**5000 + 7, -(10**5000) - 7, Fraction(-(10**5000) - 7, 3), Fraction(1, 10**4500)):
        (x, _, _) = phrame.parse(json.dumps(phrame.ask("transform", QUINTIC, move=[move, 0, 0]))).point(0)
        assert x - move == QUINTIC.point(0)[0]


def test_other_exceptions_are_those_of_the_library():
    line = phrame.Curve([1], [0], [0], [0])
    with pytest.raises(phrame.DomainError):
        phrame.ask("angle", line, frame="frenet", at=1)
    with pytest.raises(TypeError, match="at: a number, a text, a list or a dict is wanted"):
        phrame.ask("angle", QUINTIC, at=object())
