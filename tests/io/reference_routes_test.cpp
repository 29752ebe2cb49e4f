// The values of reference/ by other ways of phrame than those that made them: these are angles to
// the Euler–Rodrigues frame by the roots of its rate, of curves that are not PH angles to the frame
// of up_vector(); here it is certified quadrature of the rate, and the frames of other vectors.
#include <array>

#include "io/reference.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/frame/closed_curve.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/random.hpp"

namespace reference_routes_test {

using namespace phrame;
using namespace phrame::test;

namespace {

constexpr long bits = 200;

/// Relative to 1, or to the value where that is greater, as docs/reference.md has it.
void check_agrees(const RealBall& found, const std::string& expected) {
  CAPTURE(expected);
  CAPTURE(found);
  const Rational value = parse_rational(expected);
  const Rational most = power_of_ten(-49) * std::max(Rational(1), Rational(abs(value)));
  CHECK(found.is_finite());
  CHECK(abs(found.midpoint() - value) + found.radius() <= most);
}

/// Those that are nowhere along the tangent, but for the one that phrame takes.
std::optional<PathAngle> angle_to_another_frame(const Path& path) {
  const Vector<Rational> usual = up_vector(path);
  for (const Vector<Rational>& v : writhe_projections())
    if (v != usual) try {
        return PathAngle(path, v);
      } catch (const Error&) {
        continue;
      }
  return std::nullopt;
}

void check_frames(const PathAngle& angle, const Json& expected) {
  const StartAngle start = start_angle(LeastRotation(), angle);
  for (std::size_t k = 0; k < expected["at"].size(); ++k) {
    const Place at(locate(angle.path(), rational(expected["at"][k])));
    const Frame<Real> frame = rotation_minimizing_frame(angle, at, start);
    for (std::size_t i = 0; i < 3; ++i) {
      const Json& row = expected["frames"][k];
      check_agrees(frame.e2[i].enclose(bits), row[6 + i].get<std::string>());
      check_agrees(frame.e3[i].enclose(bits), row[9 + i].get<std::string>());
    }
  }
}

void check_ph(const Curve& curve, const Json& expected) {
  if (expected.contains("theta_erf"))
    for (std::size_t k = 0; k < expected["at"].size(); ++k)
      check_agrees(quadrature(rate_to_erf(curve.preimage()), 0, rational(expected["at"][k]), bits),
                   expected["theta_erf"][k].get<std::string>());
}

/// |f|σ/W², where f has one sign.
std::optional<RealBall> length_by_quadrature(const Path& path) {
  RealBall sum;
  for (const Segment& segment : path.segments()) {
    const Curve* curve = ph_curve(segment);
    if (curve == nullptr) return std::nullopt;
    const Signs signs = multiplier_signs(*curve);
    if (signs.positive && signs.negative) return std::nullopt;
    const RationalFunction speed(curve->multiplier() * sigma(curve->preimage()),
                                 curve->weight() * curve->weight());
    sum = add(sum, absolute(quadrature(speed, 0, 1, bits)), bits);
  }
  return sum;
}

}  // namespace

TEST_CASE("reference: other vectors and quadrature give the same values") {
  long frames = 0;
  long lengths = 0;
  long line = 0;
  const long every = everyday(4, 1);
  for (const char* group :
       {"bezier",          "closed",      "corners",      "formulas",      "high-degree",
        "inflections",     "knots",       "long-numbers", "minimal-twist", "near-cusp",
        "ph-splines",      "pipes",       "plane",        "power-basis",   "rational",
        "rational-frames", "rational-ph", "splines",      "tame",          "turning-multiplier"}) {
    std::ifstream file(root(std::string("/reference/") + group + ".jsonl"));
    REQUIRE(file.good());
    for (std::string text; std::getline(file, text);) {
      if (++line % every != 0) continue;
      const Json curve = Json::parse(text);
      const std::string name = curve["name"];
      CAPTURE(name);
      const Json& expected = curve["expected"];
      const Path path = read_any_path(text).path;
      if (const Curve* ph = ph_curve(path.segments().front())) check_ph(*ph, expected);
      if (const auto length = length_by_quadrature(path)) {
        check_agrees(*length, expected["length"].get<std::string>());
        ++lengths;
      }
      const auto angle = angle_to_another_frame(path);
      if (!angle) continue;
      check_frames(*angle, expected);
      if (expected.contains("holonomy"))
        check_agrees(angle->holonomy().value().enclose(bits),
                     expected["holonomy"].get<std::string>());
      if (expected.contains("writhe"))
        if (const auto frame = closed_frame(path, angle->up()))
          check_agrees(writhe(*frame).enclose(bits), expected["writhe"].get<std::string>());
      ++frames;
    }
  }
  MESSAGE(frames << " curves by another frame, " << lengths << " lengths by quadrature");
  CHECK(frames > 15);
  CHECK(lengths > 8);
}

}  // namespace reference_routes_test
