#pragma once
#include <optional>

#include "phrame/io/curve_file.hpp"
#include "phrame/ph/rmf_angle.hpp"

namespace phrame {

/// What `phrame info` shows of a curve beside its polynomials.
struct CurveInfo {
  NamedCurve curve;
  std::vector<Interval> cusps;            ///< in [0, 1]
  Decimal twist_erf;                      ///< ∫₀¹ 2h/σ
  std::optional<Decimal> bending_energy;  ///< ∫₀¹ κ² ds = ∫₀¹ ρ/(|f|σ³) dt
  std::string no_energy;  ///< why there is none: "∞ (cusp)", a pole, or "f changes sign"
};

/// Computes the two integrals to `digits` digits.
CurveInfo curve_info(const NamedCurve& named, long digits);

std::string to_text(const CurveInfo& info);
std::string to_json(const CurveInfo& info);  ///< info/1

}  // namespace phrame
