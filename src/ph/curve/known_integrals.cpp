#include "phrame/ph/curve/known_integrals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/gauss_rule.hpp"

// With |y_z| ≤ M on |z| ≤ 4, the coefficients of its Taylor series are at most M/4ᵏ, so that the
// integral of what is left out is at most M/4ⁿ · Σ 4⁻ᵏ/(n + 1) up to |z| = 1.
//
// Whole parts are integrated by Gauss's rule, whose points serve all integrands. The ellipse with
// the foci ±1 and the half axis (ρ + 1/ρ)/2 = 4 is in that disc, and on it y_z = Σ aₖTₖ, |aₖ| ≤
// 2Mρ⁻ᵏ [Trefethen 2013, theorem 8.1]. The rule is exact up to T₂ₙ₋₁ and for odd k; for other Tₖ
// the integral and the sum are at most 2. So the error is at most Σ 8Mρ⁻ᵏ, k = 2n, 2n + 2, …, with
// ρ² = (4 + √15)² > 61: less than 9M/61ⁿ.

namespace phrame {
namespace {

/// More than the error that is asked for, against the errors of rounding.
constexpr long guard_bits = 20;
/// Of these what is left out of a series need not be below.
constexpr long spare_bits = 16;

/// The bits of what is left out on a part.
long bits_left_out(const TaylorPart& part, long bits) {
  return std::max(bits - spare_bits + std::max(exponent_above(part.bound), 0L), 0L);
}

Rational half_of(const TaylorPart& part) { return (part.upper - part.lower) / 2; }

/// Is a earlier on the walk, or on the same part but longer?
bool is_before(const TaylorPart& a, const TaylorPart& b) {
  return a.lower < b.lower || (a.lower == b.lower && b.upper < a.upper);
}

}  // namespace

/// ∫ y from the middle of a part, a polynomial in z, and how far it is from the truth at most.
struct KnownIntegrals::Piece {
  BallPolynomial antiderivative;
  RealBall start;  ///< its value at z = −1
  RealBall error;

  static Piece of(const ExpressionCurve& curve, const CurveIntegrand& y, const TaylorPart& part,
                  long bits) {
    const long length = bits_left_out(part, bits) / 2 + 2;
    const Rational half = half_of(part);
    const long more = bits + std::max(exponent_above(part.bound), 0L);
    const CurveJet jet(curve, RealBall(part.lower + half, more), half, length, more);
    Piece piece;
    piece.antiderivative = phrame::antiderivative(series(y(jet)), more);
    piece.start = evaluate(piece.antiderivative, RealBall(-1, bits), bits);
    // Both ends, 2/(1 − 1/4) < 4.
    piece.error = times_power_of_two(multiply(part.bound, RealBall(4, 64), 64), -2 * length);
    return piece;
  }
  static Piece over_gap(const TaylorPart& part) {
    return {{}, {}, times_power_of_two(part.bound, 1)};
  }

  RealBall up_to(const RealBall& z, long bits) const {
    return widened(subtract(evaluate(antiderivative, z, bits), start, bits), error);
  }
};

/// Rules that were needed.
class KnownIntegrals::Rules {
 public:
  /// That which leaves out less than 2^(−left_out) of the bound, in balls of so many bits.
  const GaussRule& of(long left_out, long bits) {
    constexpr double bits_a_point = 5.93;  // log₂ 61
    const long n = static_cast<long>(std::ceil(static_cast<double>(left_out + 4) / bits_a_point));
    const auto known = rules_.find({n, bits});
    if (known != rules_.end()) return known->second;
    return rules_.emplace(std::pair(n, bits), gauss_rule(n, bits)).first->second;
  }

 private:
  std::map<std::pair<long, long>, GaussRule> rules_;
};

/// ∫ y from 0, of y with the sign 1.
class KnownIntegrals::Integral {
 public:
  Integral(CurveIntegrand integrand, TaylorParts parts)
      : y(std::move(integrand)), analytic(std::make_shared<const TaylorParts>(std::move(parts))) {}

  const CurveIntegrand y;
  const std::shared_ptr<const TaylorParts> analytic;

  /// Where y is not analytic all along, they have gaps, of the precision `bits`.
  const std::vector<TaylorPart>& parts() const {
    return with_gaps_ ? with_gaps_->parts : analytic->parts;
  }
  long bits() const { return bits_; }  ///< with which it is computed, 0 before the first time
  /// Where it is broken off: what is asked for next may be fewer bits.
  void forget() { bits_ = 0; }
  /// That is as many as are needed for 2^−wanted.
  long needed_bits(long wanted) const {
    return wanted + guard_bits + static_cast<long>(std::log2(parts().size() + 1));
  }

