#include <algorithm>

#include "phrame/integrate/definite_integral.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/known_integral.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

const Endpoint infinity = Infinity::positive;
const Endpoint minus_infinity = Infinity::negative;

Endpoint rational(const Rational& x) { return x; }

/// √2, √3, …
Endpoint root_of(long n) { return real_root({-n, 0, 1}, {Rational(0), std::nullopt}); }

RealBall value(const ExactValue& v, long bits) {
  RealBall sum =
      add(RealBall(v.rational, bits), multiply(RealBall(v.pi, bits), pi(bits), bits), bits);
  for (const auto& [factor, of] : v.logarithms) {
    RealBall term(of, bits);
    arb_log(term.raw(), term.raw(), bits);
    sum = add(sum, multiply(RealBall(factor, bits), term, bits), bits);
  }
  for (const auto& [factor, of] : v.arctangents) {
    RealBall term(of, bits);
    arb_atan(term.raw(), term.raw(), bits);
    sum = add(sum, multiply(RealBall(factor, bits), term, bits), bits);
  }
  if (v.irrational_pi)
    sum = add(sum, multiply(enclose(*v.irrational_pi, bits), pi(bits), bits), bits);
  return sum;
}

/// ∫ f by Arb's quadrature, which knows neither logarithms nor residues: beyond ±1 of f(1/s)/s²
/// from 0 to 1/t. Preconditions: no pole between the ends, and an integral.
RealBall by_quadrature(const RationalFunction& f, const Endpoint& a, const Endpoint& b, long bits) {
  const long n = f.numerator().degree();
  const long m = f.denominator().degree();
  const auto reversed = [](const Polynomial& p) {
    std::vector<Rational> list = p.coefficients();
    std::reverse(list.begin(), list.end());
    return Polynomial(list);
  };
  const auto from_zero = [&](const Endpoint& end) {
    if (const auto* t = std::get_if<Rational>(&end)) return quadrature(f, 0, *t, bits);
    const Rational unit = end == infinity ? 1 : -1;
    const RationalFunction g(reversed(f.numerator()) * Polynomial::monomial(1, m - n - 2),
                             reversed(f.denominator()));
    return add(quadrature(f, 0, unit, bits), quadrature(g, 0, unit, bits), 2 * bits);
  };
  return subtract(from_zero(b), from_zero(a), 2 * bits);
}

/// Is there an integral between rational or infinite ends? By counting roots only.
bool exists(const RationalFunction& f, const Endpoint& a, const Endpoint& b, AtPoles at_poles) {
  if (f.is_zero()) return true;
  const auto* x = std::get_if<Rational>(&a);
  const auto* y = std::get_if<Rational>(&b);
  const long drop = f.denominator().degree() - f.numerator().degree();
  const bool principal = at_poles == AtPoles::principal_value;
  const bool whole_line = x == nullptr && y == nullptr && !(a == b);
  if ((x == nullptr || y == nullptr) && drop < (principal && whole_line ? 1 : 2)) return false;
  if (x == nullptr && y == nullptr && a == b) return true;
  Interval path;
  if (x != nullptr && y != nullptr) path = closed_interval(std::min(*x, *y), std::max(*x, *y));
  if (a == infinity || b == infinity)
    path.lower = x != nullptr ? std::optional(*x) : y != nullptr ? std::optional(*y) : std::nullopt;
  else if (a == minus_infinity || b == minus_infinity)
    path.upper = x != nullptr ? *x : *y;
  const Polynomial& d = f.denominator();
  if (!principal) return count_real_roots(d, path) == 0;
  for (const Rational* end : {x, y})
    if (end != nullptr && d(*end) == 0) return false;
  return d.is_constant() || count_real_roots(gcd(d, differentiate(d)), path) == 0;
}

std::string digits(const DefiniteIntegral& integral, long count) {
  return round_to_decimal(integral.value, count).value;
}

}  // namespace

