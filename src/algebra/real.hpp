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

/// A real number: known exactly, or by enclosures as narrow as one asks. Copies share these.
class Real {
 public:
  /// `bits` → a ball around the number, whose radius tends to 0 as bits grow.
  using Enclosure = std::function<RealBall(long bits)>;
  /// What is known beside the enclosures: how far to go to tell the number from a rational one.
  struct Origin {
    bool is_irrational =
        false;      ///< proved: with enough bits it is apart from every rational number
    long bits = 0;  ///< of all that the number was made from, about
    std::shared_ptr<const AngleForm> angle = nullptr;  ///< where it is known to be such an angle
  };

  /// A number known exactly.
  Real(Rational exact) : exact_(std::move(exact)) {}  // NOLINT(google-explicit-constructor)
  /// A number of which nothing but enclosures is known.
  explicit Real(Enclosure enclosure) : Real(std::move(enclosure), Origin()) {}
  /// The same with what is known beside them.
  Real(Enclosure enclosure, Origin origin)
      : enclosure_(std::make_shared<const Enclosure>(std::move(enclosure))),
        origin_(std::move(origin)) {}

  /// The number, where it is known exactly; else it may be rational still.
  const std::optional<Rational>& exact() const { return exact_; }
  /// Of an exact number, its bits.
  Origin origin() const { return exact_ ? Origin{false, bits_of(*exact_), nullptr} : origin_; }
  /// A ball around it: the more bits, the narrower, as the enclosure does it.
  RealBall enclose(long bits) const {
    return exact_ ? RealBall(*exact_, bits) : (*enclosure_)(bits);
  }

 private:
  std::optional<Rational> exact_;
  std::shared_ptr<const Enclosure> enclosure_;
  Origin origin_;
};

/// @{ Exact where the operands are, and 0·x = 0; sums of what has an AngleForm are exact where
/// they are rational, and else known to be irrational. Sums and products of an
/// irrational number and a rational one ≠ 0 are irrational; of two other irrational ones nothing is
/// known.
PHRAME_API Real operator-(const Real& x);
PHRAME_API Real operator+(const Real& x, const Real& y);
PHRAME_API Real operator*(const Real& x, const Real& y);
/// @}
/// The same number, which keeps the narrowest ball that it was asked for, for the next time. Its
/// copies share it.
PHRAME_API Real cached(const Real& x);
/// The same number, which is known to be irrational.
PHRAME_API Real known_irrational(const Real& x);
/// @{ √x for x ≥ 0, exact where it is rational; of an x that is not exact nothing is known.
PHRAME_API Real square_root_of(const Rational& x);
PHRAME_API Real square_root_of(const Real& x);
/// @}

/// The number, where it is exact; else a ball of 64 bits around it, "[3.14159265358979
/// +/- 3.24e-15]". For digits that are certain: round_to_decimal().
PHRAME_API std::ostream& operator<<(std::ostream& out, const Real& x);

}  // namespace phrame
