"""Random pipes as routes have them: lines, quarter circles and arcs of rational and of algebraic angles, in planes and in
space, open and closed; and parallel transport along them in doubles, from the control points alone."""
import math
import random
from fractions import Fraction as F


def plus(a, b, factor=1):
    return [x + factor * y for x, y in zip(a, b)]


def times(c, a):
    return [c * x for x in a]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


AXES = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]]
HALF = F(1, 2)


def axes_turned(rng):
    """Three rational unit vectors at right angles: those of x, y, z, or turned by a quaternion."""
    u, v, p, q = rng.choice([(1, 0, 0, 0), [rng.randint(-3, 3) for _ in range(3)] + [1]])
    n = F(u * u + v * v + p * p + q * q)
    return [times(1 / n, row) for row in (
        [u * u + v * v - p * p - q * q, 2 * (v * p + u * q), 2 * (v * q - u * p)],
        [2 * (v * p - u * q), u * u - v * v + p * p - q * q, 2 * (p * q + u * v)],
        [2 * (v * q + u * p), 2 * (p * q - u * v), u * u - v * v - p * p + q * q])]


def cosine_and_sine(t):
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def open_pipe(rng, legs, kind):
    """Legs (points, weights); each starts in the direction T in which the one before ends."""
    p, (T, N, B), pipe = [F(rng.randint(-5, 5)) for _ in range(3)], axes_turned(rng), []
    for leg in range(legs):
        r = F(rng.randint(1, 6), rng.randint(1, 2))
        if leg % 2 == 0 and rng.random() < .8:
            pipe.append(([p, plus(p, T, r)], [1, 1]))
        elif kind == "algebraic":  # a conic to a direction of any length
            D = [F(rng.randint(-4, 4)) for _ in range(3)]
            while cross(D, T) == [0, 0, 0]:
                D = [F(rng.randint(-4, 4)) for _ in range(3)]
            middle = plus(p, T, r)
            pipe.append(([p, middle, plus(middle, D)], [1, F(rng.randint(1, 4), 3), rng.randint(1, 2)]))
            T = D
        else:  # an arc in the plane of T and U
            (a, b), (c, s) = (1, 0), (0, 1)
            if kind == "quarters":
                a, b = rng.choice([(1, 0), (0, 1), (-1, 0), (0, -1)])
            if kind == "plane":
                a = rng.choice([1, -1])
            if kind == "rational":
                a, b = cosine_and_sine(F(rng.randint(-5, 5), rng.randint(1, 5)))
            if kind in ("plane", "rational"):
                c, s = cosine_and_sine(F(rng.randint(1, 9), rng.randint(9, 12)))
            U = plus(times(a, N), B, b)
            end = plus(plus(p, T, r * s), U, r * (1 - c))
            pipe.append(([p, plus(p, T, r * s / (1 + c)), end], [1, (1 + F(c)) / 2, (1 + F(c)) / 2]))
            if kind != "plane" or b != 0:
                N = plus(times(c, U), T, -s)
                T = plus(times(c, T), U, s)
                B = cross(T, N)
            else:
                T, N = plus(times(c, T), U, s), times(a, plus(times(c, U), T, -s))
        p = pipe[-1][0][-1]
    return pipe


def corners(rng, count, kind):
    """Of a closed polygon: along the axes, or anywhere."""
    if kind == "algebraic":
        return [[rng.randint(-6, 6) for _ in range(3)] for _ in range(count)]
    allowed = [a for a in AXES if kind != "plane" or a[2] == 0]
    points = [[0, 0, 0]]
    for _ in range(count):
        points.append(plus(points[-1], rng.choice(allowed), 2 * rng.randint(1, 3)))
    back = [times(-x, AXES[k]) for k, x in enumerate(points[-1]) if x != 0]
    rng.shuffle(back)
    for step in back:
        points.append(plus(points[-1], step))
    return points[:-1]


