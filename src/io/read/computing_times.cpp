#include "phrame/io/read/computing_times.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/number.hpp"

namespace phrame::inline v0 {
namespace {

/// Without blanks and quotes around it.
std::string field(std::string_view text) { return std::string(trimmed(text, "\" \t\r")); }

Rational seconds_of(const std::string& text) {
  if (text.empty()) throw InputError("no seconds are given");
  Rational seconds = parse_short_number(text);
  if (seconds < 0) throw InputError(as_written(seconds) + " seconds are negative");
  return seconds;
}

}  // namespace

std::map<std::string, ComputingTime> computing_times(std::string_view text) {
  text = without_mark(text);
  std::map<std::string, ComputingTime> times;
  bool is_head = true;
  for (long line = 1; !text.empty(); ++line) {
    const std::string_view content = trimmed(take_line(text));
    if (content.empty() || content.starts_with('#')) continue;
    try {
      const std::size_t comma = content.rfind(',');
      const std::string name = field(content.substr(0, comma));
      const std::string value =
          comma == content.npos ? std::string() : field(content.substr(comma + 1));
      if (is_head && (name != "name" || value != "seconds"))
        throw InputError(
            fmt::format("the first line is to be name,seconds, not {}", abbreviated(content)));
      if (!is_head && !times.try_emplace(name, ComputingTime{seconds_of(value), line}).second)
        throw InputError(fmt::format("\"{}\" has seconds already", abbreviated(name)));
      is_head = false;
    } catch (const InputError& error) {
      throw InputError(line_place(line), error.reason());
    }
  }
  if (is_head) throw InputError(line_place(1), "the first line is to be name,seconds");
  return times;
}

}  // namespace phrame
