#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/along/antisymmetry.hpp"

namespace phrame::inline v0 {

/// |θ(t) − theta| ≤ radius.
struct AngleClaim {
  Rational t;                     ///< the parameter
  std::string theta;              ///< a decimal
  std::string radius;             ///< a decimal
  std::optional<TurnCount> turn;  ///< of the argument of the bend, with the Frenet frame
  /// Of an IntegralCertificate: why the integral up to t ≤ 1 is 0.
  std::optional<Antisymmetry> symmetry = {};
  friend bool operator==(const AngleClaim&, const AngleClaim&) = default;
};

/// |length from 0 to t − length| ≤ radius.
struct LengthClaim {
  Rational t;          ///< the parameter
  std::string length;  ///< a decimal
  std::string radius;  ///< a decimal
  friend bool operator==(const LengthClaim&, const LengthClaim&) = default;
};

/// One thing that a certificate states.
struct Statement {
  /// An angle, a length, or what the certificate calls the part that states it: "rate", "decision
  /// helical".
  std::variant<std::string, AngleClaim, LengthClaim> what;
  std::string objection;                    ///< why it is not proved; empty for a proved one
  std::optional<std::size_t> segment = {};  ///< of a path, where it is of one
  bool is_proved() const { return objection.empty(); }  ///< has it no objection?
};
/// Is each of them?
inline bool are_proved(const std::vector<Statement>& statements) {
  return std::ranges::all_of(statements, [](const Statement& x) { return x.is_proved(); });
}

}  // namespace phrame
