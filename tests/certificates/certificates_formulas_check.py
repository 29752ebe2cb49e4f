"""Certificates of curves by formulas, and of paths with such segments: both checkers prove the honest ones, whose values are those of
mpmath's quadrature of the torsion, of e2'.e3 and of |r'|, as these are defined, and at corners of rotated vectors; they refuse
forged ones, and decide alike to the last bit.
"""
import copy
import io
import json
import os
import subprocess
import sys
import tempfile
from argparse import Namespace
from contextlib import redirect_stderr, redirect_stdout
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import check_certificate as checker

PROGRAM = os.environ["PHRAME_PROGRAM"]
ALL = int(os.environ.get("PHRAME_TEST_MULTIPLIER", 1)) > 1


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def by_script(path, curve=None):
    options = Namespace(quiet=False, curve=curve and str(curve), table=None, max_degree=1001, unlimited=False, files=[])
    out = io.StringIO()
    with redirect_stdout(out), redirect_stderr(out):
        status = checker.check(str(path), options)
    return status, out.getvalue()


def expect(status, what, path, curve=None, line=""):
    done = run("verify", path, *(["--curve", curve] if curve else []))
    mine, other = by_script(path, curve), (done.returncode, done.stdout + done.stderr)
    if mine[0] != status or other[0] != status or line not in mine[1] or line not in other[1]:
        sys.exit("%s: %d is expected, the script %s, verify %s" % (what, status, mine, other))


def expect_each(are_proved, what, path):
    """Of the claims of a certificate these are proved, and those not, and so is all that they rest on."""
    done = run("verify", path)
    for status, text in (by_script(path), (done.returncode, done.stdout)):
        lines = text.splitlines()[:-1]
        found = [line.startswith("proved ") for line in lines if "  |theta(" in line]
        others = [line for line in lines if line.startswith("not proved ") and "  |theta(" not in line]
        if status != 1 or found != are_proved or others:
            sys.exit("%s: %s is expected, and found: %d, %s" % (what, are_proved, status, text))


def expect_refused(here, lies):
    """Of (what it is, what is told, a certificate): both checkers refuse them, verify in one run, and say where that is in the file."""
    paths = [here / ("%d.lie" % k) for k in range(len(lies))]
    for path, (_, _, lie) in zip(paths, lies):
        path.write_text(json.dumps(lie))
    done = run("verify", *paths)
    told = done.stdout.splitlines()
    if done.returncode != 2 or len(told) != len(paths):
        sys.exit("verify of %d files: %s" % (len(paths), done))
    for path, other, (what, line, _) in zip(paths, told, lies):
        status, mine = by_script(path)
        if status != 2 or not other.startswith("%s:/" % path) or line not in mine or line not in other:
            sys.exit("%s: to be refused, the script %d, %s, verify %s" % (what, status, mine, other))


# ---- honest ones

def curve(x, y, z, start=0, end=1, **more):
    return {"phrame": "curve/1", "expressions": {"x": x, "y": y, "z": z}, "from": start, "to": end, **more}


PART = curve("(2 + cos(3*s))*cos(2*s)", "(2 + cos(3*s))*sin(2*s)", "sin(3*s)", 0, "pi/3")
TREFOIL = curve("(2 + cos(3*s))*cos(2*s)", "(2 + cos(3*s))*sin(2*s)", "sin(3*s)", 0, "2*pi")
LOG = curve("s*log(1 + s)", "sqrt(1 + s^2)", "(1 + s)*atan(s)", -0.5, "1/3")
SUBJECTS = [  # name, curve, arguments
    ("trefoil, Frenet", TREFOIL, ["--frame", "frenet", "--digits", "9"]),
    ("trefoil", PART, ["--digits", "8", "--at", "1/3,1"]),
    ("helix", curve("3*cos(s)", "3*sin(s)", "4*s", 0, "4*pi"), ["--digits", "30"]),
    ("exp", curve("exp(-u)*cos(2*u)", "exp(-u)*sin(2*u)", "exp(u/3)", "0", "1", variable="u"), ["--digits", "12", "--frame", "up", "--up", "1,-2,3"]),
    ("length of exp", curve("exp(-s)*cos(2*s)", "exp(-s)*sin(2*s)", "exp(s/3)"), ["--length", "--digits", "12", "--at", "2/7,1"]),
    ("log, sqrt and atan", LOG, ["--digits", "10", "--frame", "frenet"]),
    ("raised digits", curve("x² − 2·x⁻³", "exp(−x²)", "sin(x)²·x", 1, "3⁻¹·π"), ["--digits", "8"]),
    ("others", curve("tan(t)/2", "asin(t/2) + cosh(t)", "t**(2/3) - e^t/t**3", "pi/8", 1), ["--digits", "8", "--up", "0,1,1/3"]),
    ("plane", curve("s", "sin(s)", 0, 1, 2), ["--digits", "10", "--frame", "frenet"])]


