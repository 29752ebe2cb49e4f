#include "phrame/ph/frame/near_deviation.hpp"

#include <cstdlib>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/quaternion.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// What is not told from 0.
struct NotTold {};

/// Vectors of balls with so many bits.
class Balls {
 public:
  explicit Balls(long bits) : bits_(bits) {}

  RealBall of(const Rational& x) const { return {x, bits_}; }
  Vector<RealBall> of(const Vector<Rational>& v) const { return {of(v[0]), of(v[1]), of(v[2])}; }
  RealBall dot(const Vector<RealBall>& u, const Vector<RealBall>& v) const {
    RealBall sum = multiply(u[0], v[0], bits_);
    for (std::size_t k = 1; k < 3; ++k) sum = add_product(sum, u[k], v[k], bits_);
    return sum;
  }
  Vector<RealBall> cross(const Vector<RealBall>& u, const Vector<RealBall>& v) const {
    const auto minor = [&](std::size_t i, std::size_t j) {
      return subtract(multiply(u[i], v[j], bits_), multiply(u[j], v[i], bits_), bits_);
    };
    return {minor(1, 2), minor(2, 0), minor(0, 1)};
  }
  /// x·u + y·v
  Vector<RealBall> combined(const RealBall& x, const Vector<RealBall>& u, const RealBall& y,
                            const Vector<RealBall>& v) const {
    Vector<RealBall> sum;
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] = add_product(multiply(x, u[k], bits_), y, v[k], bits_);
    return sum;
  }
  RealBall root(const RealBall& x) const { return sqrt_of_nonnegative(x, bits_); }
  RealBall over(const RealBall& x, const RealBall& y) const { return divide(x, y, bits_); }

  /// |f·v|/(|f|·|v|)
  RealBall cosine(const Vector<RealBall>& f, const Vector<RealBall>& v,
                  const RealBall& squares) const {
    return over(absolute(told_or_zero(dot(f, v))), root(squares));
  }
  /// | |f| − 1 |
  RealBall off_unit(const RealBall& square) const {
    return absolute(told_or_zero(subtract(root(square), RealBall(1, bits_), bits_)));
  }
  /// arg(f·e·|H| + i f·(H × e)), up to whole turns.
  RealBall angle_about(const Vector<RealBall>& H, const RealBall& size, const Vector<RealBall>& e,
                       const Vector<RealBall>& f) const {
    const RealBall re = multiply(dot(f, e), size, bits_);
    const RealBall im = dot(cross(f, H), e);
    if (re.contains_zero()) told(im);
    const ComplexBall z(re, im);
    return re.midpoint() >= 0 ? argument(z, bits_) : argument_about_pi(z, bits_);
  }

  static const RealBall& told_or_zero(const RealBall& x) { return x.is_zero() ? x : told(x); }
  static const RealBall& told(const RealBall& x) {
    if (x.contains_zero() || !x.is_finite()) throw NotTold{};
    return x;
  }

 private:
  long bits_;
};

/// A i A*, A j A* and A k A*, of length |A|².
struct ErfBalls {
  Vector<RealBall> i, j, k;
  RealBall size;  ///< |A|²
};

ErfBalls erf_balls(const RationalQuaternion& a, const Balls& balls, long bits) {
  const RealBall u = balls.of(a.u), v = balls.of(a.v), p = balls.of(a.p), q = balls.of(a.q);
  const auto square = [&](const RealBall& x) { return multiply(x, x, bits); };
  const auto twice = [&](const RealBall& x, const RealBall& y, const RealBall& z, const RealBall& w,
                         int sign) {  // 2(xy ± zw)
    const RealBall zw = multiply(z, w, bits);
    const RealBall xy = multiply(x, y, bits);
    return times_power_of_two(sign > 0 ? add(xy, zw, bits) : subtract(xy, zw, bits), 1);
  };
  const RealBall uu = square(u), vv = square(v), pp = square(p), qq = square(q);
  const auto diagonal = [&](const RealBall& plus, const RealBall& x, const RealBall& y) {
    return subtract(add(uu, plus, bits), add(x, y, bits), bits);
  };
  return {{diagonal(vv, pp, qq), twice(v, p, u, q, 1), twice(v, q, u, p, -1)},
          {twice(v, p, u, q, -1), diagonal(pp, vv, qq), twice(p, q, u, v, 1)},
          {twice(v, q, u, p, 1), twice(p, q, u, v, -1), diagonal(qq, vv, pp)},
          add(add(uu, vv, bits), add(pp, qq, bits), bits)};
}

FrameDeviation deviation(const PhSegment& segment, const Rational& t, const RealBall& theta,
                         int side, const GivenFrame& frame, long bits) {
  const long more = bits + 32;
  const Balls balls(more);
  const RationalQuaternion a = evaluate(segment.primitive_preimage(), t);
  const auto [H, second, third, size] = erf_balls(a, balls, more);
  Balls::told(size);
  const RealBall sigma = multiply(size, size, more);

  FrameDeviation result;
  for (std::size_t k = 0; k < 3; ++k) result.e1[k] = balls.over(H[k], size);
  result.theta = theta;
  const Vector<RealBall> f2 = balls.of(frame.f2);
  const RealBall f2_square = Balls::told(balls.dot(f2, f2));
  result.f2 = balls.angle_about(H, size, second, f2);
  const Rational re = segment.bend().re(t);
  const Rational im = segment.bend().im(t);
  if (re != 0 || im != 0)
    result.from_normal = balls.angle_about(
        H, size, balls.combined(balls.of(re), second, balls.of(Rational(-im)), third), f2);

  const auto grow_to = [&](RealBall& x, const RealBall& y) { x = max(x, y, more); };
  const auto add_normal = [&, &H = H](const Vector<RealBall>& f, const RealBall& square) {
    grow_to(result.orthogonality, balls.cosine(f, H, multiply(sigma, square, more)));
    grow_to(result.length, balls.off_unit(square));
  };
  add_normal(f2, f2_square);
  Vector<RealBall> tangent = H;
  if (frame.tangent) tangent = balls.of(*frame.tangent);
  if (frame.f3) {
    const Vector<RealBall> f3 = balls.of(*frame.f3);
    const RealBall f3_square = Balls::told(balls.dot(f3, f3));
    add_normal(f3, f3_square);
    grow_to(result.orthogonality, balls.cosine(f2, f3, multiply(f2_square, f3_square, more)));
    result.handedness = sign(Balls::told(balls.dot(tangent, balls.cross(f2, f3))));
  }
  if (frame.tangent) {
    result.is_reversed = sign(Balls::told(balls.dot(tangent, H))) * side < 0;
    const RealBall square = Balls::told(balls.dot(tangent, tangent));
    grow_to(result.length, balls.off_unit(square));
    const Vector<RealBall> c = balls.cross(tangent, H);
    result.tangent_sine =
        balls.root(balls.over(Balls::told(balls.dot(c, c)), multiply(sigma, square, more)));
  } else {  // the determinant was that with e₁
    result.handedness = side == 0 ? std::abs(result.handedness) : result.handedness * side;
  }
  return result;
}

}  // namespace

std::optional<FrameDeviation> near_deviation(const PhSegment& segment, const Rational& t,
                                             const RealBall& theta, int side,
                                             const GivenFrame& frame, long bits) {
  try {
    return deviation(segment, t, theta, side, frame, bits);
  } catch (const NotTold&) {
    return std::nullopt;
  }
}

}  // namespace phrame
