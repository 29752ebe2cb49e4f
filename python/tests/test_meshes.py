"""Bodies as trimesh reads them: it neither warns nor repairs, and finds closed bodies of the right volume.

A prism has the area of its section times its length. A tube around a closed curve has, where it does not meet itself,
the area of its section times the length of the curve, and the surface 2·pi·R times that length [Pappus]; a mesh within a
tolerance of that surface is off by no more than the layer of that thickness. Lengths are sums of Gauss's here.
"""

import logging
import math
import os
import subprocess

import numpy as np
import pytest

import phrame
from common import PROGRAM, QUINTIC, ROOT

trimesh = pytest.importorskip("trimesh")

FORMATS = ("obj", "stl", "ply", "glb")
# The corners of an L of the area 3.
L_SHAPE = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]


def as_read(body, file, caplog):
    """One mesh, with points that are given once; a word of complaint is a failure, as warnings are everywhere."""
    body.save(file)
    with caplog.at_level(logging.WARNING):
        mesh = trimesh.load_mesh(file)
    assert not [record for record in caplog.records if record.levelno >= logging.WARNING]
    assert mesh.vertices.shape == body.vertices.shape and mesh.faces.shape == body.triangles.shape
    assert mesh.is_watertight and mesh.is_winding_consistent and mesh.is_volume
    assert mesh.area_faces.min() > 0
    return mesh


def length(path):
    """∫|r'|, each segment in 40 parts of 12 nodes."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    total = 0.0
    for curve in path.segments:
        hodograph = [np.array([float(c) for c in part.coefficients] or [0.0]) for part in curve.hodograph]
        for k in range(40):
            t = (k + (nodes + 1) / 2) / 40
            rate = [np.polynomial.polynomial.polyval(t, c) for c in hodograph]
            total += float(weights @ np.sqrt(sum(x * x for x in rate))) / 80
    return total


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("suffix", FORMATS)
def test_a_prism_has_its_volume(suffix, tmp_path, caplog):
    line = phrame.Curve([2], [0], [0], [1])  # (3, 4, 0)·t
    mesh = as_read(phrame.sweep(line, L_SHAPE, tolerance="1/100"), tmp_path / f"prism.{suffix}", caplog)
    assert mesh.euler_number == 2 and mesh.volume == pytest.approx(15, rel=1e-14 if suffix in ("obj", "ply") else 1e-6)
    assert mesh.area == pytest.approx(2 * 3 + 8 * 5, rel=1e-6)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("suffix", FORMATS)
def test_holes_go_through(suffix, tmp_path, caplog):
    outline = tmp_path / "outline.svg"
    outline.write_text('<svg><path d="M0 0H6V4H0Z M1 1V3H2V1Z"/><path d="M3 1h2v2z"/></svg>')
    line = phrame.Curve([2], [0], [0], [1])
    mesh = as_read(phrame.sweep(line, outline, tolerance="1/100"), tmp_path / f"profile.{suffix}", caplog)
    assert mesh.euler_number == -2 and mesh.volume == pytest.approx(5 * (24 - 2 - 2), rel=1e-6)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(("name", "suffix"), [("torus", "obj"), ("in space", "ply")])
def test_a_tube_around_a_closed_spline_has_the_volume_of_pappus(name, suffix, tmp_path, caplog):
    if name == "torus":  # 12 quintics next to the unit circle
        points = [[math.cos(k * math.pi / 6), math.sin(k * math.pi / 6), 0] for k in range(12)]
        path, radius, tolerance = phrame.Curve.through(points, closed=True), 1 / 4, 1 / 500
    else:
        path, radius, tolerance = phrame.read(ROOT / "examples/curves/closed-spline.json"), 1 / 8, 1 / 250
    body = phrame.sweep(path, f"circle:{radius}", tolerance=tolerance)
    assert body.is_closed and body.folds == 0 and body.error <= tolerance
    mesh = as_read(body, tmp_path / f"tube.{suffix}", caplog)
    along = length(path)
    if name == "torus":
        assert abs(along - 2 * math.pi) < 1e-3
    surface, volume = 2 * math.pi * radius * along, math.pi * radius**2 * along
    assert mesh.euler_number == 0
    assert abs(mesh.volume - volume) <= 1.01 * tolerance * surface
    assert mesh.area == pytest.approx(surface, rel=0.02)


@pytest.mark.parametrize("offset", [0, 10**3, 10**6, 10**9])
def test_bodies_far_from_0_are_as_they_are_near(offset, tmp_path, caplog):
    """Where floats do: glTF's always, beside a node's place; those of STL from an origin near the body."""
    path = QUINTIC.translated([offset] * 3)
    near = phrame.sweep(QUINTIC, "circle:1/10", tolerance="1/40")
    body = phrame.sweep(path, "circle:1/10", tolerance="1/40")
    local = phrame.sweep(path, "circle:1/10", tolerance="1/40", origin="auto")
    assert local.origin == (offset,) * 3 and np.array_equal(local.vertices, near.vertices)
    for file in ("a.glb", "a.ply"):
        mesh = as_read(body, tmp_path / file, caplog)
        off = np.linalg.norm(mesh.vertices - offset - near.vertices, axis=1).max()
        assert off <= 1e-6 + offset * 2e-16 * math.sqrt(3)
    assert near.error < local.save(tmp_path / "a.stl") < near.error + 1e-6
    if offset < 10**6:
        assert body.save(tmp_path / "b.stl") < 1 / 40
    else:
        with pytest.raises(phrame.Undecided, match="the same in floats; PLY and OBJ have doubles"):
            body.save(tmp_path / "b.stl")
        assert not (tmp_path / "b.stl").exists()


@pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")
@pytest.mark.parametrize(("name", "radius"), [("curves/farouki-2003-quintic.json", 1 / 10), ("curves/closed-spline.json", 1 / 20)])
def test_normals_of_tubes_in_space_are_within_the_bound(name, radius, tmp_path):
    """The normal of a tube is the direction from the nearest point of the curve: that of many in doubles."""
    file = tmp_path / "tube.ply"
    said = subprocess.run([PROGRAM, "sweep", ROOT / "examples" / name, "--profile", f"circle:{radius}", "--tolerance", "1",
                           "--normal-tolerance", "10deg", "-o", file], capture_output=True, check=True, text=True).stdout
    bound = float(said.split("normals within ")[1].split(" rad")[0])
    assert bound <= 0.18  # 10 degrees, rounded up
    mesh = trimesh.load_mesh(file)
    path = phrame.read(ROOT / "examples" / name)
    ts = np.linspace(0, len(path.segments), 4001)
    centers, tangents = path.points(ts), path.frames(ts)[:, 0]
    chosen = np.random.default_rng(21).choice(len(mesh.faces), 200)
    inside = np.random.default_rng(22).dirichlet([0.3] * 3, 200)  # mostly near corners and sides
    places = np.einsum("ij,ijk->ik", inside, mesh.vertices[mesh.faces[chosen]])
    nearest = np.argmin(np.linalg.norm(places[:, None] - centers[None], axis=2), axis=1)
    out = places - centers[nearest]
    out -= np.sum(out * tangents[nearest], axis=1, keepdims=True) * tangents[nearest]
    normals = mesh.face_normals[chosen]
    is_side = np.abs(np.sum(normals * tangents[nearest], axis=1)) < 0.9  # no cap
    cosines = np.sum(normals * out, axis=1) / np.linalg.norm(out, axis=1)
    greatest = np.arccos(np.clip(cosines[is_side], -1, 1)).max()
    assert bound / 4 < greatest <= bound
