#include "phrame/ph/curve/quaternion.hpp"

#include <sstream>

#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("quaternion: i² = j² = k² = ijk = −1") {
  const RationalQuaternion i{0, 1, 0, 0};
  const RationalQuaternion j{0, 0, 1, 0};
  const RationalQuaternion k{0, 0, 0, 1};
  const RationalQuaternion minus_one{-1, 0, 0, 0};
  CHECK(i * i == minus_one);
  CHECK(j * j == minus_one);
  CHECK(k * k == minus_one);
  CHECK(i * j * k == minus_one);
  CHECK(i * j == k);
}

TEST_CASE(
    "quaternion: law: A i A*, A j A*, A k A* by the product itself; the norm is multiplicative") {
  for_samples(60, [](Random& random) {
    const QuaternionPolynomial a = random.quaternion_polynomial(3);
    const QuaternionPolynomial b = random.quaternion_polynomial(3);
    const QuaternionPolynomial conjugate{a.u, -a.v, -a.p, -a.q};
    const auto sandwich = [&](const QuaternionPolynomial& unit) {
      const QuaternionPolynomial product = a * unit * conjugate;
      CHECK(product.u.is_zero());
      return Vector<Polynomial>{product.v, product.p, product.q};
    };
    CHECK(rotated_i(a) == sandwich({{}, {1}, {}, {}}));
    CHECK(rotated_j(a) == sandwich({{}, {}, {1}, {}}));
    CHECK(rotated_k(a) == sandwich({{}, {}, {}, {1}}));
    CHECK(norm(a * b) == norm(a) * norm(b));
    const HopfForm form = hopf_form(a);
    CHECK(from_hopf_form(form) == a);
    CHECK(norm(form.alpha) + norm(form.beta) == norm(a));
    const Rational t = random.rational();
    CHECK(norm(evaluate(a, t)) == norm(a)(t));
    CHECK((a.u % real_content(a)).is_zero());
    const QuaternionPolynomial rest = without_real_content(a);
    CHECK(real_content(rest) == Polynomial{1});
    CHECK(real_content(a) * rest.q == a.q);
    CHECK(real_content(a) * rest.p == a.p);
  });
}

TEST_CASE("vectors and quaternions are printed by their components") {
  std::ostringstream text;
  text << Vector<Rational>{1, 0, Rational(2, 3)} << Vector<Polynomial>{Polynomial{0, 1}, {}, {}}
       << RationalQuaternion{1, 2, 3, 4} << QuaternionPolynomial{{}, {1}, {0, 2}, {}};
  CHECK(text.str() == "(1, 0, 2/3)(t, 0, 0)(1, 2, 3, 4)(0, 1, 2*t, 0)");
}
