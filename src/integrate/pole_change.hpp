#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/shared.hpp"

namespace phrame::inline v0 {

/// A polynomial ≠ 0 whose zeros are isolated once for all that have them as poles: copies share
/// them.
class PoleBase {
 public:
  PoleBase(Polynomial p) : p_(std::move(p)) {}  // NOLINT(google-explicit-constructor)

  const Polynomial& polynomial() const { return p_; }
  /// To about so many bits, none of a constant; null where they are not simple or not told apart.
  std::shared_ptr<const Roots> roots(long bits) const;

 private:
  Polynomial p_;
  Refined<Roots> roots_;
};
/// A factor of a denominator.
struct PolePower {
  PoleBase base;
  long exponent;  ///< ≥ 1
};
/// A rational function by the factors of its denominator, perhaps not in lowest terms.
struct FactoredFunction {
  Polynomial numerator;
  std::vector<PolePower> denominator;
};

/// An integral from 0 to 1.
struct PoleChange {
  RealBall rational;   ///< what of it is no logarithm: a rational number
  RealBall logarithm;  ///< the rest, 0 or transcendental [Baker 1975]

  RealBall whole(long bits) const { return add(rational, logarithm, bits); }
};
/// That of f, to about so many bits, by its expansions at the poles: what integrate() gives without
/// a closed form, in a small part of the time. No value where a base has a multiple zero, or one in
/// common with another one or next to it, and where a real zero of one is not seen to be outside
/// [0, 1].
std::optional<PoleChange> pole_change(const FactoredFunction& f, long bits);

}  // namespace phrame
