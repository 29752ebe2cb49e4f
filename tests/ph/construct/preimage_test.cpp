#include "phrame/ph/construct/preimage.hpp"

#include <cmath>

#include "phrame/algebra/big_float.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

RationalQuaternion random_quaternion(Random& random) {
  return {random.rational(), random.rational(), random.rational(), random.rational()};
}

constexpr double tiny = 1e-300;
const std::vector<Vector<double>> directions{
    {1, 0, 0},     {-1, 0, 0},      {0, 1, 0},        {0, 0, -1},    {-1, 1e-12, -1e-13},
    {-1, tiny, 0}, {3, 4, 0},       {-0.8, 0.3, 1.2}, {-1e-9, 1, 1}, {1e100, -1e90, 1e99},
    {0, -1, 0},    {-1e-100, 0, 0}, {5e-3, -2e-3, 7}};

}  // namespace

TEST_CASE("S(A, B) is (A i B* + B i A*)/2, a vector, and S(A, A) is A i A*") {
  for_samples(50, [](Random& random) {
    const RationalQuaternion a = random_quaternion(random);
    const RationalQuaternion b = random_quaternion(random);
    const RationalQuaternion i{0, 1, 0, 0};
    const RationalQuaternion sum = a * i * conjugate(b) + b * i * conjugate(a);
    const Vector<Rational> s = symmetric_product(a, b);
    CHECK(sum == RationalQuaternion{0, 2 * s[0], 2 * s[1], 2 * s[2]});
    CHECK(symmetric_product(a, a) == rotated_i(a));
  });
}

TEST_CASE("H(A, B) = A·B + iω(A, B): linear over ℂ in B, and |H|² = ½(|A|²|B|² + S(A,A)·S(B,B))") {
  for_samples(50, [](Random& random) {
    const RationalQuaternion a = random_quaternion(random);
    const RationalQuaternion b = random_quaternion(random);
    const ComplexOf<Rational> z{random.rational(), random.rational()};
    const auto h = hermitian_product(a, b);
    const auto turned_h = hermitian_product(a, turned(b, z));
    const auto product = z * h;
    CHECK(turned_h.re == product.re);
    CHECK(turned_h.im == product.im);
    CHECK(2 * (h.re * h.re + h.im * h.im) == norm(a) * norm(b) + dot(rotated_i(a), rotated_i(b)));
    // A·z is the product with z = re + im·i from the right.
    CHECK(turned(b, z) == b * RationalQuaternion{z.re, z.im, 0, 0});
  });
}

TEST_CASE("wedge(A, B) is 0 for B = A·z, is ℂ-linear in both, and |wedge|² + |H|² = |A|²|B|²") {
  for_samples(50, [](Random& random) {
    const RationalQuaternion a = random_quaternion(random);
    const RationalQuaternion b = random_quaternion(random);
    const ComplexOf<Rational> z{random.rational(), random.rational()};
    const auto none = wedge(a, turned(a, z));
    CHECK((none.re == 0 && none.im == 0));
    const auto w = wedge(a, b);
    const auto h = hermitian_product(a, b);
    CHECK(w.re * w.re + w.im * w.im + h.re * h.re + h.im * h.im == norm(a) * norm(b));
    const auto product = z * w;
    CHECK(wedge(turned(a, z), b).re == product.re);
    CHECK(wedge(a, turned(b, z)).im == product.im);
  });
}

TEST_CASE("preimage(d): A i A* = d to a few units of the last place, in all directions") {
  for (const Vector<double>& d : directions) {
    CAPTURE(d[0]);
    CAPTURE(d[1]);
    const Vector<double> found = rotated_i(preimage(d));
    const double size = std::sqrt(dot(d, d));
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(found[k] - d[k]) <= 4e-16 * size);
  }
  CHECK(preimage(Vector<double>{0, 0, 0}) == Quaternion<double>{0, 0, 0, 0});
}

TEST_CASE("preimage(d): a small component has its own digits where the direction is nearly −x") {
  const Vector<double> found = rotated_i(preimage(Vector<double>{-1, 1e-12, -1e-13}));
  CHECK(std::abs(found[1] - 1e-12) < 1e-27);
  CHECK(std::abs(found[2] + 1e-13) < 1e-28);
}

TEST_CASE("preimage(d) with 300 bits is as near as they allow") {
  for (const Vector<double>& d : directions) {
    CAPTURE(d[0]);
    const auto number = [](double x) { return BigFloat(exact_rational(x), 300); };
    const auto found =
        rotated_i(preimage(Vector<BigFloat>{number(d[0]), number(d[1]), number(d[2])}));
    for (std::size_t k = 0; k < 3; ++k) {
      const long places = 290 - static_cast<long>(std::ilogb(std::sqrt(dot(d, d))));
      const Rational off =
          Rational(found[k].scaled(places)) - exact_rational(d[k]) * power_of_two(places);
      CHECK(abs(off) <= 2);
    }
  }
}

TEST_CASE("direction_of: of size 1, and 1 where the number means nothing") {
  const auto z = direction_of(ComplexOf<double>{3, -4}, 0.0);
  CHECK(std::abs(z.re - 0.6) < 1e-15);
  CHECK(std::abs(z.im + 0.8) < 1e-15);
  CHECK(direction_of(ComplexOf<double>{0, 0}, 0.0).re == 1);
  CHECK(direction_of(ComplexOf<double>{0, 1e-20}, 1e-15).im == 0);
}
