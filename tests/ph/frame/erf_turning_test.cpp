#include "phrame/ph/frame/erf_turning.hpp"

#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::quintic;

TEST_CASE("ERF turning: its zeros and extrema") {
  // The quintic of Farouki 2003: h = 4t(t − 1), so that it turns back only at the ends.
  const ErfTurning turning = erf_turning(quintic);
  CHECK(turning.zeros == std::vector<RealRoot>{{Rational(0), 1}, {Rational(1), 1}});
  CHECK(turning.is_monotone);
  REQUIRE(turning.extrema.size() == 1);
  const Polynomial s = sigma(quintic.preimage());
  const Polynomial h = twist_numerator(quintic.preimage());
  CHECK(sign_at(s * differentiate(h) - Rational(2) * differentiate(s) * h, turning.extrema[0].at) ==
        0);
  // α = 1 + it, β = 0: ω₁ = 2/(1 + t²)² is greatest at 0.
  const ErfTurning line = erf_turning(Curve({{1}, {0, 1}, {}, {}}));
  CHECK(line.zeros.empty());
  CHECK(line.extrema == std::vector<RealRoot>{{Rational(0), 1}});
  // u = 1, v = t − t²: h = 1 − 2t.
  const ErfTurning back = erf_turning(Curve({{1}, {0, 1, -1}, {}, {}}));
  CHECK(back.zeros == std::vector<RealRoot>{{Rational(1, 2), 1}});
  CHECK_FALSE(back.is_monotone);
}
