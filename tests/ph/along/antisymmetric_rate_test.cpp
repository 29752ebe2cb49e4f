// Symmetries are those of the curves by construction; that their angles are 0 there quadrature
// says, too (tests/certificates/certificates_formulas_check.py).
#include "phrame/ph/along/antisymmetric_rate.hpp"

#include <doctest/doctest.h>

#include "phrame/io/read/formula.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/rational_rates.hpp"

using namespace phrame;

namespace {

Formula formula(const char* text) { return parse_formula(text, "s").value; }

/// To the frame of (0, 0, 1), or to the Frenet frame.
bool has(const char* x, const char* y, const char* z, const char* to, const Rational& t,
         const Antisymmetry& symmetry, bool is_frenet = false,
         const Integer& most = 1'000'000'000) {
  const auto up = is_frenet ? std::nullopt : std::optional(Vector<Rational>{0, 0, 1});
  return has_antisymmetry({formula(x), formula(y), formula(z)}, Formula(0), formula(to), up, t,
                          symmetry, most);
}

const Rational half(1, 2);

}  // namespace

TEST_CASE("antisymmetric rates along formulas") {
  const Antisymmetry mirror;
  CHECK(has("2*cos(s)", "sin(s)", "cos(2*s)/7", "2*pi", half, mirror));
  CHECK(has("2*cos(s)", "sin(s)", "cos(2*s)/7", "2*pi", 1, mirror));
  CHECK(!has("2*cos(s)", "sin(s)", "cos(2*s)/7", "2*pi", Rational(1, 3), mirror));
  CHECK(!has("2*cos(s)", "sin(s)", "sin(2*s)/7", "2*pi", half, mirror));  // a half turn
  CHECK(has("cos(s)", "sin(s)", "sin(2*s)", "2*pi", half, {Rational(1, 4)}));
  CHECK(has("cos(s)", "sin(s)", "sin(2*s)", "2*pi", half, {Rational(1, 4)}, true));
  CHECK(!has("cos(s)", "sin(s)", "sin(2*s) + s", "2*pi", half, {Rational(1, 4)}));
  CHECK(!has("cos(s)", "sin(s)", "sin(2*s)", "2*pi", 1, {half}));  // a turn about v
  CHECK(!has("2*cos(s)", "sin(s)", "exp(2)", "2*pi", half, mirror));
  // N is odd, but D is not even: y″ = 1 + sin u and z′ = (1 − sin u)·sin u for u = s − 1.
  const char* y = "(s - 1)^2/2 - sin(s - 1)";
  const char* z = "sin(2*s - 2)/4 - cos(s - 1) - s/2";
  CHECK(!has("s", y, z, "2", 1, mirror));
  CHECK(!has("2*cos(s)", "sin(s)", "cos(2*s)/7", "2*pi", half, mirror, false, 100'000));
}

TEST_CASE("antisymmetric rates of rational curves") {
  const Vector<Rational> up{0, 0, 1};
  const Polynomial bump{0, 1, -1};
  const RationalCurve even({Polynomial{0, 1}, bump, bump * bump}, Polynomial{1});
  // The same of u = 2t − 1: y″ = 4(1 + u), z′ = 2u(1 − u).
  const Polynomial u{-1, 2};
  const RationalCurve near({Polynomial{0, 1}, half * u * u + Rational(1, 6) * u * u * u,
                            half * u * u - Rational(1, 3) * u * u * u},
                           Polynomial{1});
  CHECK(!has_antisymmetry(up_frame_turning(near, up), 1, {}));
  const RationalCurve odd({Polynomial{0, 1}, bump, bump * Polynomial{-1, 2}}, Polynomial{1});
  CHECK(has_antisymmetry(up_frame_turning(even, up), 1, {}));
  CHECK(!has_antisymmetry(up_frame_turning(even, up), Rational(3, 4), {}));
  CHECK(!has_antisymmetry(up_frame_turning(even, up), 1, {half}));
  CHECK(!has_antisymmetry(up_frame_turning(odd, up), 1, {}));
  CHECK(has_antisymmetry(frenet_turning(even), 1, {}));
}

TEST_CASE("an angle is exactly 0 by a symmetry") {
  const ExpressionCurve eight({formula("2*cos(s)"), formula("sin(s)"), formula("cos(2*s)/7")},
                              Formula(0), formula("2*pi"));
  const PathAngle angle(Path(eight), Vector<Rational>{0, 0, 1});
  CHECK(angle.value(half).exact() == Rational(0));
  CHECK(angle.value(1).exact() == Rational(0));
  CHECK(!angle.value(Rational(1, 4)).exact());
  CHECK(angle.holonomy().value().exact() == Rational(0));
}
