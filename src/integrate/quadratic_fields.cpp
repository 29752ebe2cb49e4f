// An irreducible quartic is, with t = y + s, a multiple of
//   y⁴ + Py² + Qy + R = (y² + Ey + F)(y² − Ey + G),
//   F + G − E² = P,  E(G − F) = Q,  FG = R,
// and w = E² is a root of w³ + 2Pw² + (P² − 4R)w − Q² (Descartes). Over a real quadratic field its
// two factors are conjugate, for their product is rational and they are not. So either E = e√D,
// and w = e²D > 0 is rational, or E = 0, Q = 0 and F, G = (P ± √(P² − 4R))/2 are real. Conversely,
// every rational w > 0 gives a factorization, with F = (P + w)/2 − Q/(2E).
//
// An octic f with the roots c + βᵢ has the quadratic factors
//   (t − c)² − (βᵢ + βⱼ)(t − c) + βᵢβⱼ.
// Let c be such that the 28 products are distinct, as they are for all but finitely many: then
//   M(y) = ∏_{i<j} (y − βᵢβⱼ),  S(y) = Σ_{i<j} (βᵢ + βⱼ)·M(y)/(y − βᵢβⱼ)
// are rational, βᵢ + βⱼ = S(r)/M′(r) for r = βᵢβⱼ, and the coefficients of a factor generate ℚ(r).
// So the factors over biquadratic fields are those of the roots r of the irreducible factors of
// degree 4 of M which lie in such a field; their product over the four conjugates is f, as f is
// irreducible. From the power sums sₖ of the βᵢ,
//   Σ_{i<j} (βᵢβⱼ)ᵏ = (sₖ² − s₂ₖ)/2,  Σ_{i<j} (βᵢ + βⱼ)(βᵢβⱼ)ᵏ = sₖ₊₁sₖ − s₂ₖ₊₁.
// Modulo a prime that does not divide its discriminant f has irreducible factors as long as the
// cycles of an automorphism (Dedekind). That leaves each of the four pairs of roots where it is, or
// exchanges them two by two: its cycles have the lengths 1 and 2 only, or 2 and 4 only. Of all
// permutations of eight roots one in twelve is such, so that few primes exclude nearly every octic.
#include "phrame/integrate/quadratic_fields.hpp"

#include <algorithm>

#include "phrame/algebra/bivariate.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/modular.hpp"
#include "phrame/algebra/power_series.hpp"
#include "phrame/algebra/surd_root.hpp"

