"""Certificates of paths: both checkers say the same, statement by statement, of those of the program, of forged ones and of tables of frames under
them; the angles are those of mpmath's quadrature, where that is there.
"""
import copy
import io
import json
import math
import os
import re
import subprocess
import sys
import tempfile
from argparse import Namespace
from contextlib import redirect_stderr, redirect_stdout
from fractions import Fraction
from itertools import zip_longest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import check_certificate as checker

PROGRAM = os.environ["PHRAME_PROGRAM"]
AT = "0,1/2,1,5/3,3"


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def phrame(*arguments):
    done = run(*arguments)
    return done.stdout if done.returncode == 0 else sys.exit("phrame %s: %s" % (" ".join(map(str, arguments)), done.stderr))


def both(path, curve=None, table=None):
    """(status, lines) of the script, and of the program; no lines where the file is none."""
    options = Namespace(quiet=False, curve=curve and str(curve), table=table and str(table), max_degree=1001, unlimited=False, files=[])
    out = io.StringIO()
    with redirect_stdout(out), redirect_stderr(io.StringIO()):
        status = checker.check(str(path), options)
    more = (["--curve", curve] if curve else []) + (["--table", table] if table else [])
    done = run("verify", path, *more)
    return (status, out.getvalue().splitlines()), (done.returncode, done.stdout.splitlines())


def statements(lines):
    """Without the reasons, which each has in its own words."""
    return [re.sub(r"^(not proved  (?:segment \d+: )?(?:decision \w+: \w+|[^:]*)): .*", r"\1", line) for line in lines]


def expect(status, what, *arguments, line=None, **more):
    mine, other = both(*arguments, **more)
    if mine[0] != status or other[0] != status or status < 2 and statements(mine[1]) != statements(other[1]):
        sys.exit("%s: the script %s, verify %s\n%s" % (what, mine[0], other[0], "\n".join(set(mine[1]) ^ set(other[1]))))
    if line and not any(text.startswith("not proved  " + line) for text in mine[1]):
        sys.exit("%s: it is not told that %s" % (what, line))


def angle_by_quadrature(certificate, t, mp):
    """The sum of the integrals of -2h/sigma."""
    total = mp.mpf(0)
    for k, segment in enumerate(certificate["segments"]):
        end = min(max(t - k, 0), 1)
        A = [[mp.mpf(c.numerator) / c.denominator for c in map(Fraction, reversed(segment["curve"]["preimage"][x]))] for x in "uvpq"]

        def rate(s):
            (u, du), (v, dv), (p, dp), (q, dq) = (mp.polyval(c or [0], s, derivative=1) for c in A)
            return -2 * (u * dv - du * v - p * dq + dp * q) / (u * u + v * v + p * p + q * q)
        if end > 0:
            total += mp.quad(rate, [0, mp.mpf(end.numerator) / (2 * end.denominator), mp.mpf(end.numerator) / end.denominator])
    return total


def check_angles(certificate):
    try:
        from mpmath import mp
    except ImportError:
        return print("mpmath is not installed")
    mp.dps = 40
    for claim in certificate["claims"]:
        off = angle_by_quadrature(certificate, Fraction(claim["t"]), mp) - mp.mpf(claim["theta"])
        if abs(off) > mp.mpf(claim["radius"]) * (1 + mp.mpf(10) ** -6):
            sys.exit("theta(%s) is off by %s" % (claim["t"], off))


def half_turned(honest):
    """With A i of the second segment, another frame of the same curve."""
    lie = copy.deepcopy(honest)
    A = lie["segments"][1]["curve"]["preimage"]
    A.update(u=["-" + x if x[0] != "-" else x[1:] for x in A["v"]], v=A["u"], p=A["q"],
             q=["-" + x if x[0] != "-" else x[1:] for x in A["p"]])
    return lie


