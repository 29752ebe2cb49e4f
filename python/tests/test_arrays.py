"""Arrays of frames, quaternions, matrices and points; progress, Ctrl-C, threads."""

import pickle
import random
import threading
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import QUINTIC, random_curve


def test_many_frames_are_those_one_by_one():
    """Those of arrays come from approximations with a proof, single ones from the closed form."""
    rng = random.Random(5)
    plane = phrame.Curve([1, 1], [0], [0], [0, 2])
    for curve in (QUINTIC, plane, phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)])):
        ts = np.array([rng.random() * curve.end for _ in range(200)])
        for start in (0, Fraction(1, 7)):
            many = curve.frames(ts, start=start)
            quaternions = curve.quaternions(ts, start=start)
            for k in range(0, 200, 12):
                assert (curve.frames([ts[k]], start=start)[0] == many[k]).all()
                assert (curve.quaternions([ts[k]], start=start)[0] == quaternions[k]).all()
            x, y, z, w = quaternions.T
            matrix = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                               [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                               [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
            assert np.abs(matrix.transpose(2, 1, 0) - many).max() < 4e-16 * 4
            assert (curve.matrices(ts, start=start)[:, :3, :3].transpose(0, 2, 1) == many).all()
        angle = curve.angle(start=Fraction(1, 7))
        assert (angle(ts) == [float(angle.value(t)) for t in ts]).all()


def test_quaternions_are_continuous():
    path = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)])
    q = path.quaternions(np.linspace(0, 2, 2001))
    assert (np.sum(q[1:] * q[:-1], axis=1) > 0.99).all()
    assert np.abs(np.linalg.norm(q, axis=1) - 1).max() < 1e-15


def test_points_round_correctly():
    ts = [Fraction(k, 7) for k in range(8)]
    expected = [[float(x) for x in QUINTIC.point(t)] for t in ts]
    assert (QUINTIC.points(ts) == expected).all()
    # Doubles go another way than fractions.
    rng = random.Random(8)
    cubic = phrame.Curve.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
    conic = phrame.Curve.bezier([[1, 0, 0], [1, 1, 0], [0, 1, 0]], [1, 1, 2])
    whole = random_curve(rng, 4)
    spline = phrame.Path([whole.segment(0, "1/3"), whole.segment("1/3", 1)])
    smooth = phrame.Curve.cubic_spline([[0, 0, 0], [1, "1/2", 0], [2, 0, 1], [3, 1, 1]])
    for path in (QUINTIC, spline, cubic, smooth, conic):
        ts = [0.0, 1.0, path.end / 2, float(path.end), 2**-60] + [rng.random() * path.end for _ in range(100)]
        expected = [[float(x) for x in path.point(Fraction(t))] for t in ts]
        assert (path.points(np.array(ts)) == expected).all()
        assert (path.matrices(np.array(ts))[:, :3, 3] == expected).all()


def test_arrays_of_all_kinds_are_parameters():
    exact = QUINTIC.frames([0, Fraction(1, 2), 1])
    for ts in ((0, 0.5, 1), np.array([0, 0.5, 1]), np.array([0, 0.5, 1], dtype=np.float32),
               np.array([0, 0, 0.5, 0, 1])[::2], ["0", "1/2", "1"],
               np.array([0, Fraction(1, 2), 1], dtype=object)):
        assert (QUINTIC.frames(ts) == exact).all() and QUINTIC.frames(ts).shape == (3, 3, 3)
    assert (QUINTIC.points(np.array([0, 1])) == QUINTIC.points([0, 1])).all()


def test_other_kinds_of_frames():
    erf = QUINTIC.frames([0.25], kind="erf")[0]
    frenet = QUINTIC.frames([0.25], kind="frenet")[0]
    assert (erf[0] == frenet[0]).all() and abs(np.linalg.det(erf) - 1) < 1e-15
    acceleration = np.array([float(r.derivative()(Fraction(1, 4))) for r in QUINTIC.hodograph])
    assert abs(acceleration @ frenet[2]) < 1e-14 and acceleration @ frenet[1] > 0


INFLECTED = phrame.Curve([1, -1, 1], [0], [2], [0, 1, -1])  # n jumps at t = 1/2


