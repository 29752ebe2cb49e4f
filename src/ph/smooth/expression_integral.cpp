#include "phrame/ph/smooth/expression_integral.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"

// On a part of length 2h around c, with z = (t − c)/h, the integrand is y dt = y_z dz, y_z made of
// derivatives by z. Its factors are bounded from below on |z| ≤ 4 by the coefficients of their
// Taylor series and, for what is left out of these, by Cauchy's estimate on |z| ≤ 8, where balls
// enclose the derivatives of r. With |y_z| ≤ M on |z| ≤ 4, its coefficients are at most M/4ᵏ, so
// that the integral of what is left out is at most M/4ⁿ · Σ 4⁻ᵏ/(n + 1) up to |z| = 1.

namespace phrame {
namespace {

constexpr long guess_bits = 64;
constexpr long guess_length = 16;
constexpr long least_halvings = 40;
constexpr std::size_t most_parts = 20'000;

/// A number that |z| does not exceed, exactly.
RealBall size_above(const ComplexBall& z) {
  const RealBall size = absolute(z, guess_bits);
  return subtract({}, lower_end(subtract({}, size, guess_bits), guess_bits), guess_bits);
}

BallPolynomial shortened_series(const BallPolynomial& p, long length) {
  std::vector<RealBall> coefficients;
  for (long k = 0; k < length; ++k) coefficients.push_back(p.coefficient(k));
  return BallPolynomial(coefficients);
}

/// |r′|, |r″| and |r‴| on |z| ≤ 8, component by component.
using DiscBounds = std::array<Vector<RealBall>, 3>;

/// No value where r is not seen to be analytic there.
std::optional<DiscBounds> bounds_on_disc(const ExpressionCurve& curve, const Rational& middle,
                                         const Rational& half) {
  const Rational radius = half * Rational(outer_radius);
  const RealBall around = widened(RealBall(), RealBall(radius, guess_bits));
  const ComplexBall disc(add(RealBall(middle, guess_bits), around, guess_bits), around);
  const Vector<ComplexSeries> r = curve.series(disc, half, 4, guess_bits);
  DiscBounds bounds;
  for (long order = 1; order <= 3; ++order)
    for (std::size_t k = 0; k < 3; ++k) {
      const RealBall size = size_above(r[k].coefficient(order));
      if (!size.is_finite()) return std::nullopt;
      const long factorial = order == 3 ? 6 : order;
      bounds[static_cast<std::size_t>(order - 1)][k] =
          multiply(RealBall(factorial, guess_bits), size, guess_bits);
    }
  return bounds;
}

CurveJet jet_around(const ExpressionCurve& curve, const RealBall& middle, const Rational& half,
                    const DiscBounds& bounds, long length, long bits) {
  const Vector<BallPolynomial> r = curve.series(middle, half, length + 3, bits);
  CurveJet jet;
  for (std::size_t k = 0; k < 3; ++k) {
    const BallPolynomial first = differentiate(r[k], bits);
    const BallPolynomial second = differentiate(first, bits);
    jet.first[k] = {shortened_series(first, length), bounds[0][k], length, bits};
    jet.second[k] = {shortened_series(second, length), bounds[1][k], length, bits};
    jet.third[k] = {differentiate(second, bits), bounds[2][k], length, bits};
  }
  jet.middle = middle;
  jet.half = half;
  return jet;
}

/// |r′·r′| is at least the least number of it on |z| ≤ 8, where that is > 0: on the inner disc of
/// the jet of twice the size, where r′ by z is half as long.
RealBall least_square(const ExpressionCurve& curve, const Rational& middle, const Rational& half,
                      long length) {
  static_assert(outer_radius == 2 * inner_radius);
  const auto bounds = bounds_on_disc(curve, middle, 2 * half);
  if (!bounds) return {};
  const RealBall at(middle, guess_bits);
  const CurveJet wide = jet_around(curve, at, 2 * half, *bounds, length, guess_bits);
  const RealBall least = size_bounds(dot(wide.first, wide.first)).lower;
  return times_power_of_two(lower_end(least, guess_bits), -2);
}

/// Halves until every part is good, from left to right.
class PartSearch {
 public:
  PartSearch(const ExpressionCurve& curve, const CurveIntegrand& integrand,
             std::optional<long> gap_bits)
      : curve_(curve),
        integrand_(integrand),
        gap_bits_(gap_bits),
        most_halvings_(gap_bits ? *gap_bits + least_halvings : least_halvings) {}

  TaylorParts run() {
    cover(0, 1, 0);
    return std::move(found_);
  }

