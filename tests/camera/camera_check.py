"""The camera paths of `phrame frames`, read by code of their own: glTF by its specification's bytes, Blender's script run
with a stand-in for bpy that records what it is told.

What is compared are the vectors of `phrame frames`: turned by the camera's quaternion, -z, y and x must be e1, f2 and
f3. The floats of glTF must be those nearest to the doubles of the script.
"""
import base64
import csv
import io
import json
import math
import struct
import sys
import tempfile
import types
from fractions import Fraction
from pathlib import Path

from program import output

ROOT = Path(__file__).resolve().parent.parent.parent


def as_float(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


def read_glb(data):
    """The JSON and the buffer."""
    magic, version, size = struct.unpack_from("<4sII", data)
    assert (magic, version, size) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON" and size % 4 == 0
    size2, kind = struct.unpack_from("<I4s", data, 20 + size)
    assert kind == b"BIN\0" and size2 % 4 == 0 and 28 + size + size2 == len(data)
    return json.loads(data[20:20 + size]), data[28 + size:]


def read_gltf(data):
    document = json.loads(data)
    kind, _, numbers = document["buffers"][0]["uri"].partition(",")
    assert kind == "data:application/octet-stream;base64"
    return document, base64.b64decode(numbers, validate=True)


def accessor(document, buffer, index):
    part = document["accessors"][index]
    view = document["bufferViews"][part["bufferView"]]
    width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[part["type"]]
    assert part["componentType"] == 5126 and view["byteLength"] == 4 * width * part["count"]
    start = view.get("byteOffset", 0)
    assert start + view["byteLength"] <= document["buffers"][0]["byteLength"] <= len(buffer)
    numbers = struct.unpack_from("<%df" % (width * part["count"]), buffer, start)
    return [numbers[k:k + width] for k in range(0, len(numbers), width)]


def keys_of_gltf(document, buffer):
    """Where the node around the camera is, and (time, place, rotation) of the only camera."""
    assert document["asset"]["version"] == "2.0"
    node = document["scenes"][document["scene"]]["nodes"][0]
    origin = 0, 0, 0
    if "children" in document["nodes"][node]:
        origin = document["nodes"][node]["translation"]
        assert set(document["nodes"][node]) == {"name", "translation", "children"}
        node, = document["nodes"][node]["children"]
    camera = document["cameras"][document["nodes"][node]["camera"]]
    assert camera["type"] == "perspective" and 0 < camera["perspective"]["yfov"] < math.pi
    assert camera["perspective"]["znear"] > 0
    animation, = document["animations"]
    found = {}
    for channel in animation["channels"]:
        assert channel["target"]["node"] == node
        sampler = animation["samplers"][channel["sampler"]]
        assert sampler["interpolation"] == "LINEAR"
        times = accessor(document, buffer, sampler["input"])
        bounds = document["accessors"][sampler["input"]]
        assert [as_float(x) for x in bounds["min"] + bounds["max"]] == [times[0][0], times[-1][0]]
        found[channel["target"]["path"]] = times, accessor(document, buffer, sampler["output"])
    times = [t for t, in found["translation"][0]]
    assert found["rotation"][0] == found["translation"][0] and set(found) == {"translation", "rotation"}
    assert times[0] == 0 and all(a < b for a, b in zip(times, times[1:]))
    return origin, list(zip(times, found["translation"][1], found["rotation"][1]))


class Blender:
    """So much of bpy as the script needs, in the order of Blender's: quaternions are (w, x, y, z)."""

    def __init__(self, is_old):
        self.keys, self.linked, points = {}, [], []
        curve = types.SimpleNamespace(keyframe_points=points)
        outer = self

        class Camera:
            rotation_mode = "XYZ"

            def keyframe_insert(self, path, frame):
                assert self.rotation_mode == "QUATERNION" and self in outer.linked
                outer.keys.setdefault(frame, {})[path] = tuple(getattr(self, path))
                points.append(types.SimpleNamespace(interpolation="BEZIER"))

        def action():
            if is_old:
                return types.SimpleNamespace(fcurves=[curve])
            bag = types.SimpleNamespace(fcurves=[curve])
            strip = types.SimpleNamespace(channelbags=[bag])
            return types.SimpleNamespace(layers=[types.SimpleNamespace(strips=[strip])])

        Camera.animation_data = types.SimpleNamespace(action=action())
        self.points = points
        self.scene = types.SimpleNamespace(
            render=types.SimpleNamespace(fps=24, fps_base=1.0), camera=None,
            collection=types.SimpleNamespace(objects=types.SimpleNamespace(link=self.linked.append)))
        module = types.ModuleType("bpy")
        module.context = types.SimpleNamespace(scene=self.scene)
        module.data = types.SimpleNamespace(
            objects=types.SimpleNamespace(new=lambda name, data: Camera() if data == "lens" else None),
            cameras=types.SimpleNamespace(new=lambda name: "lens"))
        self.module = module


def keys_of_blender(script, fps, is_old):
    blender = Blender(is_old)
    sys.modules["bpy"] = blender.module
    exec(compile(script, "camera.py", "exec"), {"__name__": "__main__"})
    scene = blender.scene
    assert scene.camera in blender.linked and all(p.interpolation == "LINEAR" for p in blender.points)
    assert len(blender.points) == 2 * len(blender.keys)
    assert abs(scene.render.fps / scene.render.fps_base - fps) < 1e-12 * fps and scene.render.fps >= 1
    last = max(blender.keys)
    assert scene.frame_start == 1 and last <= scene.frame_end < last + 1
    found = []
    for frame, key in sorted(blender.keys.items()):
        w, x, y, z = key["rotation_quaternion"]
        found.append(((frame - 1) / fps, key["location"], (x, y, z, w)))
    return found


def turned(q, v):
    """q v q*."""
    x, y, z, w = q
    def cross(a, b):
        return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    once = cross((x, y, z), v)
    twice = cross((x, y, z), once)
    return [a + 2 * (w * b + c) for a, b, c in zip(v, once, twice)]


def check(curve, names, *options, duration=None, fps=24, is_far=False):
    """The frames of the columns `names` at the rows that the options ask for."""
    curve = ROOT / "examples" / curve
    table = list(csv.DictReader(io.StringIO(output("frames", curve, *options).decode())))
    rows = [{name: float(x) for name, x in row.items()} for row in table]
    by = "s" if "arc-length" in options else "t"
    if by == "s":
        lengths = csv.DictReader(io.StringIO(output("frames", curve, *options, "--columns", "s").decode()))
        for row, other in zip(rows, lengths):
            row["s"] = float(other["s"])
    seconds = ["--duration", duration] if duration else []
    first, last = rows[0][by], rows[-1][by]
    unit = duration / (last - first) if duration else 1

    script = output("frames", curve, *options, *seconds, "--fps", fps, "--format", "blender").decode()
    keys = keys_of_blender(script, fps, False)
    assert keys == keys_of_blender(script, fps, True) and len(keys) == len(rows)
    for (time, place, q), row in zip(keys, rows):
        assert abs(time - (row[by] - first) * unit) < 1e-13 * (duration or last - first), (time, row)
        assert place == (row["x"], row["y"], row["z"])
        assert abs(sum(x * x for x in q) - 1) < 1e-15
        second, third = names
        for axis, sign, name in ((2, -1, "e1"), (1, 1, second), (0, 1, third)):
            vector = turned(q, [float(k == axis) for k in range(3)])
            for x, letter in zip(vector, "xyz"):
                assert abs(sign * x - row[name + letter]) < 2e-15, (curve, name, row)
    assert keys[0][2][3] > 0
    assert all(sum(x * y for x, y in zip(a[2], b[2])) > 0 for a, b in zip(keys, keys[1:]))

    extent = max(max(c) - min(c) for c in zip(*(place for _, place, _ in keys)))

    def same(origin, found):
        assert len(found) == len(keys)
        assert is_far == any(origin), origin
        for (_, place, q), (_, exact_place, exact_q) in zip(found, keys):
            exact_local = [Fraction(x) - Fraction(o) for x, o in zip(exact_place, origin)]
            assert place == tuple(as_float(float(x)) for x in exact_local) and q == tuple(map(as_float, exact_q))
            # So near that a float is off by little of the whole.
            assert all(abs(Fraction(x) - y) <= 2e-7 * extent for x, y in zip(place, exact_local))
        for (time, _, _), (exact, _, _) in zip(found, keys):
            assert abs(time - exact) <= 1e-7 * keys[-1][0]
    with tempfile.TemporaryDirectory() as folder:
        for ending, read in (("glb", read_glb), ("GLTF", read_gltf)):
            path = Path(folder) / ("camera." + ending)
            output("frames", curve, *options, *seconds, "-o", path)
            same(*keys_of_gltf(*read(path.read_bytes())))
    return len(keys)


QUINTIC = "curves/farouki-2003-quintic.json"
RMF = "f2", "f3"
count = check(QUINTIC, RMF, "--samples", 33)
count += check(QUINTIC, RMF, "--samples", 12, "--by", "arc-length", duration=10, fps=30)
count += check(QUINTIC, RMF, "--at", "1/7,1/3,2", "--start-normal", "0,0,1", duration=3, fps=23.976)
count += check(QUINTIC, ("n", "b"), "--samples", 5, "--frame", "frenet")
count += check("curves/closed-spline.json", RMF, "--samples", 41)
count += check("curves/closed-spline.json", ("exact_mtf2", "exact_mtf3"), "--samples", 10, "--frame", "mtf-exact",
               "--from", "0", "--closed", duration=1.5, fps=0.5)
count += check("any/wave.svg", RMF, "--samples", 6, "--by", "arc-length", duration=4)
with tempfile.TemporaryDirectory() as folder:
    moved = json.loads((ROOT / "examples" / QUINTIC).read_text())
    for offset in (10 ** 3, 10 ** 6, 10 ** 9):
        moved["start"] = [offset, 0, -offset]
        file = Path(folder) / "far.json"
        file.write_text(json.dumps(moved))
        count += check(file, RMF, "--samples", 7, is_far=True)
print("%d keys" % count)
