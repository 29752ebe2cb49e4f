#include "phrame/answer/wronskian.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/twist/frame_angle_error.hpp"
#include "phrame/ph/twist/rational_twist.hpp"
#include "phrame/ph/twist/twist_error.hpp"
#include "phrame/ph/twist/wronskian_frame.hpp"

namespace phrame::inline v0 {
namespace {

void add_rates(WronskianAnswer& answer, const Curve& curve) {
  try {
    const TwistPiece piece = untwisted_piece(curve);
    const Polynomial common = gcd(answer.pair.a, answer.pair.b);
    const Real here = root_mean_square(piece, exact_quotient(answer.pair.b, common),
                                       exact_quotient(answer.pair.a, common));
    const BestTwist least = best_twist(
        piece, {answer.planes.degree, EndRates::free, false, answer.digits * 10 / 3 + 16});
    answer.rates = {
        error_size(here, "the root mean square", answer.digits),
        error_size(least.twist.root_mean_square(), "the least root mean square", answer.digits)};
  } catch (const DomainError& error) {
    answer.why_no_rates = error.what();
  } catch (const Undecided& error) {
    answer.why_no_rates = error.what();
  }
}

}  // namespace

WronskianAnswer answer(const NamedPhPath& named, const WronskianQuery& query) {
  if (!named.path.is_curve())
    throw DomainError("pairs of polynomials are for single curves; this is a spline");
  const WronskianFrame frame(named.path.segments().front(), query.weight);
  const long digits = query.digits;
  const auto list = [digits](const std::vector<Real>& numbers, const std::string& what) {
    std::vector<Decimal> decimals;
    for (const Real& x : numbers) decimals.push_back(rounded_or_zero(x, what, digits));
    return decimals;
  };
  const RationalPair pair = frame.rounded(digits * 10 / 3 + 16);
  const QuaternionPolynomial& preimage = frame.curve().preimage();
  const FrameAngleError error = frame_angle_error(preimage, pair.a, pair.b);
  const auto form = frame.form(frame.best());
  WronskianAnswer answer{
      named,
      query.weight,
      frame.wronskian(),
      frame.planes(),
      {},
      frame.best(),
      rounded_or_zero(frame.multiplier(frame.best()), "the multiplier", digits),
      list({form.begin(), form.end()}, "a coefficient of a² + b²"),
      list(frame.a(), "a coefficient of a"),
      list(frame.b(), "a coefficient of b"),
      pair,
      2 * (preimage_degree(frame.curve()) + frame.planes().degree - gcd(pair.a, pair.b).degree()),
      error_size(error.greatest, "the greatest error of the angle", digits),
      rounded_or_zero(error.at_end, "the error of the angle at the end", digits),
      {},
      {},
      digits};
  for (std::size_t k = 0; k < frame.planes().real.size(); ++k)
    answer.real.push_back({frame.planes().real[k], error_size(frame.value(k), "J", digits),
                           frame.critical_points(k), frame.is_tied(k)});
  add_rates(answer, frame.curve());
  return answer;
}

}  // namespace phrame
