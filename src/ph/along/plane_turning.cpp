// κ² is rational, and (κ²)′ = 2κκ′: its zeros are those of κ′, and where κ = 0 with the order k it
// has one of the order 2k − 1.
//
// The rotation index is counted along a chain of directions d₀, d₁, …, of which neighbours, and all
// e₁ between them, are in an open half-plane m·e₁ > 0. So each step is by an angle in (−π, π), as
// is that at a corner. The angle from d₀ to dₖ is one in (−π, π] and whole turns, of which one is
// gained where a step to the left comes from the left half of that interval, (0, π], to the right
// one, and one is lost by the opposite. Only signs are needed. The directions are those at ends and
// middles of parts, of formulas rounded, within the half-planes of both neighbours.
#include "phrame/ph/along/plane_turning.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/curve_series.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

std::optional<Vector<Rational>> upper_normal(const Path& path) {
  auto normal = plane_normal(path);
  if (!normal) return std::nullopt;
  std::size_t last = 2;
  while ((*normal)[last] == 0) --last;
  return (*normal)[last] > 0 ? *normal : Rational(-1) * *normal;
}

namespace {

/// The order of a zero of p ≠ 0 at t, 0 where it is none, and the sign of p just after it.
std::pair<int, int> order_and_sign(Polynomial p, const RealAlgebraic& t) {
  int order = 0;
  int sign = sign_at(p, t);
  for (; sign == 0; ++order, sign = sign_at(p, t)) p = differentiate(p);
  return {order, sign};
}

}  // namespace

std::vector<CurvaturePlace> curvature_places(const Segment& segment,
                                             const Vector<Rational>& normal) {
  using enum CurvaturePlace::Kind;
  const RationalCurve& curve = *rational_curve(segment);
  const Polynomial bend = dot(normal, binormal(curve));
  const RationalFunction slope = differentiate(squared_curvature(curve));
  std::vector<CurvaturePlace> places;
  if (slope.numerator().is_zero()) return places;
  int after = sign_after_zero(slope.numerator());
  for (const RealRoot& root : real_roots(slope.numerator(), open_interval(0, 1))) {
    if (root.order % 2 == 0) continue;
    after = -after;
    if (sign_at(curve.multiplier(), root.at) == 0) continue;
    const auto [order, side] = order_and_sign(bend, root.at);
    if (order > 0) {
      places.push_back({root.at,
                        order % 2 == 1 ? inflection
                        : side > 0     ? least
                                       : greatest,
                        Real(Rational(0))});
      continue;
    }
    const bool grows_behind = after * sign_at(slope.denominator(), root.at) > 0;
    places.push_back({root.at, grows_behind == (side > 0) ? least : greatest,
                      Rational(side) * curvature(Path(segment), Place(0, root.at))});
  }
  return places;
}

namespace {

/// How far directions of the plane with this normal have turned.
class DirectionChain {
 public:
  explicit DirectionChain(Vector<Rational> normal) : normal_(std::move(normal)) {}

  /// From the last direction by an angle in (−π, π).
  void step_to(const Vector<Rational>& next) {
    if (first_ == Vector<Rational>{}) first_ = last_ = next;
    const int step = side_of(last_, next);
    const int here = half_of(next);
    if (step > 0 && half_ > 0 && here < 0) ++turns_;
    if (step < 0 && half_ < 0 && here > 0) --turns_;
    half_ = here;
    last_ = next;
  }

  const Vector<Rational>& first() const { return first_; }
  /// The whole turns of the angle from the first direction, less that in (−π, π].
  long turns() const { return turns_; }
  /// 1 where that is in (0, π], −1 where it is in (−π, 0].
  int half() const { return half_; }
  /// Is it more than a quarter of a turn?
  bool is_behind() const { return dot(first_, last_) < 0; }

 private:
  int side_of(const Vector<Rational>& a, const Vector<Rational>& b) const {
    return dot(normal_, cross(a, b)).sign();
  }
  /// 1 where the angle from the first direction is in (0, π], −1 where it is in (−π, 0].
  int half_of(const Vector<Rational>& b) const {
    const int side = side_of(first_, b);
    return side != 0 ? side : dot(first_, b).sign() < 0 ? 1 : -1;
  }

