#include "phrame/io/read/number.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {

std::string_view trimmed(std::string_view text, std::string_view around) {
  const std::size_t begin = text.find_first_not_of(around);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(around) - begin + 1);
}

std::string_view take_line(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string_view without_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::string line_place(long line) { return fmt::format("line {}", line); }

std::string line_and_column(std::string_view text, std::size_t offset) {
  const auto read = text.substr(0, offset);
  const auto line = 1 + std::count(read.begin(), read.end(), '\n');
  const auto column = read.size() - (read.rfind('\n') + 1);  // npos + 1 is 0
  return fmt::format("{}:{}", line, std::max(column, std::size_t{1}));
}

Rational parse_number(std::string_view text) {
  text = trimmed(text);
  const std::size_t slash = text.find('/');
  const bool is_short = text.size() <= max_number_length;
  if (slash == std::string_view::npos || !is_short) return parse_rational(text);
  const std::string_view below = trimmed(text.substr(slash + 1));
  Rational n;
  Rational d;
  try {
    n = parse_rational(trimmed(text.substr(0, slash)));
    // A sign belongs in front of the whole, and a second "/" would be read from the wrong side.
    if (below.find_first_of("+-/") == 0 || below.find('/') != std::string_view::npos)
      return parse_rational(text);
    d = parse_rational(below);
  } catch (const InputError&) {
    return parse_rational(text);  // complains of the whole
  }
  if (d == 0) throw InputError("\"" + abbreviated(text) + "\" divides by zero");
  return n / d;
}

void refuse_long_number(const Rational& x, std::string_view text) {
  if (bits_of(x) > most_number_bits)
    throw InputError(
        fmt::format("the number {} has more than {} bits", abbreviated(text), most_number_bits));
}

Rational parse_short_number(std::string_view text) {
  Rational x = parse_number(text);
  refuse_long_number(x, text);
  return x;
}

}  // namespace phrame
