#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/answer/integral.hpp"
#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/endpoint_text.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/pole_table.hpp"
#include "phrame/io/write/radical_form_text.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

using enum Notation;

std::string closed_form(const IntegralAnswer& answer, Notation notation, std::string_view before) {
  const Letters letters = letters_for(answer.variable, notation);
  const auto written = [&](const auto& F) {
    return formatted_sum(formatted_terms(F, notation, letters), before, notation);
  };
  if (const auto* real = std::get_if<RealForm>(&answer.other)) return written(*real);
  const auto* textbook = std::get_if<TextbookForm>(&answer.other);
  return textbook ? written(*textbook) : written(answer.antiderivative);
}

std::string text_form(const IntegralAnswer& answer) {
  constexpr auto line = "\n      ";
  const auto* radicals = std::get_if<RadicalForm>(&answer.other);
  if (!radicals) return closed_form(answer, unicode, line);
  const Letters letters = letters_for(answer.variable, unicode);
  return indented(to_text(*radicals, letters.variable, letters.pole), line);
}

std::string latex_form(const IntegralAnswer& answer) {
  const auto* radicals = std::get_if<RadicalForm>(&answer.other);
  if (!radicals) return with_constant(closed_form(answer, latex, " "), "C");
  const Letters letters = letters_for(answer.variable, latex);
  return to_latex(*radicals, letters.variable, letters.pole, "C");
}

/// Why the sums over roots are what they are.
std::string reason_for_sums(const Antiderivative& F) {
  const std::string name = form_name(F);
  if (name == "partial-fractions") return "a sum over poles, since the residues are distinct";
  if (name == "rothstein-trager") return "a sum over residues, since residues repeat";
  return "over poles where the residues are distinct, over residues where they repeat";
}

template <class C>
bool is_biquadratic(const SurdSum<C>& x) {
  return field_of(x).radicands().size() > 2;
}

/// The fields of its numbers.
std::string fields_of(const RealForm& form) {
  const auto any = [](const auto& terms, const auto& is) {
    return std::any_of(terms.begin(), terms.end(), is);
  };
  const bool some_are_biquadratic =
      any(form.logarithms, [](const auto& log) { return is_biquadratic(log.of); }) ||
      any(form.arctangents, [](const auto& term) { return is_biquadratic(term.of); }) ||
      any(form.quotients, [](const auto& term) {
        return is_biquadratic(term.of) || is_biquadratic(term.radicand);
      });
  return some_are_biquadratic ? "quadratic or biquadratic fields" : "quadratic fields";
}

/// Why the logarithms are written as they are, where nobody asked for a form.
std::string reason_for_form(const TextbookForm& F) {
  const RealForm& real = F.real;
  if (!F.sums.empty()) {
    const std::string reason = reason_for_sums(Antiderivative{{}, {}, F.sums});
    const bool is_mixed =
        !(real.logarithms.empty() && real.arctangents.empty() && real.quotients.empty());
    return is_mixed ? "real functions as far as " + fields_of(real) + " reach; else " + reason
                    : reason;
  }
  if (!real.arctangents.empty())
    return "real functions, since residues or poles lie in " + fields_of(real);
  if (!real.quotients.empty() ||
      std::any_of(real.logarithms.begin(), real.logarithms.end(), [](const auto& log) {
        return !log.factor.is_rational() || !log.of.is_rational();
      }))
    return "real logarithms, since residues or poles lie in " + fields_of(real);
  return real.logarithms.empty()
             ? "no logarithms, since every residue is 0"
             : "logarithms of polynomials over ℚ, since every residue is rational";
}

/// `text` in lines of at most 100 digits, the later ones indented by `indent`.
std::string wrapped(const std::string& text, std::size_t indent) {
  constexpr std::size_t width = 100;
  std::string lines;
  for (std::size_t k = 0; k < text.size(); k += width)
    lines += (k == 0 ? "" : "\n" + std::string(indent, ' ')) + text.substr(k, width);
  return lines;
}

std::string value_text(const DefiniteValue& definite, const IntegralAnswer& answer) {
  std::string text = fmt::format("\n  {}∫ f d{} from {} to {}\n",
                                 definite.principal_value ? "principal value of " : "",
                                 answer.variable, to_text(definite.from), to_text(definite.to));
  const bool is_decimal = definite.value.radius == "0";
  if (definite.exact) {
    const std::string exact =
        formatted_sum(formatted_terms(*definite.exact, unicode), " ", unicode);
    if (is_decimal && exact == shown(definite.value))
      return text + fmt::format("    = {}\n", exact);
    text += fmt::format("    = {}\n", readable_exact(exact));
  }
  return text + fmt::format("    {} {}\n    {} to {}\n", is_decimal ? "=" : "≈",
                            with_minus_sign(wrapped(definite.value.value, 6)), "correctly rounded",
                            counted(static_cast<std::size_t>(answer.digits), "digit"));
}

}  // namespace

std::string to_text(const IntegralAnswer& answer, bool says_checked) {
  const std::string& x = answer.variable;
  const RationalFunction& f = answer.integrand;
  const std::string form = text_form(answer);
  std::string text = fmt::format("  f  = {}\n  ∫f = {}\n", formatted_quotient(f, unicode, x),
                                 form == "0" ? "constant" : form + "\n      + constant");
  if (says_checked) text += "  Checked: the derivative of this ∫f is f, exactly.\n";
  if (const auto* textbook = std::get_if<TextbookForm>(&answer.other))
    text += fmt::format("  Form: {}.\n", reason_for_form(*textbook));
  if (answer.poles) text += to_text(*answer.poles);
  if (answer.definite) text += value_text(*answer.definite, answer);
  return text;
}

std::string to_latex(const IntegralAnswer& answer) {
  const std::string x = letters_for(answer.variable, latex).variable;
  const std::string f = formatted_quotient(answer.integrand, latex, x);
  std::string text =
      fmt::format("\\begin{{align*}}\n\\int {} \\,d{} &= {}", f, x, latex_form(answer));
  if (const auto& definite = answer.definite) {
    const std::string decimal = latex_decimal(definite->value.value);
    const auto relation = definite->value.radius == "0" ? "=" : "\\approx";
    text += fmt::format(
        " \\\\\n{}\\int_{{{}}}^{{{}}} {} \\,d{} &{} {}",
        definite->principal_value ? "\\operatorname{p.v.} " : "", to_latex(definite->from),
        to_latex(definite->to), f, x, definite->exact ? "=" : relation,
        definite->exact ? formatted_sum(formatted_terms(*definite->exact, latex), " ", latex)
                        : decimal);
    if (definite->exact) text += fmt::format(" {} {}", relation, decimal);
  }
  return text + "\n\\end{align*}\n";
}

std::string to_json(const IntegralAnswer& answer) {
  JsonOutput json = {{"phrame", "integral/1"},
                     {"variable", answer.variable},
                     {"integrand", json_of(answer.integrand)},
                     {"antiderivative", json_of(answer.antiderivative)}};
  add_other_form(json, answer.other);
  if (const auto& definite = answer.definite) {
    json["definite"] = {{"from", json_of(definite->from)},
                        {"to", json_of(definite->to)},
                        {"principal_value", definite->principal_value},
                        {"value", definite->value.value},
                        {"radius", definite->value.radius}};
    if (definite->exact) json["definite"]["exact"] = cas_formula(*definite->exact, Language::plain);
    if (definite->exact && definite->exact->irrational_pi)
      json["definite"]["multiple_of_pi"] = json_of(*definite->exact->irrational_pi);
  }
  return pretty(json);
}

}  // namespace phrame
