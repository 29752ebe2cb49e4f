#include "phrame/ph/smooth/known_integrals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"

// With |y_z| ≤ M on |z| ≤ 4, its coefficients are at most M/4ᵏ, so that the integral of what is
// left out is at most M/4ⁿ · Σ 4⁻ᵏ/(n + 1) up to |z| = 1.

namespace phrame {
namespace {

/// More than the error that is asked for, against the errors of rounding.
constexpr long guard_bits = 20;
/// Of these what is left out of a series need not be below.
constexpr long spare_bits = 16;

/// How a part is computed.
struct PieceSize {
  long length;
  long bits;
};
PieceSize size_of(const TaylorPart& part, long bits) {
  const long above = std::max(exponent_above(part.bound), 0L);
  return {std::max((bits - spare_bits + above) / 2, 0L) + 2, bits + above};
}

CurveJet jet_on(const ExpressionCurve& curve, const TaylorPart& part, const PieceSize& size) {
  const Rational half = (part.upper - part.lower) / 2;
  return {curve, RealBall(part.lower + half, size.bits), half, size.length, size.bits};
}

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

  static Piece of(const CurveIntegrand& y, const TaylorPart& part, const CurveJet& jet) {
    const DiscProduct product = y(jet);
    const auto& [own_series, own_bound, length, bits] = product.numerator;
    Piece piece;
    piece.antiderivative = phrame::antiderivative(series(product), bits);
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
  /// That is as many as are needed for 2^−wanted.
  long needed_bits(long wanted) const {
    return wanted + guard_bits + static_cast<long>(std::log2(parts().size() + 1));
  }

  void refine(const ExpressionCurve& curve, const std::vector<TaylorPart>& regular, long bits) {
    if (analytic->fault) {
      TaylorParts found =
          find_parts_with_gaps(curve, y, regular, with_gaps_ ? *with_gaps_ : *analytic, bits);
      if (found.fault)
        throw Undecided(fmt::format("integral: {} bits of it take too many parts near t = {:.9g}",
                                    bits, static_cast<double>(found.fault->lower)));
      with_gaps_ = std::move(found);
    }
    bits_ = bits;
    pieces_.assign(parts().size(), std::nullopt);
    sums_.assign(1, RealBall());
  }

  /// The first part whose integral is not in the sums; null after the last one.
  const TaylorPart* next_part() const {
    return sums_.size() > parts().size() ? nullptr : &parts()[sums_.size() - 1];
  }
  void add_piece(const Piece& piece) {
    sums_.push_back(add(sums_.back(), piece.up_to(RealBall(1, bits_), bits_), bits_));
  }

  RealBall value(const ExpressionCurve& curve, const Rational& t) {
    const auto next = std::upper_bound(
        parts().begin(), parts().end(), t,
        [](const Rational& at, const TaylorPart& part) { return at < part.lower; });
    const auto k = static_cast<std::size_t>(next - parts().begin()) - 1;
    while (sums_.size() <= k) add_piece(piece(curve, sums_.size() - 1));
    const TaylorPart& part = parts()[k];
    if (t == part.upper && sums_.size() > k + 1) return sums_[k + 1];
    const Rational z = (Rational(2) * t - part.lower - part.upper) / (part.upper - part.lower);
    return add(sums_[k], piece(curve, k).up_to(RealBall(z, bits_), bits_), bits_);
  }

 private:
  const Piece& piece(const ExpressionCurve& curve, std::size_t k) {
    const TaylorPart& part = parts()[k];
    if (!pieces_[k])
      pieces_[k] = part.is_gap ? Piece::over_gap(part)
                               : Piece::of(y, part, jet_on(curve, part, size_of(part, bits_)));
    return *pieces_[k];
  }

  std::optional<TaylorParts> with_gaps_;
  long bits_ = 0;
  std::vector<std::optional<Piece>> pieces_;
  std::vector<RealBall> sums_;  ///< ∫ up to the start of part 0, 1, …, as far as known
};

KnownIntegrals::KnownIntegrals() = default;
KnownIntegrals::~KnownIntegrals() = default;

void KnownIntegrals::search(const ExpressionCurve& curve,
                            const std::vector<CurveIntegrand>& integrands) {
  if (integrals_.empty())
    integrals_.push_back(std::make_unique<Integral>(length_rate(), find_regular_parts(curve)));
  std::vector<CurveIntegrand> sought;
  for (const CurveIntegrand& y : integrands)
    if (find(y) == nullptr) sought.push_back(y.sign < 0 ? negative(y) : y);
  if (sought.empty()) return;
  auto found = find_parts(curve, sought, integrals_.front()->analytic->parts);
  for (std::size_t k = 0; k < sought.size(); ++k)
    integrals_.push_back(std::make_unique<Integral>(sought[k], std::move(found[k])));
}

/// Of y or −y; null where it was not searched for.
KnownIntegrals::Integral* KnownIntegrals::find(CurveIntegrand y) const {
  y.sign = 1;
  const auto found = std::find_if(integrals_.begin(), integrals_.end(),
                                  [&y](const auto& known) { return known->y == y; });
  return found == integrals_.end() ? nullptr : found->get();
}

KnownIntegrals::Integral& KnownIntegrals::searched(const ExpressionCurve& curve,
                                                   const CurveIntegrand& y) {
  search(curve, {y});
  return *find(y);
}

std::shared_ptr<const TaylorParts> KnownIntegrals::parts(const ExpressionCurve& curve,
                                                         const CurveIntegrand& y) {
  const std::lock_guard guard(lock_);
  return searched(curve, y).analytic;
}

void KnownIntegrals::find_together(const ExpressionCurve& curve,
                                   const std::vector<CurveIntegrand>& integrands) {
  const std::lock_guard guard(lock_);
  search(curve, integrands);
  together_.clear();
  for (const CurveIntegrand& y : integrands)
    if (Integral* f = find(y); f->bits() == 0 && !f->analytic->fault) together_.push_back(f);
}

/// The integrals up to the ends of their parts. Where several have the same part, what they are
/// made of is found once.
void KnownIntegrals::walk_together(const ExpressionCurve& curve, long bits) {
  for (Integral* f : together_) f->refine(curve, {}, bits);
  const auto waits_longer = [](const Integral* f, const Integral* g) {
    return g->next_part() == nullptr ||
           (f->next_part() != nullptr && is_before(*f->next_part(), *g->next_part()));
  };
  for (;;) {
    const Integral* first = *std::min_element(together_.begin(), together_.end(), waits_longer);
    if (first->next_part() == nullptr) return;
    const TaylorPart part = *first->next_part();
    std::vector<Integral*> here;
    PieceSize size{0, 0};
    for (Integral* f : together_)
      if (const TaylorPart* own = f->next_part();
          own != nullptr && own->lower == part.lower && own->upper == part.upper) {
        here.push_back(f);
        const PieceSize enough = size_of(*own, bits);
        size = {std::max(size.length, enough.length), std::max(size.bits, enough.bits)};
      }
    const CurveJet jet = jet_on(curve, part, size);
    for (Integral* f : here) f->add_piece(Piece::of(f->y, *f->next_part(), jet));
  }
}

void KnownIntegrals::refine(const ExpressionCurve& curve, Integral& f, long bits) {
  constexpr long more_for_others = 8;
  if (std::find(together_.begin(), together_.end(), &f) != together_.end()) {
    walk_together(curve, bits + more_for_others);
    together_.clear();
  } else {
    f.refine(curve, integrals_.front()->analytic->parts, bits);
  }
}

RealBall KnownIntegrals::enclose(const ExpressionCurve& curve, const CurveIntegrand& y,
                                 const Rational& t, long bits) {
  const std::lock_guard guard(lock_);
  Integral& f = searched(curve, y);
  const RealBall wanted = times_power_of_two(RealBall(1, 2), -bits);
  const long least = f.needed_bits(bits);
  if (f.bits() < least) refine(curve, f, least);
  RealBall value = f.value(curve, t);
  for (int more = 0; more < 3 && !is_at_most(radius_of(value), wanted); ++more) {
    refine(curve, f, f.bits() + (32L << more));
    value = f.value(curve, t);
  }
  return y.sign < 0 ? subtract({}, value, f.bits()) : value;
}

}  // namespace phrame
