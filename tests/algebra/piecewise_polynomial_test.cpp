#include "phrame/algebra/piecewise_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double random_end(Random& random) {
  if (random.chance(3)) return static_cast<double>(random.integer(-2, 2));
  const double x = static_cast<double>(random.integer(-1000, 1000)) / 700;
  return random.chance(4) ? std::ldexp(x, static_cast<int>(random.integer(-700, 700))) : x;
}

/// Polynomials that are 0.
std::optional<PolynomialPiece> zero_piece(double low, double high) {
  auto piece = empty_piece(low, high);
  if (piece) piece->coefficients.assign(static_cast<std::size_t>(plain_shape(1).size()), 0);
  return piece;
}

/// Pieces that are narrow near a point, as those of a curve with a near-cusp are.
PiecewisePolynomial narrow_near(double point, double share, double from, double to) {
  return {from, to, plain_shape(1), [=](double low, double high) {
            auto piece = zero_piece(low, high);
            if (piece)
              piece->coefficients.assign(static_cast<std::size_t>(plain_shape(1).size()), 0);
            const double distance = std::max({low - point, point - high, 1e-6 * (to - from)});
            return piece && high - low <= distance * share ? piece : std::nullopt;
          }};
}

}  // namespace

TEST_CASE(
    "piecewise polynomial: law: every double is found in its piece, with an exact |y| <= 1 or a "
    "tiny one") {
  for_samples(300, [](Random& random) {
    const double a = random_end(random);
    const double b = random_end(random);
    if (a == b) return;
    const double from = std::min(a, b);
    const double to = std::max(a, b);
    const double width = to - from;
    const double point = from + width * static_cast<double>(random.integer(0, 100)) / 100;
    const PiecewisePolynomial p =
        narrow_near(point, static_cast<double>(random.integer(1, 40)) / 4, from, to);
    CAPTURE(from);
    CAPTURE(to);
    REQUIRE(p.ends().size() == p.pieces().size() + 1);
    CHECK(p.from() == from);
    CHECK(p.to() == to);
    const auto check = [&](double t) {
      if (!(from <= t && t <= to)) return;
      CAPTURE(t);
      const auto number = static_cast<std::size_t>(&p.at(t) - p.pieces().data());
      REQUIRE(number < p.pieces().size());
      CHECK(p.ends()[number] <= t);
      CHECK((t < p.ends()[number + 1] || number + 1 == p.pieces().size()));
      const PolynomialPiece& piece = p.pieces()[number];
      const double y = (t - piece.center) * piece.scale;
      const Rational exact =
          (exact_rational(t) - exact_rational(piece.center)) * exact_rational(piece.scale);
      CHECK(abs(exact_rational(y) - exact) <=
            (abs(exact) < power_of_two(-1000) ? power_of_two(-1075) : 0));
      CHECK(std::abs(y) <= 1);
    };
    for (const double end : p.ends())
      for (const double t : {end, std::nextafter(end, -infinity), std::nextafter(end, infinity)})
        check(t);
    for (int k = 0; k < 50; ++k)
      check(from + width * static_cast<double>(random.integer(0, 1L << 50)) * 0x1p-50);
    for (const double tiny : {0.0, -0.0, 0x1p-1074, -0x1p-1074, 1e-300}) check(tiny);
  });
}

TEST_CASE("piecewise polynomial: the limit is one of each interval, and many are no matter") {
  const std::size_t most = PiecewisePolynomial::max_pieces;
  const auto whole = [](double low, double high) { return zero_piece(low, high); };
  CHECK(PiecewisePolynomial::on_units(4 * most, plain_shape(1), whole).pieces().size() == 4 * most);
  // The interval [1, 2] of three needs too many.
  const auto narrow = [](double low, double high) {
    return 1 <= low && high <= 2 && high - low > 1e-5 ? std::nullopt : zero_piece(low, high);
  };
  CHECK_THROWS_WITH_AS(PiecewisePolynomial::on_units(3, plain_shape(1), narrow),
                       doctest::Contains("more than 20000 pieces"), Undecided);
  const auto coarser = [](double low, double high) {
    return 1 <= low && high <= 2 && high - low > 1e-4 ? std::nullopt : zero_piece(low, high);
  };
  CHECK(PiecewisePolynomial::on_units(3, plain_shape(1), coarser).pieces().size() == 2 + 16384);
  // Together they may need more than one may.
  const auto even = [](double low, double high) {
    return high - low > 1e-4 ? std::nullopt : zero_piece(low, high);
  };
  CHECK(PiecewisePolynomial::on_units(3, plain_shape(1), even).pieces().size() == 3 * 16384);
}