def spline(*segments):
    return {"phrame": "spline/1", "segments": list(segments)}


CORNER = spline(curve("cos(s)", "sin(s)", "s/3", 0, "pi/2"), curve("s", "exp(s)", "pi/6 + s^2"))
SMOOTH = spline(curve("cos(s)", "sin(s)", "s", 0, "pi/2"), curve("cos(s)", "sin(s)", "s", "pi/2", "pi"))
SUBJECTS += [
    ("corner", CORNER, ["--digits", "12", "--up", "1,-7,2"]),
    ("smooth joint", SMOOTH, ["--digits", "10"]),
    ("helices, Frenet", SMOOTH, ["--digits", "10", "--frame", "frenet"]),
    # Behind the corner, about the z axis, both binormals are along that axis.
    ("corner, Frenet", spline(curve("sin(s)", "1 - cos(s)", "s^3", -1, 0), curve("sin(s)", "2*s + sin(s)^2", "s^3*exp(s)")), ["--digits", "10", "--frame", "frenet"]),
    ("length of two", CORNER, ["--length", "--digits", "10", "--at", "1/2,3/2,2"]),
    # r' = (2t - 1)(1, t, 1 + t^2) has a cusp, behind which e1 = -r'/|r'| goes on, also through a corner and along formulas.
    ("cusp", spline({"basis": "power", "position": {"x": [0, -1, 1], "y": [0, 0, "-1/2", "2/3"], "z": [0, -1, 1, "-1/3", "1/2"]}},
                    curve("exp(s) - 1", "1/6 + sin(s)", "1/6 + s + s^2"), curve("exp(1) - 1 + s", "1/6 + sin(1) + s^2", "13/6 + 3*s")),
     ["--digits", "10", "--up", "1,-7,2"]),
    ("mixed", json.loads((ROOT / "examples" / "any" / "mixed.json").read_text()), ["--digits", "10", "--at", "1,5/2,3"])]


# The angle is exactly 0: r(c - s) or r(s + d) is r(s) but for a motion that turns v over or not and changes the orientation.
SYMMETRIC = [  # name, curve, t, v or none for the Frenet frame, symmetry
    ("mirror", curve("2*cos(s)", "sin(s)", "cos(2*s)/7", 0, "2*pi"), "1/2", "0,0,1", "mirror"),
    ("mirror of a third", curve("cos(s)", "sin(s)", "cos(3*s)/3", 0, "2*pi"), "1/3", "0,0,1", "mirror"),
    ("mirror, Frenet", curve("2*cos(s)", "sin(s)", "s^2/7 - cos(s*1)^2*s*sin(3*s)", "-pi/3", "pi/3"), "1", None, "mirror"),
    ("mirror with numbers", curve("sin(s - 1)", "cos(s - 1)", "(s - 1)^2", "-1/2", "5/2"), "1", "0,0,1", "mirror"),
    ("shift", curve("4*cos(s) + cos(5*s)", "4*sin(s) + sin(5*s)", "sin(6*s)/2", 0, "2*pi"), "1", "0,0,1", "1/4"),
    ("shift, Frenet", curve("cos(s)", "sin(s)", "cos(2*s + pi/7)/3", "2*pi/9", "20*pi/9"), "1/2", None, "1/4"),
    ("plane", curve("exp(s)", "1", "s", 0, 1), "1", "0,1,0", "none"),
    ("plane, sine", curve("s", "1", "sin(s)", 0, 1), "1", "0,1,0", "mirror"),
    ("polynomial", {"phrame": "curve/1", "basis": "power", "position": {"x": [0, 1], "y": [0, 1, -1], "z": [0, 0, 1, -2, 1]}}, "1", "0,0,1", "mirror"),
    ("rational", {"phrame": "curve/1", "control_points": [[-3, 0, 0], [-1, 2, 1], [1, 2, 1], [3, 0, 0]], "weights": [1, 2, 2, 1]}, "1", "0,0,1", "mirror")]


