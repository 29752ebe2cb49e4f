#include "phrame/io/write/formula.hpp"

#include <fmt/format.h>

#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/surd_root.hpp"
#include "phrame/io/write/radical_text.hpp"

namespace phrame::inline v0 {
namespace {

std::string minus(Notation notation) { return notation == Notation::unicode ? "−" : "-"; }

std::string superscript(long k, Notation notation) {
  if (k == 1) return "";
  if (notation == Notation::latex) return fmt::format("^{{{}}}", k);
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(k)) text += digits[c - '0'];
  return text;
}

/// Appends " + term" or " − term" to a sum, the first term without blanks.
void append_term(std::string& sum, bool negative, std::string_view term, Notation notation) {
  if (sum.empty())
    sum = negative ? minus(notation) : "";
  else
    sum += negative ? fmt::format(" {} ", minus(notation)) : " + ";
  sum += term;
}

/// |c|·variableᵏ.
std::string term(const Rational& c, long k, Notation notation, std::string_view variable) {
  const Rational size = abs(c);
  if (k == 0) return formatted(size, notation);
  const bool whole = denominator(size) == 1;
  std::string factor;
  if (size != 1) {
    factor = formatted(size, notation);
    if (!whole && notation == Notation::unicode) factor = "(" + factor + ")";
  }
  return fmt::format("{}{}{}", factor, variable, superscript(k, notation));
}

std::string root_of(const Integer& d, Notation notation) {
  return fmt::format(fmt::runtime(notation == Notation::latex ? "\\sqrt{{{}}}" : "√{}"), d.str());
}

}  // namespace

std::string formatted(const Rational& x, Notation notation) {
  if (x < 0) return minus(notation) + formatted(Rational(-x), notation);
  if (notation == Notation::latex && denominator(x) != 1)
    return fmt::format("\\frac{{{}}}{{{}}}", numerator(x).str(), denominator(x).str());
  return to_string(x);
}

std::string formatted(const Polynomial& p, Notation notation, std::string_view variable) {
  std::string text;
  for (long k = p.degree(); k >= 0; --k) {
    const Rational c = p.coefficient(k);
    if (c == 0) continue;
    append_term(text, c < 0, term(c, k, notation, variable), notation);
  }
  return text.empty() ? "0" : text;
}

std::string formatted(const Bivariate& v, Notation notation, std::string_view variable,
                      std::string_view index) {
  std::string text;
  for (long k = v.degree(); k >= 0; --k) {
    const Polynomial c = v.coefficient(k);
    if (c.is_zero()) continue;
    if (c.is_constant()) {
      const Rational number = c.coefficient(0);
      append_term(text, number < 0, term(number, k, notation, variable), notation);
      continue;
    }
    append_term(text, false,
                in_parentheses(formatted(c, notation, index), notation) +
                    (k == 0 ? "" : term(1, k, notation, variable)),
                notation);
  }
  return text.empty() ? "0" : text;
}

std::string in_parentheses(std::string_view text, Notation notation) {
  return fmt::format(fmt::runtime(notation == Notation::latex ? "\\left({}\\right)" : "({})"),
                     text);
}

std::string formatted_multiple(const Rational& c, std::string_view name, Notation notation) {
  if (c < 0) return minus(notation) + formatted_multiple(Rational(-c), name, notation);
  const std::string times = numerator(c) == 1 ? "" : numerator(c).str();
  if (denominator(c) == 1) return fmt::format("{}{}", times, name);
  return fmt::format(fmt::runtime(notation == Notation::latex ? "\\frac{{{}{}}}{{{}}}" : "{}{}/{}"),
                     times, name, denominator(c).str());
}

std::string with_constant(const std::string& sum, std::string_view constant) {
  if (constant.empty()) return sum;
  return sum == "0" ? std::string(constant) : fmt::format("{} + {}", sum, constant);
}

std::string latex_decimal(const std::string& decimal) {
  const auto e = decimal.find('e');
  if (e == std::string::npos) return decimal;
  return fmt::format("{} \\cdot 10^{{{}}}", decimal.substr(0, e), decimal.substr(e + 1));
}