TEST_CASE("definite integral: π, log 2 and 3π/4 + arctan(1/2) in finite terms") {
  CHECK(definite_integral({{1}, {1, 0, 1}}, minus_infinity, infinity).exact ==
        ExactValue{0, 1, {}, {}});
  CHECK(definite_integral({{1}, {1, 0, 1}}, infinity, rational(0)).exact ==
        ExactValue{0, Rational(-1, 2), {}, {}});
  CHECK(definite_integral({{1}, {0, 1, 1}}, rational(1), infinity).exact ==
        ExactValue{0, 0, {{1, 2}}, {}});
  // 3π/4 + arctan(1/2) = π − arctan(1/3).
  CHECK(definite_integral({{6, 0, -3, 0, 1}, {4, 0, 5, 0, -5, 0, 1}}, rational(1), rational(2))
            .exact == ExactValue{0, 1, {}, {{-1, Rational(1, 3)}}});
  // Dalzell: ∫₀¹ t⁴(1 − t)⁴/(1 + t²) dt = 22/7 − π.
  const Polynomial t{0, 1};
  CHECK(definite_integral({pow(t, 4) * pow(Polynomial{1, -1}, 4), {1, 0, 1}}, rational(0),
                          rational(1))
            .exact == ExactValue{Rational(22, 7), -1, {}, {}});
  const DefiniteIntegral none = definite_integral({{1}, {1, 1, 0, 1}}, rational(0), infinity);
  CHECK_FALSE(none.exact.has_value());
}

// Euler 1738 and Machin 1706.
TEST_CASE("definite integral: arctangents that add up to a multiple of π") {
  const ExactValue quarter{0, Rational(1, 4), {}, {}};
  const auto arctan = [](const Rational& factor, const Rational& of) {
    return ExactValue{0, 0, {}, {{factor, of}}};
  };
  CHECK(arctan(1, Rational(1, 2)) + arctan(1, Rational(1, 3)) == quarter);
  CHECK(arctan(4, Rational(1, 5)) + arctan(-1, Rational(1, 239)) == quarter);
  CHECK(Rational(-4) * quarter + arctan(1, 2) == ExactValue{0, -1, {}, {{1, 2}}});
  const ExactValue mixed{Rational(1, 2), 0, {{3, 2}}, {{1, 5}}};
  CHECK(mixed + Rational(-1) * mixed == ExactValue{});
  CHECK(mixed + ExactValue{1, 0, {{3, 5}}, {}} ==
        ExactValue{Rational(3, 2), 0, {{3, 10}}, {{1, 5}}});
  // (2 + it)(3 + it) turns by arctan(1/2) + arctan(1/3) from 0 to 1.
  CHECK(definite_integral({{30, 0, 5}, {36, 0, 13, 0, 1}}, rational(0), rational(1)).exact ==
        quarter);
}

// π − π/(1 + ε) = επ − ….
TEST_CASE("definite integral: small ones over the whole line, with the digits asked for") {
  const Rational a = 1 + power_of_ten(-3000);
  const RationalFunction f =
      RationalFunction({1}, {1, 0, 1}) - RationalFunction({1}, {a * a, 0, 1});
  const DefiniteIntegral integral = definite_integral(f, Infinity::negative, Infinity::positive);
  CHECK(round_to_decimal(integral.value, 10).value == "3.141592654e-3000");
  REQUIRE(integral.exact);
  CHECK(integral.exact->pi == 1 - 1 / a);
}

TEST_CASE("definite integral: what diverges is refused with the reason") {
  const auto message = [](const std::string& text) { return doctest::Contains(text.c_str()); };
  CHECK_THROWS_WITH_AS(
      definite_integral({{3}, {0, 2}}, rational(1), infinity),
      message("diverges at ∞, where the integrand is about 3/2 times the power -1 of its variable"),
      DomainError);
  CHECK_THROWS_WITH_AS(definite_integral({{0, 0, 1}, {1}}, minus_infinity, rational(1)),
                       message("diverges at −∞"), DomainError);
  CHECK_THROWS_WITH_AS(definite_integral({{1}, {-1, 0, 1}}, rational(0), infinity),
                       message("pole at 1"), DomainError);
  CHECK_THROWS_WITH_AS(definite_integral({{1}, {-2, 0, 1}}, root_of(2), rational(2)),
                       message("pole in ("), DomainError);
  // √2 < √3: the pole √2 is in (1, √3), not in (√3, 2), although the intervals are close.
  CHECK_THROWS_AS(definite_integral({{1}, {-2, 0, 1}}, rational(1), root_of(3)), DomainError);
  CHECK_NOTHROW(definite_integral({{1}, {-2, 0, 1}}, root_of(3), rational(2)));
  CHECK(definite_integral(RationalFunction(), minus_infinity, infinity).value.exact() ==
        Rational(0));
}

