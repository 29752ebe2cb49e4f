"""Angles against quadrature of the rate that common.py writes down, and against the program, which is C++ throughout."""

import json
import os
import random
import subprocess
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest

import phrame
from common import MULTIPLIER, PROGRAM, QUINTIC, random_curve, ROOT, theta_by_quadrature


@pytest.mark.parametrize("seed", range(12 * MULTIPLIER))
def test_angles_agree_with_quadrature(seed):
    rng = random.Random(seed)
    curve = random_curve(rng, rng.randint(1, 3))
    t = Fraction(rng.randint(1, 16), 8)
    theta = curve.angle().value(t, digits=25)
    exact = theta_by_quadrature(curve, t, 60)
    with mpmath.workdps(60):
        assert abs(mpmath.mpf(str(theta)) - exact) <= abs(exact) * mpmath.mpf(10) ** -24


def test_one_angle_is_a_float():
    theta = float(QUINTIC.angle().value("1/2"))
    for t in (0.5, Fraction(1, 2), Decimal("0.5"), np.float64(0.5), "1/2"):
        assert QUINTIC.angle()(t) == theta and isinstance(QUINTIC.angle()(t), float)


def test_angles_start_where_they_are_asked_to():
    angle = QUINTIC.angle(start="pi/4")
    assert abs(float(angle.value(0)) - np.pi / 4) < 1e-15
    assert QUINTIC.angle(start=1).value(0) == 1
    e1, f2, f3 = QUINTIC.frames([0.0], start_normal=[0, 0, 1])[0]
    assert np.abs(np.cross(e1, np.cross([0, 0, 1], e1)) / np.linalg.norm(np.cross(e1, [0, 0, 1])) - f2).max() < 1e-15
    frenet = QUINTIC.angle("frenet")
    assert frenet.rate() != QUINTIC.angle().rate()


def corpus():
    with open(ROOT / "tests/data/curves.jsonl", encoding="utf-8") as file:
        lines = [line for line in file if line.strip()]
    return lines if MULTIPLIER > 1 else lines[::6]


@pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")
def test_the_corpus_gives_what_the_program_gives():
    lines = corpus()
    at = ["1/3", "1"]
    questions = "".join(
        json.dumps({"id": k, "curve": json.loads(line), "at": at, "digits": 40}) + "\n"
        for k, line in enumerate(lines))
    run = subprocess.run([PROGRAM, "batch", "-"], input=questions, capture_output=True, text=True, check=False)
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    assert len(answers) == len(lines)
    values = 0
    for line, answer in zip(lines, answers):
        if "error" in answer:
            with pytest.raises(phrame.Error):
                angle = phrame.Path.from_json(line).angle()
                for t in at:
                    angle.value(t, digits=40)
            continue
        angle = phrame.Path.from_json(line).angle()
        for t, value in zip(at, answer["values"]):
            assert str(angle.value(t, digits=40)) == str(Decimal(value["theta"])), answer["curve"]
            values += 1
        rate = angle.rate()
        assert rate.numerator == phrame.Polynomial(answer["integrand"]["numerator"])
    assert values > len(lines)


@pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")
@pytest.mark.parametrize("by, option", [("parameter", []), ("arc_length", ["--by", "arc-length"])])
def test_frames_are_those_of_the_program_to_the_bit(tmp_path, by, option):
    file = tmp_path / "curve.json"
    file.write_text(QUINTIC.json())
    subprocess.run([PROGRAM, "frames", str(file), "--samples", "33", *option, "--format", "npy", "-o",
                    str(tmp_path / "frames.npy")], check=True)
    table = np.load(tmp_path / "frames.npy")
    if table.dtype.names:
        table = np.array(table.tolist())
    ts = [Fraction(k, 32) * (QUINTIC.length if by == "arc_length" else 1) for k in range(33)]
    assert (QUINTIC.frames(ts, by=by).reshape(33, 9) == table[:, 4:13]).all()
    assert (QUINTIC.points(ts, by=by) == table[:, 1:4]).all()
    assert (QUINTIC.matrices(ts, by=by)[:, :3, 3] == table[:, 1:4]).all()