@pytest.mark.parametrize("kind", ["rmf", "erf", "frenet"])
def test_frames_by_any_way_are_the_same(kind):
    """Compiled segments, fractions that no double is, and what an object kept from earlier calls."""
    rng = random.Random(17)
    spline = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1), QUINTIC.segment(1, 2)])
    for path in (QUINTIC, INFLECTED, spline):
        ts = [rng.random() * path.end for _ in range(300)]
        many = path.frames(np.array(ts), kind=kind)
        quaternions = path.quaternions(np.array(ts), kind=kind)
        again = path.frames(ts[:20], kind=kind)
        assert (again == many[:20]).all()
        # One fraction that is no double, and none is compiled.
        fresh = pickle.loads(pickle.dumps(path))
        exact = fresh.frames(ts[:40] + [Fraction(1, 3)], kind=kind)[:40]
        assert (exact == many[:40]).all()
        one_by_one = np.array([fresh.quaternions([Fraction(t)], kind=kind)[0] for t in ts[:20]])
        sign = np.sign(np.sum(one_by_one * quaternions[:20], axis=1))[:, None] if kind == "frenet" else 1
        assert (one_by_one * sign == quaternions[:20]).all()


def test_components_are_zero_only_where_the_frame_has_not_turned():
    """A segment that turns, and then one whose Euler–Rodrigues frame is rotation-minimizing."""
    turning = phrame.Curve([0], [0], [1], [1, 1, 2])
    plane = phrame.Curve([0], [0, 1], [1], [4, 0], start=turning.point(1))
    path = phrame.Path([turning, plane])
    ts = np.array([1.25, 1.5, 1.75])
    matrices = path.frames(ts)
    for f, (x, y, z, w) in zip(matrices, path.quaternions(ts)):
        f2 = [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)]
        assert np.abs(f[1] - f2).max() < 1e-15


