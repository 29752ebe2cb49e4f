// For q = at² + bt + c with the discriminant −D, 4a·q = (2at + b)² + D: with X = 2at + bs, Y = 2y a
// point of y² = s²q(t/s) is one of X² = aY² − Ds². Of x² = Ay² + Bz² with integers A and B without
// square factors there is a point over ℚ where there is one over ℝ and each ℚₚ, p odd, (A, B)ₚ = 1:
// for p | A, p ∤ B this says that B is a square modulo p, and for p | A, B that −AB/p² is.
// Lagrange: for w² ≡ A mod B, |w| ≤ |B|/2, w² − A = B·T·m² with |T| < |B|, and (w + √A)(x + y√A)
// has the norm B·(Tmz)² where x² − Ay² = Tz².
#include "phrame/algebra/conic.hpp"

#include "phrame/algebra/integer_factors.hpp"

namespace phrame::inline v0 {
namespace {

/// x = square²·∏ primes, with the sign of x.
struct SquarefreeInteger {
  Integer rest;
  Integer square = 1;
  std::vector<Integer> primes = {};  ///< of `rest`
  bool is_complete = true;           ///< are these all primes?
};

SquarefreeInteger without_squares(const Integer& x) {
  SquarefreeInteger found{x.sign()};
  for (const auto& [base, exponent] : factors(abs(x))) {
    found.is_complete = found.is_complete && is_prime(base);
    found.square *= pow(base, exponent / 2);
    if (exponent % 2 == 0) continue;
    found.rest *= base;
    found.primes.push_back(base);
  }
  return found;
}

bool is_square_modulo(const Integer& x, const Integer& p) {
  return p == 2 || fmpz_jacobi(modulo(x, p).raw(), p.raw()) != -1;
}

/// An odd p with (A, B)ₚ = −1; 0 where there is none.
Integer obstruction(const SquarefreeInteger& a, const SquarefreeInteger& b) {
  for (const auto* one : {&a, &b}) {
    const Integer& other = one == &a ? b.rest : a.rest;
    for (const Integer& p : one->primes) {
      if (p == 2) continue;
      const Integer unit = other % p == 0 ? -(one->rest / p) * (other / p) : other;
      if (!is_square_modulo(unit, p)) return p;
    }
  }
  return 0;
}

using Triple = std::array<Integer, 3>;

/// w with w² ≡ a mod ∏ primes, |w| ≤ half of that.
Integer root_modulo(const Integer& a, const SquarefreeInteger& b) {
  Integer modulus = 1;
  Integer w = 0;
  for (const Integer& p : b.primes) {
    Integer root = modulo(a, p);
    if (p > 2) fmpz_sqrtmod(root.raw(), modulo(a, p).raw(), p.raw());
    w += modulus * modulo((root - w) * *inverse_modulo(modulo(modulus, p), p), p);
    modulus *= p;
  }
  w = modulo(w, modulus);
  return 2 * w > modulus ? w - modulus : w;
}

/// A point of x² = ay² + bz², which has one; no value where a number is too large to factor.
std::optional<Triple> descent(const SquarefreeInteger& a, const SquarefreeInteger& b) {
  if (a.rest == 1) return Triple{1, 1, 0};
  if (b.rest == 1) return Triple{1, 0, 1};
  if (abs(a.rest) > abs(b.rest)) {
    auto found = descent(b, a);
    if (found) std::swap((*found)[1], (*found)[2]);
    return found;
  }
  const Integer w = root_modulo(a.rest, b);
  const SquarefreeInteger t = without_squares((w * w - a.rest) / b.rest);
  if (!t.is_complete) return std::nullopt;
  const auto found = descent(a, t);
  if (!found) return std::nullopt;
  const auto& [x, y, z] = *found;
  return Triple{w * x + a.rest * y, x + w * y, t.rest * t.square * z};
}

Integer numerator_times_denominator(const Rational& x) { return numerator(x) * denominator(x); }

}  // namespace

Integer squarefree_rest(const Integer& x) { return without_squares(x).rest; }

ConicParameters conic_parameters(const Polynomial& q) {
  const Rational a = q.coefficient(2);
  const Rational b = q.coefficient(1);
  const Rational c = q.coefficient(0);
  const Rational gap = 4 * a * c - b * b;
  ConicParameters found{{}, {}, 0, 1};
  std::optional<std::array<Rational, 3>> point;  // (t, y, s)
  if (const auto root = square_root(a)) {
    point = {1, *root, 0};
  } else if (const auto at_zero = square_root(c)) {
    point = {0, *at_zero, 1};
  } else {
    const SquarefreeInteger first = without_squares(numerator_times_denominator(a));
    const SquarefreeInteger second = without_squares(-numerator_times_denominator(gap));
    found.radicand = first.rest;
    if (!first.is_complete || !second.is_complete) return found;
    found.prime = obstruction(first, second);
    if (found.prime != 0) return found;
    const auto solution = descent(first, second);
    if (!solution) return found;
    // a = first·(first.square/denominator)², and so is the discriminant.
    const Rational x = (*solution)[0];
    const Rational y = Rational((*solution)[1]) * Rational(denominator(a), first.square) / 2;
    const Rational s = Rational((*solution)[2]) * Rational(denominator(gap), second.square);
    point = {(x - b * s) / (2 * a), y, s};
  }
  found.radicand = 1;
  const auto& [t, at, s] = *point;
  if (s == 0) {
    // y = (y/t)·t + m
    const Rational root = at / t;
    const RationalFunction of_m(Polynomial{c, 0, -1}, Polynomial{-b, 2 * root});
    found.form = {of_m,
                  RationalFunction(Polynomial{root}) * of_m + RationalFunction(Polynomial{0, 1})};
    return found;
  }
  return conic_through(q, t / s, at / s);
}

ConicParameters conic_through(const Polynomial& q, const Rational& t, const Rational& y) {
  // y + m(T − t) at T
  const RationalFunction step(Polynomial{differentiate(q)(t), -2 * y},
                              Polynomial{-q.coefficient(2), 0, 1});
  return {{{RationalFunction(Polynomial{t}) + step,
            RationalFunction(Polynomial{y}) + RationalFunction(Polynomial{0, 1}) * step}},
          {{t, y}},
          0,
          1};
}

}  // namespace phrame
