#include "phrame/io/write/closed_form.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/surd_root.hpp"
#include "phrame/io/write/algebraic_text.hpp"
#include "phrame/io/write/root_term.hpp"

namespace phrame::inline v0 {
namespace {

using enum Notation;

constexpr auto next_line = "\n        ";

std::string shown(const Polynomial& p, Notation notation, std::string_view variable) {
  std::string text = formatted(p, notation, variable);
  return notation == unicode ? readable(std::move(text), p) : text;
}

std::string shown(const Bivariate& v, Notation notation, const Letters& letters) {
  return notation == unicode ? readable(v, letters.variable, letters.residue)
                             : formatted(v, latex, letters.variable, letters.residue);
}

std::string shown(const SurdPolynomial& p, Notation notation, std::string_view variable) {
  return notation == unicode ? readable(p, variable) : formatted(p, latex, variable);
}

std::string shown_factors(const Polynomial& p, Notation notation, std::string_view variable) {
  return notation == unicode ? readable_factors(p, variable)
                             : formatted_factors(p, notation, variable);
}

bool is_monomial(const Polynomial& p) {
  return p == Polynomial::monomial(p.leading_coefficient(), std::max(0L, p.degree()));
}

/// factor · function, where the function is written `text`.
std::string product(const Radical& factor, std::string_view text, Notation notation) {
  const RadicalNotation& numbers =
      notation == unicode ? radical_notation::unicode : radical_notation::latex;
  const bool negative = is_written_negative(factor);
  const Radical size = negative ? -factor : factor;
  return fmt::format(
      "{}{}{}", negative ? numbers.minus : "",
      size == Radical(1) ? "" : formatted_factor(size, numbers) + std::string(numbers.dot), text);
}

std::string product(const Surd& factor, std::string_view text, Notation notation) {
  if (factor.count_roots() > 1) return product(to_radical(factor), text, notation);
  if (factor == Surd(1)) return std::string(text);
  const std::string minus = notation == unicode ? "−" : "-";
  if (factor == Surd(-1)) return minus + std::string(text);
  std::string number = formatted(factor, notation);
  if (factor.terms().size() > 1) number = in_parentheses(number, notation);
  return number + (notation == unicode ? "·" : " ") + std::string(text);
}

std::string log(const std::string& of, Notation notation) {
  return (notation == unicode ? "log" : "\\log") + in_parentheses(of, notation);
}

std::string log_of_size(const std::string& of, Notation notation) {
  return fmt::format(fmt::runtime(notation == unicode ? "log|{}|" : "\\log\\left|{}\\right|"), of);
}

std::string arctan(const std::string& of, Notation notation) {
  return (notation == unicode ? "arctan" : "\\arctan") + in_parentheses(of, notation);
}

std::string unicode_sum(const LogSum& sum, const Letters& letters) {
  const auto& [t, z, x] = letters;
  const long roots = sum.index.degree();
  if (is_over_poles(sum))
    return fmt::format("Σ c({2})·log({0} − {2}) over the {1} roots {2} of {3}{4}c({2}) = {5}", t,
                       roots, z, shown(sum.index, unicode, z), next_line,
                       shown(sum.residue, unicode, z));
  const bool plain = sum.residue == Polynomial{0, 1};
  return fmt::format(
      "Σ {0}·log v({1}, {2}) over the {3} roots {1} of {4}{5}{6}v({1}, {2}) = {7}",
      plain ? x : fmt::format("c({})", x), x, t, roots, shown(sum.index, unicode, x),
      plain ? "" : fmt::format("{}c({}) = {}", next_line, x, shown(sum.residue, unicode, x)),
      next_line, shown(sum.argument, unicode, letters));
}

std::string latex_sum(const LogSum& sum, const Letters& letters) {
  const bool over_poles = is_over_poles(sum);
  const std::string& index = over_poles ? letters.pole : letters.residue;
  const std::string head =
      fmt::format("\\sum_{{{} = 0}} \\left({}\\right) ", formatted(sum.index, latex, index),
                  formatted(sum.residue, latex, index));
  return head + (over_poles ? fmt::format("\\log({} - {})", letters.variable, index)
                            : log(shown(sum.argument, latex, letters), latex));
}

std::string formatted_term(const LogSum& sum, Notation notation, const Letters& letters) {
  if (sum.index.degree() == 1) {  // a rational residue and a rational argument
    const QuotientRing ring(sum.index);
    return product(Surd(ring.reduce(sum.residue).coefficient(0)),
                   log(shown(ring.reduce(sum.argument), notation, letters), notation), notation);
  }
  return notation == unicode ? unicode_sum(sum, letters) : latex_sum(sum, letters);
}

/// c(z)·log|t − z| of the real poles and twice the real part of that of the upper ones.
std::vector<std::string> real_terms(const LogSum& sum, Notation notation, const Letters& letters) {
  const auto& [t, z, unused] = letters;
  const long real = count_real_roots(sum.index, real_line());
  const long upper = (sum.index.degree() - real) / 2;
  const std::string q = shown(sum.index, notation, z);
  const std::string c = shown(sum.residue, notation, z);
  const auto roots = [](long count, std::string_view kind) {
    return count == 1 ? fmt::format("the {}root", kind)
                      : fmt::format("the {} {}roots", count, kind);
  };
  std::vector<std::string> terms;
  if (notation == latex) {
    if (real > 0)
      terms.push_back(
          fmt::format("\\sum_{{{0} = 0,\\ {1} \\in \\mathbb{{R}}}} \\left({2}\\right) "
                      "\\log\\left|{3} - {1}\\right|",
                      q, z, c, t));
    if (upper > 0)
      terms.push_back(fmt::format(
          "\\sum_{{{0} = 0,\\ \\operatorname{{Im}} {1} > 0}} \\left("
          "\\operatorname{{Re}}\\left({2}\\right) \\log\\left|{3} - {1}\\right|^{{2}} - "
          "2 \\operatorname{{Im}}\\left({2}\\right) "
          "\\arctan\\frac{{{3} - \\operatorname{{Re}} {1}}}{{\\operatorname{{Im}} {1}}}\\right)",
          q, z, c, t));
    return terms;
  }
  const std::string where = fmt::format("{}c({}) = {}", next_line, z, c);
  if (real > 0)
    terms.push_back(fmt::format("Σ c({0})·log|{1} − {0}| over {2} {0} of {3}{4}", z, t,
                                roots(real, "real "), q, where));
  if (upper > 0)
    terms.push_back(
        fmt::format("Σ (Re c({0})·log|{1} − {0}|² − 2·Im c({0})·arctan(({1} − Re {0})/Im {0}))"
                    "{2}over {3} {0} of {4} with Im {0} > 0{5}",
                    z, t, next_line, roots(upper, ""), q, where));
  return terms;
}

RootTerm root_term(const auto& term, Notation notation, const Letters& letters) {
  return written(term, letters.variable,
                 notation == unicode ? radical_notation::unicode : radical_notation::latex);
}

std::string formatted_term(const RealForm::Arctangent& term, Notation notation,
                           const Letters& letters) {
  if (term.radicand == Surd(1))
    return product(term.factor, arctan(shown(term.of, notation, letters.variable), notation),
                   notation);
  const auto [factor, argument] = root_term(term, notation, letters);
  return product(factor, arctan(argument, notation), notation);
}

std::string formatted_term(const RealForm::LogQuotient& term, Notation notation,
                           const Letters& letters) {
  const auto [factor, argument] = root_term(term, notation, letters);
  return product(factor, log_of_size(argument, notation), notation);
}

template <class F>
std::vector<std::string> algebraic_terms(const F& f, Notation notation, const Letters& letters) {
  std::vector<std::string> terms;
  if (!f.polynomial.is_zero()) terms.push_back(shown(f.polynomial, notation, letters.variable));
  if (!f.rational.is_zero())
    terms.push_back(formatted_quotient(f.rational, notation, letters.variable));
  return terms;
}

/// "θ" and the like for LaTeX, which knows the Greek letters by their names.
std::string latex_name(const std::string& variable) {
  static constexpr std::pair<std::string_view, std::string_view> greek[] = {
      {"α", "alpha"},  {"β", "beta"},  {"γ", "gamma"}, {"δ", "delta"},   {"ε", "varepsilon"},
      {"ζ", "zeta"},   {"η", "eta"},   {"θ", "theta"}, {"ι", "iota"},    {"κ", "kappa"},
      {"λ", "lambda"}, {"μ", "mu"},    {"ν", "nu"},    {"ξ", "xi"},      {"π", "pi"},
      {"ρ", "rho"},    {"σ", "sigma"}, {"τ", "tau"},   {"υ", "upsilon"}, {"φ", "varphi"},
      {"χ", "chi"},    {"ψ", "psi"},   {"ω", "omega"}};
  if (variable.size() == 1) return variable;
  for (const auto& [letter, name] : greek)
    if (variable == letter) return fmt::format("\\{}", name);
  std::string escaped;
  for (const char c : variable) escaped += c == '_' ? "\\_" : std::string(1, c);
  return fmt::format("\\mathit{{{}}}", escaped);
}

}  // namespace

Letters letters_for(const std::string& variable, Notation notation) {
  return {notation == latex ? latex_name(variable) : variable, variable == "z" ? "w" : "z",
          variable == "x" ? "y" : "x"};
}

// A squarefree polynomial is at least as long in factors as its longest coefficient is without:
// from ‖∏ b‖ ≤ ∏ (1 + deg b)·‖b‖ its digits are no more than those of the coefficients and
// exponents that the factors show. So what has a coefficient that no line can bear need not be
// factored.
std::string readable_factors(const Polynomial& p, std::string_view variable) {
  const std::string plain = formatted(p, unicode, variable);
  if (plain.size() > 100'000 && is_squarefree(p)) {
    long digits = 0;
    for (const Rational& c : primitive_part(p).coefficients())
      digits = std::max(digits, static_cast<long>(abs(numerator(c)).str().size()));
    if (digits > 250) return readable(plain, p);
  }
  std::string text = formatted_factors(p, unicode, variable);
  constexpr std::string_view minus = "−";  // the sign of a product stays outside of a passage
  const bool is_product = text.starts_with(minus) && text.find('(') != std::string::npos;
  return is_product ? std::string(minus) + readable(text.substr(minus.size()), p)
                    : readable(std::move(text), p);
}

std::string formatted_quotient(const RationalFunction& f, Notation notation,
                               std::string_view variable) {
  const std::string n = shown_factors(f.numerator(), notation, variable);
  if (f.is_polynomial()) return n;
  const std::string d = shown_factors(f.denominator(), notation, variable);
  if (notation == latex) return fmt::format("\\frac{{{}}}{{{}}}", n, d);
  const bool wrap = n.find('(') == std::string::npos &&
                    (!is_monomial(f.numerator()) || n.find('/') != std::string::npos);
  const bool power = f.denominator() == Polynomial::monomial(1, f.denominator().degree());
  return fmt::format("{}/{}", wrap ? "(" + n + ")" : n, power ? d : "(" + d + ")");
}

std::vector<std::string> formatted_terms(const Antiderivative& F, Notation notation,
                                         const Letters& letters) {
  std::vector<std::string> terms = algebraic_terms(F, notation, letters);
  for (const LogSum& sum : F.logs) terms.push_back(formatted_term(sum, notation, letters));
  return terms;
}

std::vector<std::string> formatted_terms(const RealForm& F, Notation notation,
                                         const Letters& letters) {
  std::vector<std::string> terms = algebraic_terms(F, notation, letters);
  for (const auto& [factor, of, positive] : F.logarithms) {
    const std::string v = shown(of, notation, letters.variable);
    terms.push_back(
        product(factor, positive ? log(v, notation) : log_of_size(v, notation), notation));
  }
  for (const RealForm::LogQuotient& term : F.quotients)
    terms.push_back(formatted_term(term, notation, letters));
  for (const RealForm::Arctangent& term : F.arctangents)
    terms.push_back(formatted_term(term, notation, letters));
  for (const LogSum& sum : F.others)
    for (std::string& term : real_terms(sum, notation, letters)) terms.push_back(std::move(term));
  return terms;
}

std::vector<std::string> formatted_terms(const TextbookForm& F, Notation notation,
                                         const Letters& letters) {
  std::vector<std::string> terms = formatted_terms(F.real, notation, letters);
  for (const LogSum& sum : F.sums) terms.push_back(formatted_term(sum, notation, letters));
  return terms;
}

std::vector<std::string> formatted_terms(const ExactValue& x, Notation notation) {
  std::vector<std::string> terms;
  if (x.rational != 0) terms.push_back(formatted(x.rational, notation));
  if (x.pi != 0)
    terms.push_back(formatted_multiple(x.pi, notation == latex ? "\\pi " : "π", notation));
  if (x.irrational_pi)
    terms.push_back(
        formatted_multiple(*x.irrational_pi, notation == latex ? "\\pi" : "π", notation));
  for (const auto& [factor, of] : x.logarithms)
    terms.push_back(product({factor, 0}, log(formatted(of, notation), notation), notation));
  for (const auto& [factor, of] : x.arctangents)
    terms.push_back(product({factor, 0}, arctan(formatted(of, notation), notation), notation));
  return terms;
}

std::string formatted_sum(const std::vector<std::string>& terms, std::string_view before,
                          Notation notation) {
  const std::string_view minus = notation == unicode ? "−" : "-";
  std::string text;
  for (const std::string& term : terms) {
    if (text.empty()) {
      text = term;
      continue;
    }
    const bool negative = term.starts_with(minus);
    text += fmt::format("{}{} {}", before, negative ? minus : "+",
                        negative ? term.substr(minus.size()) : term);
  }
  return text.empty() ? "0" : text;
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

}  // namespace phrame
