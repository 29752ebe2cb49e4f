"""What a call has taken is given back, whether it answered or refused. With PHRAME_TEST_MULTIPLIER=25 over 100 000 curves."""

import ctypes
import gc
import os
import pickle
import resource
import subprocess
import sys
import time

import numpy as np
import pytest

import phrame
from api import ALL
from common import MULTIPLIER, QUINTIC


class MallInfo(ctypes.Structure):
    """struct mallinfo2 of glibc."""

    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")]


def mallinfo2():
    function = getattr(ctypes.CDLL(None), "mallinfo2", None)
    if function is not None:
        function.restype = MallInfo
    return function


def in_use():
    """(Bytes that malloc has given out, blocks that Python has)."""
    gc.collect()
    info = mallinfo2()()
    return info.uordblks + info.hblkhd, sys.getallocatedblocks()


@pytest.fixture(autouse=True, scope="module")
def frozen():
    """What other packages have is not looked through each time."""
    gc.freeze()
    yield
    gc.unfreeze()


def refused(call, **arguments):
    try:
        call(**arguments)
    except (phrame.Error, TypeError, OSError):
        pass


@pytest.mark.skipif(mallinfo2() is None, reason="malloc is not glibc's")
@pytest.mark.parametrize("name", [name for name in ALL if "plot" not in name and not name.startswith(("dask", "sympy"))])
def test_no_call_keeps_what_it_took(name):
    call, arguments = ALL[name]
    wrong = next(iter(arguments), None)

    def use(n):
        for _ in range(n):
            refused(call, **arguments)  # a file that is not there, too
            if wrong is not None:
                refused(call, **{**arguments, wrong: object()})

    begin = time.process_time()
    use(2)
    calls = MULTIPLIER * max(2, min(50, int(0.01 / (time.process_time() - begin))))
    for _ in range(30):  # what FLINT keeps for each thread grows until it is enough
        bytes_before, blocks_before = in_use()
        use(calls)
        more_bytes, more_blocks = (after - before for after, before in zip(in_use(), (bytes_before, blocks_before)))
        if more_bytes < 64 * calls + 2048 and more_blocks < calls + 2:
            return
    raise AssertionError(f"{name}: {more_bytes / calls:.0f} bytes and {more_blocks / calls:.1f} objects of each call are kept")


def resident():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="no /proc")
def test_no_memory_is_lost():
    def use(n):
        for k in range(n):
            curve = phrame.Curve([2, -4, 4], [1, k, -1], [0, -4, 4], [10**40 + k, 2, -2])
            curve.sigma, curve.control_points[1], pickle.dumps(curve.h)
        for _ in range(n // 100):
            curve.angle().value(1, digits=20), QUINTIC.frames([0.25, "1/3"])
            with pytest.raises(phrame.InputError):
                phrame.Curve([1], [0], ["x"], [0])

    n = 2000 * MULTIPLIER
    use(n)
    before = resident()
    use(2 * n)
    assert resident() - before < 4 << 20


def test_arrays_outlive_what_made_them():
    frames = phrame.Curve([1, 1], [0], [0], [0, 2]).frames(np.linspace(0, 1, 1000))
    rows = frames[::7, 2]
    del frames
    gc.collect()
    rubbish = [np.full(9000, k) for k in range(100)]
    assert (rows == [0, 0, 1]).all() and rubbish


SHORT = """
import resource
import time
import phrame

large = phrame.Polynomial([3**400_000] * 100)  # 8 MB
questions = [
    lambda: large * large,
    lambda: phrame.integrate("1/(x^30-x-1)^3", 2, 3).value(5000),
    lambda: phrame.Polynomial([1] * 500000),
    lambda: phrame.Curve.expressions("s*2^(10^8)", "s", "s^2", 0, 1).length,
    lambda: phrame.sweep(phrame.Curve([1, 2], [0, 1], [3], [1]), "circle:1", sections=10**6),
]
phrame.set_threads(1)
phrame.Curve([1, 2], [0, 1], [3], [1]).angle().value(1, 50)  # by the thread that there is from now on
with open("/proc/self/statm") as file:
    used = int(file.read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + MARGIN, resource.RLIM_INFINITY))
names = []
for question in questions:
    time.sleep(0.1)  # it waits for the next question, so that no other thread begins
    try:
        question()
        names.append("answered")
    except Exception as error:
        names.append(type(error).__name__)
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
print(*names, phrame.Curve([1], [0, 1], [0], [1]).angle().value(1, 10))  # the session goes on
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="limits are set as on Linux")
@pytest.mark.parametrize("margin", [10] if MULTIPLIER == 1 else range(4, 60, 4))
def test_a_session_outlives_too_little_memory(margin):
    program = SHORT.replace("MARGIN", f"{margin} * 2**20")
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100, check=False)
    assert run.returncode == 0 and run.stderr == "", (run.returncode, run.stderr[-2000:])
    *names, theta = run.stdout.split()
    assert theta == "-0.8704197514" and set(names) <= {"answered", "MemoryError", "InputError", "Undecided", "DomainError"}
    assert "MemoryError" in names[1:] and (names[0] == "MemoryError" or margin > 10)  # the first one by FLINT and GMP
