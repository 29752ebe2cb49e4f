#include "phrame/ph/frame/frame_quaternion.hpp"

#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

bool is_exact(const Quaternion<Real>& q, const Quaternion<Rational>& expected) {
  return q.u.exact() == expected.u && q.v.exact() == expected.v && q.p.exact() == expected.p &&
         q.q.exact() == expected.q;
}

Frame<Real> rotated_axes(const Quaternion<Rational>& q) {
  const Rational scale = 1 / norm(q);
  const auto unit = [&](const Vector<Rational>& v) {
    return Vector<Real>{Rational(scale * v[0]), Rational(scale * v[1]), Rational(scale * v[2])};
  };
  return {unit(rotated_i(q)), unit(rotated_j(q)), unit(rotated_k(q))};
}

}  // namespace

TEST_CASE("frame quaternion: half turns about the axes and no turn are exact") {
  CHECK(is_exact(quaternion_of(rotated_axes({1, 0, 0, 0})), {1, 0, 0, 0}));
  CHECK(is_exact(quaternion_of(rotated_axes({0, -1, 0, 0})), {0, 1, 0, 0}));
  CHECK(is_exact(quaternion_of(rotated_axes({0, 0, 1, 0})), {0, 0, 1, 0}));
  CHECK(is_exact(quaternion_of(rotated_axes({0, 0, 0, -1})), {0, 0, 0, 1}));
  const Rational half(1, 2);
  CHECK(is_exact(quaternion_of(rotated_axes({-3, 3, 3, -3})), {half, -half, -half, half}));
}

// Q/|Q| for Q ∈ ℚ⁴, of which a component is rational or irrational and known to be.
TEST_CASE("frame quaternion: law: that of the frame of Q is Q/|Q| or its opposite") {
  for_samples(60, [](Random& random) {
    Quaternion<Rational> q;
    while (norm(q) == 0)
      q = {random.rational(), random.rational(), random.rational(), random.rational()};
    const Quaternion<Real> found = quaternion_of(rotated_axes(q));
    const Rational square = 1 / norm(q);
    const auto check = [&](const Real& x, const Rational& of_q) {
      const Real expected = Real(of_q) * square_root_of(square);
      CHECK(std::abs(round_to_double(x)) == std::abs(round_to_double(expected)));
      CHECK(x.exact().has_value() == expected.exact().has_value());
      CHECK((x.exact() || x.origin().is_irrational));
    };
    check(found.u, q.u);
    check(found.v, q.v);
    check(found.p, q.p);
    check(found.q, q.q);
    // The signs belong together: the frame of what was found is the frame.
    const auto rounded = [](const Real& x) { return exact_rational(round_to_double(x)); };
    const Frame<Real> again =
        rotated_axes({rounded(found.u), rounded(found.v), rounded(found.p), rounded(found.q)});
    const Frame<Real> frame = rotated_axes(q);
    for (const auto& [a, b] :
         {std::pair{again.e1, frame.e1}, {again.e2, frame.e2}, {again.e3, frame.e3}})
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(abs(*a[k].exact() - *b[k].exact()) < power_of_two(-48));
  });
}

// (e₁, f₂, f₃) of A at t and the angle θ is that of A·e^{iθ/2}: two ways to one quaternion.
TEST_CASE("frame quaternion: law: a frame turned by theta is that of A·exp(iθ/2)/|A|") {
  for_samples(30, [](Random& random) {
    const Quaternion<Rational> a{random.integer(-9, 9), random.integer(-9, 9),
                                 random.integer(-9, 9), random.integer(1, 9)};
    const Rational theta = Rational(random.integer(1, 600), 100);
    const Quaternion<Real> found = quaternion_of(turned(rotated_axes(a), theta));
    constexpr long bits = 200;
    const CosSin turn = cos_sin(RealBall(theta / 2, bits), bits);
    const RealBall root = sqrt(RealBall(norm(a), bits), bits);
    const auto over_root = [&](const Rational& x, const Rational& y) {  // (x cos + y sin)/|A|
      return divide(add(multiply(turn.cos, RealBall(x, bits), bits),
                        multiply(turn.sin, RealBall(y, bits), bits), bits),
                    root, bits);
    };
    // (u + vi)(c + si) and (pj + qk)(c + si) = (pc + qs)j + (qc − ps)k
    const std::array expected{over_root(a.u, -a.v), over_root(a.v, a.u), over_root(a.p, a.q),
                              over_root(a.q, -a.p)};
    const std::array balls{found.u.enclose(bits), found.v.enclose(bits), found.p.enclose(bits),
                           found.q.enclose(bits)};
    const auto agree = [&](bool is_negated) {
      return std::equal(balls.begin(), balls.end(), expected.begin(), [&](auto& x, auto& y) {
        return x.accuracy_bits() > 100 &&
               x.overlaps(is_negated ? subtract(RealBall(0, bits), y, bits) : y);
      });
    };
    CHECK((agree(false) || agree(true)));
  });
}