def forgeries(honest):
    """(what is done, the status, which statement is told not to be proved)"""
    def changed(do):
        lie = copy.deepcopy(honest)
        do(lie)
        return lie
    claim = honest["claims"][3]
    text = "|theta(%s) - " % claim["t"]
    # What is said of the claims where the angle, its radius, a summand or a joint is not that.
    yield "another digit", 1, text, changed(lambda c: c["claims"][3].update(theta=claim["theta"][:-1] + "05"[claim["theta"][-1] == "0"]))
    yield "a small radius", 1, text, changed(lambda c: c["claims"][3].update(radius="1e-33"))
    yield "outside", 1, "|theta(4) - ", changed(lambda c: c["claims"][3].update(t="4"))
    yield "no summand", 1, "|theta(3) - ", changed(lambda c: c["segments"][0].update(claims=[x for x in c["segments"][0]["claims"] if x["t"] != "1"]))
    yield "a wrong summand", 1, "segment 0: |theta(1) - ", changed(lambda c: next(
        x for x in c["segments"][0]["claims"] if x["t"] == "1").update(theta="0.5"))
    yield "moved", 1, "joint 1: the segment does not begin", changed(lambda c: c["segments"][1]["curve"].update(start=["0", "0", "1"]))
    yield "the other way round", 1, "joint 1", changed(lambda c: c["segments"].reverse())
    yield "turned", 1, "joint 1: the Euler-Rodrigues frame does not go on", half_turned(honest)
    yield "no segments", 2, None, changed(lambda c: c.update(segments=[]))
    yield "another frame", 2, None, changed(lambda c: c["segments"][0].update(frame="frenet"))
    yield "another key", 2, None, changed(lambda c: c.update(note="?"))
    yield "a certificate as a segment of itself", 2, None, changed(lambda c: c["segments"].append(copy.deepcopy(honest)))


def product(a, b):
    c = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += Fraction(x) * Fraction(y)
    return [str(x) for x in c]


def forgeries_of_weights(honest):
    """Of a path of which the first and the last segment are rational, as above, and which statement of a table is not proved."""
    def changed(do, k=0):
        lie = copy.deepcopy(honest)
        do(lie["segments"][k])
        return lie

    def with_factor(c, a):
        c.update(position={key: product(x, a) for key, x in c["position"].items()}, hodograph=[product(product(x, a), a) for x in c["hodograph"]])

    def moved(c):
        c["curve"]["start"][2] = str(Fraction(c["curve"]["start"][2]) + 1)
        z, w = c["position"]["z"], c["position"]["w"]
        c["position"]["z"] = [str(Fraction(x) + Fraction(y)) for x, y in zip_longest(z, w, fillvalue=0)]

    def shown_as_rational(c):
        c["position"] = copy.deepcopy(honest["segments"][0]["position"])

    def set_to(key, value):
        return lambda c: c["position"].update({key: value})
    yield "the weight and the positions with a factor", 0, None, changed(lambda c: with_factor(c, ["1", "1"]))
    yield "a zero on the way", 1, "segment 0: weight", changed(lambda c: with_factor(c, ["-1", "2"]))
    yield "two equal zeros on the way", 1, "segment 2: weight", changed(lambda c: with_factor(c, ["1", "-4", "4"]), 2)
    yield "a zero at the end", 1, "joint 1: the weight", changed(lambda c: with_factor(c, ["1", "-1"]))
    yield "a zero at the start", 2, None, changed(lambda c: with_factor(c, ["0", "1"]))
    yield "the weight alone with a factor", 2, None, changed(lambda c: c["position"].update(w=product(c["position"]["w"], ["1", "1"])))
    yield "another weight", 2, None, changed(lambda c: c["position"]["w"].__setitem__(1, "81"))
    yield "another position", 2, None, changed(lambda c: c["position"]["x"].__setitem__(1, "81"))
    yield "no positions", 2, None, changed(lambda c: c.pop("position"))
    yield "no weight", 2, None, changed(lambda c: c["position"].pop("w"))
    yield "a constant weight", 2, None, changed(set_to("w", ["32"]))
    yield "moved", 1, "joint 2: the segment does not begin", changed(moved, 2)
    yield "another start", 2, None, changed(lambda c: c["curve"].update(start=["0", "0", "1"]))
    yield "another multiplier", 2, None, changed(lambda c: c["curve"]["multiplier"].update(numerator=["2"]))
    yield "another denominator", 2, None, changed(lambda c: c["curve"]["multiplier"]["denominator"].__setitem__(0, "65"))
    yield "a multiplier that is none", 2, None, changed(lambda c: c["curve"].update(multiplier=["1"]))
    yield "no pole", 2, None, changed(lambda c: c["curve"]["multiplier"].update(denominator=["1"]))
    yield "another hodograph", 1, "segment 0: invariants", changed(lambda c: c["hodograph"].reverse())
    yield "the positions of another segment", 2, None, changed(shown_as_rational, 2)
    yield "positions of a polynomial curve", 2, None, changed(shown_as_rational, 1)


