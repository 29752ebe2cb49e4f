"""Both checkers accept the same files: certificates are changed at random, and what tools/check_certificate.py and
`phrame verify` say of each is compared: no certificate (exit status 2), all is proved (0), or not (1). Then of true certificates
with a table of frames (--table) and with the file of a curve (--curve), which are changed.

    PHRAME_PROGRAM=build/dev/bin/phrame tests/certificates/certificates_differential_check.py [--number N] [--seed S] [--keep DIR]

With --module build/dev/python the C++ checker is asked in this process, by the Python module, and most certificates are short ones:
so many hundreds a second are tried. It stops after --seconds, and tells how far it is every minute.
"""
import argparse
import copy
import importlib.util
import io
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import time
from contextlib import redirect_stderr, redirect_stdout
from fractions import Fraction
from itertools import chain, islice, starmap
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["PHRAME_PROGRAM"]
spec = importlib.util.spec_from_file_location("check_certificate", ROOT / "tools" / "check_certificate.py")
checker = importlib.util.module_from_spec(spec)
spec.loader.exec_module(checker)

QUINTIC = {"u": ["2", "-4", "4"], "v": ["1", "0", "-1"], "p": ["0", "-4", "4"], "q": ["1", "2", "-2"]}
CURVES = [  # preimage, multiplier, frame
    (QUINTIC, ["1"], "erf"), (QUINTIC, ["-1", "2", "1"], "frenet"),
    ({"u": ["1"], "v": ["0", "1"], "p": ["0", "1"], "q": ["0"]}, ["1"], "frenet"),
    ({"u": ["1"], "v": ["0"], "p": ["0"], "q": ["1", "3", "1"]}, ["1"], "frenet"),
    ({"u": ["1", "2"], "v": ["0"], "p": ["0"], "q": ["0"]}, ["1/3", "1"], "erf"),
    ({"u": ["0", "0", "1"], "v": ["0", "1"], "p": ["0", "1"], "q": ["1"]}, ["1"], "erf"),
    ({"u": ["1", "0", "-6"], "v": ["0", "4", "3"], "p": ["0", "-2", "-12"], "q": ["0", "6", "-4"]}, ["1"], "erf")]
TWISTED = {"u": ["1"], "v": ["0", "1"], "p": ["0"], "q": ["0", "0", "1"]}, {"numerator": ["1"], "denominator": ["64", "192", "240", "160", "60", "12", "1"]}
RATIONAL = [  # an arc of a circle, and a line by 1 + t^2 over 1 + t^2
    (*TWISTED, "erf"), (*TWISTED, "frenet"),
    ({"u": ["1", "-1"], "v": ["0"], "p": ["0"], "q": ["1", "1"]}, {"numerator": ["1"], "denominator": ["1", "0", "2", "0", "1"]}, "frenet"),
    ({"u": ["1"], "v": ["0", "1"], "p": ["0"], "q": ["0"]}, {"numerator": ["1"], "denominator": ["1", "0", "1"]}, "erf")]
CUBIC = {"phrame": "curve/1", "control_points": [[0, 0, 0], [1, 3, -2], [4, 1, 5], [2, -3, 1]]}
CUSP = {"phrame": "curve/1", "basis": "power", "position": {"x": [0, -1, 0, 2], "y": [0, 0, -1, 0, 3], "z": [0, 1, 0, -2]}}  # at 1/sqrt(6)
INTEGRALS = [
    (CUBIC, ["--at", "1/3,1", "--digits", "5"]), (CUBIC, ["--frame", "frenet", "--digits", "9"]), (CUBIC, ["--length", "--digits", "5"]),
    ({**CUBIC, "weights": [1, 2, 1, 3]}, ["--digits", "5"]), ({**CUBIC, "weights": [1, 2, 1, 3]}, ["--length", "--digits", "5"]),
    (CUSP, ["--length", "--digits", "8"]),
    ({"phrame": "spline/1", "segments": [CUBIC, {"control_points": [[2, -3, 1], [0, -7, -3], [1, 1, 1]]}]}, ["--at", "1/2,3/2,2", "--digits", "5"]),
    ({"phrame": "spline/1", "segments": [CUBIC, {"control_points": [[2, -3, 1], [0, 7, 3], [1, 1, 1]]}]}, ["--digits", "5"]),  # a corner
    ({"phrame": "curve/1", "basis": "power", "preimage": QUINTIC}, ["--length", "--at", "1/2,1", "--digits", "5"])]
