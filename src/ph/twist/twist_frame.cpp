#include "phrame/ph/twist/twist_frame.hpp"

#include <algorithm>
#include <iterator>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/frame/erf_turning.hpp"

namespace phrame::inline v0 {
namespace {

constexpr std::size_t most_pieces = 1000;
constexpr long sign_bits = 80;

Rational nearby(const RealAlgebraic& t, long bits) {
  return t.is_rational() ? *t.rational() : enclose(t, bits + 2).midpoint();
}

/// The points of the kinds asked for, on the whole spline.
std::vector<Rational> special_points(const Path& path, bool inflections, bool extrema, long bits) {
  std::vector<Rational> points;
  if (!inflections && !extrema) return points;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const ErfTurning turning = erf_turning(*ph_curve(path.segments()[k]));
    const auto append = [&](const std::vector<RealRoot>& found) {
      for (const RealRoot& point : odd_inside(found))
        points.push_back(Rational(static_cast<long>(k)) + nearby(point.at, bits));
    };
    if (inflections) append(turning.zeros);
    if (extrema) append(turning.extrema);
  }
  return points;
}

bool is_good(const RationalTwist& twist, const Subdivision& subdivision, const MinimalTwist& mtf) {
  if (subdivision.until_monotone &&
      (twist.extra_turns() != 0 || is_monotone(twist) != Monotone::yes))
    return false;
  if (!subdivision.tolerance) return true;
  const RealBall error =
      relative_error(twist.root_mean_square(), mtf, twist.piece().length).enclose(64);
  return error.is_finite() && error.upper() <= *subdivision.tolerance;
}

}  // namespace

TwistFrame twist_frame(const MinimalTwist& mtf, const RationalTwistOptions& options,
                       const Subdivision& subdivision) {
  require_to_erf(mtf);
  std::vector<Rational> points =
      special_points(mtf.path(), subdivision.at_inflections, subdivision.at_extrema, options.bits);
  points.insert(points.end(), subdivision.at.begin(), subdivision.at.end());
  const bool until_monotone = subdivision.until_monotone;
  const auto special = special_points(mtf.path(), until_monotone, until_monotone, options.bits);

  // Proofs are for the last division only.
  RationalTwistOptions draft = options;
  draft.prove = false;
  const bool is_adaptive = until_monotone || subdivision.tolerance;
  std::vector<TwistPiece> pending = twist_pieces(mtf, points);
  std::reverse(pending.begin(), pending.end());
  std::vector<TwistPiece> settled;
  while (!pending.empty()) {
    const TwistPiece piece = std::move(pending.back());
    pending.pop_back();
    if (!is_adaptive || is_good(best_twist(piece, draft).twist, subdivision, mtf)) {
      settled.push_back(piece);
      continue;
    }
    if (until_monotone && mtf.twist().exact() == Rational(0))
      throw DomainError(
          "the frame turns by 0 in all: whatever the pieces, its rate has both signs");
    std::vector<Rational> inside;
    std::copy_if(special.begin(), special.end(), std::back_inserter(inside),
                 [&](const Rational& t) { return t > piece.from && t < piece.to; });
    if (inside.empty()) inside.push_back((piece.from + piece.to) / 2);
    auto parts = divided(mtf, piece, inside);
    pending.insert(pending.end(), parts.rbegin(), parts.rend());
    if (settled.size() + pending.size() > most_pieces)
      throw Undecided("a frame of " + std::to_string(most_pieces) +
                      " pieces does not do what was asked for");
  }

  TwistFrame frame;
  Stage stage("pieces", settled.size());
  for (const TwistPiece& piece : settled) {
    frame.pieces.push_back(best_twist(piece, options));
    stage.advance();
  }
  return frame;
}

Real value(const TwistFrame& frame, const Real& t) {
  const Rational near = t.exact() ? *t.exact() : t.enclose(128).lower();
  if (near < frame.pieces.front().twist.piece().from || near > frame.pieces.back().twist.piece().to)
    throw DomainError("the parameter " + as_written(near) +
                      " is outside the curve that the frame belongs to");
  const BestTwist* here = &frame.pieces.front();
  for (const BestTwist& piece : frame.pieces)
    if (piece.twist.piece().from <= near) here = &piece;
  const TwistPiece& piece = here->twist.piece();
  const Rational width = piece.to - piece.from;
  return here->twist.value((t + Real(-piece.from)) * Real(1 / width));
}

Monotone is_monotone(const RationalTwist& twist) {
  return is_monotone(twist.inflections(sign_bits));
}

Monotone is_monotone(const SignChanges& changes) {
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

Real relative_error(const Real& error, const MinimalTwist& mtf, const Real& length) {
  const Real whole = error * quotient_of(mtf.length(), length);
  if (mtf.twist().exact() == Rational(0)) return whole;
  return Real([whole, twist = mtf.twist()](long bits) {
    const long precision = bits + 16;
    return divide(whole.enclose(precision), absolute(twist.enclose(precision)), precision);
  });
}

Real root_mean_square(const TwistFrame& frame) {
  // ∫(Ω₁ − Ω̄₁)² ds = Σ G/ΔS.
  return Real([pieces = frame.pieces](long bits) {
    const long precision = bits + 16;
    Rational length = 0;
    RealBall sum;
    for (const BestTwist& piece : pieces) {
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
