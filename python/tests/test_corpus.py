"""What tests/data/curves.jsonl gives in Python is what the program gives, which is C++ throughout."""

import json
import os
import subprocess
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import MULTIPLIER, PROGRAM, ROOT

pytestmark = pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")

AT = ["1/3", "1"]
KINDS = {2: phrame.InputError, 3: phrame.DomainError, 4: phrame.Undecided}


def corpus(step):
    with open(ROOT / "tests/data/curves.jsonl", encoding="utf-8") as file:
        lines = [line for line in file if line.strip()]
    return lines[step // 2 :: step // MULTIPLIER] if MULTIPLIER < step else lines


@pytest.mark.parametrize("frame", ["erf", "frenet"])
def test_angles(frame):
    lines = corpus(10)
    questions = "".join(
        json.dumps({"id": k, "curve": json.loads(line), "at": AT, "digits": 40, "frame": frame}) + "\n"
        for k, line in enumerate(lines))
    run = subprocess.run([PROGRAM, "batch", "-"], input=questions, capture_output=True, text=True, check=False)
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    assert len(answers) == len(lines)
    values = 0
    for line, answer in zip(lines, answers):
        if "error" in answer:
            with pytest.raises(KINDS[answer["error"]["status"]]):
                angle = phrame.Path.from_json(line).angle(frame)
                for t in AT:
                    angle.value(t, digits=40)
            continue
        angle = phrame.Path.from_json(line).angle(frame)
        for t, value in zip(AT, answer["values"]):
            assert str(angle.value(t, digits=40)) == str(Decimal(value["theta"])), answer["curve"]
            values += 1
        rate = angle.rate()
        assert rate.numerator == phrame.Polynomial(answer["integrand"]["numerator"])
    assert values > len(lines)


def classified(path):
    return path.classify().json()


def certified(path):
    return path.certify(AT, digits=30).json()


def totals(path):
    found = {}
    for row, name in [("length", "length"), ("erf_twist", "erf_twist"), ("torsion", "total_torsion"),
                      ("bending_energy", "bending_energy"), ("frenet_energy", "frenet_energy")]:
        try:
            found[row] = getattr(path, name)
        except phrame.DomainError as error:
            found[row] = error
    return found


def twist(path):
    found = path.minimal_twist(0, "pi/3")
    return found.length, *(x.digits(30) if isinstance(x, phrame.Real) else x
                           for x in (found.erf_twist, found.nominal_twist, found.twist))


def frames(path):
    at = np.array(AT + ["1/7"], dtype=object)
    return np.concatenate([path.points(at)[:, None], path.frames(at), path.frames(at, kind="erf")[:, 1:]], axis=1)


def lengths(path):
    s = [path.length * Fraction(k, 4) for k in range(5)]
    return np.concatenate([path.points(s, by="arc-length"), path.quaternions(s, by="arc-length")], axis=1)


def same_text(found, printed):
    return found == printed.decode()


def same_totals(found, printed):
    rows = json.loads(printed)
    for name, x in found.items():
        value = rows.get(name, {}).get("value")
        if value is None:
            assert x == float("inf") or isinstance(x, phrame.DomainError), name
        else:
            assert (x.digits(30) if isinstance(x, phrame.Real) else Decimal(value)) == Decimal(value), name
            assert isinstance(x, phrame.Real) or abs(x - Fraction(value)) <= Fraction(rows[name]["radius"]), name
    return True


def same_twist(found, printed):
    answer = json.loads(printed)
    parts = [answer["twist"][name]["value"] for name in ("erf", "total", "minimal")]
    return found[0] == Fraction(answer["length"]) and list(found[1:]) == list(map(Decimal, parts))


def same_frames(found, printed):
    table = np.array([list(map(float, row.split(","))) for row in printed.decode().splitlines()[1:]])
    return (found.reshape(len(table), -1) == table[:, 1:]).all()


def same_lengths(found, printed):
    table = np.array([list(map(float, row.split(","))) for row in printed.decode().splitlines()[1:]])
    return (found == np.delete(table[:, 1:-1], range(3, 12), axis=1)).all()


@pytest.mark.parametrize(
    "ask, same, step, command",
    [
        (classified, same_text, 44, ["classify", "--print", "json"]),
        (certified, same_text, 44, ["certify", "--at", ",".join(AT), "--digits", "30"]),
        (totals, same_totals, 44, ["totals", "--print", "json", "--digits", "30"]),
        (twist, same_twist, 132, ["mtf", "--from", "0", "--to", "pi/3", "--print", "json", "--digits", "30"]),
        (frames, same_frames, 44, ["frames", "--at", ",".join(AT + ["1/7"]), "--frame", "rmf,erf"]),
        (lengths, same_lengths, 44, ["frames", "--by", "arc-length", "--samples", "5", "--columns", "quaternion"]),
    ],
    ids=["classify", "certify", "totals", "mtf", "frames", "lengths"],
)
def test_other_questions(ask, same, step, command):
    for line in corpus(step):
        run = subprocess.run([PROGRAM, *command, "-"], input=line.encode(), capture_output=True, check=False)
        if run.returncode in KINDS:
            with pytest.raises(KINDS[run.returncode]):
                ask(phrame.Path.from_json(line))
        else:
            assert run.returncode == 0 and same(ask(phrame.Path.from_json(line)), run.stdout), line[:80]
