#include "phrame/io/read/svg_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/expression_token.hpp"
#include "phrame/io/read/number.hpp"

namespace phrame::inline v0 {
namespace {

bool is_svg_digit(char c) { return c >= '0' && c <= '9'; }

/// [+-]?(d+.?d*|.d+)([eE][+-]?d+)? at the beginning; 0 where it is not there.
std::size_t svg_number_length(std::string_view text) {
  std::size_t n = 0;
  const auto has = [&](std::string_view any_of) {
    return n < text.size() && any_of.find(text[n]) != std::string_view::npos;
  };
  const auto digits = [&] {
    const std::size_t first = n;
    while (n < text.size() && is_svg_digit(text[n])) ++n;
    return n - first;
  };
  if (has("+-")) ++n;
  std::size_t count = digits();
  if (has(".")) {
    ++n;
    count += digits();
  }
  if (count == 0) return 0;
  const std::size_t mantissa = n;
  if (has("eE")) {
    ++n;
    if (has("+-")) ++n;
    if (digits() == 0) n = mantissa;
  }
  return n;
}

}  // namespace

SvgNumbers::SvgNumbers(std::string_view text, std::size_t begin) : text_(text), at_(begin) {
  skip();
}

void SvgNumbers::skip() {
  at_ = std::min(text_.find_first_not_of(" \t\r\n\f,", at_), text_.size());
}

bool SvgNumbers::is_at_number() const { return svg_number_length(text_.substr(at_)) > 0; }

Rational SvgNumbers::number() {
  // A longer number is refused; that it is looked at only so far keeps the cost of one in bounds.
  const std::size_t length = svg_number_length(text_.substr(at_, max_number_length + 1));
  if (length == 0) fail("a number is expected");
  std::string digits(text_.substr(at_, length));
  if (digits.front() == '+') digits.erase(0, 1);
  if (const auto point = digits.find('.');
      point != std::string::npos &&
      (point + 1 == digits.size() || !is_svg_digit(digits[point + 1])))
    digits.erase(point, 1);  // "5." and "5.e3"
  try {
    Rational value = parse_rational(digits);
    refuse_long_number(value, digits);
    at_ += length;
    skip();
    return value;
  } catch (const InputError& error) {
    throw InputError(place(), error.reason());
  }
}

bool SvgNumbers::flag() {
  if (at_end() || (text_[at_] != '0' && text_[at_] != '1')) fail("a flag, 0 or 1, is expected");
  const bool result = text_[at_] == '1';
  ++at_;
  skip();
  return result;
}

char SvgNumbers::take_letter(std::string_view letters) {
  if (at_end() || letters.find(text_[at_]) == std::string_view::npos) return 0;
  const char c = text_[at_];
  ++at_;
  skip();
  return c;
}

std::string_view SvgNumbers::take_word() {
  const std::size_t first = at_;
  while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  const std::string_view word = text_.substr(first, at_ - first);
  skip();
  return word;
}

bool SvgNumbers::take(char c) { return take_letter({&c, 1}) != 0; }

std::string SvgNumbers::place() {
  for (; counted_ < at_; ++counted_)
    if (text_[counted_] == '\n') {
      ++line_;
      line_begin_ = counted_ + 1;
    }
  return fmt::format("{}:{}", line_, at_ - line_begin_ + 1);
}

void SvgNumbers::fail(const std::string& expected) {
  const std::string there = at_end() ? "the end" : in_quotes(first_token(text_.substr(at_)).text);
  throw InputError(place(), fmt::format("{}, not {}", expected, there));
}

}  // namespace phrame
