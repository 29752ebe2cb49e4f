"""Pipes of lines and arcs (pipes.py) in all commands: each answers, and angles, holonomies and frames are those of parallel
transport in doubles. A few every day, 200 with PHRAME_TEST_MULTIPLIER; with an argument that many, and the times."""
import csv
import io
import json
import math
import os
import sys
import tempfile
import time
from pathlib import Path

from pipes import Transport, dot, file_of, pipes, plus
from program import phrame, writes_pages

times = {}


def timed(*arguments):
    start = time.perf_counter()
    text = phrame(*arguments)
    times.setdefault(arguments[0], []).append(time.perf_counter() - start)
    return text


def near(a, b, of_period=False):
    return abs(math.remainder(a - b, 2 * math.pi) if of_period else a - b) < 1e-8


def check_angles(file, pipe, is_closed, transport):
    places = [0.5, 1, len(pipe) - 0.25, len(pipe)]
    answer = json.loads(timed("angle", file, "--print", "json", "--at", ",".join(map(str, places))))
    v = [float(x) for x in answer["up"]]
    for place, value in zip(places, answer["values"]):
        assert near(float(value["theta"]), transport.angle(v, place), True), ("theta", place, value)
    assert answer["closed"] == is_closed
    if is_closed:
        turn = float(answer["holonomy"]["value"])
        # About T by as much as the frame of v, which closes, is turned back.
        assert near(turn, transport.angle(v, len(pipe)), True) and -math.pi < turn < 3.1415926535897936, turn
    return answer


def check_frames(file, pipe, transport, tables):
    count = 4 * len(pipe) + 1
    text = timed("frames", file, "--samples", count)
    rows = list(csv.DictReader(io.StringIO(text)))
    assert len(rows) == count
    vector = lambda row, name: [float(row[name + axis]) for axis in "xyz"]
    given = ["t,e1x,e1y,e1z,f2x,f2y,f2z"]
    for k, row in enumerate(rows):
        f, T = transport.along(vector(rows[0], "f2"), k / 4)
        for mine, theirs in ((f, "f2"), (T, "e1")):
            error = plus(mine, vector(row, theirs), -1)
            assert dot(error, error) < 1e-16, (row["t"], theirs)
        given.append(",".join(map(repr, [k / 4, *T, *f])))
    table = tables / "frames.csv"
    table.write_text("\n".join(given) + "\n")
    timed("check", file, table)


def check_totals(file, is_closed, answer):
    totals = json.loads(timed("totals", file, "--print", "json"))
    assert near(-float(totals["up_twist"]["value"]), float(answer["total"]["value"]))
    info = json.loads(timed("info", file, "--print", "json"))
    assert info["closed"] == is_closed
    if is_closed:
        assert totals["holonomy"]["value"] == info["holonomy"]["value"] == answer["holonomy"]["value"]


def check(name, is_closed, pipe, folder):
    file = folder / "pipe.json"
    file.write_text(json.dumps(file_of(pipe)))
    transport = Transport(pipe)
    answer = check_angles(file, pipe, is_closed, transport)
    check_frames(file, pipe, transport, folder)
    check_totals(file, is_closed, answer)
    for to in ("0", "pi", "pi/2"):
        timed("mtf", file, "--from", "0", "--to", to)
    if is_closed:
        timed("mtf", file, "--from", "pi/4", "--closed")
    header = timed("compile", file)
    assert "phrame" in header
    timed("interpolate", file, "--feed", "1", "--period", "1/2")
    line = json.loads(timed("batch", file, "--at", "1"))
    assert "error" not in line, line
    timed("sweep", file, "--profile", "circle:1/10", "--tolerance", "0.01", "-o", folder / "pipe.ply")
    if writes_pages():
        timed("page", file, "-o", folder / "pipe.html")


def main():
    effort = int(os.environ.get("PHRAME_TEST_MULTIPLIER", "1"))
    stride = 200 // int(sys.argv[1]) if len(sys.argv) > 1 else 1 if effort > 1 else 61
    with tempfile.TemporaryDirectory() as folder:
        for name, is_closed, pipe in list(pipes(200))[::stride]:
            try:
                check(name, is_closed, pipe, Path(folder))
            except AssertionError as error:
                sys.exit("pipe %s: %s" % (name, error))
    if len(sys.argv) > 1:
        for command, seconds in times.items():
            print("%-12s %5d calls, mean %.3f s, most %.3f s" % (
                command, len(seconds), sum(seconds) / len(seconds), max(seconds)))


main()
