"""Many curves: on threads, and on clusters of Dask and of Spark, of two workers of which one is killed."""

import itertools
import os
import random
import shutil
import subprocess
import sys
import threading
import time
import types

import numpy as np
import pytest

import phrame
from api import Rdd
from common import MULTIPLIER, QUINTIC, ROOT, random_curve

LINE = phrame.Curve([1], [0], [0], [0])


def curves(n):
    rng = random.Random(7)
    return [random_curve(rng) for _ in range(n)]


def theta(curve):
    return str(curve.angle().value(1, digits=30))


def test_answers_are_in_order_on_any_number_of_threads():
    many = curves(100)
    expected = [theta(curve) for curve in many]
    for threads in (None, 1, 3):
        assert list(phrame.map(many, theta, threads=threads)) == expected
    assert list(phrame.map([], theta)) == []


def test_curves_are_read_as_they_are_needed():
    read = []

    def endless():
        for k in itertools.count():
            read.append(k)
            yield QUINTIC

    found = phrame.map(endless(), lambda curve: curve.degree, threads=2)
    assert [next(found) for _ in range(5)] == [5] * 5
    assert len(read) < 1000
    found.close()
    names = set()
    assert len(list(phrame.map(curves(200), lambda _: names.add(threading.get_ident()) or time.sleep(0.001), threads=2))) == 200
    assert len(names) == 2


def test_a_curve_without_an_answer():
    def frenet(curve):
        return curve.angle("frenet").value(1, digits=10)

    mixed = [QUINTIC, LINE, QUINTIC]
    first, none, last = phrame.map(mixed, frenet, errors="return")
    assert first == last == frenet(QUINTIC) and isinstance(none, phrame.DomainError)
    found = phrame.map(mixed, frenet)
    assert next(found) == first
    with pytest.raises(phrame.DomainError):
        next(found)
    with pytest.raises(ZeroDivisionError):
        list(phrame.map(mixed, lambda curve: 1 / 0, errors="return"))
    for wrong in ({"errors": "ignore"}, {"threads": 0}):
        with pytest.raises(phrame.InputError, match=next(iter(wrong))):
            phrame.map(mixed, frenet, **wrong)


def test_dask_without_a_cluster():
    pytest.importorskip("dask")
    import dask

    many = curves(20)
    with dask.config.set(scheduler="synchronous"):
        assert phrame.dask.map(many, theta, partitions=3).compute() == [theta(curve) for curve in many]
        assert phrame.dask.map([LINE], lambda curve: curve.angle("frenet"), errors="return").compute()[0].reason
        ts = np.linspace(0, 1, 100)
        blocks = __import__("dask.array").array.from_array(ts, chunks=30)
        for name in ("frames", "matrices", "quaternions", "points"):
            lazy = getattr(phrame.dask, name)(QUINTIC, blocks)
            whole = getattr(QUINTIC, name)(ts)
            assert lazy.shape == whole.shape and (lazy.compute() == whole).all()
        assert (phrame.dask.frames(QUINTIC, ts, start="pi/8").compute() == QUINTIC.frames(ts, start="pi/8")).all()
        assert (phrame.dask.angles(QUINTIC.angle(), blocks).compute() == QUINTIC.angle()(ts)).all()


def test_frames_of_dask():
    pandas, frames = pytest.importorskip("pandas"), pytest.importorskip("dask.dataframe")
    many = curves(7)
    table = pandas.DataFrame({"curve": [curve.json() for curve in many], "t": np.linspace(0, 1, 7)}, index=list("gfedcba"))
    lazy = frames.from_pandas(table, npartitions=3, sort=False)
    found = phrame.dask.map(lazy, theta).compute(scheduler="synchronous")
    assert found.tolist() == [theta(curve) for curve in many] and found.index.equals(table.index) and found.name == "theta"
    assert phrame.dask.map(lazy["curve"], theta).compute(scheduler="synchronous").equals(found)
    errors = phrame.dask.map(lazy.assign(curve="{}"), theta, errors="return").compute(scheduler="synchronous")
    assert all(isinstance(error, phrame.InputError) for error in errors)
    assert (phrame.dask.points(QUINTIC, lazy["t"]).compute(scheduler="synchronous") == QUINTIC.points(table["t"])).all()


