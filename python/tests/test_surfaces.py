"""Exact surfaces of `phrame sweep --exact`, as free-form OBJ, evaluated by geomdl: S = r + scale·(x f2 + y f3)."""

import json
import os
import subprocess

import numpy as np
import pytest

import phrame
from common import PROGRAM, ROOT

NURBS = pytest.importorskip("geomdl.NURBS")
pytestmark = pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")

CURVES = ROOT / "examples/curves"


def program(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, check=True, text=True).stdout


def read_free_form(text):
    """The statement surf lists control points u first; a Bézier patch is a spline with all knots at its ends."""
    vertices, surfaces, kind, degrees = [], [], None, None
    for line in text.splitlines():
        word, *rest = line.split()
        if word == "v":
            x, y, z, w = map(float, rest)
            vertices.append([w * x, w * y, w * z, w])
        elif word == "cstype":
            kind = rest
        elif word == "deg":
            degrees = list(map(int, rest))
        elif word == "surf":
            assert kind == ["rat", "bezier"] and rest[:4] == ["0", "1", "0", "1"]
            points = [vertices[int(k) - 1] for k in rest[4:]]
            count_u, count_v = (degree + 1 for degree in degrees)
            assert len(points) == count_u * count_v
            surface = NURBS.Surface()
            surface.degree_u, surface.degree_v = degrees
            surface.ctrlpts2d = [[points[u + count_u * v] for v in range(count_v)] for u in range(count_u)]
            surface.knotvector_u, surface.knotvector_v = ([0.0] * n + [1.0] * n for n in (count_u, count_v))
            surfaces.append(surface)
    return surfaces


def on_circle(side, u):
    x, y = (1 - u * u) / (1 + u * u), 2 * u / (1 + u * u)
    for _ in range(side):
        x, y = -y, x
    return x, y


def on_square(side, u):
    corners = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    (a, b), (c, d) = corners[side], corners[(side + 1) % 4]
    return a + u * (c - a), b + u * (d - b)


@pytest.mark.parametrize(("name", "profile", "at", "size", "scale"), [
    ("rational-frame-quintic.json", "circle:1/5", on_circle, 1 / 5, "1"),
    ("plane-cubic.json", "rectangle:1,1", on_square, 1 / 2, "(2-t)/(1+t)"),
    ("septic-erf-is-rmf.json", "circle:1/3", on_circle, 1 / 3, "1+t^2"),
])
def test_surfaces_are_where_the_frame_has_them(name, profile, at, size, scale):
    path = phrame.read(CURVES / name)
    options = ["sweep", CURVES / name, "--exact", "--profile", profile, "--scale", scale]
    surfaces = read_free_form(program(*options))
    patches = json.loads(program(*options, "--format", "json"))["patches"]
    assert len(surfaces) == len(patches)
    grid = [0, 0.15, 0.5, 0.85, 1]
    extent = np.abs(path.points(grid)).max()
    for surface, patch in zip(surfaces, patches):
        begin, end = (float(x.split("/")[0]) / float((x + "/1").split("/")[1]) for x in patch["t"])
        for s in grid:
            t = begin + s * (end - begin)
            (r,), ((_, f2, f3),) = path.points([t]), path.frames([t])
            length = size * float(eval(scale.replace("^", "**"), {"t": t}))
            for u in grid:
                x, y = at(patch["side"], u)
                assert np.abs(surface.evaluate_single((u, s)) - (r + length * (x * f2 + y * f3))).max() < 1e-11 * (1 + extent)


def test_a_closed_surface_of_minimal_twist_is_a_tube():
    name = CURVES / "closed-spline.json"
    path = phrame.read(name)
    options = ["sweep", name, "--exact", "--profile", "circle:1/8", "--degree", "2"]
    surfaces = read_free_form(program(*options))
    patches = json.loads(program(*options, "--format", "json"))["patches"]
    for surface, patch in zip(surfaces, patches):
        begin, end = (float(x.split("/")[0]) / float((x + "/1").split("/")[1]) for x in patch["t"])
        for s in (0.1, 0.6, 0.95):
            t = begin + s * (end - begin)
            (r,), ((e1, _, _),) = path.points([t]), path.frames([t])
            for u in (0, 0.3, 1):
                out = np.array(surface.evaluate_single((u, s))) - r
                assert abs(np.linalg.norm(out) - 1 / 8) < 1e-12 and abs(out @ e1) < 1e-12
    first, last = surfaces[0].evaluate_single((0.4, 0.0)), surfaces[-4].evaluate_single((0.4, 1.0))
    assert np.abs(np.array(first) - last).max() < 1e-12
