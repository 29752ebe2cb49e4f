#include "phrame/algebra/rounded_values.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/rational.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace rounded_values_test {

/// Polynomials near random ones, of which the exact values are known. The error is that of rounding
/// and what is left of goal.
struct Known {
  std::vector<BallPolynomial> exact;
  PiecewisePolynomial p;

  Known(Random& random, double goal) : p(make(random, goal, exact)) {}

  static PiecewisePolynomial make(Random& random, double goal, std::vector<BallPolynomial>& exact) {
    const DoubleShape shape = compensated_shape(1);
    return {0, 1, shape, [&](double low, double high) {
              auto piece = empty_piece(low, high);
              if (!piece || high - low > 0.3) return std::optional<PolynomialPiece>();
              std::vector<RealBall> c;
              for (long k = 0; k <= shape.degree; ++k)
                c.emplace_back(
                    Rational(random.integer(-1L << 50, 1L << 50)) / 3 * power_of_two(-4 * k), 200);
              const BallPolynomial found(c);
              piece->coefficients = round_coefficients({found}, shape);
              exact.push_back(exact_polynomial(piece->coefficients, shape, 0));
              piece->error = rounding_error(piece->coefficients, shape, 0) + goal;
              piece->error_per_y = 2 * goal;
              return piece;
            }};
  }
};

TEST_CASE("rounded values: law: the nearest doubles, the same by whatever the processor has") {
  long told = 0;
  for_samples(20, [&](Random& random) {
    const Known known(random, random.chance(2) ? 0 : 0.02);
    std::vector<double> t{0, 1};
    while (random.integer(0, 60) != 0)
      t.push_back(std::ldexp(static_cast<double>(random.integer(0, 1L << 53)), -53));
    if (random.chance(2)) std::sort(t.begin(), t.end());
    for (const std::size_t at_once : {2U, 4U, 8U}) {
      if (at_once > widest()) continue;
      CAPTURE(at_once);
      std::vector<double> values(t.size());
      const std::vector<std::size_t> untold = rounded_values(known.p, t, values, at_once);
      CHECK(std::is_sorted(untold.begin(), untold.end()));
      for (std::size_t k = 0; k < t.size(); ++k) {
        CAPTURE(t[k]);
        const std::size_t number = known.p.index_at(t[k]);
        const PolynomialPiece& piece = known.p.pieces()[number];
        const auto [one] =
            evaluate_compensated<1>(piece.coefficients.data(), known.p.shape(), piece.y(t[k]));
        const double error = piece.error + piece.error_per_y * std::abs(piece.y(t[k]));
        const bool is_told = common_double(one, error).has_value();
        CHECK(std::binary_search(untold.begin(), untold.end(), k) == !is_told);
        if (!is_told) continue;
        ++told;
        const RealBall value =
            evaluate(known.exact[number], RealBall(exact_rational(piece.y(t[k])), 400), 400);
        CHECK(values[k] == round_to_double(value.midpoint()));
      }
    }
  });
  CHECK(told > 500);
}

// Of numbers that are doubles, that are sums of two, and that are known to some error; next to the
// ends of pieces, too, where nothing is told.
TEST_CASE("rounded values: law: of near numbers those that are told are the nearest doubles") {
  long told = 0;
  for_samples(20, [&](Random& random) {
    const Known known(random, 0);
    std::vector<Rational> exact;
    NearNumbers t(static_cast<std::size_t>(random.integer(1, 60)), 0);
    for (std::size_t k = 0; k < t.size(); ++k) {
      const bool is_near_end = random.chance(4);
      const double end = known.p.ends()[static_cast<std::size_t>(
          random.integer(1, static_cast<long>(known.p.ends().size()) - 2))];
      const double high = is_near_end
                              ? std::nextafter(end, random.chance(2) ? 0 : 1)
                              : std::ldexp(static_cast<double>(random.integer(0, 1L << 53)), -53);
      const double low =
          random.chance(3) ? 0 : std::ldexp(static_cast<double>(random.integer(-999, 999)), -65);
      const double error = low == 0 || random.chance(2) ? 0 : 0x1p-100;
      t.set(k, {{high, low}, error});
      exact.push_back(exact_rational(high) + exact_rational(low));
    }
    for (const std::size_t at_once : {2U, 4U, 8U}) {
      if (at_once > widest()) continue;
      CAPTURE(at_once);
      std::vector<double> values(t.size());
      const std::vector<std::size_t> untold = rounded_values(known.p, t, values, at_once);
      for (std::size_t k = 0; k < t.size(); ++k) {
        CAPTURE(t.high[k]);
        CAPTURE(t.low[k]);
        const NearNumber one{{t.high[k], t.low[k]}, t.error[k]};
        const auto near = near_values<1>(known.p, one);
        const auto rounded = near ? common_double(near->values[0], near->error) : std::nullopt;
        CHECK(std::binary_search(untold.begin(), untold.end(), k) == !rounded);
        if (!rounded) continue;
        ++told;
        const std::size_t number = known.p.index_at(t.high[k]);
        const PolynomialPiece& piece = known.p.pieces()[number];
        const Rational y = (exact[k] - exact_rational(piece.center)) * exact_rational(piece.scale);
        const RealBall value = evaluate(known.exact[number], RealBall(y, 400), 400);
        CHECK(values[k] == round_to_double(value.midpoint()));
      }
    }
  });
  CHECK(told > 500);
}

}  // namespace rounded_values_test