TEST_CASE("definite integral: from an infinite end to the same, there is no pole") {
  for (const Endpoint& end : {infinity, minus_infinity}) {
    CHECK(definite_integral({{1}, {-1, 0, 1}}, end, end).value.exact() == Rational(0));
    for (const AtPoles at_poles : {AtPoles::refuse, AtPoles::principal_value})
      CHECK_THROWS_AS(definite_integral({{1}, {0, 1}}, end, end, at_poles), DomainError);
  }
}

TEST_CASE("definite integral: odd about a point between the ends, it is 0") {
  const auto principal = AtPoles::principal_value;
  const Polynomial s{-1, 1};
  const RationalFunction f(s, pow(s, 4) + Polynomial{2});
  CHECK(definite_integral(f, rational(0), rational(2), principal).value.exact() == Rational(0));
  CHECK(definite_integral(f, minus_infinity, infinity).value.exact() == Rational(0));
  const Endpoint low = real_root({-1, -2, 1}, {std::nullopt, Rational(0)});  // 1 ∓ √2
  const Endpoint high = real_root({-1, -2, 1}, {Rational(0), std::nullopt});
  CHECK(definite_integral({{1}, s}, low, high, principal).value.exact() == Rational(0));
  CHECK(definite_integral(f, low, high).value.exact() == Rational(0));
  CHECK_FALSE(definite_integral(f, low, rational(2)).value.exact().has_value());
}

TEST_CASE("definite integral: logarithms with fractional factors cancel: log 2 − ½·log 4") {
  const RationalFunction f =
      RationalFunction({1}, {0, 1}) - RationalFunction({1}, {Rational(-4, 3), 2});
  CHECK(definite_integral(f, rational(1), rational(2)).value.exact() == Rational(0));
  CHECK_FALSE(definite_integral(f, rational(1), rational(3)).value.exact().has_value());
}

TEST_CASE("definite integral: a constant of integration does not matter") {
  Antiderivative F = integrate({{1}, {1, 0, 1}});
  F.polynomial = {5};
  CHECK(definite_integral(F, rational(0), infinity).exact == ExactValue{0, Rational(1, 2), {}, {}});
  CHECK(definite_integral(F, rational(0), rational(1)).exact ==
        ExactValue{0, Rational(1, 4), {}, {}});
  CHECK(round_to_decimal(definite_integral(F, root_of(3), infinity).value, 20).value ==
        "0.52359877559829887308");  // π/6
}

TEST_CASE("definite integral: principal values") {
  const auto principal = AtPoles::principal_value;
  // ∫ dt/t from −1 to 2 is log 2; over the line dt/(t² − 1) is 0 and t dt/(1 + t²) is 0.
  CHECK(definite_integral({{1}, {0, 1}}, rational(-1), rational(2), principal).exact ==
        ExactValue{0, 0, {{1, 2}}, {}});
  CHECK(definite_integral({{1}, {-1, 0, 1}}, minus_infinity, infinity, principal).value.exact() ==
        Rational(0));
  CHECK(definite_integral({{1, 1}, {1, 0, 1}}, minus_infinity, infinity, principal).exact ==
        ExactValue{0, 1, {}, {}});
  CHECK_THROWS_WITH_AS(definite_integral({{1}, {0, 0, 1}}, rational(-1), rational(1), principal),
                       doctest::Contains("pole of order 2 at 0"), DomainError);
  CHECK_THROWS_WITH_AS(definite_integral({{1}, {0, 1}}, rational(0), rational(1), principal),
                       doctest::Contains("pole at an end"), DomainError);
  CHECK_THROWS_AS(definite_integral({{1}, {0, 1}}, rational(1), infinity, principal), DomainError);
}

