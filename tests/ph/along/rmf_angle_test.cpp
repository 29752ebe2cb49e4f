#include "phrame/ph/along/rmf_angle.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "support/curves.hpp"
#include "support/data.hpp"
#include "support/linear_system.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::class_one;
using test::for_samples;
using test::quintic;
using test::Random;

namespace {

/// |a − b| ≤ 10^-48·max(1, |b|).
bool agree(const std::string& a, const std::string& b) {
  const Rational x = parse_rational(a);
  const Rational y = parse_rational(b);
  return abs(x - y) <= parse_rational("1e-48") * (abs(y) > 1 ? Rational(abs(y)) : Rational(1));
}

std::string fifty(const RmfAngle& angle, const Rational& t) {
  return round_to_decimal(angle.value(t), 50).value;
}

/// θ_Frenet as the paper finds it: −∫a/σ − ∫b/ρ with a and b from the linear system of (15). No
/// value where that system is singular.
std::optional<Antiderivative> frenet_angle_by_linear_system(const Curve& curve) {
  const QuaternionPolynomial& preimage = curve.preimage();
  const auto split = test::split_by_linear_system(preimage);
  if (!split) return std::nullopt;
  Antiderivative sum = integrate({-split->a, sigma(preimage)});
  const Antiderivative bend = integrate({-split->b, rho(preimage)});
  sum.rational = sum.rational + bend.rational;
  sum.logs.insert(sum.logs.end(), bend.logs.begin(), bend.logs.end());
  return sum;
}

}  // namespace

TEST_CASE("angle: the quintic of Farouki 2003 at eleven points, in both frames") {
  std::ifstream file(test::data("/farouki-2003.json"));
  const auto reference = nlohmann::json::parse(file).at("quintic");
  RmfAngle erf(quintic, Reference::euler_rodrigues);
  RmfAngle frenet(quintic, Reference::frenet);
  for (const auto& [t, theta] : reference.at("theta_RMF_rel_ERF").items())
    CHECK(agree(fifty(erf, parse_rational(t)), theta));
  for (const auto& [t, theta] : reference.at("theta_RMF_rel_Frenet").items())
    CHECK(agree(fifty(frenet, parse_rational(t)), theta));
  CHECK(fifty(frenet, 1) == "2.9950414081175964605037551595138716605649466792612");
}

TEST_CASE("angle: every curve of the collection, both frames, 50 digits") {
  std::ifstream file(test::data("/curves.jsonl"));
  long count = 0;
  for (std::string line; std::getline(file, line);) {
    const NamedCurve named = read_curve(line);
    const Curve& curve = named.curve;
    CAPTURE(named.name);
    const auto expected = nlohmann::json::parse(line).at("expected");
    RmfAngle erf(curve, Reference::euler_rodrigues);
    CHECK(agree(fifty(erf, 1), expected.at("theta_erf_1")));
    if (expected.contains("theta_frenet_1")) {
      RmfAngle frenet(curve, Reference::frenet);
      CHECK(agree(fifty(frenet, 1), expected.at("theta_frenet_1")));
    } else {
      CHECK_THROWS_WITH_AS(RmfAngle(curve, Reference::frenet), doctest::Contains("straight line"),
                           DomainError);
    }
    ++count;
  }
  CHECK(count > 120);
}

TEST_CASE(
    "angle: A = (t + i)(t + j): θ = −2t/(1 + t²) exactly, Frenet as in the reference values") {
  const Curve curve({{0, 0, 1}, {0, 1}, {0, 1}, {1}});
  RmfAngle erf(curve, Reference::euler_rodrigues);
  CHECK(erf.angle_to_erf() == Antiderivative{{}, RationalFunction({0, -2}, {1, 0, 1}), {}});
  CHECK(erf.value(Rational(1, 2)).exact() == Rational(-4, 5));
  RmfAngle frenet(curve, Reference::frenet);
  CHECK(agree(fifty(frenet, 1), "-1.7853981633974483096156608458198757210492923498438"));
  CHECK(
      agree(fifty(frenet, Rational(1, 2)), "-1.4747409422235526630565209736098136150740062548407"));
}

