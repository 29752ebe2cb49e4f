#include "phrame/ph/twist_frame.hpp"

#include <algorithm>
#include <set>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/twist_error.hpp"

namespace phrame {
namespace {

constexpr std::size_t most_pieces = 1000;
constexpr long sign_bits = 80;

std::vector<RealAlgebraic> odd_roots(const Polynomial& p) {
  std::vector<RealAlgebraic> at;
  if (p.is_zero()) return at;
  for (const RealRoot& root : real_roots(p, open(0, 1)))
    if (root.order % 2 == 1) at.push_back(root.at);
  return at;
}

Rational nearby(const RealAlgebraic& t, long bits) {
  if (const auto exact = t.rational()) return *exact;
  const RealBall ball = enclose(t, bits + 2);
  return (ball.lower() + ball.upper()) / 2;
}

/// The points of the kinds asked for, on the whole spline.
std::vector<Rational> special_points(const Spline& spline, bool inflections, bool extrema,
                                     long bits) {
  std::vector<Rational> points;
  for (std::size_t k = 0; k < spline.segments().size(); ++k) {
    const Curve& curve = spline.segments()[k];
    const auto append = [&](const std::vector<RealAlgebraic>& at) {
      for (const RealAlgebraic& t : at)
        points.push_back(Rational(static_cast<long>(k)) + nearby(t, bits));
    };
    if (inflections) append(erf_inflections(curve));
    if (extrema) append(erf_extrema(curve));
  }
  return points;
}

/// The root mean square over |T|, or what stands for it where T = 0.
RealBall relative_error(const RationalTwist& twist, const Rational& whole_length) {
  const Real& wanted = twist.piece().twist;
  const RealBall error = twist.root_mean_square().enclose(64);
  if (wanted.exact() == Rational(0))
    return multiply(error, RealBall(Rational(whole_length / twist.piece().length), 64), 64);
  RealBall size;
  arb_abs(size.raw(), wanted.enclose(64).raw());
  return divide(error, size, 64);
}

bool is_good(const RationalTwist& twist, const Subdivision& subdivision,
             const Rational& whole_length) {
  if (subdivision.until_monotone &&
      (twist.extra_turns() != 0 || is_monotone(twist) != Monotone::yes))
    return false;
  if (!subdivision.tolerance) return true;
  const RealBall error = relative_error(twist, whole_length);
  return error.is_finite() && error.upper() <= *subdivision.tolerance;
}

}  // namespace

std::vector<RealAlgebraic> erf_inflections(const Curve& curve) {
  return odd_roots(twist_numerator(curve.preimage()));
}

std::vector<RealAlgebraic> erf_extrema(const Curve& curve) {
  const Polynomial s = sigma(curve.preimage());
  const RationalFunction rate(twist_numerator(curve.preimage()), curve.multiplier() * s * s);
  return odd_roots(differentiate(rate).numerator());
}

std::string_view to_string(Monotone monotone) {
  return monotone == Monotone::yes ? "yes" : monotone == Monotone::no ? "no" : "undecided";
}

TwistFrame twist_frame(const MinimalTwist& mtf, const RationalTwistOptions& options,
                       const Subdivision& subdivision) {
  std::vector<Rational> points = special_points(mtf.spline(), subdivision.at_inflections,
                                                subdivision.at_extrema, options.bits);
  points.insert(points.end(), subdivision.at.begin(), subdivision.at.end());
  std::vector<Rational> special;
  if (subdivision.until_monotone) special = special_points(mtf.spline(), true, true, options.bits);

  // Proofs are for the last division only.
  RationalTwistOptions draft = options;
  draft.prove = false;
  const bool is_adaptive = subdivision.until_monotone || subdivision.tolerance;
  std::set<std::pair<Rational, Rational>> good;
  while (is_adaptive) {
    std::vector<Rational> more;
    for (const TwistPiece& piece : twist_pieces(mtf, points)) {
      const std::pair ends(piece.from, piece.to);
      if (good.contains(ends)) continue;
      if (is_good(best_twist(piece, draft).twist, subdivision, mtf.length())) {
        good.insert(ends);
        continue;
      }
      const std::size_t before = more.size();
      std::copy_if(special.begin(), special.end(), std::back_inserter(more),
                   [&](const Rational& t) { return t > piece.from && t < piece.to; });
      if (more.size() == before) more.push_back((piece.from + piece.to) / 2);
    }
    if (more.empty()) break;
    if (subdivision.until_monotone && mtf.twist().exact() == Rational(0))
      throw DomainError(
          "the frame turns by 0 in all: whatever the pieces, its rate has both signs");
    points.insert(points.end(), more.begin(), more.end());
    if (points.size() > most_pieces)
      throw Undecided("a frame of " + std::to_string(most_pieces) +
                      " pieces does not do what was asked for");
  }

  TwistFrame frame;
  for (const TwistPiece& piece : twist_pieces(mtf, points))
    frame.pieces.push_back(best_twist(piece, options));
  return frame;
}

Real value(const TwistFrame& frame, const Real& t) {
  const Rational near = t.exact() ? *t.exact() : t.enclose(128).lower();
  if (near < frame.pieces.front().twist.piece().from || near > frame.pieces.back().twist.piece().to)
    throw DomainError("the parameter " + abbreviated(to_string(near)) +
                      " is outside the curve that the frame belongs to");
  const BestTwist* here = &frame.pieces.front();
  for (const BestTwist& piece : frame.pieces)
    if (piece.twist.piece().from <= near) here = &piece;
  const TwistPiece& piece = here->twist.piece();
  const Rational width = piece.to - piece.from;
  return here->twist.value((t + Real(-piece.from)) * Real(1 / width));
}

Monotone is_monotone(const RationalTwist& twist) {
  const SignChanges changes = twist.inflections(sign_bits);
  if (!changes.at.empty()) return Monotone::no;
  return changes.is_complete() ? Monotone::yes : Monotone::undecided;
}

Monotone is_monotone(const TwistFrame& frame) {
  Monotone all = Monotone::yes;
  int sign = 0;
  for (const BestTwist& piece : frame.pieces) {
    const Monotone here = is_monotone(piece.twist);
    if (here == Monotone::no) return Monotone::no;
    if (here == Monotone::undecided) all = Monotone::undecided;
    const int direction = piece.twist.sign_of_rate(Rational(1, 2));
    if (sign * direction < 0) return Monotone::no;
    if (direction != 0) sign = direction;
  }
  return all;
}

Real root_mean_square(const TwistFrame& frame) {
  // ∫(Ω₁ − Ω̄₁)² ds = Σ G/ΔS.
  return Real([&frame](long bits) {
    const long precision = bits + 16;
    Rational length = 0;
    RealBall sum;
    for (const BestTwist& piece : frame.pieces) {
      const RealBall error = piece.twist.root_mean_square().enclose(precision);
      length += piece.twist.piece().length;
      sum = add(sum,
                multiply(multiply(error, error, precision),
                         RealBall(Rational(1 / piece.twist.piece().length), precision), precision),
                precision);
    }
    return sqrt(multiply(sum, RealBall(length, precision), precision), precision);
  });
}

}  // namespace phrame
