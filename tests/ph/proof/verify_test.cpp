#include "phrame/ph/proof/verify.hpp"

#include <algorithm>

#include "io/reference.hpp"
#include "phrame/algebra/argument.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/io/read/certificate_file.hpp"
#include "phrame/io/write/certificate.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/proof/certify.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"
#include "support/rational_curves.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

std::vector<std::string> not_proved(const Certificate& c) {
  std::vector<std::string> list;
  for (const auto& [what, objection, segment] : verify(c)) {
    const auto* part = std::get_if<std::string>(&what);
    if (!objection.empty()) list.push_back((part != nullptr ? *part : "theta") + ": " + objection);
  }
  return list;
}

void check_proved(const Certificate& c) {
  for (const std::string& objection : not_proved(c)) FAIL_CHECK(objection);
}

/// At 1/2, 1 and −1/3 with 30 digits.
Certificate certificate(const Curve& curve, Reference reference) {
  return certify(curve, reference, {Rational(1, 2), 1, Rational(-1, 3)}, 30);
}

bool is_line(const Curve& curve) { return line_direction(curve.preimage()).has_value(); }

}  // namespace

TEST_CASE("certificate: the quintic's angles are the known ones, its proof is proved") {
  const Certificate c = certify(farouki_quintic().curve, Reference::euler_rodrigues, {1}, 40);
  const std::string truth = farouki_2003()["quintic"]["theta_RMF_rel_ERF"]["1"].get<std::string>();
  check_rounded(c.claims[0].theta, c.claims[0].radius, truth, 40, 48);
  CHECK(c.claims[0].radius == "5e-41");
  check_proved(c);
}

TEST_CASE("certificate: all curves up to preimage degree 4, both frames, through a file") {
  std::istringstream lines(read_data("curves.jsonl"));
  long low = 0;
  long proved = 0;
  for (std::string line; std::getline(lines, line);) {
    const NamedCurve named = read_curve(line);
    if (preimage_degree(named.curve) > everyday(4, 8)) continue;
    if (low++ % everyday(3, 1) != 0) continue;  // every third one is enough for every day
    CAPTURE(named.name);
    for (const Reference reference : {Reference::euler_rodrigues, Reference::frenet}) {
      if (reference == Reference::frenet && is_line(named.curve)) continue;
      const Certificate c = certificate(named.curve, reference);
      const std::string text = write_certificate(c, named.name);
      CHECK(read_certificate(text).certificate == c);
      check_proved(c);
      ++proved;
    }
  }
  CHECK(proved == everyday(34, 161));  // a straight line has no Frenet frame
}

TEST_CASE("verify: near-cusps, next to the ends and inside, are proved") {
  // A = (t − c)·B + ε·C, a cusp at c but for ε. tools/check_certificate.py proves the same ones:
  // tests/certificates.
  const auto near_cusp = [](const Rational& c, const Rational& epsilon) {
    const Polynomial x{-c, 1};
    const auto part = [&](const Polynomial& b, const Rational& e) {
      return x * b + Polynomial{epsilon * e};
    };
    return Curve({part({2, -1}, 3), part({1, 4}, -2), part({-3, 1}, 1), part({5, -2}, 4)});
  };
  std::vector<const char*> distances{"1e-3", "1e-30", "1e-9", "1e-16"};
  distances.resize(static_cast<std::size_t>(everyday(2, 4)));
  long places = 0;
  for (const char* text : distances) {
    const Rational epsilon = parse_rational(text);
    for (const Rational& c : {Rational(0), epsilon, Rational(1, 3), Rational(1, 2),
                              Rational(1 - epsilon), Rational(1), Rational(1 + epsilon)}) {
      if (places++ % everyday(2, 1) != 0) continue;  // each place, with one of the distances
      CAPTURE(text);
      CAPTURE(to_string(c));
      check_proved(
          certify(near_cusp(c, epsilon), Reference::euler_rodrigues, {Rational(1, 2), 1}, 25));
    }
  }
}

