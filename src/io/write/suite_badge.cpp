#include <fmt/format.h>

#include "phrame/algebra/rounding.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/suite.hpp"
#include "phrame/version.hpp"

namespace phrame::inline v0 {

// Widths are those of digits and small letters of most fonts without serifs, and textLength makes
// the others fit.
std::string to_badge(const SuiteAnswer& answer) {
  const SuiteGroup all = suite_groups(answer).back();
  const std::size_t curves = answer.rows.size() + answer.missing.size();
  const std::string error = all.max_error ? upper_bound_text(*all.max_error) : "none judged";
  const std::string left = fmt::format("phrame {} frames", version);
  const std::string right = fmt::format("{} of {}, error {}", all.passed, curves, error);
  constexpr std::size_t per_letter = 7;
  constexpr std::size_t margin = 6;
  const std::size_t left_width = left.size() * per_letter;
  const std::size_t right_width = right.size() * per_letter;
  const std::size_t middle = left_width + 2 * margin;
  const auto text = [](const std::string& words, std::size_t x, std::size_t width) {
    return fmt::format("    <text x=\"{}\" y=\"14\" textLength=\"{}\">{}</text>\n", x, width,
                       words);
  };
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"20\" role=\"img\">\n"
      "  <title>Rotation-minimizing frames for the reference collection of phrame {1}: {2} of {3} "
      "curves pass, to within {4}; largest error: {5}; without a verdict: {6}; without a table: "
      "{7}</title>\n"
      "  <rect width=\"{8}\" height=\"20\" fill=\"#444\"/>\n"
      "  <rect x=\"{8}\" width=\"{9}\" height=\"20\" fill=\"{10}\"/>\n"
      "  <g fill=\"#fff\" font-family=\"Verdana,sans-serif\" font-size=\"11\">\n{11}{12}  </g>\n"
      "</svg>\n",
      middle + right_width + 2 * margin, version, all.passed, curves, to_string(answer.tolerance),
      error, all.failures, answer.missing.size(), middle, right_width + 2 * margin,
      answer.passes() ? "#27642b" : "#8a3b12", text(left, margin, left_width),
      text(right, middle + margin, right_width));
}

}  // namespace phrame
