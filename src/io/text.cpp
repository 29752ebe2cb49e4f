#include "phrame/io/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace phrame {
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

bool is_bearable(std::string_view text) { return text_width(text) <= 240; }

std::size_t longest_coefficient(const Polynomial& p) {
  std::size_t digits = 0;
  for (const Rational& c : p.coefficients())
    digits = std::max({digits, abs(numerator(c)).str().size(), denominator(c).str().size()});
  return digits;
}

std::string summary(long degree, std::size_t digits) {
  return fmt::format("⟨degree {}, coefficients of up to {} digits⟩", degree, digits);
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

std::string formatted(const Bivariate& v, Notation notation) {
  const bool latex = notation == Notation::latex;
  std::string text;
  for (long k = v.degree(); k >= 0; --k) {
    const Polynomial c = v.coefficient(k);
    if (c.is_zero()) continue;
    if (c.is_constant()) {
      const Rational number = c.coefficient(0);
      append_term(text, number < 0, term(number, k, notation, "t"), notation);
      continue;
    }
    const std::string power = k == 0 ? "" : term(1, k, notation, "t");
    append_term(text, false,
                fmt::format("{}{}{}{}", latex ? "\\left(" : "(", formatted(c, notation, "x"),
                            latex ? "\\right)" : ")", power),
                notation);
  }
  return text.empty() ? "0" : text;
}

std::string formatted_factors(const Polynomial& p, Notation notation, std::string_view variable) {
  if (p.is_constant()) return formatted(p, notation, variable);
  const Factorization factors = factor(p);
  if (factors.unit == 1 && factors.factors.size() == 1 && factors.factors.front().exponent == 1)
    return formatted(p, notation, variable);
  std::string text;
  if (factors.unit == -1)
    text = minus(notation);
  else if (factors.unit != 1)
    text = formatted(factors.unit, notation);
  if (denominator(factors.unit) != 1 && notation == Notation::unicode) text += " ";
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

std::string place_of_root(const Interval& root) {
  const auto shown = [](const Rational& t) { return abbreviated(to_string(t)); };
  if (*root.lower == *root.upper) return "t = " + shown(*root.lower);
  return fmt::format("a t in ({}, {})", shown(*root.lower), shown(*root.upper));
}

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t k = 0; k < text.size(); ++k) {
    unsigned code = static_cast<unsigned char>(text[k]);
    // U+0080 … U+009F are the two bytes C2 80 … C2 9F.
    const unsigned next = k + 1 < text.size() ? static_cast<unsigned char>(text[k + 1]) : 0;
    if (code == 0xC2U && next >= 0x80U && next < 0xA0U) {
      code = next;
      ++k;
    } else if (code >= 0x20U && code != 0x7FU) {
      shown += text[k];
      continue;
    }
    shown += fmt::format("\\u{:04x}", code);
  }
  return shown;
}

std::size_t text_width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // not a continuation byte of UTF-8
  }));
}

std::string readable(std::string text, const Polynomial& p) {
  return is_bearable(text) ? std::move(text) : summary(p.degree(), longest_coefficient(p));
}

std::string readable(const Bivariate& v) {
  std::string text = formatted(v, Notation::unicode);
  return is_bearable(text) ? std::move(text) : fmt::format("⟨degree {} in t⟩", v.degree());
}

std::string readable(const GaussianPolynomial& g) {
  std::string text = formatted(g, Notation::unicode);
  return is_bearable(text)
             ? std::move(text)
             : summary(degree(g), std::max(longest_coefficient(g.re), longest_coefficient(g.im)));
}

}  // namespace phrame
