#include "phrame/algebra/sturm.hpp"

#include <fmt/format.h>

#include <ostream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"

namespace phrame::inline v0 {
namespace {

/// The number of sign changes in a sequence, zeros skipped.
struct SignCounter {
  long count = 0;
  int last = 0;

  void see(int sign) {
    if (sign != 0 && sign == -last) ++count;
    if (sign != 0) last = sign;
  }
};

int sign_at(const fmpz_poly_t p, const fmpq_t t) {
  flint::Fmpq value;
  fmpz_poly_evaluate_fmpq(value.get(), p, t);
  return fmpq_sgn(value.get());
}

int sign_at(const Polynomial& p, const Rational& t) { return p(t).sign(); }

/// A number beyond every root of p in absolute value: Cauchy's 1 + max |c_k/c_n|.
Rational root_bound(const Polynomial& p) {
  Rational largest = 0;
  const Rational lead = abs(p.leading_coefficient());
  for (long k = 0; k < p.degree(); ++k) {
    const Rational ratio = abs(p.coefficient(k)) / lead;
    if (ratio > largest) largest = ratio;
  }
  return largest + 1;
}

/// The sign changes in the coefficients of (1 + s)ⁿ p((a + b·s)/(1 + s)): an upper bound of the
/// number of roots in (a, b), with multiplicity, and exact where it is 0 or 1 (Descartes).
long descartes_bound(const Polynomial& p, const Rational& a, const Rational& b) {
  // x = a + (b − a)·y, y ∈ (0, 1); then reverse and shift by 1: y = 1/(1 + s).
  const bool is_unit = a == 0 && b == 1;
  const flint::FmpzPoly on_unit = integer_numerator(is_unit ? p : compose(p, Polynomial{a, b - a}));
  flint::FmpzPoly shifted;
  flint::Fmpz one;
  fmpz_one(one.get());
  fmpz_poly_reverse(shifted.get(), on_unit.get(), fmpz_poly_length(on_unit.get()));
  fmpz_poly_taylor_shift(shifted.get(), shifted.get(), one.get());
  SignCounter changes;
  for (slong k = 0; k < fmpz_poly_length(shifted.get()); ++k)
    changes.see(fmpz_sgn(fmpz_poly_get_coeff_ptr(shifted.get(), k)));
  return changes.count;
}

bool is_empty(const Interval& i) {
  if (!i.lower || !i.upper) return false;
  return *i.lower > *i.upper || (*i.lower == *i.upper && !(i.lower_closed && i.upper_closed));
}

/// Both ends finite, no root of p lost: an infinite end moves to the root bound.
Interval bounded(const Polynomial& p, Interval interval) {
  if (interval.lower && interval.upper) return interval;
  const Rational bound = root_bound(p);
  if (!interval.lower)
    interval.lower =
        interval.upper && *interval.upper < -bound ? *interval.upper - 1 : Rational(-bound);
  if (!interval.upper) interval.upper = *interval.lower > bound ? *interval.lower + 1 : bound;
  return interval;
}

/// The number of roots of a squarefree f in open intervals: by Descartes' rule where that decides.
/// Where it does not, halves of the interval are mostly decided at once, and that takes far less
/// time than a Sturm sequence, whose coefficients are as long as the discriminant of f. Roots
/// close together need one.
class RootCounter {
 public:
  explicit RootCounter(const Polynomial& f) : f_(f) {}

  /// No value for "halve it", in the first halvings only.
  std::optional<long> count(const Rational& a, const Rational& b, long halvings) {
    const long bound = descartes_bound(f_, a, b);
    if (bound <= 1) return bound;
    if (halvings < 128) return std::nullopt;
    if (!chain_) chain_.emplace(f_, differentiate(f_));
    // V(a) − V(b) counts the roots in (a, b].
    return chain_->variations(a) - chain_->variations(b) - (f_(b) == 0 ? 1 : 0);
  }

