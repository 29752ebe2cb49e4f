#include "phrame/ph/smooth/smooth_shape.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational_function.hpp"
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

}  // namespace phrame
