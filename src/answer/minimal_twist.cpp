#include "phrame/answer/minimal_twist.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/twist/smooth_twist.hpp"

namespace phrame {
namespace {

/// The rational frame, or, unless it is needed, why there is none, or none was found.
void add_rational(MinimalTwistAnswer& answer, const MinimalTwist& mtf,
                  const MinimalTwistQuery::RationalFrame& wanted) {
  const auto make = [&] {
    const TwistFrame frame = twist_frame(mtf, wanted.rotation, wanted.subdivision);
    answer.rational = rounded(frame, mtf, answer.digits);
  };
  if (wanted.is_needed) return make();
  try {
    make();
  } catch (const DomainError& error) {
    answer.why_not_rational = error.what();
  } catch (const Undecided& error) {
    answer.why_undecided = error.what();
  }
}

}  // namespace

MinimalTwistAnswer answer(const NamedPhPath& named, const MinimalTwistQuery& query) {
  const MinimalTwist mtf(PathAngle(named.path), query.from, query.to, query.extra_turns);
  const auto decimal = [&query](const Real& x, const std::string& what) {
    return rounded(x, what, query.digits);
  };
  MinimalTwistAnswer answer{named,
                            decimal(to_real(query.from), "the angle at the start"),
                            decimal(to_real(query.to), "the angle at the end"),
                            mtf.length(),
                            {},
                            decimal(mtf.erf_twist(), "the twist of the Euler-Rodrigues frame"),
                            decimal(mtf.nominal_twist(), "the nominal twist"),
                            decimal(mtf.twist(), "the twist"),
                            decimal(mtf.rate(), "the rate"),
                            {},
                            query.digits};
  if (const auto& within = mtf.half_turn_within())
    answer.half_turn_within = upper_bound_text(*within);
  for (const Rational& t : query.at)
    answer.values.push_back(rounded_angle(t, mtf.value(t), query.digits));
  if (query.rational) add_rational(answer, mtf, *query.rational);
  return answer;
}

MinimalTwistAnswer answer(const NamedPath& named, const SmoothTwistQuery& query) {
  const PathAngle angle =
      query.up ? PathAngle(named.path, *query.up) : PathAngle(named.path, Reference::up);
  const SmoothTwist mtf(angle, query.from, query.to, query.extra_turns);
  const auto decimal = [&query](const Real& x, const std::string& what) {
    return rounded_or_zero(x, what, query.digits);
  };
  MinimalTwistAnswer answer{named,
                            decimal(mtf.from(), "the angle at the start"),
                            decimal(mtf.to(), "the angle at the end"),
                            mtf.length(),
                            decimal(mtf.length(), "the length"),
                            decimal(mtf.up_twist(), "the twist of the frame of v"),
                            decimal(mtf.nominal_twist(), "the nominal twist"),
                            decimal(mtf.twist(), "the twist"),
                            decimal(mtf.rate(), "the rate"),
                            {},
                            query.digits};
  answer.up = angle.up();
  if (const auto& within = mtf.half_turn_within())
    answer.half_turn_within = upper_bound_text(*within);
  for (const Rational& t : query.at)
    answer.values.push_back(
        {t, decimal(mtf.value(locate(named.path, t)), "theta at t = " + as_written(t))});
  return answer;
}

}  // namespace phrame