 private:
  const Polynomial& f_;
  std::optional<SturmChain> chain_;
};

/// A part of an interval that is still to be looked at: open, or a point.
struct Part {
  Rational lower;
  Rational upper;
  long halvings;
};

/// Puts the two open halves and the middle on the list, the first half last. (There may be as many
/// halvings as f has bits, too many for recursion.)
void halve(const Part& part, std::vector<Part>& parts) {
  const Rational middle = (part.lower + part.upper) / 2;
  parts.push_back({middle, part.upper, part.halvings + 1});
  parts.push_back({middle, middle, part.halvings + 1});
  parts.push_back({part.lower, middle, part.halvings + 1});
}

/// The roots in the open (a, b) of the squarefree f, f(a)·f(b) ≠ 0 not required.
long count_inside(const Polynomial& f, const Rational& a, const Rational& b) {
  RootCounter counter(f);
  long total = 0;
  std::vector<Part> parts = {{a, b, 0}};
  while (!parts.empty()) {
    const Part part = std::move(parts.back());
    parts.pop_back();
    if (part.lower == part.upper) {
      if (f(part.lower) == 0) ++total;
    } else if (const auto count = counter.count(part.lower, part.upper, part.halvings)) {
      total += *count;
    } else {
      halve(part, parts);
    }
  }
  return total;
}

}  // namespace

std::string to_string(const Interval& i) {
  if (i.lower && i.upper && *i.lower == *i.upper) return to_string(*i.lower);
  return fmt::format("{}{}, {}{}", i.lower && i.lower_closed ? "[" : "(",
                     i.lower ? to_string(*i.lower) : "−∞", i.upper ? to_string(*i.upper) : "∞",
                     i.upper && i.upper_closed ? "]" : ")");
}

SturmChain::SturmChain(const Polynomial& p, const Polynomial& q) {
  // integer_primitive_part makes the leading coefficient positive; the chain needs the sign of p
  // and of q themselves.
  const auto push = [this](const Polynomial& f) {
    chain_.push_back(integer_primitive_part(f));
    if (f.leading_coefficient() < 0) fmpz_poly_neg(chain_.back().get(), chain_.back().get());
  };
  if (p.is_zero()) throw DomainError("SturmChain: the first polynomial is 0");
  push(p);
  if (q.is_zero()) return;
  push(q);
  for (;;) {
    const auto& a = chain_[chain_.size() - 2];
    const auto& b = chain_.back();
    flint::FmpzPoly r;
    flint::Fmpz content;
    ulong power = 0;
    fmpz_poly_pseudo_rem(r.get(), &power, a.get(), b.get());  // lead(b)^power · a ≡ r modulo b
    if (fmpz_poly_is_zero(r.get()) != 0) return;
    fmpz_poly_content(content.get(), r.get());
    fmpz_poly_scalar_divexact_fmpz(r.get(), r.get(), content.get());
    const bool flipped = power % 2 == 1 && fmpz_sgn(fmpz_poly_lead(b.get())) < 0;
    if (!flipped) fmpz_poly_neg(r.get(), r.get());
    chain_.push_back(std::move(r));
  }
}

std::vector<int> SturmChain::signs(const Rational& t) const {
  std::vector<int> list;
  for (const flint::FmpzPoly& p : chain_) list.push_back(sign_at(p.get(), t.raw()));
  return list;
}

long SturmChain::variations(const Rational& t) const {
  SignCounter changes;
  for (const int sign : signs(t)) changes.see(sign);
  return changes.count;
}

long count_real_roots(const Polynomial& p, const Interval& interval) {
  if (p.is_zero()) throw DomainError("count_real_roots: the zero polynomial vanishes everywhere");
  if (p.is_constant() || is_empty(interval)) return 0;
  const Interval finite = bounded(p, interval);
  const Rational& a = *finite.lower;
  const Rational& b = *finite.upper;
  const bool has_some = a < b && descartes_bound(p, a, b) > 0;
  long count = has_some ? count_inside(squarefree_part(p), a, b) : 0;
  if (finite.lower_closed && p(a) == 0) ++count;
  if (finite.upper_closed && a != b && p(b) == 0) ++count;
  return count;
}

std::vector<Interval> isolate_real_roots(const Polynomial& p, const Interval& interval) {
  if (p.is_zero()) throw DomainError("isolate_real_roots: the zero polynomial vanishes everywhere");
  if (p.is_constant() || is_empty(interval)) return {};
  const Interval finite = bounded(p, interval);
  std::vector<Interval> found;
  const auto point = [&](const Rational& t) { found.push_back(closed_interval(t, t)); };
  // The roots in the open (from, to), in order. It ends because f is squarefree.
  const auto search = [&](const Rational& from, const Rational& to) {
    if (descartes_bound(p, from, to) == 0) return;
    const Polynomial f = squarefree_part(p);
    RootCounter counter(f);
    std::vector<Part> parts = {{from, to, 0}};
    while (!parts.empty()) {
      const Part part = std::move(parts.back());
      parts.pop_back();
      const auto& [a, b, halvings] = part;
      if (a == b) {
        if (f(a) == 0) point(a);
        continue;
      }
      const auto count = counter.count(a, b, halvings);
      if (count == 0) continue;
      if (count == 1 && sign_at(f, a) * sign_at(f, b) < 0)
        found.push_back(open_interval(a, b));
      else
        halve(part, parts);
    }
  };

  const Rational& a = *finite.lower;
  const Rational& b = *finite.upper;
  if (finite.lower_closed && p(a) == 0) point(a);
  if (a < b) search(a, b);
  if (finite.upper_closed && a != b && p(b) == 0) point(b);
  return found;
}

Interval narrowed(const Polynomial& p, Interval isolating, const Rational& width) {
  if (*isolating.upper - *isolating.lower <= width) return isolating;
  const Polynomial f = squarefree_part(p);
  const int below = sign_at(f, *isolating.lower);
  do {
    const Rational middle = (*isolating.lower + *isolating.upper) / 2;
    const int sign = sign_at(f, middle);
    if (sign == 0) return closed_interval(middle, middle);
    (sign == below ? isolating.lower : isolating.upper) = middle;
  } while (*isolating.upper - *isolating.lower > width);
  return isolating;
}

std::vector<Interval> located_real_roots(const Polynomial& p, const Interval& interval) {
  std::vector<Interval> found = isolate_real_roots(p, interval);
  if (found.empty()) return found;
  for (const auto& [base, exponent] : factor(p).factors) {
    if (base.degree() != 1) continue;
    const Rational root = -base.coefficient(0) / base.coefficient(1);
    for (Interval& i : found)
      if (*i.lower < root && root < *i.upper) i = closed_interval(root, root);
  }
  for (Interval& i : found) i = narrowed(p, std::move(i), Rational(1, 1 << 20));
  return found;
}

long cauchy_index(const SturmChain& chain, const Rational& a, const Rational& b) {
  return chain.variations(a) - chain.variations(b);
}

std::ostream& operator<<(std::ostream& out, const Interval& interval) {
  return out << to_string(interval);
}

}  // namespace phrame
