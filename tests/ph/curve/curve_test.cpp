#include "phrame/ph/curve/curve.hpp"

#include <sstream>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("curve: zero preimages and multipliers are refused") {
  CHECK_THROWS_AS(Curve({}), DomainError);
  CHECK_THROWS_AS(Curve({{1}, {}, {}, {}}, Polynomial()), DomainError);
}

TEST_CASE("curve: degrees; the cubic with A = 1 + t·j runs along (1 − t², 0, −2t)") {
  const Curve curve({{1}, {}, {0, 1}, {}});
  CHECK(degree(curve) == 3);
  CHECK(preimage_degree(curve) == 1);
  CHECK(hodograph(curve) ==
        Vector<Polynomial>{Polynomial{1, 0, -1}, Polynomial{}, Polynomial{0, -2}});
  CHECK(degree(Curve({{1}, {}, {0, 1}, {}}, {0, 0, 1})) == 5);
}

TEST_CASE("curve: the double PH curve of degree 7 needs the multiplier 1/3") {
  // Beltran & Monterde's curve: 3r′ = B i B*, B = (3t − t³) − 3t² i + 3k.
  const Curve curve({{0, 3, 0, -1}, {0, 0, -3}, {}, {3}}, {Rational(1, 3)});
  const Polynomial speed = Rational(1, 3) * norm(curve.preimage());
  const auto r = hodograph(curve);
  CHECK(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] == speed * speed);
  // |B|² = (3t − t³)² + 9t⁴ + 9 = t⁶ + 3t⁴ + 9t² + 9, by hand.
  CHECK(norm(curve.preimage()) == Polynomial{9, 0, 9, 0, 3, 0, 1});
}

TEST_CASE("curve: law: |r′| = |f|σ, and Bézier points give back the curve") {
  for_samples(60, [](Random& random) {
    const Curve curve = random.curve(4);
    const auto r1 = hodograph(curve);
    const Polynomial speed = curve.multiplier() * norm(curve.preimage());
    CHECK(r1[0] * r1[0] + r1[1] * r1[1] + r1[2] * r1[2] == speed * speed);
    const auto r = position(curve);
    CHECK(evaluate(r, 0) == curve.start());
    const auto points = control_points(curve);
    CHECK(static_cast<long>(points.size()) == degree(curve) + 1);
    CHECK(points.front() == curve.start());
    CHECK(points.back() == evaluate(r, 1));
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<Rational> b;
      for (const auto& point : points) b.push_back(point[k]);
      CHECK(from_bernstein(b) == r[k]);
    }
  });
}

TEST_CASE("Bernstein: law: the sum of basis polynomials, written out") {
  CHECK(from_bernstein({1, 1, 1}) == Polynomial{1});
  CHECK(from_bernstein({0, Rational(1, 2), 1}) == Polynomial{0, 1});
  CHECK_THROWS_AS(to_bernstein({0, 0, 1}, 1), DomainError);
  for_samples(60, [](Random& random) {
    std::vector<Rational> b;
    for (long k = random.integer(0, 6); k >= 0; --k) b.push_back(random.rational());
    const auto m = static_cast<long>(b.size()) - 1;
    Polynomial sum;
    Rational binomial = 1;
    for (long r = 0; r <= m; ++r) {
      sum += b[static_cast<std::size_t>(r)] * binomial * pow(Polynomial{1, -1}, m - r) *
             pow(Polynomial{0, 1}, r);
      binomial = binomial * (m - r) / (r + 1);
    }
    CHECK(from_bernstein(b) == sum);
    CHECK(to_bernstein(sum, m) == b);
    CHECK(from_bernstein(to_bernstein(sum, m + 3)) == sum);  // degree elevation
  });
}

TEST_CASE("curve: the signs of the multiplier on [0, 1] are exact") {
  const auto signs = [](const Polynomial& f) {
    return multiplier_signs(Curve({{1}, {}, {}, {}}, f));
  };
  constexpr Signs positive{true, false};
  constexpr Signs negative{false, true};
  constexpr Signs both{true, true};
  CHECK(signs({3}) == positive);
  CHECK(signs({-3}) == negative);
  CHECK(signs({-1, 2}) == both);
  CHECK(signs({2, -1}) == positive);  // a root beyond 1
  CHECK(signs({0, 1}) == positive);   // and at an end
  CHECK(signs({0, -1, 1}) == negative);
  CHECK(signs({1, -4, 4}) == positive);  // a double root at 1/2
  CHECK(signs({-1, 0, 2}) == both);      // a root at 1/√2
  CHECK(signs({1, 0, -4, 0, 4}) == positive);
  const auto at = [](const char* root) { return Polynomial{-parse_rational(root), 1}; };
  CHECK(signs(at("1/3") * at("1/2") * at("1/2")) == both);
  // Negative between 1/3 and 1/3 + 10⁻⁵⁰ only.
  const Polynomial near = at("1/3") * Polynomial{-Rational(1, 3) - parse_rational("1e-50"), 1};
  CHECK(signs(near) == both);
  CHECK(signs(pow(near, 2)) == positive);
  CHECK(signs(Polynomial{0, 1, -1} * near) == both);
  CHECK(signs(-at("0") * at("1") * pow(at("1/2"), 2)) == positive);
}

TEST_CASE("curve: law: the signs of the multiplier are those of its values") {
  for_samples(100, [](Random& random) {
    const Curve curve({{1}, {}, {}, {}}, random.nonzero_polynomial(5));
    const Signs signs = multiplier_signs(curve);
    CHECK((signs.positive || signs.negative));
    for (long k = 0; k <= 64; ++k) {
      const Rational value = curve.multiplier()(Rational(k, 64));
      CHECK((value <= 0 || signs.positive));
      CHECK((value >= 0 || signs.negative));
    }
    const Signs opposite = multiplier_signs(Curve(curve.preimage(), -curve.multiplier()));
    CHECK(opposite == Signs{signs.negative, signs.positive});
  });
}

TEST_CASE("Bézier hodograph: law: the derivative of the curve with these points") {
  CHECK_THROWS_AS(bezier_hodograph({}), DomainError);
  CHECK(bezier_hodograph({{1, 2, 3}}) == Vector<Polynomial>{});
  CHECK(bezier_hodograph({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}) ==
        Vector<Polynomial>{Polynomial{2, -2}, Polynomial{0, 2}, Polynomial{}});
  for_samples(30, [](Random& random) {
    const Curve curve = random.curve(3);
    CHECK(bezier_hodograph(control_points(curve)) == hodograph(curve));
  });
}

TEST_CASE("a curve is printed on one line") {
  std::ostringstream text;
  text << Curve({{1, 1}, {2}, {}, {}}, Polynomial{-3}, {0, 1, 2});
  CHECK(text.str() == "A = (t + 1, 2, 0, 0), f = -3, r(0) = (0, 1, 2)");
}