# Nearly so: N is odd, as y'' = 1 + sin s and z' = (1 - sin s) sin s, or 1 + s and s (1 - s), but D is not even.
NEARLY = [curve("s", "s^2/2 - sin(s)", "sin(2*s)/4 - cos(s) - s/2", -1, 1), curve("s", "s^2/2 + s^3/6", "s^2/2 - s^3/3", -1, 1)]


def check_symmetric(here):
    """They are proved to be 0 with the radius 0, and `phrame angle` says so; forged ones are not."""
    path, file, number = here / "a.cert", here / "a.json", 0
    for name, value, t, up, symmetry in SYMMETRIC:
        file.write_text(json.dumps(value))
        frame = ["--frame", "frenet"] if up is None else ["--up", up]
        done = run("certify", file, *frame, "--at", t, "--digits", "9", "-o", path)
        honest = json.loads(path.read_text()) if not done.returncode else {}
        claim = honest.get("claims", [{}])[0]
        if symmetry == "none":
            if "symmetry" in claim or claim["radius"] == "0":
                sys.exit("%s: %s" % (name, claim))
            continue
        if claim != {"t": t, "theta": "0", "radius": "0", "symmetry": symmetry}:
            sys.exit("%s: %s, %s" % (name, done.stderr, claim))
        expect(0, name, path, curve=file)
        if ALL and t == "1" and "expressions" in value:
            check_value(name, value, honest)
        asked = json.loads(run("angle", file, *frame, "--at", t, "--print", "json").stdout)
        if asked["values"][0].get("radius", "0") != "0" or asked["values"][0]["theta"] != "0":
            sys.exit("%s: angle says %s" % (name, asked["values"]))
        other = {"mirror": "1/2"}.get(symmetry, "mirror")
        lies = [{"theta": "1e-900"}, {"t": "0"}]
        lies += [{"t": "2/5"}, {"symmetry": "1/3"}, {"symmetry": other}] * (name != "plane, sine")  # whose angle is 0 all along
        refused = [{"symmetry": "-1/2"}, {"symmetry": "0"}, {"symmetry": 1}, {"symmetry": "mirrors"}, {"length": "1"}]
        expect_refused(here, [("%s, %s" % (name, change), "", {**honest, "claims": [{**claim, **change}]}) for change in refused])
        # Of one curve each is judged by itself, so that its pieces need be proved but once.
        claims = [{**claim, **change} for change in (*lies, {"theta": "1e-9", "radius": "1e-9"})]
        path.write_text(json.dumps({**honest, "claims": claims}))
        expect_each([False] * len(lies) + [True], name, path)
        number += len(refused) + len(claims)
        if name == "mirror":
            for k, near in enumerate(NEARLY):
                file.write_text(json.dumps(near))
                run("certify", file, "--up", "0,0,1", "--digits", "5", "-o", path)
                lie = json.loads(path.read_text())
                path.write_text(json.dumps({**lie, "claims": [{**claim, "t": "1"}]}))
                expect(1, "nearly symmetric %d" % k, path, line="not proved  |theta(1) - ")
                number += 1
        for key, formula in (("z", "cos(2*s) + s/1000"), ("from", "1/1000"), ("x", "2*cos(s + 1/10)")) if name == "mirror" else ():
            lie = copy.deepcopy(honest)
            lie["segments"][0]["expressions"][key] = formula
            path.write_text(json.dumps(lie))
            expect(1, "%s, %s" % (name, formula), path, line="not proved  |theta(1/2) - ")
            number += 1
    return number


def check_work_of_symmetry(here):
    """Both count the same work: with so many claims that each may just take what it takes both prove them, with one more neither."""
    path, file, spent = here / "a.cert", here / "a.json", []
    file.write_text(json.dumps(curve("2*cos(s)", "sin(s)", "cos(2*s)^20/7 + pi*cos(4*s)*(1/123456789)", 0, "2*pi")))
    run("certify", file, "--up", "0,0,1", "--at", "1/2", "--digits", "5", "-o", path)
    honest, spend = json.loads(path.read_text()), checker.Waves.spend

    def counted(waves, *arguments):
        before = waves.room
        spend(waves, *arguments)
        spent.append(before - waves.room)
    checker.Waves.spend = counted
    expect(0, "symmetry", path)
    checker.Waves.spend = spend
    most = checker.MAX_SYMMETRY // sum(spent)
    for number, status in ((most, 0), (most + 1, 1)):
        path.write_text(json.dumps({**honest, "claims": honest["claims"] * number}))
        expect(status, "%d symmetries" % number, path)


