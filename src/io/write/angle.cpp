#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/frame_start.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/answer/angle.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_object.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/pole_table.hpp"
#include "phrame/io/write/radical_form_text.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/io/write/value_table.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0 {
namespace {

using enum Notation;
constexpr auto below_label = "\n      ";

std::string quotient(const RationalFunction& f) { return formatted_quotient(f, unicode); }

std::string as_text(const std::variant<FrameAngle, Decimal>& angle) {
  return std::visit([](const auto& x) { return shown(x); }, angle);
}

/// e₂ and e₃ of the reference frame.
std::pair<const char*, const char*> axes(const AngleAnswer& answer) {
  return answer.reference == Reference::frenet ? std::pair{"n", "b"} : std::pair{"e₂", "e₃"};
}

/// Is it a path of PH curves, by a frame that they all have closed forms to?
std::optional<PhPath> ph_path(const AngleAnswer& answer) {
  return answer.reference == Reference::up ? std::nullopt : answer.path.path.with_preimages();
}

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
  const auto [second, third] = axes(answer);
  std::string text =
      fmt::format("  f₂ = cos θ {0} + sin θ {1},  f₃ = −sin θ {0} + cos θ {1},  θ(0) = {2}\n",
                  second, third, as_text(answer.start_angle));
  if (const auto* normal = std::get_if<StartNormal>(&answer.start))
    text +=
        fmt::format("  f₂(0) is along {}, projected to the normal plane\n", shown(normal->vector));
  if (const auto* least = std::get_if<LeastRotation>(&answer.start))
    text += fmt::format("  At the start {}\n", to_sentence(*least));
  if (!answer.path.path.corners().empty())
    text +=
        fmt::format("  At corners f₂ and f₃ are carried by the least rotation of the tangent{}\n",
                    answer.reference == Reference::up ? ", and θ jumps" : "");
  return text + "\n";
}

std::string curve_text(const AngleAnswer& answer, const Curve& curve) {
  const AngleFormula& formula = *answer.formulas.front();
  const QuaternionPolynomial& preimage = curve.preimage();
  const bool erf = answer.reference == Reference::euler_rodrigues;
  std::string text = fmt::format("  σ = {}\n  h = {}\n", readable_factors(sigma(preimage)),
                                 readable_factors(twist_numerator(preimage)));
  if (!erf) text += fmt::format("  g = {}\n", readable(bend_numerator(preimage)));
  for (const RealRoot& cusp : cusps(curve))
    text += fmt::format("  r′ = 0 at {}: frames and angle are continued through\n",
                        place_text("t", cusp.at));
  if (const std::string note = note_on_sign(curve); !note.empty())
    text += fmt::format("  {}\n", prose(note, unicode));
  if (!erf)
    for (const RealRoot& flip : odd(inflections(preimage)))
      text += fmt::format("  inflection at {}: (n, b) flip there, the angle is continued through\n",
                          place_text("t", flip.at));
  text += fmt::format(
      "\nThe rotation-minimizing frame is the {} frame turned by θ about the tangent:\n",
      erf ? "Euler–Rodrigues" : "Frenet");
  text += turning_text(answer);
  text +=
      formula_text(formula, erf ? "−2h/σ = " : "−2h/σ + Im(g′/g) = ", as_text(answer.start_angle));
  text += "  Checked: the derivative of this θ is θ′, exactly.\n";
  if (formula.poles) text += to_text(*formula.poles);
  return text;
}

std::string relation(const Decimal& x) { return x.radius == "0" ? "=" : "≈"; }

std::string totals_text(const AngleAnswer& answer) {
  std::string text =
      fmt::format("  total angle {} {}\n", relation(*answer.total), shown(*answer.total));
  if (answer.holonomy)
    text += fmt::format("  holonomy {} {}: the frame comes back turned by this about the tangent\n",
                        relation(*answer.holonomy), shown(*answer.holonomy));
  if (!answer.no_holonomy.empty())
    text += fmt::format("  holonomy undecided: {}\n", answer.no_holonomy);
  return text;
}

