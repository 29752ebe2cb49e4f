#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/frame_start.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/answer/angle.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/pole_table.hpp"
#include "phrame/io/write/radical_form_text.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/io/write/value_table.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame {
namespace {

using enum Notation;
constexpr auto below_label = "\n      ";

std::string quotient(const RationalFunction& f) { return formatted_quotient(f, unicode); }

/// In LaTeX with the constant; in text "0" where θ is one.
std::string closed_form(const AngleFormula& formula, Notation notation,
                        const std::string& constant = "C") {
  if (const auto* radicals = std::get_if<RadicalForm>(&formula.other))
    return notation == unicode ? indented(to_text(*radicals), below_label)
                               : to_latex(*radicals, "t", "z", constant);
  std::vector<std::string> terms;
  if (const auto* real = std::get_if<RealForm>(&formula.other)) {
    terms = formatted_terms(*real, notation);
  } else {
    terms = formatted_terms(formula.angle_to_erf, notation);
    if (const auto& g = formula.bend)
      terms.push_back(notation == unicode
                          ? "arg g(t), continuous"
                          : fmt::format("\\arg\\left({}\\right)", formatted(*g, latex)));
  }
  return notation == unicode ? formatted_sum(terms, below_label, unicode)
                             : with_constant(formatted_sum(terms, " ", latex), constant);
}

/// `start` is what is said of a θ that is constant.
std::string formula_text(const AngleFormula& formula, std::string_view rate,
                         const std::string& start) {
  const std::string form = closed_form(formula, unicode);
  return fmt::format("  θ′ = {}{}\n  θ  = {}\n", rate, quotient(formula.rate),
                     form == "0" ? start : form + below_label + "+ constant");
}

/// How the frame is turned.
std::string turning_text(const AngleAnswer& answer) {
  const bool erf = answer.reference == Reference::euler_rodrigues;
  std::string text = fmt::format(
      "  f₂ = cos θ {} + sin θ {},  f₃ = −sin θ {} + cos θ {},  θ(0) = {}\n", erf ? "e₂" : "n",
      erf ? "e₃" : "b", erf ? "e₂" : "n", erf ? "e₃" : "b", shown(answer.start_angle));
  if (const auto* normal = std::get_if<StartNormal>(&answer.start))
    text +=
        fmt::format("  f₂(0) is along {}, projected to the normal plane\n", shown(normal->vector));
  if (const auto* least = std::get_if<LeastRotation>(&answer.start))
    text += fmt::format("  At the start {}\n", to_sentence(*least));
  return text + "\n";
}

std::string curve_text(const AngleAnswer& answer) {
  const Curve& curve = answer.path.path.segments().front();
  const AngleFormula& formula = answer.formulas.front();
  const QuaternionPolynomial& preimage = curve.preimage();
  const bool erf = answer.reference == Reference::euler_rodrigues;
  std::string text = fmt::format("  σ = {}\n  h = {}\n", readable_factors(sigma(preimage)),
                                 readable_factors(twist_numerator(preimage)));
  if (!erf) text += fmt::format("  g = {}\n", readable(bend_numerator(preimage)));
  for (const RealRoot& cusp : cusps(curve))
    text += fmt::format("  r′ = 0 at {}: frames and angle are continued through\n",
                        place("t", cusp.at));
  if (const std::string note = note_on_sign(curve); !note.empty())
    text += fmt::format("  {}\n", prose(note, unicode));
  if (!erf)
    for (const RealRoot& flip : odd(inflections(preimage)))
      text += fmt::format("  inflection at {}: (n, b) flip there, the angle is continued through\n",
                          place("t", flip.at));
  text += fmt::format(
      "\nThe rotation-minimizing frame is the {} frame turned by θ about the tangent:\n",
      erf ? "Euler–Rodrigues" : "Frenet");
  text += turning_text(answer);
  text +=
      formula_text(formula, erf ? "−2h/σ = " : "−2h/σ + Im(g′/g) = ", shown(answer.start_angle));
  text += "  Checked: the derivative of this θ is θ′, exactly.\n";
  if (formula.poles) text += to_text(*formula.poles);
  return text;
}

std::string relation(const Decimal& x) { return x.radius == "0" ? "=" : "≈"; }

std::string spline_text(const AngleAnswer& answer) {
  std::string text = notes_on_signs(answer.path.path);
  text += fmt::format(
      "The rotation-minimizing frame is the {} frame, continuous through the joints,\n"
      "turned by θ about the tangent:\n",
      answer.reference == Reference::frenet ? "Frenet" : "Euler–Rodrigues");
  text += turning_text(answer);
  text +=
      "On each segment t runs from 0 to 1 here; along the spline, segment k is from t = k − 1 to "
      "k.\n\n";
  for (std::size_t k = 0; k < answer.formulas.size(); ++k) {
    text += fmt::format("Segment {}\n", k + 1);
    if (const auto& g = answer.formulas[k].bend) text += fmt::format("  g = {}\n", readable(*g));
    text += formula_text(answer.formulas[k], "", "constant");
  }
  text += "Checked: the derivative of each θ is θ′, exactly.\n\n";
  text += fmt::format("  total angle {} {}\n", relation(*answer.total), shown(*answer.total));
  if (answer.holonomy)
    text += fmt::format("  holonomy {} {}: the frame comes back turned by this about the tangent\n",
                        relation(*answer.holonomy), shown(*answer.holonomy));
  return text;
}

/// The formula of one segment.
void add_formula(JsonOutput& json, const AngleFormula& formula) {
  json["integrand"] = json_of(formula.rate);
  json["antiderivative"] = json_of(formula.antiderivative);
  add_other_form(json, formula.other);
}

JsonOutput json_of(const AngleAnswer& answer) {
  const auto& [name, path, near, notes] = answer.path;
  const std::vector<Curve>& segments = path.segments();
  JsonOutput json;
  if (path.is_curve()) {
    json = {{"phrame", "angle/1"},
            {"curve", {{"name", name}, {"degree", degree(segments.front())}}},
            {"frame", name_of(answer.reference)}};
    if (!answer.formulas.empty()) add_formula(json, answer.formulas.front());
  } else {
    json = {{"phrame", "spline-angle/1"}, {"name", name}};
    if (answer.reference == Reference::frenet) json["frame"] = name_of(answer.reference);
    for (std::size_t k = 0; k < answer.formulas.size(); ++k) {
      json["segments"].push_back({{"degree", degree(segments[k])}});
      add_formula(json["segments"].back(), answer.formulas[k]);
    }
  }
  json["theta0"] = to_string(answer.start_angle);
  add_start(json, answer.start);
  add_nearness(json, near);
  if (!path.is_curve()) {
    json["total"] = phrame::json_of(*answer.total);
    json["closed"] = path.closing_turn().has_value();
    json["holonomy"] = answer.holonomy ? phrame::json_of(*answer.holonomy) : JsonOutput();
  }
  json["values"] = phrame::json_of(answer.values);
  return json;
}

}  // namespace

