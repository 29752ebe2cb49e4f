#include "phrame/algebra/radical_roots.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/sturm.hpp"

// The cubic t³ + c₂t² + c₁t + c₀ [(A.5) – (A.7)]. With t = y − c₂/3 it is y³ + 3Qy − 2R, and with
// Δ = Q³ + R² the numbers S = ∛(R + √Δ), any cube root, and T = −Q/S satisfy T³ = R − √Δ; the
// roots are y = S + T, −(S + T)/2 ± i√3(S − T)/2.
//   S = 0 or T = 0 happens only where Q = 0; then −Q/S may have no meaning, but one of the two cube
//   roots is that of 2R and the other one is 0, which is right.
//   Δ > 0: S and T are the real cube roots, written with the signs of R ± √Δ taken out. The
//   product of these two is −Q³, so the signs are decided in ℚ.
//   Δ < 0: R + √Δ lies above the real axis, and the principal cube root of its conjugate R − √Δ is
//   the conjugate of S, |S|² = −Q; so T = ∛(R − √Δ), principal too.
//
// The quartic t⁴ + a₃t³ + a₂t² + a₁t + a₀ [(A.1) – (A.4)]. With t = y − a₃/4 it is
// y⁴ + py² + qy + r. Let w = z − p for a root z of the resolvent cubic (A.2); then E = √w, and
//   w³ + 2pw² + (p² − 4r)w − q² = 0,  F = −q/(2E),
//   y² ± Ey + (w + p)/2 ± F = 0,  y = (∓E + τ√(−w − 2p ± 2q/E))/2,  τ = ±1.
// (The paper prints 4F for 4E in the denominator of F.)
//   E = 0: w = 0 is a root iff q = 0; then either another w is rational, or the quartic is
//   biquadratic, y² = (−p ± √(p² − 4r))/2, which is F = √(z²/4 − r).
//   All w rational (Euler): y = (±√w₁ ± √w₂ ± √w₃)/2 with signs that make the product −q.
//   Otherwise w is the rational one, or the largest real one. The product of the three is q² > 0,
//   so that the latter is > 0, and E > 0. Then the radicands −w − 2p ± 2q/E are real, the greater
//   one is that with the sign of q, and how many of them are > 0 is half the number of real roots.