SHORT = [  # curve, arguments
    ({"phrame": "curve/1", "basis": "power", "preimage": {"u": ["1"], "v": ["0", "1"], "p": ["0"], "q": ["1/2"]}}, ["--at", "1"]),
    ({"phrame": "curve/1", "basis": "power", "preimage": {"u": ["1"], "v": ["0", "1"], "p": ["0", "1"], "q": ["0"]}}, ["--frame", "frenet"]),
    ({"phrame": "curve/1", "basis": "power", "preimage": {"u": ["1", "2"], "v": ["0"], "p": ["0"], "q": ["0"]}, "multiplier": ["1", "-2"]}, []),
    ({"phrame": "curve/1", "basis": "power", "preimage": {"u": ["1"], "v": ["0", "1"], "p": ["0"], "q": ["0"]},
      "multiplier": {"numerator": ["1"], "denominator": ["1", "0", "1"]}}, []),
    ({"phrame": "curve/1", "basis": "power", "position": {"x": [0, 1], "y": [0, 0, 1], "z": [0, 0, 0, "1/8"]}}, ["--up", "0,0,1"]),
    ({"phrame": "curve/1", "basis": "power", "position": {"x": [0, 1], "y": [0, 0, "1/8"]}}, ["--length", "--at", "1/2"]),
    ({"phrame": "curve/1", "expressions": {"x": "s", "y": "exp(s/8)"}, "from": 0, "to": 1}, ["--length"]),
    ({"phrame": "spline/1", "segments": [{"basis": "power", "preimage": {"u": ["1"], "v": ["0"], "p": ["0"], "q": ["0"]}}] * 2}, ["--at", "2"]),
    ({"phrame": "spline/1", "segments": [{"expressions": {"x": "s", "y": "exp(s/8)"}, "from": 0, "to": 1},
                                         {"expressions": {"x": "s", "y": "exp(s/8)", "z": "1 - cos(s - 1)"}, "from": 1, "to": "3/2"}]}, ["--length"]),
    ({"phrame": "spline/1", "segments": [{"basis": "power", "position": {"x": [0, 1], "y": [0, 0, 1]}}, {"expressions": {"x": "s", "y": "exp(s - 1)"}, "from": 1, "to": 2}]},
     ["--up", "1,1,5"]),
    ({"phrame": "curve/1", "basis": "power", "position": {"x": [0, 1], "y": [0, 1, -1], "z": [0, 0, 1, -2, 1]}}, ["--up", "0,0,1"]),  # symmetric
    ({"phrame": "curve/1", "expressions": {"x": "cos(s)", "y": "sin(s)", "z": "sin(2*s)/3"}, "from": 0, "to": "pi"}, ["--up", "0,0,1"])]
FORMULAS = [  # x, y, z, from, to, arguments
    ("cos(s)", "sin(s)", "s/3", 0, "pi/2", ["--at", "1/3,1"]), ("s*exp(-s)", "sqrt(2 + s)", "atan(s)^2", "-1/3", 1, []),
    ("log(2 + s)", "s^(2/3)", "1/s", 1, 2, ["--frame", "frenet"]), ("tan(s/2)", "sinh(s)", "s^3 - s", 0, 1, ["--length"]),
    ("2*cos(s)", "sin(s)", "cos(2*s)/7", 0, "2*pi", ["--at", "1/3,1/2"])]
LIMIT = 5  # seconds, for a certificate below 100 kB
TEXTS = ["0", "1", "-1", "-0", "00", "1/2", "1/0", "2/4", "+1", " 1", "1 ", "1.5", ".5", "5.", "1e5", "1e-5", "1E5", "1e+5", "1e10000",
         "1e10001", "1e-10000", "1e100000", "0x1p3", "nan", "", "-", "1/-2", "1//2", "١", "٣/٢", "1e", "1e-", "1" * 50, "9" * 3000, "9" * 7000, "1/" + "7" * 200]