  Vector<Rational> normal_;
  Vector<Rational> first_{};
  Vector<Rational> last_{};
  int half_ = -1;
  long turns_ = 0;
};

/// Is m·e₁ > 0 on the part [a, b] of the segment?
bool is_along(const RationalCurve& curve, const Vector<Rational>& m, const Rational& a,
              const Rational& b) {
  const Polynomial along = dot(m, curve.direction());
  const std::vector<Rational> bounds =
      to_bernstein(compose(along, Polynomial{a, b - a}), std::max(along.degree(), 0L));
  return std::ranges::all_of(bounds, [](const Rational& x) { return x > 0; });
}

bool is_along(const ExpressionCurve& curve, const Vector<Rational>& m, const Rational& a,
              const Rational& b) {
  constexpr long bits = 80;
  const auto rate = curve.series(hull(a, b, bits), 1, 2, bits);
  RealBall along;
  for (std::size_t k = 0; k < 3; ++k)
    along = add_product(std::move(along), RealBall(m[k], bits), rate[k].coefficient(1), bits);
  return sign(along) == curve.orientation();
}

/// Adds the directions on [a, b] behind a.
void add_part(DirectionChain& chain, const Path& path, std::size_t segment,
              const Vector<Rational>& at_a, const Rational& a, const Rational& b) {
  const Rational middle = (a + b) / 2;
  const auto at = [&](const Rational& t) { return near(direction(path, Place(segment, t))); };
  const Vector<Rational> m = at(middle);
  const Vector<Rational> at_b = at(b);
  const auto is_along_part = [&](const auto& curve) { return is_along(curve, m, a, b); };
  if (dot(m, at_a) > 0 && dot(m, at_b) > 0 &&
      visit_curve(is_along_part, path.segments()[segment])) {
    chain.step_to(at_b);
    return;
  }
  if (b - a < power_of_two(-40) && rational_curve(path.segments()[segment]) == nullptr)
    throw Undecided("rotation index: how formulas turn is not told within a part of 2^-40");
  add_part(chain, path, segment, at_a, a, middle);
  add_part(chain, path, segment, m, middle, b);
}

/// The angle over 2π, in (−1/4, 1/4), from a to b.
Real share_of_turn(const Vector<Real>& a, const Vector<Real>& b, const Vector<Rational>& normal) {
  const Real x = dot(a, b);
  const Real y = dot(as_reals(normal), cross(a, b));
  const Rational squared = dot(normal, normal);
  const bool is_exact = x.exact() && y.exact();
  if (is_exact) {
    const auto half_turns =
        AlgebraicAngle::argument(*x.exact(), *y.exact() / squared, squared).half_turns();
    if (half_turns) return Rational(*half_turns / 2);
  }
  const Real share([angle = argument_of(x, over_square_root(y, squared))](long bits) {
    return divide(times_power_of_two(angle.enclose(bits), -1), pi(bits), bits);
  });
  return is_exact ? known_irrational(share) : share;
}

}  // namespace

std::optional<Real> rotation_index(const Path& path) {
  if (are_on_a_line(direction_span(path))) return Real(Rational(0));
  const auto normal = upper_normal(path);
  if (!normal) return std::nullopt;
  DirectionChain chain(*normal);
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const Vector<Rational> start = near(direction(path, Place(k, Rational(0))));
    chain.step_to(start);
    add_part(chain, path, k, start, 0, 1);
  }
  const Closure closed = closure(path);
  if (!closed.is_closed) throw Undecided("rotation index: " + closed.undecided);
  if (*closed.is_closed) {
    chain.step_to(chain.first());
    return Real(Rational(chain.turns()));
  }
  const Vector<Real> first = direction(path, Place(0, Rational(0)));
  const Vector<Real> last = direction(path, end_of(path));
  // Where e₁ is about opposite to the first one, their angle might be next to π or −π.
  const Rational half = chain.is_behind() ? Rational(chain.half(), 2) : Rational(0);
  return share_of_turn(first, chain.is_behind() ? opposite(last) : last, *normal) +
         Real(Rational(Rational(chain.turns()) + half));
}

}  // namespace phrame
