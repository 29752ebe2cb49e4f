"""Angles and where they start; frames to the bit."""

import os
import subprocess
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

from common import PROGRAM, QUINTIC


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


@pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")
@pytest.mark.parametrize("by, option", [("t", []), ("arc-length", ["--by", "arc-length"])])
def test_frames_are_those_of_the_program_to_the_bit(tmp_path, by, option):
    file = tmp_path / "curve.json"
    file.write_text(QUINTIC.json())
    subprocess.run([PROGRAM, "frames", str(file), "--samples", "33", *option, "--format", "npy", "-o",
                    str(tmp_path / "frames.npy")], check=True)
    table = np.load(tmp_path / "frames.npy")
    if table.dtype.names:
        table = np.array(table.tolist())
    ts = [Fraction(k, 32) * (QUINTIC.length if by == "arc-length" else 1) for k in range(33)]
    assert (QUINTIC.frames(ts, by=by).reshape(33, 9) == table[:, 4:13]).all()
    assert (QUINTIC.points(ts, by=by) == table[:, 1:4]).all()
    assert (QUINTIC.matrices(ts, by=by)[:, :3, 3] == table[:, 1:4]).all()