VALUES = [None, True, False, 0, 1, -1, 2, 1000000, 1000001, 10 ** 30, 0.5, 1e5, [], {}, [[]], ["1"], ["0"], ["1", "1"], ["0", "0", "1"],
          "mirror", {"re": [], "im": []}, {"answer": True}, {"answer": False}, *TEXTS]
BYTES = [b"\xff", b"\x00", b"\xef\xbb\xbf", b"\\ud800", b"\\u0031", b" ", b"\n", b",", b"]", b"}", b'"', b"1", b"-", b"e5", b"NaN", b"//"]


def honest():
    """Certificates of many kinds of curves."""
    for preimage, multiplier, frame in CURVES + RATIONAL:
        curve = {"phrame": "curve/1", "name": "c", "basis": "power", "preimage": preimage, "multiplier": multiplier}
        for at, digits in (("1/3,1", "12"), ("1", "40")):
            run = subprocess.run([PROGRAM, "certify", "-", "--at", at, "--digits", digits, "--frame", frame],
                                 input=json.dumps(curve), capture_output=True, text=True, check=True)
            yield json.loads(run.stdout)
    for path, *options in (("examples/curves/closed-spline.json", "--at", "1/3,5/2,4"), ("tests/data/rational-path.json", "--at", "1/3,5/2,3"),
                           ("examples/any/cube-edges.json", "--at", "2,9/2"), ("examples/curves/closed-spline.json", "--holonomy", "--writhe"), ("tests/data/closed-eight.json", "--holonomy", "--writhe"), ("examples/any/mixed.json",)):
        run = subprocess.run([PROGRAM, "certify", ROOT / path, *options, "--digits", "12"], capture_output=True, text=True, check=True)
        yield {**json.loads(run.stdout), "name": "p"}
    for x, y, z, start, end, arguments in FORMULAS:
        curve = {"phrame": "curve/1", "expressions": {"x": x, "y": y, "z": z}, "from": start, "to": end}
        run = subprocess.run([PROGRAM, "certify", "-", *arguments, "--digits", "4"], input=json.dumps(curve), capture_output=True, text=True, check=True)
        yield {**json.loads(run.stdout), "name": "f"}
    for curve, arguments in INTEGRALS:
        run = subprocess.run([PROGRAM, "certify", "-", *arguments], input=json.dumps(curve), capture_output=True, text=True, check=True)
        yield {**json.loads(run.stdout), "name": "i"}


def short():
    """Certificates that are read and checked soon."""
    for curve, arguments in SHORT:
        run = subprocess.run([PROGRAM, "certify", "-", *arguments, "--digits", "2"], input=json.dumps(curve), capture_output=True, text=True, check=True)
        yield json.loads(run.stdout)


def places(value, path=()):
    out = [path]
    for key, item in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        out += places(item, path + (key,))
    return out


def put(value, path, new):
    for key in path[:-1]:
        value = value[key]
    value[path[-1]] = new


def at(value, path):
    for key in path:
        value = value[key]
    return value


def spelled(text, chance):
    """The same number, or nearly, written in another way; not all are allowed."""
    if re.fullmatch("-?[0-9]+", text) and chance.random() < 0.7:
        k = chance.choice([1, 1, 2, 3, 10, -1])
        return chance.choice(["%s/1" % text, "%d/%d" % (int(text) * k, k), "0" + text, text + ".", text + ".0", text + "e0", text + "0e-1", text + "/01",
                              text[1:] if text[0] == "-" else "-" + text, "-0" if int(text) == 0 else text + "e-0"])
    if match := re.fullmatch("(-?[0-9]+)/([0-9]+)", text):
        k = chance.choice([2, 3, 7, -1, 10 ** 20])
        return "%d/%d" % (int(match[1]) * k, int(match[2]) * k)
    if match := re.fullmatch(r"(-?[0-9]+)([.][0-9]+)?(?:e(-?[0-9]+))?", text):
        k = chance.choice([-1, 1, 2, 9999, 10000, 10001, -9999])
        return chance.choice([match[1] + (match[2] or "") + "e%d" % (int(match[3] or 0) + k), text + "0", match[1] + (match[2] or "") + "0" * 20 +
                              "e" + (match[3] or "0"), text.replace("e", "E"), text.replace("e-", "e-0")])
    return text.swapcase()


