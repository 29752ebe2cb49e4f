#include "phrame/io/write/cas_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/io/write/radical_form_text.hpp"

namespace phrame::inline v0 {
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

/// Does an argument of a logarithm cross the cut for real t? One of degree 1 is written as t − z,
/// which is real or stays in a half plane.
bool may_jump(const LogSum& sum) {
  return sum.argument.degree() > 1 && count_real_roots(sum.index, real_line()) < sum.index.degree();
}

/// log₂|x| for x ≠ 0, as doubles have it.
double log2_of(const Rational& x) {
  const long e = binary_exponent(abs(x));
  return static_cast<double>(e) + std::log2(static_cast<double>(abs(x) * power_of_two(-e)));
}

constexpr double log2_of_zero = -std::numeric_limits<double>::infinity();

/// log₂ Σ 2ˣ.
double log2_of_sum(const std::vector<double>& list) {
  const double largest = list.empty() ? log2_of_zero : *std::max_element(list.begin(), list.end());
  if (largest == log2_of_zero) return largest;
  double sum = 0;
  for (const double x : list) sum += std::exp2(x - largest);
  return largest + std::log2(sum);
}

/// log₂ Σ|pₖ|rᵏ.
double log2_of_size(const Polynomial& p, double log2_of_r) {
  std::vector<double> terms;
  for (long k = 0; k <= p.degree(); ++k)
    if (const Rational c = p.coefficient(k); c != 0)
      terms.push_back(log2_of(c) + (k == 0 ? 0 : static_cast<double>(k) * log2_of_r));
  return log2_of_sum(terms);
}

/// log₂ of Cauchy's bound for the roots of q: the r > 0 with |qₙ|rⁿ = Σ|qₖ|rᵏ, k < n.
double log2_of_root_bound(const Polynomial& q) {
  const long n = q.degree();
  double least = log2_of_zero;  // where one of the terms on the right reaches that on the left
  for (long k = 0; k < n; ++k)
    if (const Rational c = q.coefficient(k); c != 0)
      least = std::max(least, log2_of(c / q.leading_coefficient()) / static_cast<double>(n - k));
  if (least == log2_of_zero) return least;
  double greatest = least + 1;  // there the right is at most 1/2 + 1/4 + … of the left
  const Polynomial lower = q - Polynomial::monomial(q.leading_coefficient(), n);
  for (int step = 0; step < 40; ++step) {
    const double middle = (least + greatest) / 2;
    const bool is_enough = log2_of_size(lower, middle) <=
                           log2_of(q.leading_coefficient()) + static_cast<double>(n) * middle;
    (is_enough ? greatest : least) = middle;
  }
  return greatest;
}

/// log₂ of the least |w(z)| at a root z of q, to which w is coprime.
double log2_of_least_value(const Polynomial& w, const Polynomial& q) {
  if (w.is_constant()) return log2_of(w.coefficient(0));
  constexpr long first_bits = 128;
  Roots roots = isolate_roots(q, first_bits);
  for (long bits = first_bits;; bits *= 2, refine(q, roots, bits)) {
    std::optional<Rational> least;
    const auto include = [&](const ComplexBall& z) {
      const Rational size = absolute(evaluate(w, z, bits), bits).lower();
      if (!least || size < *least) least = size;
    };
    for (const RealBall& z : roots.real) include({z, {}});
    for (const ComplexBall& z : roots.upper) include(z);
    if (*least > 0) return log2_of(*least);
  }
}

/// How many decimal digits are lost where the sum is computed in floating point, about. The error
/// of a term pₖzᵏ is about k ε of it, that of adding n terms n ε of their sizes: at most 2n ε
/// Σ|pₖ|rᵏ for |z| ≤ r, Cauchy's bound; a root z that is off by ε|z| changes p(z) by half as much.
/// This n times, for each root. The logarithms count as of the size of 1, and their arguments as
/// of that of their leading coefficient, which they have or more but near a pole.
double digits_lost(const LogSum& sum) {
  const long n = sum.index.degree();
  if (n == 1) return 0;  // it is written without a root
  const double r = log2_of_root_bound(sum.index);
  double bits = log2_of_size(sum.residue, r);
  if (!is_over_poles(sum)) {
    std::vector<double> sizes;
    for (const Polynomial& c : sum.argument.coefficients()) sizes.push_back(log2_of_size(c, r));
    const Polynomial& lead = sum.argument.coefficients().back();
    bits += std::max(0.0, log2_of_sum(sizes) - log2_of_least_value(lead, sum.index));
  }
  return std::log10(2.0) * (bits + std::log2(3.0 * static_cast<double>(n * n)));
}

double digits_lost(const std::vector<LogSum>& sums) {
  double most = 0;
  for (const LogSum& sum : sums) most = std::max(most, digits_lost(sum));
  return most;
}

/// Is it written in real functions, on the command line's demand?
bool is_real(const OtherForm& form) { return std::holds_alternative<RealForm>(form); }

/// A closed form in its style; what it says of the jumps that a form has by nature.
struct ClosedForm {
  std::string formula;
  double digits_lost = 0;  ///< in its sums over roots
  std::string warning = {};
};

ClosedForm closed_form(const Antiderivative& F, const OtherForm& other, Language language,
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
  if (const auto* real = std::get_if<RealForm>(&other))
    return {cas_formula(*real, language, variable), digits_lost(real->others)};
  if (const auto* textbook = std::get_if<TextbookForm>(&other)) {
    const std::vector<LogSum> sums = sums_over_poles(*textbook);
    return {cas_formula(textbook->real, sums, language, variable), digits_lost(sums)};
  }
  const auto* radicals = std::get_if<RadicalForm>(&other);
  if (!radicals)
    return {cas_formula(F, language, variable), digits_lost(F.logs),
            jumps(F.logs, [](const LogSum& sum) { return sum; })};
  const std::string rest =
      cas_formula(Antiderivative{radicals->polynomial, radicals->rational, {}}, language, variable);
  if (radicals->logs.empty()) return {rest};
  const std::string logs = to_cas(radicals->logs, radical_notation_of(language), variable);
  return {rest == "0" ? logs : fmt::format("{} + ({})", rest, logs), 0,
          jumps(radicals->logs, [](const RadicalSum& sum) { return sum.sum; })};
}

/// What makes PARI compute so many digits, or 20 where these are less; nothing where it does by
/// default.
std::string precision_for_pari(double digits_lost, long digits) {
  constexpr long default_digits = 38;
  constexpr long enough = 20;
  const long lost = static_cast<long>(std::ceil(digits_lost));
  const long kept = std::max(digits, enough);
  if (lost + enough <= default_digits) return "";
  return comment(
             fmt::format("the sums over roots lose up to {} digits; {} are to stay", lost, kept),
             Language::pari) +
         fmt::format("if(default(realprecision) < {0}, default(realprecision, {0}));\n",
                     lost + kept);
}

}  // namespace