/// The closed forms of the segments that have one; on paths of several kinds those where θ is
/// constant, as on straight lines, are listed.
std::string formulas_text(const AngleAnswer& answer) {
  const bool is_ph = answer.path.path.is_ph();
  std::vector<std::size_t> constant;
  std::string formulas;
  for (std::size_t k = 0; k < answer.formulas.size(); ++k) {
    if (!answer.formulas[k]) continue;
    if (!is_ph && answer.formulas[k]->rate.is_zero()) {
      constant.push_back(k + 1);
      continue;
    }
    formulas += fmt::format("Segment {}\n", k + 1);
    if (const auto& g = answer.formulas[k]->bend)
      formulas += fmt::format("  g = {}\n", readable(*g));
    formulas += formula_text(*answer.formulas[k], "", "constant");
  }
  std::string text;
  if (!constant.empty())
    text = fmt::format("θ is constant on segment{} {}.\n", constant.size() == 1 ? "" : "s",
                       ranges(constant));
  if (formulas.empty()) return text;
  return text +
         "On each segment t runs from 0 to 1 here; along the spline, segment k is from t = k − 1 "
         "to k.\n\n" +
         formulas + "Checked: the derivative of each θ is θ′, exactly.\n";
}

std::string spline_text(const AngleAnswer& answer, const PhPath& path) {
  std::string text = notes_on_signs(path);
  text += fmt::format(
      "The rotation-minimizing frame is the {} frame, continuous through the joints,\n"
      "turned by θ about the tangent:\n",
      answer.reference == Reference::frenet ? "Frenet" : "Euler–Rodrigues");
  return text + turning_text(answer) + formulas_text(answer) + "\n" + totals_text(answer);
}

/// Where the path has no closed form.
std::string no_closed_form(const AngleAnswer& answer) {
  std::vector<std::size_t> none;
  const auto& segments = answer.path.path.segments();
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (ph_curve(segments[k]) == nullptr) none.push_back(k + 1);
  if (none.size() == segments.size())
    return "no closed form: the curve is not Pythagorean-hodograph";
  return fmt::format("no closed form on segment{} {}, not Pythagorean-hodograph",
                     none.size() == 1 ? "" : "s", ranges(none));
}

/// What θ is the integral of, to the frame of a vector and along what is not PH.
std::string rate_text(const AngleAnswer& answer) {
  if (answer.is_straight)
    return "  θ is constant: the curve is a straight line, where any frame that does not turn is "
           "rotation-minimizing\n";
  if (answer.is_zero) return "  θ is constant: this frame is rotation-minimizing already\n";
  std::string text;
  if (!answer.path.path.has_erf())
    text = fmt::format(
        "  θ′ = {}, H along r′\n  {}\n",
        answer.up ? "−(v·H) det(v, H, H′)/(|H| |v × H|²)" : "−|H| det(H, H′, H″)/|H × H′|²",
        no_closed_form(answer));
  const bool has_formulas = std::any_of(answer.formulas.begin(), answer.formulas.end(),
                                        [](const auto& formula) { return formula != nullptr; });
  if (!has_formulas) return text;
  if (answer.formulas.size() > 1) return text + "\n" + formulas_text(answer);
  if (const auto& g = answer.formulas.front()->bend)
    text += fmt::format("  g = {}\n", readable(*g));
  text +=
      formula_text(*answer.formulas.front(), "−2h/σ + Im(g′/g) = ", as_text(answer.start_angle));
  text += "  Checked: the derivative of this θ is θ′, exactly.\n";
  if (const auto& poles = answer.formulas.front()->poles) text += to_text(*poles);
  return text;
}

std::string general_text(const AngleAnswer& answer) {
  const std::string frame =
      answer.up ? fmt::format(
                      "The rotation-minimizing frame is the frame of the up vector v = {}, "
                      "e₂ = v × e₁/|v × e₁|,\ne₃ = e₁ × e₂, turned by θ about the "
                      "tangent:\n",
                      shown(*answer.up))
                : "The rotation-minimizing frame is the Frenet frame turned by θ about the "
                  "tangent:\n";
  return frame + turning_text(answer) + rate_text(answer) + "\n" + totals_text(answer);
}

/// The formula of one segment.
void add_formula(JsonOutput& json, const AngleFormula& formula) {
  json["integrand"] = json_of(formula.rate);
  json["antiderivative"] = json_of(formula.antiderivative);
  add_other_form(json, formula.other);
}

JsonOutput curve_json(const NamedPath& named) {
  JsonOutput json = object_with_room(2);
  json["name"] = named.name;
  if (const Curve* ph = ph_curve(named.path.segments().front())) json["degree"] = degree(*ph);
  return json;
}