def check_value(name, value, certificate):
    """The last claim is that of mpmath's quadrature; derivatives are those of mpmath's Taylor series."""
    try:
        from mpmath import mp
    except ImportError:
        return
    mp.dps = 15
    names = {key: getattr(mp, key) for key in ("sin", "cos", "exp", "log", "sqrt", "atan", "asin", "tan", "cosh", "e", "pi")}
    number = lambda text, **more: mp.mpf(eval(str(text).replace("^", "**"), {**names, **more}))
    variable = "t" if name == "others" else "u" if name == "exp" else "s"
    up = [number(x) for x in certificate.get("up", [])]
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    def derivatives(given, s):
        series = [mp.taylor(lambda x: number(given[key], **{variable: x}), s, 3) for key in "xyz"]
        return [[row[n] * mp.factorial(n) for row in series] for n in (1, 2, 3)]

    def rate(given, s):
        d, e, f = derivatives(given, s)
        speed = mp.sqrt(dot(d, d))
        if certificate["frame"] == "none":
            return speed
        if certificate["frame"] == "frenet":
            bend = cross(d, e)
            return -speed * dot(bend, f) / dot(bend, bend)
        n, slope = cross(up, d), cross(up, e)
        size = mp.sqrt(dot(n, n))
        e2 = [x / size for x in n]
        return -dot([(x - y * dot(e2, slope)) / size for x, y in zip(slope, e2)], cross([x / speed for x in d], e2))

    def turn(a, b):
        """v x a rotated about a x b by the angle of a and b, against v x b; about b."""
        axis, side, other = cross(a, b), cross(up, a), cross(up, b)
        size, along = mp.sqrt(dot(axis, axis)), [x / mp.sqrt(dot(b, b)) for x in b]
        angle, n = mp.atan2(size, dot(a, b)), [x / size for x in axis]
        moved = [mp.cos(angle) * x + mp.sin(angle) * y + (1 - mp.cos(angle)) * dot(n, side) * z for x, y, z in zip(side, cross(n, side), n)]
        return mp.atan2(dot(cross(other, moved), along), dot(other, moved))
    total, before = 0, None
    for part in value.get("segments", [value]):
        given, a, b = part["expressions"], number(part["from"]), number(part["to"])
        if name == "trefoil, Frenet":  # the trapezoidal rule of a period converges geometrically
            total += sum(rate(given, a + (b - a) * k / 150) for k in range(150)) * (b - a) / 150
        else:
            total += mp.quadgl(lambda s: rate(given, s), mp.linspace(a, b, 41 if "shift" in name else 13 if name == "helix" else 3), maxdegree=3)
        if name == "corner" and before:
            total += turn(before, derivatives(given, a)[0])
        before = derivatives(given, b)[0]
    stated = mp.mpf(certificate["claims"][-1].get("theta", certificate["claims"][-1].get("length")))
    if abs(total - stated) > mp.mpf("1e-7") * max(1, abs(stated)) + mp.mpf(certificate["claims"][-1]["radius"]):
        sys.exit("%s: quadrature finds %s, stated is %s" % (name, total, stated))


def check_to_the_last_bit(name, certificate, path):
    """With the least radius that follows from the pieces both prove the claim, with a smaller one neither does."""
    proof = checker.proof_of(checker.read_certificate(json.dumps(certificate).encode(), Namespace(max_degree=1001, unlimited=False)))
    proof.run()
    bounds = [proof.bounds(k, Fraction(1)) for k in range(len(proof.parts))] + [proof.turn(k, 0) for k in range(1, len(proof.parts))]
    low, high = (sum(x) for x in zip(*bounds))
    value = Fraction(certificate["claims"][-1].get("theta", certificate["claims"][-1].get("length")))
    least = max(value - low, high - value)
    digits = least.denominator.bit_length()
    if least:
        radii = [least * 10 ** digits - k for k in range(2)]
        claims = [{**certificate["claims"][-1], "radius": "%de-%d" % (n, digits)} for n in radii]
        path.write_text(json.dumps({**certificate, "claims": claims}))
        expect_each([True, False], name + " to the last bit", path)


