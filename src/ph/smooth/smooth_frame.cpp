#include "phrame/ph/smooth/smooth_frame.hpp"

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {
namespace {

Vector<Real> over_size(const Vector<Real>& v, const Real& squared_size) {
  return {over_square_root(v[0], squared_size), over_square_root(v[1], squared_size),
          over_square_root(v[2], squared_size)};
}

/// H/|H| and, for an n normal to it, n/|n| and H × n/|H × n|.
Frame<Real> frame_along(const Vector<Real>& H, const Vector<Real>& n) {
  const Real sigma = remembered(dot(H, H));
  const Real size = remembered(dot(n, n));
  return {over_size(H, sigma), over_size(n, size), over_size(cross(H, n), sigma * size)};
}

/// The reference frame of an angle.
Frame<Real> reference_at(const SmoothAngle& angle, const SmoothParameter& at) {
  return angle.reference() == SmoothReference::up ? up_frame(angle.path(), angle.up(), at)
                                                  : frenet_frame(angle.path(), at);
}

/// arg(x + iy) of x = n·e₂ and y = n·e₃ in (−π, π], where `up` × H, for the frame of `up`, is along
/// e₂: exact where H and `up` are.
Real argument_of(const Vector<Rational>& n, const Frame<Real>& frame, const Vector<Real>& H,
                 const Vector<Real>& up) {
  const Vector<Real> normal = as_reals(n);
  const Vector<Real> second = cross(up, H);
  const Real x = dot(normal, second);
  const Real y = dot(normal, cross(H, second));
  const Real sigma = dot(H, H);
  const auto enclosure = [x = dot(normal, frame.e2), y = dot(normal, frame.e3)](long bits) {
    return argument(ComplexBall(x.enclose(bits + 8), y.enclose(bits + 8)), bits + 8);
  };
  if (y.exact() == Rational(0)) return sign_of(x) > 0 ? Real(Rational(0)) : to_real(Angle(1, 0));
  if (!x.exact() || !y.exact() || !sigma.exact()) return Real(enclosure);
  // e₃ is along H × second/|H|.
  const auto rest = [x = *x.exact(), y = Rational(*y.exact() / *sigma.exact()),
                     sigma = *sigma.exact()] { return AlgebraicAngle::argument(x, y, sigma); };
  return real_angle(enclosure, {0, rest}, x.origin().bits + y.origin().bits);
}

}  // namespace

Frame<Real> up_frame(const SmoothPath& path, const Vector<Rational>& up,
                     const SmoothParameter& at) {
  const Vector<Real> H = direction(path, at);
  return frame_along(H, cross(as_reals(up), H));
}

Frame<Real> frenet_frame(const SmoothPath& path, const SmoothParameter& at) {
  const Vector<Real> H = direction(path, at);
  const Vector<Real> binormal = cross(H, direction_slope(path, at));
  if (is_zero(binormal))
    throw DomainError(
        "Frenet frame: the curvature is 0 there, at an inflection or on a straight line; the "
        "principal normal is undefined");
  // n is along b × e₁, and b along e₁ × n.
  return frame_along(H, cross(binormal, H));
}

Real start_angle(const FrameStart& start, const SmoothAngle& angle, const SmoothParameter& at) {
  if (const auto* given = std::get_if<Angle>(&start)) return to_real(*given);
  const Vector<Rational>& normal = std::get<StartNormal>(start).vector;
  const Frame<Real> frame = reference_at(angle, at);
  const Vector<Real> H = direction(angle.path(), at);
  if (is_zero(cross(H, as_reals(normal))))
    throw DomainError("the vector " + abbreviated(normal) + " has no part in the normal plane" +
                      (normal == Vector<Rational>{} ? "" : ": it is along the tangent"));
  const Vector<Real> up = angle.reference() == SmoothReference::up
                              ? as_reals(angle.up())
                              : cross(H, direction_slope(angle.path(), at));
  return argument_of(normal, frame, H, up);
}

Frame<Real> rotation_minimizing_frame(const SmoothAngle& angle, const SmoothParameter& at,
                                      const Real& start) {
  return turned(reference_at(angle, at), angle.value(at) + start);
}

}  // namespace phrame
