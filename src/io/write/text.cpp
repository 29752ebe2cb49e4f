#include "phrame/io/write/text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/surd_root.hpp"
#include "phrame/io/write/radical_text.hpp"

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

std::string root_of(const Integer& d, Notation notation) {
  return fmt::format(fmt::runtime(notation == Notation::latex ? "\\sqrt{{{}}}" : "√{}"), d.str());
}

constexpr std::size_t longest_line = 240;
constexpr std::size_t longest_fraction = 20;  // digits without a decimal beside them

// A passage is begin, the full text, middle, the abridged text, end.
constexpr char passage_begin = '\x02';
constexpr char passage_middle = '\x1f';
constexpr char passage_end = '\x03';

bool is_bearable(std::string_view text) { return text_width(text) <= longest_line; }

std::size_t longest_coefficient(const Polynomial& p) {
  std::size_t digits = 0;
  for (const Rational& c : p.coefficients())
    digits = std::max({digits, abs(numerator(c)).str().size(), denominator(c).str().size()});
  return digits;
}

std::string in_length(std::string_view text, bool full) {
  std::string read;
  for (;;) {
    const auto begin = text.find(passage_begin);
    read += text.substr(0, begin);
    if (begin == std::string_view::npos) return read;
    const auto middle = text.find(passage_middle, begin);
    const auto end = text.find(passage_end, middle);
    if (end == std::string_view::npos) throw DomainError("a text with half a passage");
    read += full ? text.substr(begin + 1, middle - begin - 1)
                 : text.substr(middle + 1, end - middle - 1);
    text.remove_prefix(end + 1);
  }
}

std::string readable(std::string text, std::string_view summary) {
  return is_bearable(text) ? std::move(text) : passage(text, summary);
}

bool is_long_fraction(const Rational& x) {
  const auto digits = [](const Integer& n) { return abs(n).str().size(); };
  return denominator(x) != 1 &&
         std::max(digits(numerator(x)), digits(denominator(x))) > longest_fraction;
}

/// "x ≈ 0.5", "x = 0.5".
std::string with_decimal(const std::string& x, const Decimal& rounded) {
  return fmt::format("{} {} {}", x, rounded.radius == "0" ? "=" : "≈", rounded.value);
}

/// A passage where the text is longer than that; passages in it become part of that one.
std::string within(std::size_t limit, const std::string& text) {
  const std::string brief = in_length(text, false);
  if (brief.size() <= limit) return text;
  return passage(in_length(text, true), abbreviated(brief, limit));
}

std::string number_within(std::size_t limit, const Rational& x) {
  return within(limit, formatted(x, Notation::unicode));
}

std::string summary(long degree, std::size_t digits) {
  return fmt::format("⟨degree {}, coefficients of up to {}⟩", degree, counted(digits, "digit"));
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

std::string passage(std::string_view full, std::string_view abridged) {
  std::string text(1, passage_begin);
  text += full;
  text += passage_middle;
  text += abridged;
  return text += passage_end;
}

std::string for_reading(std::string_view text, bool in_full) {
  const bool has_passages = text.find(passage_begin) != std::string_view::npos;
  return in_length(text, in_full) +
         (has_passages && !in_full ? "\nLong parts are abridged (--full prints it all).\n" : "");
}

std::string abridged(std::string_view text) { return in_length(text, false); }

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

std::string indented(std::string_view text, std::string_view line) {
  std::string result;
  for (const char c : text) {
    if (c == '\n')
      result += line;
    else
      result += c;
  }
  return result;
}

std::size_t text_width(std::string_view text) {
  std::size_t width = 0;
  bool counts = true;
  for (const char c : text) {
    if (c == passage_begin || c == passage_middle || c == passage_end)
      counts = c != passage_begin;
    else if (counts && (static_cast<unsigned char>(c) & 0xC0U) != 0x80U)
      ++width;  // a continuation byte of UTF-8 is no character
  }
  return width;
}

std::vector<std::string> aligned(const std::vector<std::string>& texts) {
  const auto padded = [&](bool full) {
    std::vector<std::string> column;
    std::size_t width = 0;
    for (const std::string& text : texts) {
      column.push_back(in_length(text, full));
      width = std::max(width, text_width(column.back()));
    }
    for (std::string& text : column) text.append(width - text_width(text), ' ');
    return column;
  };
  std::vector<std::string> column = padded(false);
  const std::vector<std::string> full = padded(true);
  for (std::size_t k = 0; k < column.size(); ++k)
    if (column[k] != full[k]) column[k] = passage(full[k], column[k]);
  return column;
}

std::string readable(std::string text, const Polynomial& p) {
  return readable(std::move(text), summary(p.degree(), longest_coefficient(p)));
}

std::string readable(const Bivariate& v, std::string_view variable, std::string_view index) {
  return readable(formatted(v, Notation::unicode, variable, index),
                  fmt::format("⟨degree {} in {}⟩", v.degree(), variable));
}

std::string readable(const GaussianPolynomial& g) {
  return readable(
      formatted(g, Notation::unicode),
      summary(degree(g), std::max(longest_coefficient(g.re), longest_coefficient(g.im))));
}

std::string readable(const SurdPolynomial& p, std::string_view variable) {
  std::size_t digits = 0;
  for (const auto& [d, c] : p.terms()) digits = std::max(digits, longest_coefficient(c));
  return readable(formatted(p, Notation::unicode, variable), summary(degree(p), digits));
}

std::string readable_exact(const std::string& text, std::size_t limit) {
  return within(limit, text);
}

std::string shown(const Rational& x, std::size_t limit) {
  constexpr long digits = 12;
  const std::string text = number_within(limit, x);
  return is_long_fraction(x) ? with_decimal(text, round_to_decimal(x, digits)) : text;
}

std::string shown(const FrameAngle& x) {
  return within(longest_line, formatted(x, Notation::unicode));
}

std::string shown(const Vector<Rational>& v) {
  return fmt::format("({}, {}, {})", shown(v[0]), shown(v[1]), shown(v[2]));
}

std::string shown(const Polynomial& p) { return readable(formatted(p, Notation::unicode), p); }

std::string shown(const Real& x, const Decimal& rounded) {
  if (!x.exact()) return rounded.value;
  const std::string text = number_within(longest_line, *x.exact());
  return is_long_fraction(*x.exact()) ? with_decimal(text, rounded) : text;
}

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string name_prefix(const std::string& name) {
  constexpr std::size_t limit = 80;
  const std::string text = printable(name);
  if (text.empty()) return "";
  return within(limit, text) + ": ";
}

std::string row(std::string_view label, const std::string& value, std::size_t width) {
  return fmt::format("  {}{}  {}\n", label, std::string(width - text_width(label), ' '), value);
}

std::string shown(const RealAlgebraic& x) {
  if (const auto exact = x.rational()) return shown(*exact);
  const Rational below = enclose(x, 128).lower();
  return (below < 0 ? "−" + upper_bound_text(-below, 12) : lower_bound_text(below, 12)) + "…";
}

}  // namespace phrame