std::string to_script(const IntegralAnswer& answer, Language language) {
  const std::string t = cas_variable(answer.variable);
  const ClosedForm closed = closed_form(answer.antiderivative, answer.other, language, t);
  std::vector<Definition> definitions{{"integrand", cas_formula(answer.integrand, language, t)},
                                      {"antiderivative", closed.formula}};
  if (const auto& definite = answer.definite)
    definitions.push_back({"definite",
                           definite->exact ? cas_formula(*definite->exact, language)
                                           : cas_formula(definite->value, language),
                           false});
  // Neither computes with as many digits as a number has that it reads.
  const bool has_digits = answer.definite && !answer.definite->exact;
  if (language == Language::maxima && has_digits && answer.digits > 16)
    definitions.insert(definitions.begin(), {"fpprec", std::to_string(answer.digits), false});
  const std::string text = script(definitions, language, t, is_real(answer.other), closed.warning);
  if (language != Language::pari) return text;
  const std::string precision =
      precision_for_pari(closed.digits_lost, has_digits ? answer.digits : 0);
  if (!precision.empty()) return precision + text;
  constexpr long default_digits = 38;
  if (!has_digits || answer.digits <= default_digits) return text;
  return comment(
             fmt::format("default(realprecision, {}) shows all digits of definite, and computes "
                         "antiderivative to as many",
                         answer.digits),
             language) +
         text;
}

std::string to_script(const AngleAnswer& answer, Language language) {
  const AngleFormula& formula = *answer.formulas.front();
  const ClosedForm closed = closed_form(formula.antiderivative, formula.other, language, "t");
  const std::string text = script(
      {{"integrand", cas_formula(formula.rate, language, "t")}, {"antiderivative", closed.formula}},
      language, "t", is_real(formula.other), closed.warning);
  return language == Language::pari ? precision_for_pari(closed.digits_lost, 0) + text : text;
}

}  // namespace phrame