/// The closed forms, or why there is none.
void add_formulas(JsonOutput& json, const AngleAnswer& answer) {
  const auto& segments = answer.path.path.segments();
  const bool is_single = segments.size() == 1;
  if (std::none_of(segments.begin(), segments.end(), ph_curve)) {
    json["closed_form"] = nullptr;
    json["closed_form_reason"] = no_closed_form(answer);
  }
  for (std::size_t k = 0; k < answer.formulas.size(); ++k) {
    if (json.contains("closed_form")) return;
    if (is_single) return add_formula(json, *answer.formulas[k]);
    JsonOutput segment;
    if (const Curve* ph = ph_curve(segments[k])) {
      segment["degree"] = degree(*ph);
      add_formula(segment, *answer.formulas[k]);
    } else {
      segment["closed_form"] = nullptr;
      segment["closed_form_reason"] = "the curve is not Pythagorean-hodograph";
    }
    json["segments"].push_back(std::move(segment));
  }
}

JsonOutput json_of(const AngleAnswer& answer) {
  const Path& path = answer.path.path;
  const bool is_single = path.segments().size() == 1;
  JsonOutput json = object_with_room(12);
  json["phrame"] = is_single ? "angle/1" : "spline-angle/1";
  if (is_single)
    json["curve"] = curve_json(answer.path);
  else
    json["name"] = answer.path.name;
  if (is_single || answer.reference != Reference::euler_rodrigues)
    json["frame"] = name_of(answer.reference);
  if (answer.up) json["up"] = phrame::json_of(*answer.up);
  add_formulas(json, answer);
  if (const auto* exact = std::get_if<FrameAngle>(&answer.start_angle))
    json["theta0"] = to_string(*exact);
  else
    json["theta0"] = phrame::json_of(std::get<Decimal>(answer.start_angle));
  add_start(json, answer.start);
  add_nearness(json, answer.path.near);
  if (answer.total) {
    json["total"] = phrame::json_of(*answer.total);
    json["closed"] = json_if_known(closure(path).is_closed);
    json["holonomy"] = answer.holonomy ? phrame::json_of(*answer.holonomy) : JsonOutput();
  }
  if (!answer.no_holonomy.empty()) json["holonomy_reason"] = "undecided: " + answer.no_holonomy;
  add_values(json, answer.values, answer.by);
  return json;
}

/// θ′ along what is not PH, or θ′ = 0.
std::string latex_rate(const AngleAnswer& answer) {
  if (answer.is_zero) return "0";
  if (!answer.up) return "-\\frac{|H| \\det(H, H', H'')}{|H \\times H'|^2}";
  std::string text = "-\\frac{(v \\cdot H) \\det(v, H, H')}{|H|\\, |v \\times H|^2},\\quad v = (";
  for (std::size_t k = 0; k < 3; ++k)
    text += (k == 0 ? "" : ", ") + formatted((*answer.up)[k], latex);
  return text + ")";
}

std::string latex_start(const AngleAnswer& answer) {
  if (const auto* exact = std::get_if<FrameAngle>(&answer.start_angle))
    return formatted(*exact, latex);
  return latex_decimal(std::get<Decimal>(answer.start_angle).value);
}

}  // namespace

std::string to_text(const AngleAnswer& answer) {
  std::string text = heading(answer.path) + "\n\n";
  if (const auto ph = ph_path(answer))
    text += ph->is_curve() ? curve_text(answer, ph->segments().front()) : spline_text(answer, *ph);
  else
    text += general_text(answer);
  return answer.values.empty() ? text : text + value_table(answer.values, answer.digits, answer.by);
}

std::string to_latex(const AngleAnswer& answer) {
  std::string text = "\\begin{align*}\n";
  const bool is_single = answer.formulas.size() <= 1;
  const bool is_ph = answer.path.path.has_erf();
  if (!is_ph) text += "\\theta'(t) &= " + latex_rate(answer);
  for (std::size_t k = 0; k < answer.formulas.size(); ++k) {
    if (!answer.formulas[k]) continue;
    const AngleFormula& formula = *answer.formulas[k];
    const std::string index = is_single ? "" : fmt::format("_{{{}}}", k + 1);
    const std::string theta = "\\theta" + index;
    text += fmt::format("{}{}'(t) &= {} \\\\\n{}(t) &= {}", k == 0 && is_ph ? "" : " \\\\\n", theta,
                        formatted_quotient(formula.rate, latex), theta,
                        closed_form(formula, latex, "C" + index));
  }
  const auto* exact = std::get_if<FrameAngle>(&answer.start_angle);
  if (!is_ph || exact == nullptr || !(*exact == FrameAngle()))
    text += fmt::format(" \\\\\n\\theta(0) &= {}", latex_start(answer));
  text += "\n\\end{align*}\n";
  return answer.values.empty() ? text : text + latex_value_table(answer.values, answer.by);
}

std::string to_json(const AngleAnswer& answer) { return pretty(json_of(answer)); }

}  // namespace phrame
