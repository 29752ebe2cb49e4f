"""Tables of frames under a certificate (--table): those of the program are proved by both checkers; where one number of a table is the
next double, or a row is another, neither proves it, and both say the same.
"""
import json
import os
import struct
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path
from types import SimpleNamespace

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import check_certificate as checker

PROGRAM = os.environ["PHRAME_PROGRAM"]
EVERY = 1 if int(os.environ.get("PHRAME_TEST_MULTIPLIER", 1)) > 1 else 3
LIMITS = SimpleNamespace(max_degree=1001, unlimited=False)


def next_double(x, is_up):
    if x == 0:
        return 5e-324 if is_up else -5e-324
    (bits,) = struct.unpack("<q", struct.pack("<d", x))
    return struct.unpack("<d", struct.pack("<q", bits + (1 if (x > 0) == is_up else -1)))[0]


def phrame(*arguments, may_fail=False):
    run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if run.returncode > (1 if may_fail else 0):
        sys.exit("phrame %s: %s" % (" ".join(map(str, arguments)), run.stderr))
    return run.stdout


@cache
def proof_of(data):
    """Its statements, which the tables beside one certificate share."""
    proof = checker.proof_of(checker.read_certificate(data, LIMITS))
    proof.run()
    return proof


def verdicts(certificate, table, text):
    """Of the table, by each checker: None where it is proved, or why not."""
    table.write_text(text)
    proof = proof_of(certificate.read_bytes())
    proof.state("table", proof.table, (), checker.read_table(str(table)))
    mine = None if proof.lines[-1][0] else proof.lines[-1][1].split(": ", 1)[1]
    (line,) = [x for x in phrame("verify", certificate, "--table", table, may_fail=True).splitlines() if " table %s" % table in x]
    return mine, None if line.startswith("proved") else line.split(": ", 1)[1]


def bezier(*points):
    return {"phrame": "curve/1", "control_points": points}


SUBJECTS = [  # a curve of the collection or a file, where, of how many numbers one is changed
    *((name, "0,1/7,1/2,1", EVERY) for name in ("tame-01", "hard-rounding-01", "turning-multiplier-05", "plane-offsets-02")),
    (bezier([0, 0, 0], [1, 3, -2], [4, 1, 5], [2, -3, 1]), "0,1/7,1/2,1", 2 * EVERY),  # to the frame of a vector
    (bezier([0, 0, 0], [1, 0, 2], [5, 0, 3], [7, 0, -4]), "0,1/7,1/2,1", 4 * EVERY),  # plane, with numbers that are 0
    ({"phrame": "spline/1", "segments": [bezier([0, 0, 0], [2, 0, 0]), bezier([2, 0, 0], [3, 0, 0], [4, 1, 0], [4, 3, 5]),
                                         bezier([4, 3, 5], [4, 2, 7])]}, "0,1/7,3/2,2", 2 * EVERY),  # a line first; at a corner
    (bezier([0, 0, 0], [1, 2, 1], [3, 2, 1], [4, 0, 0]), "0,1/3,2/3,1", 2 * EVERY)]  # symmetric, so that the angle is 0 at the end


def main():
    tried = 0
    with tempfile.TemporaryDirectory() as folder:
        certificate, table, curve = (Path(folder) / name for name in ("angle.cert", "frames.csv", "curve.json"))
        for name, at, every in SUBJECTS:
            if isinstance(name, str):
                phrame("reference", name, "-o", curve)
            else:
                curve.write_text(json.dumps(name))
            phrame("certify", curve, "--at", at, "--digits", "40", "-o", certificate)
            text = phrame("frames", curve, "--at", at)
            if verdicts(certificate, table, text) != (None, None):
                sys.exit("%s: the program's own table: %s" % (name, verdicts(certificate, table, text)))
            head, *rows = text.splitlines()
            forged = ["\n".join([head, *rows[:-1]]), "\n".join([head, rows[0], rows[2], rows[1], rows[3]])]
            for k, row in enumerate(rows):
                cells = row.split(",")
                for i in range((k + len(name)) % every, len(cells), every):
                    x = float(cells[i])
                    other = repr(next_double(x, (i + k) % 2 == 1))
                    changed = ",".join([*cells[:i], other, *cells[i + 1:]])
                    forged.append("\n".join([head, *rows[:k], changed, *rows[k + 1:]]))
            for lie in forged:
                said = verdicts(certificate, table, lie + "\n")
                tried += 1
                if said[0] is None or said[0] != said[1]:
                    sys.exit("%s: %s of a table that is wrong:\n%s" % (name, said, lie))
            # With few digits the angle does not tell the double, and both say so.
            phrame("certify", curve, "--at", at, "--digits", "12", "-o", certificate)
            said = verdicts(certificate, table, text)
            if said[0] != said[1] or (name == "tame-01") and said[0] is None:
                sys.exit("%s, 12 digits: %s" % (name, said))
        # Of the Frenet frame there is no table.
        curve.write_text(json.dumps(SUBJECTS[4][0]))
        phrame("certify", curve, "--frame", "frenet", "-o", certificate)
        if verdicts(certificate, table, phrame("frames", curve, "--at", "1")) != ("the angles are not those to the frame of a vector",) * 2:
            sys.exit("to the Frenet frame: %s" % (verdicts(certificate, table, text),))
        # The rational arc is not known beyond its ends; the angle, which is 0, is.
        curve.write_text(json.dumps({"phrame": "curve/1", "control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0]], "weights": [1, 1, 2]}))
        phrame("certify", curve, "--at", "0,1", "-o", certificate)
        text = phrame("frames", curve, "--at", "0,1")
        if verdicts(certificate, table, text) != (None, None):
            sys.exit("an arc: %s" % (verdicts(certificate, table, text),))
        beyond = json.loads(certificate.read_text())
        beyond["claims"][1]["t"] = "2"
        certificate.write_text(json.dumps(beyond))
        if verdicts(certificate, table, text) != ("a t is not on the path",) * 2:
            sys.exit("an arc beyond its end: %s" % (verdicts(certificate, table, text),))
    print("%d forged tables" % tried)


if __name__ == "__main__":
    main()