TEST_CASE("piecewise polynomial: most doubles of an even division need one comparison") {
  const PiecewisePolynomial p(0, 1, plain_shape(1), [](double low, double high) {
    return high - low > 1.0 / 64 ? std::nullopt : zero_piece(low, high);
  });
  REQUIRE(p.pieces().size() == 64);
  // y takes up all of [−1, 1].
  CHECK(p.pieces()[5].scale == 128);
  for (std::size_t k = 0; k + 1 < p.first().size(); ++k)
    CHECK(p.first()[k + 1] - p.first()[k] <= 1);
}

TEST_CASE("piecewise polynomial: what is no interval, and what has no end, is refused") {
  const auto never = [](double, double) { return std::optional<PolynomialPiece>(); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [from, to] :
       {std::pair{1.0, 1.0}, {1.0, 0.0}, {0.0, infinity}, {nan, 1.0}, {-1.5e308, 1.5e308}})
    CHECK_THROWS_AS(PiecewisePolynomial(from, to, plain_shape(1), never), DomainError);
  CHECK_THROWS_WITH_AS(PiecewisePolynomial(0.25, 1, plain_shape(1), never),
                       doctest::Contains("next to t = 0.25"), Undecided);
}

TEST_CASE("piecewise polynomial: law: on_piece is p at the t of y, as exact as asked for") {
  for_samples(200, [](Random& random) {
    const Polynomial p = random.polynomial(12);
    double from = std::abs(random_end(random));
    if (from > 1e3 || from < 1e-3) from = 0.5;
    auto piece = zero_piece(from, from * (1 + 1.0 / static_cast<double>(random.integer(1, 1000))));
    REQUIRE(piece.has_value());
    const BallPolynomial q = on_piece(p, *piece, 100);
    const Rational y(random.integer(-7, 7), 7);
    const Rational t = exact_rational(piece->center) + y / exact_rational(piece->scale);
    const RealBall value = evaluate(q, RealBall(y, 200), 200);
    CHECK(value.contains(p(t)));
    Rational greatest = 0;
    for (long k = 0; k <= q.degree_bound(); ++k)
      greatest = std::max(greatest, Rational(abs(q.coefficient(k).midpoint())));
    CHECK(value.radius() * power_of_two(90) <= greatest);
    if (p(exact_rational(piece->center)) != 0)
      CHECK(on_piece(p, *piece, 100, true).coefficient(0).accuracy_bits() >= 100);

    CHECK(least(q, 60).lower() <= abs(p(t)));
    CHECK(abs(p(t) - p(exact_rational(piece->center))) <=
          variation(q, 60).upper() * abs(y) + greatest * power_of_two(-80));
  });
  // 1e-200 of 1 is left of this one.
  const Polynomial nearly_zero = pow(Polynomial{-1, 2}, 2) + Polynomial{parse_rational("1e-200")};
  const auto piece = zero_piece(0.25, 0.75);
  CHECK(on_piece(nearly_zero, *piece, 100, true).coefficient(0).accuracy_bits() >= 100);
  CHECK(sign(on_piece(Polynomial{-1, 2}, *piece, 100, true).coefficient(0)) == 0);
}

TEST_CASE("piecewise polynomial: the bound of an integral") {
  // |∫₀^y (3 − 4t + 9t²)| ≤ |y|·(3 + 2 + 3).
  const BallPolynomial p(Polynomial{3, -4, 9}, 60);
  CHECK(integral_bound(p, 60).contains(8));
  CHECK(variation(p, 60).contains(13));
  CHECK(least(p, 60).contains(-10));
}
