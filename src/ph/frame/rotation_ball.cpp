#include "phrame/ph/frame/rotation_ball.hpp"

#include "phrame/algebra/ring_ball.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame {
namespace {

using Ball = RingBall<rotation_bits>;

std::optional<Vector<double>> rounded(const Vector<Ball>& v) {
  Vector<double> found;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto x = common_double(v[i].x);
    if (!x) return std::nullopt;
    found[i] = *x;
  }
  return found;
}

}  // namespace

Quaternion<RealBall> rotation_ball(const QuaternionPolynomial& a, const Rational& t,
                                   const RealBall& theta, int sign) {
  const RealBall at(t, rotation_bits + 64);
  const auto component = [&](const Polynomial& p) {
    return Ball{evaluate(p, at, rotation_bits + 16)};
  };
  const Quaternion<Ball> here{component(a.u), component(a.v), component(a.p), component(a.q)};
  RealBall size = sqrt(norm(here).x, rotation_bits);
  if (sign < 0) size = subtract({}, size, rotation_bits);
  Quaternion<Ball> turn{{RealBall(Rational(1), rotation_bits)}, {}, {}, {}};
  if (!theta.is_zero()) {
    const CosSin half = cos_sin(times_power_of_two(theta, -1), rotation_bits);
    turn = {{half.cos}, {half.sin}, {}, {}};
  }
  const Quaternion<Ball> b = here * turn;
  const auto over_size = [&](const Ball& x) { return divide(x.x, size, rotation_bits); };
  return {over_size(b.u), over_size(b.v), over_size(b.p), over_size(b.q)};
}

std::optional<Frame<double>> rounded_frame(const Quaternion<RealBall>& b) {
  const Quaternion<Ball> unit{{b.u}, {b.v}, {b.p}, {b.q}};
  const auto e1 = rounded(rotated_i(unit));
  const auto e2 = rounded(rotated_j(unit));
  const auto e3 = rounded(rotated_k(unit));
  if (!e1 || !e2 || !e3) return std::nullopt;
  return Frame<double>{*e1, *e2, *e3};
}

}  // namespace phrame
