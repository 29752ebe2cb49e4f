#pragma once
#include <vector>

#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame::inline v0 {

/// An angle along a path, by which a frame is turned about e₁ beside how it is else.
class PHRAME_API Roll {
 public:
  /// The angle π·half_turns + radians.
  struct Piece {
    RationalFunction half_turns;  ///< a function of the parameter of the path
    RationalFunction radians;     ///< likewise
  };

  Roll() : Roll(Piece{}) {}  ///< 0
  /// One function all along.
  // NOLINTNEXTLINE(google-explicit-constructor)
  Roll(Piece of_t) : pieces_{std::move(of_t)}, is_whole_(true) {}
  /// These values at t = 0, 1, …, and linear in between. Precondition: there are two at least.
  explicit Roll(const std::vector<Angle>& at_joints);

  bool is_zero() const;  ///< is it 0 all along?
  /// On segment k.
  const Piece& on(std::size_t k) const { return pieces_[is_whole_ ? 0 : k]; }
  /// Throws DomainError where it has a pole on that many segments, and for values at another number
  /// of joints.
  void require_along(std::size_t segments) const;
  Angle at(const PathParameter& at) const;  ///< there
  Real at(const Place& at) const;           ///< likewise

 private:
  std::vector<Piece> pieces_;
  bool is_whole_;  ///< is there one for all segments?
};

}  // namespace phrame
