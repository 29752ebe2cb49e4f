// f = N/D with D = ∏ pₖ^nₖ is (A/P)′ + B/S with S = ∏ pₖ squarefree, P = D/S and deg A < deg P
// [Horowitz 1971]. So A′·S − A·E + B·P = N with E = S·P′/P = Σ (nₖ − 1)·pₖ′·S/pₖ, and A alone is
// what solves A′·S − A·E ≡ N modulo P. There is one: where the left side is 0 modulo P for A ≠ 0,
// (A/P)′ is Q/S with simple poles only, which no derivative has.
#include "phrame/integrate/rational_change.hpp"

#include "phrame/algebra/linear_system.hpp"

namespace phrame::inline v0 {
namespace {

using Coefficients = std::vector<RealBall>;

/// Modulo a polynomial of degree n ≥ 1.
class Remainders {
 public:
  Remainders(const Polynomial& modulus, long bits) : bits_(bits) {
    const Rational leading = modulus.leading_coefficient();
    for (long k = 0; k < modulus.degree(); ++k)
      tail_.emplace_back(modulus.coefficient(k) / leading, bits);
  }

  Coefficients of(const Polynomial& p) const {
    Coefficients remainder(tail_.size());
    for (long k = p.degree(); k >= 0; --k) {
      remainder = times_t(remainder);
      remainder[0] = add(remainder[0], RealBall(p.coefficient(k), bits_), bits_);
    }
    return remainder;
  }

  Coefficients times_t(const Coefficients& p) const {
    const RealBall minus_leading = subtract(RealBall(), p.back(), bits_);
    Coefficients result;
    for (std::size_t k = 0; k < p.size(); ++k)
      result.push_back(add_product(k == 0 ? RealBall() : p[k - 1], minus_leading, tail_[k], bits_));
    return result;
  }

 private:
  long bits_;
  Coefficients tail_;  ///< of the monic modulus, but for tⁿ
};

/// (A/P)(1) − (A/P)(0).
RealBall change(const Coefficients& a, const Polynomial& p, long bits) {
  RealBall sum;
  for (const RealBall& x : a) sum = add(sum, x, bits);
  return subtract(divide(sum, RealBall(p(1), bits), bits), divide(a[0], RealBall(p(0), bits), bits),
                  bits);
}

/// (A/P)(1) − (A/P)(0) for A′·S − A·E ≡ N modulo P. No value where the equations for A are not seen
/// to be regular with so many bits.
std::optional<RealBall> change(const Polynomial& P, const Polynomial& S, const Polynomial& E,
                               const Polynomial& N, long bits) {
  const Remainders modulo(P, bits);
  Coefficients s = modulo.of(S);
  Coefficients e = modulo.of(E);
  std::vector<Coefficients> columns;  // of A = 1, t, t², …
  for (long k = 0; k < P.degree(); ++k) {
    Coefficients& column = columns.emplace_back();
    for (std::size_t j = 0; j < e.size(); ++j) {
      const RealBall rate = k == 0 ? RealBall() : multiply(RealBall(k, bits), s[j], bits);
      column.push_back(subtract(rate, e[j], bits));
    }
    if (k > 0) s = modulo.times_t(s);
    e = modulo.times_t(e);
  }
  const auto a = solve(columns, modulo.of(N), bits);
  return a ? std::optional(change(*a, P, bits)) : std::nullopt;
}

}  // namespace

std::optional<RealBall> rational_change(const RationalFunction& f,
                                        const std::vector<PolePower>& denominator, long bits) {
  Polynomial simple{1};    // S
  Polynomial repeated{1};  // P
  Polynomial slope;        // E
  for (const auto& [base, exponent] : denominator) {
    slope = slope * base + Rational(exponent - 1) * differentiate(base) * simple;
    simple *= base;
    repeated *= pow(base, exponent - 1);
  }
  const Polynomial product = simple * repeated;
  const Rational constant = product.leading_coefficient() / f.denominator().leading_coefficient();
  if (!(product == constant * f.denominator()) || !is_squarefree(simple)) return std::nullopt;
  const Division whole = divide(constant * f.numerator(), product);
  const Polynomial polynomial = antiderivative(whole.quotient);
  const RealBall known(polynomial(1) - polynomial(0), bits);
  if (repeated.is_constant()) return known;
  const long limit = 16 * (bits + repeated.degree());
  for (long more = bits + 2 * repeated.degree(); more <= limit; more *= 2)
    if (const auto found = change(repeated, simple, slope, whole.remainder, more);
        found && found->is_accurate(bits))
      return add(known, *found, bits);
  return std::nullopt;
}

}  // namespace phrame