  void refine(const ExpressionCurve& curve, const std::vector<TaylorPart>& regular, long bits) {
    bits_ = 0;
    if (analytic->fault) {
      TaylorParts found =
          find_parts_with_gaps(curve, y, regular, with_gaps_ ? *with_gaps_ : *analytic, bits);
      if (found.fault)
        throw Undecided(fmt::format("integral: {} bits of it take too many parts near t = {:.9g}",
                                    bits, static_cast<double>(found.fault->lower)));
      with_gaps_ = std::move(found);
    }
    pieces_.assign(parts().size(), std::nullopt);
    sums_.assign(1, RealBall());
    bits_ = bits;
  }

  /// The first part whose integral is not in the sums; null after the last one.
  const TaylorPart* next_part() const {
    return sums_.size() > parts().size() ? nullptr : &parts()[sums_.size() - 1];
  }
  void add_to_sums(const RealBall& of_next) { sums_.push_back(add(sums_.back(), of_next, bits_)); }
  /// The sum up to the start of part k, which is known.
  const RealBall& sum(std::size_t k) const { return sums_[k]; }
  std::size_t sums() const { return sums_.size(); }  ///< how many of these are known
  /// From there to t, on part k.
  RealBall rest(const ExpressionCurve& curve, std::size_t k, const Rational& t) {
    const TaylorPart& part = parts()[k];
    if (!pieces_[k])
      pieces_[k] = part.is_gap ? Piece::over_gap(part) : Piece::of(curve, y, part, bits_);
    const Rational z = (Rational(2) * t - part.lower - part.upper) / (part.upper - part.lower);
    return pieces_[k]->up_to(RealBall(z, bits_), bits_);
  }
  /// The integral over the next part, if a polynomial for it is known.
  std::optional<RealBall> known_next() const {
    const auto& known = pieces_[sums_.size() - 1];
    return known ? std::optional(known->up_to(RealBall(1, bits_), bits_)) : std::nullopt;
  }