namespace phrame::inline v0 {
namespace {

Radical times_i(const Radical& x) { return Radical::imaginary_unit() * x; }

/// √x for a real x ≠ 0 whose sign is known.
Radical real_sqrt(const Radical& x, bool positive) {
  return positive ? sqrt(x) : times_i(sqrt(-x));
}

std::vector<Radical> quadratic_roots(const Polynomial& p) {
  const Rational a = p.coefficient(2);
  const Rational b = p.coefficient(1);
  const Radical middle = Rational(-b / (2 * a));
  const Radical half = sqrt(Radical(Rational((b * b - 4 * a * p.coefficient(0)) / (4 * a * a))));
  return {middle - half, middle + half};
}

std::vector<Radical> cubic_roots(const Polynomial& p) {
  const Rational lead = p.leading_coefficient();
  const Rational c2 = p.coefficient(2) / lead;
  const Rational c1 = p.coefficient(1) / lead;
  const Rational c0 = p.coefficient(0) / lead;
  const Rational Q = (3 * c1 - c2 * c2) / 9;
  const Rational R = (9 * c1 * c2 - 27 * c0 - 2 * c2 * c2 * c2) / 54;
  const Rational delta = Q * Q * Q + R * R;
  // Of the two factors of −Q³ that with the sign of R is the greater one, and not 0.
  const int s = delta < 0 || R >= 0 ? 1 : Q.sign();
  const int t = delta < 0 ? 1 : R <= 0 ? -1 : -Q.sign();
  const Radical root = sqrt(Radical(delta));
  const Radical S = Rational(s) * cbrt(Rational(s) * (R + root));
  const Radical T = Rational(t) * cbrt(Rational(t) * (R - root));
  const Radical shift = Rational(-c2 / 3);
  const Radical even = shift - (S + T) / 2;
  const Radical odd = times_i(sqrt(Radical(3))) * (S - T) / 2;
  return {shift + S + T, even + odd, even - odd};
}

/// y⁴ + py² + qy + r, and t = y + shift.
struct Quartic {
  Rational p;
  Rational q;
  Rational r;
  Rational shift;
  long real_roots;
};

Quartic depressed(const Polynomial& f) {
  const Rational shift = -f.coefficient(3) / (4 * f.leading_coefficient());
  const Polynomial g = (1 / f.leading_coefficient()) * compose(f, {shift, 1});
  return {g.coefficient(2), g.coefficient(1), g.coefficient(0), shift,
          count_real_roots(f, real_line())};
}

/// q = 0 and r is no square.
std::vector<Radical> biquadratic_roots(const Quartic& f) {
  const Rational square = f.p * f.p / 4 - f.r;
  const Radical root = sqrt(Radical(square));
  std::vector<Radical> roots;
  for (const int s : {1, -1}) {
    const Radical u = Rational(-f.p / 2) + Rational(s) * root;
    // The greater of two real u is negative iff both are, and p > 0.
    const bool both_of_one_sign = f.r > 0;
    const bool positive = both_of_one_sign ? f.p < 0 : s > 0;
    const Radical y = square < 0 ? sqrt(u) : real_sqrt(u, positive);
    roots.insert(roots.end(), {f.shift + y, f.shift - y});
  }
  return roots;
}

std::vector<Radical> euler_roots(const Quartic& f, const std::vector<Rational>& w) {
  const auto negative = std::count_if(w.begin(), w.end(), [](const Rational& x) { return x < 0; });
  // √w₁·√w₂·√w₃ = |q|, or i²|q|.
  const int product = (f.q > 0 ? -1 : 1) * (negative == 2 ? -1 : 1);
  std::vector<Radical> halves;
  for (const Rational& x : w) halves.push_back(sqrt(Radical(Rational(x / 4))));
  std::vector<Radical> roots;
  for (const int a : {1, -1})
    for (const int b : {1, -1})
      roots.push_back(f.shift + Rational(a) * halves[0] + Rational(b) * halves[1] +
                      Rational(a * b * product) * halves[2]);
  return roots;
}

/// `positive` where w > 0; else w < 0 is rational.
std::vector<Radical> ferrari_roots(const Quartic& f, const Radical& w, bool positive) {
  const Radical E = sqrt(w);
  const Radical ratio = w.rational() ? 2 * f.q / *w.rational() * E : Rational(2 * f.q) / E;
  std::vector<Radical> roots;
  for (const int s : {1, -1}) {
    const Radical radicand = Rational(-2 * f.p) - w + Rational(s) * ratio;
    const bool above = f.real_roots == 4 || (f.real_roots == 2 && s == f.q.sign());
    const Radical half = (positive ? real_sqrt(radicand, above) : sqrt(radicand)) / 2;
    const Radical middle = f.shift - Rational(s, 2) * E;
    roots.insert(roots.end(), {middle + half, middle - half});
  }
  return roots;
}

std::vector<Radical> quartic_roots(const Polynomial& polynomial) {
  const Quartic f = depressed(polynomial);
  const Polynomial resolvent{-f.q * f.q, f.p * f.p - 4 * f.r, 2 * f.p, 1};
  std::vector<Rational> rational;
  for (const auto& [base, exponent] : factor(resolvent).factors)
    if (base.degree() == 1) rational.push_back(-base.coefficient(0) / base.coefficient(1));
  if (rational.size() == 3) return euler_roots(f, rational);
  if (f.q == 0) return biquadratic_roots(f);
  if (rational.size() == 1) return ferrari_roots(f, rational.front(), rational.front() > 0);
  const auto largest = static_cast<std::size_t>(count_real_roots(resolvent, real_line()) - 1);
  return ferrari_roots(f, roots_by_radicals(resolvent)[largest], true);
}

std::vector<Radical> roots_of_irreducible(const Polynomial& p) {
  switch (p.degree()) {
    case 1:
      return {Rational(-p.coefficient(0) / p.coefficient(1))};
    case 2:
      return quadratic_roots(p);
    case 3:
      return cubic_roots(p);
    case 4:
      return quartic_roots(p);
    default:
      throw DomainError("roots_by_radicals: the irreducible factor " +
                        abbreviated(to_string(p), 200) + " has a degree > 4");
  }
}

std::vector<ComplexBall> enclosures(const Roots& roots) {
  std::vector<ComplexBall> all;
  for (const RealBall& x : roots.real) all.emplace_back(x, RealBall());
  all.insert(all.end(), roots.upper.begin(), roots.upper.end());
  for (const ComplexBall& z : roots.upper) all.push_back(conjugate(z));
  return all;
}

/// found[k] is the radical in the k-th enclosure. No value where an enclosure of a radical meets
/// several; throws where it meets none, for then the radical is no root.
std::optional<std::vector<Radical>> matched(const std::vector<Radical>& radicals,
                                            const std::vector<ComplexBall>& enclosures, long bits) {
  std::vector<std::optional<Radical>> found(enclosures.size());
  for (const Radical& x : radicals) {
    const ComplexBall ball = enclose(x, bits);
    const auto meets = [&](const ComplexBall& z) { return z.overlaps(ball); };
    const auto count = std::count_if(enclosures.begin(), enclosures.end(), meets);
    if (count == 0) throw Error("roots_by_radicals: the check failed, a radical is not a root");
    if (count > 1) return std::nullopt;
    const auto place = std::find_if(enclosures.begin(), enclosures.end(), meets);
    auto& slot = found[static_cast<std::size_t>(place - enclosures.begin())];
    if (slot) throw Error("roots_by_radicals: the check failed, two radicals are the same root");
    slot = x;
  }
  std::vector<Radical> roots;
  for (auto& x : found) roots.push_back(std::move(x).value());
  return roots;
}

}  // namespace

std::vector<Radical> roots_by_radicals(const Polynomial& p) {
  long bits = 64;
  Roots roots = isolate_roots(p, bits);
  std::vector<Radical> radicals;
  for (const auto& [base, exponent] : factor(p).factors) {
    const auto of_base = roots_of_irreducible(base);
    radicals.insert(radicals.end(), of_base.begin(), of_base.end());
  }
  constexpr long most_bits = 1 << 20;
  for (; bits <= most_bits; bits *= 2) {
    refine(p, roots, bits);
    if (auto all = matched(radicals, enclosures(roots), bits)) return *all;
  }
  throw Undecided("roots_by_radicals: 2^20 bits do not tell the roots apart");
}

}  // namespace phrame
