#include "phrame/ph/sweep/length_share.hpp"

#include <cmath>

#include <doctest/doctest.h>
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "support/curves.hpp"

using namespace phrame;

namespace {

/// (t, 0, 0), and an arc of a parabola from its end.
Path line_and_parabola() {
  Path path(RationalCurve({Polynomial{0, 1}, Polynomial(), Polynomial()}));
  path.append(RationalCurve({Polynomial{1, 1}, Polynomial{0, 0, 1}, Polynomial()}));
  return path;
}

}  // namespace

TEST_CASE("length share: along a PH curve it is the exact one") {
  const LengthShare share(series_of(PhPath(test::quintic)));
  const ArcLength exact(test::quintic);
  const Rational whole = exact.polynomial()(1);
  CHECK(std::abs(share.length() / round_to_double(whole) - 1) <= share.error());
  CHECK(share.error() < 1e-12);
  for (long k = 0; k <= 64; ++k) {
    const double expected = round_to_double(Rational(exact.polynomial()(Rational(k, 64)) / whole));
    CHECK(std::abs(share(0, static_cast<double>(k) / 64) - expected) <= share.error());
  }
}

// ∫₀ᵗ √(1 + 4t²) = t√(1 + 4t²)/2 + asinh(2t)/4
TEST_CASE("length share: over several segments of any kind") {
  const LengthShare share(series_of(line_and_parabola()));
  const auto parabola = [](double t) {
    return t * std::sqrt(1 + 4 * t * t) / 2 + std::asinh(2 * t) / 4;
  };
  const double whole = 1 + parabola(1);
  CHECK(std::abs(share.length() - whole) < 1e-13);
  CHECK(share(0, 0) == 0);
  CHECK(std::abs(share(0, 0.3) - 0.3 / whole) < 1e-14);
  CHECK(std::abs(share(1, 0.7) - (1 + parabola(0.7)) / whole) < 1e-14);
  CHECK(std::abs(share(1, 1) - 1) < 1e-14);
}

// r = (t, c(t − 1/2)²) with a sharp bend in the middle: 2c·s = 2cx√(1 + 4c²x²)/2 + asinh(2cx)/2 for
// x = t − 1/2, counted from there. One piece for all of it would be off by far more than the bound.
TEST_CASE("length share: where a curve bends sharply the remainders are counted") {
  const double c = 1000;
  const LengthShare share(series_of(
      Path(RationalCurve({Polynomial{0, 1}, Polynomial{250, -1000, 1000}, Polynomial()}))));
  const auto from_middle = [&](double x) {
    const double y = 2 * c * x;
    return (y * std::sqrt(1 + y * y) + std::asinh(y)) / (4 * c);
  };
  CHECK(std::abs(share.length() / (2 * from_middle(0.5)) - 1) <= share.error());
  CHECK(share.error() < 1e-11);
  for (int k = -32; k <= 32; ++k) {
    const double x = k / 64.0 * (k % 2 == 0 ? 1 : 0x1p-6);
    const double expected = 0.5 + from_middle(x) / (2 * from_middle(0.5));
    CHECK(std::abs(share(0, 0.5 + x) - expected) <= share.error());
  }
}

TEST_CASE("length share: where the path turns back in a cusp it is undecided") {
  const PhPath cusp(Curve({{1}, {}, {}, {0, 1}}, Polynomial{Rational(-1, 3), 1}));
  CHECK_THROWS_AS(LengthShare(series_of(cusp)), Undecided);
}

// |r′| = t(1 + t²)
TEST_CASE("length share: through a cusp at an end it goes on") {
  const LengthShare share(series_of(PhPath(Curve({{1}, {}, {}, {0, 1}}, Polynomial{0, 1}))));
  CHECK(std::abs(share.length() / 0.75 - 1) <= share.error());
  for (double t = 0; t <= 1; t += 0x1p-6)
    CHECK(std::abs(share(0, t) - (t * t / 2 + t * t * t * t / 4) / 0.75) <= share.error());
}
