#include "phrame/io/cas_script.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/sturm.hpp"
#include "phrame/io/radical_form_text.hpp"

namespace phrame {
namespace {

struct Definition {
  std::string_view name;
  std::string formula;
  bool of_variable = true;
};

/// Python reads no integer of more than 4300 decimal digits, but hexadecimal ones of any length
/// (sys.get_int_max_str_digits()). What is quoted stays.
std::string for_python(const std::string& formula) {
  constexpr std::size_t limit = 4300;
  constexpr std::string_view decimal = "0123456789";
  std::string text;
  std::size_t end = 0;
  while (end < formula.size()) {
    const std::size_t begin = end;
    if (formula[begin] == '\'') {
      end = formula.find('\'', begin + 1) + 1;
      text += formula.substr(begin, end - begin);
    } else if (decimal.find(formula[begin]) == std::string_view::npos) {
      end = std::min(formula.find_first_of("'0123456789", begin), formula.size());
      text += formula.substr(begin, end - begin);
    } else {
      end = std::min(formula.find_first_not_of(decimal, begin), formula.size());
      const std::string digits = formula.substr(begin, end - begin);
      text += digits.size() > limit ? "0x" + Integer(digits).str(16) : digits;
    }
  }
  return text;
}

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
    case Language::sympy:
      return fmt::format("{} = {}\n", name, for_python(formula));
    default:
      return fmt::format("{} = {}\n", name, formula);
  }
}

std::string comment(std::string_view text, Language language) {
  switch (language) {
    case Language::mathematica:
      return fmt::format("(* {} *)\n", text);
    case Language::maxima:
      return fmt::format("/* {} */\n", text);
    case Language::pari:
      return fmt::format("\\\\ {}\n", text);
    default:
      return fmt::format("# {}\n", text);
  }
}

/// log|x| has a derivative only where x is known to be real.
std::string script(const std::vector<Definition>& definitions, Language language,
                   const std::string& variable, bool is_real, const std::string& warning) {
  std::string text;
  if (language == Language::sympy)
    text =
        fmt::format(fmt::runtime(is_real ? "from sympy import *\n{0} = symbols('{0}', real=True)\n"
                                           "{1} = symbols('{1}')\n"
                                         : "from sympy import *\n{0}, {1} = symbols('{0} {1}')\n"),
                    variable, variable == "z" ? "w" : "z");
  for (const Definition& definition : definitions)
    text += statement(definition, language, variable);
  if (!warning.empty()) text += comment(warning, language);
  return text;
}

/// Does an argument of a logarithm cross the cut for real t? One of degree 1 is t − z, which is
/// real or stays in a half plane.
bool may_jump(const LogSum& sum) {
  return sum.argument.degree() > 1 && count_real_roots(sum.index, real_line()) < sum.index.degree();
}

/// A report's closed form in its style; what it says of the jumps that a form has by nature.
struct ClosedForm {
  std::string formula;
  std::string warning = {};
};

template <class Report>
ClosedForm closed_form(const Antiderivative& F, const Report& report, Language language,
                       const std::string& variable) {
  constexpr auto warning =
      "the logarithms may cross their cut, where antiderivative jumps; with --form auto or real it "
      "is continuous";
  const auto jumps = [&](const auto& logs, const auto& sum_of) {
    return std::any_of(logs.begin(), logs.end(),
                       [&](const auto& log) { return may_jump(sum_of(log)); })
               ? warning
               : "";
  };
  if (report.real) return {cas_formula(*report.real, language, variable)};
  if (report.textbook) return {cas_formula(*report.textbook, language, variable)};
  if (!report.radicals)
    return {cas_formula(F, language, variable),
            jumps(F.logs, [](const LogSum& sum) { return sum; })};
  const RadicalForm& radicals = *report.radicals;
  const std::string rest =
      cas_formula(Antiderivative{radicals.polynomial, radicals.rational, {}}, language, variable);
  if (radicals.logs.empty()) return {rest};
  const std::string logs = to_cas(radicals.logs, radical_notation_of(language), variable);
  return {rest == "0" ? logs : fmt::format("{} + ({})", rest, logs),
          jumps(radicals.logs, [](const RadicalSum& sum) { return sum.sum; })};
}

}  // namespace

std::string to_script(const IntegralReport& report, Language language) {
  const std::string t = cas_variable(report.integrand.variable);
  const ClosedForm closed = closed_form(report.antiderivative, report, language, t);
  std::vector<Definition> definitions{
      {"integrand", cas_formula(report.integrand.value, language, t)},
      {"antiderivative", closed.formula}};
  if (const auto& definite = report.definite)
    definitions.push_back({"definite",
                           definite->exact ? cas_formula(*definite->exact, language)
                                           : cas_formula(definite->value, language),
                           false});
  // Neither computes with as many digits as a number has that it reads.
  const bool has_digits = report.definite && !report.definite->exact;
  if (language == Language::maxima && has_digits && report.digits > 16)
    definitions.insert(definitions.begin(), {"fpprec", std::to_string(report.digits), false});
  const std::string text =
      script(definitions, language, t, report.real.has_value(), closed.warning);
  constexpr long default_digits = 38;
  if (language != Language::pari || !has_digits || report.digits <= default_digits) return text;
  return comment(
             fmt::format("default(realprecision, {}) shows all digits of definite, and computes "
                         "antiderivative to as many",
                         report.digits),
             language) +
         text;
}

std::string to_script(const AngleReport& report, Language language) {
  const ClosedForm closed = closed_form(report.angle.antiderivative(), report, language, "t");
  return script({{"integrand", cas_formula(report.angle.rate(), language, "t")},
                 {"antiderivative", closed.formula}},
                language, "t", report.real.has_value(), closed.warning);
}

}  // namespace phrame
