"""What the checks in Python have in common: the program. tests/with_python.sh makes this folder known."""
import os
import subprocess
import sys

PROGRAM = os.environ["PHRAME_PROGRAM"]


def output(*arguments):
    """What the program writes to its standard output, as bytes."""
    run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True)
    if run.returncode != 0:
        sys.exit("%s: %s" % (arguments, run.stderr.decode()))
    return run.stdout


def phrame(*arguments):
    return output(*arguments).decode()


def writes_pages():
    """Is the program built with what its pages are made with? That is said before any curve is read."""
    run = subprocess.run([PROGRAM, "page", os.devnull], capture_output=True)
    return b"built without npm" not in run.stderr
