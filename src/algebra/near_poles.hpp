#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/near_complex.hpp"
#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// z above the real axis, 1/z and n(z)/d′(z).
struct NearPole {
  NearComplex place;
  NearComplex inverse;
  NearComplex residue;
};

/// The poles of n/d above the real axis and their residues, with an accuracy of 80 to 100 bits
/// where they are not near to each other, by pairs of doubles. Then d is proved to be squarefree,
/// without a real root; where n and d have a root in common, its residue may be 0. No
/// value where doubles do not prove that. Cost: a fifth of that of roots to 80 bits by balls.
std::optional<std::vector<NearPole>> near_poles(const Polynomial& n, const Polynomial& d);

/// Are all residues, those at the conjugates of the poles too, seen to be distinct, in doubles?
bool have_distinct_residues(const std::vector<NearPole>& poles);

/// Σ c·log(1 − t/z) over the poles and their conjugates, which is the integral of n/d from 0 to t
/// where n is of lower degree. Its error is infinite where doubles do not tell, and not small
/// beside the sum where t is near 0. In rounding to nearest.
NearNumber change(const std::vector<NearPole>& poles, const NearNumber& t);

}  // namespace phrame