def changed_text(text, chance):
    k = chance.randrange(len(text) + 1)
    kind = chance.choice([0] * 9 + [1, 1, 2, 3])
    if kind == 0 and re.search("[0-9]", text):
        k = chance.choice([m.start() for m in re.finditer("[0-9]", text)])
        return text[:k] + chance.choice("0123456789") + text[k + 1:]
    if kind == 1:
        return text[1:] if text.startswith("-") else "-" + text
    if kind == 2:
        return text[:k] + chance.choice("0123456789/.-+e ") + text[k:]
    return text[:k] + text[k + 1:]


TOKENS = ["s", "1", "2", "3", "7", "10", "1000", "0", "pi", "(", ")", "+", "-", "*", "/", "^", "sin(", "cos(", "exp(", "log(", "sqrt(", "atan(", "tan(", "e", "t", " ", "", "π", "²", "⁻¹", "−", "·", "φ"]


def changed_formula(text, chance):
    """One token changed, and mostly written as a certificate has it."""
    tokens = re.findall("[a-z]+[(]?|[0-9]+|.", text) or [""]
    for _ in range(8):
        new, k = list(tokens), chance.randrange(len(tokens))
        new[k:k + chance.choice([0, 1, 1, 2])] = [chance.choice(TOKENS) for _ in range(chance.choice([1, 1, 1, 2, 3]))]
        if chance.random() < 0.05:
            break
        try:
            return checker.canonical("".join(new), "")
        except checker.Malformed:
            pass
    return "".join(new)


def change(certificate, chance):
    """One change, in place."""
    if "expressions" in str(certificate)[:4000] and chance.random() < 0.5:
        formulas = [p for p in places(certificate) if len(p) > 1 and p[-2] == "expressions" and isinstance(at(certificate, p), str)]
        if formulas:
            path = chance.choice(formulas)
            return put(certificate, path, changed_formula(at(certificate, path), chance))
    part = "closed" if "closed" in certificate and chance.random() < 0.5 else None
    kind = chance.choice([0] * 20 + [3, 4, 5, 6])
    for _ in range(8):  # mostly a number, an answer or a list
        path = chance.choice([p for p in places(certificate) if p and part in (None, p[0])])
        value = at(certificate, path)
        if kind or isinstance(value, int) or isinstance(value, list) and value or isinstance(value, str) and value[:1] in "-0123456789+":
            break
    if kind == 6:  # two exchanged
        other = chance.choice([p for p in places(certificate) if p])
        if path[:len(other)] != other and other[:len(path)] != path:
            put(certificate, path, at(certificate, other))
            return put(certificate, other, value)
        kind = 0
    if kind < 3 and isinstance(value, str):
        if chance.random() < 0.3:
            return put(certificate, path, spelled(value, chance))
        return put(certificate, path, changed_text(value, chance))
    if kind < 3 and isinstance(value, bool):
        return put(certificate, path, not value)
    if kind < 3 and type(value) is int:
        return put(certificate, path, value + chance.choice([-2, -1, 1, 2, 100]))
    if kind < 3 and isinstance(value, list) and value:
        k = chance.randrange(len(value))
        what = chance.randrange(4)
        if what == 0:
            return value.pop(k)
        if what == 1:
            return value.insert(k, copy.deepcopy(value[k]))
        if what == 2:
            return value.append(chance.choice(VALUES + 4 * value))
        i = chance.randrange(len(value))
        value[i], value[k] = value[k], value[i]
        return None
    if kind == 3 and isinstance(value, dict) and value:
        if chance.random() < 0.5:
            return value.pop(chance.choice(list(value)))
        if chance.random() < 0.3:  # the same keys in another order
            items = list(value.items())
            chance.shuffle(items)
            value.clear()
            return value.update(items)
        return value.update({chance.choice(["x", "note", "name", "start", "turn", "bend", "answer", "closed", "holonomy", "symmetry"]): chance.choice(VALUES)})
    if kind == 4:  # something from elsewhere
        other = chance.choice([p for p in places(certificate) if p])
        return put(certificate, path, copy.deepcopy(at(certificate, other)))
    return put(certificate, path, copy.deepcopy(chance.choice(VALUES)))


