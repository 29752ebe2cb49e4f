#include "phrame/ph/curve/taylor_parts.hpp"

#include <algorithm>
#include <numeric>

#include "phrame/algebra/ball_order.hpp"

// On a part of length 2h around c, with z = (t − c)/h, the integrand is y dt = y_z dz, y_z made of
// derivatives by z. Its factors are bounded from below on |z| ≤ 4 by the coefficients of their
// Taylor series and, for what is left out of these, by Cauchy's estimate on |z| ≤ 8, where balls
// enclose the derivatives of r.

namespace phrame::inline v0 {
namespace {

constexpr long guess_bits = 64;
constexpr long guess_length = 16;
constexpr long least_halvings = 40;
constexpr std::size_t most_taylor_parts = 20'000;

/// Indices of integrands.
using Sought = std::vector<std::size_t>;

/// How often [0, 1] was halved to get it.
long halvings_of(const TaylorPart& part) {
  const Rational times = 1 / (part.upper - part.lower);
  return exponent_above(RealBall(times, guess_bits)) - 1;
}

/// Is it analytic where ρ ≠ 0 only? Then the rest of it need not be made to see that it is not.
bool needs_bend(const CurveIntegrand& y) {
  using Kind = CurveIntegrand::Kind;
  return y.kind == Kind::curvature || y.kind == Kind::torsion || y.kind == Kind::squared_torsion;
}

/// Halves until the part is good for every integrand, from left to right.
class PartSearch {
 public:
  PartSearch(const ExpressionCurve& curve, const std::vector<CurveIntegrand>& integrands,
             std::optional<long> gap_bits = std::nullopt)
      : curve_(curve),
        integrands_(integrands),
        gap_bits_(gap_bits),
        most_halvings_(least_halvings + gap_bits.value_or(0)),
        found_(integrands.size()) {}

  void cover(const TaylorPart& part) {
    Sought all(integrands_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    cover(part.lower, part.upper, halvings_of(part), all, part.length > guess_length);
  }
  /// Of one integrand, a part that is known to be good.
  void take(const TaylorPart& part) { found_.front().parts.push_back(part); }

  std::vector<TaylorParts> found() { return std::move(found_); }

 private:
  void cover(const Rational& lower, const Rational& upper, long halvings, Sought sought,
             bool is_long);
  Sought left_over(const CurveJet& jet, const TaylorPart& part, const Sought& sought);
  Sought left_over(TaylorPart part, long halvings, Sought sought, bool is_long);

  const ExpressionCurve& curve_;
  const std::vector<CurveIntegrand>& integrands_;
  std::optional<long> gap_bits_;
  long most_halvings_;
  std::vector<TaylorParts> found_;
  bool may_gain_ = false;  ///< may a longer series do for what was left over last?
};

/// For which the part is not good by this jet. What is seen to be as small as a gap is one.
Sought PartSearch::left_over(const CurveJet& jet, const TaylorPart& part, const Sought& sought) {
  Sought rest;
  may_gain_ = false;
  for (const std::size_t k : sought) {
    const bool has_bend = needs_bend(integrands_[k]);
    const long least = has_bend ? least_radius : inner_radius;
    if (!gap_bits_ && has_bend && sign(jet.bend_square().size(least).lower) <= 0) {
      may_gain_ = may_gain_ || jet.bend_square().size().may_gain;
      rest.push_back(k);
      continue;
    }
    const DiscProduct y = integrands_[k](jet);
    auto& parts = found_[k].parts;
    long radius = inner_radius;
    auto bound = bound_on_inner_disc(y);
    while (!bound && radius > least) bound = bound_on_inner_disc(y, --radius);
    if (bound) {
      parts.push_back({part.lower, part.upper, *bound, false, part.length, radius});
      continue;
    }
    const auto size = gap_bits_ ? bound_with_zeros(y) : std::nullopt;
    if (size && exponent_above(*size) + 1 <= -*gap_bits_) {
      parts.push_back({part.lower, part.upper, *size, true, part.length});
      continue;
    }
    may_gain_ = may_gain_ || gap_bits_ || may_gain(y);
    rest.push_back(k);
  }
  return rest;
}

// At a distance d from a zero of |v × r′|², that is about d², and d is about the size of a part:
// what is left out of the series, about 2^(−length), has to be less.
Sought PartSearch::left_over(TaylorPart part, long halvings, Sought sought, bool is_long) {
  constexpr long first_deep = 6;
  const Rational half = (part.upper - part.lower) / 2;
  const Rational middle = part.lower + half;
  const auto bounds = bounds_on_disc(curve_, middle, half);
  if (!bounds) return sought;
  may_gain_ = true;
  const auto look = [&](long length, long bits) {
    part.length = length;
    sought = left_over(CurveJet(curve_, middle, half, *bounds, length, bits), part, sought);
  };
  if (!is_long) look(guess_length, guess_bits);
  if (halvings >= first_deep && !sought.empty() && may_gain_)
    look(guess_length + 2 * halvings, guess_bits + 2 * halvings);
  return sought;
}

void PartSearch::cover(const Rational& lower, const Rational& upper, long halvings, Sought sought,
                       bool is_long) {
  sought.erase(std::remove_if(sought.begin(), sought.end(),
                              [this](std::size_t k) { return found_[k].fault.has_value(); }),
               sought.end());
  if (sought.empty()) return;
  sought = left_over({lower, upper, {}}, halvings, std::move(sought), is_long);
  for (const std::size_t k : sought)
    if (halvings == most_halvings_ || found_[k].parts.size() > most_taylor_parts)
      found_[k].fault = NarrowPart{lower, upper};
  if (sought.empty()) return;
  const Rational middle = (lower + upper) / 2;
  cover(lower, middle, halvings + 1, sought, false);
  cover(middle, upper, halvings + 1, std::move(sought), false);
}

}  // namespace

TaylorParts find_regular_parts(const ExpressionCurve& curve) {
  const std::vector<CurveIntegrand> of{length_rate()};
  PartSearch search(curve, of);
  search.cover({0, 1, {}});
  return std::move(search.found().front());
}

std::vector<TaylorParts> find_parts(const ExpressionCurve& curve,
                                    const std::vector<CurveIntegrand>& integrands,
                                    const std::vector<TaylorPart>& regular) {
  PartSearch search(curve, integrands);
  for (const TaylorPart& part : regular) search.cover(part);
  return search.found();
}

// What is known up to a fault is taken up to the start of the regular part with the fault.
TaylorParts find_parts_with_gaps(const ExpressionCurve& curve, const CurveIntegrand& y,
                                 const std::vector<TaylorPart>& regular, const TaylorParts& known,
                                 long bits) {
  const std::vector<CurveIntegrand> of{y};
  PartSearch search(curve, of, bits);
  auto rest = regular.end();
  if (known.fault)
    rest = std::prev(std::upper_bound(
        regular.begin(), regular.end(), known.fault->lower,
        [](const Rational& at, const TaylorPart& part) { return at < part.lower; }));
  for (const TaylorPart& part : known.parts) {
    if (rest != regular.end() && part.lower >= rest->lower) break;
    part.is_gap ? search.cover(part) : search.take(part);
  }
  std::for_each(rest, regular.end(), [&](const TaylorPart& part) { search.cover(part); });
  return std::move(search.found().front());
}

}  // namespace phrame
