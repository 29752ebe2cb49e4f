#pragma once
#include <string>
#include <vector>

#include "phrame/ph/proof/classify.hpp"
#include "phrame/ph/proof/statement.hpp"

namespace phrame {

/// A point of [0, 1] as a certificate states it: the only root of the polynomial in the interval,
/// which is a point for a rational number and else open.
struct StatedPoint {
  Polynomial polynomial;
  Interval interval;
  long order;
  friend bool operator==(const StatedPoint&, const StatedPoint&) = default;
};

/// The answers of `classify` as a certificate states them. Where the answer is a witness, none
/// means no.
struct StatedDecisions {
  bool regular;
  std::vector<StatedPoint> cusps;
  bool has_inflections;
  std::vector<StatedPoint> inflections;
  std::optional<Vector<Rational>> line;
  std::optional<Vector<Rational>> normal;
  struct Helix {
    Vector<Rational> axis;
    Rational cosine_squared;
    friend bool operator==(const Helix&, const Helix&) = default;
  };
  std::optional<Helix> helix;
  std::optional<DoublePh> double_ph;
  bool primitive;
  Polynomial content;
  bool erf_is_rmf;
  std::optional<GaussianPolynomial> rational_frame;  ///< w, θ = 2·arg w + constant
  bool erf_monotone;
  std::vector<StatedPoint> zeros_of_h;
  std::vector<StatedPoint> extrema;
  friend bool operator==(const StatedDecisions&, const StatedDecisions&) = default;
};

StatedDecisions stated(const Classification& c);

/// No objection where it holds.
inline std::string unless(bool holds, const char* objection) { return holds ? "" : objection; }

/// Decides each by classifying the curve; a witness is checked by its identity, and may be another
/// one than `classify` finds.
std::vector<Statement> check_decisions(const StatedDecisions& d, const Curve& curve);

}  // namespace phrame