def product(a, b):
    c = [Fraction(0)] * (len(a) + len(b) - 1) if a and b else []
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += Fraction(x) * Fraction(y)
    return [str(x) for x in c]


def with_factor(certificate, a):
    """The same curve with the weight a W: the positions times a, the hodograph times a^2."""
    for part in certificate.get("segments", [certificate]):
        if "pieces" in part and "x" in part:
            part.update({key: product(part[key], a) for key in "xyzw"})
        if "position" in part:
            part["position"] = {key: product(x, a) for key, x in part["position"].items()}
            part["hodograph"] = [product(product(x, a), a) for x in part["hodograph"]]


def candidate(originals, chance):
    """Of one of the texts."""
    certificate = json.loads(chance.choice(originals))
    if chance.random() < 0.2:  # 2t - 1 is 0 on the way
        with_factor(certificate, chance.choice([["1", "1"], ["-1", "2"], ["3"], ["-2", "1/3"], ["1", "0", "1"], ["1", "-1"]]))
    for _ in range(chance.choice([1, 1, 1, 2, 3])):
        change(certificate, chance)
    data = json.dumps(certificate, ensure_ascii=False).encode("utf-8")
    if chance.random() < 0.1:  # broken JSON, mostly
        data = broken(data, chance)
    if chance.random() < 0.02:  # a key twice
        keys = list(re.finditer(rb'("[a-z_]+"): ', data))
        if keys:
            key, other = chance.choice(keys), chance.choice(keys)
            data = data[:key.start()] + other[1] + b": " + json.dumps(chance.choice(VALUES[:20])).encode() + b", " + data[key.start():]
    return data


PIECE = ("segments", 0, "pieces", 0)
PLACES_OF_INTEGRALS = [("frame",), ("up",), ("up", 0), ("segments",), ("segments", 0), ("segments", 0, "x"), ("segments", 0, "w"), ("segments", 0, "square"),
                       ("segments", 0, "square", 0), ("segments", 0, "pieces"), PIECE, *((*PIECE, key) for key in ("to", "root_bits", "root", "rate_bits", "rate")),
                       (*PIECE, "root", 0), (*PIECE, "rate", 1), ("claims", 0, "t"), ("claims", 0, "theta"), ("claims", 0, "radius")]
OF_FORMULAS = ("segments", 0, "expressions")
PLACES_OF_FORMULAS = [OF_FORMULAS, *((*OF_FORMULAS, key) for key in ("x", "z", "from", "to")), PIECE, *((*PIECE, key) for key in ("to", "order", "bits")), ("claims", 0, "symmetry")]
PLACES = [("position",), ("position", "w"), ("position", "w", 0), ("position", "x"), ("position", "z", 0), ("curve", "multiplier"),
          ("curve", "multiplier", "numerator"), ("curve", "multiplier", "denominator"), ("curve", "multiplier", "denominator", 0)]


def with_each_text(original, paths):
    """Every text and value at a place of each kind, which made() makes."""
    return [(original, path, value) for path in paths for value in VALUES]


def made(original, path, value):
    certificate = copy.deepcopy(original)
    put(certificate, path, value)
    return json.dumps(certificate, ensure_ascii=False).encode("utf-8")


def with_each_text_of_polynomial(original):
    logs = ("antiderivative", "logs", 0)
    return with_each_text(original, (("sigma", 0), ("curve", "preimage", "u", 0), ("curve", "phrame"), ("curve", "name"), ("claims", 0, "t"), ("claims", 0, "theta"),
                 ("claims", 0, "radius"), ("rate", "coprime_modulo"), ("bits",), (*logs, "index"), (*logs, "roots", 0, "radius"),
                 (*logs, "roots", 0, "center", 0), ("decisions", "line", "answer"), ("decisions", "regular", "cusps")))


