"""Writes scipy.json: curves of scipy.interpolate as lists, and points of them in doubles. Needs SciPy."""

import json
import pathlib

import numpy
from scipy.interpolate import BSpline, CubicSpline, PchipInterpolator, make_interp_spline, splev, splprep

x = numpy.array([0.0, 1.0, 2.5, 4.0, 5.0])
y = numpy.array([[0, 0, 0], [1, 2, 0], [3, 3, 1], [4, 0, 2], [5, -1, 2]], dtype=float)
fractions = (0.25, 0.5)


def entry(name, curve, breaks, value):
    """With points of each span, at these fractions of it: [span, fraction, point]."""
    points = [
        [k, f, [float(a) for a in value(a + f * (b - a))]]
        for k, (a, b) in enumerate(zip(breaks, breaks[1:]))
        for f in fractions
    ]
    return {"name": name, "curve": curve, "points": points}


def of_bspline(name, spline):
    curve = {"t": spline.t.tolist(), "c": spline.c.tolist(), "k": int(spline.k)}
    return entry(name, curve, numpy.unique(spline.t[spline.k : len(spline.t) - spline.k]), spline)


def of_ppoly(name, poly):
    return entry(name, {"c": poly.c.tolist(), "x": poly.x.tolist()}, poly.x, poly)


tck, u = splprep(y.T, s=0)
listed = [tck[0].tolist(), [a.tolist() for a in tck[1]], int(tck[2])]
entries = [
    of_bspline("make_interp_spline", make_interp_spline(x, y, k=3)),
    of_bspline("quintic", make_interp_spline(numpy.arange(8.0), numpy.column_stack(
        [numpy.arange(8.0), numpy.sin(numpy.arange(8.0))]), k=5)),
    of_bspline("unclamped", BSpline(numpy.arange(9.0), y, 3)),
    of_ppoly("CubicSpline", CubicSpline(x, y)),
    of_ppoly("PchipInterpolator", PchipInterpolator(x, y)),
    entry("splprep", listed, numpy.unique(tck[0]), lambda t: splev(t, tck)),
    entry("splprep with u", [listed, u.tolist()], numpy.unique(tck[0]), lambda t: splev(t, tck)),
]
path = pathlib.Path(__file__).with_name("scipy.json")
path.write_text("[\n" + ",\n".join(json.dumps(e) for e in entries) + "\n]\n", encoding="utf-8")
