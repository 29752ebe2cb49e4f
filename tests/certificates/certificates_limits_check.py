"""Certificates of up to 100 kB made to take long: both checkers decide or refuse each, within the memory that docs/certificate.md
promises and, since machines differ, some times the seconds; PHRAME_LIMITS=print shows what they take.
"""
import copy
import json
import os
import random
import resource
import subprocess
import sys
import tempfile
from fractions import Fraction
from itertools import islice
from math import comb
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["PHRAME_PROGRAM"]
SECONDS, MEMORY = 30, 500 << 20
CHANCE = random.Random(40)
if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)


def product(a, b):
    c = [0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def texts(numbers):
    return [str(x) for x in numbers]


def some(n, most=9):
    return [CHANCE.randint(-most, most) for _ in range(n)]


def curve(preimage, multiplier=(1,)):
    return {"phrame": "curve/1", "basis": "power", "preimage": {key: texts(c) for key, c in zip("uvpq", preimage)},
            "multiplier": texts(multiplier)}


def certified(a_curve, *options):
    run = subprocess.run([PROGRAM, "certify", "-", *options], input=json.dumps(a_curve), capture_output=True, text=True, check=True)
    return run.stdout


def mignotte(n, size):
    """t^n - 2 (size t - 1)^2: two zeros are as close to each other as can be."""
    c = [0] * (n + 1)
    c[0], c[1], c[2] = -2, 4 * size, -2 * size * size
    c[n] += 1
    return c


BASE, BASE_ERF = (json.loads(certified(curve([some(3) for _ in range(4)]), "--at", "1/2,1", "--digits", "20", "--frame", frame))
                  for frame in ("frenet", "erf"))


def changed(change, base=BASE):
    """A function that makes it, or, of a `base` that is one, makes that first: every day most are not asked for."""
    def text():
        c = copy.deepcopy(base() if callable(base) else base)
        change(c)
        return json.dumps(c)
    return text


def at_point(t):
    return lambda c: c["decisions"]["regular"].update(answer=False, cusps=[{"t": t, "order": 1}])


def at_cusp(t):
    """Of a curve with one."""
    def change(c):
        c["curve"]["multiplier"] = ["-1", "2"]
        at_point(t)(c)
    return change


def all_claims(**values):
    return lambda c: [claim.update(values) for claim in c["claims"]]


def cusps(n):
    """Points that are zeros of one polynomial of degree n - 1, all of them stated."""
    f = [1]
    for k in range(1, n):
        f = product(f, [-k, n])

    def change(c):
        c["curve"] = curve([[1]] * 4, f)
        c["decisions"]["regular"] = {"answer": False, "cusps": [
            {"t": {"polynomial": texts(f), "interval": ["%d/%d" % (2 * k - 1, 2 * n), "%d/%d" % (2 * k + 1, 2 * n)]}, "order": 1}
            for k in range(1, n)]}
    return change


def bad():
    """(name, a function that makes the text)."""
    logs = ("antiderivative", "logs", 0)
    far, big = "1" + "0" * 3000, CHANCE.randrange(10 ** 4000)

    def set_at(path, value):
        def change(c):
            for key in path[:-1]:
                c = c[key]
            c[path[-1]] = value
        return change
    one = [[1], [0, 1], [1], [2]]
    changes = {
        "dense sigma": set_at(["sigma"], ["1"] * 20000),
        "sigma of exponents": set_at(["sigma"], ["1e100000"] * 5000),
        "sigma of long numbers": set_at(["sigma"], [str(10 ** 18000 + k) for k in range(5)]),
        "dense index": set_at([*logs, "index"], ["1"] * 20000),
        "long residue": set_at([*logs, "residue"], ["1/" + "3" * 20000] * 4),
        "dense rational part": set_at(["antiderivative", "rational"], {"numerator": ["1"] * 9000, "denominator": ["3"] * 9000}),
        "radius 1e-9800": all_claims(radius="1e-9800"),
        "radius 1e-30000": all_claims(radius="1e-30000"),
        "radius 1e-1500": all_claims(radius="1e-1500"),
        "theta of 30000 digits": all_claims(theta="0." + "3" * 30000),
        "long t": all_claims(t="1/3" + "7" * 20000),
        "t of 2000 digits": all_claims(t="1/3" + "7" * 2000),
        "many claims": lambda c: c.update(claims=[dict(c["claims"][0], radius="1e-200", t="1/%d" % k) for k in range(2, 600)]),
        "close zeros, exponents": at_point({"polynomial": ["-1", "1e50000"], "interval": ["0", "1"]}),
        "close zeros": at_point({"polynomial": ["9" * 30000, "-2" + "0" * 30000, "1" + "0" * 30000], "interval": ["0", "2"]}),
        "close zeros of degree 8": at_point({"polynomial": texts(mignotte(8, 10 ** 3000)), "interval": ["0", "1"]}),
        "long interval": at_point({"polynomial": ["-1", "0", "0", "0", "0", "0", "7"], "interval": ["1/" + "7" * 15000, "2"]}),
        "interval to 1e3000": at_cusp({"polynomial": ["1", "-136", "-228", "-392", "-539", "11480"], "interval": ["0", "9" * 3000]}),
        "three zeros, one far away": at_cusp({"polynomial": texts(product(product([-1, 3], [-1, 2]), [-10 ** 3000, 1])), "interval": ["0", "9" * 3001]}),
        "close zeros in a long interval": at_cusp({"polynomial": texts(mignotte(8, 10 ** 300)), "interval": ["-1" + "0" * 1000, "9" * 1001]}),
        "modulus": set_at(["rate", "coprime_modulo"], "1" + "0" * 60000 + "1"),
        "bits": set_at(["bits"], 1000000),
        "direction": set_at(["decisions", "line"], {"answer": True, "direction": ["1/" + "7" * 30000, "2", "3"]}),
        "denominators": set_at(["rate", "numerator"], ["1/%d" % CHANCE.randrange(10 ** 900) for _ in range(10)]),
        "cusps": cusps(24), "nesting": set_at(["sigma"], eval("[" * 90 + "]" * 90))}
    curves = {
        "degree 1001": curve([some(501) for _ in range(4)]), "multiplier of degree 900": curve(one, [1] * 901),
        "preimage of degree 80": curve([some(81) for _ in range(4)]),
        "(t - 1)^60": curve(one, [comb(60, k) * (-1) ** k for k in range(61)]),
        "(t - 1)^500": curve(one, [comb(500, k) * (-1) ** k for k in range(501)]),
        "a common factor": curve([product(some(11), some(11, 10 ** 20))] * 4), "long coefficients": curve([some(3, big) for _ in range(4)]),
        "many denominators": curve([[Fraction(1, CHANCE.randrange(10 ** 60)) for _ in range(20)] for _ in range(4)]),
        "close zeros of degree 4": curve(one, mignotte(4, int(far))), "close zeros of degree 40": curve(one, mignotte(40, 10 ** 100))}
    yield from ((name, changed(change)) for name, change in changes.items())
    yield from (("curve: " + name, changed(set_at(["curve"], c))) for name, c in curves.items())
    yield from rational()
    yield from integrals()
    yield from closed()
    yield from formulas()
    yield from symmetric()
    honest = {  # all that is in them is true
        "(t - 1)^20": curve(one, [comb(20, k) * (-1) ** k for k in range(21)]),
        "close zeros of degree 6": curve(one, mignotte(6, 10 ** 40)),
        "a common factor": curve([product(some(4), [3, 1, 2, 5])] * 2 + [product(some(4), [3, 1, 2, 5])] * 2),
        "degree 41": curve([some(21) for _ in range(4)]), "degree 25, 15 digits": curve([some(13, 10 ** 15) for _ in range(4)]),
        "rational, degree 13": over(some_list(7), 14), "rational, degree 25": over(some_list(13), 26)}
    for name, c in honest.items():
        for frame in ("erf", "frenet"):
            yield "%s, %s" % (name, frame), lambda: certified(c, "--frame", frame, "--at", "1/3,1")


def some_list(n):
    return [some(n) for _ in range(4)]


def over(preimage, k):
    """A i A*/(t + 1)^k, which is the derivative of a rational curve where k is more than its degree and 1."""
    return {**curve(preimage), "multiplier": {"numerator": ["1"], "denominator": texts(comb(k, j) for j in range(k + 1))}}


def rational():
    """r = tW/W, so that every W is a weight; and what is no derivative."""
    weights = {"close zeros of degree 4": mignotte(4, 10 ** 2000), "close zeros of degree 12": mignotte(12, 10 ** 100),
               "close zeros of degree 30": mignotte(30, 10 ** 30), "dense": [1] * 900, "degree 100": some(101), "degree 30, long": some(31, 10 ** 300),
               "long": [1, 3 ** 20000], "zeros on the way": product(product([-1, 2], [-1, 3]), [-2, 5])}
    for name, w in weights.items():
        def of_weight(c):
            c["curve"] = {**curve([[1], [0], [0], [0]]), "multiplier": {"numerator": ["1"], "denominator": ["1"]}}
            c["position"] = {"x": texts([0, *w]), "y": [], "z": [], "w": texts(w)}
        yield "weight: " + name, changed(of_weight, BASE_ERF)

    def no_quotient(c):
        c["curve"]["multiplier"] = {"numerator": texts(some(60, 10 ** 40)), "denominator": texts(some(100, 10 ** 40))}
        c["position"] = {key: texts(some(50, 10 ** 40)) for key in "xyzw"}
    yield "weight: no quotient", changed(no_quotient, BASE_ERF)
    for size in (10 ** 900, 10 ** 2000):
        yield "multiplier: close zeros of degree 4", changed(lambda c: c.update(curve=curve([[1], [0], [0], [0]], mignotte(4, size))), BASE_ERF)


def integral_of(f):
    return ["0"] + [str(Fraction(x) / (k + 1)) for k, x in enumerate(f)]


def integrals():
    """Of curves that are not PH, and of lengths."""
    cubic = {"phrame": "curve/1", "control_points": [[0, 0, 0], [1, 3, -2], [4, 1, 5], [2, -3, 1]]}
    base, length = (json.loads(certified(cubic, "--digits", "9", *more)) for more in ([], ["--length"]))
    piece = base["segments"][0]["pieces"][0]
    long = str(10 ** 18000 + 1)

    def segment(**values):
        return changed(lambda c: c["segments"][0].update(values), base)

    def of_piece(**values):
        return changed(lambda c: c["segments"][0]["pieces"][0].update(values), base)

    def many(n, size):
        """Rational segments one behind the other, each a closed curve."""
        def change(c):
            closed = {"x": texts([0, *some(n), 0]), "y": texts([0, *some(n)]), "z": texts([0, *some(n)]), "w": texts([1, *map(abs, some(n))]), "square": ["1"], "pieces": []}
            for key in "xyz":
                closed[key][-1] = str(-sum(map(int, closed[key][:-1])))
            c.update(frame="frenet", segments=[closed] * size)
            del c["up"]
        return changed(change, base)
    close = mignotte(30, 10 ** 30)
    yield from {
        "integral: degree 1000": segment(x=texts(some(1001)), y=texts(some(1001))), "integral: degree 60": segment(x=texts(some(61)), y=texts(some(61))),
        "integral: long coefficients": segment(x=["0", long, long], y=["1", "1/" + long[::-1]]), "integral: long square": segment(square=[long]),
        "integral: root of 18000 terms": of_piece(root=["1"] * 18000), "integral: root of 3000 terms": of_piece(root=["1"] * 3000),
        "integral: root of 900 terms": of_piece(root=["1"] + ["0"] * 900, rate=["3"] * 900),
        "integral: long root": of_piece(root=[long] * 5, root_bits=1), "integral: long rate": of_piece(rate=[str(3 ** 6000)] * 20),
        "integral: bits": of_piece(root_bits=1000000), "integral: bits of the rate": of_piece(rate_bits=1000000),
        "integral: 100000 bits": of_piece(root_bits=100000, root=["1" + "0" * 30000]), "integral: long end": of_piece(to="1/" + long),
        "integral: end of 1000 digits": of_piece(to="1/" + "7" * 1000),
        "integral: many pieces": changed(lambda c: c["segments"][0].update(pieces=[{"to": "%d/1500" % k, "root_bits": 0, "root": ["1"], "rate_bits": 0, "rate": []}
                                                                                    for k in range(1, 1200)]), base),
        "integral: many pieces of many terms": changed(lambda c: c["segments"][0].update(pieces=[dict(piece, to="%d/90" % k) for k in range(1, 80)]), base),
        "integral: long t": changed(all_claims(t="1/3" + "7" * 20000), base), "integral: t of 500 digits": changed(all_claims(t="1/3" + "7" * 500), base),
        "integral: radius 1e-9800": changed(all_claims(radius="1e-9800"), base), "integral: theta of 30000 digits": changed(all_claims(theta="0." + "3" * 30000), base),
        "integral: many claims": changed(lambda c: c.update(claims=[dict(c["claims"][0], t="%d/1501" % k) for k in range(1, 1400)]), base),
        "integral: many segments": many(10, 340), "integral: many short segments": many(3, 700),
        "integral: close zeros of the weight": segment(w=texts(mignotte(12, 10 ** 100))),
        "integral: close cusps": changed(lambda c: c["segments"][0].update(x=integral_of(close), y=integral_of([2 * x for x in close]), z=integral_of([0, *close])), length)}.items()
    random_points = {"phrame": "curve/1", "control_points": [some(3, 99) for _ in range(41)]}
    yield "integral: degree 40", lambda: certified(random_points, "--digits", "17", "--length")
    yield "integral: degree 40, angle", lambda: certified({**random_points, "control_points": random_points["control_points"][:21]}, "--digits", "17", "--frame", "frenet")


def formulas():
    """Of curves by formulas: many steps, deep ones, long numbers, and many pieces."""
    helix = {"phrame": "curve/1", "expressions": {"x": "cos(s)", "y": "sin(s)", "z": "s"}, "from": 0, "to": 1}
    base = json.loads(certified(helix, "--digits", "5"))

    def of_formula(pieces=1, frame="frenet", start="0", end="1", **values):
        def change(c):
            part = c["segments"][0]
            part["expressions"] = {"x": "exp(s)", "y": "s^2", "z": "s^3", "from": start, "to": end, **values}
            piece = {**part["pieces"][0], **sizes}
            part["pieces"] = [dict(piece, to="%d/%d" % (k, pieces)) for k in range(1, pieces + 1)]
            c.update(frame=frame, claims=[{"length" if frame == "none" else "theta": "1", "t": "1", "radius": "1e-5"}])
            if frame != "up":
                c.pop("up", None)
        return changed(change, base)
    deep = {name: name + ("(2 + " + name) * 50 + "(s)" + ")" * 50 for name in ("sin", "exp", "log", "sqrt", "atan")}
    deep["exp"] = "exp(-" * 55 + "s" + ")" * 55
    sums = {"sums": " + ".join(["s"] * 2500), "products": "*".join(["s"] * 4900), "quotients": "s" + "/s" * 4900, "powers": "*".join(["s^999"] * 1500),
            "angles": " + ".join("sin(%d*s)" % k for k in range(1, 700)), "long number": "s + " + "7" * 9900, "quotient of long numbers": "s + " + "7" * 4000 + "/" + "3" * 4000}
    for sizes in ({"order": 60, "bits": 150}, {"order": 8, "bits": 4000}):
        for name, text in {**deep, **sums}.items():
            yield "formulas: %s, %s" % (name, list(sizes.values())), of_formula(start="1", end="33/32", z=text)
    for pieces, sizes in ((1500, {"order": 2, "bits": 100}), (1500, {"order": 20, "bits": 64}), (60, {"order": 40, "bits": 1000}), (20, {"order": 10, "bits": 9000})):
        yield "formulas: %d pieces" % pieces, of_formula(pieces, "up" if pieces == 60 else "none", x="cos(s)", y="sin(s)", z="atan(s)")
    for sizes in ({"order": 2, "bits": 20000}, {"order": 2, "bits": 200000}, {"order": 1000000, "bits": 1}, {"order": 900, "bits": 0}):
        yield "formulas: %s" % list(sizes.values()), of_formula(x="cos(s)")
    sizes = {"order": 30, "bits": 100}
    for name, text in {"a great angle": "sin(10^300*s) + 9^999", "a great exponent": "exp(10^9*s)", "a pole": "1/(s - (1/3))", "a great power": "(1 + s)^1000",
                       "a power of a power": "(9^999)^999 + s", "many turns": "sin(100000*s)"}.items():
        yield "formulas: " + name, of_formula(300, z=text)


    def of_segments(n, *parts):
        """With so many segments, these in turn."""
        def change(c):
            c.update(segments=[parts[k % len(parts)] for k in range(n)], claims=[{"t": str(n), "theta": "1", "radius": "1e-5"}])
        return changed(change, base)
    line = {"x": ["0", "1"], "y": ["0", "1"], "z": ["3"], "w": ["1"], "square": ["1"], "pieces": []}
    for bits in (64, 1000, 20000):
        part = {"expressions": {"x": "cos(s)", "y": "sin(atan(s))", "z": "3", "from": "0", "to": "pi"}, "pieces": [{"to": "1", "order": 2, "bits": bits}]}
        yield "formulas: many segments, %d bits" % bits, of_segments(500, part)
        yield "formulas: segments of two kinds, %d bits" % bits, of_segments(500, line, part)
        yield "formulas: long numbers at joints, %d bits" % bits, of_segments(20, {**line, "x": ["0", "1" + "0" * 4000]}, part)


def symmetric():
    """Claims that angles are 0 by a symmetry, which is to be seen from long formulas, long numbers and high degrees, often."""
    def of_formula(number=1, t="1", symmetry="mirror", z="sin(2*s)"):
        wave = {"phrame": "curve/1", "expressions": {"x": "cos(s)", "y": "sin(s)", "z": z}, "from": 0, "to": "pi"}
        claim = {"t": t, "theta": "0", "radius": "0", "symmetry": symmetry}
        return changed(lambda c: c.update(claims=[claim] * number), lambda: json.loads(certified(wave, "--digits", "2", "--up", "0,0,1", "--at", "1/3")))
    texts_of = {"sines": " + ".join("sin(%d*s)" % k for k in range(1, 7)), "products": "*".join(["sin(s)"] * 9), "a power": "(cos(s) + sin(3*s))^4",
                "long numbers": "sin(2*s) + cos(s)/" + "7" * 300, "many long numbers": " + ".join("cos(%d*s)/%s" % (k, "7" * 100) for k in range(1, 6)),
                "powers of s": "(s/4 + (1/9))^8", "a power of pi": "(s/9 + pi)^4*(pi + 1)^3/100", "angles in angles": "sin(" * 4 + "s" + ")" * 4}
    for name, text in texts_of.items():
        for number in (1, 100):
            yield "symmetry: %s, %d times" % (name, number), of_formula(number, z=text)
    yield "symmetry: 600 claims", of_formula(600)
    yield "symmetry: 1300 shifts", of_formula(1300, symmetry="1/2")
    yield "symmetry: a long shift", of_formula(1, symmetry="1/" + "6" * 20000)
    yield "symmetry: long t", of_formula(20, t="1/3" + "7" * 3000)
    bump = [[1]]
    for _ in range(24):
        bump.append(product(bump[-1], [0, 1, -1]))
    for degree, number, t in ((3, 1000, "1"), (12, 300, "1"), (24, 60, "1"), (24, 20, "1/3" + "7" * 500), (6, 20, "1/3" + "7" * 3000)):
        curve = {"phrame": "curve/1", "basis": "power", "position": {"x": texts([0, 1]), "y": texts(bump[2]), "z": texts(bump[degree])}}
        yield "symmetry: degree %d, %d claims" % (2 * degree, number), changed(
            lambda c: c.update(claims=[{"t": t, "theta": "0", "radius": "0", "symmetry": "mirror"}] * number), lambda: json.loads(certified(curve, "--digits", "2", "--up", "0,0,1")))


def closed():
    """Of closed paths: a circle that is gone round twice, so that all crossings are lost, and long numbers."""
    sides = [([1, 0, -1], [0, 2]), ([0, -2], [1, 0, -1]), ([-1, 0, 1], [0, -2]), ([0, 2], [-1, 0, 1])]
    circle = {"phrame": "spline/1", "segments": [{"basis": "power", "position": {"x": x, "y": y, "w": [1, 0, 1]}} for x, y in sides]}
    once = json.loads(certified(circle, "--holonomy", "--writhe"))
    yield "closed: twice", changed(lambda c: c.update(segments=c["segments"] * 2, claims=[]), once)
    eight = json.loads(certified(json.loads((ROOT / "tests/data/closed-eight.json").read_text()), "--holonomy", "--writhe", "--digits", "12"))

    def of_writhe(**values):
        return changed(lambda c: c["closed"]["writhe"].update(values), eight)
    first = eight["closed"]["writhe"]["crossings"][0]
    yield "closed: long projection", of_writhe(projection=["1/" + "7" * 3000, "1/" + "3" * 300, "1"])
    yield "closed: long box", of_writhe(crossings=[{**first, "first": {**first["first"], "interval": ["1/" + "7" * 4000, "85/128"]}}])
    yield "closed: many boxes", of_writhe(crossings=[first] * 130)
    yield "closed: radius 1e-1100", of_writhe(radius="1e-1100")
    yield "closed: value 3e10000", of_writhe(value="3e10000")
    yield "closed: radius 3e10000", of_writhe(radius="3e10000")
    yield "closed: value of 20000 digits", of_writhe(value="0." + "3" * 20000)


# Every day one of twelve.
EVERY = 1 if os.environ.get("PHRAME_LIMITS") or int(os.environ.get("PHRAME_TEST_MULTIPLIER", 1)) > 1 else 12


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    if "asan" not in os.environ.get("PHRAME_PRESET", ""):
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def main():
    wrong, number, longest = [], 0, {}
    with tempfile.TemporaryDirectory() as folder:
        for name, make in islice(bad(), 0, None, EVERY):
            text = make()
            path = Path(folder) / "bad.cert"
            path.write_text(text)
            results = []
            for command in ([sys.executable, "-B", str(ROOT / "tools" / "check_certificate.py"), str(path)], [PROGRAM, "verify", str(path)]):
                start = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                run = subprocess.run(command, capture_output=True, text=True, preexec_fn=limit)
                seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - start
                results.append((run.returncode, seconds, (run.stdout + run.stderr).strip().splitlines()[-1:]))
            number += 1
            if os.environ.get("PHRAME_LIMITS") == "print":
                print("%-40s %6d bytes, script: %s in %.2f s, verify: %s in %.2f s %s" % (
                    name, len(text), results[0][0], results[0][1], results[1][0], results[1][1], str(results[0][2])[:110]), flush=True)
            (mine, _, told), (other, _, said) = results
            if mine not in (0, 1, 2) or mine != other or len(text) > 110000 or "Traceback" in str(told):
                wrong.append("%s: the script %s %s, verify %s %s" % (name, mine, told, other, said))
    print("%d certificates" % number)
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