def check_rational(here):
    """A file whose formulas are rational functions has a certificate of these, and is its curve; another one is not."""
    path, file = here / "a.cert", here / "a.json"
    for value, arguments in ((curve("s", "s^2", 0, 0, 1), ["--up", "1,2,3"]), (curve("s - s^3/3", "s^2", 0, -1, "3/2"), []),
                             (curve("(1 - s^2)/(1 + s^2)", "2*s/(1 + s^2)", "s^(-1)*s^2/(1 + s/7)", "1/3", "2"), ["--length"])):
        file.write_text(json.dumps(value))
        done = run("certify", file, *arguments, "--digits", "12", "-o", path)
        if done.returncode:
            sys.exit("rational: %s" % done.stderr)
        expect(0, "rational formulas", path, curve=file)
        value["to"] = "5/2"
        file.write_text(json.dumps(value))
        expect(1, "other rational formulas", path, curve=file)


def check_honest(here):
    path, file = here / "a.cert", here / "a.json"
    for name, value, arguments in SUBJECTS:
        file.write_text(json.dumps(value))
        done = run("certify", file, *arguments, "-o", path)
        if done.returncode:
            sys.exit("%s: %s" % (name, done.stderr))
        expect(0, name, path, curve=file)
        certificate = json.loads(path.read_text())
        if name in ("trefoil, Frenet", "exp", "corner", "corner, Frenet") or ALL and name not in ("cusp", "mixed", "raised digits"):
            check_value(name, value, certificate)
        if name == "helix" and abs(Fraction(certificate["claims"][0]["theta"]) - Fraction(  # 4 pi/5
                "2.51327412287183459077011470662360230773577395")) > Fraction(certificate["claims"][0]["radius"]):
            sys.exit("the helix: %s" % certificate["claims"])
        if name in ("exp", "log, sqrt and atan", "others", "corner", "corner, Frenet") or ALL and name != "mixed":
            check_to_the_last_bit(name, certificate, path)


# ---- forged ones

def check_table(here, certificate):
    """Tables of frames along such curves are not proved."""
    table = here / "frames.csv"
    table.write_text("t,x,y,z,e1x,e1y,e1z,f2x,f2y,f2z,f3x,f3y,f3z\n" + ",".join(["1"] * 13) + "\n")
    options = Namespace(quiet=False, curve=None, table=str(table), max_degree=1001, unlimited=False, files=[])
    out = io.StringIO()
    with redirect_stdout(out):
        status = checker.check(str(certificate), options)
    done = run("verify", certificate, "--table", table)
    if (status, done.returncode) != (1, 1) or "there are none of curves by formulas" not in out.getvalue():
        sys.exit("the table: %s, %s" % (out.getvalue(), done))


