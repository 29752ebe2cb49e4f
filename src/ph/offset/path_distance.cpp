// |r(s) − at|² − d² is a polynomial of s over ℚ for a rational point. Its sign on [0, 1] is that of
// its Bernstein coefficients on short parts; where it has a zero without a change of sign, as at
// the point that the offset belongs to, if that is not taken out, its roots and their orders
// decide.
#include "phrame/ph/offset/path_distance.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/real_algebraic.hpp"

namespace phrame::inline v0 {
namespace {

enum class Sign { never_negative, negative, unknown };

/// Of a polynomial with these Bernstein coefficients.
Sign sign_of(const std::vector<RealBall>& coefficients, int depth) {
  constexpr long bits = 128;
  if (sign(coefficients.front()) < 0 || sign(coefficients.back()) < 0) return Sign::negative;
  if (std::ranges::all_of(coefficients, [](const RealBall& c) { return sign(c) > 0; }))
    return Sign::never_negative;
  if (depth == 0) return Sign::unknown;
  const auto [left, right] = split(coefficients, Rational(1, 2), bits);
  const Sign one = sign_of(left, depth - 1);
  if (one == Sign::negative) return one;
  const Sign other = sign_of(right, depth - 1);
  return other == Sign::never_negative ? one : other;
}

/// Is p < 0 anywhere on [0, 1]?
bool is_negative_somewhere(Polynomial p) {
  if (p.is_zero()) return false;
  while (p(0) == 0) p = exact_quotient(p, Polynomial{0, 1});
  while (p(1) == 0) p = exact_quotient(p, Polynomial{1, -1});
  if (p(0) < 0 || p(1) < 0) return true;
  constexpr long bits = 128;
  constexpr int depth = 10;
  const Sign seen = sign_of(to_bernstein(BallPolynomial(p, bits), p.degree(), bits), depth);
  if (seen != Sign::unknown) return seen == Sign::negative;
  return std::ranges::any_of(real_roots(p, open_interval(0, 1)),
                             [](const RealRoot& root) { return root.order % 2 != 0; });
}

double size_of(const PlaneBox& box) {
  double size = 0;
  for (const DoubleInterval& x : box) size = std::max({size, std::abs(x.lower), std::abs(x.upper)});
  return size;
}

/// A little more than [x, x].
DoubleInterval around(const Rational& x) {
  const auto near = static_cast<double>(x);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {std::nextafter(near, -infinity), std::nextafter(near, infinity)};
}

/// Of the points of two boxes, in one coordinate.
double gap(const DoubleInterval& a, const DoubleInterval& b) {
  return std::max({a.lower - b.upper, b.lower - a.upper, 0.0});
}

bool is_beyond(const PlaneBox& a, const PlaneBox& b, double reach) {
  return gap(a[0], b[0]) > reach || gap(a[1], b[1]) > reach;
}

/// All values of p on [0, 1].
DoubleInterval range_of(const Polynomial& p) {
  constexpr long bits = 64;
  DoubleInterval range{std::numeric_limits<double>::infinity(),
                       -std::numeric_limits<double>::infinity()};
  for (const RealBall& c : to_bernstein(BallPolynomial(p, bits), std::max(p.degree(), 0L), bits)) {
    range.lower = std::min(range.lower, -upper_double(subtract({}, c, bits)));
    range.upper = std::max(range.upper, upper_double(c));
  }
  return range;
}

/// As many points as are next to each other by a quarter of |d|, within bounds.
long count_of(const PlaneBox& box, double reach) {
  const double size = std::hypot(box[0].upper - box[0].lower, box[1].upper - box[1].lower);
  constexpr double least = 8;
  constexpr double most = 128;
  return static_cast<long>(std::clamp(4 * size / reach, least, most));
}

}  // namespace

PathDistance::PathDistance(const PhPath& path, const Rational& d)
    : squared_(d * d), reach_(std::abs(static_cast<double>(d)) * (1 + 1e-12)) {
  double size = 0;
  for (const Curve& curve : path.segments()) {
    const Vector<Polynomial> r = position(curve);
    Part part{r[0], r[1], {}, {range_of(r[0]), range_of(r[1])}};
    const long count = count_of(part.box, reach_);
    for (long k = 0; k <= count; ++k) {
      const Rational t(k, count);
      part.points.push_back({static_cast<double>(r[0](t)), static_cast<double>(r[1](t))});
    }
    size = std::max(size, size_of(part.box));
    parts_.push_back(std::move(part));
  }
  // A point and a corner of a box are off by 2⁻⁵⁰ of their sizes.
  error_ = 0x1p-46 * (size + reach_) * (size + reach_);
  certain_ = static_cast<double>(squared_) * (1 - 1e-9) - error_;
}

bool PathDistance::covers(const PlaneBox& box) const {
  const double limit = certain_ - 0x1p-46 * size_of(box) * size_of(box);
  const auto farthest = [](const DoubleInterval& x, double at) {
    return std::max(std::abs(x.lower - at), std::abs(x.upper - at));
  };
  for (const Part& part : parts_) {
    if (is_beyond(part.box, box, reach_)) continue;
    for (const auto& [x, y] : part.points) {
      const double dx = farthest(box[0], x);
      const double dy = farthest(box[1], y);
      if (dx * dx + dy * dy < limit) return true;
    }
  }
  return false;
}

bool PathDistance::is_nearer(const Vector<Rational>& at, const Part& part,
                             const Polynomial& known) const {
  const PlaneBox box{around(at[0]), around(at[1])};
  if (is_beyond(part.box, box, reach_ * (1 + 1e-12) + 0x1p-40 * size_of(box))) return false;
  const Polynomial x = part.x - Polynomial{at[0]};
  const Polynomial y = part.y - Polynomial{at[1]};
  return is_negative_somewhere(exact_quotient(x * x + y * y - Polynomial{squared_}, known));
}

bool PathDistance::is_nearer(const Vector<Rational>& at) const {
  return std::ranges::any_of(parts_,
                             [&](const Part& part) { return is_nearer(at, part, Polynomial{1}); });
}

bool PathDistance::is_nearer(const Vector<Rational>& at, std::size_t segment,
                             const Rational& t) const {
  const Polynomial known = Polynomial{-t, 1} * Polynomial{-t, 1};
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (is_nearer(at, parts_[k], k == segment ? known : Polynomial{1})) return true;
  return false;
}

}  // namespace phrame
