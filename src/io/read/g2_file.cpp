#include "phrame/io/read/g2_file.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/svg_number.hpp"
#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

long count_of(SvgNumbers& in, long least, long most, const char* what) {
  const std::string place = in.place();
  const Rational x = in.number();
  if (denominator(x) != 1 || x < least || x > most)
    throw InputError(place,
                     fmt::format("{}: {} is not from {} to {}", what, as_written(x), least, most));
  return static_cast<long>(numerator(x));
}

}  // namespace

bool is_g2_file(std::string_view text) {
  text = trimmed(text.substr(0, text.find('\n')));
  return text.starts_with("100 1 0 0");
}

std::vector<GivenSegment> read_g2(std::string_view text, const CurveLimits& limits) {
  SvgNumbers in(text, 0);
  for (const char* what : {"a curve of the class 100", "version 1"}) count_of(in, 0, 100, what);
  for (int k = 0; k < 2; ++k) count_of(in, 0, 0, "a curve without auxiliary data");
  const long dimension = count_of(in, 2, 3, "the dimension");
  const bool is_rational = count_of(in, 0, 1, "whether it is rational") == 1;
  const long points = count_of(in, 2, 1'000'000, "the number of points");
  BSpline spline;
  spline.degree = count_of(in, 2, limits.max_degree + 1, "the order") - 1;
  for (long k = 0; k < points + spline.degree + 1; ++k) spline.knots.push_back(in.number());
  for (long k = 0; k < points; ++k) {
    Vector<Rational> p;
    for (long c = 0; c < dimension; ++c) p[static_cast<std::size_t>(c)] = in.number();
    if (is_rational) {
      const std::string place = in.place();
      const Rational w = in.number();
      if (w <= 0) throw InputError(place, fmt::format("the weight {} is not > 0", as_written(w)));
      spline.weights.push_back(w);
      p = 1 / w * p;
    }
    spline.points.push_back(p);
  }
  if (!in.at_end()) in.fail("one curve is wanted: the end is expected");
  if (const auto fault = fault_of(spline)) throw InputError("1:1", fault->reason);
  return span_segments(spline, "1:1");
}

}  // namespace phrame