 private:
  std::optional<TaylorParts> with_gaps_;
  long bits_ = 0;
  std::vector<std::optional<Piece>> pieces_;
  std::vector<RealBall> sums_;  ///< ∫ up to the start of part 0, 1, …, as far as known
};

KnownIntegrals::KnownIntegrals() : rules_(std::make_unique<Rules>()) {}
KnownIntegrals::~KnownIntegrals() = default;

void KnownIntegrals::search(const ExpressionCurve& curve,
                            const std::vector<CurveIntegrand>& integrands) {
  constexpr std::size_t most_kept = 64;
  if (integrals_.empty())
    integrals_.push_back(std::make_shared<Integral>(length_rate(), find_regular_parts(curve)));
  std::vector<CurveIntegrand> sought;
  for (const CurveIntegrand& y : integrands)
    if (find(y) == nullptr) sought.push_back(y.sign < 0 ? negative(y) : y);
  if (sought.empty()) return;
  auto found = find_parts(curve, sought, integrals_.front()->analytic->parts);
  for (std::size_t k = 0; k < sought.size(); ++k)
    integrals_.push_back(std::make_shared<Integral>(sought[k], std::move(found[k])));
  if (integrals_.size() > most_kept)
    integrals_.erase(integrals_.begin() + 1, integrals_.end() - most_kept / 2);
}

/// Of y or −y; null where it was not searched for.
std::shared_ptr<KnownIntegrals::Integral> KnownIntegrals::find(CurveIntegrand y) const {
  y.sign = 1;
  const auto found = std::find_if(integrals_.begin(), integrals_.end(),
                                  [&y](const auto& known) { return known->y == y; });
  return found == integrals_.end() ? nullptr : *found;
}

std::shared_ptr<KnownIntegrals::Integral> KnownIntegrals::integral(const ExpressionCurve& curve,
                                                                   const CurveIntegrand& y) {
  const std::lock_guard guard(lock_);
  search(curve, {y});
  return find(y);
}

std::shared_ptr<const TaylorParts> KnownIntegrals::parts(const ExpressionCurve& curve,
                                                         const CurveIntegrand& y) {
  return integral(curve, y)->analytic;
}

void KnownIntegrals::find_together(const ExpressionCurve& curve,
                                   const std::vector<CurveIntegrand>& integrands) {
  const std::lock_guard guard(lock_);
  search(curve, integrands);
  together_.clear();
  for (const CurveIntegrand& y : integrands)
    if (auto f = find(y); f->bits() == 0 && !f->analytic->fault) together_.push_back(std::move(f));
}

/// To the sums of these, for which the next part is the same: the points of a rule, and what
/// integrands have in common there, are found once.
void KnownIntegrals::add_next_part(const ExpressionCurve& curve, const std::vector<Integral*>& of) {
  const long bits = of.front()->bits();
  const TaylorPart& part = *of.front()->next_part();
  if (part.is_gap) return of.front()->add_to_sums(Piece::over_gap(part).up_to({}, bits));
  long left_out = 0;
  for (const Integral* f : of) left_out = std::max(left_out, bits_left_out(*f->next_part(), bits));
  const GaussRule& rule = rules_->of(left_out, bits);
  const Rational half = half_of(part);
  const RealBall middle(part.lower + half, bits);
  const RealBall scale(half, bits);
  std::vector<RealBall> sums(of.size());
  for (std::size_t k = 0; k < rule.points.size(); ++k) {
    const CurveJet jet(curve, add_product(middle, scale, rule.points[k], bits), half, 1, bits);
    for (std::size_t j = 0; j < of.size(); ++j)
      sums[j] = add_product(std::move(sums[j]), rule.weights[k],
                            series(of[j]->y(jet)).coefficient(0), bits);
  }
  const RealBall power = pow(RealBall(61, 64), static_cast<long>(rule.points.size()), 64);
  for (std::size_t j = 0; j < of.size(); ++j) {
    const RealBall error =
        divide(multiply(of[j]->next_part()->bound, RealBall(9, 64), 64), power, 64);
    of[j]->add_to_sums(widened(sums[j], error));
  }
}

/// All sums of those that were asked for together.
void KnownIntegrals::walk(const ExpressionCurve& curve,
                          const std::vector<std::shared_ptr<Integral>>& all, long bits) {
  for (const auto& f : all) f->refine(curve, {}, bits);
  const auto is_next = [](const auto& f, const auto& g) {
    return g->next_part() == nullptr ||
           (f->next_part() != nullptr && is_before(*f->next_part(), *g->next_part()));
  };
  for (;;) {
    const TaylorPart* next = (*std::min_element(all.begin(), all.end(), is_next))->next_part();
    if (next == nullptr) return;
    std::vector<Integral*> here;
    for (const auto& f : all)
      if (const TaylorPart* own = f->next_part();
          own != nullptr && own->lower == next->lower && own->upper == next->upper)
        here.push_back(f.get());
    add_next_part(curve, here);
  }
}

RealBall KnownIntegrals::value(const ExpressionCurve& curve, Integral& f, const Rational& t) {
  const auto& parts = f.parts();
  const auto after =
      std::upper_bound(parts.begin(), parts.end(), t,
                       [](const Rational& at, const TaylorPart& part) { return at < part.lower; });
  const auto k = static_cast<std::size_t>(after - parts.begin()) - 1;
  const std::size_t whole = t == parts[k].upper ? k + 1 : k;
  while (f.sums() <= whole) {
    const auto known = f.known_next();
    known ? f.add_to_sums(*known) : add_next_part(curve, {&f});
  }
  if (whole > k || t == parts[k].lower) return f.sum(whole);
  return add(f.sum(k), f.rest(curve, k, t), f.bits());
}

void KnownIntegrals::refine(const ExpressionCurve& curve, Integral& f, long bits) {
  constexpr long more_for_others = 8;
  const bool is_one = std::any_of(together_.begin(), together_.end(),
                                  [&f](const auto& other) { return other.get() == &f; });
  if (!is_one) return f.refine(curve, integrals_.front()->analytic->parts, bits);
  const auto all = std::exchange(together_, {});
  try {
    walk(curve, all, bits + more_for_others);
  } catch (...) {
    for (const auto& other : all) other->forget();
    throw;
  }
}

RealBall KnownIntegrals::value(const ExpressionCurve& curve, Integral& f, const Rational& t,
                               long least_bits) {
  try {
    if (f.bits() < least_bits) refine(curve, f, least_bits);
    return value(curve, f, t);
  } catch (...) {
    f.forget();
    throw;
  }
}

RealBall KnownIntegrals::enclose(const ExpressionCurve& curve, Integral& f, const Rational& t,
                                 long bits) {
  const std::lock_guard guard(lock_);
  const RealBall wanted = times_power_of_two(RealBall(1, 2), -bits);
  RealBall found = value(curve, f, t, f.needed_bits(bits));
  for (int more = 0; more < 3 && !is_at_most(radius_of(found), wanted); ++more)
    found = value(curve, f, t, f.bits() + (32L << more));
  return found;
}

}  // namespace phrame