TEST_CASE("angle: h = 0 without lying in a plane: the ERF is rotation-minimizing") {
  const Curve curve({{1}, {0, 0, 0, 1}, {0, 3}, {0, 0, 1}});  // 1 + t³i + 3tj + t²k
  CHECK(rate_to_erf(curve.preimage()).is_zero());
  RmfAngle erf(curve, Reference::euler_rodrigues);
  CHECK(erf.value(Rational(2, 3)).exact() == Rational(0));
  CHECK_FALSE(RmfAngle(curve, Reference::frenet).rate().is_zero());
}

TEST_CASE("angle: a plane curve's Frenet frame is rotation-minimizing, exactly") {
  // u + qk lies in the plane z = 0; turned by f + gi its ERF is not rotation-minimizing any more.
  const QuaternionPolynomial planar{{1, 2}, {}, {}, {3, 0, 1}};
  const QuaternionPolynomial turned = planar * QuaternionPolynomial{{1, 1}, {0, 2}, {}, {}};
  RmfAngle frenet(Curve(turned), Reference::frenet);
  CHECK(frenet.rate().is_zero());
  CHECK(frenet.value(5).exact() == Rational(0));
  CHECK_FALSE(frenet.bend().has_value());
  RmfAngle erf(Curve(turned), Reference::euler_rodrigues);
  CHECK_FALSE(erf.value(1).exact().has_value());
}

TEST_CASE("angle: an inflection does not disturb the Frenet angle") {
  // A = B(t²): r′(t) = r_B′(t²), the tangent of B's curve; g_A = 2t·g_B(t²) changes sign at 0.
  const QuaternionPolynomial b{{1, 2}, {3}, {0, 1}, {2, -1}};
  const Polynomial square{0, 0, 1};
  const QuaternionPolynomial a{compose(b.u, square), compose(b.v, square), compose(b.p, square),
                               compose(b.q, square)};
  RmfAngle on_a(Curve(a), Reference::frenet);
  RmfAngle on_b(Curve(b), Reference::frenet);
  // The frames follow the same tangents: θ_A(t) = θ_B(t²), on both sides of the inflection.
  for (const Rational& t : {Rational(1), Rational(-1), Rational(3, 2), Rational(-7, 3)})
    CHECK(fifty(on_a, t) == fifty(on_b, t * t));
}

TEST_CASE("angle: a cusp does not disturb it") {
  // A real factor of A leaves the tangents alone.
  const QuaternionPolynomial b{{1, 2}, {3}, {0, 1}, {2, -1}};
  const Polynomial factor{-1, 2};
  const Curve curve({factor * b.u, factor * b.v, factor * b.p, factor * b.q}, {-1, 3});
  for (const Reference reference : {Reference::euler_rodrigues, Reference::frenet}) {
    RmfAngle with_cusp(curve, reference);
    RmfAngle without(Curve(b), reference);
    CHECK(with_cusp.rate() == without.rate());
    CHECK(fifty(with_cusp, Rational(1, 2)) == fifty(without, Rational(1, 2)));
    CHECK(fifty(with_cusp, 3) == fifty(without, 3));
  }
}

TEST_CASE("angle: h of both signs with θ(t₁) = 0 exactly, seen through w(0) = w(1)") {
  // B(t² − t): the path t² − t returns to 0 at t = 1.
  const QuaternionPolynomial b{{1, 2}, {3}, {0, 1}, {2, -1}};
  const Polynomial w{0, -1, 1};
  const Curve curve({compose(b.u, w), compose(b.v, w), compose(b.p, w), compose(b.q, w)});
  RmfAngle erf(curve, Reference::euler_rodrigues);
  CHECK(erf.value(1).exact() == Rational(0));
  RmfAngle frenet(curve, Reference::frenet);
  CHECK(frenet.value(1).exact() == Rational(0));
  CHECK_FALSE(erf.value(Rational(1, 2)).exact().has_value());
}

