"""`phrame batch` as a filter that is interrupted: order, threads, signals, resumption, GNU parallel.

The answers of one undisturbed run with one thread are the reference; all other ways give the same bytes.
"""
import fcntl
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

PROGRAM = os.environ["PHRAME_PROGRAM"]
LINES = 800


def line(k, rng):
    """Mostly quintics, some curves that take a hundred times as long, some lines that are refused."""
    degree = 25 if k % 200 == 7 else 2
    preimage = {c: [rng.randint(-9, 9) for _ in range(degree)] + [rng.randint(1, 9)] for c in "uvpq"}
    if k % 100 == 3:
        preimage["p"][0] = "1/0"
    return json.dumps({"id": k, "curve": {"basis": "power", "preimage": preimage}, "at": ["1"]}) + "\n"


def batch(*arguments, **streams):
    return subprocess.run([PROGRAM, "batch", *arguments], stderr=subprocess.PIPE, **streams)


def require(truth, what):
    if not truth:
        sys.exit(f"batch_check: {what}")


def check_whole_lines(data, reference):
    """Whole lines, those of the reference up to some place."""
    require(data == reference[: len(data)], "not what the reference begins with")
    require(not data or data.endswith(b"\n"), "the last line is not whole")


def started(output, wanted=100):
    """A running batch whose output has this many lines. It cannot finish: its last line never comes."""
    Path(output).unlink(missing_ok=True)
    process = subprocess.Popen([PROGRAM, "batch", "-o", output], stdin=subprocess.PIPE, stderr=subprocess.PIPE)

    def feed():
        try:
            process.stdin.write(Path("lines").read_bytes().rpartition(b"\n")[0] + b"\n")
            process.stdin.flush()
        except BrokenPipeError:  # it was interrupted
            pass

    threading.Thread(target=feed, daemon=True).start()
    while process.poll() is None and (not Path(output).exists() or Path(output).read_bytes().count(b"\n") < wanted):
        time.sleep(0.001)
    require(process.poll() is None, "finished before it could be interrupted")
    return process


def check_refusals():
    for arguments, complaint in (
        (["lines", "-o", "lines"], b'--output: "lines" is the input'),
        (["nowhere"], b"nowhere: cannot be opened: No such file"),
        (["lines", "-o", "no/where"], b"no/where: cannot be opened: No such file"),
        (["lines", "--at", "x"], b"--at: "),
        (["lines", "--frame", "bishop"], b"--frame: "),
        (["."], b".: cannot be read: Is a directory"),
    ):
        before = Path("lines").read_bytes()
        run = batch(*arguments, stdout=subprocess.PIPE)
        require(run.returncode == 2 and run.stdout == b"", f"{arguments} are not refused")
        require(complaint in run.stderr and run.stderr.count(b"\n") == 1, f"{arguments}: {run.stderr}")
        require(Path("lines").read_bytes() == before, "the input was changed")


def check_threads(reference):
    for threads in (2, 4):
        run = batch("--threads", str(threads), "lines", stdout=subprocess.PIPE)
        require(run.stdout == reference, f"{threads} threads give other bytes")
        require(run.returncode == 1 and b" lines failed: " in run.stderr and run.stderr.count(b"\n") == 1,
                "refused lines are not told")