// The integral from −R to R of Σ pₖtᵏ + c/t + O(t⁻²): only even k contribute without bound.
TEST_CASE("definite integral: the symmetric limit exists where the even powers are absent") {
  const auto principal = AtPoles::principal_value;
  CHECK(definite_integral({{0, 1}, {1}}, minus_infinity, infinity, principal).value.exact() ==
        Rational(0));
  // t³ − 2t + 1/(t² + 1), and from ∞ to −∞.
  const RationalFunction f({1, -2, 0, -1, 0, 1}, {1, 0, 1});
  CHECK(definite_integral(f, minus_infinity, infinity, principal).exact ==
        ExactValue{0, 1, {}, {}});
  CHECK(definite_integral(f, infinity, minus_infinity, principal).exact ==
        ExactValue{0, -1, {}, {}});
  CHECK_THROWS_AS(definite_integral(f, minus_infinity, infinity), DomainError);
  CHECK_THROWS_AS(definite_integral(f, rational(0), infinity, principal), DomainError);
  // Odd about 1, but from −R to R it is about −2R.
  CHECK_THROWS_WITH_AS(definite_integral({{-1, 1}, {1}}, minus_infinity, infinity, principal),
                       doctest::Contains("it diverges, as the integral from -R to R is about -2·R"),
                       DomainError);
  CHECK_THROWS_WITH_AS(definite_integral({{1, 0, 1}, {1}}, minus_infinity, infinity, principal),
                       doctest::Contains("about 2/3·R^3"), DomainError);
}

TEST_CASE("definite integral: logarithms at algebraic ends that cancel are seen to") {
  // t⁵ − t + 3 = 31/10 at both ends.
  const Polynomial ends{-1, -10, 0, 0, 0, 10};
  const RationalFunction f({-1, 0, 0, 0, 5}, {3, -1, 0, 0, 0, 1});
  const Endpoint low = real_root(ends, closed_interval(Rational(-1, 2), Rational(1, 2)));
  const Endpoint high = real_root(ends, closed_interval(Rational(1, 2), Rational(3, 2)));
  CHECK(definite_integral(f, low, high).value.exact() == Rational(0));
  CHECK_FALSE(definite_integral(f, low, rational(2)).value.exact().has_value());
  // t³ − t − 1 is 1 at the end and −1 at 0.
  const Endpoint end = real_root({-2, -1, 0, 1}, closed_interval(1, 2));
  CHECK(definite_integral({{-1, 0, 3}, {-1, -1, 0, 1}}, end, rational(0), AtPoles::principal_value)
            .value.exact() == Rational(0));
  // ∫ 3/t − 2/(t − 1) is log|t³/(t − 1)²|, log 8 at 2. t³ = 8(t − 1)² also at 3 + √5, and
  // t³ = −8(t − 1)² where t³ + 8t² − 16t + 8 = 0, at a t < 0.
  const RationalFunction g({-3, 1}, {0, -1, 1});
  const Endpoint same = real_root({4, -6, 1}, closed_interval(5, 6));
  CHECK(definite_integral(g, rational(2), same).value.exact() == Rational(0));
  const Endpoint opposite = real_root({8, -16, 8, 1}, {std::nullopt, Rational(0)});
  CHECK(definite_integral(g, opposite, rational(2), AtPoles::principal_value).value.exact() ==
        Rational(0));
  // Half as much: exponents are not whole.
  const RationalFunction half({Rational(-3, 2), Rational(1, 2)}, {0, -1, 1});
  CHECK(definite_integral(half, rational(2), same).value.exact() == Rational(0));
  // log|t² − 1| from 0 to √2: |1| and |−1|.
  CHECK(definite_integral({{0, 2}, {-1, 0, 1}}, rational(0), root_of(2), AtPoles::principal_value)
            .value.exact() == Rational(0));
}

TEST_CASE("definite integral: rational multiples of π between algebraic ends") {
  const RationalFunction f({1}, {1, 0, 1});
  CHECK(definite_integral(f, rational(0), root_of(3)).exact ==
        ExactValue{0, Rational(1, 3), {}, {}});
  CHECK(definite_integral(f, root_of(3), infinity).exact == ExactValue{0, Rational(1, 6), {}, {}});
  CHECK(definite_integral(f, minus_infinity, root_of(3)).exact ==
        ExactValue{0, Rational(5, 6), {}, {}});
  // tan(π/8) = √2 − 1.
  const Endpoint eighth = real_root({-1, 2, 1}, {Rational(0), std::nullopt});
  CHECK(definite_integral(f, rational(0), eighth).exact == ExactValue{0, Rational(1, 8), {}, {}});
  CHECK_FALSE(definite_integral(f, rational(0), root_of(2)).exact.has_value());
  // 2t + 1/(1 + t²): 3 + π/3.
  CHECK(definite_integral({{1, 2, 0, 2}, {1, 0, 1}}, rational(0), root_of(3)).exact ==
        ExactValue{3, Rational(1, 3), {}, {}});
}

