#!/usr/bin/env python3
"""Writes splines.json: points of B-splines, NURBS and cubic splines, as SciPy 1.17 and geomdl 5.4 find them.

Both are asked where both can; they agree to 12 digits, or this fails. Numbers are doubles.
"""

import json
import random

import numpy as np
from geomdl import NURBS
from scipy.interpolate import BSpline, CubicSpline

random.seed(19)


def bspline(name, degree, knots, points, weights=None):
    points = np.array(points, dtype=float)
    w = np.ones(len(points)) if weights is None else np.array(weights, dtype=float)
    first, last = knots[degree], knots[-1 - degree]
    at = [first, last] + [first + (last - first) * random.random() for _ in range(6)]
    homogeneous = BSpline(knots, np.column_stack([w[:, None] * points, w]), degree)(at)
    values = homogeneous[:, :3] / homogeneous[:, 3:]
    if knots[0] == first and knots[-1] == last:  # geomdl knows clamped ones only
        curve = NURBS.Curve(normalize_kv=False)
        curve.degree = degree
        curve.ctrlpts = points.tolist()
        curve.weights = w.tolist()
        curve.knotvector = knots
        # Beyond its last span geomdl evaluates nothing.
        inner = [u for u in at if u != last]
        expected = [v for u, v in zip(at, values) if u != last]
        assert np.allclose(curve.evaluate_list(inner), expected, rtol=1e-12, atol=1e-12), name
    spline = {"name": name, "degree": degree, "knots": knots, "control_points": points.tolist()}
    if weights is not None:
        spline["weights"] = weights
    return spline | {"at": at, "values": values.tolist()}


def cubic(name, points, parameters, ends, derivatives=None):
    points = np.array(points, dtype=float)
    kind = ends
    if ends == "clamped":
        kind = ((1, derivatives[0]), (1, derivatives[1]))
    spline = CubicSpline(parameters, points, bc_type=kind)
    result = {"name": name, "points": points.tolist(), "parameters": parameters, "ends": ends}
    if derivatives:
        result["end_derivatives"] = derivatives
    return result | {"derivatives": spline(parameters, 1).tolist()}


def random_points(count):
    return [[round(random.uniform(-5, 5), 3) for _ in range(3)] for _ in range(count)]


half = 0.7071067811865476
around = [[1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 1, 0], [-1, 0, 0], [-1, -1, 0], [0, -1, 0], [1, -1, 0], [1, 0, 0]]
closed = random_points(6)
splines = {
    "made_by": "splines.py",
    "bsplines": [
        bspline("clamped cubic", 3, [0, 0, 0, 0, 1, 2.5, 3, 3, 3, 3], random_points(6)),
        bspline("unclamped quartic", 4, [-2, -1, 0, 0.5, 1, 2, 4, 4.5, 5, 7, 8, 9], random_points(7)),
        bspline("a double and a triple knot", 3, [0, 0, 0, 0, 1, 1, 2, 2, 2, 3, 3, 3, 3], random_points(9)),
        bspline("circle", 2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], around, [1, half] * 4 + [1]),
        bspline("rational quintic", 5, [0] * 6 + [0.25, 0.75] + [1] * 6, random_points(8),
                [1, 2, 0.5, 0.125, 3, 1, 1, 7]),
        bspline("one span of degree 9", 9, [0] * 10 + [1] * 10, random_points(10)),
    ],
    "cubics": [
        cubic("natural", random_points(7), [0, 1, 1.5, 4, 4.25, 5, 9], "natural"),
        cubic("clamped", random_points(5), [0, 1, 2, 3, 4], "clamped", [[1, 0, -2], [0.5, 0.5, 3]]),
        cubic("periodic", closed + closed[:1], [0, 1, 3, 3.5, 5, 6, 8], "periodic"),
        cubic("two points", random_points(2), [0, 2], "natural"),
    ],
}

with open("splines.json", "w") as file:
    text = json.dumps(splines)
    file.write(text.replace('{"name"', '\n  {"name"').replace('"cubics"', '\n "cubics"') + "\n")