TEST_CASE("angle: a rational RMF whose turns cancel at t = 1: θ = 0 exactly, in both frames") {
  // A = (1 + tj)·w turns the frame of 1 + tj, which is in a plane and is its own RMF, by 2 arg w:
  // w(1)/w(0) > 0 with w = (t + (1 + 2i)/10)(t + (1 − i)/2)².
  const auto linear = [](Rational re, Rational im) {
    return QuaternionPolynomial{{std::move(re), 1}, {std::move(im)}, {}, {}};
  };
  const QuaternionPolynomial w = linear(Rational(1, 10), Rational(2, 10)) *
                                 linear(Rational(1, 2), Rational(-1, 2)) *
                                 linear(Rational(1, 2), Rational(-1, 2));
  const Curve curve(QuaternionPolynomial{{1}, {}, {0, 1}, {}} * w);
  RmfAngle erf(curve, Reference::euler_rodrigues);
  CHECK(erf.value(1).exact() == Rational(0));
  CHECK_FALSE(erf.value(2).exact().has_value());
  CHECK(RmfAngle(curve, Reference::frenet).value(1).exact() == Rational(0));
}

TEST_CASE(
    "angle: law: its direction is that of the exact angle, for rational frames and no other") {
  for_samples(30, [](Random& random) {
    // With A, one in the plane z = 0 or the RRMF quintic of class I, also A·w has a rational frame.
    const QuaternionPolynomial plane{random.polynomial(2), {}, {}, random.polynomial(2)};
    const QuaternionPolynomial w{random.polynomial(2), random.polynomial(2), {}, {}};
    const QuaternionPolynomial a = (random.chance(2) ? plane : class_one) * w;
    if (is_zero(a)) return;
    for (const Reference reference : {Reference::euler_rodrigues, Reference::frenet}) {
      if (reference == Reference::frenet && is_zero(bend_numerator(a))) continue;
      RmfAngle angle(Curve(a), reference);
      const Rational t = random.rational();
      const auto z = angle.direction(t);
      REQUIRE(z);
      const RealBall size = sqrt(RealBall(z->re * z->re + z->im * z->im, 128), 128);
      const CosSin expected = cos_sin(angle.enclose(t, 128), 128);
      CHECK(expected.cos.overlaps(divide(RealBall(z->re, 128), size, 128)));
      CHECK(expected.sin.overlaps(divide(RealBall(z->im, 128), size, 128)));
    }
  });
  CHECK_FALSE(RmfAngle(quintic, Reference::euler_rodrigues).direction(0));
  // θ = −2t/(1 + t²): e^{iθ} is no rational function.
  CHECK_FALSE(
      RmfAngle(Curve({{0, 0, 1}, {0, 1}, {0, 1}, {1}}), Reference::euler_rodrigues).direction(1));
}

TEST_CASE("angle: far outside [0, 1] and close to 0, against the leading behaviour") {
  RmfAngle erf(quintic, Reference::euler_rodrigues);
  // θ′ = 8t/6·(1 + O(t)): at t = 10^-30 θ = (2/3)·10^-60 (1 + O(10^-30)).
  CHECK(round_to_decimal(erf.value(parse_rational("1e-30")), 20).value ==
        "6.6666666666666666667e-61");
  // The next terms are 4/9·t³, −17/9·t⁴ and −28/15·t⁵ (series division in fractions).
  const Rational h = parse_rational("1e-3000");
  const Rational near =
      h * h *
      (Rational(2, 3) + h * (Rational(4, 9) - h * (Rational(17, 9) + h * Rational(28, 15))));
  CHECK(round_to_decimal(erf.value(h), 10).value == "6.666666667e-6001");
  CHECK(round_to_decimal(erf.value(h), 10000).value == round_to_decimal(near, 10000).value);
  CHECK(round_to_decimal(erf.value(parse_rational("1e-100000")), 10).value ==
        "6.666666667e-200001");
  CHECK(round_to_decimal(erf.value(h) + Rational(1, 2), 9).value == "0.500000000");
  // The Frenet angle is 2/15·t + 272/225·t² + …: both parts are (2/15) and more apart from 0.
  RmfAngle frenet(quintic, Reference::frenet);
  const Rational leading_terms = h * (Rational(2, 15) + h * Rational(272, 225));
  CHECK(round_to_decimal(frenet.value(h), 3000).value ==
        round_to_decimal(leading_terms, 3000).value);
  for (const Route route : {Route::roots, Route::both}) {
    RmfAngle slow(quintic, Reference::euler_rodrigues);
    slow.set_route(route);
    CHECK(round_to_decimal(slow.value(parse_rational("1e-700")), 10).value == "6.666666667e-1401");
  }
  // θ has limits at ±∞: θ′ ~ −8/(37t²), so θ(10^30) and θ(10^31) differ by (8/37)(10^-30 − 10^-31).
  const RealBall change = subtract(erf.enclose(parse_rational("1e31"), 300),
                                   erf.enclose(parse_rational("1e30"), 300), 300);
  const Rational leading = Rational(-8, 37) * parse_rational("9e-31");
  CHECK(abs(change.lower() - leading) < parse_rational("1e-58"));
}

