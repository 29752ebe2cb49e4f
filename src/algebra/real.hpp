#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "phrame/algebra/ball.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

struct AngleForm;

/// The bits of numerator and denominator.
PHRAME_API long bits_of(const Rational& x);

/// A real number, either known exactly or given by enclosures, which are as narrow as one asks for
/// and are shared by copies.
class Real {
 public:
  /// Gives a ball around the number, whose radius tends to 0 as `bits` grows.
  using Enclosure = std::function<RealBall(long bits)>;
  /// What is known beside the enclosures. It says how many bits may be needed to tell the number
  /// from a rational one.
  struct Origin {
    bool is_irrational = false;  ///< has that been proved?
    long bits = 0;               ///< about how many bits the number was made from has
    std::shared_ptr<const AngleForm> angle = nullptr;  ///< its form, where it is such an angle
  };

  /// A number known exactly.
  Real(Rational exact) : exact_(std::move(exact)) {}  // NOLINT(google-explicit-constructor)
  /// A number of which nothing but enclosures is known.
  explicit Real(Enclosure enclosure) : Real(std::move(enclosure), Origin()) {}
  /// A number of which more is known.
  Real(Enclosure enclosure, Origin origin)
      : known_(std::make_shared<const Known>(Known{std::move(enclosure), std::move(origin)})) {}
  /// A number of which a ball is known before anything is asked for, which may be too wide.
  Real(Enclosure enclosure, Origin origin, RealBall quick)
      : known_(std::make_shared<const Known>(
            Known{std::move(enclosure), std::move(origin), std::move(quick)})) {}

  /// The number, where it is known exactly; without a value it may still be rational.
  const std::optional<Rational>& exact() const { return exact_; }
  /// What is known beside the enclosures; of an exact number, its bits.
  Origin origin() const {
    return exact_ ? Origin{false, bits_of(*exact_), nullptr} : known_->origin;
  }
  /// The ball that is known already: what it decides need not be asked of enclosures. Null without
  /// one.
  const RealBall* quick() const { return known_ && known_->quick ? &*known_->quick : nullptr; }
  /// A ball around the number, narrower with more bits.
  RealBall enclose(long bits) const {
    return exact_ ? RealBall(*exact_, bits) : known_->enclosure(bits);
  }

 private:
  struct Known {
    Enclosure enclosure;
    Origin origin;
    std::optional<RealBall> quick = {};
  };

  std::optional<Rational> exact_;
  std::shared_ptr<const Known> known_;  ///< of a number that is not known exactly
};

/// @{ Exact where both operands are, and 0·x = 0. Sums of numbers that have an AngleForm are exact
/// where they are rational, and otherwise known to be irrational. The sum or product of an
/// irrational number and a rational one ≠ 0 is known to be irrational; of other sums and products
/// that is unknown.
PHRAME_API Real operator-(const Real& x);
PHRAME_API Real operator+(const Real& x, const Real& y);
PHRAME_API Real operator*(const Real& x, const Real& y);
/// @}
/// The same number, which keeps the narrowest ball that it has found, for itself and its copies.
PHRAME_API Real cached(const Real& x);
/// The same number, marked as irrational, which the caller has proved.
PHRAME_API Real known_irrational(const Real& x);
/// @{ √x for x ≥ 0: exact where x is exact and √x rational.
PHRAME_API Real square_root_of(const Rational& x);
PHRAME_API Real square_root_of(const Real& x);
/// @}

/// Writes an exact number as it is, others as a ball of 64 bits, "[3.14159265358979 +/- 3.24e-15]".
/// Use round_to_decimal() for certain digits.
PHRAME_API std::ostream& operator<<(std::ostream& out, const Real& x);

}  // namespace phrame
