#include "phrame/ph/frame/rational_frame.hpp"

#include "phrame/algebra/resultant.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::class_one;
using test::for_samples;
using test::Random;

namespace {

QuaternionPolynomial times(const QuaternionPolynomial& a, const GaussianPolynomial& w) {
  const auto [alpha, beta] = hopf_form(a);
  return from_hopf_form({alpha * w, beta * w});
}

QuaternionPolynomial compose(const QuaternionPolynomial& a, const Polynomial& t) {
  return {phrame::compose(a.u, t), phrame::compose(a.v, t), phrame::compose(a.p, t),
          phrame::compose(a.q, t)};
}

/// The frame, after a check from the definitions: 2·arg w is the angle, and the ERF of B = A·w up
/// to a real factor is rotation-minimizing.
RationalFrame checked_frame(const QuaternionPolynomial& a) {
  const auto result = rational_frame(a);
  REQUIRE(std::holds_alternative<RationalFrame>(result));
  const RationalFrame frame = std::get<RationalFrame>(result);
  const Polynomial slope = (differentiate(frame.w) * conjugate(frame.w)).im;
  CHECK(sigma(a) * slope == -(twist_numerator(a) * norm(frame.w)));
  const QuaternionPolynomial b = times(a, frame.w);
  const Polynomial content = real_content(b);
  CHECK(exact_quotient(b.u, content) == frame.preimage.u);
  CHECK(exact_quotient(b.q, content) == frame.preimage.q);
  CHECK(twist_numerator(frame.preimage).is_zero());
  return frame;
}

/// Is a residue of 2h/σ not in iℤ? By enclosures.
bool has_residue_off_integers(const QuaternionPolynomial& a) {
  const RationalFunction f = -rate_to_erf(a);
  const Polynomial& d = f.denominator();
  const Roots roots = isolate_roots(d, 128);
  const auto is_off = [&](const ComplexBall& z) {
    const ComplexBall c =
        divide(evaluate(f.numerator(), z, 128), evaluate(differentiate(d), z, 128), 128);
    for (long n = -10; n <= 10; ++n)
      if (c.overlaps({RealBall(), RealBall(n, 128)})) return false;
    return c.im().lower() > -10 && c.im().upper() < 10;
  };
  for (const ComplexBall& z : roots.upper)
    if (is_off(z)) return true;
  return false;
}

}  // namespace

TEST_CASE("rational frame: the class I quintic has the known w") {
  CHECK(sigma(class_one) == Polynomial{1, 0, 44, 24, 205});
  CHECK(twist_numerator(class_one) == Polynomial{4, 6, -56});
  const RationalFrame frame = checked_frame(class_one);
  // t² + (12 − 56i)t/205 + (14 + 3i)/205, or its conjugate: which, depends on the sign of θ.
  const GaussianPolynomial known{{Rational(14, 205), Rational(12, 205), 1},
                                 {Rational(3, 205), Rational(-56, 205)}};
  CHECK((frame.w == known || frame.w == conjugate(known)));
  CHECK(degree(frame.preimage) == 4);
}

TEST_CASE("rational frame: another class of quintics") {
  // A = 1 + (i + j)t + (−2 + k)t²/5.
  checked_frame({{1, 0, Rational(-2, 5)}, {0, 1}, {0, 1}, {0, 0, Rational(1, 5)}});
}

TEST_CASE("rational frame: where h = 0 it is the ERF; where a residue is no multiple of i, none") {
  const QuaternionPolynomial septic{{1}, {0, 0, 0, 1}, {0, 3}, {0, 0, 1}};
  const RationalFrame frame = checked_frame(septic);
  CHECK(degree(frame.w) == 0);
  CHECK(frame.preimage == septic);
  // θ = −2t/(1 + t²): rational, but e^{iθ} is not.
  const auto repeated = rational_frame({{0, 0, 1}, {0, 1}, {0, 1}, {1}});
  using Reason = NoRationalFrame::Reason;
  REQUIRE(std::holds_alternative<NoRationalFrame>(repeated));
  CHECK(std::get<NoRationalFrame>(repeated) == NoRationalFrame{Reason::multiple_pole, {1, 0, 1}});
  // α = 1 + it: 2h/σ = 2/(1 + t²) has the residues ∓i.
  checked_frame({{1}, {0, 1}, {}, {}});
  // u = 1, v = t, p = 0, q = t: 2h/σ = 2/(1 + 2t²) has the residues ∓i/√2.
  const auto quadratic = rational_frame({{1}, {0, 1}, {}, {0, 1}});
  REQUIRE(std::holds_alternative<NoRationalFrame>(quadratic));
  CHECK(std::get<NoRationalFrame>(quadratic) == NoRationalFrame{Reason::residue, {1, 0, 2}});
}

TEST_CASE("rational frame: law: A·w̄ has one if A has, of no higher degree") {
  for_samples(30, [](Random& random) {
    // Plane curves: u and q only have h = 0.
    const auto small = [&](long degree) {
      std::vector<Rational> c;
      for (long k = 0; k <= degree; ++k) c.emplace_back(random.integer(-5, 5));
      return Polynomial(c);
    };
    const QuaternionPolynomial minimizing =
        random.chance(2)
            ? QuaternionPolynomial{small(2) + Polynomial::monomial(1, 3), {}, {}, small(3)}
            : QuaternionPolynomial{{1}, {0, 0, 0, 1}, {0, 3}, {0, 0, 1}};
    const Polynomial one{1};
    GaussianPolynomial w{one, {}};
    for (long k = random.integer(1, 3); k > 0; --k)
      w = w * GaussianPolynomial{small(1) + Polynomial{0, 1}, Polynomial{random.integer(1, 4)}};
    const RationalFrame frame = checked_frame(times(minimizing, w));
    CHECK(degree(frame.preimage) <= degree(minimizing));
  });
}

TEST_CASE("rational frame: law: a new parameter and a factor change nothing, to degree 25") {
  for_samples(6, [](Random& random) {
    const Polynomial t{random.integer(-3, 3), random.integer(1, 3), random.integer(-2, 2),
                       random.integer(1, 2)};
    QuaternionPolynomial a = compose(class_one, t);  // degree 6: a curve of degree 13
    checked_frame(a);
    const GaussianPolynomial w{{random.integer(-3, 3), random.integer(1, 3)},
                               {random.integer(1, 3), random.integer(-1, 1)}};
    for (long k = random.integer(1, 6); k > 0; --k) a = times(a, w);
    checked_frame(a);
  });
}

TEST_CASE("rational frame: law: random quintics have none, and the residue says so") {
  for_samples(50, [](Random& random) {
    const auto c = [&] {
      return Polynomial{random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9)};
    };
    const QuaternionPolynomial a{c(), c(), c(), c()};
    if (is_zero(a) || twist_numerator(a).is_zero()) return;
    const auto result = rational_frame(a);
    if (std::holds_alternative<RationalFrame>(result)) {
      checked_frame(a);
      return;
    }
    const auto& none = std::get<NoRationalFrame>(result);
    if (none.reason == NoRationalFrame::Reason::multiple_pole) return;
    CHECK(has_residue_off_integers(a));
    const RationalFunction f = -rate_to_erf(a);
    CHECK((residue_polynomial(f.numerator(), f.denominator()) % none.factor).is_zero());
    for (long n = 1; n <= 20; ++n) CHECK(gcd(none.factor, Polynomial{n * n, 0, 1}).is_constant());
  });
}
