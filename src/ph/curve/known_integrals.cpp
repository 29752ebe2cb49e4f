#include "phrame/ph/curve/known_integrals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/gauss_rule.hpp"

// With |y_z| ≤ M on |z| ≤ r, the ellipse with the foci ±1 and the half axis (ρ + 1/ρ)/2 = r is in
// that disc, and on it y_z = Σ aₖTₖ, |aₖ| ≤ 2Mρ⁻ᵏ [Trefethen 2013, theorem 8.1], with ρ = r + √(r²
// − 1) > 3 for r ≥ 2.
//
// Up to points inside of a part the polynomial is integrated that takes the values of y_z at the n
// + 1 extrema of Tₙ. It is off by 4Mρ⁻ⁿ/(ρ − 1) at most [theorem 8.2], so its integral by 4Mρ⁻ⁿ.
//
// Whole parts are integrated by Gauss's rule, whose points serve all integrands. The rule is exact
// up to T₂ₙ₋₁ and for odd k; for other Tₖ the integral and the sum are at most 2. So the error is
// at most Σ 8Mρ⁻ᵏ, k = 2n, 2n + 2, …: less than 9M/ρ²ⁿ.

namespace phrame::inline v0 {
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

/// ρ².
RealBall gain_a_point(const TaylorPart& part) {
  const Rational r = part.radius;
  const RealBall root = sqrt(RealBall(r * r - 1, 64), 64);
  return pow(add(RealBall(r, 64), root, 64), 2, 64);
}

/// How many points leave out less than the last of the bits.
long count_points(const TaylorPart& part, long bits) {
  const double bits_a_point = std::log2(approximate(gain_a_point(part)));
  return static_cast<long>(
      std::ceil(static_cast<double>(bits_left_out(part, bits) + 4) / bits_a_point));
}

/// What is known of y on a smaller part: of s times the size, at most 1 − s from the middle, it has
/// a disc of s·r′ = r − (1 − s) in that of the given one. 1/s is a power of 2.
TaylorPart part_inside(TaylorPart part, const Rational& lower, const Rational& upper) {
  if (lower == part.lower && upper == part.upper) return part;
  const Rational size = (upper - lower) / (part.upper - part.lower);
  const Rational radius = 1 + (part.radius - 1) / size;
  return {lower,       upper,       multiply(part.bound, RealBall(size, 64), 64),
          part.is_gap, part.length, static_cast<long>(numerator(radius))};
}

}  // namespace

/// Rules and points that were needed.
class KnownIntegrals::Rules {
 public:
  /// That of so many points, in balls of so many bits.
  const GaussRule& of(long n, long bits) {
    const auto known = rules_.find({n, bits});
    if (known != rules_.end()) return known->second;
    return rules_.emplace(std::pair(n, bits), gauss_rule(n, bits)).first->second;
  }
  /// cos kπ/n for k = 0, …, 2n − 1.
  const std::vector<RealBall>& cosines(long n, long bits) {
    const auto known = cosines_.find({n, bits});
    if (known != cosines_.end()) return known->second;
    std::vector<RealBall> all;
    const RealBall step = divide(pi(bits), RealBall(n, bits), bits);
    for (long k = 0; k <= n; ++k)
      all.push_back(cos_sin(multiply(RealBall(k, bits), step, bits), bits).cos);
    for (long k = n - 1; k > 0; --k) all.push_back(all[static_cast<std::size_t>(k)]);
    return cosines_.emplace(std::pair(n, bits), std::move(all)).first->second;
  }

 private:
  std::map<std::pair<long, long>, GaussRule> rules_;
  std::map<std::pair<long, long>, std::vector<RealBall>> cosines_;
};

/// ∫ y on a part, Σ bₖTₖ(z) for k = 1, 2, …, and how far it is from the truth at most.
struct KnownIntegrals::Piece {
  std::vector<RealBall> antiderivative;  ///< b₁, b₂, …
  RealBall start;                        ///< its value at z = −1
  RealBall error;

  static Piece of(const ExpressionCurve& curve, const CurveIntegrand& y, const TaylorPart& part,
                  Rules& rules, long bits) {
    // A multiple of 8, so that parts have points in common.
    const long n = (2 * count_points(part, bits) + 7) / 8 * 8;
    const std::vector<RealBall>& cosines = rules.cosines(n, bits);
    const auto count = static_cast<std::size_t>(n);
    const Rational half = half_of(part);
    const RealBall middle(part.lower + half, bits);
    const RealBall scale(half, bits);
    std::vector<RealBall> values;
    for (std::size_t j = 0; j <= count; ++j) {
      values.push_back(
          y(CurvePoint(curve, add_product(middle, scale, cosines[j], bits), half, bits)));
      if (j == 0 || j == count) values[j] = times_power_of_two(std::move(values[j]), -1);
    }
    // n/2 times the coefficients of Tₖ, of T₀ n times; 0 from Tₙ₊₁ on.
    std::vector<RealBall> c(count + 2);
    for (std::size_t k = 0; k <= count; ++k) {
      for (std::size_t j = 0; j <= count; ++j)
        c[k] = add_product(std::move(c[k]), values[j], cosines[j * k % (2 * count)], bits);
    }
    c[count] = times_power_of_two(std::move(c[count]), -1);
    // bₖ = (cₖ₋₁ − cₖ₊₁)/(2k), with 2c₀.
    Piece piece;
    for (std::size_t k = 1; k <= count + 1; ++k) {
      const RealBall last = k <= count ? c[k + 1] : RealBall();
      piece.antiderivative.push_back(
          divide(subtract(c[k - 1], last, bits), RealBall(n * static_cast<long>(k), bits), bits));
      piece.start = k % 2 == 0 ? add(piece.start, piece.antiderivative.back(), bits)
                               : subtract(piece.start, piece.antiderivative.back(), bits);
    }
    piece.error =
        divide(multiply(part.bound, RealBall(4, 64), 64), pow(gain_a_point(part), n / 2, 64), 64);
    return piece;
  }
  static Piece over_gap(const TaylorPart& part) {
    return {{}, {}, times_power_of_two(part.bound, 1)};
  }