CLUSTER = """
import os, signal, sys, time
sys.path[:0] = {path!r}
import phrame
from dask.distributed import Client, LocalCluster, as_completed
from test_map import curves, theta

def slow_theta(curve):
    time.sleep(0.02)
    return theta(curve)

if __name__ == "__main__":
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None,
                      worker_dashboard_address=None) as cluster, Client(cluster) as client:
        parts = phrame.dask.map(curves({n}), slow_theta, partitions={n} // 5).to_delayed()
        futures = client.compute(parts)
        next(as_completed(futures))
        killed = next(iter(client.run(os.getpid).values()))
        os.kill(killed, signal.SIGKILL)
        answers = [answer for part in client.gather(futures) for answer in part]
        print("\\n".join(answers))
        print("killed", killed, "left", *sorted(client.run(os.getpid).values()))
"""


@pytest.mark.skipif(MULTIPLIER == 1, reason="a cluster takes seconds: PHRAME_TEST_MULTIPLIER=2")
def test_dask_loses_nothing_with_a_worker(tmp_path):
    pytest.importorskip("distributed")
    n = 100
    script = tmp_path / "cluster.py"
    script.write_text(CLUSTER.format(path=[str(ROOT / "python/tests"), *os.environ.get("PYTHONPATH", "").split(":")], n=n))
    run = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, cwd=tmp_path, timeout=120, check=False)
    assert run.returncode == 0, run.stderr[-2000:]
    *answers, last = run.stdout.splitlines()
    assert answers == [theta(curve) for curve in curves(n)]
    killed, left = last.removeprefix("killed ").split(" left ")
    assert killed not in left.split()


def test_spark_without_a_cluster():
    many = curves(4)
    lines = [curve.json() for curve in many]
    expected = [theta(curve) for curve in many]
    assert phrame.spark.map(Rdd(many[:3], [], many[3:]), theta) == expected
    assert phrame.spark.map(Rdd(lines[:1], lines[1:]), theta) == expected
    found = phrame.spark.map(Rdd([lines[0], "{}"], [LINE]), lambda curve: curve.angle("frenet").text(), errors="return")
    assert [type(answer) for answer in found[1:]] == [phrame.InputError, phrame.DomainError]
    with pytest.raises(phrame.InputError):
        phrame.spark.map(Rdd(["{}"]), theta)
    with pytest.raises(phrame.InputError, match="errors"):
        phrame.spark.map(Rdd(), theta, errors="ignore")


class Frame:
    """As much of a DataFrame of Spark as phrame.spark takes: rows, and a column that is the name of one."""

    def __init__(self, rows):
        self.rows = rows

    def __getitem__(self, name):
        return name

    def withColumn(self, name, value):  # noqa: N802
        return Frame([{**row, name: value(row)} for row in self.rows])


def test_frames_of_spark_without_spark(monkeypatch):
    functions = types.ModuleType("pyspark.sql.functions")
    functions.udf = lambda f, kind: lambda column: lambda row: {"double": float, "string": str}[kind](f(row[column])) if f(row[column]) is not None else None
    for name in ("pyspark", "pyspark.sql"):
        monkeypatch.setitem(sys.modules, name, types.ModuleType(name))
    monkeypatch.setitem(sys.modules, "pyspark.sql.functions", functions)
    many = curves(3)
    frame = Frame([{"id": k, "file": curve.json()} for k, curve in enumerate(many)] + [{"id": 3, "file": None}])
    found = phrame.spark.map(frame, lambda curve: curve.length, column="file", returns="length double").rows
    assert [row["length"] for row in found] == [float(curve.length) for curve in many] + [None]
    assert [row["id"] for row in found] == [0, 1, 2, 3]
    bad = Frame([{"curve": "{}"}])
    with pytest.raises(phrame.InputError):
        phrame.spark.map(bad, theta)
    assert phrame.spark.map(bad, theta, errors="return").rows[0]["answer"] is None
    with pytest.raises(phrame.InputError, match="^returns: a name and a type"):
        phrame.spark.map(bad, theta, returns="double")


