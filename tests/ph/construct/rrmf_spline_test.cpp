#include "phrame/ph/construct/rrmf_spline.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/construct/rrmf_quintic.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/proof/classify.hpp"
#include "support/hermite.hpp"

namespace rrmf_spline_test {

using namespace phrame;
using test::for_samples;
using test::one_segment;
using test::Random;

namespace {

Vector<Rational> vector(const char* x, const char* y, const char* z) {
  return {parse_rational(x), parse_rational(y), parse_rational(z)};
}

void check_met(const Construction& found, const HermiteSpline& data, const Deviation& asked) {
  const auto& curves = found.path.segments();
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Vector<Rational> end = evaluate(position(curves[k]), 1);
    const Vector<Rational> off = end - data.points[k + 1];
    CHECK(dot(off, off) <= found.deviation.points * found.deviation.points);
    for (const long t : {0, 1}) {
      const Vector<Rational> tangent = evaluate(hodograph(curves[k]), t);
      const Vector<Rational>& wanted = data.derivatives[k + static_cast<std::size_t>(t)];
      CHECK(dot(tangent, wanted) > 0);
      // sin² of the angle, by the product, not by that function
      const Vector<Rational> across = cross(tangent, wanted);
      CHECK(dot(across, across) <= found.deviation.derivatives * found.deviation.derivatives *
                                       dot(tangent, tangent) * dot(wanted, wanted));
    }
    if (k + 1 == curves.size()) break;
    CHECK(end == curves[k + 1].start());
    const Vector<Rational> before = evaluate(hodograph(curves[k]), 1);
    const Vector<Rational> after = evaluate(hodograph(curves[k + 1]), 0);
    CHECK(cross(before, after) == Vector<Rational>{});
    CHECK(dot(before, after) > 0);
  }
  CHECK(found.deviation.points <= asked.points);
  CHECK(found.deviation.derivatives <= asked.derivatives);
}

}  // namespace

// Worked by hand: b i b* = (−5, 2, 14).
TEST_CASE("RRMF quintics: 1, 1 + 2i − j + 3k and τ = 7 make −5 + 7i − 14j + 2k") {
  const RrmfQuintic<Rational> known{{1, 2, -1, 3}, 7, 1};
  CHECK(last_coefficient(known) == RationalQuaternion{-5, 7, -14, 2});
}

TEST_CASE("RRMF quintics: every b, τ has the law, a rational frame, and the step that is said") {
  for_samples(25, [](Random& random) {
    const auto number = [&] { return Rational(random.integer(-9, 9), 4); };
    const RrmfQuintic<Rational> x{{number(), number(), number(), number()}, number(), 3};
    const Curve curve(from_bernstein({RationalQuaternion{1, 0, 0, 0}, x.b, last_coefficient(x)}),
                      Polynomial{3});
    CHECK(is_rrmf_of_class_one(PhPath(curve)));
    CHECK(evaluate(position(curve), 1) == step_of(x));
    if (x.b.p == 0 && x.b.q == 0) return;
    CHECK(std::holds_alternative<RationalFrame>(classify(curve).rational_frame));
    RrmfQuintic<Rational> other = x;
    other.b.q += 1;
    const Curve broken(
        from_bernstein({RationalQuaternion{1, 0, 0, 0}, other.b, last_coefficient(x)}),
        Polynomial{3});
    CHECK_FALSE(is_rrmf_of_class_one(PhPath(broken)));
  });
}

// SciPy's least_squares finds solutions of the first ones from more than half of 60 random starts,
// and of the last one, where none is found here, not one from 200.
TEST_CASE("RRMF quintics: data that have some get one, and one line says where none is found") {
  const std::vector<HermiteSpline> solvable{
      one_segment({1, 1, 1}, vector("-0.8", "0.3", "1.2"), vector("0.5", "-1.3", "-1")),
      one_segment(vector("1", "0.1", "-0.2"), vector("1", "0.5", "0.3"),
                  vector("1", "-0.4", "0.6")),
      one_segment(vector("1", "0.3", "0"), vector("1", "1", "0"), vector("0.4", "-1", "0")),
      // Of these the first found have f < 0.
      one_segment(vector("-0.234445", "-0.745186", "-0.972382"),
                  vector("-0.231397", "0.756044", "-0.387802"),
                  vector("0.336939", "-0.969904", "0.657054")),
      one_segment(vector("0.939606", "-0.412139", "0.374902"),
                  vector("-0.913525", "0.661781", "0.465144"),
                  vector("-0.015037", "-0.747463", "-0.510827"))};
  for (const char* bound : {"1e-9", "1e-15", "1e-40"}) {
    const Deviation asked{parse_rational(bound), parse_rational(bound)};
    for (const HermiteSpline& data : solvable) {
      const Construction found = rrmf_spline(data, asked);
      check_met(found, data, asked);
      CHECK(is_rrmf_of_class_one(found.path));
      // No great loop, though that would have less energy.
      CHECK(arc_length(found.path.segments().front())(1) < 4);
      CHECK(std::holds_alternative<RationalFrame>(
          classify(found.path.segments().front()).rational_frame));
    }
  }
  const Deviation asked{power_of_ten(-15), power_of_ten(-15)};
  CHECK_THROWS_WITH_AS(
      rrmf_spline(
          one_segment({1, 1, 1}, vector("0.4", "-1.5", "-1.2"), vector("-1.2", "-0.6", "-1.2")),
          asked),
      "segment 1: no quintic with these ends and tangents and a rational rotation-minimizing frame "
      "was found",
      Undecided);
}

