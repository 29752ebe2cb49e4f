#include "phrame/ph/twist/rational_twist.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/proof/classify.hpp"
#include "phrame/ph/twist/twist_error.hpp"
#include "phrame/ph/twist/twist_frame.hpp"
#include "phrame/ph/twist/twist_minimum.hpp"
#include "support/curves.hpp"
#include "support/data.hpp"
#include "support/farouki_moon.hpp"
#include "support/random.hpp"

namespace rational_twist_test {

using namespace phrame;
using nlohmann::json;
using test::curve_of;
using test::farouki_moon;
using test::for_samples;
using test::number;
using test::Random;

namespace {

constexpr long bits = 160;

/// The frame of minimal twist of a curve.
struct Framed {
  PathAngle rmf;
  MinimalTwist mtf;
  Framed(const Curve& curve, const FrameAngle& from, const FrameAngle& to)
      : rmf(PhPath(curve)), mtf(rmf, from, to) {}
};

Framed framed_example(const json& example) {
  return {curve_of(example), {}, {number(example["consistent"]["delta_theta_over_pi"]), 0}};
}

RealBall quotient(const Real& a, const Real& b) {
  return divide(a.enclose(bits), b.enclose(bits), bits);
}

/// Agree to `digits` decimals.
bool is_near(const RealBall& x, const Rational& truth, long digits) {
  const Rational width = power_of_ten(-digits);
  return abs(x.lower() - truth) < width && abs(x.upper() - truth) < width;
}

RealBall relative_error(const RationalTwist& twist) {
  return quotient(twist.root_mean_square(), twist.piece().twist);
}

/// The turn about e₁ along the piece, by quadrature of its rate.
RealBall turn_by_quadrature(const RationalTwist& twist) {
  const Rotation& w = twist.rotation(256);
  const BallPolynomial n(twist.piece().erf_rate.numerator(), 256);
  const BallPolynomial d(twist.piece().erf_rate.denominator(), 256);
  const BallPolynomial square = norm(w, 256);
  const BallPolynomial cross = wronskian(w, 256);
  return quadrature(
      [&](const ComplexBall& z, long precision) {
        const ComplexBall turn =
            divide(evaluate(cross, z, precision), evaluate(square, z, precision), precision);
        const ComplexBall erf =
            divide(evaluate(n, z, precision), evaluate(d, z, precision), precision);
        return add(erf, add(turn, turn, precision), precision);
      },
      80, 64);
}

FrameAngle random_angle(Random& random) {
  return {Rational(random.integer(-40, 40), 40),
          random.chance(2) ? Rational(0) : random.rational()};
}

/// A regular curve of degree 3 to 15.
Curve random_curve(Random& random) {
  const long degree = random.integer(1, 7);
  std::array<std::vector<Rational>, 4> parts;
  for (auto& part : parts)
    for (long k = 0; k <= degree; ++k) part.push_back(Rational(random.integer(-30, 30), 10));
  QuaternionPolynomial a{from_bernstein(parts[0]), from_bernstein(parts[1]),
                         from_bernstein(parts[2]), from_bernstein(parts[3])};
  if (sigma(a)(0) == 0 || sigma(a)(1) == 0 || count_real_roots(sigma(a), closed_interval(0, 1)) > 0)
    return random_curve(random);
  return Curve(a);
}

}  // namespace

TEST_CASE("rational twist: the examples of the paper, proved") {
  for (const std::string name : {"example1", "example2", "example3"}) {
    CAPTURE(name);
    const Framed example = framed_example(farouki_moon()[name]);
    const auto& truth = farouki_moon()[name]["consistent"];
    const auto pieces = twist_pieces(example.mtf, {});
    REQUIRE(pieces.size() == 1);
    CHECK(is_near(pieces[0].first_rate().enclose(bits), number(truth["rho0"]), 35));
    CHECK(is_near(pieces[0].last_rate().enclose(bits), number(truth["rho1"]), 35));
    const BestTwist best = best_twist(pieces[0], {});
    REQUIRE(best.minimum);
    CHECK(best.twist.end_factor_change(best.minimum->radius) < power_of_ten(-22));
    REQUIRE(best.other);
    for (const auto& minimum : truth["minima"]) {
      // There γ has the sign for angles that are less by 2π.
      const Rational gamma = abs(number(minimum["gamma"]));
      const Rational error = number(minimum["rel_rms"]);
      const bool is_best = error < 1;
      const RationalTwist& twist = is_best ? best.twist : *best.other;
      const RealBall found = twist.end_factor().enclose(bits);
      CHECK(is_near(is_best ? found : subtract({}, found, bits), gamma, is_best ? 22 : 9));
      CHECK(is_near(relative_error(twist), error, is_best ? 30 : 20));
      const RealBall turned = turn_by_quadrature(twist);
      CHECK(turned.overlaps(
          add(twist.piece().twist.enclose(bits),
              multiply(RealBall(Rational(2 * twist.extra_turns()), bits), pi(bits), bits), bits)));
      CHECK((twist.extra_turns() == 0) == is_best);
      const SignChanges inflections = twist.inflections(100);
      CHECK(inflections.is_complete());
      const auto& expected = minimum["rational_frame_inflections"];
      REQUIRE(inflections.at.size() == expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k)
        CHECK(is_near(inflections.at[k], number(expected[k]), is_best ? 20 : 8));
      CHECK(is_monotone(twist) == (expected.empty() ? Monotone::yes : Monotone::no));
    }
  }
}

// The Hermite data behind the printed preimages: the paper's T and T_min, to their last digit.
TEST_CASE("rational twist: the examples of the paper, not rounded") {
  std::ifstream file(test::data("/farouki-moon-2018-hermite.json"));
  const json preimages = json::parse(file);
  const std::vector<std::array<const char*, 3>> printed{{"example1", "-4.3703", "1.9129"},
                                                        {"example2", "-3.6675", "2.6157"},
                                                        {"example3", "2.2046", "2.2046"}};
  for (const auto& [key, nominal, least] : printed) {
    const std::string name = key;
    CAPTURE(name);
    const auto& truth = farouki_moon()[name]["unrounded"];
    const Curve curve = curve_of({{"A", preimages[name]}});
    const Framed framed(curve, {}, {number(truth["delta_theta_over_pi"]), 0});
    CHECK(round_to_decimal(framed.mtf.nominal_twist(), 5).value == nominal);
    CHECK(round_to_decimal(framed.mtf.twist(), 5).value == least);
    CHECK(is_near(framed.mtf.twist().enclose(bits), number(truth["T_min"]), 45));
    const BestTwist best = best_twist(twist_pieces(framed.mtf, {})[0], {});
    REQUIRE(best.minimum);
    CHECK(is_near(best.twist.end_factor().enclose(bits), abs(number(truth["minima"][0]["gamma"])),
                  22));
    CHECK(is_near(relative_error(best.twist), number(truth["minima"][0]["rel_rms"]), 30));
  }
}

// (36) at values of γ that are no minima, both signs. The source has them to 18 digits.
TEST_CASE("rational twist: the mean square where gamma is given") {
  for (const std::string name : {"example1", "example2", "example3"}) {
    CAPTURE(name);
    const Framed example = framed_example(farouki_moon()[name]);
    const TwistPiece piece = twist_pieces(example.mtf, {})[0];
    // There Δθ is less by 2π, where γ has the other sign.
    const Real difference = Real([&](long precision) {
      return multiply(
          RealBall(number(farouki_moon()[name]["consistent"]["delta_theta_over_pi"]), precision),
          pi(precision), precision);
    });
    const bool is_flipped = !difference.enclose(bits).overlaps(piece.turn.enclose(bits));
    for (const auto& item : farouki_moon()[name]["rel_rms_eq36_at_gamma"].items()) {
      const std::string& text = item.key();
      CAPTURE(text);
      const Rational gamma = parse_rational(text) * (is_flipped ? -1 : 1);
      const RationalTwist twist = twist_with_end_factor(piece, gamma);
      CHECK(is_near(twist.end_factor().enclose(bits), gamma, 30));
      for (const long size : {-40, -600})
        for (const Rational& small : {gamma * power_of_two(size), -gamma * power_of_two(size)}) {
          const RealBall found = twist_with_end_factor(piece, small).end_factor().enclose(1000);
          CHECK(is_near(divide(found, RealBall(small, bits), bits), 1, 29));
        }
      CHECK(is_near(divide(twist.root_mean_square().enclose(100), piece.twist.enclose(bits), bits),
                    number(item.value()), 17));
    }
  }
}

TEST_CASE("rational twist: a frame in pieces") {
  const auto& data = farouki_moon()["example3"];
  const Framed example = framed_example(data);
  Subdivision at_extremum;
  at_extremum.at = {number(data["consistent"]["ERF_omega1_extrema"][1])};
  Subdivision everywhere;
  everywhere.at_extrema = everywhere.at_inflections = true;
  const std::vector<std::pair<std::string, Subdivision>> cases{
      {"subdivision_at_extremum_0.6735", at_extremum},
      {"subdivision_at_both_extrema_and_inflection", everywhere}};
  for (const auto& [key, subdivision] : cases) {
    const std::string name = key;
    CAPTURE(name);
    const auto& truth = data[name];
    const TwistFrame frame = twist_frame(example.mtf, {}, subdivision);
    REQUIRE(frame.pieces.size() == truth["segments"].size());
    for (std::size_t k = 0; k < frame.pieces.size(); ++k) {
      const auto& expected = truth["segments"][k];
      const RationalTwist& twist = frame.pieces[k].twist;
      CHECK(frame.pieces[k].minimum);
      const TwistPiece& piece = twist.piece();
      CHECK(abs(piece.from - number(expected["xi0"])) < power_of_ten(-22));
      CHECK(abs(piece.to - number(expected["xi1"])) < power_of_ten(-22));
      CHECK(is_near(piece.twist.enclose(bits), number(expected["T_k"]), 22));
      CHECK(is_near(piece.turn.enclose(bits), number(expected["delta_theta"]), 22));
      CHECK(is_near(piece.start.enclose(bits), number(expected["theta_0"]), 22));
      CHECK(is_near(twist.end_factor().enclose(bits), number(expected["gamma"]), 20));
      CHECK(is_near(relative_error(twist), number(expected["rel_rms"]), 20));
      CHECK(is_monotone(twist) == Monotone::yes);
    }
    CHECK(is_near(quotient(root_mean_square(frame), example.mtf.twist()),
                  number(truth["overall_rel_rms"]), 20));
    CHECK(is_monotone(frame) == Monotone::yes);
  }
}

TEST_CASE("rational twist: where the Euler-Rodrigues frame turns back, and its extrema") {
  for (const std::string name : {"example1", "example2", "example3"}) {
    CAPTURE(name);
    const Curve curve = curve_of(farouki_moon()[name]);
    const auto& truth = farouki_moon()[name]["consistent"];
    const auto check = [](const std::vector<RealRoot>& points, const json& expected) {
      const auto found = odd_inside(points);
      REQUIRE(found.size() == expected.size());
      for (std::size_t k = 0; k < found.size(); ++k)
        CHECK(is_near(enclose(found[k].at, bits), number(expected[k]), 35));
    };
    check(erf_turning(curve).zeros, truth["ERF_inflections"]);
    check(erf_turning(curve).extrema, truth["ERF_omega1_extrema"]);
  }
  // A line with σ = 1 + (t − 1/2)².
  CHECK(odd_inside(erf_turning(Curve({{1}, {Rational(-1, 2), 1}, {}, {}})).extrema) ==
        std::vector<RealRoot>{{Rational(1, 2), 1}});
  CHECK(erf_turning(Curve({{1}, {}, {0, 1}, {}})).zeros.empty());  // h = 0
  CHECK(erf_turning(Curve({{1}, {}, {0, 1}, {}})).extrema.empty());
}

TEST_CASE("rational twist: law: rates and orientations at the ends, turns, errors") {
  for_samples(25, [](Random& random) {
    const FrameAngle from = random_angle(random);
    const FrameAngle to = random_angle(random);
    const Framed framed(random_curve(random), from, to);
    const TwistPiece piece = twist_pieces(framed.mtf, {})[0];
    const BestTwist best = best_twist(piece, {2, EndRates::matched, false, 80});
    const RationalTwist& twist = best.twist;
    // Ω₁(0) = Ω₁(1) = Ω̄₁.
    const Rotation& w = twist.rotation(256);
    for (const Rational& end : {Rational(0), Rational(1)}) {
      const RealBall at(end, 256);
      const RealBall rate =
          divide(evaluate(wronskian(w, 256), at, 256), evaluate(norm(w, 256), at, 256), 256);
      const RealBall all = add(RealBall(piece.erf_rate(end), 256), add(rate, rate, 256), 256);
      const RealBall wanted =
          multiply(piece.twist.enclose(256), RealBall(piece.speed(end), 256), 256);
      CHECK(all.overlaps(wanted));
      CHECK(all.accuracy_bits() > 40);
    }
    // θ(0) = θ_i, θ(1) = θ_f up to whole turns.
    for (const auto& [tau, angle] : {std::pair(0, from), std::pair(1, to)}) {
      const RealBall turns = divide(
          subtract(twist.value(Rational(tau)).enclose(bits), to_real(angle).enclose(bits), bits),
          multiply(RealBall(2, bits), pi(bits), bits), bits);
      CHECK(arb_contains_int(turns.raw()) != 0);
      CHECK(turns.radius() < power_of_ten(-20));
    }
    // The twist, by quadrature; and G ≥ (2πk)² for k turns too many (Cauchy and Schwarz).
    const Integer extra = twist.extra_turns();
    const RealBall full = multiply(RealBall(Rational(2 * extra), bits), pi(bits), bits);
    CHECK(turn_by_quadrature(twist).overlaps(add(piece.twist.enclose(bits), full, bits)));
    const RealBall error = twist.root_mean_square().enclose(60);
    REQUIRE(error.is_finite());
    CHECK(error.upper() >= abs(full.lower()) - power_of_ten(-10));
    // The maximum is above the mean.
    const RealBall greatest = twist.greatest_error().enclose(60);
    REQUIRE(greatest.is_finite());
    CHECK(greatest.upper() >= error.lower());
    // Halfway along, θ lies where the exact angle does, off by no more than √(G s(1 − s)).
    const Rational share = antiderivative(piece.speed)(Rational(1, 2));
    const RealBall off =
        subtract(twist.value(Rational(1, 2)).enclose(bits),
                 framed.mtf.reduced_value({0, Rational(1, 2)}).enclose(bits), bits);
    const RealBall bound = multiply(error, sqrt(RealBall(share * (1 - share), bits), bits), bits);
    if (extra == 0) CHECK(subtract(off, bound, bits).lower() <= 0);
  });
}

TEST_CASE("rational twist: law: derivatives of the mean square, and its bounds on intervals") {
  for_samples(4, [](Random& random) {
    const Framed framed(random_curve(random), random_angle(random), random_angle(random));
    const TwistPiece piece = twist_pieces(framed.mtf, {})[0];
    const RotationFamily family = rotation_family(piece, 2, EndRates::matched, 300);
    const Rational p = random.rational() / 7;
    const auto w = [&](const Rational& q) { return member(family, {RealBall(q, 300)}, 300); };
    if (!turn(w(p), 0, 1, 300)) return;
    // Divided differences at a distance of 2^−40, off by about its square.
    const Rational step = power_of_two(-40);
    const auto difference = [&](const RealBall& after, const RealBall& before) {
      return divide(subtract(after, before, 300), RealBall(2 * step, 300), 300);
    };
    const RealBall slope = mean_square_slope(piece, family, p, 60);
    const RealBall by_values =
        difference(mean_square(piece, w(p + step), 160), mean_square(piece, w(p - step), 160));
    const Rational size = abs(slope.upper()) + 1;
    CHECK(abs(slope.upper() - by_values.upper()) < size * power_of_ten(-12));
    MeanSquareConvexity convexity(piece, family, p, 60);
    const RealBall here = convexity(RealBall(p, 300), 100'000);
    const RealBall by_slopes = difference(mean_square_slope(piece, family, p + step, 160),
                                          mean_square_slope(piece, family, p - step, 160));
    CHECK(abs(here.upper() - by_slopes.upper()) < (abs(here.upper()) + 1) * power_of_ten(-12));
    // On an interval, and again where points are known.
    MeanSquareConvexity rough(piece, family, p + Rational(1, 1000), 8);
    for (const Rational& width : {Rational(1, 1000), Rational(1, 300)}) {
      const RealBall around = rough(hull(p - width, p + width, 100), 1000);
      if (around.is_finite()) CHECK(around.overlaps(here));
    }
  });
}

TEST_CASE("rational twist: the greatest error is that of many points, and not less") {
  for (const std::string name : {"example1", "example2", "example3"}) {
    CAPTURE(name);
    const Framed example = framed_example(farouki_moon()[name]);
    const TwistPiece piece = twist_pieces(example.mtf, {})[0];
    for (long degree = 2; degree <= 3; ++degree) {
      const RationalTwist twist = best_twist(piece, {degree, EndRates::matched, false, 60}).twist;
      const Rotation& w = twist.rotation(128);
      double most = 0;
      for (long k = 0; k <= 3000; ++k) {
        const Rational tau(k, 3000);
        const RealBall at(tau, 128);
        const RealBall turn =
            divide(evaluate(wronskian(w, 128), at, 128), evaluate(norm(w, 128), at, 128), 128);
        const RealBall rate = add(RealBall(piece.erf_rate(tau), 128), add(turn, turn, 128), 128);
        const RealBall error = subtract(divide(rate, RealBall(piece.speed(tau), 128), 128),
                                        piece.twist.enclose(128), 128);
        most = std::max(most, std::abs(round_to_double(error.lower())));
      }
      const RealBall greatest = twist.greatest_error().enclose(60);
      CHECK(greatest.upper() >= exact_rational(most) - power_of_ten(-14));
      CHECK(greatest.lower() <= exact_rational(most * (1 + 1e-5)));
      CHECK(greatest.accuracy_bits() > 40);
    }
  }
}

// A = (−1.5001 + 3t, 0.4998 − t, 0, −1 + 2t), |A(1/2)|² = 5·10⁻⁸. By mpmath: γ where the derivative
// of (36) vanishes, and (36) there, quadrature in 25 digits with 20 parts around t = 1/2.
TEST_CASE("rational twist: next to a cusp one is found") {
  if (test::multiplier() == 1) return;  // for every day there is one of the program's
  const Framed near(Curve({{Rational(-15001, 10000), 3}, {Rational(2499, 5000), -1}, {}, {-1, 2}}),
                    {0, Rational(3, 10)}, {0, 1});
  const TwistPiece piece = twist_pieces(near.mtf, {})[0];
  const BestTwist quadratic = best_twist(piece, {});
  CHECK(is_near(quadratic.twist.end_factor().enclose(bits), number("1.0006914188"), 7));
  CHECK(is_near(relative_error(quadratic.twist), -number("3998027.3229601846909"), 6));
  const BestTwist linear = best_twist(piece, {1, EndRates::free, true, 60});
  CHECK(is_near(linear.twist.end_factor().enclose(bits), number("0.99997142898"), 7));
  CHECK(is_near(relative_error(linear.twist), -number("3997532.5947385632541"), 6));
  // Divided beside the cusp, too.
  for (const Rational& at : {Rational(4999, 10000), Rational(1, 2), Rational(2, 5)})
    for (const TwistPiece& part : twist_pieces(near.mtf, {at}))
      CHECK(best_twist(part, {2, EndRates::matched, false, 60})
                .twist.root_mean_square()
                .enclose(60)
                .is_finite());
}

// Where the frame is nearly exact, so that its error is small against its rates.
TEST_CASE("rational twist: the greatest error of a short piece") {
  const Framed example = framed_example(farouki_moon()["example3"]);
  const TwistPiece piece = twist_pieces(example.mtf, {Rational(3, 100), Rational(4, 100)})[1];
  const RationalTwist twist = best_twist(piece, {2, EndRates::matched, false, 60}).twist;
  const Rotation& w = twist.rotation(256);
  RealBall most;
  for (long k = 0; k <= 2000; ++k) {
    const Rational tau(k, 2000);
    const RealBall at(tau, 256);
    const RealBall turn =
        divide(evaluate(wronskian(w, 256), at, 256), evaluate(norm(w, 256), at, 256), 256);
    const RealBall rate = add(RealBall(piece.erf_rate(tau), 256), add(turn, turn, 256), 256);
    const RealBall error = absolute(subtract(divide(rate, RealBall(piece.speed(tau), 256), 256),
                                             piece.twist.enclose(256), 256));
    arb_max(most.raw(), most.raw(), error.raw(), 256);
  }
  const RealBall greatest = twist.greatest_error().enclose(80);
  CHECK(greatest.accuracy_bits() > 60);
  CHECK(greatest.upper() >= most.lower());
  CHECK(greatest.lower() <= most.upper() * (1 + power_of_ten(-5)));
  CHECK(most.upper() < power_of_ten(-6));
}

// At an end here, with all zeros of E′ excluded in the last round.
TEST_CASE("rational twist: the greatest error at an end of a linear rotation") {
  const Framed example(curve_of(farouki_moon()["example2"]), {}, {0, 1});
  const TwistPiece piece = twist_pieces(example.mtf, {})[0];
  const RationalTwist twist = best_twist(piece, {1, EndRates::free, true, 60}).twist;
  CHECK(twist.greatest_error().enclose(80).accuracy_bits() > 60);
}

TEST_CASE("rational twist: a minimum that another one beats is not proved to be the best") {
  const Framed example = framed_example(farouki_moon()["example1"]);
  const TwistPiece piece = twist_pieces(example.mtf, {})[0];
  const RotationFamily family = rotation_family(piece, 2, EndRates::matched, 128);
  TwistObjective right(piece, family);
  TwistObjective wrong = right;
  const auto good = search_line(right, 1);
  const auto poor = search_line(wrong, -1);
  REQUIRE(good);
  REQUIRE(poor);
  CHECK(good->value < poor->value);
  CHECK(twist_minimum(piece, 2, EndRates::matched, *good, *poor, 40).is_for_both_signs);
  CHECK_THROWS_AS(twist_minimum(piece, 2, EndRates::matched, *poor, *good, 40), Undecided);
  // Of those with its sign it is the best.
  CHECK_FALSE(twist_minimum(piece, 2, EndRates::matched, *poor, {}, 40).is_for_both_signs);
  // A guess next to it is no minimum.
  LineGuess beside = *good;
  beside.parameter += 0.3;
  CHECK_THROWS_AS(twist_minimum(piece, 2, EndRates::matched, beside, {}, 40), Undecided);
}

// Of two minima with the same sign of γ the worse one must not be proved, however near it is.
TEST_CASE("rational twist: law: a local minimum is not proved to be the least") {
  long refused = 0;
  for_samples(10, [&](Random& random) {
    const Framed framed(random_curve(random), random_angle(random), random_angle(random));
    const TwistPiece piece = twist_pieces(framed.mtf, {})[0];
    const RotationFamily family = rotation_family(piece, 1, EndRates::free, 128);
    TwistObjective objective(piece, family);
    const auto best = search_line(objective, 1);
    if (!best || !best->is_interior) return;
    const auto value = [&](double p) { return objective(std::span(&p, 1)); };
    double before = value(best->parameter / 315);
    double here = value(best->parameter / 300);
    for (double p = best->parameter / 300; p < 300 * best->parameter; p *= 1.05) {
      const double after = value(p * 1.05);
      const bool is_least = here < before && here < after;
      before = std::exchange(here, after);
      if (!is_least) continue;
      double x = p;
      for (int k = 0; k < 30; ++k) {
        objective.resolve(std::span(&x, 1));
        const auto [first, second] = objective.derivatives(x);
        x -= std::clamp(first / second, -0.02 * x, 0.02 * x);
      }
      const LineGuess local{x, value(x), objective.derivatives(x).second, true};
      if (!(local.convexity > 0) || !(local.value > best->value * 1.0001)) continue;
      ++refused;
      CHECK_THROWS_AS(twist_minimum(piece, 1, EndRates::free, local, {}, 40), Undecided);
      if (test::multiplier() == 1) break;  // one a sample
    }
  });
  CHECK(refused > 0);
}

// Two revolutions more: a frame with one less is better, but not what was asked for.
TEST_CASE("rational twist: a frame that turns by T goes before a better one that does not") {
  PathAngle rmf{PhPath(test::quintic)};
  long preferred = 0;
  for (long turns = test::everyday(-2, -3); turns <= 3; turns += test::everyday(4, 1)) {
    const MinimalTwist mtf(rmf, {}, Angle(Rational(1, 2), 0), turns);
    const BestTwist best = best_twist(twist_pieces(mtf, {})[0], {2, EndRates::matched, true, 40});
    if (!best.other || best.other->extra_turns() == 0) continue;
    const RealBall here = best.twist.root_mean_square().enclose(60);
    const RealBall there = best.other->root_mean_square().enclose(60);
    if (best.twist.extra_turns() == 0 && there.upper() < here.lower()) ++preferred;
    if (best.twist.extra_turns() != 0) CHECK(here.lower() <= there.upper());
  }
  CHECK(preferred > 0);
}

TEST_CASE("rational twist: law: no parameter is better than the proved one") {
  for_samples(3, [](Random& random) {
    const Framed framed(random_curve(random), random_angle(random), random_angle(random));
    const TwistPiece piece = twist_pieces(framed.mtf, {})[0];
    const long degree = random.integer(1, 2);
    const EndRates rates = degree == 2 ? EndRates::matched : EndRates::free;
    BestTwist best = best_twist(piece, {degree, rates, true, 60});
    if (!best.minimum) {
      CHECK_FALSE(best.doubt.empty());
      return;
    }
    const RotationFamily family = rotation_family(piece, degree, rates, 200);
    const auto value = [&](const Rational& p) {
      return mean_square(piece, member(family, {RealBall(p, 200)}, 200), 60);
    };
    const auto slope = [&](const Rational& p) { return mean_square_slope(piece, family, p, 100); };
    const auto& [parameter, radius, is_for_both_signs] = *best.minimum;
    CHECK(slope(parameter - 2 * radius).upper() < 0);
    CHECK(slope(parameter + 2 * radius).lower() > 0);
    const RealBall least = value(parameter);
    for (int k = 0; k < 12; ++k) {
      const Rational p =
          parameter + (random.chance(2) ? 1 : -1) * power_of_two(random.integer(-8, 5));
      if (!turn(member(family, {RealBall(p, 200)}, 200), 0, 1, 200)) continue;
      const RealBall signs =
          multiply(end_factor(family, {p}, 200), best.twist.end_factor().enclose(200), 200);
      if (is_for_both_signs || signs.lower() > 0) CHECK(value(p).upper() >= least.lower());
    }
    if (best.other && is_for_both_signs)
      CHECK(best.other->root_mean_square().enclose(60).upper() >=
            best.twist.root_mean_square().enclose(60).lower());
  });
}

TEST_CASE("rational twist: law: a higher degree is no worse") {
  for_samples(3, [](Random& random) {
    const Framed framed(random_curve(random), random_angle(random), random_angle(random));
    const TwistPiece piece = twist_pieces(framed.mtf, {})[0];
    const EndRates rates = random.chance(2) ? EndRates::matched : EndRates::free;
    std::optional<RealBall> last;
    for (long degree = rates == EndRates::matched ? 2 : 1; degree <= 4; ++degree) {
      const RationalTwist twist = best_twist(piece, {degree, rates, false, 60}).twist;
      const RealBall error = twist.root_mean_square().enclose(60);
      CHECK(twist.degree() <= degree);
      if (last) CHECK(error.lower() <= last->upper());
      last = error;
      if (rates == EndRates::matched) {
        const Rotation& w = twist.rotation(256);
        const RealBall one(1, 256);
        const RealBall rate =
            divide(evaluate(wronskian(w, 256), one, 256), evaluate(norm(w, 256), one, 256), 256);
        CHECK(add(rate, rate, 256).overlaps(piece.last_rate().enclose(256)));
      }
    }
  });
}

// The order of the error in the length of the pieces: ω₁ is matched at both ends and in the mean.
TEST_CASE("rational twist: the error goes to 0 under subdivision") {
  const Framed framed(test::quintic, {}, {Rational(1, 3), 0});
  std::vector<double> errors;
  for (long count = 2; count <= 16; count *= 2) {
    Subdivision even;
    for (long k = 1; k < count; ++k) even.at.emplace_back(k, count);
    const TwistFrame frame = twist_frame(framed.mtf, {2, EndRates::matched, false, 60}, even);
    errors.push_back(round_to_double(root_mean_square(frame)));
  }
  for (std::size_t k = 0; k + 1 < errors.size(); ++k) CHECK(errors[k + 1] < errors[k] / 4);
  Subdivision small;
  small.tolerance = Rational(1, 10000);
  for (const BestTwist& piece :
       twist_frame(framed.mtf, {2, EndRates::matched, false, 60}, small).pieces)
    CHECK(relative_error(piece.twist).upper() <= *small.tolerance);
}

TEST_CASE("rational twist: turns that are whole, and frames that do not turn") {
  // Δθ = 0: w = w₀ + … with x free, and γ > 0 where the rates at the ends differ in sign.
  const Framed closed_turn(curve_of(farouki_moon()["example3"]), {}, {0, 0});
  const TwistPiece piece = twist_pieces(closed_turn.mtf, {})[0];
  REQUIRE(piece.whole_turns);
  const BestTwist best = best_twist(piece, {2, EndRates::matched, true, 60});
  const RealBall half_turn = multiply(RealBall(Rational(*piece.whole_turns), bits), pi(bits), bits);
  CHECK(piece.turn.enclose(bits).overlaps(add(half_turn, half_turn, bits)));
  CHECK(best.minimum);
  CHECK_FALSE(best.other);  // γ is fixed
  CHECK_THROWS_WITH_AS(twist_with_end_factor(piece, 1), doctest::Contains("γ is fixed"),
                       DomainError);
  CHECK(turn_by_quadrature(best.twist)
            .overlaps(add(
                piece.twist.enclose(bits),
                multiply(RealBall(Rational(2 * best.twist.extra_turns()), bits), pi(bits), bits),
                bits)));
  // A plane curve, h = 0: nothing has to turn.
  const Framed plane(Curve({{1}, {}, {0, 1}, {}}), {Rational(1, 5), 0}, {Rational(1, 5), 0});
  const TwistPiece still = twist_pieces(plane.mtf, {})[0];
  for (long degree = 1; degree <= 3; ++degree) {
    const RationalTwist twist =
        best_twist(still, {degree, degree == 1 ? EndRates::free : EndRates::matched, true, 60})
            .twist;
    CHECK(twist.root_mean_square().enclose(60).contains_zero());
    CHECK(twist.extra_turns() == 0);
    CHECK(is_monotone(twist) != Monotone::no);
  }
  // The same, turned half around: Ω̄₁ > 0 at both ends.
  const Framed half(Curve({{1}, {}, {0, 1}, {}}), {}, {1, 0});
  CHECK(best_twist(twist_pieces(half.mtf, {})[0], {}).minimum);
}

TEST_CASE("rational twist: what is refused") {
  const Framed cusp(Curve({{1}, {0, 1}, {}, {1}}, Polynomial{1, -4, 4}), {}, {});
  CHECK_THROWS_AS(twist_pieces(cusp.mtf, {}), DomainError);
  const Framed fine(test::quintic, {}, {Rational(1, 2), 0});
  CHECK_THROWS_WITH_AS(twist_pieces(fine.mtf, {Rational(3, 2)}),
                       "the parameter 3/2 is outside [0, 1]", DomainError);
  const TwistPiece piece = twist_pieces(fine.mtf, {})[0];
  CHECK_THROWS_AS(best_twist(piece, {0, EndRates::free, false, 60}), DomainError);
  CHECK_THROWS_AS(best_twist(piece, {9, EndRates::free, false, 60}), DomainError);
  CHECK_THROWS_AS(rotation_family(piece, 1, EndRates::matched, 60), DomainError);
  CHECK_THROWS_AS(twist_with_end_factor(piece, 0), DomainError);
  CHECK_THROWS_AS(twist_with_end_factor(piece, power_of_two(-10000)), Undecided);
  TwistPiece whole = piece;
  whole.whole_turns = 1;
  CHECK_THROWS_AS(best_twist(whole, {1, EndRates::free, false, 60}), DomainError);
}

}  // namespace rational_twist_test