namespace phrame::inline v0 {
namespace {

/// t² + pt + q.
struct Quadratic {
  Surd p;
  Surd q;
};

/// (t − s)² + E(t − s) + F.
Quadratic shifted(const Surd& E, const Surd& F, const Rational& s) {
  return {E - Surd(2 * s), Surd(s * s) - s * E + F};
}

/// One of two conjugate factors over each real quadratic field.
std::vector<Quadratic> factors_of_quartic(const Polynomial& quartic) {
  const Rational lead = quartic.leading_coefficient();
  const Rational s = -quartic.coefficient(3) / (4 * lead);
  const Polynomial f = (1 / lead) * compose(quartic, {s, 1});
  const Rational P = f.coefficient(2);
  const Rational Q = f.coefficient(1);
  const Rational R = f.coefficient(0);
  const auto root = [](const Polynomial& p) {
    const auto [a, b, d] = quadratic_root(p);
    return Surd(a, b, d);
  };
  std::vector<Quadratic> found;
  for (const auto& [base, exponent] : factor({-Q * Q, P * P - 4 * R, 2 * P, 1}).factors) {
    if (base.degree() != 1) continue;
    const Rational w = -base.coefficient(0) / base.coefficient(1);
    if (w <= 0) continue;
    const Surd E = root({-w, 0, 1});  // and 1/E = E/w
    found.push_back(shifted(E, Surd((P + w) / 2) - Q / (2 * w) * E, s));
  }
  if (Q == 0 && P * P > 4 * R) found.push_back(shifted({}, root({R, -P, 1}), s));
  return found;
}

/// The square of half the difference of its zeros.
Surd quarter_discriminant(const Quadratic& g) { return Rational(1, 4) * (g.p * g.p) - g.q; }

/// A root of an irreducible quartic that is a sum of real square roots; no value where none is.
std::optional<Surd> biquadratic_root(const Polynomial& quartic) {
  for (const Quadratic& g : factors_of_quartic(quartic)) {
    const Surd h = quarter_discriminant(g);
    if (sign(h) < 0) continue;
    if (const auto root = simple_root(h)) return *root - Rational(1, 2) * g.p;
  }
  return std::nullopt;
}

/// May f be a product of four conjugate quadratic polynomials over a biquadratic field, by the
/// degrees of its factors modulo some primes?
bool may_be_biquadratic(const Polynomial& f) {
  constexpr int tries = 8;
  const IntegerPolynomial integral = integer_primitive_part(f);
  Primes primes;
  for (int k = 0; k < tries; ++k) {
    const ModularPolynomial modular(primes.next(), integral);
    std::vector<long> of_degree(static_cast<std::size_t>(f.degree()) + 1);
    bool is_good = modular.degree() == f.degree();
    for (const auto& [degree, exponent] : shapes_of_factors(modular)) {
      ++of_degree[static_cast<std::size_t>(degree)];
      is_good = is_good && exponent == 1;
    }
    const long short_cycles = of_degree[1] + 2 * of_degree[2];
    const long even_cycles = 2 * of_degree[2] + 4 * of_degree[4];
    if (is_good && short_cycles != f.degree() && even_cycles != f.degree()) return false;
  }
  return true;
}

/// M and S.
struct PairResolvent {
  Polynomial products;
  Polynomial sums;
};

PairResolvent pair_resolvent(const Polynomial& f) {
  const long pairs = f.degree() * (f.degree() - 1) / 2;
  const Polynomial s = power_sums_of_roots(f, 2 * pairs + 1);  // s₀ + s₁y + …
  std::vector<Rational> of_products;
  std::vector<Rational> of_sums;  // Σ (βᵢ + βⱼ)/(y − βᵢβⱼ) is Σ of_sums[k]·y^{−k−1}
  for (long k = 0; k <= pairs; ++k)
    of_products.push_back((s.coefficient(k) * s.coefficient(k) - s.coefficient(2 * k)) / 2);
  for (long k = 0; k < pairs; ++k)
    of_sums.push_back(s.coefficient(k + 1) * s.coefficient(k) - s.coefficient(2 * k + 1));
  PairResolvent result{with_power_sums(of_products), {}};
  // The part of M(y)·Σ of_sums[k]·y^{−k−1} without negative powers.
  std::reverse(of_sums.begin(), of_sums.end());
  result.sums =
      divide(result.products * Polynomial(of_sums), Polynomial::monomial(1, pairs)).quotient;
  return result;
}

/// One of four conjugate factors over each real biquadratic field.
std::vector<Quadratic> factors_of_octic(const Polynomial& octic) {
  if (!may_be_biquadratic(octic)) return {};
  Rational c = 0;
  PairResolvent resolvent = pair_resolvent(octic);
  while (!is_squarefree(resolvent.products)) {
    c += 1;
    resolvent = pair_resolvent(compose(octic, {c, 1}));
  }
  const auto& [M, S] = resolvent;
  std::vector<Quadratic> found;
  for (const auto& [base, exponent] : factor(M).factors) {
    if (base.degree() != 4) continue;
    const auto r = biquadratic_root(base);
    if (!r) continue;
    const QuotientRing ring(base);
    const Polynomial sum = ring.divide(ring.reduce(S), ring.reduce(differentiate(M)));
    found.push_back(shifted(-evaluate(sum, *r), *r, c));
  }
  return found;
}

/// How hard its zeros are to write: √ of a rational number, a sum of such, a root of a root.
int complexity(const Quadratic& g) {
  const Surd h = quarter_discriminant(g);
  return h.is_rational() ? 0 : simple_root(sign(h) > 0 ? h : -h) ? 1 : 2;
}

/// ut + v modulo a quadratic polynomial.
struct Linear {
  Surd u;
  Surd v;
};

Linear multiply(const Linear& x, const Linear& y, const Quadratic& g) {
  const Surd square = x.u * y.u;  // t² = −pt − q
  return {x.u * y.v + x.v * y.u - square * g.p, x.v * y.v - square * g.q};
}

Linear remainder(const Polynomial& p, const Quadratic& g) {
  Linear value;
  for (long k = p.degree(); k >= 0; --k) {
    value = multiply(value, {Rational(1), {}}, g);
    value.v.add(p.coefficient(k), 1);
  }
  return value;
}

/// The other zero of g is −p − t.
Linear inverse(const Linear& x, const Quadratic& g) {
  const Linear other{-x.u, x.v - x.u * g.p};
  const Surd norm = multiply(x, other, g).v;
  return {other.u / norm, other.v / norm};
}

/// Pairs as t² ± pt + q one after the other: from the greatest distance of p from the mean to the
/// least, and p above the mean first.
void sort_by_place(std::vector<QuadraticFraction>& conjugates) {
  const Surd mean = conjugates.front().p.rational_part();
  const auto comes_before = [&](const QuadraticFraction& f, const QuadraticFraction& g) {
    const Surd x = f.p - mean;
    const Surd y = g.p - mean;
    const int farther = sign(x * x - y * y);
    return farther != 0 ? farther > 0 : sign(x - y) > 0;
  };
  std::stable_sort(conjugates.begin(), conjugates.end(), comes_before);
}

}  // namespace

// For d = lead·g·h and n/d = (αt + β)/g + …: αt + β = n/(lead·h) modulo g, where d′ = lead·g′h.
std::vector<QuadraticFraction> over_real_quadratic_fields(const SimpleFraction& f) {
  const Polynomial& d = f.denominator;
  if (d.degree() != 4 && d.degree() != 8) return {};
  const std::vector<Quadratic> factors =
      d.degree() == 4 ? factors_of_quartic(d) : factors_of_octic(d);
  const auto simplest =
      std::min_element(factors.begin(), factors.end(),
                       [](const auto& g, const auto& h) { return complexity(g) < complexity(h); });
  if (simplest == factors.end()) return {};
  const Quadratic& g = *simplest;
  const Linear numerator = multiply(multiply(remainder(f.numerator, g), {Surd(2), g.p}, g),
                                    inverse(remainder(differentiate(d), g), g), g);
  std::vector<QuadraticFraction> conjugates{{numerator.u, numerator.v, g.p, g.q}};
  RootField field = field_of(g.p);
  for (const auto& [radicand, coefficient] : g.q.terms()) field.adjoin(radicand);
  for (const RootField& fixed : fields_without_a_root(field)) {
    const std::size_t count = conjugates.size();
    for (std::size_t k = 0; k < count; ++k) {
      const auto [alpha, beta, p, q] = conjugates[k];
      conjugates.push_back({conjugate(alpha, fixed), conjugate(beta, fixed), conjugate(p, fixed),
                            conjugate(q, fixed)});
    }
  }
  sort_by_place(conjugates);
  return conjugates;
}

}  // namespace phrame