 private:
  /// By so many coefficients. What is seen to be as small as a gap is one.
  bool is_good(const Rational& lower, const Rational& upper, long length, long bits) {
    const Rational half = (upper - lower) / 2;
    const Rational middle = lower + half;
    const auto jet = curve_jet(curve_, middle, half, length, bits);
    if (!jet) return false;
    const DiscProduct y = integrand_(*jet);
    if (const auto bound = bound_on_inner_disc(y)) {
      found_.parts.push_back({lower, upper, *bound});
      return true;
    }
    if (!gap_bits_) return false;
    const auto bound = bound_with_zeros(y);
    if (!bound || exponent_above(*bound) + 1 > -*gap_bits_) return false;
    found_.parts.push_back({lower, upper, *bound, true});
    return true;
  }

  // At a distance d from a zero of |v × r′|², that is about d², and d is about the size of a part:
  // what is left out of the series, about 2^(−length), has to be less.
  bool is_good(const Rational& lower, const Rational& upper, long halvings) {
    if (is_good(lower, upper, guess_length, guess_bits)) return true;
    constexpr long first_deep = 6;
    return halvings >= first_deep &&
           is_good(lower, upper, guess_length + 2 * halvings, guess_bits + 2 * halvings);
  }

  bool cover(const Rational& lower, const Rational& upper, long halvings) {
    if (is_good(lower, upper, halvings)) return true;
    if (halvings == most_halvings_ || found_.parts.size() > most_parts) {
      found_.fault = NarrowPart{lower, upper};
      return false;
    }
    const Rational middle = (lower + upper) / 2;
    return cover(lower, middle, halvings + 1) && cover(middle, upper, halvings + 1);
  }

  const ExpressionCurve& curve_;
  const CurveIntegrand& integrand_;
  std::optional<long> gap_bits_;
  long most_halvings_;
  TaylorParts found_;
};

}  // namespace

DiscFunction parameter_of(const CurveJet& jet) {
  const auto& [series, bound, length, bits] = jet.first[0];
  std::vector<RealBall> t{jet.middle};
  if (length > 1) t.emplace_back(jet.half, bits);
  const RealBall reach(abs(jet.half) * Rational(outer_radius), guess_bits);
  return {BallPolynomial(t), add(absolute(jet.middle), reach, guess_bits), length, bits};
}

// On the disc, where r′·r′ has no zero, a branch of its root is analytic.
DiscFunction inverse_speed(const CurveJet& jet) {
  const DiscFunction square = dot(jet.first, jet.first);
  const RealBall bound = jet.least_square ? divide(RealBall(1, guess_bits),
                                                   sqrt(jet.least_square(), guess_bits), guess_bits)
                                          : RealBall();
  return {inverse_sqrt_series(square.series, square.length, square.bits), bound, square.length,
          square.bits};
}

std::optional<CurveJet> curve_jet(const ExpressionCurve& curve, const Rational& middle,
                                  const Rational& half, long length, long bits) {
  const auto bounds = bounds_on_disc(curve, middle, half);
  if (!bounds) return std::nullopt;
  CurveJet jet = jet_around(curve, RealBall(middle, bits), half, *bounds, length, bits);
  jet.least_square = [&curve, middle, half, length] {
    return least_square(curve, middle, half, length);
  };
  return jet;
}

TaylorParts taylor_parts(const ExpressionCurve& curve, const CurveIntegrand& integrand) {
  return PartSearch(curve, integrand, std::nullopt).run();
}

TaylorParts taylor_parts_with_gaps(const ExpressionCurve& curve, const CurveIntegrand& integrand,
                                   long bits) {
  return PartSearch(curve, integrand, bits).run();
}

std::vector<TaylorPart> regular_parts(const ExpressionCurve& curve) {
  TaylorParts found = taylor_parts(curve, [](const CurveJet& jet) {
    const DiscFunction one = constant_like(jet.first[0], 1);
    return DiscProduct{one, {{dot(jet.first, jet.first), 1}}};
  });
  if (!found.fault) return std::move(found.parts);
  refuse_part(curve, *found.fault);
}

struct ExpressionIntegral::State {
  /// ∫ y from the middle of a part, a polynomial in z, and how far it is from the truth at most.
  struct Piece {
    BallPolynomial antiderivative;
    RealBall start;  ///< its value at z = −1
    RealBall error;
  };

  ExpressionCurve curve;
  CurveIntegrand integrand;
  std::vector<TaylorPart> parts;
  bool has_gaps = false;

  std::mutex lock;
  long bits = 0;  ///< of what follows
  std::vector<std::optional<Piece>> pieces;
  std::vector<RealBall> sums;  ///< ∫ up to the start of part 0, 1, …, as far as known

