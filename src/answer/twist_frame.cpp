#include "phrame/answer/twist_frame.hpp"

#include <algorithm>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/answer/rounded.hpp"

namespace phrame::inline v0 {
namespace {

/// The parameter of the curve at an inflection of a piece.
Real inflection_at(const RationalTwist& twist, const RealBall& found) {
  return Real([twist, found](long bits) {
    const long precision = bits + 32;
    const auto& narrow = twist.inflections(precision).at;
    const auto same = std::find_if(narrow.begin(), narrow.end(),
                                   [&](const RealBall& tau) { return tau.overlaps(found); });
    const TwistPiece& piece = twist.piece();
    const RealBall width(piece.to - piece.from, precision);
    return add(RealBall(piece.from, precision),
               multiply(width, same == narrow.end() ? found : *same, precision), precision);
  });
}

constexpr long few = 6;  // digits of what is only guessed, and in a table

TwistPieceAnswer rounded_piece(const MinimalTwist& mtf, const BestTwist& best, long digits) {
  const RationalTwist& twist = best.twist;
  const TwistPiece& piece = twist.piece();
  const auto decimal = [digits](const Real& x, const std::string& what) {
    return rounded(x, what, digits);
  };
  const auto& [index, t] = locate_inside(mtf.path().segments().size(), piece.from);
  const auto size = [&](const Real& x, const std::string& what, long to_digits) {
    return error_size(relative_error(x, mtf, piece.length), what, to_digits);
  };
  const Real gamma = cached(twist.end_factor());
  const SignChanges inflections = twist.inflections(4 * digits + 64);
  TwistPieceAnswer answer{
      piece.from,
      piece.to,
      2 * preimage_degree(*ph_curve(mtf.path().segments()[index])) + 2 * twist.degree(),
      twist.degree(),
      decimal(gamma, "gamma"),
      rounded(gamma, "gamma", few).value,
      {},
      best.doubt,
      {},
      twist.extra_turns(),
      size(twist.root_mean_square(), "the root mean square", digits),
      size(twist.greatest_error(), "the greatest error", digits),
      is_monotone(inflections),
      {},
      {}};
  if (best.minimum) {
    const Rational& radius = best.minimum->radius;
    answer.proved = {{upper_bound_text(radius), upper_bound_text(twist.end_factor_change(radius)),
                      !best.minimum->is_for_both_signs}};
  }
  for (const auto& [re, im] : twist.coefficients())
    answer.coefficients.emplace_back(rounded_or_zero(re, "a coefficient of w", digits),
                                     rounded_or_zero(im, "a coefficient of w", digits));
  for (const RealBall& tau : inflections.at)
    answer.inflections.push_back(decimal(inflection_at(twist, tau), "an inflection"));
  if (best.other) {  // only a guess is known
    const long known = std::min(digits, few);
    answer.other = {rounded(best.other->end_factor(), "gamma", known),
                    size(best.other->root_mean_square(), "the root mean square", known)};
  }
  return answer;
}

}  // namespace

TwistFrameAnswer rounded(const TwistFrame& frame, const MinimalTwist& mtf, long digits) {
  TwistFrameAnswer answer{{},
                          error_size(relative_error(root_mean_square(frame), mtf, mtf.length()),
                                     "the root mean square", digits),
                          Monotone::undecided,
                          mtf.twist().exact() != Rational(0)};
  for (const BestTwist& piece : frame.pieces)
    answer.pieces.push_back(rounded_piece(mtf, piece, digits));
  answer.monotone = is_monotone(frame);  // by the inflections of the pieces, known now
  return answer;
}

}  // namespace phrame
