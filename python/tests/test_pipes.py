"""Pipes of lines and arcs, of which the angle comes back to multiples of π/2: Python's answers are those of parallel transport
in doubles (tests/pipes)."""
import json
import math
import os
import sys
from pathlib import Path

import phrame
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "pipes"))
from pipes import Transport, file_of, pipes  # noqa: E402

everyday = int(os.environ.get("PHRAME_TEST_MULTIPLIER", "1")) == 1


@pytest.mark.parametrize("name, is_closed, pipe", list(pipes(200))[:: 37 if everyday else 1])
def test_pipe(name, is_closed, pipe):
    path = phrame.parse(json.dumps(file_of(pipe)))
    angle = path.angle()
    transport = Transport(pipe)
    v = [float(x) for x in angle.up]
    n = len(pipe)
    for t in (0.5, 1, n - 0.25, n):
        assert abs(math.remainder(float(angle(t)) - transport.angle(v, t), 2 * math.pi)) < 1e-8
    f2 = path.frames([k / 4 for k in range(4 * n + 1)])[:, 1]
    for k in range(4 * n + 1):
        expected, _ = transport.along(list(f2[0]), k / 4)
        assert max(abs(a - b) for a, b in zip(expected, f2[k])) < 1e-8
    if is_closed:
        turn = float(path.holonomy)
        assert abs(math.remainder(turn - transport.angle(v, n), 2 * math.pi)) < 1e-8
    assert "double" in path.compile("pipe")
    for end in (0, "pi", "pi/2"):
        twist = float(path.minimal_twist(0, end).twist)
        assert -math.pi < twist <= math.pi + 1e-15
