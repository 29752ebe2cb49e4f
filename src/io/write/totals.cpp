#include "phrame/io/write/totals.hpp"

#include <fmt/format.h>

#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

using Row = TotalsAnswer::Row;
using enum Notation;

struct Label {
  const char* key;     ///< in JSON
  const char* symbol;  ///< "∫ ds"
};

Label label(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return {"length", "∫ ds"};
    case Quantity::erf_twist:
      return {"erf_twist", "∫ 2h/σ dt"};
    case Quantity::torsion:
      return {"torsion", "∫ τ ds"};
    case Quantity::curvature:
      return {"curvature", "∫ κ ds"};
    case Quantity::rotation_index:
      return {"rotation_index", "∫ κ ds/2π"};
    case Quantity::bending_energy:
      return {"bending_energy", "∫ κ² ds"};
    case Quantity::frenet_energy:
      break;
  }
  return {"frenet_energy", "∫ (κ² + τ²) ds"};
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

/// "√3·(…) + …", and as the parts of a formula for computer algebra.
std::string exact_text(const PathTotal& total) {
  std::vector<std::string> terms;
  for (const auto& [radicand, of] : *total.exact)
    terms.push_back(
        times_root(radicand, formatted_sum(formatted_terms(of, unicode), " ", unicode)));
  return formatted_sum(terms, " ", unicode);
}

std::string exact_formula(const PathTotal& total) {
  std::string sum;
  for (const auto& [radicand, of] : *total.exact) {
    const std::string formula = cas_formula(of, Language::plain);
    sum += (sum.empty() ? "" : " + ") +
           (radicand == 1 ? formula : fmt::format("sqrt({})*({})", to_string(radicand), formula));
  }
  return sum;
}

/// The integral, its integrand and its antiderivative.
std::string formula_text(const Total& total) {
  std::string text = fmt::format(
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
  return text + fmt::format("    F  = {}\n",
                            formatted_sum(formatted_terms(F, unicode), "\n         ", unicode));
}

std::string to_text(const Row& row) {
  std::string text = fmt::format("  {} {}", name_of(row.quantity), label(row.quantity).symbol);
  if (row.infinite)
    return text + fmt::format(" = ∞, the pole is at t = {}\n", shown(row.infinite->pole));
  if (!row.value) return text + fmt::format(": {}\n", row.reason);
  const bool is_curve = row.total && row.total->segments.size() == 1;
  text += is_curve ? formula_text(row.total->segments.front()) : "\n";
  return text + value_line(row.total && row.total->exact ? exact_text(*row.total) : "", *row.value);
}

JsonOutput json_of(const Row& row, bool is_curve) {
  if (row.infinite) {
    JsonOutput json = {{"value", "inf"}, {"pole", phrame::json_of(row.infinite->pole)}};
    if (!is_curve) json["segment"] = row.infinite->segment + 1;
    return json;
  }
  if (!row.value) return {{"value", nullptr}, {"reason", row.reason}};
  JsonOutput json = phrame::json_of(*row.value);
  if (!row.total) return json;
  if (is_curve) {
    const Total& total = row.total->segments.front();
    JsonOutput turns = JsonOutput::array();
    for (const RealAlgebraic& turn : total.sign_changes) turns.push_back(phrame::json_of(turn));
    json["radicand"] = to_string(total.radicand);
    json["integrand"] = phrame::json_of(total.rate);
    json["turns"] = turns;
    json["antiderivative"] = phrame::json_of(total.antiderivative);
  }
  if (row.total->exact) json["exact"] = exact_formula(*row.total);
  return json;
}

}  // namespace

std::string to_text(const TotalsAnswer& answer) {
  const Path& path = answer.path.path;
  std::string text = heading(answer.path) + "\n\n";
  for (const Row& row : answer.rows) text += to_text(row) + "\n";
  return text + fmt::format("From t = 0 to {}{}; decimals are correctly rounded to {}.{}\n",
                            to_string(path.end()),
                            path.is_curve() ? "" : ", the sums over the segments",
                            counted(static_cast<std::size_t>(answer.digits), "digit"),
                            path.is_curve() ? " Checked: the derivative of F is F′, exactly." : "");
}

std::string to_json(const TotalsAnswer& answer) {
  const auto& [name, path] = answer.path;
  JsonOutput json = {{"phrame", path.is_curve() ? "totals/1" : "spline-totals/1"}, {"name", name}};
  if (path.is_curve()) json["degree"] = degree(path.segments().front());
  for (const Row& row : answer.rows) json[label(row.quantity).key] = json_of(row, path.is_curve());
  return pretty(json);
}

}  // namespace phrame
