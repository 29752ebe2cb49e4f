#include "phrame/io/cas_script.hpp"

#include <fmt/format.h>

#include "phrame/io/radical_form_text.hpp"

namespace phrame {
namespace {

struct Definition {
  std::string_view name;
  std::string formula;
  bool of_variable = true;
};

std::string statement(const Definition& definition, Language language, std::string_view variable) {
  const auto& [name, formula, of_variable] = definition;
  switch (language) {
    case Language::maple:
      return fmt::format("{} := {}:\n", name, formula);
    case Language::maxima:
      return fmt::format("{}: {}$\n", name, formula);
    case Language::mathematica:
      return fmt::format("{} = {};\n", name, formula);
    case Language::pari:
      return of_variable ? fmt::format("{}({}) = {};\n", name, variable, formula)
                         : fmt::format("{} = {};\n", name, formula);
    default:
      return fmt::format("{} = {}\n", name, formula);
  }
}

/// log|x| has a derivative only where x is known to be real.
std::string script(const std::vector<Definition>& definitions, Language language,
                   const std::string& variable, bool is_real) {
  std::string text;
  if (language == Language::sympy)
    text =
        fmt::format(fmt::runtime(is_real ? "from sympy import *\n{0} = symbols('{0}', real=True)\n"
                                           "{1} = symbols('{1}')\n"
                                         : "from sympy import *\n{0}, {1} = symbols('{0} {1}')\n"),
                    variable, variable == "z" ? "w" : "z");
  for (const Definition& definition : definitions)
    text += statement(definition, language, variable);
  return text;
}

const RadicalNotation& radical_notation_of(Language language) {
  switch (language) {
    case Language::sympy:
      return radical_notation::sympy;
    case Language::mathematica:
      return radical_notation::mathematica;
    case Language::maxima:
      return radical_notation::maxima;
    case Language::pari:
      return radical_notation::pari;
    default:
      return radical_notation::maple;
  }
}

std::string closed_form(const Antiderivative& F, const std::optional<RealForm>& real,
                        const std::optional<RadicalForm>& radicals, Language language,
                        const std::string& variable) {
  if (real) return cas_formula(*real, language, variable);
  if (!radicals) return cas_formula(F, language, variable);
  const std::string rest =
      cas_formula(Antiderivative{radicals->polynomial, radicals->rational, {}}, language, variable);
  if (radicals->logs.empty()) return rest;
  const std::string logs = to_cas(radicals->logs, radical_notation_of(language), variable);
  return rest == "0" ? logs : fmt::format("{} + ({})", rest, logs);
}

}  // namespace

std::string to_script(const IntegralReport& report, Language language) {
  const std::string t = cas_variable(report.integrand.variable);
  std::vector<Definition> definitions{
      {"integrand", cas_formula(report.integrand.value, language, t)},
      {"antiderivative",
       closed_form(report.antiderivative, report.real, report.radicals, language, t)}};
  if (const auto& definite = report.definite)
    definitions.push_back({"definite",
                           definite->exact ? cas_formula(*definite->exact, language)
                                           : cas_formula(definite->value, language),
                           false});
  // Maxima reads a number with as many digits as are asked for before.
  const bool has_digits = report.definite && !report.definite->exact;
  if (language == Language::maxima && has_digits && report.digits > 16)
    definitions.insert(definitions.begin(), {"fpprec", std::to_string(report.digits), false});
  return script(definitions, language, t, report.real.has_value());
}

std::string to_script(const AngleReport& report, Language language) {
  return script({{"integrand", cas_formula(report.angle.rate(), language, "t")},
                 {"antiderivative", closed_form(report.angle.antiderivative(), report.real,
                                                report.radicals, language, "t")}},
                language, "t", report.real.has_value());
}

}  // namespace phrame
