// The parameter of a length or a time very near to an end was looked for beyond it, where s and T
// need not increase: the result was −2⁻³⁰, or an error.
#include <doctest/doctest.h>

#include "phrame/ph/along/travel_time.hpp"

using namespace phrame;

namespace {

std::string digits(const Real& x) { return round_to_decimal(x, 30).value; }

const QuaternionPolynomial line{{1}, {}, {}, {}};

}  // namespace

TEST_CASE("near an end: the parameter of an arc length, where the speed vanishes at the end") {
  // s = t²/2, and s = t − t²/2; √2 = 1.41421356237309504880168872421.
  const ArcLength start(Curve(line, {0, 1}));
  CHECK(digits(start.parameter(parse_rational("1e-36"))) == "1.41421356237309504880168872421e-18");
  CHECK(digits(start.parameter(parse_rational("1e-200"))) ==
        "1.41421356237309504880168872421e-100");
  CHECK(start.parameter(parse_rational("2e-60")).exact() == parse_rational("2e-30"));
  CHECK(digits(to_real(start.algebraic_parameter(parse_rational("1e-60")))) ==
        "1.41421356237309504880168872421e-30");
  const ArcLength end(Curve(line, {1, -1}));
  CHECK(digits(end.parameter(Rational(1, 2) - parse_rational("1e-38"))) ==
        "0.999999999999999999858578643763");
}

TEST_CASE("near an end: the parameter of a time, where the feedrate nearly vanishes at the end") {
  // V = t + ε: ξ = (e − 1)ε at time 1.
  const Polynomial v{parse_rational("1e-25"), 1};
  TravelTime motion(Path(PhSegment(Curve(line))), {RationalFunction(v), Feedrate::Of::parameter});
  CHECK(digits(motion.at_time(1).at.t) == "1.71828182845904523536028747135e-25");
}
