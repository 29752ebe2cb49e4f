#pragma once
#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

#include "phrame/algebra/grid_polynomial.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/formula.hpp"
#include "phrame/ph/proof/statement.hpp"

namespace phrame::inline v0 {

/// What is stated of N/(D√S) from a to b, as functions of z ∈ [−1, 1], t = (a + b)/2 + z(b − a)/2.
struct IntegralPiece {
  Rational to;          ///< b; a is the end of the piece before, at first 0
  GridPolynomial root;  ///< about 1/√S
  GridPolynomial rate;  ///< about N/(D√S)
  friend bool operator==(const IntegralPiece&, const IntegralPiece&) = default;
};

/// Part of a path from t = k to k + 1: r = X/W, not a single point.
struct IntegralSegment {
  Vector<Polynomial> position;  ///< X
  Polynomial weight;            ///< W, not 0 at t = 0
  Polynomial square;            ///< c ≠ 0 with c²S = |H|²
  std::vector<IntegralPiece> pieces;
  friend bool operator==(const IntegralSegment&, const IntegralSegment&) = default;
};

/// Where formulas are evaluated: from the end of the piece before, at first 0, to b.
struct ModelPiece {
  Rational to;     ///< b
  long order = 2;  ///< of terms of each Taylor model, ≥ 2
  long bits = 0;   ///< of its grid, ≥ 0
  friend bool operator==(const ModelPiece&, const ModelPiece&) = default;
};

/// A curve by formulas, not all of which are rational functions, of s from one constant to another.
struct FormulaSegment {
  Vector<Formula> position;  ///< r(s)
  Formula from;              ///< s at t = 0
  Formula to;                ///< s at t = 1
  std::vector<ModelPiece> pieces;
  friend bool operator==(const FormulaSegment&, const FormulaSegment&) = default;
};

/// A part of a path.
using CertifiedSegment = std::variant<IntegralSegment, FormulaSegment>;

/// Claims about the angle of the rotation-minimizing frame to a frame, or about the length, along a
/// path, and enclosures of what is integrated, which arithmetic with integers proves; of segments
/// by formulas the enclosures are found when they are checked: docs/certificate.md. True or not, as
/// a Certificate.
struct IntegralCertificate {
  std::optional<Reference> frame;          ///< up or frenet; none where it is of lengths
  Vector<Rational> up{};                   ///< v, with the frame of that
  std::vector<CertifiedSegment> segments;  ///< at least one
  std::vector<AngleClaim> angles;          ///< with a frame
  std::vector<LengthClaim> lengths;        ///< without
  friend bool operator==(const IntegralCertificate&, const IntegralCertificate&) = default;
};

/// Is some segment by formulas?
inline bool has_formulas(const IntegralCertificate& c) {
  return std::ranges::any_of(c.segments, [](const CertifiedSegment& segment) {
    return std::holds_alternative<FormulaSegment>(segment);
  });
}

}  // namespace phrame
