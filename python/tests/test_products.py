"""What is made of a path: motions, headers in C, bodies, pages."""

import os
import pickle
import subprocess
from collections import Counter
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import PROGRAM, QUINTIC, ROOT

CUBIC = phrame.Curve.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
FILE = ROOT / "examples/curves/farouki-2003-quintic.json"

by_program = pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program was not built")


def program(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, check=True).stdout


def test_motions():
    for path in (QUINTIC, CUBIC):
        motion = path.interpolate(2, "1/8")
        assert motion.dtype.names == ("k", "time", "t", "s", "x", "y", "z")
        assert (motion["k"] == np.arange(len(motion))).all()
        assert (motion["time"][:-1] == motion["k"][:-1] / 8).all() and (motion["s"] == 2 * motion["time"]).all()
        assert motion["t"][-1] == 1 and motion["s"][-1] == float(path.length)
        assert np.abs([float(path.arc_length(t)) for t in motion["t"][:-1]] - motion["s"][:-1]).max() < 1e-14
        rows = np.stack([motion[c] for c in "xyz"], axis=1)
        assert np.abs(rows - path.points(motion["t"])).max() < 1e-14
    slower = QUINTIC.interpolate("1 + t", "1/8")
    assert slower["time"][-1] > QUINTIC.interpolate(2, "1/8")["time"][-1]
    limited = QUINTIC.interpolate("min(2, 1 + s)", "1/8", max_tangential_acceleration=1, start_speed=1, end_speed="1/2")
    assert limited.dtype.names[-1] == "v" and limited["v"][0] == 1 and limited["v"][-1] == 0.5
    with pytest.raises(ValueError, match="start_speed: it needs max_tangential_acceleration"):
        QUINTIC.interpolate(2, 1, start_speed=1)


@by_program
def test_motions_headers_and_bodies_are_those_of_the_program(tmp_path):
    lines = program("interpolate", FILE, "--period", "1/4", "--feed", "1 + s").decode().splitlines()
    motion = phrame.read(FILE).interpolate("1 + s", Fraction(1, 4))
    assert [tuple(map(float, line.split(","))) for line in lines[1:]] == motion.tolist()
    limits = {"max-normal-acceleration": "1", "max-tangential-acceleration": "3/2"}
    lines = program("interpolate", FILE, "--period", "1/4", "--feed", "2", *(x for k, v in limits.items() for x in ("--" + k, v)))
    motion = phrame.read(FILE).interpolate(2, Fraction(1, 4), **{k.replace("-", "_"): v for k, v in limits.items()})
    assert [tuple(map(float, line.split(","))) for line in lines.decode().splitlines()[1:]] == motion.tolist()
    header = program("compile", FILE, "--prefix", "arm", "--theta0", "pi/4", "--to", "2").decode()
    assert phrame.read(FILE).compile("arm", start="pi/4", upper=2) == header
    wave = ROOT / "examples/any/wave.svg"
    assert phrame.read(wave).compile("wave") == program("compile", wave, "--prefix", "wave").decode()
    for name, options in [("a.obj", ["--profile", "rectangle:1,1/2", "--tolerance", "1/100"]),
                          ("a.GLB", ["--profile", "polygon:5,1/3", "--sections", "20", "--twist", "pi/3", "--scale", "1-t/2"]),
                          ("a.ply", ["--profile", "circle:1/3", "--tolerance", "1/10", "--normal-tolerance", "20deg"])]:
        suffix = name[2:].lower()
        expected = program("sweep", FILE, "--format", suffix, *options)
        given = dict(zip((option[2:].replace("-", "_") for option in options[::2]), options[1::2]))
        profile = given.pop("profile")
        if "sections" in given:
            given["sections"] = int(given["sections"])
        phrame.sweep(phrame.read(FILE), profile, **given).save(tmp_path / name)
        assert (tmp_path / name).read_bytes() == expected


def test_bodies():
    """Of a tube the volume is that of the profile times the length [Pappus], if it does not reach too far."""
    square = [[1, 1], [-1, 1], [-1, -1], [1, -1]]
    corners = [["1/50" if x > 0 else "-1/50" for x in corner] for corner in square]
    body = phrame.sweep(CUBIC, corners, tolerance="1/2000", start_normal=[0, 0, 1])
    vertices, triangles = body.vertices, body.triangles
    assert vertices.shape[1] == triangles.shape[1] == 3 and triangles.dtype == np.uint32
    edges = Counter((int(t[i]), int(t[i - 2])) for t in triangles for i in range(3))
    assert set(edges.values()) == {1} and all((b, a) in edges for a, b in edges)
    p, q, r = (vertices[triangles[:, i]] for i in range(3))
    volume = float(np.sum(p * np.cross(q, r))) / 6
    assert abs(volume - body.volume()) < 1e-12 and abs(volume - float(CUBIC.length) / 25**2) < 1e-4
    assert not body.is_closed and body.folds == 0 and body.error <= 1 / 2000 and body.sections > 5 and body.turn == 0
    again = pickle.loads(pickle.dumps(body))
    assert (again.vertices == vertices).all() and (again.triangles == triangles).all() and again.error == body.error
    with pytest.raises(ValueError, match="read-only"):
        vertices[0, 0] = 1
    assert body.normal_error is None
    tube = phrame.sweep(phrame.Curve([2], [0], [0], [1]), "circle:1/2", normal_tolerance="10deg")
    # A prism with n sides: between sides and circle there are angles of up to π/n.
    sides = len(tube.vertices) // tube.sections
    assert np.pi / sides <= tube.normal_error <= np.pi / 18
    assert pickle.loads(pickle.dumps(tube)).normal_error == tube.normal_error
    with pytest.raises(phrame.InputError, match="^normal_tolerance: it is not between 0 and 90deg"):
        phrame.sweep(CUBIC, corners, normal_tolerance="pi/2")
    with pytest.raises(phrame.InputError, match="^sections: it and normal_tolerance exclude each other"):
        phrame.sweep(CUBIC, corners, normal_tolerance=1, sections=3)
    circle = phrame.Curve.expressions("cos(s)", "sin(s)", 0, 0, "2*pi")
    ring = phrame.sweep(circle, "circle:1/4", sections=8)
    assert ring.is_closed and ring.error is None and len(ring.vertices) - 3 * len(ring.triangles) // 2 + len(ring.triangles) == 0
    del body
    assert vertices[0].shape == (3,)


@pytest.mark.parametrize("path", ["QUINTIC", "CUBIC"])
def test_pages(path, tmp_path):
    path = globals()[path]
    ts = [0, 0.5, 1]
    try:
        path.page(tmp_path / "a.html", ts, path.frames(ts)[:, 1])
    except phrame.DomainError as error:
        assert "npm" in str(error) and not (tmp_path / "a.html").exists()
    else:
        text = (tmp_path / "a.html").read_text(encoding="utf-8")
        assert text.lstrip().startswith("<!") and repr(float(path.points([0.5])[0, 1])) in text
