"""Frames by the methods of graphics libraries, for `phrame check`:

    phrame frames CURVE --samples 101 | python3 sweep_frames.py METHOD | phrame check CURVE -

reflection  double reflection (Wang, Juettler, Zheng, Liu, ACM TOG 27, 2008)
rotation    each frame turned by the least rotation from tangent to tangent (Bloomenthal 1990), as three.js does
projection  the last f2, projected to the next normal plane
closed      rotation, and what the ends of a closed curve differ by spread over the samples, as three.js does
camera      z x T, what a camera that looks along the curve has
"""
import sys

import numpy as np


def unit(v):
    return v / np.linalg.norm(v)


def across(f, tangent):
    return unit(f - (f @ tangent) * tangent)


def turned(f, axis, angle):
    """f, turned about the unit vector by Rodrigues' formula."""
    return np.cos(angle) * f + np.sin(angle) * np.cross(axis, f) + (1 - np.cos(angle)) * (axis @ f) * axis


def mirrored(f, v):
    return f - 2 * (v @ f) / (v @ v) * v


def reflection(f, r, tangent, next_r, next_tangent):
    v1 = next_r - r
    v2 = next_tangent - mirrored(tangent, v1)
    return mirrored(mirrored(f, v1), v2)


def rotation(f, r, tangent, next_r, next_tangent):
    axis = np.cross(tangent, next_tangent)
    sine = np.linalg.norm(axis)
    return turned(f, axis / sine, np.arctan2(sine, tangent @ next_tangent)) if sine > 0 else f


def projection(f, r, tangent, next_r, next_tangent):
    return across(f, next_tangent)


def frames(method, r, tangents, f):
    if method == "camera":
        return [unit(np.cross([0, 0, 1], tangent)) for tangent in tangents]
    step = {"reflection": reflection, "projection": projection}.get(method, rotation)
    found = [f]
    for k in range(1, len(r)):
        found.append(step(found[-1], r[k - 1], tangents[k - 1], r[k], tangents[k]))
    if method != "closed":
        return found
    first, last = found[0], found[-1]
    turn = np.arctan2(tangents[0] @ np.cross(last, first), last @ first) / (len(r) - 1)
    return [turned(f, tangent, k * turn) for k, (f, tangent) in enumerate(zip(found, tangents))]


def main():
    names = sys.stdin.readline().strip().split(",")
    rows = np.loadtxt(sys.stdin, delimiter=",")
    def columns(*of):
        return rows[:, [names.index(name) for name in of]]
    r = columns("x", "y", "z")
    tangents = columns("e1x", "e1y", "e1z")
    found = frames(sys.argv[1], r, tangents, columns("f2x", "f2y", "f2z")[0])
    print("t,f2x,f2y,f2z")
    for t, f in zip(columns("t")[:, 0], found):
        print(*[repr(float(x)) for x in (t, *f)], sep=",")


main()
