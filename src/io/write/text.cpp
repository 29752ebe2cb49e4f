#include "phrame/io/write/text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

constexpr std::size_t longest_line = 240;
constexpr std::size_t longest_fraction = 20;  // digits without a decimal beside them

bool is_bearable(std::string_view text) { return text_width(text) <= longest_line; }

std::size_t longest_coefficient(const Polynomial& p) {
  std::size_t digits = 0;
  for (const Rational& c : p.coefficients())
    digits = std::max({digits, abs(numerator(c)).str().size(), denominator(c).str().size()});
  return digits;
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
  return fmt::format("{} {} {}", x, rounded.radius == "0" ? "=" : "≈", shown(rounded));
}

/// A passage where the text is longer than that; passages in it become part of that one.
std::string within(std::size_t limit, const std::string& text) {
  const std::string brief = abridged(text);
  if (brief.size() <= limit) return text;
  return passage(for_reading(text, true), abbreviated(brief, limit));
}

/// "12345678…23456789" where n ≥ 0 is longer than that.
std::string ends_of(const std::string& n) {
  constexpr std::size_t kept = 8;
  return n.size() <= 2 * kept + 1 ? n : n.substr(0, kept) + "…" + n.substr(n.size() - kept);
}

std::string summary(long degree, std::size_t digits) {
  return fmt::format("⟨degree {}, coefficients of up to {}⟩", degree, counted(digits, "digit"));
}

/// Of the character that the text begins with, in bytes of UTF-8; 0 where there is none.
std::size_t length_of_character(std::string_view text) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
  };
  const unsigned first = byte(0);
  if (first < 0x80U) return 1;
  const std::size_t length = first < 0xC2U ? 0 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
  // Neither longer than need be nor half of a surrogate pair nor beyond U+10FFFF.
  const unsigned least = first == 0xE0U ? 0xA0U : first == 0xF0U ? 0x90U : 0x80U;
  const unsigned greatest = first == 0xEDU ? 0x9FU : first == 0xF4U ? 0x8FU : 0xBFU;
  if (length == 0 || first > 0xF4U || byte(1) < least || byte(1) > greatest) return 0;
  for (std::size_t k = 2; k < length; ++k)
    if (byte(k) < 0x80U || byte(k) > 0xBFU) return 0;
  return length;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    text.remove_prefix(character.size());
    // U+0080 … U+009F are the two bytes C2 80 … C2 9F.
    const bool is_c1 = length == 2 && character < "\xC2\xA0";
    const unsigned code = static_cast<unsigned char>(character.back());
    if (length == 0)
      shown += fmt::format("\\x{:02x}", code);
    else if (is_c1 || (length == 1 && (code < 0x20U || code == 0x7FU)))
      shown += fmt::format("\\u{:04x}", code);
    else
      shown += character;
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

std::vector<std::string> aligned(const std::vector<std::string>& texts) {
  const auto padded = [&](bool full) {
    std::vector<std::string> column;
    std::size_t width = 0;
    for (const std::string& text : texts) {
      column.push_back(full ? for_reading(text, true) : abridged(text));
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

std::string columns_text(const std::vector<std::vector<std::string>>& rows,
                         std::string_view margin) {
  std::vector<std::string> lines(rows.size(), std::string(margin));
  for (std::size_t column = 0; column < rows.front().size(); ++column) {
    std::vector<std::string> cells;
    for (const auto& row : rows) cells.push_back(row[column]);
    cells = aligned(cells);
    for (std::size_t k = 0; k < lines.size(); ++k) lines[k] += (column == 0 ? "" : "  ") + cells[k];
  }
  std::string text;
  for (std::string& line : lines) {
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
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

std::string in_brief(const Rational& x, std::size_t limit) {
  const std::string full = formatted(x, Notation::unicode);
  if (text_width(full) <= limit) return full;
  const std::string above = abs(numerator(x)).str();
  const std::string below = denominator(x).str();
  const std::string sign = x < 0 ? "−" : "";
  return passage(full, denominator(x) == 1
                           ? fmt::format("{}{} ({} digits)", sign, ends_of(above), above.size())
                           : fmt::format("{}{}/{} ({}/{} digits)", sign, ends_of(above),
                                         ends_of(below), above.size(), below.size()));
}

std::string shown(const Rational& x, std::size_t limit) {
  constexpr long digits = 12;
  const std::string text = in_brief(x, limit);
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
  if (!x.exact()) return shown(rounded);
  const std::string text = in_brief(*x.exact());
  return is_long_fraction(*x.exact()) ? with_decimal(text, rounded) : text;
}

std::string shown(const Interval& interval) {
  std::string text = to_string(interval);
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at))
    text.replace(at, 1, "−");
  return text;
}

std::string with_minus_sign(const std::string& decimal) {
  return decimal.starts_with('-') ? "−" + decimal.substr(1) : decimal;
}

std::string shown(const Decimal& x) { return with_minus_sign(x.value); }

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string ranges(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t first = 0; first < numbers.size();) {
    std::size_t last = first;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (last == first + 1) last = first;  // "1, 2", but "1 to 3"
    if (!text.empty()) text += ", ";
    text += std::to_string(numbers[first]);
    if (last > first) text += fmt::format(" to {}", numbers[last]);
    first = last + 1;
  }
  return text;
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
  // This ends: an irrational number lies between two decimals.
  for (long bits = 128;; bits *= 2) {
    const RealBall ball = enclose(x, bits);
    const bool is_negative = ball.upper() < 0;
    const Rational least = is_negative ? -ball.upper() : ball.lower();
    const Rational most = is_negative ? -ball.lower() : ball.upper();
    if (!(least > 0)) continue;
    const std::string text = lower_bound_text(least, 12);
    if (text == lower_bound_text(most, 12)) return (is_negative ? "−" : "") + text + "…";
  }
}

std::string element_text(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
}

}  // namespace phrame
