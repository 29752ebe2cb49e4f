#pragma once
#include "phrame/ph/twist/rational_twist.hpp"
#include "phrame/ph/twist/twist_search.hpp"

namespace phrame::inline v0 {

/// From a guess, and one for the other sign of γ if that is to be looked at. The radius is about
/// 2^−goal, where w(1/2) moves by its own length per unit, or less. Throws Undecided where this is
/// not proved, as where both signs of γ do equally well.
///
/// How: on a part of the line, G ≥ Σ (ΔY)²/ΔS over any division of [0, 1] (Cauchy and Schwarz),
/// where Y is the angle between the frame and the exact one: so whatever is far from the guess has
/// a greater G, up to the ends of the line. Around the guess G″ > 0, in interval arithmetic. There
/// a parameter is |G′|/min G″ from the minimum at most.
TwistMinimum twist_minimum(const TwistPiece& piece, long degree, EndRates rates,
                           const LineGuess& guess, const std::optional<LineGuess>& other_guess,
                           long goal);

}  // namespace phrame