def broken(data, chance):
    k = chance.randrange(len(data))
    return data[:k] + chance.choice(BYTES) + data[k + chance.randrange(2):]


def beside():
    """(option, certificate, what is given beside it) of curves of all kinds, but of PH splines whose frames depend on preimages."""
    values = [{"phrame": "curve/1", "basis": "power", "preimage": QUINTIC, "multiplier": ["-1", "2", "1"]},
              {"phrame": "curve/1", "basis": "power", "preimage": TWISTED[0], "multiplier": TWISTED[1]}, CUBIC, INTEGRALS[3][0], INTEGRALS[6][0],
              json.loads((ROOT / "tests/data/rational-path.json").read_text())]
    formulas = {"phrame": "curve/1", "expressions": {"x": "cos(u)", "y": "sin(u)", "z": "u/3", "variable": "u"}, "from": 0, "to": "pi/2"}
    two = {"phrame": "spline/1", "segments": [CUBIC, {"expressions": {"x": "2 + sin(s)", "y": "-3*cos(s)", "z": "exp(s)"}, "from": 0, "to": "1/2"}]}
    for value in [*values, formulas, two]:
        text = json.dumps(value)
        at = "0,1/3,1"
        run = lambda *arguments: subprocess.run([PROGRAM, *arguments, "--at", at], input=text, capture_output=True, text=True, check=True).stdout
        yield "--curve", run("certify", "-", "--digits", "6"), text
        if value not in (formulas, two):
            yield "--table", run("certify", "-", "--digits", "30"), run("frames", "-")


def changed_table(text, chance):
    rows = [line.split(",") for line in text.splitlines()]
    for _ in range(chance.choice([1, 1, 2])):
        k, what = chance.randrange(len(rows)), chance.randrange(8)
        i = chance.randrange(len(rows[k])) if rows[k] else 0
        if what < 4 and rows[k]:
            x = rows[k][i]
            if what == 0 and re.fullmatch("-?[0-9]+([.][0-9]+)?", x):  # the next double
                x = repr(float(x) * (1 + chance.choice([-1, 1]) * 2.0 ** -52))
            rows[k][i] = changed_text(x, chance) if what in (1, 2) else chance.choice(TEXTS) if what == 3 else x
        elif what == 4:
            rows.insert(k, rows[chance.randrange(len(rows))])
        elif what == 5 and len(rows) > 1:
            rows.pop(k)
        elif what == 6 and rows[k]:
            rows[k].pop(i)
        else:
            j = chance.randrange(len(rows))
            rows[j], rows[k] = rows[k], rows[j]
    return chance.choice(["\n"] * 9 + ["\r\n"]).join(",".join(row) for row in rows) + chance.choice(["\n"] * 9 + [""])


def changed_beside(option, text, chance):
    if chance.random() < 0.1:
        return text.encode()
    if option == "--table":
        data = changed_table(text, chance).encode()
    else:
        value = json.loads(text)
        for _ in range(chance.choice([1, 1, 2])):
            change(value, chance)
        data = json.dumps(value, ensure_ascii=False).encode()
    return broken(data, chance) if data and chance.random() < 0.1 else data


def by_script(path, option=None, given=None):
    options = argparse.Namespace(quiet=False, curve=None, table=None, max_degree=checker.MAX_DEGREE, unlimited=False, files=[])
    if option:
        setattr(options, option[2:], str(given))
    out = io.StringIO()
    with redirect_stdout(out), redirect_stderr(out):
        status = checker.check(str(path), options)
    return status, out.getvalue()


def by_module(module, data):
    """(exit status, what is not proved), as the Python module tells it."""
    try:
        certificate = module.Certificate.from_json(data.decode("utf-8"))
    except module.InputError as error:
        return 2, str(error)
    objections = certificate.objections()
    return min(1, len(objections)), "\n".join(objections)


