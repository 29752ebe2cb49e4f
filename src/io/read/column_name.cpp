#include "phrame/io/read/column_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "phrame/io/read/number.hpp"

namespace phrame::inline v0 {
namespace {

// Letters and powers as they stand in headers, in lower case.
constexpr auto units = std::to_array<std::string_view>({
    "m",      "mm",      "cm",      "dm",      "km",     "um",    "µm",         "μm",
    "nm",     "in",      "inch",    "inches",  "ft",     "feet",  "yd",         "mi",
    "mil",    "mils",    "px",      "pixel",   "pixels", "pt",    "meter",      "meters",
    "metre",  "metres",  "unit",    "units",   "s",      "ms",    "us",         "µs",
    "ns",     "sec",     "second",  "seconds", "min",    "h",     "hz",         "rad",
    "deg",    "degree",  "degrees", "°",       "%",      "1",     "millimeter", "millimeters",
    "radian", "radians", "mm^2",    "m^2",     "mm²",    "m²",    "s^2",        "s²",
    "s2",     "g",       "kg",      "n",       "v",      "a",     "k",          "c",
    "°c",     "pa",      "bar",     "1/m",     "1/mm",   "mm^-1",
});

bool is_simple_unit(std::string_view text) {
  return std::ranges::find(units, lower_case(text)) != units.end();
}

/// The text within this pair around it; else as it is.
std::string_view within(std::string_view text, char open, char close) {
  if (text.size() >= 2 && text.front() == open && text.back() == close)
    return trimmed(text.substr(1, text.size() - 2));
  return text;
}

/// The last such pair in a text that it ends, and what is in front of it.
std::optional<ColumnName> split_at(std::string_view text, char open, char close) {
  const auto at = text.rfind(open);
  if (!text.ends_with(close) || at == std::string_view::npos || at == 0) return std::nullopt;
  const std::string_view name = trimmed(text.substr(0, at));
  const std::string_view unit = trimmed(text.substr(at + 1, text.size() - at - 2));
  if (name.empty()) return std::nullopt;
  return ColumnName{std::string(name), unit == "-" ? "" : std::string(unit)};
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool is_missing_text(std::string_view field) {
  std::string word = lower_case(field);
  if (word.starts_with('-') || word.starts_with('+')) word.erase(0, 1);
  constexpr auto words = std::to_array<std::string_view>(
      {"", "nan", "inf", "infinity", "na", "n/a", "#n/a", "null", "none", "1.#qnan", "1.#inf"});
  return std::ranges::find(words, word) != words.end();
}

bool is_unit(std::string_view text) {
  text = within(within(trimmed(text), '[', ']'), '(', ')');
  if (text == "-" || is_simple_unit(text)) return true;
  const auto slash = text.find('/');
  return slash != std::string_view::npos && is_simple_unit(trimmed(text.substr(0, slash))) &&
         is_simple_unit(trimmed(text.substr(slash + 1)));
}

std::string unit_in(std::string_view text) {
  text = within(within(trimmed(text), '[', ']'), '(', ')');
  return text == "-" ? "" : std::string(text);
}

ColumnName column_name(std::string_view header) {
  header = trimmed(header);
  if (auto found = split_at(header, '[', ']')) return *found;
  if (auto found = split_at(header, '(', ')');
      found && (found->unit.empty() || is_unit(found->unit)))
    return *found;
  const auto slash = header.find('/');
  if (slash != std::string_view::npos && slash > 0 && is_unit(header.substr(slash + 1)))
    return {std::string(trimmed(header.substr(0, slash))),
            std::string(trimmed(header.substr(slash + 1)))};
  return {std::string(header)};
}

// Of "field.pose.position.x", what is in front of "position" does not matter.
std::optional<PositionColumn> position_column(std::string_view name) {
  constexpr std::array<std::string_view, 10> before{"pos",      "position",   "p",          "t",
                                                    "coord",    "point",      "coordinate", "loc",
                                                    "location", "translation"};
  constexpr std::array<std::string_view, 4> behind{"pos", "position", "coord", "coordinate"};
  const auto is_one_of = [](const auto& list, std::string_view word) {
    return std::ranges::find(list, word) != list.end();
  };
  if (const auto last = name.rfind('.'); last != std::string_view::npos && last > 0)
    if (const auto dot = name.rfind('.', last - 1); dot != std::string_view::npos)
      name.remove_prefix(dot + 1);
  std::string word = lower_case(name);
  std::erase_if(word,
                [](char c) { return std::string_view(" _-.").find(c) != std::string_view::npos; });
  constexpr std::string_view axes = "xyz";
  if (word.size() < 2) return std::nullopt;
  const std::string front = word.substr(0, word.size() - 1);
  if (const auto axis = axes.find(word.back());
      axis != std::string_view::npos && is_one_of(before, front))
    return PositionColumn{front, axis};
  const std::string rest = word.substr(1);
  if (const auto axis = axes.find(word.front());
      axis != std::string_view::npos && is_one_of(behind, rest))
    return PositionColumn{rest, axis};
  return std::nullopt;
}

std::optional<std::array<std::size_t, 3>> position_columns(const std::vector<std::string>& names) {
  std::map<std::string, std::array<std::vector<std::size_t>, 3>> families;
  constexpr std::string_view axes = "xyz";
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string word = lower_case(names[k]);
    if (word.size() == 1 && axes.find(word.front()) != std::string_view::npos)
      families[""][axes.find(word.front())].push_back(k);
    else if (const auto other = position_column(names[k]))
      families[other->family][other->axis].push_back(k);
  }
  std::erase_if(families, [](const auto& family) {
    return std::ranges::any_of(family.second, [](const auto& list) { return list.size() != 1; });
  });
  if (families.size() > 1 && families.count("") == 0) families.erase("t");
  if (families.empty() || (families.size() > 1 && families.count("") == 0)) return std::nullopt;
  const auto& found = families.begin()->second;  // "" is the first
  return std::array{found[0].front(), found[1].front(), found[2].front()};
}

}  // namespace phrame
