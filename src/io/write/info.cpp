#include "phrame/io/write/info.hpp"

#include <fmt/format.h>

#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame {
namespace {

std::string curve_text(const InfoAnswer& info) {
  const Curve& curve = info.path.path.segments().front();
  const QuaternionPolynomial& a = curve.preimage();
  const auto factors = [](const Polynomial& p) { return readable_factors(p); };
  const GaussianPolynomial g = bend_numerator(a);
  const AngleSplit split = closed_split(a);
  std::string text;
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
  for (const RealRoot& cusp : info.cusps) row("cusp, r′ = 0", place("t", cusp.at));
  if (const std::string note = note_on_sign(curve); !note.empty()) row("sign of f", note);
  row("length ∫₀¹ |f|σ", shown(info.length.exact, info.length.rounded));
  row("twist ∫₀¹ 2h/σ", info.twist_erf.value);
  for (const Decimal& t : info.erf_inflections) row("ERF turns back", "at t = " + t.value);
  for (const Decimal& t : info.erf_extrema) row("extremum of ω₁", "at t = " + t.value);
  row("energy ∫₀¹ κ² ds", info.bending_energy ? info.bending_energy->value : "∞");
  return text;
}

std::string spline_text(const InfoAnswer& info) {
  const Path& path = info.path.path;
  std::string text = notes_on_signs(path);
  const auto row = [&](std::string_view name, const std::string& value) {
    text += phrame::row(name, value, 18);
  };
  row("length ∫ |f|σ", shown(info.length.exact, info.length.rounded));
  row("twist ∫ 2h/σ", info.twist_erf.value);
  row("energy ∫ κ² ds", info.bending_energy ? info.bending_energy->value : "∞");
  if (info.holonomy) row("holonomy", info.holonomy->value);
  text += "\n  segment  degree  length\n";
  for (std::size_t k = 0; k < path.segments().size(); ++k)
    text += fmt::format("  {:>7}  {:>6}  {}\n", k + 1, degree(path.segments()[k]),
                        shown(info.lengths[k].exact, info.lengths[k].rounded));
  return text;
}

JsonOutput json_of(const InfoAnswer::Length& length) {
  return phrame::json_of(length.exact, length.rounded);
}

void add_energy(JsonOutput& json, const InfoAnswer& info) {
  json["bending_energy"] =
      info.bending_energy ? phrame::json_of(*info.bending_energy) : JsonOutput();
}

JsonOutput curve_json(const InfoAnswer& info) {
  const Curve& curve = info.path.path.segments().front();
  const QuaternionPolynomial& a = curve.preimage();
  const AngleSplit split = closed_split(a);
  JsonOutput points = JsonOutput::array();
  for (const auto& point : control_points(curve)) points.push_back(phrame::json_of(point));
  JsonOutput cusp_list = JsonOutput::array();
  for (const RealRoot& cusp : info.cusps) {
    const auto exact = cusp.at.rational();
    const RealBall t = enclose(cusp.at, 53);
    cusp_list.push_back(
        {to_string(exact ? *exact : t.lower()), to_string(exact ? *exact : t.upper())});
  }
  const auto values = [](const std::vector<Decimal>& decimals) {
    JsonOutput list = JsonOutput::array();
    for (const Decimal& t : decimals) list.push_back(t.value);
    return list;
  };
  JsonOutput json = {{"phrame", "info/1"},
                     {"name", info.path.name},
                     {"degree", degree(curve)},
                     {"preimage_degree", preimage_degree(curve)},
                     {"preimage",
                      {{"u", phrame::json_of(a.u)},
                       {"v", phrame::json_of(a.v)},
                       {"p", phrame::json_of(a.p)},
                       {"q", phrame::json_of(a.q)}}},
                     {"multiplier", phrame::json_of(curve.multiplier())},
                     {"sigma", phrame::json_of(sigma(a))},
                     {"h", phrame::json_of(twist_numerator(a))},
                     {"g", phrame::json_of(bend_numerator(a))},
                     {"rho", phrame::json_of(rho(a))},
                     {"triple_product", phrame::json_of(triple_product(curve))},
                     {"split", {{"a", phrame::json_of(split.a)}, {"b", phrame::json_of(split.b)}}},
                     {"arc_length", json_of(info.length)},
                     {"control_points", points},
                     {"end_point", phrame::json_of(evaluate(position(curve), 1))},
                     {"cusps", cusp_list},
                     {"twist_erf", phrame::json_of(info.twist_erf)},
                     {"erf_inflections", values(info.erf_inflections)},
                     {"erf_extrema", values(info.erf_extrema)}};
  add_energy(json, info);
  return json;
}

JsonOutput spline_json(const InfoAnswer& info) {
  const Path& path = info.path.path;
  JsonOutput segments = JsonOutput::array();
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const Curve& curve = path.segments()[k];
    segments.push_back({{"degree", degree(curve)},
                        {"start", phrame::json_of(curve.start())},
                        {"end", phrame::json_of(evaluate(position(curve), 1))},
                        {"arc_length", json_of(info.lengths[k])}});
  }
  JsonOutput json = {{"phrame", "spline-info/1"},
                     {"name", info.path.name},
                     {"segments", segments},
                     {"closed", path.closing_turn().has_value()},
                     {"ends_meet", path.ends_meet()},
                     {"arc_length", json_of(info.length)},
                     {"twist_erf", phrame::json_of(info.twist_erf)}};
  add_energy(json, info);
  json["holonomy"] = info.holonomy ? phrame::json_of(*info.holonomy) : JsonOutput();
  return json;
}

}  // namespace

std::string to_text(const InfoAnswer& info) {
  return heading(info.path) + "\n\n" +
         (info.path.path.is_curve() ? curve_text(info) : spline_text(info));
}

std::string to_json(const InfoAnswer& info) {
  JsonOutput json = info.path.path.is_curve() ? curve_json(info) : spline_json(info);
  if (!info.bending_energy) json["bending_energy_reason"] = "∞";
  return pretty(json);
}

}  // namespace phrame
