#include "phrame/io/write/angle_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/factor.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/number_text.hpp"
#include "phrame/io/write/pole_table.hpp"
#include "phrame/io/write/radical_form_text.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

constexpr auto unicode = Notation::unicode;
constexpr auto latex = Notation::latex;

std::string quotient(const RationalFunction& f) { return formatted_quotient(f, unicode); }

/// In LaTeX with the constant.
std::string closed_form(const AngleReport& report, Notation notation) {
  constexpr auto line = "\n      ";
  constexpr auto constant = " + C";
  if (report.radicals)
    return notation == unicode ? indented(to_text(*report.radicals), line)
                               : to_latex(*report.radicals, "t", "z", constant);
  std::vector<std::string> terms;
  if (report.real) {
    terms = formatted_terms(*report.real, notation);
  } else {
    terms = formatted_terms(report.angle.twist(), notation);
    if (const auto& g = report.angle.bend())
      terms.push_back(notation == unicode
                          ? "arg g(t), continuous"
                          : fmt::format("\\arg\\left({}\\right)", formatted(*g, latex)));
  }
  return notation == unicode ? formatted_sum(terms, line, unicode)
                             : formatted_sum(terms, " ", latex) + constant;
}

JsonOutput json_of(const AngleReport& report) {
  JsonOutput json = {
      {"phrame", "angle/1"},
      {"curve", {{"name", report.curve.name}, {"degree", degree(report.curve.curve)}}},
      {"frame", report.reference == Reference::erf ? "erf" : "frenet"}};
  if (report.shows_form) {
    json["integrand"] = phrame::json_of(report.angle.rate());
    json["antiderivative"] =
        phrame::json_of(report.angle.antiderivative(), form_name(report.angle.antiderivative()));
  }
  if (report.real) json["real"] = phrame::json_of(*report.real);
  if (report.radicals) json["radicals"] = phrame::json_of(*report.radicals);
  json["theta0"] = to_string(report.start_angle);
  json["values"] = phrame::json_of(report.values);
  return json;
}

}  // namespace

AngleValue rounded_angle(const Rational& t, const Real& theta, long digits) {
  return {t, rounded(theta, "theta at t = " + abbreviated(to_string(t)), digits)};
}

std::string value_table(const std::vector<AngleValue>& values, long digits) {
  constexpr std::size_t longest = 40;
  std::size_t whole_width = 1;
  const auto whole = [](const std::string& theta) {
    return std::min(theta.find('.'), theta.size());
  };
  std::vector<std::string> column{"t"};
  for (const AngleValue& value : values) {
    column.push_back(shown(value.t, longest));
    whole_width = std::max(whole_width, whole(value.theta.value));
  }
  column = aligned(column);
  std::string text = fmt::format("\n  {}   {}θ(t)   radians, correctly rounded to {}\n", column[0],
                                 std::string(whole_width - 1, ' '),
                                 counted(static_cast<std::size_t>(digits), "digit"));
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string& theta = values[k].theta.value;
    text += fmt::format("  {}   {}{}\n", column[k + 1],
                        std::string(whole_width - whole(theta), ' '), theta);
  }
  return text;
}

std::string form_name(const Antiderivative& F) {
  const auto over_poles = std::count_if(F.logs.begin(), F.logs.end(), is_over_poles);
  if (F.logs.empty()) return "rational";
  if (over_poles == static_cast<long>(F.logs.size())) return "partial-fractions";
  if (over_poles > 0) return "mixed";
  const auto is_irreducible = [](const LogSum& sum) {
    return factor(sum.index).factors.size() == 1;
  };
  return std::all_of(F.logs.begin(), F.logs.end(), is_irreducible) ? "rothstein-trager"
                                                                   : "lazard-rioboo-trager";
}

std::string heading(const NamedCurve& named) {
  const long n = degree(named.curve);
  const std::string kind = n == 1   ? "line segment"
                           : n == 3 ? "PH cubic"
                           : n == 5 ? "PH quintic"
                           : n == 7 ? "PH septic"
                                    : "PH curve";
  return fmt::format("{}{}, degree {} (preimage of degree {})", name_prefix(named.name), kind, n,
                     preimage_degree(named.curve));
}

std::string note_on_sign(const Curve& curve) {
  const Signs signs = multiplier_signs(curve);
  if (!signs.negative) return "";
  return fmt::format("f < 0 {}: there e₁ = A i A*/σ is −r′/|r′|",
                     signs.positive ? "in a part of [0, 1]" : "on [0, 1]");
}

std::string to_text(const AngleReport& report) {
  const QuaternionPolynomial& preimage = report.curve.curve.preimage();
  const bool erf = report.reference == Reference::erf;
  std::string text = heading(report.curve) + "\n\n";
  text += fmt::format("  σ = {}\n  h = {}\n", readable_factors(sigma(preimage)),
                      readable_factors(twist_numerator(preimage)));
  if (!erf) {
    text += fmt::format("  g = {}\n", phrame::readable(bend_numerator(preimage)));
  }
  for (const Interval& cusp : cusps(report.curve.curve, closed(0, 1)))
    text += fmt::format("  r′ = 0 at {}: frames and angle are continued through\n",
                        place_of_root(cusp));
  if (const std::string note = note_on_sign(report.curve.curve); !note.empty())
    text += fmt::format("  {}\n", note);
  if (!erf)
    for (const Interval& flip : normal_flips(preimage, closed(0, 1)))
      text += fmt::format("  inflection at {}: (n, b) flip there, the angle is continued through\n",
                          place_of_root(flip));
  text += fmt::format(
      "\nThe rotation-minimizing frame is the {} frame turned by θ about the tangent:\n"
      "  f₂ = cos θ {} + sin θ {},  f₃ = −sin θ {} + cos θ {},  θ(0) = {}\n\n",
      erf ? "Euler–Rodrigues" : "Frenet", erf ? "e₂" : "n", erf ? "e₃" : "b", erf ? "e₂" : "n",
      erf ? "e₃" : "b", shown(report.start_angle));
  text += fmt::format("  θ′ = {} = {}\n", erf ? "−2h/σ" : "−2h/σ + Im(g′/g)",
                      quotient(report.angle.rate()));
  const std::string form = closed_form(report, unicode);
  text += fmt::format("  θ  = {}{}\n", form, form == "0" ? "" : "\n      + constant");
  text += "  Checked: the derivative of this θ is θ′, exactly.\n";
  if (!report.real && !report.radicals)
    text += pole_table(report.angle.twist(), report.lists_all_poles);
  if (!report.values.empty()) text += value_table(report.values, report.digits);
  return text;
}

std::string to_latex(const AngleReport& report) {
  std::string text = fmt::format(
      "\\begin{{align*}}\n\\theta'(t) &= {} \\\\\n\\theta(t) &= {}{}\n"
      "\\end{{align*}}\n",
      formatted_quotient(report.angle.rate(), latex), closed_form(report, latex),
      report.start_angle == Angle()
          ? ""
          : fmt::format(" \\\\\n\\theta(0) &= {}", formatted(report.start_angle, latex)));
  if (report.values.empty()) return text;
  text += "\\begin{tabular}{ll}\n$t$ & $\\theta(t)$ \\\\\n";
  for (const AngleValue& value : report.values)
    text += fmt::format("${}$ & ${}$ \\\\\n", formatted(value.t, latex),
                        latex_decimal(value.theta.value));
  return text + "\\end{tabular}\n";
}

std::string to_json(const AngleReport& report) { return pretty(json_of(report)); }

std::string to_json_line(const AngleReport& report) { return json_of(report).dump(); }

}  // namespace phrame
