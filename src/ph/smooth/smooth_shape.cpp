#include "phrame/ph/smooth/smooth_shape.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {
namespace {

Vector<Polynomial> derivative_of(const Vector<Polynomial>& v) {
  return {differentiate(v[0]), differentiate(v[1]), differentiate(v[2])};
}

/// κ², in lowest terms.
RationalFunction squared_curvature(const RationalCurve& curve) {
  const Vector<Polynomial>& H = curve.direction();
  const Vector<Polynomial> normal = cross(H, derivative_of(H));
  const Polynomial sigma = dot(H, H);
  return {dot(normal, normal) * pow(curve.weight(), 4), pow(curve.multiplier(), 2) * pow(sigma, 3)};
}

RationalFunction torsion_of(const RationalCurve& curve) {
  const Vector<Polynomial>& H = curve.direction();
  const Vector<Polynomial> first = derivative_of(H);
  const Vector<Polynomial> normal = cross(H, first);
  const Polynomial rho = dot(normal, normal);
  if (rho.is_zero()) throw DomainError("torsion: the curve is a straight line, it has none");
  return {dot(normal, derivative_of(first)) * pow(curve.weight(), 2), curve.multiplier() * rho};
}

/// f(t), exact where t is.
Real value_of(const RationalFunction& f, const Real& t, const char* name) {
  if (!t.exact())
    return Real([f, t](long bits) { return evaluate(f, t.enclose(bits + 8), bits + 8); });
  const Rational below = f.denominator()(*t.exact());
  if (below == 0)
    throw DomainError(
        fmt::format("{}: it is infinite at t = {}", name, abbreviated(to_string(*t.exact()))));
  return Rational(f.numerator()(*t.exact()) / below);
}

const RationalCurve& curve_at(const SmoothPath& path, const SmoothParameter& at) {
  return std::get<RationalCurve>(path.segments()[at.segment]);
}

Vector<Polynomial> binormal_of(const RationalCurve& curve) {
  return cross(curve.direction(), derivative_of(curve.direction()));
}

/// Has the curve neither inflections nor a straight part?
bool bends_all_along(const RationalCurve& curve) {
  const Vector<Polynomial> b = binormal_of(curve);
  const Polynomial common = gcd(gcd(b[0], b[1]), b[2]);
  return !common.is_zero() && count_real_roots(common, {0, 1}) == 0;
}

/// Along the binormal at t.
Vector<Rational> binormal_at(const RationalCurve& curve, const Rational& t) {
  return evaluate(binormal_of(curve), t);
}

}  // namespace

Real curvature(const SmoothPath& path, const SmoothParameter& at) {
  const Real squared = value_of(squared_curvature(curve_at(path, at)), at.t, "curvature");
  if (squared.exact()) return square_root_of(*squared.exact());
  return Real(
      [squared](long bits) { return sqrt_of_nonnegative(squared.enclose(bits + 8), bits + 8); });
}

Real torsion(const SmoothPath& path, const SmoothParameter& at) {
  return value_of(torsion_of(curve_at(path, at)), at.t, "torsion");
}

bool has_continuous_frenet_frame(const SmoothPath& path) {
  const auto& segments = path.segments();
  for (const SmoothSegment& segment : segments)
    if (!std::visit([](const auto& curve) { return bends_all_along(curve); }, segment))
      return false;
  const auto at = [&](std::size_t k, const Rational& t) {
    return std::visit([&](const auto& curve) { return binormal_at(curve, t); }, segments[k]);
  };
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const bool is_last = k + 1 == segments.size();
    if (is_last && !path.is_closed()) break;
    const Vector<Rational> before = at(k, 1);
    const Vector<Rational> after = at(is_last ? 0 : k + 1, 0);
    if (cross(before, after) != Vector<Rational>{} || dot(before, after) <= 0) return false;
  }
  return true;
}

}  // namespace phrame
