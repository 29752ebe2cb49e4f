#include "phrame/ph/along/path_totals.hpp"

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/integrate/integral_sum.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/shape.hpp"

namespace phrame {
namespace {

/// factor · (total/√radicand), the integral without the root.
KnownIntegral without_root(const Total& total, const Rational& factor) {
  const Real value = Real(factor) * (square_root_of(1 / total.radicand) * total.value);
  KnownIntegral integral{{remembered(value), std::nullopt}};
  if (total.exact) integral.value.exact = factor * *total.exact;
  Rational from = 0;
  Rational sign = factor;
  const auto add = [&](const Rational& to) {
    integral.parts.push_back({total.rate, total.antiderivative, from, to, sign});
    from = to;
    sign = -sign;
  };
  for (const RealAlgebraic& turn : total.sign_changes) {
    if (!turn.is_rational()) {
      integral.parts.clear();
      return integral;
    }
    add(*turn.rational());
  }
  add(1);
  return integral;
}

/// Those with one root.
struct Group {
  Rational radicand;
  std::vector<KnownIntegral> integrals = {};
};

PathTotal sum_of(std::vector<Total> segments) {
  if (segments.size() == 1) {
    const Total& only = segments.front();
    PathTotal total{{}, only.value, std::nullopt};
    if (only.exact) total.exact = {{only.radicand, *only.exact}};
    total.segments = std::move(segments);
    return total;
  }
  std::vector<Group> groups;
  for (const Total& segment : segments) {
    if (segment.value.exact() == Rational(0)) continue;
    // √radicand of it over that of the group, where it is rational.
    const auto quotient = [&](const Group& group) {
      return square_root(Rational(segment.radicand / group.radicand));
    };
    auto group = std::find_if(groups.begin(), groups.end(), quotient);
    if (group == groups.end()) group = groups.insert(group, {segment.radicand});
    group->integrals.push_back(without_root(segment, *quotient(*group)));
  }
  PathTotal total{std::move(segments), Rational(0), std::vector<PathTotal::Term>()};
  for (const Group& group : groups) {
    const DefiniteIntegral sum = sum_of_integrals(group.integrals);
    total.value = total.value + square_root_of(group.radicand) * sum.value;
    if (sum.exact && total.exact)
      total.exact->push_back({group.radicand, *sum.exact});
    else
      total.exact.reset();
  }
  if (groups.empty()) total.exact = {{1, ExactValue{}}};
  return total;
}

PathTotal sum_over(const PhPath& path, Total (*of)(const Curve&)) {
  std::vector<Total> segments;
  Stage stage("segments", path.segments().size());
  for (const Curve& curve : path.segments()) {
    segments.push_back(of(curve));
    stage.advance();
  }
  return sum_of(std::move(segments));
}

std::variant<PathTotal, Infinite> sum_over(const PhPath& path,
                                           std::variant<Total, Infinite> (*of)(const Curve&)) {
  std::vector<Total> segments;
  for (const Curve& curve : path.segments()) {
    const std::variant<Total, Infinite> total = of(curve);
    if (const auto* infinite = std::get_if<Infinite>(&total)) {
      const std::size_t k = segments.size();
      return Infinite{*algebraic_parameter(Place(k, infinite->pole)), k};
    }
    segments.push_back(std::get<Total>(total));
  }
  return sum_of(std::move(segments));
}

/// Does the tangent of a path in the plane with this normal never turn back? The sense in which it
/// turns is the sign of normal·(d × d′), d = A i A*.
bool turns_one_way(const PhPath& path, const Vector<Rational>& normal, const PathTotal& curvature) {
  int sense = 0;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    if (!curvature.segments[k].sign_changes.empty()) return false;
    const auto [x, y, z] = rotated_i(path.segments()[k].preimage());
    const auto minor = [](const Polynomial& a, const Polynomial& b) {
      return a * differentiate(b) - b * differentiate(a);
    };
    const int here = sign_after_zero(dot(normal, {minor(y, z), minor(z, x), minor(x, y)}));
    if (here * sense < 0) return false;
    if (here != 0) sense = here;
  }
  return true;
}

/// A i A*/σ, through cusps by continuity.
Vector<Rational> unit_tangent(const Curve& curve, const Rational& t) {
  const RationalQuaternion a = evaluate(without_real_content(curve.preimage()), t);
  return Rational(1 / norm(a)) * rotated_i(a);
}

}  // namespace

PathTotal total_length(const PhPath& path) { return sum_over(path, total_length); }

PathTotal erf_twist(const PhPath& path) { return sum_over(path, erf_twist); }

std::variant<PathTotal, Infinite> bending_energy(const PhPath& path) {
  return sum_over(path, bending_energy);
}

std::variant<PathTotal, Infinite> frenet_energy(const PhPath& path) {
  return sum_over(path, frenet_energy);
}

PathTotal total_torsion(const PhPath& path) { return sum_over(path, total_torsion); }

std::optional<PathTotal> total_curvature(const PhPath& path) {
  std::vector<Total> segments;
  for (const Curve& curve : path.segments()) {
    const auto total = total_curvature(curve);
    if (!total) return std::nullopt;
    segments.push_back(*total);
  }
  return sum_of(std::move(segments));
}

// The tangents at the ends are rational vectors. Between them the tangent turns by ±α up to whole
// turns, where it does not turn back; and an angle α with a rational cosine is a rational multiple
// of π only for cos α = 0, ±1/2 and ±1 (Niven), that is a multiple of π/6.
std::optional<Real> absolute_rotation_index(const PhPath& path) {
  const auto normal = plane_normal(path);
  if (!normal) return std::nullopt;
  const PathTotal curvature = total_curvature(path).value();  // ρ of a plane curve is a square
  if (curvature.value.exact() == Rational(0)) return Real(Rational(0));
  if (curvature.exact && curvature.exact->size() == 1)
    if (const auto& [radicand, x] = curvature.exact->front(); x == ExactValue{0, x.pi, {}, {}})
      return square_root_of(radicand) * Rational(x.pi / 2);
  const Real index = curvature.value * Real([](long bits) {
                       return divide(RealBall(Rational(1, 2), bits), pi(bits), bits);
                     });
  if (!turns_one_way(path, *normal, curvature)) return index;
  const Rational cosine =
      dot(unit_tangent(path.segments().front(), 0), unit_tangent(path.segments().back(), 1));
  if (cosine != 0 && abs(cosine) != 1 && abs(cosine) != Rational(1, 2))
    return Real([index](long bits) { return index.enclose(bits); }, {true, index.origin().bits});
  for (long bits = 64;; bits *= 2) {
    const RealBall twelfths = multiply(RealBall(12, bits), index.enclose(bits), bits);
    if (const auto nearest = unique_integer(twelfths)) return Real(Rational(*nearest, 12));
  }
}

}  // namespace phrame