std::string formatted(const Angle& angle, Notation notation) {
  const auto& [half_turns, radians] = angle;
  if (half_turns == 0) return formatted(radians, notation);
  std::string text = radians == 0 ? "" : formatted(radians, notation);
  append_term(
      text, half_turns < 0,
      formatted_multiple(abs(half_turns), notation == Notation::latex ? "\\pi" : "π", notation),
      notation);
  return text;
}

std::string formatted(const FrameAngle& angle, Notation notation) {
  const auto [plain, z] = terms(angle);
  if (!z) return formatted(plain, notation);
  const std::string argument =
      fmt::format("{}({}, {})", notation == Notation::latex ? "\\operatorname{atan2}" : "atan2",
                  formatted(Rational(z->im), notation), formatted(Rational(z->re), notation));
  return plain == Angle() ? argument : formatted(plain, notation) + " + " + argument;
}

std::string formatted(const Surd& x, Notation notation) {
  return formatted(surd_polynomial({x}), notation, "");
}

std::string formatted(const SurdPolynomial& p, Notation notation, std::string_view variable) {
  std::string text;
  for (long k = degree(p); k >= 0; --k) {
    const Surd factor = coefficient(p, k);
    const std::string power =
        k == 0 ? "" : (notation == Notation::latex ? " " : "·") + term(1, k, notation, variable);
    if (factor.count_roots() > 1) {
      const RadicalNotation& numbers =
          notation == Notation::latex ? radical_notation::latex : radical_notation::unicode;
      const Radical number = to_radical(factor);
      const bool negative = is_written_negative(number);
      const std::string plain = formatted(number, numbers);
      if (k == 0 && (!negative || plain.starts_with(numbers.minus)))
        append_term(text, negative, negative ? plain.substr(numbers.minus.size()) : plain,
                    notation);
      else
        append_term(text, negative, formatted_factor(negative ? -number : number, numbers) + power,
                    notation);
      continue;
    }
    if (k > 0 && factor.terms().size() > 1) {
      append_term(text, false, in_parentheses(formatted(factor, notation), notation) + power,
                  notation);
      continue;
    }
    for (const auto& [d, c] : factor.terms())
      append_term(text, c < 0,
                  d == 1 ? term(c, k, notation, variable)
                         : formatted_multiple(abs(c), root_of(d, notation), notation) + power,
                  notation);
  }
  return text.empty() ? "0" : text;
}

std::string formatted_factors(const Polynomial& p, Notation notation, std::string_view variable) {
  if (p.is_constant()) return formatted(p, notation, variable);
  const Factorization factors = factor(p);
  if (factors.unit == 1 && factors.factors.size() == 1 && factors.factors.front().exponent == 1)
    return formatted(p, notation, variable);
  std::string text = factors.unit < 0 ? minus(notation) : "";
  if (const Rational size = abs(factors.unit); size != 1) {
    const std::string number = formatted(size, notation);
    const bool is_open = denominator(size) != 1 && notation == Notation::unicode;
    text += is_open ? "(" + number + ")" : number;
  }
  for (const auto& [base, exponent] : factors.factors) {
    const std::string inside = formatted(base, notation, variable);
    const bool bare = inside == variable;
    text += bare ? inside : "(" + inside + ")";
    text += superscript(exponent, notation);
  }
  return text;
}

std::string formatted(const GaussianPolynomial& p, Notation notation, std::string_view variable) {
  if (p.im.is_zero()) return formatted(p.re, notation, variable);
  // A constant imaginary part is written 3i, −i, any other (…)i.
  const bool plain = p.im.is_constant();
  const bool negative = plain && p.im.coefficient(0) < 0;
  const Polynomial size = negative ? -p.im : p.im;
  const std::string part = size == Polynomial{1} ? "" : formatted(size, notation, variable);
  const std::string imaginary = plain ? part + "i" : "(" + part + ")i";
  if (p.re.is_zero()) return negative ? minus(notation) + imaginary : imaginary;
  const std::string real = formatted(p.re, notation, variable);
  return fmt::format("{} {} {}", p.re.is_constant() ? real : "(" + real + ")",
                     negative ? minus(notation) : "+", imaginary);
}

}  // namespace phrame
