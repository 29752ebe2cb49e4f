"""Everything public is asked by several threads at once of the same objects. ./dev tsan runs this under ThreadSanitizer."""

import os
import random
import subprocess
import sys
import threading
from fractions import Fraction

import numpy as np
import pytest

import phrame
from phrame import _threads
from api import ALL
from common import MULTIPLIER, QUINTIC, random_curve
from values import same

THREADS = 4
# Matplotlib is for one thread at a time, and files are others'.
SHARED = [name for name, (_, arguments) in ALL.items() if "plot" not in name and "file" not in arguments]


def at_once(*questions):
    """Their answers, asked by a thread each that waits until all are there."""
    ready, found = threading.Barrier(len(questions)), [None] * len(questions)

    def ask(k):
        ready.wait()
        try:
            found[k] = questions[k]()
        except Exception as error:
            found[k] = error

    threads = [threading.Thread(target=ask, args=(k,)) for k in range(len(questions))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return found


@pytest.fixture(autouse=True)
def switched_often():
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(interval)


def test_every_public_function():
    """Together with all others, in another order in each thread."""
    ask = {name: ALL[name][0] for name in SHARED}

    def all_of_them(seed):
        names = SHARED[:]
        random.Random(seed).shuffle(names)
        return {name: ask[name](**ALL[name][1]) for name in names}

    expected = all_of_them(0)
    for turn in range(MULTIPLIER):
        for found in at_once(*(lambda seed=seed: all_of_them(seed) for seed in range(THREADS * turn, THREADS * (turn + 1)))):
            assert not isinstance(found, Exception), found
            for name in SHARED:
                if hasattr(expected[name], "__next__") or name.startswith("dask"):
                    continue
                if name == "Real.ball":  # smaller after more digits were asked for
                    (low, high), (a, b) = found[name], expected[name]
                    assert max(low, a) <= min(high, b)
                    continue
                assert same(found[name], expected[name]), name


def test_what_is_refined_is_shared():
    """More and more digits of the same fresh objects, each thread in its own order."""
    for seed in range(2 * MULTIPLIER):
        rng = random.Random(seed)
        degree = rng.randint(2, 6)

        def fresh(seed=seed, degree=degree):
            curve = random_curve(random.Random(seed), degree)
            smooth = phrame.Curve.bezier(curve.control_points[:4])
            return [curve.angle(), curve.angle().value("1/3"), smooth.angle(), smooth.length, curve.total_torsion]

        def ask(things, order):
            found = {}
            for k, digits in order:
                thing = things[k]
                if callable(thing):
                    found[k, digits] = str(thing.value("2/3", digits=digits))
                elif isinstance(thing, phrame.Real):
                    found[k, digits] = str(thing.digits(digits))
            return found

        orders = [[(k, digits) for k in range(5) for digits in (5, 17, 40, 90)] for _ in range(THREADS)]
        expected, shared = ask(fresh(), orders[0]), fresh()
        for order in orders:
            rng.shuffle(order)
        assert at_once(*(lambda order=order: ask(shared, order) for order in orders)) == [expected] * THREADS


def test_arrays_beside_arrays():
    """Jobs of several threads share the workers; one of them is stopped."""
    ts = np.linspace(0, 1, 20_000)
    exact = [Fraction(k, 301) for k in range(300)]
    expected = QUINTIC.frames(ts), QUINTIC.quaternions(ts), QUINTIC.angle()(exact)

    def stop(done, n):
        raise KeyError("enough")

    def stopped():
        with pytest.raises(KeyError):
            QUINTIC.frames(exact * 20, progress=stop)

    for _ in range(2 * MULTIPLIER):
        *found, nothing = at_once(lambda: QUINTIC.frames(ts), lambda: QUINTIC.quaternions(ts), lambda: QUINTIC.angle()(exact), stopped)
        assert all((a == b).all() for a, b in zip(found, expected)) and nothing is None


def test_the_same_list_is_read_while_it_changes():
    numbers = [Fraction(k, 7) for k in range(50)]

    def read():
        return [len(phrame.Polynomial(numbers).coefficients) for _ in range(50)]

    def change():
        for k in range(2000):
            numbers.append(k + 1)
            numbers.pop()

    lengths, *_ = at_once(read, change, change)
    assert set(lengths) <= {49, 50, 51, 52}


FLOCK = """
import os, sys
import numpy as np
import phrame
from phrame import _threads
curve = phrame.Curve([2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2])
before = len(os.listdir("/proc/self/task"))
curve.frames(np.linspace(0, 1, 300_000))
print(len(os.listdir("/proc/self/task")) - before)
phrame.set_threads(5)
curve.frames(np.linspace(0, 1, 300_000))
print(len(os.listdir("/proc/self/task")) - before)
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="threads are counted by /proc")
def test_threads_are_as_many_as_asked_for():
    environment = {**os.environ, "PHRAME_THREADS": "2"}
    found = subprocess.run([sys.executable, "-c", FLOCK], env=environment, capture_output=True, text=True, check=True)
    assert found.stdout.split() == ["2", "5"]


def test_the_limit_of_threads(monkeypatch):
    for wrong in ("0", "-1", "two", "1e3", "²"):
        monkeypatch.setenv("PHRAME_THREADS", wrong)
        with pytest.raises(phrame.InputError, match="^PHRAME_THREADS: "):
            QUINTIC.frames(np.linspace(0, 1, 20_000))
        with pytest.raises(phrame.InputError, match="^PHRAME_THREADS: "):
            phrame.map([], len)
    monkeypatch.setenv("PHRAME_THREADS", "3")
    assert _threads.limit() == 3
    phrame.set_threads(7)
    assert _threads.limit() == 7
    phrame.set_threads(None)
    monkeypatch.delenv("PHRAME_THREADS")
    assert 1 <= _threads.limit() <= os.cpu_count()
    if hasattr(os, "sched_setaffinity"):
        cores = os.sched_getaffinity(0)
        os.sched_setaffinity(0, {min(cores)})
        try:
            assert _threads.limit() == 1
        finally:
            os.sched_setaffinity(0, cores)


@pytest.mark.parametrize(
    "group, files, expected",
    [
        ("0::/", {"cpu.max": "150000 100000"}, 1.5),
        ("0::/a/b", {"a/cpu.max": "200000 100000", "a/b/cpu.max": "max 100000"}, 2),  # that of all around it counts
        ("0::/a", {"cpu.max": "max 100000"}, float("inf")),
        ("4:cpu,cpuacct:/x\n0::/", {"cpu,cpuacct/cpu.cfs_quota_us": "50000", "cpu,cpuacct/cpu.cfs_period_us": "100000"}, 0.5),
        ("4:cpu:/\n3:memory:/", {"cpu/cpu.cfs_quota_us": "-1", "cpu/cpu.cfs_period_us": "100000"}, float("inf")),
        (None, {}, float("inf")),
    ],
)
def test_the_quota_of_a_container(tmp_path, group, files, expected):
    for name, text in {**{f"sys/fs/cgroup/{name}": text for name, text in files.items()}, "proc/self/cgroup": group}.items():
        if text is not None:
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text + "\n")
    assert _threads._cores_of_group(str(tmp_path)) == expected


FIRST_FRAMES = """
import sys, threading, phrame
sys.setswitchinterval(1e-5)
for n in range(60):
    path = phrame.Path.bezier([[0, 0, 0], [1, n, 0], [3, 0, 1], [4, 1, 2]])
    threads = [threading.Thread(target=path.frames, args=([0, 0.5],), kwargs={"start": start}) for start in (None, None, 1, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
"""


def test_threads_that_ask_first_do_not_wait_for_each_other():
    subprocess.run([sys.executable, "-c", FIRST_FRAMES], check=True, timeout=60)