def test_threads_share_what_a_path_keeps():
    halves = [QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)]
    ts = np.linspace(0, 2, 300)
    expected = phrame.Path(halves).frames(ts)
    path = phrame.Path(halves)
    found = {}

    def ask(name):
        found[name] = np.array([path.frames([t])[0] for t in ts])

    threads = [threading.Thread(target=ask, args=(k,)) for k in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 3 and all((frames == expected).all() for frames in found.values())


def test_progress_is_reported_and_can_stop():
    seen = []
    QUINTIC.frames(np.linspace(0, 1, 50_000), progress=lambda done, n: seen.append((done, n)))
    assert seen[-1] == (50_000, 50_000)

    def stop(done, n):
        raise KeyError("enough")

    with pytest.raises(KeyError):
        QUINTIC.frames(np.linspace(0, 1, 50_000), progress=stop)


def test_threads_share_one_angle():
    angle = random_curve(random.Random(3), 6).angle()
    ts = [Fraction(k, 13) for k in range(14)]
    expected = [angle.value(t, digits=30) for t in ts]
    fresh = random_curve(random.Random(3), 6).angle()
    found = {}

    def ask(name):
        found[name] = [fresh.value(t, digits=30) for t in ts]

    threads = [threading.Thread(target=ask, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(values == expected for values in found.values()) and len(found) == 4


def test_boxes_and_nearest_points():
    """x = 3t² − 2t³, y = 3t(1 − t): the box by hand, distances by NumPy of many points."""
    path = phrame.Path.bezier([[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]])
    assert path.bounding_box == ((0, 1), (0, Fraction(3, 4)), (0, 0))
    t, distance = path.nearest([2, 1, 1])
    points = path.points(np.linspace(0, 1, 2001))
    least = np.linalg.norm(points - [2, 1, 1], axis=1).min()
    assert least - 1e-6 < float(distance) <= least
    assert abs(np.linalg.norm(path.points([float(t)])[0] - [2, 1, 1]) - float(distance)) < 1e-15
    assert pickle.loads(pickle.dumps(distance)) == distance
    helix = phrame.Path.expressions("3*cos(s)", "3*sin(s)", "4*s", 0, 4)  # |r − (0, 0, 8)|² = 9 + 16(s − 2)²
    t, distance = helix.nearest([0, 0, 8])
    assert float(t) == 0.5 and float(distance) == 3 and pickle.loads(pickle.dumps(distance)) == distance
    with pytest.raises(phrame.Undecided, match="segment 1, by formulas: next to t = "):
        phrame.Path.expressions("cos(s)", "sin(s)", "0", 0, 1).nearest([0, 0, 0])


def test_parameters_of_files_and_of_lengths_are_named_by_by():
    """s of a helix, knots of a NURBS; 3 cos s and 3 sin s by NumPy, lengths by arc_length."""
    helix = phrame.Path.expressions("3*cos(s)", "3*sin(s)", "4*s", 0, "4*pi")
    low, high = helix.domain("native")
    assert low == 0 and float(high) == 4 * np.pi
    s = np.linspace(float(low), float(high), 7)
    np.testing.assert_allclose(helix.points(s, by="native"), np.transpose([3 * np.cos(s), 3 * np.sin(s), 4 * s]), atol=1e-14)
    assert [float(x) for x in helix.point(2, by="native")] == list(helix.points([2], by="native")[0])
    assert helix.angle()([2], by="native")[0] == helix.angle()(2, by="native")
    assert float(helix.arc_length(3, by="native")) == 15  # 5 for each radian
    spline = phrame.Path.nurbs([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2], [5, 5, 5]], knots=[0, 0, 0, 0, "3/10", 1, 1, 1, 1])
    assert spline.domain("native") == (0, 1) and spline.domain() == (0, 2)
    assert (spline.frames(["3/20"], by="native") == spline.frames([0.5])).all()
    assert (spline.frames([0.25], by="unit") == spline.frames([0.5])).all()
    half = spline.points([0.5], by="fraction")
    np.testing.assert_allclose(half, spline.points([float(spline.length) / 2], by="arc-length"), rtol=1e-15)
    for path in (helix, spline, QUINTIC):
        for by in ("t", "native", "arc-length", "fraction"):
            if by == "native" and path is QUINTIC:
                continue
            ends = [float(x) for x in path.domain(by)]
            for n in (3, 10):
                assert path.frames(np.linspace(*ends, n), by=by).shape == (n, 3, 3)
    for moved in (pickle.loads(pickle.dumps(helix)), helix.translated([1, 0, 0]), helix.scaled(2)):
        assert [float(x) for x in moved.domain("native")] == [0, 4 * np.pi]
    assert pickle.loads(pickle.dumps(spline)).domain("native") == (0, 1)
    with pytest.raises(phrame.DomainError, match="by: the file of the path has no parameter of its own but t"):
        QUINTIC.points([0], by="native")
    with pytest.raises(phrame.InputError, match="is not one of t, native, unit, arc-length, fraction"):
        QUINTIC.points([0], by="length")


def test_numbers_at_many_places_are_those_one_by_one():
    cubic = phrame.Curve.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
    helix = phrame.Path.expressions("3*cos(s)", "3*sin(s)", "4*s", 0, "2*pi")
    for path in (QUINTIC, cubic, phrame.Path([cubic, phrame.Path.bezier([[4, 1, 2], [5, 2, 3]])]), helix):
        ts = [0, Fraction(1, 3), 0.5, 1]
        for name in ("curvature", "arc_length", "derivative"):
            one = getattr(path, name)
            assert (one(ts) == [np.array(one(t), dtype=float) for t in ts]).all()
    assert (helix.torsion(np.array([0.25, 0.5])) == [0.16, 0.16]).all()
    assert (QUINTIC.curvature([0, 1, 2], by="arc-length") == [float(QUINTIC.curvature(s, "arc-length")) for s in (0, 1, 2)]).all()
    with pytest.raises(phrame.Error, match=r"t\[1\]"):
        cubic.curvature([0, 2])


def test_derivatives_of_any_order():
    parabola = phrame.Curve.bezier([[0, 0, 0], [1, 0, 0], [2, 3, 0]])  # (2t, 3t², 0)
    assert parabola.derivative("1/3") == (2, 2, 0)
    assert parabola.derivative("1/3", 2) == (0, 6, 0)
    assert (parabola.derivative([0, 1], 3) == 0).all()
    assert (parabola.derivative([0, 1], 0) == [[0, 0, 0], [2, 3, 0]]).all()
    conic = phrame.Curve.bezier([[1, 0, 0], [1, 1, 0], [0, 1, 0]], [1, 1, 2])  # ((1 − t²), 2t)/(1 + t²)
    assert conic.derivative(1, 1) == (-1, 0, 0)
    assert conic.derivative(0, 3) == (0, -12, 0)  # 2t − 2t³ + …
    helix = phrame.Path.expressions("3*cos(s)", "3*sin(s)", "4*s", 0, "2*pi")
    fifth = helix.derivative([0, 0.25], 5)
    assert np.allclose(fifth, [[0, 3 * (2 * np.pi) ** 5, 0], [-3 * (2 * np.pi) ** 5, 0, 0]], rtol=1e-15, atol=1e-9)
    speed = helix.derivative("1/2")
    assert str(phrame.digits(speed[2], 15)) == "25.1327412287183"  # 8π
    assert pickle.loads(pickle.dumps(speed[1])) == speed[1]
    with pytest.raises(phrame.InputError, match="order"):
        helix.derivative(0, -1)


def test_roll_turns_frames_about_the_tangent():
    """By Rodrigues' formula; along the path the roll is a function of t, or linear between joints."""
    cubic = phrame.Curve.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
    two = phrame.Path([cubic, phrame.Path.bezier([[4, 1, 2], [5, 2, 3]])])
    for path, rolls in ((QUINTIC, ("pi/3", "60*t deg", "t^2")), (cubic, ([0, "90deg"],)), (two, ([0, 1, "30deg"],))):
        ts = np.linspace(0, path.end, 9)
        plain = path.frames(ts)
        for roll in rolls:
            angle = {"pi/3": lambda t: np.pi / 3 + 0 * t, "60*t deg": lambda t: np.pi / 3 * t, "t^2": lambda t: t * t}.get(
                str(roll), lambda t: np.interp(t, range(len(roll)), [0, 1, np.pi / 6] if len(roll) > 2 else [0, np.pi / 2]))(ts)[:, None]
            turned = path.frames(ts, roll=roll)
            assert np.abs(turned[:, 1] - np.cos(angle) * plain[:, 1] - np.sin(angle) * plain[:, 2]).max() < 1e-15
            assert (path.matrices(ts, roll=roll)[:, :3, :3].transpose(0, 2, 1) == turned).all()
            assert (path.frames(ts, roll=roll, kind="up")[:, 0] == plain[:, 0]).all()
            q = path.quaternions(ts, roll=roll)
            assert (np.sum(q[1:] * q[:-1], axis=1) > 0).all()
    assert phrame.sweep(cubic, "rectangle:1,1/2", roll=[0, "90deg"], sections=5).vertices[0] @ [1, 1, 1] != 0
    with pytest.raises(phrame.DomainError):
        two.frames([0], roll=[0, 1])
    with pytest.raises(phrame.InputError, match="roll"):
        QUINTIC.frames([0], kind="erf", roll=1)
    with pytest.raises(phrame.InputError, match="roll"):
        QUINTIC.frames([0], roll="x")


def test_frames_of_minimal_twist_by_their_name():
    posed = phrame.Path.through([[0, 0, 0], [2, 1, 0], [3, 3, 1]], orientations=[[0, 0, 0, 1], [1, 0, 1, 2], [0, -1, 2, 2]],
                                tangent_axis="z")
    assert (posed.frames([0, 0.5, 2], kind="mtf") == posed.twist().frames([0, 0.5, 2])).all()
    body = posed.matrices([0, 1], kind="mtf")[:, :3, :3]
    assert np.abs(body[0] - np.eye(3)).max() < 1e-15  # that of the pose, whose z is the tangent
    ring = phrame.Path.expressions("(2 + cos(3*s))*cos(2*s)", "(2 + cos(3*s))*sin(2*s)", "sin(3*s)", 0, "2*pi")
    ends = ring.frames([0, 1], kind="mtf")
    assert np.abs(ends[0] - ends[1]).max() < 1e-15
    with pytest.raises(phrame.InputError, match="minimal_twist"):
        QUINTIC.frames([0], kind="mtf")
