#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// z above the real axis and n(z)/d′(z).
struct NearPole {
  ComplexBall place;
  ComplexBall residue;
};

/// The poles of n/d above the real axis and their residues, with an accuracy of 80 to 100 bits
/// where they are not near to each other, by pairs of doubles. Then d is proved to be squarefree,
/// without a real root; where n and d have a root in common, the ball of its residue contains 0. No
/// value where doubles do not prove that. Cost: a fifth of that of roots to 80 bits by balls.
std::optional<std::vector<NearPole>> near_poles(const Polynomial& n, const Polynomial& d);

/// Are all residues, those at the conjugates of the poles too, seen to be distinct, in doubles?
bool have_distinct_residues(const std::vector<NearPole>& poles);

}  // namespace phrame
