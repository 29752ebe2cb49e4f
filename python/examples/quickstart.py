"""Frames of a spline through points, the exact angle of a curve, and a check of somebody's frames."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

import phrame


def main() -> None:
    path = phrame.Curve.through([[0, 0, 0], [1, 0.5, 0], [2, 0, 1], [3, 1, 1]])
    ts = np.linspace(0, float(path.end), 1000)
    frames = path.frames(ts, start_normal=[0, 0, 1])
    poses = path.matrices(ts, start_normal=[0, 0, 1])
    print(frames.shape, poses.shape, float(path.length))

    curve = phrame.Curve([2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2])
    angle = curve.angle()
    print(angle)
    print(angle.value(Fraction(1, 3), digits=50))
    print(float(angle.value(1)), angle(np.array([0.0, 0.5, 1.0])))

    samples = curve.frames(ts[:10], kind="erf")
    print(curve.check(ts[:10], samples[:, 1], start=0).summary)


if __name__ == "__main__":
    main()
