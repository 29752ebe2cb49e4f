#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include <array>

#include "phrame/answer/totals.hpp"
#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/ph/curve/corner.hpp"

namespace phrame::inline v0 {
namespace {

using Row = TotalsAnswer::Row;
using enum Notation;

struct Label {
  const char* key;     ///< in JSON
  const char* symbol;  ///< in a formula of prose()
};

constexpr std::array<Label, 15> labels{{{"length", "∫ ds"},
                                        {"erf_twist", "∫ 2h/σ\\, dt"},
                                        {"torsion", "∫ τ\\, ds"},
                                        {"curvature", "∫ κ\\, ds"},
                                        {"rotation_index", "∫ κ\\, ds/2π"},
                                        {"bending_energy", "∫ κ²\\, ds"},
                                        {"frenet_energy", "∫ (κ² + τ²)\\, ds"},
                                        {"up_twist", "∫ e₂′·e₃\\, dt"},
                                        {"signed_rotation_index", "∫ ±κ\\, ds/2π"},
                                        {"holonomy", ""},
                                        {"closing_turn_per_length", ""},
                                        {"writhe", ""},
                                        {"self_linking", ""},
                                        {"linking", ""},
                                        {"helicity", ""}}};
static_assert(labels.size() == static_cast<std::size_t>(Quantity::helicity) + 1);

const Label& label(Quantity quantity) { return labels[static_cast<std::size_t>(quantity)]; }

/// "twist of the ERF $∫ 2h/σ dt$".
/// How the corners of a path are counted: the tangent turns there, by their angles; energies are
/// infinite.
std::string note_of_corners(const Row& row) {
  switch (row.quantity) {
    case Quantity::curvature:
    case Quantity::rotation_index:
    case Quantity::signed_rotation_index:
      return row.value ? ", with the angles of the corners" : "";
    case Quantity::bending_energy:
    case Quantity::frenet_energy:
      return ", without the corners, where it is infinite";
    default:
      return "";
  }
}

std::string name(const Row& row, bool has_corners) {
  const std::string symbol = label(row.quantity).symbol;
  return name_of(row.quantity) + (symbol.empty() ? "" : " $" + symbol + "$") +
         (has_corners ? note_of_corners(row) : "");
}

/// "√3·(…)": x times the root of the radicand.
std::string times_root(const Rational& radicand, const std::string& x, Notation notation) {
  if (radicand == 1) return x;
  const std::string root =
      fmt::format(fmt::runtime(notation == latex ? "\\sqrt{{{}}}" : "√{}"),
                  notation == latex ? formatted(radicand, notation) : in_brief(radicand));
  if (x == "1") return root;
  return root + fmt::format(fmt::runtime(notation == latex ? " \\left({}\\right)" : "·({})"), x);
}

/// "√3·(…) + …", empty where there is none, and as the parts of a formula for computer algebra.
std::string exact_text(const Row& row, Notation notation) {
  if (!row.total || !row.total->exact)
    return row.exact ? notation == latex ? formatted(*row.exact, latex) : in_brief(*row.exact) : "";
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
           (radicand == 1    ? formula
            : formula == "1" ? fmt::format("sqrt({})", to_string(radicand))
                             : fmt::format("sqrt({})*({})", to_string(radicand), formula));
  }
  return sum;
}

/// What the integral is of a curve.
std::string integral(const CurveTotal& total, Notation notation) {
  return times_root(total.radicand, total.sign_changes.empty() ? "F(1) − F(0)" : "∫₀¹ ±F′\\, dt",
                    notation);
}

Value sign_changes(const CurveTotal& total) {
  const auto rows = [&](Notation notation) {
    std::string places;
    for (const RealAlgebraic& turn : total.sign_changes)
      places += (places.empty() ? "" : ", ") + in_words(turn, notation);
    return places.empty() || total.rate.is_zero() ? std::vector<std::string>()
                                                  : std::vector{places};
  };
  return {Value::Rows(rows), [&] { return array_of(total.sign_changes); }};
}

/// The integrand and its antiderivative.
Fields formula_fields(const CurveTotal& total) {
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

/// The segments, counted from 1, that have one; empty where all have or none.
std::vector<std::size_t> closed_forms_of_some(const Row& row) {
  std::vector<std::size_t> found;
  if (!row.total) return found;
  const auto& segments = row.total->segments;
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (closed_form(segments[k]) != nullptr) found.push_back(k + 1);
  if (found.size() == segments.size()) found.clear();
  return found;
}

/// Of a curve by itself that has one.
const CurveTotal* closed_form(const Row& row) {
  const bool is_of_curve = row.value && row.total && row.total->segments.size() == 1;
  return is_of_curve ? closed_form(row.total->segments.front()) : nullptr;
}

std::string to_text(const Row& row, bool has_corners) {
  std::string text = "  " + prose(name(row, has_corners), unicode);
  if (row.infinite)
    return text + fmt::format(" = ∞, the pole is at t = {}\n", shown(row.infinite->pole));
  if (!row.value) return text + fmt::format(": {}\n", row.reason);
  const CurveTotal* total = closed_form(row);
  if (total) text += prose(fmt::format(" = ${}$ with", integral(*total, unicode)), unicode);
  text += "\n";
  for (const auto& [label, words] : rows(total ? formula_fields(*total) : Fields(), unicode))
    text += fmt::format("    {} = {}\n", label, words);
  constexpr std::size_t longest = 240;
  const std::string exact = exact_text(row, unicode);
  if (!exact.empty()) text += fmt::format("    = {}\n", readable_exact(exact, longest));
  const Decimal& value = *row.value;
  if (shown(value) != exact)
    text += fmt::format("    {} {}\n", value.radius == "0" ? "=" : "≈", shown(value));
  if (const auto some = closed_forms_of_some(row); !some.empty())
    text += fmt::format("    in closed form on {} of {} segments: {}\n", some.size(),
                        row.total->segments.size(), ranges(some));
  return text;
}

/// The integral, its closed form and its decimal.
std::string equation(const Row& row) {
  if (row.infinite) return "$∞$, the pole is at $t =$ " + in_words(row.infinite->pole, latex);
  if (!row.value) return row.reason;
  std::string text;
  if (const CurveTotal* total = closed_form(row)) text += " = " + integral(*total, latex);
  const std::string exact = exact_text(row, latex);
  if (!exact.empty()) text += " = " + exact;
  const std::string decimal = latex_decimal(row.value->value);
  if (decimal != exact) text += (row.value->radius == "0" ? " = " : " \\approx ") + decimal;
  return "$" + text.substr(1) + "$";
}

Fields latex_fields(const Row& row, bool has_corners) {
  const auto words = [&row](Notation) { return equation(row); };
  Fields fields{{"", name(row, has_corners), {Value::Words(words), {}}}};
  const CurveTotal* total = closed_form(row);
  const Fields more = total ? formula_fields(*total) : Fields();
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
  if (const CurveTotal* total = closed_form(row)) json.update(json_of(formula_fields(*total)));
  if (row.exact) json["exact"] = to_string(*row.exact);
  if (row.total && row.total->exact) json["exact"] = exact_formula(*row.total);
  if (const auto some = closed_forms_of_some(row); !some.empty()) json["closed_forms"] = some;
  return json;
}

/// The PH curve that the path is, where it is one by itself.
const Curve* ph_by_itself(const TotalsAnswer& answer) {
  const auto& segments = answer.path.path.segments();
  return segments.size() == 1 ? ph_curve(segments.front()) : nullptr;
}

}  // namespace

std::string to_text(const TotalsAnswer& answer) {
  const std::size_t count = answer.path.path.segments().size();
  std::string text = heading(answer.path) + "\n\n";
  if (answer.up) text += fmt::format("  v = {}\n\n", shown(*answer.up));
  const bool has_corners = !corners(answer.path.path).empty();
  for (const Row& row : answer.rows) text += to_text(row, has_corners) + "\n";
  return text +
         fmt::format("From t = 0 to {}{}; decimals are correctly rounded to {}.{}\n", count,
                     count == 1 ? "" : ", the sums over the segments",
                     counted(static_cast<std::size_t>(answer.digits), "digit"),
                     ph_by_itself(answer) ? " Checked: the derivative of F is F′, exactly." : "");
}

std::string to_latex(const TotalsAnswer& answer) {
  std::string text;
  const bool has_corners = !corners(answer.path.path).empty();
  for (const Row& row : answer.rows) text += to_align(latex_fields(row, has_corners));
  return text;
}

std::string to_json(const TotalsAnswer& answer) {
  const bool is_curve = answer.path.path.segments().size() == 1;
  JsonOutput json = {{"phrame", is_curve ? "totals/1" : "spline-totals/1"},
                     {"name", answer.path.name}};
  if (const Curve* curve = ph_by_itself(answer)) json["degree"] = degree(*curve);
  if (answer.up) json["up"] = json_of(*answer.up);
  for (const Row& row : answer.rows) json[label(row.quantity).key] = json_of(row, is_curve);
  if (const auto breaks = corners(answer.path.path); !breaks.empty())
    json["corners"] = breaks.size();
  add_nearness(json, answer.path.near);
  return pretty(json);
}

}  // namespace phrame
