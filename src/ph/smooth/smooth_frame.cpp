#include "phrame/ph/smooth/smooth_frame.hpp"

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

/// arg(x + iy), in (−π, π]; x and y are multiples of their exact signs.
Real argument_of(const Real& x, const Real& y, bool y_is_zero, int sign_of_x) {
  if (y_is_zero && sign_of_x > 0) return Rational(0);
  if (y_is_zero) return Real([](long bits) { return pi(bits); }, {true, 0});
  return Real([x, y](long bits) {
    return argument(ComplexBall(x.enclose(bits + 8), y.enclose(bits + 8)), bits + 8);
  });
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
  const Real x = dot(as_reals(normal), frame.e2);
  const Real y = dot(as_reals(normal), frame.e3);
  // Exactly: n·e₂ and n·e₃ up to positive factors.
  const Vector<Real> e2 = angle.reference() == SmoothReference::up
                              ? cross(as_reals(angle.up()), H)
                              : cross(cross(H, direction_slope(angle.path(), at)), H);
  const Real exact_x = dot(as_reals(normal), e2);
  const Real exact_y = dot(as_reals(normal), cross(H, e2));
  const bool y_is_zero = exact_y.exact() == Rational(0);
  const int sign_of_x = exact_x.exact() ? exact_x.exact()->sign() : 0;
  return argument_of(x, y, y_is_zero, sign_of_x);
}

Frame<Real> rotation_minimizing_frame(const SmoothAngle& angle, const SmoothParameter& at,
                                      const Real& start) {
  return turned(reference_at(angle, at), angle.value(at) + start);
}

}  // namespace phrame