  Piece make_piece(const TaylorPart& part) const;
  const Piece& piece(std::size_t k) {
    if (!pieces[k]) pieces[k] = make_piece(parts[k]);
    return *pieces[k];
  }
  RealBall up_to(const Piece& of, const RealBall& z) const {
    const RealBall value = subtract(evaluate(of.antiderivative, z, bits), of.start, bits);
    return widened(value, of.error);
  }
  RealBall value(const Rational& t);
  void refine(long to_bits);
  /// refine() and value(). Where these are interrupted, nothing is kept: another question may be
  /// about fewer bits.
  RealBall value(const Rational& t, long at_least);
};

void ExpressionIntegral::State::refine(long to_bits) {
  if (has_gaps) {
    TaylorParts found = taylor_parts_with_gaps(curve, integrand, to_bits);
    if (found.fault)
      throw Undecided(fmt::format("integral: {} bits of it take too many parts near t = {:.9g}",
                                  to_bits, static_cast<double>(found.fault->lower)));
    parts = std::move(found.parts);
  }
  bits = to_bits;
  pieces.assign(parts.size(), std::nullopt);
  sums.assign(1, RealBall());
}

ExpressionIntegral::State::Piece ExpressionIntegral::State::make_piece(
    const TaylorPart& part) const {
  if (part.is_gap) return {{}, {}, times_power_of_two(part.bound, 1)};
  const long above = std::max(exponent_above(part.bound), 0L);
  const long length = (bits + above) / 2 + 2;
  const Rational half = (part.upper - part.lower) / 2;
  const RealBall middle(part.lower + half, bits + above);
  const CurveJet jet = jet_around(curve, middle, half, {}, length, bits + above);
  Piece piece;
  piece.antiderivative = antiderivative(series(integrand(jet)), bits + above);
  piece.start = evaluate(piece.antiderivative, RealBall(-1, bits), bits);
  // Both ends, 2/(1 − 1/4) < 4.
  piece.error = times_power_of_two(multiply(part.bound, RealBall(4, 64), 64), -2 * length);
  return piece;
}

RealBall ExpressionIntegral::State::value(const Rational& t) {
  const auto next =
      std::upper_bound(parts.begin(), parts.end(), t,
                       [](const Rational& at, const TaylorPart& part) { return at < part.lower; });
  const auto k = static_cast<std::size_t>(next - parts.begin()) - 1;
  while (sums.size() <= k)
    sums.push_back(add(sums.back(), up_to(piece(sums.size() - 1), RealBall(1, bits)), bits));
  const TaylorPart& part = parts[k];
  const Rational z = (Rational(2) * t - part.lower - part.upper) / (part.upper - part.lower);
  return add(sums[k], up_to(piece(k), RealBall(z, bits)), bits);
}

RealBall ExpressionIntegral::State::value(const Rational& t, long at_least) {
  try {
    if (bits < at_least) refine(at_least);
    return value(t);
  } catch (...) {
    bits = 0;
    throw;
  }
}

ExpressionIntegral::ExpressionIntegral(const ExpressionCurve& curve, CurveIntegrand integrand,
                                       std::vector<TaylorPart> parts)
    : state_(new State{curve, std::move(integrand), std::move(parts), false, {}, 0, {}, {}}) {}

ExpressionIntegral::ExpressionIntegral(const ExpressionCurve& curve, CurveIntegrand integrand)
    : state_(new State{curve, std::move(integrand), {}, true, {}, 0, {}, {}}) {}

RealBall ExpressionIntegral::enclose(const Rational& t, long bits) const {
  const std::lock_guard guard(state_->lock);
  const RealBall wanted = times_power_of_two(RealBall(1, 2), -bits);
  const long least = bits + 20 + static_cast<long>(std::log2(state_->parts.size() + 1));
  RealBall value = state_->value(t, least);
  for (int more = 0; more < 3 && !is_at_most(radius_of(value), wanted); ++more)
    value = state_->value(t, state_->bits + (32L << more));
  return value;
}

// F(t) is F(m) + (t − m)·F′ somewhere between m and t.
RealBall ExpressionIntegral::enclose(const RealBall& t, long bits) const {
  const Rational lower = std::clamp(t.lower(), Rational(0), Rational(1));
  const Rational upper = std::clamp(t.upper(), Rational(0), Rational(1));
  const Rational middle = (lower + upper) / 2;
  const RealBall value = enclose(middle, bits);
  if (lower == upper) return value;
  const RealBall all = hull(lower, upper, bits + 8);
  return add_product(value, subtract(all, RealBall(middle, bits + 8), bits), rate(all, bits), bits);
}

RealBall ExpressionIntegral::rate(const RealBall& t, long bits) const {
  return series(state_->integrand(jet_around(state_->curve, t, 1, {}, 1, bits))).coefficient(0);
}

}  // namespace phrame
