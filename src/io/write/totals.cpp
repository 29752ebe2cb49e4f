#include "phrame/io/write/totals.hpp"

#include <fmt/format.h>

#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/number_text.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

using Row = TotalsAnswer::Row;
using enum Notation;

struct Label {
  const char* key;     ///< in JSON
  const char* name;    ///< "length"
  const char* symbol;  ///< "∫ ds"
};

Label label(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return {"length", "length", "∫ ds"};
    case Quantity::erf_twist:
      return {"erf_twist", "twist of the ERF", "∫ 2h/σ dt"};
    case Quantity::torsion:
      return {"torsion", "total torsion", "∫ τ ds"};
    case Quantity::curvature:
      return {"curvature", "total curvature", "∫ κ ds"};
    case Quantity::rotation_index:
      return {"rotation_index", "absolute rotation index", "∫ κ ds/2π"};
    case Quantity::bending_energy:
      return {"bending_energy", "bending energy", "∫ κ² ds"};
    case Quantity::frenet_energy:
      break;
  }
  return {"frenet_energy", "energy of the Frenet frame", "∫ (κ² + τ²) ds"};
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
  const auto [key, name, symbol] = label(row.quantity);
  std::string text = fmt::format("  {} {}", name, symbol);
  if (row.infinite)
    return text + fmt::format(" = ∞, the pole is at t = {}\n", shown(row.infinite->pole));
  if (!row.value) return text + fmt::format(": {}\n", row.reason);
  if (!row.total) return text + "\n" + value_line("", *row.value);
  const Total& total = *row.total;
  text += fmt::format(
      " = {} with\n    F′ = {}\n",
      times_root(total.radicand, total.sign_changes.empty() ? "F(1) − F(0)" : "∫₀¹ ±F′ dt"),
      formatted_quotient(total.rate, unicode));
  if (!total.sign_changes.empty() && !total.rate.is_zero()) {
    std::string places;
    for (const RealAlgebraic& turn : total.sign_changes)
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
  for (const RealAlgebraic& turn : total.sign_changes) turns.push_back(phrame::json_of(turn));
  json["radicand"] = to_string(total.radicand);
  json["integrand"] = phrame::json_of(total.rate);
  json["turns"] = turns;
  json["antiderivative"] = phrame::json_of(total.antiderivative);
  if (total.exact) {
    const std::string formula = cas_formula(*total.exact, Language::plain);
    json["exact"] = total.radicand == 1
                        ? formula
                        : fmt::format("sqrt({})*({})", to_string(total.radicand), formula);
  }
  return json;
}

}  // namespace

std::string to_text(const TotalsAnswer& answer) {
  std::string text = heading(answer.curve.name, answer.curve.curve) + "\n\n";
  for (const Row& row : answer.rows) text += to_text(row) + "\n";
  return text + fmt::format(
                    "From t = 0 to 1; decimals are correctly rounded to {}. "
                    "Checked: the derivative of F is F′, exactly.\n",
                    counted(static_cast<std::size_t>(answer.digits), "digit"));
}

std::string to_json(const TotalsAnswer& answer) {
  JsonOutput json = {
      {"phrame", "totals/1"}, {"name", answer.curve.name}, {"degree", degree(answer.curve.curve)}};
  for (const Row& row : answer.rows) json[label(row.quantity).key] = json_of(row);
  return pretty(json);
}

}  // namespace phrame
