"""Positions with orientations: the tangents and the frame of Path.through(points, orientations=…)."""

import itertools
import pickle
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import MULTIPLIER

POINTS = [[0, 0, 0], [2, 1, 0], [3, 3, 1], [2, 5, 3], [0, 5, 4]]
# Scalar last, not of length 1.
QUATERNIONS = [[0.1, -0.2, 0.3, 1], [0, 0.25, 0.5, 0.75], [0.5, -0.5, 0.5, 0.5], [0, 0.3, 0.9, 0.2], [0.1, 0, 1, 0.1]]
AXES = ["".join(name) for name in itertools.product(("", "-"), "xyz")]


def matrix(q):
    """The textbook's matrix of a quaternion, in fractions."""
    x, y, z, w = (Fraction(number) for number in q)
    n = x * x + y * y + z * z + w * w
    return [[(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
            [2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n],
            [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n]]


def wanted(q, axis):
    """e1, f2, f3 of a body whose tangent axis this is, correctly rounded."""
    columns = [list(column) for column in zip(*matrix(q))]
    k = "xyz".index(axis[-1])
    e1, f2, f3 = columns[k], columns[(k + 1) % 3], columns[(k + 2) % 3]
    if axis.startswith("-"):
        e1, f2, f3 = [-x for x in e1], f3, f2
    return np.array([[float(x) for x in v] for v in (e1, f2, f3)])


@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize("smooth", [False, True])
def test_orientations_are_met_to_the_last_double(axis, smooth):
    path = phrame.Path.through(POINTS, orientations=QUATERNIONS, tangent_axis=axis, smooth_twist=smooth)
    twist = path.twist()
    assert twist.is_smooth == smooth and twist.joints == (0, 1, 2, 3, 4)
    frames = twist.frames(range(5))
    for q, frame in zip(QUATERNIONS, frames):
        assert (frame == wanted(q, axis)).all()
    assert np.abs(path.points(range(5)) - POINTS).max() < 1e-14
    assert all(abs(float(turn)) <= np.pi for turn in twist.turns)


def test_matrices_and_rotations_are_orientations():
    path = phrame.Path.through(POINTS, orientations=[matrix(q) for q in QUATERNIONS])
    assert (path.twist().frames([2])[0] == wanted(QUATERNIONS[2], "x")).all()

    class Rotation:
        def as_quat(self):
            return np.array(QUATERNIONS)

    assert phrame.Path.through(POINTS, orientations=Rotation()) == phrame.Path.through(POINTS, orientations=QUATERNIONS)
    rounded = [[[float(x) for x in row] for row in matrix(q)] for q in QUATERNIONS]
    near = phrame.Path.through(POINTS, orientations=np.array(rounded)).twist().frames(range(5))
    assert max(np.abs(f - wanted(q, "x")).max() for f, q in zip(near, QUATERNIONS)) < 4e-16


def test_the_twist_is_that_of_turning_evenly():
    path = phrame.Path.through(POINTS, orientations=QUATERNIONS, turns=[0, 1, 0, -1])
    twist = path.twist()
    lengths = [float(part.length) for part in path.segments]
    turns = [float(turn) for turn in twist.turns]
    assert float(twist.squared_rate) == pytest.approx(sum(T * T / S for T, S in zip(turns, lengths)), rel=1e-14)
    plain = phrame.Path.through(POINTS, orientations=QUATERNIONS).twist()
    assert [round((a - float(b)) / (2 * np.pi), 9) for a, b in zip(turns, plain.turns)] == [0, 1, 0, -1]
    # Between two joints by MinimalTwist, with vectors at both ends.
    segment = path.segments[2]
    other = segment.minimal_twist(*[[float(x) for x in f2] for f2 in twist.frames([2, 3])[:, 1]])
    assert float(other.twist) == pytest.approx(float(plain.turns[2]), abs=1e-14)
    assert np.abs(other.frames([0.25, 0.5]) - twist.frames([2.25, 2.5])).max() < 1e-14
    assert float(twist.rate(2.5)) == pytest.approx(turns[2] / lengths[2], rel=1e-14)


def test_a_tool_path_of_many_poses():
    count = 200 if MULTIPLIER == 1 else 1000
    u = np.linspace(0, 1, count)
    points = np.column_stack([200 * u, 60 * np.sin(6 * np.pi * u), 20 * np.cos(4 * np.pi * u)])
    tangents = np.gradient(points, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]
    # From x to the tangent by the least rotation, then about it.
    half = (1 + tangents[:, 0])[:, None]
    least = np.column_stack([np.zeros(count), -tangents[:, 2], tangents[:, 1], half[:, 0]])
    angle = 0.6 * np.sin(9 * u) / 2
    c, s = np.cos(angle), np.sin(angle)
    x, y, z, w = least.T
    quaternions = np.column_stack([w * s + x * c, y * c + z * s, z * c - y * s, w * c - x * s])
    path = phrame.Path.through(points, orientations=quaternions)
    twist = path.twist()
    frames = twist.frames(range(count))
    assert all((frame == wanted(q, "x")).all() for q, frame in zip(quaternions, frames))
    turns = np.array([float(turn) for turn in twist.turns])
    lengths = np.array([float(part.length) for part in path.segments])
    assert np.abs(turns).max() < np.pi  # the fewest turns, and evenly: by Cauchy and Schwarz nothing turns less
    assert float(twist.squared_rate) == pytest.approx((turns**2 / lengths).sum(), rel=1e-13)
    assert np.abs(path.points(range(count)) - points).max() < 1e-12


def test_orientations_are_kept():
    path = phrame.Path.through(POINTS, orientations=QUATERNIONS, tangent_axis="-y", smooth_twist=True)
    again = pickle.loads(pickle.dumps(path))
    assert again == path and (again.twist().frames([0.5]) == path.twist().frames([0.5])).all()
    read = phrame.parse(path.json())
    assert read == path and read.twist().squared_slope == path.twist().squared_slope
    assert phrame.Path.through(POINTS, orientations=QUATERNIONS, tangent_axis="-y") != path
    body = phrame.sweep(path, "rectangle:1/4,1/20", sections=9)
    first = np.asarray(body.vertices)[:4].mean(axis=0)
    assert np.abs(first).max() < 1e-12
    corner = np.asarray(body.vertices)[0] - first
    frame = wanted(QUATERNIONS[0], "-y")
    assert abs(corner @ frame[0]) < 1e-12 and abs(abs(corner @ frame[1]) - 0.125) < 1e-12


@pytest.mark.parametrize("place, arguments", [
    ("orientations", {"orientations": QUATERNIONS[:3]}),
    ("orientations[1]", {"orientations": [QUATERNIONS[0], [0, 0, 0, 0], *QUATERNIONS[2:]]}),
    ("orientations[0]", {"orientations": [[[1, 0, 0], [0, 1, 0], [0, 0, -1]], *QUATERNIONS[1:]]}),
    ("orientations[0]", {"orientations": [[1, 2], *QUATERNIONS[1:]]}),
    ("tangent_axis", {"orientations": QUATERNIONS, "tangent_axis": "w"}),
    ("turns", {"orientations": QUATERNIONS, "turns": [1]}),
    ("turns[0]", {"orientations": QUATERNIONS, "turns": [0.5, 0, 0, 0]}),
    ("turns", {"turns": [1, 0, 0, 0]}),
    ("smooth_twist", {"smooth_twist": True}),
    ("kind", {"orientations": QUATERNIONS, "kind": "c2"}),
    ("orientations", {"orientations": QUATERNIONS, "tangents": POINTS[1:] + [[1, 1, 1]]}),
])
def test_what_are_no_poses(place, arguments):
    with pytest.raises(phrame.InputError) as caught:
        phrame.Path.through(POINTS, **arguments)
    assert caught.value.place == place
    with pytest.raises(phrame.DomainError):
        phrame.Path.through(POINTS).twist()
