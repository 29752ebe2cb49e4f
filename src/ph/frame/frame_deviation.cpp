#include "phrame/ph/frame/frame_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

RealBall root(const Real& x, long bits) {
  return x.exact() ? sqrt(RealBall(*x.exact(), bits), bits)
                   : sqrt_of_nonnegative(x.enclose(bits + 8), bits);
}

void grow_to(RealBall& x, const RealBall& y, long bits) { x = max(x, y, bits); }

/// |cos| of the angle between f and v ≠ 0; 0 where f is 0.
RealBall cosine(const Vector<Rational>& f, const Vector<Real>& v, long bits) {
  const Rational size = dot(f, f);
  if (size == 0) return {};
  const Real c = dot(as_reals(f), v);
  return root(quotient_of(c * c, dot(v, v) * size), bits);
}

/// | |f| − 1 |.
RealBall off_unit(const Vector<Rational>& f, long bits) {
  return absolute(subtract(root(dot(f, f), bits), RealBall(1, bits), bits));
}

bool is_nowhere(const Vector<Real>& v) {
  return std::all_of(v.begin(), v.end(), [](const Real& x) { return sign_of(x) == 0; });
}

/// The angle of f to e about e₁ = H/|H|, up to whole turns: arg(f·e + i f·(e₁ × e)).
RealBall angle_about(const Vector<Real>& H, const Vector<Real>& e, const Vector<Rational>& f,
                     long bits) {
  const Real x = dot(as_reals(f), e);
  const Real y = dot(cross(as_reals(f), H), e);
  const Real sigma = dot(H, H);
  if (x.exact() && y.exact() && sigma.exact())
    if (const auto size = square_root(*sigma.exact()))
      return argument(*x.exact() * *size, *y.exact(), bits);
  const long more = bits + 16;
  const RealBall re = multiply(x.enclose(more), root(sigma, more), more);
  const RealBall im = y.enclose(more);
  const ComplexBall z(re, im);
  return re.midpoint() >= 0 ? argument(z, bits) : argument_about_pi(z, bits);
}

}  // namespace

FrameDeviation deviation_from(const ExactFrame& exact, const GivenFrame& frame, long bits) {
  const Vector<Real>& H = exact.tangent;
  const Real sigma = dot(H, H);
  FrameDeviation result;
  for (std::size_t k = 0; k < 3; ++k) result.e1[k] = over_square_root(H[k], sigma).enclose(bits);
  result.theta = exact.theta;
  if (!is_nowhere(cross(as_reals(frame.f2), H))) {
    result.f2 = angle_about(H, exact.second, frame.f2, bits);
    if (exact.normal) result.from_normal = angle_about(H, *exact.normal, frame.f2, bits);
  }
  std::vector<Vector<Rational>> normals{frame.f2};
  if (frame.f3) normals.push_back(*frame.f3);
  for (const auto& f : normals) {
    grow_to(result.orthogonality, cosine(f, H, bits), bits);
    grow_to(result.length, off_unit(f, bits), bits);
  }
  if (frame.f3) {
    if (dot(*frame.f3, *frame.f3) != 0)
      grow_to(result.orthogonality, cosine(frame.f2, as_reals(*frame.f3), bits), bits);
    const Vector<Real> normal = as_reals(cross(frame.f2, *frame.f3));
    result.handedness = sign_of(dot(frame.tangent ? as_reals(*frame.tangent) : H, normal));
  }
  if (frame.tangent) {
    const Vector<Rational>& given = *frame.tangent;
    result.is_reversed = sign_of(dot(as_reals(given), H)) * exact.side < 0;
    const Rational squared_size = dot(given, given);
    grow_to(result.length, off_unit(given, bits), bits);
    const Vector<Real> c = cross(as_reals(given), H);
    result.tangent_sine =  // a vector that is 0 has no direction at all
        squared_size == 0 ? RealBall(1, bits)
                          : root(quotient_of(dot(c, c), sigma * squared_size), bits);
  } else {  // the determinant was that with e₁
    result.handedness =
        exact.side == 0 ? std::abs(result.handedness) : result.handedness * exact.side;
  }
  return result;
}

int sign_beside(const Polynomial& f, const Rational& t) {
  Polynomial derivative = f;
  for (long order = 0;; ++order, derivative = differentiate(derivative))
    if (const Rational value = derivative(t); value != 0)
      return order % 2 == 1 ? 0 : value < 0 ? -1 : 1;
}

}  // namespace phrame
