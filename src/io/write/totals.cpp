#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include "phrame/answer/totals.hpp"
#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"

namespace phrame {
namespace {

using Row = TotalsAnswer::Row;
using enum Notation;

struct Label {
  const char* key;     ///< in JSON
  const char* symbol;  ///< in a formula of prose()
};

Label label(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return {"length", "∫ ds"};
    case Quantity::erf_twist:
      return {"erf_twist", "∫ 2h/σ\\, dt"};
    case Quantity::torsion:
      return {"torsion", "∫ τ\\, ds"};
    case Quantity::curvature:
      return {"curvature", "∫ κ\\, ds"};
    case Quantity::rotation_index:
      return {"rotation_index", "∫ κ\\, ds/2π"};
    case Quantity::bending_energy:
      return {"bending_energy", "∫ κ²\\, ds"};
    case Quantity::frenet_energy:
      return {"frenet_energy", "∫ (κ² + τ²)\\, ds"};
    case Quantity::up_twist:
      return {"up_twist", "∫ e₂′·e₃\\, dt"};
    case Quantity::holonomy:
      return {"holonomy", ""};
    case Quantity::closing_turn:
      return {"closing_turn_per_length", ""};
    case Quantity::writhe:
      return {"writhe", ""};
    case Quantity::self_linking:
      break;
  }
  return {"self_linking", ""};
}

/// "twist of the ERF $∫ 2h/σ dt$".
std::string name(const Row& row) {
  const std::string symbol = label(row.quantity).symbol;
  return name_of(row.quantity) + (symbol.empty() ? "" : " $" + symbol + "$");
}

/// "√3·(…)": x times the root of the radicand.
std::string times_root(const Rational& radicand, const std::string& x, Notation notation) {
  if (radicand == 1) return x;
  return fmt::format(
      fmt::runtime(notation == latex ? "\\sqrt{{{}}} \\left({}\\right)" : "√{}·({})"),
      notation == latex ? formatted(radicand, notation) : in_brief(radicand), x);
}

/// "√3·(…) + …", empty where there is none, and as the parts of a formula for computer algebra.
std::string exact_text(const Row& row, Notation notation) {
  if (row.exact) return notation == latex ? formatted(*row.exact, latex) : in_brief(*row.exact);
  if (!row.total || !row.total->exact) return "";
  std::vector<std::string> terms;
  for (const auto& [radicand, of] : *row.total->exact)
    terms.push_back(times_root(
        radicand, formatted_sum(formatted_terms(of, notation), " ", notation), notation));
  return formatted_sum(terms, " ", notation);
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

/// What the integral is of a curve.
std::string integral(const Total& total, Notation notation) {
  return times_root(total.radicand, total.sign_changes.empty() ? "F(1) − F(0)" : "∫₀¹ ±F′\\, dt",
                    notation);
}

Value sign_changes(const Total& total) {
  const auto rows = [&](Notation notation) {
    std::string places;
    for (const RealAlgebraic& turn : total.sign_changes)
      places += (places.empty() ? "" : ", ") + in_words(turn, notation);
    return places.empty() || total.rate.is_zero() ? std::vector<std::string>()
                                                  : std::vector{places};
  };
  const auto json = [&] {
    JsonOutput turns = JsonOutput::array();
    for (const RealAlgebraic& turn : total.sign_changes) turns.push_back(phrame::json_of(turn));
    return turns;
  };
  return {Value::Rows(rows), json};
}

/// The integrand and its antiderivative.
Fields formula_fields(const Total& total) {
  const auto rate = [&](Notation notation) {
    return formula(formatted_quotient(total.rate, notation), notation);
  };
  const auto antiderivative = [&](Notation notation) {
    const std::vector<std::string> terms = formatted_terms(total.antiderivative, notation);
    return formula(formatted_sum(terms, notation == latex ? " " : "\n         ", notation),
                   notation);
  };
  return {json_field("radicand", to_string(total.radicand)),
          {"integrand", "$F′$", {Value::Words(rate), [&] { return json_of(total.rate); }}},
          {"turns", "the sign is $+$ from $0$ on and changes at $t$", sign_changes(total)},
          {"antiderivative", "$F$ ", {Value::Words(antiderivative), [&] {
                                        return json_of(total.antiderivative);
                                      }}}};
}

/// Of the total of a curve.
Fields formula_fields(const Row& row, bool is_curve) {
  return is_curve && row.value && row.total ? formula_fields(row.total->segments.front())
                                            : Fields();
}

std::string to_text(const Row& row, bool is_curve) {
  std::string text = "  " + prose(name(row), unicode);
  if (row.infinite)
    return text + fmt::format(" = ∞, the pole is at t = {}\n", shown(row.infinite->pole));
  if (!row.value) return text + fmt::format(": {}\n", row.reason);
  const Fields fields = formula_fields(row, is_curve);
  if (!fields.empty())
    text +=
        prose(fmt::format(" = ${}$ with", integral(row.total->segments.front(), unicode)), unicode);
  text += "\n";
  for (const auto& [label, words] : rows(fields, unicode))
    text += fmt::format("    {} = {}\n", label, words);
  constexpr std::size_t longest = 240;
  const std::string exact = exact_text(row, unicode);
  if (!exact.empty()) text += fmt::format("    = {}\n", readable_exact(exact, longest));
  const Decimal& value = *row.value;
  if (shown(value) != exact)
    text += fmt::format("    {} {}\n", value.radius == "0" ? "=" : "≈", shown(value));
  return text;
}

/// The integral, its closed form and its decimal.
std::string equation(const Row& row, bool is_curve) {
  if (row.infinite) return "$∞$, the pole is at $t =$ " + in_words(row.infinite->pole, latex);
  if (!row.value) return row.reason;
  std::string text;
  if (is_curve && row.total) text += " = " + integral(row.total->segments.front(), latex);
  const std::string exact = exact_text(row, latex);
  if (!exact.empty()) text += " = " + exact;
  const std::string decimal = latex_decimal(row.value->value);
  if (decimal != exact) text += (row.value->radius == "0" ? " = " : " \\approx ") + decimal;
  return "$" + text.substr(1) + "$";
}

Fields latex_fields(const Row& row, bool is_curve) {
  const auto words = [&row, is_curve](Notation) { return equation(row, is_curve); };
  Fields fields{{"", name(row), {Value::Words(words), {}}}};
  const Fields more = formula_fields(row, is_curve);
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

JsonOutput json_of(const Row& row, bool is_curve) {
  if (row.infinite) {
    JsonOutput json = {{"value", "inf"}, {"pole", phrame::json_of(row.infinite->pole)}};
    if (!is_curve) json["segment"] = row.infinite->segment + 1;
    return json;
  }
  if (!row.value) return {{"value", nullptr}, {"reason", row.reason}};
  JsonOutput json = phrame::json_of(*row.value);
  json.update(json_of(formula_fields(row, is_curve)));
  if (row.exact) json["exact"] = to_string(*row.exact);
  if (row.total && row.total->exact) json["exact"] = exact_formula(*row.total);
  return json;
}

struct Shape {
  std::size_t segments;
  bool has_formulas;  ///< a PH curve by itself
};

Shape shape_of(const TotalsAnswer& answer) {
  const std::size_t count =
      std::visit([](const auto& named) { return named.path.segments().size(); }, answer.path);
  return {count, count == 1 && std::holds_alternative<NamedPhPath>(answer.path)};
}

}  // namespace

std::string to_text(const TotalsAnswer& answer) {
  const auto [count, has_formulas] = shape_of(answer);
  std::string text =
      std::visit([](const auto& named) { return heading(named); }, answer.path) + "\n\n";
  if (answer.up) text += fmt::format("  v = {}\n\n", shown(*answer.up));
  for (const Row& row : answer.rows) text += to_text(row, has_formulas) + "\n";
  return text + fmt::format("From t = 0 to {}{}; decimals are correctly rounded to {}.{}\n", count,
                            count == 1 ? "" : ", the sums over the segments",
                            counted(static_cast<std::size_t>(answer.digits), "digit"),
                            has_formulas ? " Checked: the derivative of F is F′, exactly." : "");
}

std::string to_latex(const TotalsAnswer& answer) {
  const bool has_formulas = shape_of(answer).has_formulas;
  std::string text;
  for (const Row& row : answer.rows) text += to_align(latex_fields(row, has_formulas));
  return text;
}

std::string to_json(const TotalsAnswer& answer) {
  const auto [count, has_formulas] = shape_of(answer);
  const std::string name = std::visit([](const auto& named) { return named.name; }, answer.path);
  JsonOutput json = {{"phrame", count == 1 ? "totals/1" : "spline-totals/1"}, {"name", name}};
  const auto* named = std::get_if<NamedPhPath>(&answer.path);
  if (has_formulas) json["degree"] = degree(named->path.segments().front());
  if (answer.up) json["up"] = json_of(*answer.up);
  for (const Row& row : answer.rows) json[label(row.quantity).key] = json_of(row, count == 1);
  if (named != nullptr) add_nearness(json, named->near);
  return pretty(json);
}

}  // namespace phrame
