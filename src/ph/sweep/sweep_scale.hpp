#pragma once
#include <vector>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// λ along a path, by which a profile is scaled.
class PHRAME_API SweepScale {
 public:
  SweepScale() : SweepScale(RationalFunction(Polynomial{1})) {}  ///< 1
  /// A rational function of the parameter of the path.
  SweepScale(RationalFunction of_t)  // NOLINT(google-explicit-constructor)
      : pieces_{std::move(of_t)}, is_whole_(true) {}
  /// These values at t = 0, 1, …, and linear in between. Precondition: there are two at least.
  explicit SweepScale(const std::vector<Rational>& at_joints);

  /// λ on segment k as a function of the parameter of the path.
  const RationalFunction& on(std::size_t k) const { return pieces_[is_whole_ ? 0 : k]; }
  Rational at_start() const { return pieces_.front()(0); }                ///< λ(0)
  Rational at(const Rational& end) const { return pieces_.back()(end); }  ///< λ at the end
  bool is_constant() const;                                               ///< is it one number?

  /// Throws DomainError where λ is not > 0 and finite all along that many segments, and for values
  /// at another number of joints.
  void require_along(std::size_t segments) const;
  /// A bound of λ on [0, segments], > 0. Throws likewise.
  double greatest(std::size_t segments) const;

 private:
  std::vector<RationalFunction> pieces_;
  bool is_whole_;  ///< is there one for all segments?
};

}  // namespace phrame