TEST_CASE(
    "RRMF quintics: of a smooth curve's data a spline is G1, its numbers as long at its end") {
  // (t, t² + t³/5, t³/3) at steps of 1/4, with its tangents.
  HermiteSpline data;
  for (long k = 0; k <= 8; ++k) {
    const Rational t(k, 4);
    data.points.push_back({t, t * t + t * t * t / 5, t * t * t / 3});
    data.derivatives.push_back({1, 2 * t + 3 * t * t / 5, t * t});
    data.parameters.emplace_back(k);
  }
  const Deviation asked{power_of_ten(-15), power_of_ten(-15)};
  const Construction found = rrmf_spline(data, asked);
  REQUIRE(found.path.segments().size() == 8);
  check_met(found, data, asked);
  CHECK(is_rrmf_of_class_one(found.path));
  for (std::size_t k = 0; k < 8; ++k) {
    long bits = 0;
    const QuaternionPolynomial& a = found.path.segments()[k].preimage();
    for (const Polynomial* part : {&a.u, &a.v, &a.p, &a.q})
      bits = std::max(bits, primitive_bits(*part));
    CHECK(bits < 300);
  }
}

TEST_CASE("RRMF quintics: where points and tangents are on a line it is the line") {
  const Deviation asked{Rational(1, 1'000'000'000'000), Rational(1, 1'000'000'000'000)};
  for_samples(5, [&](Random& random) {
    const Vector<Rational> d{random.rational(), random.rational(), random.integer(1, 9)};
    const HermiteSpline data{
        {{1, 2, 3}, d + Vector<Rational>{1, 2, 3}, Rational(3) * d + Vector<Rational>{1, 2, 3}},
        {d, Rational(7) * d, d},
        {0, 1, 2}};
    const Construction found = rrmf_spline(data, asked);
    check_met(found, data, asked);
    for (const Curve& curve : found.path.segments()) CHECK(preimage_degree(curve) == 0);
  });
}

TEST_CASE("RRMF quintics: adverse data have a curve or a line that says why not") {
  const auto outcome = [](const Vector<Rational>& step, const Vector<Rational>& d0,
                          const Vector<Rational>& d1) -> std::string {
    const HermiteSpline data = one_segment(step, d0, d1);
    const Rational size = largest(step);
    const Deviation asked{size * power_of_ten(-15), power_of_ten(-15)};
    try {
      const Construction found = rrmf_spline(data, asked);
      check_met(found, data, asked);
      CHECK(is_rrmf_of_class_one(found.path));
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  const Vector<Rational> x{1, 0, 0};
  const std::string none =
      "segment 1: no quintic with these ends and tangents and a rational rotation-minimizing frame "
      "was found";
  CHECK(outcome(x, x, x).empty());
  CHECK(outcome({-1, 0, 0}, {-1, 0, 0}, {-3, 0, 0}).empty());
  CHECK(outcome({1, 2, 3}, {1, 2, 3}, {2, 4, 6}).empty());
  CHECK(outcome(x, {0, 1, 0}, {0, -1, 0}).empty());
  CHECK(outcome({-1, 0, 0}, x, x) == none);
  CHECK(outcome({1, 1, 0}, x, x) == none);
  CHECK(outcome({0, 0, 0}, x, {0, 1, 0}) ==
        "segment 1: its ends are equal, and directions alone do not say how great it is");
  CHECK(outcome(x, {0, 0, 0}, x) == "the derivative at point 1 is 0: it has no direction");
  for (const long e : {150, -150})
    CHECK(outcome(power_of_ten(e) * vector("1", "0.1", "0"),
                  power_of_ten(e) * vector("1", "0", "0.01"),
                  power_of_ten(e) * vector("1", "0.2", "0"))
              .empty());
}

}  // namespace rrmf_spline_test