TEST_CASE("definite integral: multiples of π by an algebraic number") {
  const auto multiple = [](const RationalFunction& f, const Endpoint& a, const Endpoint& b) {
    const auto integral = definite_integral(f, a, b);
    REQUIRE(integral.exact.has_value());
    REQUIRE(integral.exact->irrational_pi.has_value());
    return *integral.exact->irrational_pi;
  };
  // Over the line π/√2, over half of it half as much, also where it is even about another point.
  const RationalFunction f({1}, {1, 0, 0, 0, 1});
  const RealAlgebraic half_root = real_root({-1, 0, 2}, closed_interval(0, 1));
  CHECK(multiple(f, minus_infinity, infinity) == half_root);
  CHECK(multiple(f, infinity, rational(0)) == real_root({-1, 0, 8}, closed_interval(-1, 0)));
  const Polynomial s{-2, 1};
  CHECK(multiple({{1}, Polynomial{1} + pow(s, 4)}, rational(2), infinity) ==
        real_root({-1, 0, 8}, closed_interval(0, 1)));
  // −2(1 − t²)/(1 + t⁴) is 0 over the line: t → 1/t changes its sign.
  CHECK(definite_integral({{-2, 0, 2}, {1, 0, 0, 0, 1}}, minus_infinity, infinity).value.exact() ==
        Rational(0));
  // ω = e^{2πi/3}: from 0 to 1 t − ω turns by 30°, π/(3√3).
  CHECK(multiple({{1}, {1, 1, 1}}, rational(0), rational(1)) ==
        real_root({-1, 0, 27}, closed_interval(0, 1)));
  // A generic denominator of degree 4, neither even nor cyclotomic: the value mpmath.quad gives.
  CHECK(digits(definite_integral({{1}, {1, 1, 0, 0, 1}}, minus_infinity, infinity), 17) ==
        "2.6835482442564765");
  CHECK(multiple({{1}, {1, 1, 0, 0, 1}}, minus_infinity, infinity).polynomial().degree() == 6);
  // The generic Galois group of degree 8: nothing is recognised, but the value is known.
  CHECK_FALSE(definite_integral({{1}, {3, 1, 0, 0, 0, 0, 0, 0, 1}}, minus_infinity, infinity)
                  .exact.has_value());
}

TEST_CASE("definite integral: an algebraic and an infinite end") {
  // ∫ t⁻² from √2 is 1/√2; ∫ t/(t² + 1)² from √2 is 1/(2·3), rational; from −∞ the same negative.
  CHECK(digits(definite_integral({{1}, {0, 0, 1}}, root_of(2), infinity), 30) ==
        "0.707106781186547524400844362105");
  const RationalFunction f({0, 1}, pow(Polynomial{1, 0, 1}, 2));
  CHECK(definite_integral(f, root_of(2), infinity).value.exact() == Rational(1, 6));
  CHECK(definite_integral(f, minus_infinity, root_of(2)).value.exact() == Rational(-1, 6));
  // ∫ dt/(t² + 1) from √3 is π/6.
  CHECK(digits(definite_integral({{1}, {1, 0, 1}}, root_of(3), infinity), 30) ==
        "0.523598775598298873077107230547");
}

TEST_CASE("definite integral: ends that are algebraic numbers") {
  // ∫ 2t from 0 to √2 is 2; ∫ 1 from −√2 to 1 − √2 is 1; t³ is odd; ∫ 1 from 0 to √2.
  CHECK(definite_integral({{0, 2}, {1}}, rational(0), root_of(2)).value.exact() == Rational(2));
  const Endpoint minus = real_root({-2, 0, 1}, {std::nullopt, Rational(0)});
  const Endpoint shifted = real_root({-1, -2, 1}, {std::nullopt, Rational(0)});
  CHECK(definite_integral({{1}, {1}}, minus, shifted).value.exact() == Rational(1));
  CHECK(definite_integral({{0, 0, 0, 1}, {1, 0, 0, 0, 1}}, minus, root_of(2)).value.exact() ==
        Rational(0));
  CHECK(digits(definite_integral({{1}, {1}}, rational(0), root_of(2)), 30) ==
        "1.41421356237309504880168872421");
  // ∫ dt/(1 + t²) from 0 to √3 is π/3.
  CHECK(digits(definite_integral({{1}, {1, 0, 1}}, rational(0), root_of(3)), 30) ==
        "1.04719755119659774615421446109");
}