TEST_CASE("certificate: exact angles are claimed as such") {
  const Certificate rational =
      certify(rational_angle_curve().curve, Reference::euler_rodrigues, {0, 1, Rational(1, 3)}, 20);
  CHECK(rational.logs.empty());
  CHECK(rational.claims[0] == AngleClaim{0, "0", "0", {}});
  CHECK(parse_rational(rational.claims[1].theta) == -1);  // −2t/(t² + 1)
  CHECK(rational.claims[1].radius == "0");
  CHECK(parse_rational(rational.claims[2].theta) == Rational(-3, 5));
  check_proved(rational);
  // A plane curve: its Frenet frame is rotation-minimizing, though −2h/σ has logarithms.
  const Curve parabola({Polynomial{1}, {}, {}, Polynomial{0, 1, 1}}, Polynomial{1});
  for (const Curve& curve :
       {parabola,
        Curve(parabola.preimage() * QuaternionPolynomial{{1}, Polynomial{0, 1}, {}, {}})}) {
    const Certificate c = certificate(curve, Reference::frenet);
    for (const AngleClaim& claim : c.claims) {
      CHECK(claim.theta == "0");
      CHECK(claim.radius == "0");
    }
    check_proved(c);
  }
  const Certificate line = certificate(straight_line().curve, Reference::euler_rodrigues);
  CHECK(line.claims[1] == AngleClaim{1, "0", "0", {}});
  check_proved(line);
  CHECK_THROWS_AS(certificate(straight_line().curve, Reference::frenet), DomainError);
}

// γ = (1 + it)² is purely imaginary at t = 1.
TEST_CASE("certificate: a turn by exactly a quarter") {
  const Curve curve({Polynomial{1}, {}, Polynomial{0, 0, 1}, Polynomial{0, 1, 0, Rational(-1, 3)}});
  const Certificate c = certify(curve, Reference::frenet, {1, -1}, 30);
  const auto [x, y] = ContinuousArgument(c.bend->polynomial).coordinates(1);
  CHECK(x(1) != 0);
  check_proved(c);
}

TEST_CASE("certificate: law: random curves are proved, many or few digits") {
  for_samples(15, [](Random& random) {
    const Curve curve = random.curve(5);
    const Reference reference =
        is_line(curve) || random.chance(2) ? Reference::euler_rodrigues : Reference::frenet;
    const Certificate c =
        certify(curve, reference, {random.rational(), random.rational()}, random.integer(1, 120));
    CHECK(read_certificate(write_certificate(c, "")).certificate == c);
    check_proved(c);
  });
}