BERNSTEIN, POWER = ({"phrame": "curve/1", "basis": basis} for basis in ("bernstein", "power"))
FORMS = [  # of one curve each; the frame of a plane curve does not tell A from A j
    {**BERNSTEIN, "preimage": {"u": [2, 0, 2], "v": [1, 1, 0], "p": [0, -2, 0], "q": [1, 2, 1]}},
    {**BERNSTEIN, "quaternions": [[2, 1, 0, 1], [0, 1, -2, "4/2"], [2, 0, 0, 1]]},
    {**BERNSTEIN, "hopf": {"alpha": [[2, 1], [0, 1], [2, 0]], "beta": [[1, 0], [2, -2], [1, 0]]}},
    {**POWER, "quaternions": [[2, 1, 0, 1], [-4, 0, -4, 2], [4, -1, 4, -2]]},
    {**POWER, "hopf": {"alpha": [[1], [0, 1]]}},
    {**BERNSTEIN, "hopf": {"alpha": [[1, 0]], "beta": [[0, 0], [1, 0]]}},
    {**BERNSTEIN, "quaternions": []},
    {**BERNSTEIN, "quaternions": [[0, 0, 0, 0]]},
    {**BERNSTEIN, "quaternions": [[1, 0, 0, 0]], "complex": [[1, 0]]},
    {**BERNSTEIN, "preimage": {"u": [2, 0, 2], "v": [1, 1, 0], "p": [0, -2, 0], "q": [1, 2, 1]}, "phrame": "curve/2"},
    {"basis": "power", "hopf": {"alpha": [[1], [0, 1]]}},
    {"phrame": "curve/1", "segments": [{**POWER, "quaternions": [[2, 1, 0, 1], [-4, 0, -4, 2], [4, -1, 4, -2]]}]},
    {**POWER, "position": {"x": [0, 1]}, "start": [0, 0, 0]}]
PLANE = [
    {**POWER, "complex": [[1, -1], [0, "2"]], "start": [0, 1, 0]},
    {**BERNSTEIN, "complex": [[1, -1], [1, 1]], "start": [0, 1, 0], "multiplier": [1, 1]},
    {**POWER, "preimage": {"u": [1], "v": [0], "p": [0], "q": [-1, 2]}, "start": [0, 1, 0]}]
TANGENTS = [
    {**POWER, "tangents": {"a": [0, 1], "b": [1], "support": {"numerator": [1, 0, 1], "denominator": [2, 1]}}},
    {**POWER, "tangents": {"a": [0, "3/3"], "b": [1], "support": {"numerator": [1, 0, 1], "denominator": ["2", "1"]}}},
    {**BERNSTEIN, "tangents": {"a": [0, 1], "b": [1], "support": {"numerator": [1, 1, 2], "denominator": [2, 3]}}},
    {**POWER, "tangents": {"a": [1], "b": [1], "support": [1]}},
    {**POWER, "tangents": {"a": [0, 1], "b": [1], "support": {"numerator": [1], "denominator": []}}}]


def check_forms(folder):
    """A certificate of the first of some files is one of all of them that have that curve, and what is no curve is refused."""
    given, certificate = folder / "given.json", folder / "given.cert"
    for forms, same, other in ((FORMS, 4, PLANE[0]), (PLANE, 3, TANGENTS[0]), (TANGENTS, 3, FORMS[1])):
        given.write_text(json.dumps(forms[0]))
        phrame("certify", given, "--digits", "8", "-o", certificate)
        for k, form in enumerate(forms):
            given.write_text(json.dumps(form))
            expect(0 if k < same else 2, json.dumps(form), certificate, curve=given)
        given.write_text(json.dumps(other))
        expect(1, "another curve", certificate, curve=given, line="curve of")


QUADRATICS = {"u": ["2", "-4", "4"], "v": ["1", "0", "-1"], "p": ["0", "-4", "4"], "q": ["1", "2", "-2"]}, {
    "u": ["1", "2"], "v": ["1", "-1"], "p": ["2", "0"], "q": ["0", "3"]}


def rotated(A, x):
    """A x A* for a vector x; only products of quaternions are asked of it."""
    def times(a, b):
        return (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
                a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])
    y = times(times(A, (0, *x)), (A[0], -A[1], -A[2], -A[3]))[1:]
    size = sum(a * a for a in A)
    return [a / size for a in y]