TEST_CASE(
    "definite integral: law: the exact value is in every enclosure, and Arb's quadrature too") {
  for_samples(60, [](Random& random) {
    // Residues in ℚ(i): linear factors and (t − a)² + b².
    RationalFunction f(random.polynomial(2), pow(Polynomial{random.integer(1, 5), 0, 1}, 2));
    if (random.chance(2)) f = {};
    for (long k = random.integer(1, 3); k > 0; --k) {
      const Rational a = random.rational();
      const Rational b = random.integer(0, 3);
      f = f + (b == 0 ? RationalFunction({random.rational()}, {-a, 1})
                      : RationalFunction({random.rational(), random.rational()},
                                         {a * a + b * b, -2 * a, 1}));
    }
    const auto end = [&]() -> Endpoint {
      if (random.chance(5)) return random.chance(2) ? infinity : minus_infinity;
      if (random.chance(5)) return root_of(random.chance(2) ? 2 : 7);
      return random.rational();
    };
    const Endpoint a = end();
    const Endpoint b = end();
    const auto at_poles = random.chance(2) ? AtPoles::refuse : AtPoles::principal_value;
    const bool is_algebraic = a.index() == 1 || b.index() == 1;
    std::optional<DefiniteIntegral> integral;
    try {
      integral = definite_integral(f, a, b, at_poles);
    } catch (const DomainError&) {
      CHECK((is_algebraic || !exists(f, a, b, at_poles)));
      return;
    }
    CHECK((is_algebraic || exists(f, a, b, at_poles)));
    const RealBall enclosure = integral->value.enclose(150);
    CHECK(enclosure.is_accurate(140));
    if (integral->exact) CHECK(value(*integral->exact, 200).overlaps(enclosure));
    const auto* x = std::get_if<Rational>(&a);
    const auto* y = std::get_if<Rational>(&b);
    if (x != nullptr && y != nullptr &&
        count_real_roots(f.denominator(), closed_interval(std::min(*x, *y), std::max(*x, *y))) == 0)
      CHECK(enclosure.overlaps(quadrature(f, *x, *y, 60)));
  });
}

// In exact forms there are logarithms, arctangents and algebraic multiples of π, from poles in
// ℚ(i), on circles about 0 or about another point, and of even functions.
TEST_CASE(
    "definite integral: law: the exact form of small functions meets the ball and quadrature") {
  long forms = 0;
  long multiples = 0;
  for_samples(100, [&](Random& random) {
    const auto factor = [&]() -> Polynomial {
      const long c = random.integer(1, 5);
      switch (random.integer(0, 4)) {
        case 0:  // of degree 4, even
          return {c, 0, random.integer(0, 3), 0, 1};
        case 1:  // all roots on a circle about 0
          return Polynomial::monomial(1, 2 * random.integer(1, 3)) + Polynomial{c};
        case 2:  // cyclotomic, of 3, 5 or 12
          return random.chance(2)   ? Polynomial{1, 1, 1}
                 : random.chance(2) ? Polynomial{1, 1, 1, 1, 1}
                                    : Polynomial{1, 0, -1, 0, 1};
        case 3: {  // about another point
          const Polynomial s{random.integer(-2, 2), 1};
          return pow(s, 4) + Polynomial{c};
        }
        default: {  // (t − a)² + b²
          const Rational a = random.integer(-3, 3);
          return {a * a + c * c, -2 * a, 1};
        }
      }
    };
    Polynomial d = factor();
    if (random.chance(3)) d *= factor();
    const RationalFunction f(random.polynomial(d.degree() - 2), d);
    if (f.is_zero()) return;
    const auto end = [&]() -> Endpoint {
      if (random.chance(2)) return random.chance(2) ? infinity : minus_infinity;
      return random.chance(2) ? Rational(random.integer(-2, 2)) : random.rational();
    };
    const Endpoint a = end();
    const Endpoint b = end();
    if (a == b) return;
    CAPTURE(to_string(f.numerator()));
    CAPTURE(to_string(f.denominator()));
    const DefiniteIntegral integral = definite_integral(f, a, b);
    const RealBall ball = integral.value.enclose(120);
    CHECK(ball.overlaps(by_quadrature(f, a, b, 60)));
    if (!integral.exact) return;
    ++forms;
    multiples += integral.exact->irrational_pi ? 1 : 0;
    const RealBall form = value(*integral.exact, 160);
    CHECK(form.is_accurate(100));
    CHECK(form.overlaps(ball));
    CHECK(form.overlaps(by_quadrature(f, a, b, 60)));
  });
  CHECK(forms > 20);
  CHECK(multiples > 7);
}

