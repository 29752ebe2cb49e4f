#include "phrame/ph/along/up_vector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/decimal_between.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/along/expression_integral.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/formula_domain.hpp"
#include "phrame/ph/curve/formula_program.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// H at some t of [0, 1], about.
Vector<RealBall> direction_near(const RationalCurve& curve, const Rational& t, long bits) {
  const Vector<Rational> h = evaluate(curve.direction(), t);
  return {RealBall(h[0], bits), RealBall(h[1], bits), RealBall(h[2], bits)};
}

Vector<RealBall> direction_near(const ExpressionCurve& curve, const Rational& t, long bits) {
  const Vector<BallPolynomial> r = curve.series(RealBall(t, bits), 1, 2, bits);
  return {r[0].coefficient(1), r[1].coefficient(1), r[2].coefficient(1)};
}

/// Unit tangents, or their opposites, at some points, for a guess.
std::vector<Vector<double>> sampled_tangents(const Path& path) {
  constexpr long bits = 64;
  const std::size_t count = path.segments().size();
  const long steps = std::max(4L, 64 / static_cast<long>(count));
  const std::size_t stride = 1 + count / 1024;
  std::vector<Vector<double>> all;
  for (std::size_t k = 0; k < count; k += stride)
    for (long j = 0; j <= steps; ++j) {
      const Vector<RealBall> h = visit_curve(
          [&](const auto& curve) { return direction_near(curve, Rational(j, steps), bits); },
          path.segments()[k]);
      RealBall squares;
      for (const RealBall& x : h) squares = add_product(squares, x, x, bits);
      const RealBall size = sqrt(squares, bits);
      Vector<double> unit{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        unit[axis] = approximate(divide(h[axis], size, bits));
      all.push_back(unit);
    }
  return all;
}

/// The t of an s, where it is rational by its form.
std::optional<Rational> rational_parameter(const ExpressionCurve& curve, const Formula& s) {
  return rational_value((s - curve.from()) / (curve.to() - curve.from()));
}

/// Integer vectors in all directions, one of each pair of opposite ones, z first.
std::vector<Vector<long>> candidates() {
  std::vector<Vector<long>> all;
  for (long size = 1; size <= 3; ++size)
    for (long z = 0; z <= size; ++z)
      for (long y = -size; y <= size; ++y)
        for (long x = -size; x <= size; ++x) {
          const bool is_first = z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0)));
          const bool is_new =
              std::max({std::abs(x), std::abs(y), z}) == size && std::gcd(std::gcd(x, y), z) == 1;
          if (is_first && is_new) all.push_back({x, y, z});
        }
  return all;
}

/// sin² of the smallest angle to one of the tangents.
double least_sine(const Vector<long>& v, const std::vector<Vector<double>>& tangents) {
  const Vector<double> w{static_cast<double>(v[0]), static_cast<double>(v[1]),
                         static_cast<double>(v[2])};
  const double size = dot(w, w);
  double least = size;
  for (const Vector<double>& t : tangents) {
    const Vector<double> c = cross(w, t);
    least = std::min(least, dot(c, c));
  }
  return least / size;
}

std::string where(const Interval& at, std::size_t segment) {
  const Rational offset(static_cast<long>(segment));
  if (at.lower == at.upper) return "t = " + as_written(Rational(*at.lower + offset));
  return "t ≈ " + decimal_between(*at.lower + offset, *at.upper + offset, 9);
}

/// Is v nowhere along the tangent of the path?
bool is_apart(const Path& path, const Vector<Rational>& v) {
  return std::none_of(path.segments().begin(), path.segments().end(),
                      [&](const Segment& segment) { return tangent_along(segment, v); });
}

}  // namespace

std::optional<TangentPlace> tangent_along(const RationalCurve& curve, const Vector<Rational>& v) {
  const Polynomial common = gcd(across(v, curve));
  if (common.is_zero()) return TangentPlace{closed_interval(0, 0), true};
  if (common.is_constant()) return std::nullopt;
  const auto zeros = located_real_roots(common, closed_interval(0, 1));
  if (zeros.empty()) return std::nullopt;
  return TangentPlace{zeros.front(), true};
}

std::optional<TangentPlace> tangent_along(const ExpressionCurve& curve, const Vector<Rational>& v) {
  const auto fault = taylor_parts(curve, up_frame_rate(v))->fault;
  if (!fault) return std::nullopt;
  const Vector<Formula> up{Formula(v[0]), Formula(v[1]), Formula(v[2])};
  const auto zero = simple_zero(curve, widened_part(*fault), cross(up, curve.derivative(1)));
  const auto t = zero ? rational_parameter(curve, *zero) : std::nullopt;
  return TangentPlace{t ? closed_interval(*t, *t) : closed_interval(fault->lower, fault->upper),
                      zero.has_value()};
}

std::optional<TangentPlace> tangent_along(const Segment& segment, const Vector<Rational>& v) {
  return visit_curve([&](const auto& curve) { return tangent_along(curve, v); }, segment);
}

void require_up_vector(const Path& path, const Vector<Rational>& v) {
  if (v == Vector<Rational>{}) throw DomainError("the up vector is 0");
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const auto at = tangent_along(path.segments()[k], v);
    if (!at) continue;
    if (at->is_certain)
      throw DomainError(fmt::format("the up vector {} is along the tangent at {}", abbreviated(v),
                                    where(at->place, k)));
    throw Undecided(fmt::format(
        "whether the up vector {} is along the tangent near {} is not told within parts of 2^-40 "
        "of the curve",
        abbreviated(v), where(at->place, k)));
  }
}

bool is_straight(const Path& path) { return are_on_a_line(direction_span(path)); }

std::optional<Vector<Rational>> plane_normal(const Path& path) {
  return common_normal(direction_span(path));
}

Vector<Rational> up_vector(const Path& path) {
  if (const auto normal = plane_normal(path)) return *normal;
  const auto tangents = sampled_tangents(path);
  std::vector<std::pair<double, Vector<long>>> ordered;
  static const std::vector<Vector<long>> all = candidates();
  for (const Vector<long>& v : all) ordered.emplace_back(-least_sine(v, tangents), v);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [size, v] : ordered) {
    const Vector<Rational> up{v[0], v[1], v[2]};
    if (is_apart(path, up)) return up;
  }
  throw Undecided(fmt::format(
      "each of {} up vectors that were tried is along the tangent somewhere: name another one",
      ordered.size()));
}

}  // namespace phrame
