// The frames of a numerical method: double reflection (Wang, Jüttler, Zheng, Liu, Computation of
// rotation minimizing frames, ACM TOG 27, 2008) with N steps, as a table for `phrame check`.
//
//   double_reflection [CURVE [N]] | phrame check CURVE -
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "phrame/phrame.hpp"

namespace {

using phrame::Vector;
using Point = Vector<double>;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point subtract(const Point& a, double c, const Point& b) {
  return {a[0] - c * b[0], a[1] - c * b[1], a[2] - c * b[2]};
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// a, mirrored in the plane across v.
Point mirrored(const Point& a, const Point& v) { return subtract(a, 2 * dot(v, a) / dot(v, v), v); }

}  // namespace

int main(int argc, char** argv) try {
  const char* path = argc > 1 ? argv[1] : "curves/farouki-2003-quintic.json";
  const long steps = argc > 2 ? std::atol(argv[2]) : 10;
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  const phrame::Curve curve = phrame::read_curve(text.str()).curve;
  const auto r = position(curve);
  const phrame::Frames frames(curve);

  std::cout << std::setprecision(17) << "t,f2x,f2y,f2z,f3x,f3y,f3z\n";
  Point position{};
  Point tangent{};
  Point f2{};
  for (long k = 0; k <= steps; ++k) {
    const phrame::Rational t(k, steps);
    const auto exact = frames.euler_rodrigues(t);
    const Point next = phrame::round_to_double(evaluate(r, t));
    const Point next_tangent = phrame::round_to_double(exact.e1);
    if (k == 0) {
      f2 = phrame::round_to_double(exact.e2);
    } else {
      const Point v1 = subtract(next, 1, position);
      const Point v2 = subtract(next_tangent, 1, mirrored(tangent, v1));
      f2 = mirrored(mirrored(f2, v1), v2);
    }
    position = next;
    tangent = next_tangent;
    const Point f3 = cross(tangent, f2);
    std::cout << static_cast<double>(k) / static_cast<double>(steps);
    for (const Point& v : {f2, f3}) std::cout << ',' << v[0] << ',' << v[1] << ',' << v[2];
    std::cout << '\n';
  }
} catch (const phrame::Error& error) {
  std::cerr << "usage: double_reflection CURVE.json [STEPS]\n" << error.what() << "\n";
  return 2;
}