def check_signals(reference):
    for number in (signal.SIGINT, signal.SIGTERM):
        process = started("out")
        process.send_signal(number)
        process.wait(60)
        require(process.returncode == -number, f"ended by {process.returncode}, not by the signal")
        data = Path("out").read_bytes()
        check_whole_lines(data, reference)
        require(len(data) < len(reference), "the signal had no effect")
        batch("lines", "-o", "out", "--skip-done", "out")
        require(Path("out").read_bytes() == reference, "not completed after a signal")
    waiting = subprocess.Popen([PROGRAM, "batch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    waiting.stdin.write(b'{"id": 1}\n{"id": 2')
    waiting.stdin.flush()
    require(waiting.stdout.readline().startswith(b'{"id":1,"error"'), "an answer waits for the next line")
    waiting.send_signal(signal.SIGINT)
    require(waiting.wait(60) == -signal.SIGINT, "waits for input after a signal")
    require(waiting.stdout.read() == b"", "half a line was answered")


def check_kill(reference):
    process = started("out")
    process.kill()
    process.wait()
    cut_off = b'{"id":%d,"phra' % (LINES - 1)
    with open("out", "ab") as out:  # as if it had been killed while it wrote
        out.write(cut_off)
    shutil.copy("out", "copy")
    run = batch("lines", "-o", "out", "--skip-done", "out")
    require(Path("out").read_bytes() == reference, "not completed after a kill")
    require(Path("out.damaged").read_bytes() == cut_off + b"\n", "what was cut off is not kept aside")
    said = b"phrame: out: the last line was cut off; its %d bytes are kept in out.damaged\n" % len(cut_off)
    require(run.stderr.startswith(said), f"what was cut off is not told: {run.stderr}")
    with open("copy", "ab") as copy:
        batch("lines", "--skip-done", "copy", stdout=copy)
    require(Path("copy").read_bytes() == reference, "not completed by >> after a kill")
    require(Path("copy.damaged").read_bytes() == cut_off + b"\n", "not kept aside by >>")
    run = batch("lines", "-o", "out", "--skip-done", "out")
    require(Path("out.damaged").read_bytes() == cut_off + b"\n" and run.stderr == b"", "told where nothing was cut off")
    # A last line that lacks but its end is whole: it is kept, and ended.
    first = reference[:reference.index(b"\n", len(reference) // 2)]
    Path("open").write_bytes(first)
    run = batch("lines", "-o", "open", "--skip-done", "open")
    require(Path("open").read_bytes() == reference, "not completed after a line without an end")
    require(not Path("open.damaged").exists() and b"cut off" not in run.stderr, "a whole line is called cut off")
    Path("open").write_bytes(first)
    with open("open", "ab") as out:
        batch("lines", "--skip-done", "open", stdout=out)
    require(Path("open").read_bytes() == reference, "not completed by >> after a line without an end")
    # Into another file: the rest only.
    rest = batch("lines", "--skip-done", "out", stdout=subprocess.PIPE)
    require(rest.stdout == b"" and rest.returncode == 0, "what was done is done again")


# The worker of GNU parallel that is killed. The first one gives phrame all but the last of its lines, every other one
# being blank, and then nothing: it cannot finish, however small its block is.
WORKER = """#!/bin/sh
mkdir taken 2>/dev/null || exec "$PHRAME_PROGRAM" "$@"
cat >block
touch waiting
{ head -n -2 block; while test -e waiting; do sleep 0.05; done; } | "$PHRAME_PROGRAM" "$@" &
echo $! >named
mv named worker
wait $!
kill -KILL $$
"""


def check_lock():
    """Two at a time do not write to one file."""
    first = subprocess.Popen([PROGRAM, "batch", "-o", "one", "--skip-done", "one"], stdin=subprocess.PIPE)
    first.stdin.write(b'{"id": 1}\n')
    first.stdin.flush()
    for _ in range(6000):
        if Path("one").exists() and Path("one").read_bytes():
            break
        time.sleep(0.01)
    for options in (["--skip-done", "one"], []):
        second = subprocess.run([PROGRAM, "batch", "lines", "-o", "one", *options], capture_output=True)
        require(second.returncode == 2 and second.stderr == b"phrame: one: another phrame batch is writing to it\n",
                f"a second one writes, too: {second.stderr}")
    first.stdin.close()
    first.wait(60)
    require(Path("one").read_bytes().count(b"\n") == 1, "what the first one wrote is gone")
    # What is no regular file is anybody's.
    with open("/dev/null", "w") as null:
        fcntl.flock(null, fcntl.LOCK_SH)
        run = subprocess.run([PROGRAM, "batch", "-o", "/dev/null"], input=b"", capture_output=True)
    require(run.returncode == 0, f"/dev/null is locked: {run.stderr}")


def check_time_limit():
    """A line that takes minutes holds up nobody: neither the lines behind it, nor the signal that ends the program."""
    easy = {"basis": "power", "preimage": {"u": [1], "v": ["0", "1/2"], "p": [0, 0, 3], "q": [0.25]}}
    hard = {"basis": "power", "preimage": {c: [k * k % 17 - 8 for k in range(a, a + 60)] for a, c in enumerate("uvpq")}}
    curves = [easy, hard, easy, hard, easy]
    Path("hard").write_text("".join(json.dumps({"id": k, "curve": c, "digits": 50_000 if c is hard else 9}) + "\n"
                                    for k, c in enumerate(curves)))
    run = batch("hard", "--time-limit", "0.2", "--threads", "1", "--at", "1", stdout=subprocess.PIPE)
    answers = [json.loads(answer) for answer in run.stdout.splitlines()]
    require([answer["id"] for answer in answers] == list(range(len(curves))), "lines beside a hard one are not answered")
    for answer, curve in zip(answers, curves):
        require(answer.get("error", {}).get("status") == (4 if curve is hard else None), f"not limited: {str(answer)[:200]}")
    require(answers[0]["values"] == answers[4]["values"], "another answer behind one that was stopped")
    for number in (signal.SIGINT, signal.SIGTERM):
        process = subprocess.Popen([PROGRAM, "batch", "hard", "--at", "1"], stdout=subprocess.PIPE)
        require(json.loads(process.stdout.readline())["id"] == 0, "no first answer")
        process.send_signal(number)
        require(process.wait(20) == -number, "a signal waits for a hard line")
        require(process.stdout.read() == b"", "a line that was stopped is answered")
    Path("hard.json").write_text(json.dumps({"phrame": "curve/1", **hard}))
    run = subprocess.run([PROGRAM, "angle", "hard.json", "--digits", "50000", "--at", "1", "--time-limit", "0.2", "-o", "hard.out"],
                         capture_output=True)
    require(run.returncode == 4 and run.stdout == b"" and run.stderr == b"phrame: undecided within --time-limit 0.2 s\n",
            f"a command is not limited: {run}")
    require(not list(Path(".").glob("hard.out*")), "something was written")


def check_parallel(reference):
    """The recipes of docs/cluster.md; -q since the program's path may have blanks."""
    if shutil.which("parallel") is None:
        print("parallel is not installed: the recipe for GNU parallel is not tried, all else is right")
        sys.exit(77)
    recipe = "parallel -q --pipe --block 100k --keep-order -j 2 '{}' batch --threads 1 <lines 2>/dev/null"
    run = subprocess.run(recipe.format(PROGRAM), shell=True, stdout=subprocess.PIPE)
    require(run.stdout == reference, "GNU parallel gives other bytes")
    Path("first").write_text(WORKER)
    Path("first").chmod(0o755)
    with open("out", "wb") as out:
        process = subprocess.Popen(recipe.format("./first"), shell=True, stdout=out)
        while process.poll() is None and not Path("worker").exists():
            time.sleep(0.001)
        require(process.poll() is None, "no worker was killed")
        time.sleep(0.05)
        os.kill(int(Path("worker").read_text()), signal.SIGKILL)
        Path("waiting").unlink()
        process.wait()
    lost = len(set(reference.splitlines()) - set(Path("out").read_bytes().splitlines()))
    require(lost > 0, "the killed worker had nothing left to do")
    with open("out", "ab") as out:
        batch("lines", "--skip-done", "out", stdout=out)
    answers = Path("out").read_bytes().splitlines()
    require(sorted(answers) == sorted(reference.splitlines()), "lost or doubled after a worker was killed")


def main():
    with tempfile.TemporaryDirectory(prefix="phrame-batch-") as folder:
        os.chdir(folder)
        rng = random.Random(7)
        Path("lines").write_text("\n".join(line(k, rng) for k in range(LINES)))  # every other line is blank
        reference = batch("--threads", "1", "lines", stdout=subprocess.PIPE).stdout
        ids = [json.loads(answer)["id"] for answer in reference.splitlines()]
        require(ids == list(range(LINES)), "the answers are not in the order of the lines")
        check_refusals()
        check_threads(reference)
        check_signals(reference)
        check_kill(reference)
        check_lock()
        check_time_limit()
        check_parallel(reference)
        os.chdir("/")


main()