TEST_CASE("definite integral: law: t → 1/t and t → (at + b)/(ct + d) leave it alone") {
  for_samples(40, [](Random& random) {
    Polynomial d{1};
    for (long k = random.integer(1, 3); k > 0; --k)
      d *= Polynomial{random.integer(2, 9), random.integer(-2, 2), 1};  // no real zero
    const Polynomial n = random.polynomial(std::max(0L, d.degree() - 2));
    const RationalFunction f(n, d);
    if (f.denominator().degree() - f.numerator().degree() < 2) return;
    // ∫ from s to ∞ of f(t) dt = ∫ from 0 to 1/s of f(1/t)/t² dt, s > 0.
    const Rational s = abs(random.rational()) + 1;
    const auto reversed = [](const Polynomial& p, long length) {
      Polynomial result;
      for (long k = 0; k <= p.degree(); ++k)
        result += Polynomial::monomial(p.coefficient(k), length - k);
      return result;
    };
    const long length = f.denominator().degree();
    const RationalFunction g(reversed(f.numerator(), length),
                             Polynomial::monomial(1, 2) * reversed(f.denominator(), length));
    const RealBall tail = definite_integral(f, s, infinity).value.enclose(120);
    CHECK(tail.overlaps(definite_integral(g, rational(0), Rational(1 / s)).value.enclose(120)));
    // t = (2u + 1)/(u + 1) from u = 0 to u: dt = du/(u + 1)².
    const Rational u = abs(random.rational());
    const Polynomial top{1, 2};
    const Polynomial bottom{1, 1};
    const auto homogeneous = [&](const Polynomial& p) {
      Polynomial result;
      for (long k = 0; k <= p.degree(); ++k)
        result += p.coefficient(k) * (pow(top, k) * pow(bottom, length - k));
      return result;
    };
    const RationalFunction h(homogeneous(f.numerator()),
                             homogeneous(f.denominator()) * pow(bottom, 2));
    CHECK(definite_integral(h, rational(0), u)
              .value.enclose(120)
              .overlaps(definite_integral(f, rational(1), Rational(top(u) / bottom(u)))
                            .value.enclose(120)));
  });
}

TEST_CASE("definite integral: what integrate() has found of poles is no other value") {
  for_samples(30, [](Random& random) {
    const Polynomial p = random.polynomial(2);
    const Polynomial q = random.polynomial(2);
    // Positive; the factors of q² + 2 are those of multiple poles.
    const Polynomial d = (p * p + Polynomial{1}) * pow(q * q + Polynomial{2}, 2);
    const RationalFunction f(random.nonzero_polynomial(4), d);
    const FactoredIntegral of = factored_integral(f);
    CHECK(of.F == integrate(f));
    if (!of.parts.empty()) CHECK(of.parts.size() == of.F.logs.size());
    const DefiniteIntegral known = definite_integral(of, f, rational(0), rational(1), true);
    CHECK(known.value.enclose(80).overlaps(quadrature(f, 0, 1, 80)));
    const DefiniteIntegral found =
        definite_integral(of.F, f, rational(0), rational(1), AtPoles::refuse);
    CHECK(known.exact.has_value() == found.exact.has_value());
    CHECK(round_to_decimal(known.value, 30).value == round_to_decimal(found.value, 30).value);
  });
}
