#include "phrame/io/write/totals_report.hpp"

#include <fmt/format.h>

#include "phrame/io/write/angle_report.hpp"
#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/number_text.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/shape.hpp"

namespace phrame {
namespace {

using Row = TotalsReport::Row;
constexpr auto unicode = Notation::unicode;

void set(Row& row, std::variant<Total, Infinite> answer) {
  if (auto* total = std::get_if<Total>(&answer))
    row.total = std::move(*total);
  else
    row.infinite = std::get<Infinite>(answer);
}

/// "√3·(…)": x times the root of the radicand.
std::string times_root(const Rational& radicand, const std::string& x) {
  return radicand == 1 ? x : fmt::format("√{}·({})", formatted(radicand, unicode), x);
}

std::string value_line(const std::string& exact, const Decimal& value) {
  std::string text;
  if (!exact.empty()) text += fmt::format("    = {}\n", readable_exact(exact));
  if (value.value != exact)
    text += fmt::format("    {} {}\n", value.radius == "0" ? "=" : "≈", value.value);
  return text;
}

std::string to_text(const Row& row) {
  std::string text = fmt::format("  {} {}", row.name, row.symbol);
  if (row.infinite)
    return text + fmt::format(" = ∞, the pole is at t = {}\n", shown(row.infinite->pole));
  if (!row.value) return text + fmt::format(": {}\n", row.reason);
  if (!row.total) return text + "\n" + value_line("", *row.value);
  const Total& total = *row.total;
  text +=
      fmt::format(" = {} with\n    F′ = {}\n",
                  times_root(total.radicand, total.turns.empty() ? "F(1) − F(0)" : "∫₀¹ ±F′ dt"),
                  formatted_quotient(total.rate, unicode));
  if (!total.turns.empty() && !total.rate.is_zero()) {
    std::string places;
    for (const RealAlgebraic& turn : total.turns)
      places += (places.empty() ? "" : ", ") + shown(turn);
    text += fmt::format("    the sign is + from 0 on and changes at t = {}\n", places);
  }
  const auto& F = total.antiderivative;
  text += fmt::format("    F  = {}\n",
                      formatted_sum(formatted_terms(F, unicode), "\n         ", unicode));
  std::string exact;
  if (total.exact)
    exact = times_root(total.radicand,
                       formatted_sum(formatted_terms(*total.exact, unicode), " ", unicode));
  return text + value_line(exact, *row.value);
}

JsonOutput json_of(const Row& row) {
  if (row.infinite) return {{"value", "inf"}, {"pole", phrame::json_of(row.infinite->pole)}};
  if (!row.value) return {{"value", nullptr}, {"reason", row.reason}};
  JsonOutput json = phrame::json_of(*row.value);
  if (!row.total) return json;
  const Total& total = *row.total;
  JsonOutput turns = JsonOutput::array();
  for (const RealAlgebraic& turn : total.turns) turns.push_back(phrame::json_of(turn));
  json["radicand"] = to_string(total.radicand);
  json["integrand"] = phrame::json_of(total.rate);
  json["turns"] = turns;
  json["antiderivative"] = phrame::json_of(total.antiderivative, form_name(total.antiderivative));
  if (total.exact) {
    const std::string formula = cas_formula(*total.exact, Language::plain);
    json["exact"] = total.radicand == 1
                        ? formula
                        : fmt::format("sqrt({})*({})", to_string(total.radicand), formula);
  }
  return json;
}

}  // namespace

TotalsReport totals_report(const NamedCurve& named, long digits) {
  const Curve& curve = named.curve;
  const bool is_line = line_direction(curve.preimage()).has_value();
  Row length{"length", "length", "∫ ds", total_length(curve)};
  Row twist{"erf_twist", "twist of the ERF", "∫ 2h/σ dt", erf_twist(curve)};
  Row torsion{"torsion", "total torsion", "∫ τ ds"};
  Row curvature{"curvature", "total curvature", "∫ κ ds", total_curvature(curve)};
  Row bending{"bending_energy", "bending energy", "∫ κ² ds"};
  Row frenet{"frenet_energy", "energy of the Frenet frame", "∫ (κ² + τ²) ds"};
  Row rotation{"rotation_index", "absolute rotation index", "∫ κ ds/2π"};
  set(bending, bending_energy(curve));
  if (is_line) {
    torsion.reason = frenet.reason = "a straight line has no torsion";
  } else {
    torsion.total = total_torsion(curve);
    set(frenet, frenet_energy(curve));
  }
  if (!curvature.total)
    curvature.reason = "κ is not rational, since ρ is not a constant times a square";
  if (const auto index = absolute_rotation_index(curve))
    rotation.value = rounded(*index, rotation.name, digits);
  else
    rotation.reason = "not a plane curve";

  TotalsReport report{named, {}, digits};
  for (Row* row : {&length, &twist, &torsion, &curvature, &rotation, &bending, &frenet}) {
    if (row->total) row->value = rounded(row->total->value, row->name, digits);
    report.rows.push_back(std::move(*row));
  }
  return report;
}

std::string to_text(const TotalsReport& report) {
  std::string text = heading(report.curve) + "\n\n";
  for (const Row& row : report.rows) text += to_text(row) + "\n";
  return text + fmt::format(
                    "From t = 0 to 1; decimals are correctly rounded to {}. "
                    "Checked: the derivative of F is F′, exactly.\n",
                    counted(static_cast<std::size_t>(report.digits), "digit"));
}

std::string to_json(const TotalsReport& report) {
  JsonOutput json = {
      {"phrame", "totals/1"}, {"name", report.curve.name}, {"degree", degree(report.curve.curve)}};
  for (const Row& row : report.rows) json[row.key] = json_of(row);
  return pretty(json);
}

}  // namespace phrame