// Each makes one statement false.
TEST_CASE("verify: what is false is not proved") {
  const Curve twisted = farouki_quintic().curve;
  using Change = std::pair<const char*, void (*)(Certificate&)>;
  const std::vector<Change> changes{
      {"curve", [](Certificate& c) { c.curve = Curve(c.curve.preimage(), Polynomial{2}); }},
      {"hodograph", [](Certificate& c) { c.hodograph[1] += Polynomial{1}; }},
      {"sigma",
       [](Certificate& c) {
         c.sigma += Polynomial{0, 1};
       }},
      {"h", [](Certificate& c) { c.h = -c.h; }},
      {"g", [](Certificate& c) { c.g = conjugate(c.g); }},
      {"numerator", [](Certificate& c) { c.rate.numerator *= 2; }},
      {"denominator", [](Certificate& c) { c.rate.denominator += Polynomial{1}; }},
      {"common",
       [](Certificate& c) {
         c.rate.common += Polynomial{0, 1};
       }},
      {"common factor",
       [](Certificate& c) {
         c.rate.numerator *= Polynomial{1, 1};
         c.rate.denominator *= Polynomial{1, 1};
       }},
      {"modulus that divides a leading coefficient",
       [](Certificate& c) {
         c.rate.modulus = Integer(37);  // of 6 − 12t + 46t² − 72t³ + 37t⁴
       }},
      {"modulus of a common root",
       [](Certificate& c) {
         c.rate.modulus = Integer(3);  // h ≡ t(t − 1) and σ have the root 0
       }},
      {"modulus that is no prime", [](Certificate& c) { c.rate.modulus *= Integer(15); }},
      {"rational",
       [](Certificate& c) {
         c.rational = RationalFunction({1}, {1, 1});
       }},
      {"index", [](Certificate& c) { c.logs[0].index += Polynomial{1}; }},
      {"residue", [](Certificate& c) { c.logs[0].residue += Polynomial{1}; }},
      {"lost log", [](Certificate& c) { c.logs.clear(); }},
      {"lost disc", [](Certificate& c) { c.logs[0].roots.pop_back(); }},
      {"twice", [](Certificate& c) { c.logs[0].roots[0] = c.logs[0].roots[1]; }},
      {"conjugate",
       [](Certificate& c) { c.logs[0].roots[0].center.im = -c.logs[0].roots[0].center.im; }},
      {"center", [](Certificate& c) { c.logs[0].roots[0].center.re += 100; }},
      {"radius", [](Certificate& c) { c.logs[0].roots[0].radius = 0; }},
      {"negative radius", [](Certificate& c) { c.logs[0].roots[0].radius = -1000; }},
      {"huge radius",
       [](Certificate& c) {
         c.logs[0].roots[0].radius = Integer(1) << static_cast<unsigned long>(c.bits + 8);
       }},
      {"residue disc", [](Certificate& c) { c.logs[0].roots[0].residue.im += 1000; }},
      {"residue radius", [](Certificate& c) { c.logs[0].roots[0].residue_radius = 0; }},
      {"negative residue radius",
       [](Certificate& c) {
         c.logs[0].roots[0].residue_radius = -c.logs[0].roots[0].residue_radius;
       }},
      {"bits", [](Certificate& c) { c.bits += 1; }},
      {"content", [](Certificate& c) { c.bend->content *= 2; }},
      {"bend", [](Certificate& c) { c.bend->polynomial.re += Polynomial{1}; }},
      {"index of the turn", [](Certificate& c) { c.claims[0].turn->index += 1; }},
      {"signs", [](Certificate& c) { c.claims[0].turn->at_zero[0] = '-'; }},
      {"t", [](Certificate& c) { c.claims[0].t += Rational(1, 1000); }},
      {"theta", [](Certificate& c) { c.claims[1].theta[5] ^= 1; }},
      {"radius of theta", [](Certificate& c) { c.claims[1].radius = "1e-33"; }},
      {"no radius", [](Certificate& c) { c.claims[1].radius = "0"; }},
      {"negative", [](Certificate& c) { c.claims[1].radius = "-1"; }},
      {"regular", [](Certificate& c) { c.decisions.regular = false; }},
      {"inflections", [](Certificate& c) { c.decisions.has_inflections = true; }},
      {"line",
       [](Certificate& c) {
         c.decisions.line = {1, 0, 0};
       }},
      {"planar",
       [](Certificate& c) {
         c.decisions.normal = {1, 0, 0};
       }},
      {"helical",
       [](Certificate& c) {
         c.decisions.helix = {{1, 0, 0}, Rational(1, 2)};
       }},
      {"double PH",
       [](Certificate& c) {
         c.decisions.double_ph = {1, {1}};
       }},
      {"primitive", [](Certificate& c) { c.decisions.primitive = false; }},
      {"content",
       [](Certificate& c) {
         c.decisions.content = {1, 1};
       }},
      {"ERF", [](Certificate& c) { c.decisions.erf_is_rmf = true; }},
      {"RRMF",
       [](Certificate& c) {
         c.decisions.rational_frame = {{1}, {0, 1}};
       }},
      {"monotone", [](Certificate& c) { c.decisions.erf_monotone = false; }},
      {"lost zero", [](Certificate& c) { c.decisions.zeros_of_h.pop_back(); }},
      {"order", [](Certificate& c) { c.decisions.zeros_of_h[0].order = 2; }},
      {"place",
       [](Certificate& c) { c.decisions.extrema[0].interval = open_interval(0, Rational(1, 3)); }},
  };
  const Certificate good = certificate(twisted, Reference::frenet);
  check_proved(good);
  for (const Change& change : changes) {
    CAPTURE(change.first);
    Certificate bad = good;
    change.second(bad);
    CHECK(not_proved(bad).size() >= 1);
  }
}

