#include "phrame/io/write/value_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/write/text.hpp"

namespace phrame {

std::string value_table(const std::vector<AngleValue>& values, long digits) {
  constexpr std::size_t longest = 40;
  std::size_t whole_width = 1;
  const auto whole = [](const std::string& theta) {
    return text_width(theta.substr(0, theta.find('.')));
  };
  std::vector<std::string> column{"t"};
  for (const AngleValue& value : values) {
    column.push_back(shown(value.t, longest));
    whole_width = std::max(whole_width, whole(shown(value.theta)));
  }
  column = aligned(column);
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

std::string latex_value_table(const std::vector<AngleValue>& values) {
  std::string text = "\\begin{tabular}{ll}\n$t$ & $\\theta(t)$ \\\\\n";
  for (const AngleValue& value : values)
    text += fmt::format("${}$ & ${}$ \\\\\n", formatted(value.t, Notation::latex),
                        latex_decimal(value.theta.value));
  return text + "\\end{tabular}\n";
}

}  // namespace phrame