std::string to_text(const AngleAnswer& answer) {
  std::string text = heading(answer.path) + "\n\n";
  text += answer.path.path.is_curve() ? curve_text(answer) : spline_text(answer);
  return answer.values.empty() ? text : text + value_table(answer.values, answer.digits);
}

std::string to_latex(const AngleAnswer& answer) {
  std::string text = "\\begin{align*}\n";
  for (std::size_t k = 0; k < answer.formulas.size(); ++k) {
    const AngleFormula& formula = answer.formulas[k];
    const std::string index = answer.path.path.is_curve() ? "" : fmt::format("_{{{}}}", k + 1);
    const std::string theta = "\\theta" + index;
    text += fmt::format("{}{}'(t) &= {} \\\\\n{}(t) &= {}", k == 0 ? "" : " \\\\\n", theta,
                        formatted_quotient(formula.rate, latex), theta,
                        closed_form(formula, latex, "C" + index));
  }
  if (!(answer.start_angle == FrameAngle()))
    text += fmt::format(" \\\\\n\\theta(0) &= {}", formatted(answer.start_angle, latex));
  text += "\n\\end{align*}\n";
  return answer.values.empty() ? text : text + latex_value_table(answer.values);
}

std::string to_json(const AngleAnswer& answer) { return pretty(json_of(answer)); }

std::string to_json_line(const AngleAnswer& answer) { return json_of(answer).dump(); }

}  // namespace phrame