// σ = (t² − ct + 1)(t² + ct + 1) with c ≈ 10⁻²²: on a coarse grid the roots of the two factors are
// in the same discs, and a residue there says nothing of F′.
TEST_CASE("certificate: a residue is shown where only one logarithm has a pole") {
  Rational m = 0;  // a convergent of √2 − 1
  for (int k = 0; k < 30; ++k) m = Rational(1) / (2 + m);
  const Rational b = (1 + 2 * m - m * m) / (1 + m * m);
  const Certificate c =
      certify(Curve({{1}, {0, b}, {}, {0, 0, 1}}), Reference::euler_rodrigues, {0}, 17);
  REQUIRE(c.logs.size() == 2);
  CHECK(are_apart(c.logs[0].roots[0], c.logs[1].roots[0]));
  check_proved(c);
}

TEST_CASE("certificate: roots of any size are at the nearest points of the grid") {
  const Rational tiny = phrame::power_of_ten(-3000);
  const Certificate c = certify(Curve({{1}, {0, tiny}, {0, 0, tiny * tiny}, {Rational(1, 3)}}),
                                Reference::euler_rodrigues, {0}, 17);
  for (const RootDisc& disc : c.logs.at(0).roots) CHECK(disc.radius <= 4);
}

TEST_CASE("verify: a straight line has no Frenet frame") {
  Certificate c = certificate(farouki_quintic().curve, Reference::frenet);
  c.curve = straight_line().curve;
  const auto list = not_proved(c);
  CHECK(std::find(list.begin(), list.end(), "bend: a straight line has no Frenet frame") !=
        list.end());
}

TEST_CASE("verify: the order of points is no matter") {
  Certificate c = certificate(farouki_quintic().curve, Reference::euler_rodrigues);
  std::swap(c.decisions.zeros_of_h.at(0), c.decisions.zeros_of_h.at(1));
  check_proved(c);
}

TEST_CASE("verify: of a line no vector is a witness but its direction and its normals") {
  const Certificate good = certificate(straight_line().curve, Reference::euler_rodrigues);
  check_proved(good);
  for (const Vector<Rational>& v : {Vector<Rational>{1, 2, 3}, Vector<Rational>{}}) {
    Certificate bad = good;
    bad.decisions.line = v;
    CHECK(not_proved(bad).size() == 1);
    bad = good;
    bad.decisions.normal = v;
    CHECK(not_proved(bad).size() == 1);
  }
  Certificate bad = good;
  bad.decisions.rational_frame = {{1}, {0, 1}};  // turns
  CHECK(not_proved(bad).size() == 1);
}

// (u, v, p, q) = (1, t, t, 0), a helix: x = 1, y = 2t², σ = 1 + 2t², so that x + y = σ.
TEST_CASE("verify: another witness is as good, a wrong one is none") {
  Certificate c = certificate(Curve({{1}, {0, 1}, {0, 1}, {}}), Reference::frenet);
  check_proved(c);
  c.decisions.helix->axis = {-3, -3, 0};
  c.decisions.double_ph->constant /= 4;
  c.decisions.double_ph->omega *= -2;
  check_proved(c);
  c.decisions.helix->cosine_squared = Rational(1, 3);
  c.decisions.double_ph->omega *= 2;
  CHECK(not_proved(c).size() == 2);
  c.decisions.helix.reset();
  c.decisions.double_ph.reset();
  CHECK(not_proved(c).size() == 2);
}

