#include "phrame/ph/frame/rotation_ball.hpp"

#include "phrame/algebra/ring_ball.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
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
                                   const RealBall& theta, int sign, long bits) {
  const RealBall at(t, bits + 64);
  const auto component = [&](const Polynomial& p) { return evaluate(p, at, bits + 16); };
  Quaternion<RealBall> b{component(a.u), component(a.v), component(a.p), component(a.q)};
  RealBall square;
  for (const RealBall* x : {&b.u, &b.v, &b.p, &b.q}) square = add_product(square, *x, *x, bits);
  RealBall size = sqrt(square, bits);
  if (sign < 0) size = subtract({}, size, bits);
  if (!theta.is_zero()) {
    const auto [c, s] = cos_sin(times_power_of_two(theta, -1), bits);
    // xc + ys
    const auto turned = [&, c = c](const RealBall& x, const RealBall& y, const RealBall& sine) {
      return add_product(multiply(x, c, bits), y, sine, bits);
    };
    const RealBall minus_s = subtract({}, s, bits);
    b = {turned(b.u, b.v, minus_s), turned(b.v, b.u, s), turned(b.p, b.q, s),
         turned(b.q, b.p, minus_s)};
  }
  return {divide(b.u, size, bits), divide(b.v, size, bits), divide(b.p, size, bits),
          divide(b.q, size, bits)};
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
