"""Ctrl-C during long calls, and Python's lock, which they do not hold."""

import os
import random
import subprocess
import sys
import threading
from decimal import Decimal
from fractions import Fraction

import pytest

import phrame
from common import MULTIPLIER, ROOT, random_curve

# What takes seconds when it is asked, beside what the scripts below do with it.
CURVES = """
import os, random, signal, sys, threading, time
sys.path[:0] = {path!r}
import numpy  # on a busy machine its first import, by a call, would be what is interrupted
import phrame
from fractions import Fraction
from common import random_curve

rng = random.Random(1)
curve, huge = random_curve(rng, 30), random_curve(rng, 60, 10**60)
trefoil = phrame.Curve.expressions("(2+cos(3*s))*cos(2*s)", "(2+cos(3*s))*sin(2*s)", "sin(3*s)", 0, "2*pi")
points = [[rng.randint(-99, 99) for _ in range(3)] for _ in range(400)]
"""

# Each takes seconds. What was left to itself goes on until the process ends, which is at once.
CALLS = CURVES + """
calls = dict(
    frames=lambda: curve.frames([Fraction(k, 1_000_003) for k in range(20_000)]),
    digits=lambda: trefoil.angle().value(1, digits=20_000),
    through=lambda: phrame.Curve.through(points, kind="c2"),
    map=lambda: list(phrame.map([curve] * 10_000, lambda curve: curve.angle().value(1, digits=20))),
    ball=lambda: trefoil.length.ball(100_000),
    sweep=lambda: phrame.sweep(trefoil, "circle:1/10", tolerance="1e-7"),
    certify=lambda: huge.certify(digits=20_000),
)
for name in {names!r}:
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.03, interrupt)
    try:
        timer.start()
        calls[name]()
        print(name, "inf")
    except KeyboardInterrupt:
        print(name, time.monotonic() - sent[0])
assert str(phrame.Curve([1], [0, 1], [0], [0, 1]).length) == "5/3"
"""


@pytest.mark.skipif(not hasattr(os, "kill") or sys.platform == "win32", reason="no signals")
def test_control_c_ends_calls_of_all_kinds():
    names = ["frames", "digits", "through", "map", "ball", "sweep", "certify"]
    names = names if MULTIPLIER > 1 else names[:4]
    script = CALLS.format(path=[str(ROOT / "python/tests")], names=names)
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False)
    assert run.returncode == 0, run.stderr
    seconds = {name: float(time) for name, time in map(str.split, run.stdout.splitlines())}
    assert list(seconds) == names
    # 0.05 s where there is a free core, since signals are looked for 20 times a second.
    assert max(seconds.values()) < 2 and min(seconds.values()) < 0.2, seconds


def test_other_threads_run_during_a_call():
    angle = random_curve(random.Random(2), 12).angle()
    call = threading.Thread(target=angle.value, args=(Fraction(1, 3), 20_000))
    call.start()
    turns = 0
    while call.is_alive():
        turns += 1
        call.join(0.001)
    assert turns > 5
    assert phrame.Polynomial([0, 1])(turns) == turns


# Each would take seconds, and again and again is interrupted where it happens to be: the session lives on.
LIMITED = CURVES + """
theta = random_curve(rng, 4).angle().value(1)
calls = [
    lambda: curve.frames([Fraction(k, 1_000_003) for k in range(20_000)]),
    lambda: trefoil.angle().value(1, digits=20_000),
    lambda: phrame.Curve.through(points, kind="c2"),
    lambda: trefoil.length.ball(100_000),
    lambda: phrame.sweep(trefoil, "circle:1/10", tolerance="1e-7"),
    lambda: huge.certify(digits=20_000),
    lambda: theta.digits(1_000_000),
]
caught = []

def ask(call):
    try:
        call()
    except phrame.Undecided as error:
        caught.append(str(error))

for k in range({rounds}):
    phrame.set_time_limit(rng.uniform(0.01, 0.08))
    ask(calls[k % len(calls)])
    if k % 3 == 0:  # from a thread of one's own it is done there
        thread = threading.Thread(target=ask, args=(rng.choice(calls),))
        thread.start()
        thread.join()
assert len(caught) == {rounds} + ({rounds} + 2) // 3, caught
assert all("set_time_limit" in text for text in caught), caught
phrame.set_time_limit(None)
print(trefoil.angle().value(1, digits=20), theta.digits(20) - phrame.digits(theta, 30) < 1e-19)
"""


def test_a_time_limit_ends_calls_of_all_kinds_and_nothing_else():
    script = LIMITED.format(path=[str(ROOT / "python/tests")], rounds=4 if MULTIPLIER == 1 else 300)
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=300, check=False)
    assert run.returncode == 0, run.stderr
    trefoil = phrame.Curve.expressions("(2+cos(3*s))*cos(2*s)", "(2+cos(3*s))*sin(2*s)", "sin(3*s)", 0, "2*pi")
    assert run.stdout.split() == [str(trefoil.angle().value(1, digits=20)), "True"]
    for wrong, error in ((0, phrame.InputError), (-1.5, phrame.InputError), (float("nan"), phrame.InputError),
                         (Decimal("NaN"), phrame.InputError), ("1", TypeError), (True, TypeError)):
        with pytest.raises(error, match="^seconds: "):
            phrame.set_time_limit(wrong)
