#include "phrame/io/write/svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

/// A fraction with finitely many decimals.
std::string svg_decimal(const Rational& x) {
  long places = 0;
  Rational whole = abs(x);
  for (; Rational(floor(whole)) != whole; whole *= 10) ++places;
  std::string digits = to_string(whole);
  if (places > 0) {
    const auto length = static_cast<std::size_t>(places);
    if (digits.size() <= length) digits.insert(0, length + 1 - digits.size(), '0');
    digits.insert(digits.size() - length, ".");
  }
  return x < 0 ? "-" + digits : digits;
}

std::string svg_point(const std::array<Rational, 2>& point) {
  return svg_decimal(point[0]) + "," + svg_decimal(point[1]);
}

}  // namespace

std::string path_data(const OffsetCubics& path) {
  std::string data = "M" + svg_point(path.cubics.front().front());
  for (const PlaneCubic& cubic : path.cubics)
    data +=
        fmt::format(" C{} {} {}", svg_point(cubic[1]), svg_point(cubic[2]), svg_point(cubic[3]));
  return path.is_closed ? data + " Z" : data;
}

std::string in_words(const ToleranceRange& within) {
  const std::string most = upper_bound_text(within.greatest);
  return within.least == within.greatest ? most : upper_bound_text(within.least) + " to " + most;
}

std::string write_svg(const OffsetDrawing& drawing) {
  std::array<std::vector<double>, 2> extent;
  std::string paths;
  std::size_t number = 0;
  for (const OffsetCubics& path : drawing.paths) {
    paths += fmt::format("    <path id=\"{}-{}\" d=\"{}\"/>\n", drawing.question, ++number,
                         path_data(path));
    for (const PlaneCubic& cubic : path.cubics)
      for (const auto& point : cubic)
        for (std::size_t k = 0; k < 2; ++k) extent[k].push_back(static_cast<double>(point[k]));
  }
  ToleranceRange within;
  within.add(drawing.paths);
  std::array<double, 4> view{0, 0, 1, 1};
  for (std::size_t k = 0; k < 2 && !extent[k].empty(); ++k) {
    const auto [least, most] = std::ranges::minmax(extent[k]);
    view[k] = least;
    view[k + 2] = std::max(most - least, 1e-300);
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\">\n"
      "  <title>{}</title>\n"
      "  <desc>phrame {}: cubics within {} of it, y as in the path</desc>\n"
      "  <g fill=\"none\" stroke=\"black\" stroke-width=\"{:.3g}\">\n{}  </g>\n</svg>\n",
      view[0], view[1], view[2], view[3], element_text(drawing.name), drawing.question,
      in_words(within), std::max(view[2], view[3]) / 500, paths);
}

}  // namespace phrame