  // T₂ₖ = 2Tₖ² − 1 and T₂ₖ₊₁ = 2TₖTₖ₊₁ − z, so that errors grow by little.
  RealBall up_to(const RealBall& z, long bits) const {
    const RealBall one(1, bits);
    std::vector<RealBall> t{one, z};
    RealBall sum = subtract(RealBall(), start, bits);
    for (std::size_t k = 1; k <= antiderivative.size(); ++k) {
      if (k > 1)
        t.push_back(subtract(times_power_of_two(multiply(t[k / 2], t[(k + 1) / 2], bits), 1),
                             k % 2 == 0 ? one : z, bits));
      sum = add_product(std::move(sum), antiderivative[k - 1], t[k], bits);
    }
    return widened(sum, error);
  }
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
    sum_ = {};
    reached_ = 0;
    bits_ = bits;
  }

  /// The first part whose integral is not in the sums; null after the last one.
  const TaylorPart* next_part() const {
    return sums_.size() > parts().size() ? nullptr : &parts()[sums_.size() - 1];
  }
  /// How far it is known.
  const Rational& reached() const { return reached_; }
  /// The integral from there to `upper`, at most to the end of the next part.
  void add_to_sums(const RealBall& of_next, const Rational& upper) {
    sum_ = add(sum_, of_next, bits_);
    reached_ = upper;
    if (upper == next_part()->upper) sums_.push_back(sum_);
  }
  /// The sum up to the start of part k, which is known.
  const RealBall& sum(std::size_t k) const { return sums_[k]; }
  std::size_t sums() const { return sums_.size(); }  ///< how many of these are known
  /// From there to t, on part k.
  RealBall rest(const ExpressionCurve& curve, Rules& rules, std::size_t k, const Rational& t) {
    const TaylorPart& part = parts()[k];
    if (!pieces_[k])
      pieces_[k] = part.is_gap ? Piece::over_gap(part) : Piece::of(curve, y, part, rules, bits_);
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
  RealBall sum_;                ///< up to there
  Rational reached_;
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

/// To the sums of these, up to the first end of their next parts: the points of a rule, and what
/// integrands have in common there, are found once.
void KnownIntegrals::add_next(const ExpressionCurve& curve, const std::vector<Integral*>& of) {
  const long bits = of.front()->bits();
  std::vector<TaylorPart> here;
  const Rational& lower = of.front()->reached();
  const Rational upper = (*std::min_element(of.begin(), of.end(),
                                            [](const auto* f, const auto* g) {
                                              return f->next_part()->upper < g->next_part()->upper;
                                            }))
                             ->next_part()
                             ->upper;
  long points = 0;
  for (const Integral* f : of) {
    here.push_back(part_inside(*f->next_part(), lower, upper));
    points = std::max(points, count_points(here.back(), bits));
  }
  if (here.front().is_gap)
    return of.front()->add_to_sums(Piece::over_gap(here.front()).up_to({}, bits), upper);
  const GaussRule& rule = rules_->of(points, bits);
  const Rational half = half_of(here.front());
  const RealBall middle(lower + half, bits);
  const RealBall scale(half, bits);
  std::vector<RealBall> sums(of.size());
  for (std::size_t k = 0; k < rule.points.size(); ++k) {
    const CurvePoint at(curve, add_product(middle, scale, rule.points[k], bits), half, bits);
    for (std::size_t j = 0; j < of.size(); ++j)
      sums[j] = add_product(std::move(sums[j]), rule.weights[k], of[j]->y(at), bits);
  }
  for (std::size_t j = 0; j < of.size(); ++j) {
    const RealBall power = pow(gain_a_point(here[j]), points, 64);
    const RealBall error = divide(multiply(here[j].bound, RealBall(9, 64), 64), power, 64);
    of[j]->add_to_sums(widened(sums[j], error), upper);
  }
}

/// All sums of those that were asked for together.
void KnownIntegrals::walk(const ExpressionCurve& curve,
                          const std::vector<std::shared_ptr<Integral>>& all, long bits) {
  std::vector<Integral*> of;
  for (const auto& f : all) {
    f->refine(curve, {}, bits);
    of.push_back(f.get());
  }
  while (of.front()->next_part() != nullptr) add_next(curve, of);
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
    known ? f.add_to_sums(*known, parts[f.sums() - 1].upper) : add_next(curve, {&f});
  }
  if (whole > k || t == parts[k].lower) return f.sum(whole);
  return add(f.sum(k), f.rest(curve, *rules_, k, t), f.bits());
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