def closed_pipe(rng, legs, kind):
    """The corners of a polygon made round."""
    while True:
        points = corners(rng, max(3, legs // 2), kind)
        n = len(points)
        edges = [plus(points[(k + 1) % n], points[k], -1) for k in range(n)]
        if n >= 3 and all(cross(edges[k - 1], edges[k]) != [0, 0, 0] for k in range(n)):
            break
    axes, pipe = axes_turned(rng), []
    for k in range(n):
        a, b, c = ([dot(times(F(1), q), axis) for axis in axes] for q in (points[k], points[(k + 1) % n], points[(k + 2) % n]))
        lengths = [max(map(abs, edges[(k + j) % n])) for j in (0, 1)]
        share = [F(1, 3) if kind == "algebraic" else F(1, length) for length in lengths]
        start, end, on = plus(times(1 - share[0], a), b, share[0]), plus(times(share[0], a), b, 1 - share[0]), \
            plus(times(1 - share[1], b), c, share[1])
        if start != end:
            pipe.append(([start, end], [1, 1]))
        weights = [1, F(rng.randint(1, 4), 3), 1] if kind == "algebraic" else [1, HALF, HALF]
        pipe.append(([end, b, on], weights))
    return pipe


def pipes(count):
    """(name, is closed, legs) of so many, in the same order always."""
    for number in range(count):
        rng = random.Random("pipe %d" % number)
        kind = ("quarters", "plane", "rational", "algebraic")[number % 4]
        is_closed = number // 4 % 2 == 1
        legs = rng.randint(3, 10)
        yield ("%03d, %s, %s" % (number, kind, "closed" if is_closed else "open"), is_closed,
               (closed_pipe if is_closed else open_pipe)(rng, legs, kind))


def file_of(pipe):
    return {"phrame": "spline/1", "segments": [
        {"phrame": "curve/1", "control_points": [[str(F(x)) for x in p] for p in points], "weights": list(map(str, weights))}
        for points, weights in pipe]}


def tangent(leg, t):
    """The unit tangent of a leg, from the derivatives of its polynomials in doubles."""
    points, weights = leg
    if len(points) == 2:
        r = [float(x) for x in plus(points[1], points[0], -1)]
    else:
        w = [float(x) for x in weights]
        basis = (1 - t) ** 2, 2 * t * (1 - t), t * t
        slope = -2 * (1 - t), 2 - 4 * t, 2 * t
        W, dW = (sum(x * y for x, y in zip(w, b)) for b in (basis, slope))
        r = []
        for axis in range(3):
            X, dX = (sum(w[k] * float(points[k][axis]) * b[k] for k in range(3)) for b in (basis, slope))
            r.append(dX * W - X * dW)
    return times(1 / math.sqrt(dot(r, r)), r)


class Transport:
    """Parallel transport of vectors along a pipe, by the shortest rotations between tangents a sixteenth of a leg apart."""

    def __init__(self, pipe):
        self.pipe = pipe

    def along(self, f, until):
        """f at the start → f at the parameter `until`, a multiple of 1/16, and the tangent there."""
        before = tangent(self.pipe[0], 0.0)
        for step in range(round(16 * until) + 1):
            leg = min(step // 16, len(self.pipe) - 1)
            now = tangent(self.pipe[leg], step / 16 - leg)
            axis, cosine = cross(before, now), dot(before, now)
            f = plus(plus(times(cosine, f), cross(axis, f)), axis, dot(axis, f) / (1 + cosine))
            before = now
        return f, before

    def angle(self, v, until):
        """θ of a frame that is transported to the frame of v, up to whole turns."""
        def across(T):
            e = cross(v, T)
            return times(1 / math.sqrt(dot(e, e)), e)
        f, T = self.along(across(tangent(self.pipe[0], 0.0)), until)
        e = across(T)
        return math.atan2(dot(f, cross(T, e)), dot(f, e))