TEST_CASE("angle: law: values are integrals of the rate, for every form and both references") {
  for_samples(40, [](Random& random) {
    const Curve curve = random.curve(3);
    const Rational t = Rational(random.integer(-8, 8), 4);
    for (const Reference reference : {Reference::euler_rodrigues, Reference::frenet}) {
      if (reference == Reference::frenet && is_zero(bend_numerator(curve.preimage()))) {
        CHECK_THROWS_AS(RmfAngle(curve, reference), DomainError);
        continue;
      }
      RmfAngle angle(curve, reference);
      CHECK(differentiate(angle.antiderivative()) == angle.rate());
      CHECK(angle.value(0).exact() == Rational(0));
      const RealBall expected = quadrature(angle.rate(), 0, t, 60);
      CHECK(angle.enclose(t, 100).overlaps(expected));
      CHECK(angle.enclose(t, 100).is_accurate(100));
      RmfAngle other(curve, reference, Form::rothstein_trager);
      CHECK(other.enclose(t, 100).overlaps(angle.enclose(t, 100)));
      CHECK(differentiate(other.antiderivative()) == angle.rate());
    }
  });
}

TEST_CASE("angle: law: the paper's route has the same derivative and the same certified values") {
  long compared = 0;
  for_samples(60, [&](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    if (is_zero(bend_numerator(curve.preimage()))) return;
    const auto paper = frenet_angle_by_linear_system(curve);
    if (!paper) return;
    ++compared;
    RmfAngle closed_form(curve, Reference::frenet);
    CHECK(differentiate(*paper) == closed_form.rate());
    Evaluator evaluator(*paper);
    for (const Rational& t : {Rational(1), Rational(-3), Rational(7, 5)})
      CHECK(evaluator.difference(0, t, 120).overlaps(closed_form.enclose(t, 120)));
  });
  CHECK(compared > 10);
}

// A = 1 + ti: σ = 1 + t², h = 1, θ = −2 arctan t.
TEST_CASE("angle: a start that is a multiple of pi cancels the angle exactly") {
  const Curve turning({Polynomial{1}, Polynomial{0, 1}, {}, {}});
  RmfAngle angle(turning, Reference::euler_rodrigues);
  CHECK(angle.value(1, Angle(Rational(1, 2), 0)).exact() == Rational(0));
  CHECK(angle.value(1, Angle(Rational(1, 2), Rational(1, 3))).exact() == Rational(1, 3));
  CHECK(angle.value(-1, Angle(Rational(-1, 2), 0)).exact() == Rational(0));
  CHECK_FALSE(angle.value(1, Angle(Rational(1, 4), 0)).exact());
  CHECK_FALSE(angle.value(1, Angle(Rational(1, 3))).exact());
  CHECK(angle.value(0, Angle(Rational(1, 3))).exact() == Rational(1, 3));
  CHECK_FALSE(angle.value(0, Angle(1, 0)).exact());
  // π/2 − 2 arctan(1/2) = 0.643501108793284386802809… (mpmath)
  CHECK(round_to_decimal(angle.value(Rational(1, 2), Angle(Rational(1, 2), 0)), 20).value ==
        "0.64350110879328438680");
}

TEST_CASE("angle: copies outlive what they came from, and their values outlive them") {
  const auto made = std::make_unique<RmfAngle>(quintic, Reference::frenet);
  std::optional<RmfAngle> copy = *made;
  const Real theta = copy->value(1);
  copy.reset();
  CHECK(agree(round_to_decimal(theta, 50).value, fifty(*made, 1)));
  RmfAngle moved_from = *made;
  const RmfAngle moved = std::move(moved_from);  // NOLINT(performance-move-const-arg)
  CHECK(fifty(moved, 1) == fifty(*made, 1));
  CHECK(fifty(moved_from, 1) == fifty(*made, 1));  // NOLINT(bugprone-use-after-move): a promise
}