def forgeries(honest):
    """Of a part of the trefoil: (what is done, the status, what is told, the file)."""
    text, pieces, last = "not proved  |theta(1) - ", "not proved  pieces of segment 0", honest["claims"][-1]

    def changed(do):
        lie = copy.deepcopy(honest)
        do(lie, lie["segments"][0]["pieces"])
        return lie

    def with_formula(key, text):
        return changed(lambda c, p: c["segments"][0]["expressions"].update({key: text}))
    value = Fraction(last["theta"])
    for by in (-1, 1):
        yield "a unit of the last digit", 1, text, changed(lambda c, p: c["claims"][-1].update(theta="%.4f" % float(value + Fraction(by, 10 ** 4))))
    yield "another sign", 1, text, changed(lambda c, p: c["claims"][-1].update(theta="%.4f" % -float(value)))
    yield "a radius too small", 1, text, changed(lambda c, p: c["claims"][-1].update(radius="1e-20"))
    yield "the radius 0", 1, text, changed(lambda c, p: c["claims"][-1].update(radius="0"))
    yield "another t", 1, "not proved  |theta(1/2) - ", changed(lambda c, p: c["claims"][-1].update(t="1/2"))
    yield "beyond the end", 1, "not proved  |theta(2) - ", changed(lambda c, p: c["claims"][-1].update(t="2"))
    yield "another vector", 1, text, changed(lambda c, p: c.update(up=["0", "1", "9"]))
    yield "the opposite vector", 0, "", changed(lambda c, p: c.update(up=[str(-int(x)) for x in c["up"]]))
    yield "the vector 0", 1, pieces, changed(lambda c, p: c.update(up=["0", "0", "0"]))
    for key, formula in (("x", "(2 + cos(3*s))*cos(5*s)"), ("x", "(2 + sin(3*s))*cos(2*s)"), ("y", "(2 + cos(3*s))*sin(2*s + 1/1000)"),
                         ("z", "2*sin(3*s)"), ("from", "1/1000"), ("to", "pi/3 + 1/1000")):
        yield "another formula, " + formula, 1, text, with_formula(key, formula)
    yield "undefined", 1, pieces, with_formula("z", "log(s - 1)")
    yield "a pole", 1, pieces, with_formula("z", "1/(s - 1)")
    yield "an infinite slope", 1, pieces, with_formula("z", "sqrt(s)")
    yield "a point", 1, pieces, with_formula("to", "0")
    yield "a cusp", 1, pieces, changed(lambda c, p: c["segments"][0]["expressions"].update(x="sin(s)^2", y="s^2", z="s^3"))
    yield "too great", 1, pieces, with_formula("x", "exp(exp(1 + s))")
    yield "no pieces", 1, pieces, changed(lambda c, p: p.clear())
    yield "the last piece lost", 1, pieces, changed(lambda c, p: p.pop())
    yield "a gap", 1, "", changed(lambda c, p: [p.pop(1) for _ in range(2)])
    yield "one piece", 1, pieces, changed(lambda c, p: p.__delitem__(slice(-1)))
    yield "an overlap", 1, pieces, changed(lambda c, p: p[0].update(to=p[1]["to"]))
    yield "back", 1, pieces, changed(lambda c, p: p.reverse())
    yield "beyond 1", 1, pieces, changed(lambda c, p: p[-1].update(to="9/8"))
    yield "a piece too short", 1, pieces, changed(lambda c, p: p.insert(0, {**p[0], "to": "1/%d" % (2 ** 30 + 1)}))
    yield "a short piece", 0, "", changed(lambda c, p: p.insert(0, {**p[0], "to": "1/%d" % 2 ** 30}))
    yield "too few terms", 1, "", changed(lambda c, p: p[1].update(order=5))
    yield "too few bits", 1, "", changed(lambda c, p: p[1].update(bits=20))
    yield "no bits", 1, pieces, changed(lambda c, p: p[1].update(bits=0))
    yield "more terms and bits", 0, "", changed(lambda c, p: p[1].update(order=40, bits=99))
    # What is no certificate.
    yield "one term", 2, "order", changed(lambda c, p: p[1].update(order=1))
    yield "negative bits", 2, "bits", changed(lambda c, p: p[1].update(bits=-1))
    yield "bits in quotes", 2, "bits", changed(lambda c, p: p[1].update(bits="99"))
    yield "a rate", 2, "rate", changed(lambda c, p: p[1].update(rate=["1"]))
    yield "no end", 2, "to", changed(lambda c, p: c["segments"][0]["expressions"].pop("to"))
    yield "a weight", 2, "w", changed(lambda c, p: c["segments"][0].update(w=["1"]))
    yield "the same once more", 1, "not proved  joint 1", changed(lambda c, p: [c["segments"].append(c["segments"][0]), c["claims"][-1].update(t="2")])
    for formula in ("sin(3 *s)", "sin(3*t)", "sin(3s)", "sin 3*s", "tan(s)", "sin((s))", "2*(3*s) + -1", "e^s", "s**2", "1.5*s", "s^1001", "s^(1/1001)", "",
                    "s^s", "1/0", "sin(s", "sin(s))", "(" * 61 + "s" + ")" * 61, "+s", "s + 1e3", "-(-s))", "cos(\u03b8)", "s^(-1/2)^2", "1/(1 - 1)", "sin(s)x"):
        yield "no formula, " + formula, 2, "/expressions/z", with_formula("z", formula)
    yield "an end that is no constant", 2, "/expressions/to", with_formula("to", "2*s")
    yield "rational functions", 2, "rational", changed(lambda c, p: c["segments"][0]["expressions"].update(x="s", y="s^2", z="1/(1 + s)^(-3)", to="1"))
    yield "too much work", 2, "work", changed(lambda c, p: p[0].update(order=3000))


