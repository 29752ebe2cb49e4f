"""The surfaces of `phrame sweep --exact`, in Python's fractions, by code that shares nothing with what makes them.

Of each patch, as polynomials in s for more u than there are degrees in it, so that it holds everywhere: S - r is normal
to r', has the length of the profile and, where the frame is rotation-minimizing, a rate along r'. r is integrated anew
from the curve's file. Which way the profile lies is that of `phrame frames`. The OBJ says the same in doubles.
"""
import json
import tempfile
from fractions import Fraction
from math import comb, lcm
from pathlib import Path

from program import phrame

ROOT = Path(__file__).resolve().parent.parent.parent
CURVES = ROOT / "examples/curves"


def integers(p):
    """Of the coefficients, and their common denominator."""
    d = lcm(*(x.denominator for x in p))
    return [x.numerator * (d // x.denominator) for x in p], d


def product(p, q):
    """In integers, since a sum of fractions is reduced after each term."""
    (p, d), (q, e) = integers(p), integers(q)
    r = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            r[i + j] += a * b
    return [Fraction(x, d * e) for x in r]


def total(*terms):
    """Σ c·p of pairs of a number and a polynomial."""
    r = [Fraction(0)] * max(len(p) for _, p in terms)
    for c, p in terms:
        for k, x in enumerate(p):
            r[k] += c * x
    return r


def from_bernstein(b):
    n = len(b) - 1
    p = [Fraction(0)] * (n + 1)
    for k, x in enumerate(b):
        for j in range(n - k + 1):
            p[k + j] += x * comb(n, k) * comb(n - k, j) * (-1) ** j
    return p


def segments(name):
    """(A, f) of the segments of a file and the start, f = 1 where none is given."""
    data = json.loads((CURVES / name).read_text())
    found = []
    for part in data.get("segments", [data]):
        columns = zip(*part["quaternions"]) if "quaternions" in part else (part["preimage"][k] for k in "uvpq")
        polynomials = [[Fraction(x) for x in c] for c in (*columns, part.get("multiplier", ["1"]))]
        if part["basis"] == "bernstein":
            polynomials = list(map(from_bernstein, polynomials))
        found.append((polynomials[:4], polynomials[4]))
    return found, [Fraction(x) for x in data.get("start", [0, 0, 0])]


def hodograph(preimage, f):
    u, v, p, q = preimage
    x = total((1, product(u, u)), (1, product(v, v)), (-1, product(p, p)), (-1, product(q, q)))
    y = total((2, product(u, q)), (2, product(v, p)))
    z = total((2, product(v, q)), (-2, product(u, p)))
    return [product(f, component) for component in (x, y, z)]


def value(p, t):
    r = Fraction(0)
    for c in reversed(p):
        r = r * t + c
    return r


def differentiate(p):
    return [k * c for k, c in enumerate(p)][1:] or [Fraction(0)]


def compose(p, q):
    r = [Fraction(0)]
    for c in reversed(p):
        r = total((1, product(r, q)), (1, [c]))
    return r


def is_zero(p):
    return not any(p)


def position(parts, start, segment):
    """r of the segment, as polynomials."""
    at = list(start)
    for k in range(segment + 1):
        r = [[x] + [c / (n + 1) for n, c in enumerate(rate)] for x, rate in zip(at, hodograph(*parts[k]))]
        at = [value(x, 1) for x in r]
    return r


def section(patch, u):
    """X, Y, Z, W of S(u, .) = (X, Y, Z)/W, as polynomials in s."""
    def blend(row):
        n = len(row) - 1
        return sum(comb(n, l) * u ** l * (1 - u) ** (n - l) * x for l, x in enumerate(row))
    columns = [[blend([w * (point + [1])[axis] for w, point in zip(weights, points)])
                for weights, points in zip(patch["weights"], patch["points"])] for axis in range(4)]
    return list(map(from_bernstein, columns))


def read_surface(text):
    surface = json.loads(text)
    for patch in surface["patches"]:
        patch["t"] = [Fraction(x) for x in patch["t"]]
        patch["weights"] = [[Fraction(x) for x in row] for row in patch["weights"]]
        patch["points"] = [[[Fraction(x) for x in p] for p in row] for row in patch["points"]]
        assert all(w > 0 for row in patch["weights"] for w in row)
    return surface


def circle(radius):
    """x² + y² of a quarter, and (x, y) at u."""
    def at(side, u):
        x, y = radius * (1 - u * u) / (1 + u * u), radius * 2 * u / (1 + u * u)
        for _ in range(side):
            x, y = -y, x
        return x, y
    return at


def rectangle(width, height):
    corners = [(width / 2, height / 2), (-width / 2, height / 2), (-width / 2, -height / 2), (width / 2, -height / 2)]

    def at(side, u):
        (a, b), (c, d) = corners[side], corners[(side + 1) % 4]
        return a + u * (c - a), b + u * (d - b)
    return at


def frame(width, hole):
    """A square with a square hole, in the order of the table: what is around first, holes against its direction."""
    def corners(half):
        return [(-half, -half), (half, -half), (half, half), (-half, half)]
    rings = [corners(width / 2), corners(hole / 2)[::-1]]

    def at(side, u):
        (a, b), (c, d) = rings[side // 4][side % 4], rings[side // 4][(side + 1) % 4]
        return a + u * (c - a), b + u * (d - b)
    table = "\n".join("".join("%s,%s\n" % corner for corner in corners(half)) for half in (hole / 2, width / 2))
    return table, at


def check_patch(patch, parts, start, profile, scale, is_rotation_minimizing):
    begin, end = patch["t"]
    segment = int(begin)
    r = [compose(x, [begin - segment, end - begin]) for x in position(parts, start, segment)]
    rate = list(map(differentiate, r))
    above, below = (compose(p, [begin, end - begin]) for p in scale)
    count = 2 * patch["degree_u"] + 1
    for u in (Fraction(i, count - 1) for i in range(count)):
        *place, weight = section(patch, u)
        out = [total((1, x), (-1, product(y, weight))) for x, y in zip(place, r)]
        assert is_zero(total(*((1, product(x, y)) for x, y in zip(out, rate)))), "normal"
        x, y = profile(patch["side"], u)
        distance = product(product(weight, above), product(weight, above))
        square = total(*((1, product(x, x)) for x in out))
        assert is_zero(total((1, product(square, product(below, below))), (-(x * x + y * y), distance))), "distance"
        if is_rotation_minimizing:  # (out·below/(weight·above))' is along the rate
            divisor = product(weight, above)
            turn = [total((1, product(differentiate(product(x, below)), divisor)),
                          (-1, product(product(x, below), differentiate(divisor)))) for x in out]
            for i, j in ((0, 1), (1, 2), (2, 0)):
                across = total((1, product(turn[i], rate[j])), (-1, product(turn[j], rate[i])))
                assert is_zero(across), "rotation-minimizing"


def check_direction(patch, name, parts, start, profile, frame, *more):
    """S - r in the patch, of a curve, against the frame that `phrame frames` has, in doubles."""
    s, u = Fraction(3, 5), Fraction(1, 3)
    t = patch["t"][0] + s * (patch["t"][1] - patch["t"][0])
    table = phrame("frames", CURVES / name, "--at", t, *more).splitlines()
    row = dict(zip(table[0].split(","), map(float, table[1].split(","))))
    r = [value(x, t) for x in position(parts, start, 0)]
    *place, weight = (value(x, s) for x in section(patch, u))
    x, y = profile(patch["side"], u)
    for k, axis in enumerate("xyz"):
        expected = float(x) * row[frame + "2" + axis] + float(y) * row[frame + "3" + axis]
        assert abs(float(place[k] / weight - r[k]) - expected) < 1e-13, "direction"


def check_rings(surface):
    """The last side of each ring meets its first one."""
    firsts, sides = surface["rings"], surface["sides"]
    after = {end - 1: first for first, end in zip(firsts, firsts[1:] + [sides])}
    patches = surface["patches"]
    for n, patch in enumerate(patches):
        side = n % sides
        assert patch["side"] == side
        following = patches[n - side + after.get(side, side + 1)]
        assert [row[-1] for row in patch["points"]] == [row[0] for row in following["points"]], "ring"


def check_obj(surface, text):
    """Vertices are those of the patches, in the order of the statement surf, u first."""
    vertices, patches = [], []
    for line in text.splitlines():
        word, *rest = line.split()
        if word == "v":
            vertices.append(tuple(map(float, rest)))
        elif word == "deg":
            degrees = tuple(map(int, rest))
        elif word == "surf":
            assert rest[:4] == ["0", "1", "0", "1"]
            patches.append((degrees, [vertices[int(k) - 1] for k in rest[4:]]))
        else:
            assert line in ("cstype rat bezier", "parm u 0 1", "parm v 0 1", "end"), line
    assert len(patches) == len(surface["patches"])
    for (degrees, points), patch in zip(patches, surface["patches"]):
        assert degrees == (patch["degree_u"], patch["degree_t"])
        expected = [tuple(float(x) for x in p) + (float(w),)
                    for row, weights in zip(patch["points"], patch["weights"]) for p, w in zip(row, weights)]
        assert points == expected  # Python rounds fractions correctly


def check(name, option, profile, scale=None, *more):
    """The scale as a text and as polynomials above and below the line."""
    text, polynomials = scale or ("1", ([1], [1]))
    arguments = ["sweep", CURVES / name, "--exact", "--profile", option, "--scale", text, *more]
    parts, start = segments(name)
    surface = read_surface(phrame(*arguments, "--format", "json"))
    is_rotation_minimizing = surface["frame"] == "rotation-minimizing"
    for patch in surface["patches"][::1 if is_rotation_minimizing else 3]:  # else of long fractions
        check_patch(patch, parts, start, profile, polynomials, is_rotation_minimizing)
    if not scale:
        frame = ["f"] if is_rotation_minimizing else ["mtf", "--frame", "mtf", "--from", "0", "--to-vector", more[1]]
        check_direction(surface["patches"][-1], name, parts, start, profile, *frame)
    check_obj(surface, phrame(*arguments))
    assert surface["patches"][-1]["t"][1] == len(parts)
    check_rings(surface)
    print("%s, %s: %d patches" % (name, " ".join(map(str, arguments[3:])), len(surface["patches"])))


def place(patch, s, u):
    """S, by the sum of the Bernstein polynomials."""
    def basis(n, t):
        return [comb(n, k) * t ** k * (1 - t) ** (n - k) for k in range(n + 1)]
    products = [(weight * b * c, point)
                for weights, points, b in zip(patch["weights"], patch["points"], basis(patch["degree_t"], s))
                for weight, point, c in zip(weights, points, basis(patch["degree_u"], u))]
    below = sum(weight for weight, _ in products)
    return [sum(weight * point[axis] for weight, point in products) / below for axis in range(3)]


def check_pipe():
    """Of a line and a quarter of a circle: a cylinder and a torus, by their equations; which part, by its places."""
    drawing = ROOT / "tests/data/found/kcad.svg"  # (0, 0) to (0, 10), then about (10, 10)
    surface = read_surface(phrame("sweep", drawing, "--exact", "--profile", "circle:3", "--format", "json"))
    patches = surface["patches"]
    assert len(patches) == 8 and not surface["closed"] and surface["frame"] == "rotation-minimizing"
    for patch in patches:
        for s in (Fraction(0), Fraction(1, 3), Fraction(1)):
            for u in (Fraction(0), Fraction(2, 5), Fraction(1)):
                x, y, z = place(patch, s, u)
                if patch["t"] == [0, 1]:
                    assert x * x + z * z == 9 and y == 10 * s
                else:
                    assert ((x - 10) ** 2 + (y - 10) ** 2 + z * z + 100 - 9) ** 2 == 400 * ((x - 10) ** 2 + (y - 10) ** 2)
                    assert x <= 10 <= y and (s < 1 or x == 10) and (s > 0 or y == 10)
    print("kcad.svg: a cylinder and a torus")


check_pipe()
check("rational-frame-quintic.json", "rectangle:1,1/2", rectangle(Fraction(1), Fraction(1, 2)))
check("plane-cubic.json", "circle:1/3", circle(Fraction(1, 3)), ("(2 - t)/(1 + t)", ([2, -1], [1, 1])))
check("septic-erf-is-rmf.json", "circle:1/5", circle(Fraction(1, 5)))
with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
    table, hollow = frame(Fraction(1, 4), Fraction(1, 6))
    file.write(table)
    file.flush()
    check("rational-frame-quintic.json", file.name, hollow)
    check("septic-erf-is-rmf.json", file.name, hollow, ("1 + t", ([1, 1], [1])))
check("farouki-2003-quintic.json", "rectangle:1/5,1/5", rectangle(Fraction(1, 5), Fraction(1, 5)), None,
      "--end-normal", "0,0,1", "--start", "erf")