@pytest.mark.skipif(MULTIPLIER == 1, reason="Spark takes seconds: PHRAME_TEST_MULTIPLIER=2")
def test_frames_of_spark(tmp_path, monkeypatch):
    sql = pytest.importorskip("pyspark.sql")
    if shutil.which("java") is None:
        pytest.skip("no Java")
    monkeypatch.setenv("PYSPARK_PYTHON", sys.executable)
    monkeypatch.chdir(tmp_path)
    spark = sql.SparkSession.builder.master("local[1]").config("spark.ui.enabled", "false").getOrCreate()
    try:
        many = curves(3)
        frame = spark.createDataFrame([(k, curve.json()) for k, curve in enumerate(many)], "id int, curve string")
        found = phrame.spark.map(frame, lambda curve: float(curve.length), returns="length double").collect()
        assert [row["length"] for row in found] == [float(curve.length) for curve in many]
    finally:
        spark.stop()


# An executor is a Java process, whose daemon in Python has children that ask. It is killed at its first question, so
# that a partition is lost with it.
SPARK = """
import glob, os, signal, sys, threading, time
sys.path[:0] = {path!r}
import phrame
from pyspark import SparkConf, SparkContext
from test_map import curves, theta

def executor():
    with open(f"/proc/{{os.getppid()}}/stat") as file:
        return file.read().rsplit(")", 1)[1].split()[1]

def slow_theta(curve):
    with open("{folder}/executor-" + executor(), "a") as asked:
        asked.write("1")
    time.sleep(0.05)
    return theta(curve)

def kill_one():
    while not (found := glob.glob("executor-*")):
        time.sleep(0.01)
    os.kill(int(found[0].split("-")[1]), signal.SIGKILL)

conf = SparkConf().setMaster("local-cluster[2,1,1024]").set("spark.ui.enabled", "false")
conf.set("spark.executorEnv.PYTHONPATH", os.pathsep.join({path!r}))
spark = SparkContext(conf=conf)
lines = spark.parallelize([curve.json() for curve in curves({n})], {n} // 5)
killer = threading.Thread(target=kill_one)
killer.start()
answers = phrame.spark.map(lines, slow_theta).collect()
killer.join()
print("\\n".join(answers))
asked = [os.path.getsize(name) for name in glob.glob("executor-*")]
print("executors", len(asked), "asked", sum(asked))
spark.stop()
"""


@pytest.mark.skipif(MULTIPLIER == 1, reason="a cluster takes seconds: PHRAME_TEST_MULTIPLIER=2")
def test_spark_loses_nothing_with_an_executor(tmp_path):
    pytest.importorskip("pyspark")
    if shutil.which("java") is None:
        pytest.skip("no Java")
    n = 100
    path = [str(ROOT / "python/tests"), *os.environ.get("PYTHONPATH", "").split(":")]
    script = tmp_path / "cluster.py"
    script.write_text(SPARK.format(path=path, n=n, folder=tmp_path))
    environment = {
        **os.environ,
        "PYSPARK_PYTHON": sys.executable,
        "SPARK_LOCAL_IP": "127.0.0.1",
        "SPARK_LOCAL_DIRS": str(tmp_path),
        "SPARK_WORKER_DIR": str(tmp_path / "work"),
        "JAVA_TOOL_OPTIONS": "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC",  # a short run: half of the CPU time
    }
    run = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, cwd=tmp_path, timeout=600, check=False,
                         env=environment)
    assert run.returncode == 0, run.stderr[-4000:]
    *answers, last = run.stdout.splitlines()
    assert answers == [theta(curve) for curve in curves(n)]
    executors, asked = (int(word) for word in last.split()[1::2])
    assert executors >= 2 and asked > n  # what was lost was asked again