def forgeries_of_path(honest):
    """Of two segments with a corner."""
    joint, text = "not proved  joint 1, to 2^-", "not proved  |theta(2) - "

    def changed(do):
        lie = copy.deepcopy(honest)
        do(lie, lie["segments"])
        return lie

    def with_second(start=0, end=1, **formulas):
        return changed(lambda c, s: s[1]["expressions"].update({**formulas, "from": str(start), "to": str(end)}))
    yield "a gap", 1, joint, with_second(z="s^2 + pi/6 + 1/1000")
    yield "a gap of 2^-20", 1, joint, with_second(y="exp(s) + 1/1000000")
    yield "another corner", 1, text, with_second(x="2*s")
    yield "no corner", 1, text, with_second(x="-s", y="1", z="pi/6 + s/3 + s^2")
    yield "it turns back", 1, joint, with_second("pi/2", 0, x="cos(s)", y="sin(s)", z="s*(1/3)")
    yield "the other way around", 1, joint, changed(lambda c, s: s.reverse())
    yield "v along the tangent", 1, joint, changed(lambda c, s: c.update(up=["1", "1", "0"]))
    yield "v along the other tangent", 1, joint, changed(lambda c, s: c.update(up=["-3", "0", "1"]))
    yield "Frenet", 1, text, changed(lambda c, s: [c.update(frame="frenet"), c.pop("up")])
    yield "no bits at the joint", 1, "not proved  joint 1, to 2^-0", changed(lambda c, s: s[1]["pieces"][0].update(bits=0))
    yield "fewer bits at the joint", 0, "proved      joint 1, to 2^-30", changed(lambda c, s: s[1]["pieces"].insert(0, {"to": "1/1000000", "order": 4, "bits": 60}))
    yield "too few bits for the turn", 1, "proved      joint 1, to 2^-15", changed(lambda c, s: s[1]["pieces"].insert(0, {"to": "1/1000000", "order": 4, "bits": 30}))
    yield "no pieces", 1, "not proved  joint 1, to 2^-0", changed(lambda c, s: s[0]["pieces"].clear())
    yield "pieces of the second lost", 1, "not proved  pieces of segment 1", changed(lambda c, s: s[1]["pieces"].pop())
    yield "one lost", 1, "t is not on the path", changed(lambda c, s: s.pop())
    yield "another sign", 1, text, changed(lambda c, s: c["claims"][-1].update(theta=str(-float(c["claims"][-1]["theta"]))))
    yield "a radius too small", 1, text, changed(lambda c, s: c["claims"][-1].update(radius="1e-30"))
    yield "before the corner", 1, "not proved  |theta(1/2) - ", changed(lambda c, s: c["claims"][-1].update(t="1/2"))
    yield "beyond the end", 1, "not proved  |theta(3) - ", changed(lambda c, s: c["claims"][-1].update(t="3"))
    yield "rational functions", 2, "/segments/1", with_second(x="s", y="1 + s", z="s^2")
    yield "a weight", 2, "/segments/1", changed(lambda c, s: s[1].update(w=["1"]))
    yield "no formulas", 2, "/segments/1", changed(lambda c, s: s[1].pop("expressions"))
    line = {"x": ["0", "1"], "y": ["1"], "z": ["1/6", "1"], "w": ["1"], "square": ["1"], "pieces": []}
    yield "an end without pi", 1, joint, changed(lambda c, s: s.__setitem__(1, line))


def check_forged(here):
    path, file, other = here / "a.cert", here / "a.json", here / "b.json"
    file.write_text(json.dumps(PART))
    run("certify", file, "--digits", "4", "-o", path)
    honest, number = json.loads(path.read_text()), 0
    check_table(here, path)
    run("certify", file, "--at", "0", "-o", other)
    expect(0, "at the start alone", other)
    for changed in ({"to": "pi/3 + 0"}, {"expressions": {**PART["expressions"], "z": "sin(s*3)"}}, {"to": 1}):
        other.write_text(json.dumps({**PART, **changed}))
        expect(1, "another curve", path, curve=other, line="not proved  curve of")
    other.write_text(json.dumps({**PART, "variable": "phi", "expressions": {
        key: text.replace("s)", "phi)").replace(" ", "") for key, text in PART["expressions"].items()}, "to": " pi /3"}))
    expect(0, "the same curve in other letters", path, curve=other)
    other.write_text(json.dumps(curve("(−cos(3·φ) − 2)·cos(2×φ)·(−1)", "(2 + cos(3·φ))·sin(2·φ)", "sin(3·φ)", 0, "π÷3", variable="φ")))
    expect(1, "in Greek letters, but multiplied in another way", path, curve=other, line="not proved  curve of")
    other.write_text(json.dumps(curve("(2 + cos(3·φ))·cos(2×φ)", "(2 + cos(3·φ))⋅sin(2·φ)", "sin(3·φ)", 0, "π÷3", variable="φ")))
    expect(0, "the same curve in Greek letters", path, curve=other)
    lies = list(forgeries(honest))
    expect_refused(here, [(what, line, lie) for what, status, line, lie in lies if status == 2])
    for what, status, line, lie in lies:
        if status < 2:
            path.write_text(json.dumps(lie))
            expect(status, what, path, line=line)
    number += len(lies)
    file.write_text(json.dumps(CORNER))
    run("certify", file, "--digits", "10", "--up", "1,-7,2", "-o", path)
    check_table(here, path)
    other.write_text(json.dumps(spline(*CORNER["segments"][:1], curve("s", "exp(s)", "pi/6 + s^2", 0, "1/2"))))
    expect(1, "another path", path, curve=other, line="not proved  curve of")
    file.write_text(json.dumps(SMOOTH))
    run("certify", file, "--digits", "10", "--at", "1", "-o", other)
    gap = json.loads(other.read_text())
    gap["segments"][1]["expressions"]["z"] = "s + 1/1000"
    other.write_text(json.dumps(gap))
    expect(1, "behind a gap", other, line="not proved  |theta(1) - ")
    for what, status, line, lie in forgeries_of_path(json.loads(path.read_text())):
        path.write_text(json.dumps(lie))
        expect(status, "path: " + what, path, line=line)
        number += 1
    return number