def by_program(path, *more):
    run = subprocess.run([PROGRAM, "verify", "--full", path, *more], capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


def check_refused(paths):
    """The number of these files that verify does not refuse. Of several it tells in a line each, of those that it has read how much is proved."""
    if len(paths) < 2:
        return sum(by_program(path)[0] != 2 for path in paths)
    done = subprocess.run([PROGRAM, "verify", *paths], capture_output=True, text=True)
    lines = done.stdout.split("\n")[:-1]
    if done.returncode != 2 or len(lines) != len(paths):
        sys.exit("verify of %d files: %s" % (len(paths), done))
    differ = 0
    for path, line in zip(paths, lines):
        if not line.startswith("%s:" % path) or re.search(": (all|[0-9]+ of) [0-9]+ statements? (is|are) (not )?proved$", line):
            differ += 1
            print("%s: the script refuses it, verify: %s" % (path, line))
        else:
            path.unlink()
    return differ


def check_beside(number, seed, folder, keep):
    """So many changed tables and files of curves; the number of those about which the checkers differ. Of curves verify reads more
    files, and tells of what is none, where the script says that it is another one."""
    originals, seen, differ, more = list(beside()), {0: 0, 1: 0, 2: 0}, 0, 0
    certificate = Path(folder) / "beside.cert"
    for k in range(number):
        chance = random.Random(seed * 10 ** 9 + k)
        option, text, given = chance.choice(originals)
        certificate.write_text(text)
        path = Path(keep or folder) / ("%d%s" % (k, option))
        path.write_bytes(changed_beside(option, given, chance))
        (mine, told), (other, said) = by_script(certificate, option, path), by_program(certificate, option, path)
        seen[mine] = seen.get(mine, 0) + 1
        if option == "--curve" and (mine != other and 0 not in (mine, other) or (mine, other) == (2, 0)):
            more += other == 0
        elif mine != other or mine != 2 and statements(told) != statements(said):
            differ += 1
            print("%d %s: the script %s, verify %s\n%s\n%s\n%s" % (k, option, mine, other, path.read_bytes()[:600], told[-300:], said[-300:]))
            continue
        path.unlink()
    print("%d tables and files of curves, by the script %d proved, %d not proved, %d refused; %d curves only verify reads; %d differ"
          % (number, seen[0], seen[1], seen[2], more, differ))
    return differ


def statements(text):
    """The statements, without the reasons why some are not proved."""
    return [re.sub(r"^not proved  ((?:segment \d+: )?(?:decision \w+: \w+|\|(?:theta|length).*?\| <= [^:]*|[^:]*)):.*", r"\1", line).replace("proved      ", "", 1)
            for line in text.splitlines() if line.startswith(("proved", "not proved"))]


def check_discs(certificate, folder):
    """The least radii of discs that the one checker takes are those of the other. The residues are a little off."""
    path, number = Path(folder) / "disc.cert", 0
    for k, log in enumerate(certificate["antiderivative"]["logs"]):
        for disc in log["roots"]:
            disc["residue"][0] = str(int(disc["residue"][0]) + 12345)
            for key, what in (("radius", "roots of log %d" % k), ("residue_radius", "residues of log %d" % k)):
                def is_proved(radius, by):
                    disc[key] = str(radius)
                    path.write_text(json.dumps({**certificate, "claims": []}))
                    return "proved      " + what in by(path)[1].splitlines()
                low, high = -1, 4 * int(disc[key]) + 10 ** 6
                while high - low > 1:
                    middle = (low + high) // 2
                    low, high = (low, middle) if is_proved(middle, by_script) else (middle, high)
                if not is_proved(high, by_program) or high and is_proved(high - 1, by_program):
                    sys.exit("%s: the least %s of the script is %d, not that of verify" % (what, key, high))
                disc[key], number = str(high), number + 1
    return number


def check_in_process(options):
    """Returns the number of differences, and of certificates that take too long."""
    sys.path.insert(0, options.module)
    import phrame
    small, all_kinds = ([json.dumps(c) for c in certificates()] for certificates in (short, honest))
    small += [text for text in all_kinds if len(text) < 1600]
    start, seen, differ, data, k = time.monotonic(), {0: 0, 1: 0, 2: 0}, 0, b"", options.first
    checker.read_file = lambda name: data
    for k in range(options.first, options.first + options.number):
        if k % 10000 == 0:
            print("%s: %d tried in %d seconds, %s, %d differ" % (time.strftime("%H:%M:%S"), k - options.first, time.monotonic() - start, seen, differ), flush=True)
            if time.monotonic() - start > options.seconds:
                break
        chance = random.Random(options.seed * 10 ** 9 + k)
        data = candidate(small if chance.random() < 0.95 else all_kinds, chance)
        try:
            data.decode("utf-8")
        except UnicodeDecodeError:
            continue
        began = time.process_time()
        mine, told = by_script("-")
        try:
            other, said = by_module(phrame, data)
        except Exception as error:
            other, said = 3, repr(error)
        seen[mine] = seen.get(mine, 0) + 1
        seconds = time.process_time() - began
        if mine != other or seconds > LIMIT:
            differ += 1
            path = Path(options.keep or tempfile.gettempdir()) / ("%d.cert" % k)
            path.write_bytes(data)
            print("%s: the script %s, verify %s, after %.1f seconds\n%s\n%s" % (path, mine, other, seconds, told[-600:], said[-600:]), flush=True)
    print("%d certificates, by the script %d proved, %d not proved, %d refused; %d differ; %d seconds"
          % (sum(seen.values()), seen[0], seen[1], seen[2], differ, time.monotonic() - start))
    return differ


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    effort = int(os.environ.get("PHRAME_TEST_MULTIPLIER", 1))
    parser.add_argument("--number", type=int, default=80 * effort)
    parser.add_argument("--beside", type=int, default=40 * effort, help="so many tables and files of curves")
    parser.add_argument("--every", type=int, default=1 if effort > 1 else 13, help="of the texts that are tried at each place")
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--module", metavar="DIR", help="where the Python package phrame is, to ask that")
    parser.add_argument("--first", type=int, default=0, help="with --module: the number of the first certificate")
    parser.add_argument("--seconds", type=int, default=10 ** 9, help="with --module: about so long at most")
    parser.add_argument("--keep", metavar="DIR", help="where files about which they differ are put")
    options = parser.parse_args()
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    if options.module:
        sys.exit(1 if check_in_process(options) else 0)
    originals, seen, differ = list(honest()), {0: 0, 1: 0, 2: 0}, 0
    # Each with a seed of its own, so that one can be tried again.
    written = list(map(json.dumps, originals))
    changed = (candidate(written, random.Random(options.seed * 10 ** 9 + k)) for k in range(options.number))
    with tempfile.TemporaryDirectory() as folder:
        texts = chain(with_each_text_of_polynomial(originals[0]), with_each_text(originals[2 * len(CURVES)], PLACES),
                      with_each_text(originals[-len(INTEGRALS)], PLACES_OF_INTEGRALS),
                      with_each_text(originals[-len(INTEGRALS) - len(FORMULAS)], PLACES_OF_FORMULAS))
        refused = []  # by the script; verify may then say so of many at once
        for number, data in enumerate(chain(changed, starmap(made, islice(texts, 0, None, options.every)))):
            path = Path(options.keep or folder) / ("%d.cert" % number)
            path.write_bytes(data)
            mine, told = by_script(path)
            seen[mine] = seen.get(mine, 0) + 1
            if mine == 2:
                refused.append(path)
                continue
            other, said = by_program(path)
            if mine == other and statements(told) == statements(said):
                path.unlink()
                continue
            differ += 1
            print("%d: the script %s, verify %s\n%s\n%s" % (number, mine, other,
                  [line for line in told.splitlines() if not line.startswith("proved")],
                  [line for line in said.splitlines() if not line.startswith("proved")]))
        differ += check_refused(refused)
        print("%d radii of discs" % sum(check_discs(copy.deepcopy(originals[k]), folder) for k in (0, 2 * len(CURVES) + 6)))
        differ += check_beside(options.beside, options.seed, folder, options.keep)
    print("%d certificates, by the script %d proved, %d not proved, %d refused; %d differ"
          % (sum(seen.values()), seen[0], seen[1], seen[2], differ))
    if differ or options.number >= 400 and min(seen[0], seen[1], seen[2]) < 10:
        sys.exit(1)


if __name__ == "__main__":
    main()
