#include "phrame/io/write/curve_info.hpp"

#include <fmt/format.h>

#include "phrame/io/write/angle_report.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/frame/erf_turning.hpp"

namespace phrame {
namespace {

std::vector<Decimal> rounded(const std::vector<RealRoot>& points, long digits) {
  std::vector<Decimal> decimals;
  for (const RealRoot& point : odd_inside(points))
    decimals.push_back(round_to_decimal(to_real(point.at), digits));
  return decimals;
}

}  // namespace

CurveInfo curve_info(const NamedCurve& named, long digits) {
  const Curve& curve = named.curve;
  const Real length = total_length(curve).value;
  const ErfTurning turning = erf_turning(curve);
  CurveInfo info{named,
                 cusps(curve, closed(0, 1)),
                 rounded(turning.zeros, digits),
                 rounded(turning.extrema, digits),
                 length,
                 rounded(length, "the length", digits),
                 rounded(erf_twist(curve).value, "the twist", digits),
                 {}};
  const auto energy = bending_energy(curve);
  if (const auto* finite = std::get_if<Total>(&energy))
    info.bending_energy = rounded(finite->value, "the bending energy", digits);
  return info;
}

std::string to_text(const CurveInfo& info) {
  const Curve& curve = info.curve.curve;
  const QuaternionPolynomial& a = curve.preimage();
  const auto factors = [](const Polynomial& p) { return readable_factors(p); };
  const GaussianPolynomial g = bend_numerator(a);
  const AngleSplit split = closed_split(a);
  std::string text = heading(info.curve) + "\n\n";
  const auto row = [&](std::string_view name, const std::string& value) {
    text += phrame::row(name, value, 18);
  };
  row("u", shown(a.u));
  row("v", shown(a.v));
  row("p", shown(a.p));
  row("q", shown(a.q));
  if (!(curve.multiplier() == Polynomial{1})) row("multiplier f", shown(curve.multiplier()));
  row("σ = |A|²", factors(sigma(a)));
  row("h", factors(twist_numerator(a)));
  row("g", readable(g));
  row("ρ = 4|g|²", factors(rho(a)));
  row("(r′ × r″)·r‴", factors(triple_product(curve)));
  row("  split a", shown(split.a));
  row("  split b", shown(split.b));
  row("r(0)", shown(curve.start()));
  row("r(1)", shown(evaluate(position(curve), 1)));
  for (const Interval& cusp : info.cusps) row("cusp, r′ = 0", place_of_root(cusp));
  if (const std::string note = note_on_sign(curve); !note.empty()) row("sign of f", note);
  row("length ∫₀¹ |f|σ", shown(info.length, info.rounded_length));
  row("twist ∫₀¹ 2h/σ", info.twist_erf.value);
  for (const Decimal& t : info.erf_inflections) row("ERF turns back", "at t = " + t.value);
  for (const Decimal& t : info.erf_extrema) row("extremum of ω₁", "at t = " + t.value);
  row("energy ∫₀¹ κ² ds", info.bending_energy ? info.bending_energy->value : "∞");
  return text;
}

std::string to_json(const CurveInfo& info) {
  const Curve& curve = info.curve.curve;
  const QuaternionPolynomial& a = curve.preimage();
  const AngleSplit split = closed_split(a);
  JsonOutput points = JsonOutput::array();
  for (const auto& point : control_points(curve)) points.push_back(json_of(point));
  JsonOutput cusp_list = JsonOutput::array();
  for (const Interval& cusp : info.cusps)
    cusp_list.push_back({to_string(*cusp.lower), to_string(*cusp.upper)});
  const auto values = [](const std::vector<Decimal>& decimals) {
    JsonOutput list = JsonOutput::array();
    for (const Decimal& t : decimals) list.push_back(t.value);
    return list;
  };
  JsonOutput json = {
      {"phrame", "info/1"},
      {"name", info.curve.name},
      {"degree", degree(curve)},
      {"preimage_degree", preimage_degree(curve)},
      {"preimage",
       {{"u", json_of(a.u)}, {"v", json_of(a.v)}, {"p", json_of(a.p)}, {"q", json_of(a.q)}}},
      {"multiplier", json_of(curve.multiplier())},
      {"sigma", json_of(sigma(a))},
      {"h", json_of(twist_numerator(a))},
      {"g", json_of(bend_numerator(a))},
      {"rho", json_of(rho(a))},
      {"triple_product", json_of(triple_product(curve))},
      {"split", {{"a", json_of(split.a)}, {"b", json_of(split.b)}}},
      {"arc_length", json_of(info.length, info.rounded_length)},
      {"control_points", points},
      {"end_point", json_of(evaluate(position(curve), 1))},
      {"cusps", cusp_list},
      {"twist_erf", json_of(info.twist_erf)},
      {"erf_inflections", values(info.erf_inflections)},
      {"erf_extrema", values(info.erf_extrema)},
      {"bending_energy", info.bending_energy ? json_of(*info.bending_energy) : JsonOutput()}};
  if (!info.bending_energy) json["bending_energy_reason"] = "∞";
  return pretty(json);
}

}  // namespace phrame