def check_jump(here):
    """Where the Frenet frame jumps about the tangent by arctan(4/3) the angle to it is less by that, also where the path turns by a
    corner: the second segment is like the first one, turned about the x axis and then about an axis normal to that."""
    first = curve("sin(s)", "1 - cos(s)", "s^3", -1, 0)
    r = ["sin(s)", "(3*(1 - cos(s))/5 - 4*s^3/5)", "(4*(1 - cos(s))/5 + 3*s^3/5)"]
    path, file = here / "a.cert", here / "a.json"

    def alone(value):
        file.write_text(json.dumps(value))
        return json.loads(run("certify", file, "--frame", "frenet", "--digits", "25").stdout)
    before = alone(first)
    k, c, S = [Fraction(x, 5) for x in (0, 4, 3)], Fraction(3, 5), Fraction(4, 5)  # an axis, cosine and sine
    cross = [[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]]
    turned = [[c * (i == j) + S * cross[i][j] + (1 - c) * k[i] * k[j] for j in range(3)] for i in range(3)]
    for matrix in ([[i == j for j in range(3)] for i in range(3)], turned):
        after = alone(curve(*(" + ".join("(%s)*%s" % (Fraction(x), y) for x, y in zip(row, r) if x) for row in matrix)))
        total = sum(Fraction(x["claims"][0]["theta"]) for x in (before, after))
        jump = Fraction("0.92729521800161223242851246")  # arctan(4/3)
        claims = [{"t": "2", "theta": "%de-22" % round((total + by) * 10 ** 22), "radius": "1e-20"} for by in (-jump, jump, 0)]
        path.write_text(json.dumps({**before, "segments": before["segments"] + after["segments"], "claims": claims}))
        expect_each([True, False, False], "jump", path)


def check_refused(here):
    file = here / "a.json"
    for value, arguments, words in ((CORNER, ["--frame", "frenet"], "jumps"), (curve("s", "sin(s)", "0"), ["--frame", "frenet"], "next to t = 0: a divisor may be 0"), (TREFOIL, ["--holonomy"], "PH")):
        file.write_text(json.dumps(value))
        done = run("certify", file, *arguments)
        if done.returncode not in (2, 3, 4) or words not in done.stderr.splitlines()[-1] or done.stdout:
            sys.exit("%s: status %d, %s" % (words, done.returncode, done.stderr))


def check_models():
    """A number that may be 0 has no inverse, root and logarithm."""
    models = checker.Models(4, 10)
    for f in (models.inverse, models.root, models.log):
        f(([500], 200))
        for model in (([500], 500), ([500, 300], 200), ([], 0), ([0, 1], 0)):
            try:
                sys.exit("%s of %s is %s" % (f.__name__, model, f(model)))
            except checker.NotProved:
                pass


def main():
    check_models()
    with tempfile.TemporaryDirectory() as name:
        check_rational(Path(name))
        check_honest(Path(name))
        print("%d forged certificates of angles that are 0" % check_symmetric(Path(name)))
        if ALL:
            check_work_of_symmetry(Path(name))
        print("%d forged certificates of formulas" % check_forged(Path(name)))
        check_jump(Path(name))
        check_refused(Path(name))


if __name__ == "__main__":
    main()
