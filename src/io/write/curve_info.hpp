#pragma once
#include <optional>

#include "phrame/answer/totals.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// What `phrame info` shows of a curve beside its polynomials.
struct CurveInfo {
  NamedCurve curve;
  std::vector<Interval> cusps;            ///< in [0, 1]
  std::vector<Decimal> erf_inflections;   ///< in (0, 1), where the ERF turns back
  std::vector<Decimal> erf_extrema;       ///< in (0, 1), of its rate about e₁
  Real length;                            ///< ∫₀¹ |f|σ dt
  Decimal rounded_length;                 ///< where it is irrational
  Decimal twist_erf;                      ///< ∫₀¹ 2h/σ dt
  std::optional<Decimal> bending_energy;  ///< ∫₀¹ κ² ds; no value where it is infinite
};

/// Rounds the totals to `digits` digits.
CurveInfo curve_info(const NamedCurve& named, long digits);

std::string to_text(const CurveInfo& info);
std::string to_json(const CurveInfo& info);  ///< info/1

}  // namespace phrame