// Newton's step proves a root in a disc d times as narrow as the law of docs/certificate.md asks
// for, and a wide disc has the root where the step proves nothing.
TEST_CASE("verify: discs have the radii that the law asks for, or greater ones") {
  const Certificate good = certificate(farouki_quintic().curve, Reference::euler_rodrigues);
  const auto roots_proved = [](const Certificate& c) { return verify(c).at(3).is_proved(); };
  const RootDisc& disc = good.logs.at(0).roots.at(0);
  const Polynomial& q = good.logs[0].index;
  const auto found = radius_of_root(q, disc.center, good.bits);
  REQUIRE(found);
  const Integer& least = *found;
  CHECK(least == disc.radius);
  Certificate c = good;
  c.logs[0].roots[0].radius = least - 1;
  CHECK_FALSE(roots_proved(c));
  // The roots are −0.2 … 1.2 ± 0.4i, and 0.9 apart.
  c.logs[0].roots[0].radius = disc.center.im - 1;
  CHECK(roots_proved(c));
}

TEST_CASE("verify: claims and the lack of a rational frame rest on the discs") {
  Certificate c = certificate(farouki_quintic().curve, Reference::euler_rodrigues);
  // The residues are known to within 1, the angle is not.
  for (RootDisc& disc : c.logs.at(0).roots)
    disc.residue_radius = Integer(1) << static_cast<unsigned long>(c.bits);
  const auto objections = not_proved(c);
  CHECK(std::count(objections.begin(), objections.end(), "theta: the discs are too large") == 3);
  CHECK(objections.back() == "decision rrmf: no: no disc shows a residue outside iZ");
  CHECK(objections.size() == 4);
}

TEST_CASE("verify: 1200 digits, next to a cusp, too") {
  const Rational e = phrame::power_of_ten(-20);
  const Curve curve({{Rational(-1, 2) + 3 * e, 1}, {-2 * e, 3}, {e, -1}, {4 * e, 2}});
  check_proved(certify(curve, Reference::euler_rodrigues, {1}, 1200));
  check_proved(certify(curve, Reference::frenet, {1}, 1200));
}

TEST_CASE("verify: an interval whose end is a zero isolates none") {
  Certificate c = certificate(farouki_quintic().curve, Reference::euler_rodrigues);
  StatedPoint& point = c.decisions.zeros_of_h.at(0);
  const Rational at = -point.polynomial.coefficient(0) / point.polynomial.coefficient(1);
  REQUIRE(point.polynomial.degree() == 1);
  point.polynomial *= Polynomial{-5, 1};
  point.interval = open_interval(at - 1, 5);
  CHECK(not_proved(c).size() == 1);
  point.interval = open_interval(at - 1, 4);
  check_proved(c);
}

// At ct/(1 + (c − 1)t) the polynomial curve has the frames that the rational one has at t.
TEST_CASE("certificate: a curve has the angles that it has with another parameter") {
  const Rational c(3, 2);
  const Curve rational = std::get<Curve>(identify(reparametrized(quintic, c)));
  REQUIRE_FALSE(rational.is_polynomial());
  for (const Reference reference : {Reference::euler_rodrigues, Reference::frenet}) {
    const Certificate mine = certify(rational, reference, {Rational(1, 3), 1}, 30);
    const Certificate whole = certify(quintic, reference, {Rational(3, 7), 1}, 30);
    for (std::size_t k = 0; k < 2; ++k) CHECK(mine.claims[k].theta == whole.claims[k].theta);
    check_proved(mine);
    CHECK(read_certificate(write_certificate(mine, "")).certificate == mine);
    check_proved(certify(with_factor(rational, Polynomial{1, 1}), reference, {1}, 20));
  }
  CHECK_THROWS_AS(certify(rational, Reference::frenet, {2}, 30), DomainError);
}

TEST_CASE("verify: a weight with a zero on [0, 1] is no weight") {
  const auto objections = [](const Polynomial& factor) {
    return not_proved(certify(with_factor(quarter_circle(), factor), Reference::frenet, {1}, 20));
  };
  using List = std::vector<std::string>;
  for (const Polynomial& c : {Polynomial{-1, 2}, Polynomial{1, -1}, pow(Polynomial{-2, 3}, 2)})
    CHECK(std::ranges::count(objections(c), "weight: the weight has a zero on [0, 1]") == 1);
  CHECK(objections({1, 1}) == List{});
  CHECK(objections({-4, 3}) == List{});
}
