"""The reference collection, as the package has it."""

from fractions import Fraction

import numpy as np
import pytest

import phrame


def test_the_collection_is_there_with_exact_paths_and_values():
    curves = phrame.reference()
    assert len(curves) > 400 and len({curve.name for curve in curves}) == len(curves)
    (curve,) = [curve for curve in phrame.reference("tame") if curve.name == "tame-01"]
    assert curve.path.name == "tame-01" and curve.at == [0, Fraction(1, 3), Fraction(1, 2), 1]
    assert curve.frames.shape == (4, 4, 3)
    frames = curve.path.frames(curve.at)
    assert np.array_equal(frames, curve.frames[:, 1:])
    assert str(curve.path.angle().value("1/2", digits=50)) == curve.expected["theta_erf"][2]


def test_rational_ph_curves_have_the_frames_of_the_collection():
    for curve in phrame.reference("rational-ph")[::4]:
        assert np.array_equal(curve.path.frames(curve.at), curve.frames[:, 1:]), curve.name


def test_values_that_are_hard_to_round_are_rounded_as_the_collection_says():
    for curve in phrame.reference("hard-rounding")[::7]:
        assert np.array_equal(curve.path.frames(curve.at), curve.frames[:, 1:]), curve.name
        tie = curve.expected["near_tie"]
        if tie["value"] == "theta_erf":
            assert float(curve.path.angle().value(curve.at[1])) == float(curve.expected["theta_erf"][1])


def test_a_group_that_is_none_is_refused_with_the_names_of_all():
    with pytest.raises(phrame.InputError, match="'wild' is not one of bezier, "):
        phrame.reference("wild")
