#include "phrame/algebra/real_algebraic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/roots.hpp"

namespace phrame::inline v0 {
namespace {

std::strong_ordering order(const Rational& x, const Rational& y) {
  return x < y   ? std::strong_ordering::less
         : x > y ? std::strong_ordering::greater
                 : std::strong_ordering::equal;
}

}  // namespace

RealAlgebraic::RealAlgebraic(const Rational& r)
    : polynomial_(primitive_part(Polynomial{-r, 1})), interval_(closed_interval(r, r)) {}

std::optional<Rational> RealAlgebraic::rational() const {
  return is_rational() ? interval_.lower : std::nullopt;
}

RealAlgebraic real_root(const Polynomial& p, const Interval& interval) {
  if (p.is_zero()) throw DomainError("real_root: the zero polynomial vanishes everywhere");
  const std::vector<RealRoot> roots = real_roots(p, interval);
  if (roots.size() != 1)
    throw DomainError(fmt::format("real_root: {} real roots in {}, not one",
                                  roots.empty() ? "no" : std::to_string(roots.size()),
                                  to_string(interval)));
  return roots.front().at;
}

std::vector<RealRoot> real_roots(const Polynomial& p, const Interval& interval) {
  std::vector<RealRoot> found;
  if (count_real_roots(p, interval) == 0) return found;
  // The roots of different irreducible factors are different.
  for (const auto& [base, exponent] : factor(p).factors)
    for (const Interval& root : isolate_real_roots(base, interval))
      found.push_back({base.degree() == 1
                           ? RealAlgebraic(-base.coefficient(0) / base.coefficient(1))
                           : RealAlgebraic(base, root),
                       exponent});
  std::sort(found.begin(), found.end(),
            [](const RealRoot& a, const RealRoot& b) { return compare(a.at, b.at) < 0; });
  return found;
}

/// With the leading coefficient c of p ∈ ℤ[t], c·t is an algebraic integer: a rational one is an
/// integer, and a ball narrower than 1 holds at most two.
std::optional<Rational> rational_root(const Polynomial& p, const Rational& a, const Rational& b,
                                      const Real& t) {
  if (t.exact()) return t.exact();
  const Polynomial q = primitive_part(p);
  const Rational lead = q.leading_coefficient();
  const auto size = bit_length(numerator(lead));
  for (long bits = size + 8;; bits *= 2) {
    const RealBall ball = t.enclose(bits);
    if (!ball.is_finite() || lead * ball.radius() * 2 >= 1) continue;
    const Rational low = lead * std::max(ball.lower(), a);
    Integer n = numerator(low) / denominator(low);
    if (Rational(n) < low) ++n;  // the division truncates towards 0
    for (const Rational high = lead * std::min(ball.upper(), b); Rational(n) <= high; ++n)
      if (const Rational r = Rational(n) / lead; q(r) == 0) return r;
    return std::nullopt;
  }
}

/// Where a is irrational, its polynomial has no rational root, and its sign changes in the interval
/// exactly once, at a.
std::strong_ordering compare(const RealAlgebraic& a, const Rational& r) {
  if (const auto exact = a.rational()) return order(*exact, r);
  const Interval& i = a.interval();
  if (r <= *i.lower) return std::strong_ordering::greater;
  if (r >= *i.upper) return std::strong_ordering::less;
  const Polynomial& p = a.polynomial();
  return p(r).sign() == p(*i.lower).sign() ? std::strong_ordering::greater
                                           : std::strong_ordering::less;
}

/// If a lies in the interval of b and has the same polynomial it is b. Numbers with different
/// irreducible polynomials are different, and balls around them become disjoint.
std::strong_ordering compare(const RealAlgebraic& a, const RealAlgebraic& b) {
  if (const auto exact = b.rational()) return compare(a, *exact);
  if (const auto exact = a.rational()) return 0 <=> compare(b, *exact);
  if (compare(a, *b.interval().lower) < 0) return std::strong_ordering::less;
  if (compare(a, *b.interval().upper) > 0) return std::strong_ordering::greater;
  if (a.polynomial() == b.polynomial()) return std::strong_ordering::equal;
  for (long bits = 64;; bits *= 2) {
    const RealBall x = enclose(a, bits);
    const RealBall y = enclose(b, bits);
    if (!x.overlaps(y)) return order(x.lower(), y.lower());
  }
}

// a is a root of q if and only if its irreducible polynomial divides q.
bool is_root(const Polynomial& q, const RealAlgebraic& a) {
  if (const auto exact = a.rational()) return q(*exact) == 0;
  return (q % a.polynomial()).is_zero();
}

int sign_at(const Polynomial& q, const RealAlgebraic& a) {
  if (const auto exact = a.rational()) return q(*exact).sign();
  // The remainder below has longer coefficients than q.
  for (const long bits : {64, 256}) {
    const RealBall value = evaluate(q, enclose(a, bits), bits);
    if (!value.contains_zero()) return value.lower().sign();
  }
  const Polynomial rest = q % a.polynomial();
  if (rest.is_zero()) return 0;
  for (long bits = 64;; bits *= 2) {
    const RealBall value = evaluate(rest, ComplexBall(enclose(a, bits), RealBall()), bits).re();
    if (!value.contains_zero()) return value.lower().sign();
  }
}

/// Halving the interval always helps, Newton's method once it is narrow enough.
RealBall enclose(const RealAlgebraic& a, long bits) {
  if (const auto exact = a.rational()) return {*exact, bits + 2};
  Interval around = a.interval();
  for (long width = 40;; width *= 2) {
    const bool is_last = width > bits;
    if (is_last) width = bits + 1;
    around = narrowed(a.polynomial(), std::move(around),
                      Rational(1, Integer(1) << static_cast<unsigned>(width)));
    RealBall ball((*around.lower + *around.upper) / 2, width + 64);
    const RealBall half_width((*around.upper - *around.lower) / 2, 64);
    flint::Mag radius;
    arb_get_mag(radius.get(), half_width.raw());
    arb_add_error_mag(ball.raw(), radius.get());
    if (refine(a.polynomial(), ball, bits + 2) || is_last) return ball;
  }
}

// A root that is not 0 is not below 1/(1 + H), H the greatest coefficient [Cauchy].
long bits_of(const RealAlgebraic& a) {
  if (const auto exact = a.rational()) return bits_of(*exact);
  const flint::FmpzPoly p = integer_primitive_part(a.polynomial());
  return fmpz_poly_degree(p.get()) * (std::abs(fmpz_poly_max_bits(p.get())) + 1);
}

Real to_real(const RealAlgebraic& a) {
  if (const auto exact = a.rational()) return *exact;
  return {[a](long bits) { return enclose(a, bits); }, {true, bits_of(a)}};
}

std::string place_text(std::string_view letter, const RealAlgebraic& a) {
  const auto exact = a.rational();
  return std::string(letter) +
         (exact ? " = " + abbreviated(to_string(*exact)) : " ≈ " + to_string(enclose(a, 64), 12));
}

std::ostream& operator<<(std::ostream& out, const RealAlgebraic& a) {
  if (a.is_rational()) return out << *a.rational();
  return out << "root of " << a.polynomial() << " in " << a.interval();
}

}  // namespace phrame
