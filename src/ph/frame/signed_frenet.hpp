#pragma once
#include <memory>

#include "phrame/export.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame::inline v0 {

/// The Frenet frame (e₁, n, b) of a path, continued through its inflections: where κ has a zero of
/// odd order Frenet's own n and b jump to their opposites; these go on, and κ becomes negative. At
/// the start it is Frenet's, of small t > 0. Of PH and rational curves H × H′ without its real
/// factor is along ±b, by algebra; of formulas the zeros of r′ × r″ are at simple places, where
/// their order is known by exact derivatives. Copies share what was found.
class PHRAME_API SignedFrenet {
 public:
  /// Throws DomainError for a path with a straight segment, and where the frame jumps at a joint;
  /// Undecided where a zero of the curvature of formulas, or its order, is not told.
  explicit SignedFrenet(const Path& path);

  /// (e₁, n, b), defined all along.
  Frame<Real> frame(const Place& at) const;
  /// κ with its sign: de₁/ds = κn.
  Real curvature(const Place& at) const;
  /// Of a closed path with a continuous tangent: how often n turns about e₁, to the right, against
  /// the vector v × e₁, from the start to the end: the helicity about v. It is a whole number, or
  /// a half more where n comes back as −n. Throws DomainError where the path is not closed, or v is
  /// along e₁ somewhere; Undecided where that is not told.
  Rational turns_about(const Vector<Rational>& v) const;

 private:
  struct State;

  std::shared_ptr<const State> state_;
};

}  // namespace phrame