TEST_CASE("angle: the way that a copy takes is its own") {
  const RmfAngle angle(quintic, Reference::euler_rodrigues);
  RmfAngle both = angle;
  both.set_route(Route::both);
  CHECK(both.enclose(1, 200).overlaps(angle.enclose(1, 200)));
  CHECK(fifty(both, Rational(1, 3)) == fifty(angle, Rational(1, 3)));
}

TEST_CASE("angle: it depends on the preimage alone") {
  const QuaternionPolynomial& a = quintic.preimage();
  CHECK(RmfAngle(a).rate() == RmfAngle(Curve(a, {1, 0, 3})).rate());
  CHECK_THROWS_AS(RmfAngle(QuaternionPolynomial{}), DomainError);
}

TEST_CASE("threads: four of them ask one angle at rising precisions") {
  for (const Reference reference : {Reference::euler_rodrigues, Reference::frenet}) {
    const RmfAngle angle(quintic, reference);
    const RmfAngle other(quintic, reference);
    const auto digits = [](const RmfAngle& of, long k) {
      return round_to_decimal(of.value(Rational(1 + k % 3, 3)), 20 + 40 * k).value;
    };
    std::vector<std::vector<std::string>> found(4);
    std::vector<std::thread> threads;
    for (auto& list : found)
      threads.emplace_back([&list, &digits, angle] {
        for (long k = 0; k < 12; ++k) list.push_back(digits(angle, k));
        release_caches();  // of this thread
      });
    for (std::thread& thread : threads) thread.join();
    std::vector<std::string> expected;
    for (long k = 0; k < 12; ++k) expected.push_back(digits(other, k));
    for (const auto& list : found) CHECK(list == expected);
    CHECK(angle.direction(1).has_value() == other.direction(1).has_value());
  }
}

// The values of balls, to which set_route() sends, are another way.
TEST_CASE("angle: law: values from poles in doubles are those of balls, to the last digit") {
  for_samples(40, [](Random& random) {
    const long height = random.chance(2) ? 9 : 1'000'000'000;
    const auto any = [&](long degree) {
      std::vector<Rational> c;
      for (long k = 0; k <= degree; ++k) c.emplace_back(random.integer(-height, height));
      return Polynomial(c);
    };
    const long m = random.integer(1, 6);
    QuaternionPolynomial a{any(m), any(m), any(m), any(m)};
    if (random.chance(5)) {  // next to a cusp
      const Rational tiny = power_of_ten(-random.integer(2, 20));
      a.v *= tiny;
      a.p *= tiny;
      a.q *= tiny;
    }
    const RmfAngle angle(a);
    RmfAngle by_roots = angle;
    by_roots.set_route(Route::roots);
    const Rational t = random.chance(4) ? power_of_ten(-random.integer(1, 30))
                                        : Rational(random.integer(-30, 30), random.integer(1, 9));
    const FrameAngle start =
        random.chance(2) ? FrameAngle() : FrameAngle(Rational(1, 3), 2, {Rational(1, 2), 1});
    for (const long digits : {1, 8, 17, 18}) {
      const Decimal quick = round_to_decimal(angle.value(t, start), digits);
      const Decimal ball = round_to_decimal(by_roots.value(t, start), digits);
      CHECK(quick.value == ball.value);
      CHECK(quick.radius == ball.radius);
    }
  });
}

TEST_CASE("angle: of a plain curve doubles tell 17 digits, and what no route asks of them") {
  const RmfAngle angle(quintic);
  REQUIRE(angle.value(1).quick() != nullptr);
  CHECK(angle.value(1).quick()->is_accurate(85));
  CHECK(angle.value(1, FrameAngle(Rational(1, 2), 0)).quick() != nullptr);
  RmfAngle by_roots = angle;
  by_roots.set_route(Route::roots);
  CHECK(by_roots.value(1).quick() == nullptr);
  CHECK(angle.value(0).quick() == nullptr);
}
