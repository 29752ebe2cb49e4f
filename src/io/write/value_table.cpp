#include "phrame/io/write/value_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/write/names.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {

namespace {

std::string shown_number(const std::variant<Rational, Decimal>& x) {
  constexpr std::size_t longest = 40;
  if (const auto* exact = std::get_if<Rational>(&x)) return shown(*exact, longest);
  return shown(std::get<Decimal>(x));
}

std::string latex_number(const std::variant<Rational, Decimal>& x) {
  if (const auto* exact = std::get_if<Rational>(&x)) return formatted(*exact, Notation::latex);
  return latex_decimal(std::get<Decimal>(x).value);
}

}  // namespace

std::string value_table(const std::vector<AngleValue>& values, long digits, ParameterKind by) {
  std::size_t whole_width = 1;
  const auto whole = [](const std::string& theta) {
    return text_width(theta.substr(0, theta.find('.')));
  };
  const bool is_t = by == ParameterKind::t;
  std::vector<std::string> asked{is_t ? "" : column_of(by)};
  std::vector<std::string> column{"t"};
  for (const AngleValue& value : values) {
    asked.push_back(value.asked ? shown_number(*value.asked) : "");
    column.push_back(shown_number(value.t));
    whole_width = std::max(whole_width, whole(shown(value.theta)));
  }
  asked = aligned(asked);
  column = aligned(column);
  for (std::size_t k = 0; k < column.size() && !is_t; ++k) column[k] = asked[k] + "   " + column[k];
  std::string text = fmt::format("\n  {}   {}θ(t)   radians, correctly rounded to {}\n", column[0],
                                 std::string(whole_width - 1, ' '),
                                 counted(static_cast<std::size_t>(digits), "digit"));
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string theta = shown(values[k].theta);
    text += fmt::format("  {}   {}{}\n", column[k + 1],
                        std::string(whole_width - whole(theta), ' '), theta);
  }
  return text;
}

std::string latex_value_table(const std::vector<AngleValue>& values, ParameterKind by) {
  const bool is_t = by == ParameterKind::t;
  std::string text = is_t ? "\\begin{tabular}{ll}\n$t$ & $\\theta(t)$ \\\\\n"
                          : fmt::format("\\begin{{tabular}}{{lll}}\n{} & $t$ & $\\theta(t)$ \\\\\n",
                                        column_of(by));
  for (const AngleValue& value : values) {
    if (value.asked) text += fmt::format("${}$ & ", latex_number(*value.asked));
    text +=
        fmt::format("${}$ & ${}$ \\\\\n", latex_number(value.t), latex_decimal(value.theta.value));
  }
  return text + "\\end{tabular}\n";
}

}  // namespace phrame