def check_corner(folder):
    """Through a corner: the Euler-Rodrigues frame of the certificate turned by its angle is the first normal, carried by least
    rotations from each of many tangents to the next, which is right to some 1e-6."""
    curve, certificate, lie = (folder / name for name in ("corner.json", "corner.cert", "lie.cert"))
    first = {"phrame": "curve/1", "basis": "power", "preimage": QUADRATICS[0]}
    curve.write_text(json.dumps({"phrame": "spline/1", "segments": [first, {"basis": "power", "preimage": QUADRATICS[1]}]}))
    phrame("certify", curve, "--at", "1,2", "--digits", "20", "-o", certificate)
    expect(0, "a corner", certificate, curve=curve)
    honest, steps, carried, before = json.loads(certificate.read_text()), 1500, None, None
    for segment, claim in zip(honest["segments"], honest["claims"]):
        c = [[float(Fraction(x)) for x in segment["curve"]["preimage"][key]] for key in "uvpq"]
        for k in range(steps + 1):
            A = [sum(x * (k / steps) ** n for n, x in enumerate(a)) for a in c]
            e = rotated(A, (1, 0, 0))
            if carried is None:
                carried = rotated(A, (0, 1, 0))
            elif sum(x * y for x, y in zip(before, e)) < 1 - 1e-15:
                w = sum(x * y for x, y in zip(carried, e)) / (1 + sum(x * y for x, y in zip(before, e)))
                carried = [x - w * (a + b) for x, a, b in zip(carried, before, e)]
            before = e
    theta = float(claim["theta"])
    f2 = [math.cos(theta) * x + math.sin(theta) * y for x, y in zip(rotated(A, (0, 1, 0)), rotated(A, (0, 0, 1)))]
    if max(abs(x - y) for x, y in zip(f2, carried)) > 1e-5:
        sys.exit("behind a corner the frame is off: %s, %s" % (f2, carried))
    side, negative = copy.deepcopy(honest), lambda a: [("-" + x).removeprefix("--") for x in a]
    part = side["segments"][1]
    part["curve"]["multiplier"], part["hodograph"] = negative(part["curve"]["multiplier"]), [*map(negative, part["hodograph"])]
    lie.write_text(json.dumps(side))
    expect(1, "f negative behind a corner", lie, line="joint 1: the tangent changes its side")
    lie.write_text(json.dumps(half_turned(honest)))
    expect(1, "turned behind a corner", lie, line="joint 1: the Euler-Rodrigues frame does not go on")


def main():
    tried = 0
    with tempfile.TemporaryDirectory() as folder:
        points, certificate, table, lie, curve = (Path(folder) / name for name in ("points.csv", "path.cert", "frames.csv", "lie.cert", "path.json"))
        points.write_text("0,0,0\n1,2,0\n3,2,1\n4,0,3\n")
        phrame("construct", points, "-o", curve)
        rational = ROOT / "tests/data/rational-path.json"
        check_forms(Path(folder))
        check_corner(Path(folder))
        for path, at in ((curve, AT), (ROOT / "examples/curves/closed-spline.json", "0,1,7/3,3,4"), (rational, AT)):
            phrame("certify", path, "--at", at, "--digits", "30", "-o", certificate)
            expect(0, path.name, certificate)
            honest = json.loads(certificate.read_text())
            check_angles(honest)
            table.write_text(phrame("frames", path, "--at", at))
            expect(0, "the table", certificate, table=table)
            head, *rows = table.read_text().splitlines()
            cells = rows[3].split(",")
            k = next(k for k in range(7, 13) if float(cells[k]))
            cells[k] = repr(float(cells[k]) * (1 + 2 ** -51))
            table.write_text("\n".join([head, *rows[:3], ",".join(cells), *rows[4:]]) + "\n")
            expect(1, "another table", certificate, table=table, line="table")
        # Of the rational one, the last.
        table.write_text("\n".join([head, *rows]) + "\n")
        expect(0, "its curve", certificate, curve=rational, table=table)
        expect(1, "another curve", certificate, curve=curve, line="curve of")
        for what, status, line, forged in forgeries_of_weights(honest):
            lie.write_text(json.dumps(forged))
            expect(status, what, lie, line=line, curve=rational if status == 0 else None)
            if line and "weight" in line:
                expect(1, what, lie, line="table", table=table)
            tried += 1
        phrame("certify", curve, "--at", AT, "--digits", "30", "-o", certificate)
        expect(0, "its curve", certificate, curve=curve)
        expect(1, "another curve", certificate, curve=ROOT / "examples/curves/bezier-quintic.json", line="curve of")
        for what, status, line, forged in forgeries(json.loads(certificate.read_text())):
            lie.write_text(json.dumps(forged))
            expect(status, what, lie, line=line)
            tried += 1
    print("%d forged certificates of paths" % tried)


if __name__ == "__main__":
    main()
