#include "phrame/answer/minimal_twist.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"

namespace phrame::inline v0 {
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

MinimalTwistAnswer answer(const NamedPath& named, const MinimalTwistQuery& query) {
  const PathAngle angle = angle_to(query.up, named.path);
  const MinimalTwist mtf = minimal_twist(angle, query.from, query.to, query.extra_turns);
  const bool is_to_erf = angle.reference() == Reference::euler_rodrigues;
  const auto decimal = [&](const Real& x, const std::string& what) {
    return is_to_erf ? rounded(x, what, query.digits) : rounded_or_zero(x, what, query.digits);
  };
  MinimalTwistAnswer answer{
      named,
      query.from,
      query.to,
      decimal(mtf.from().value, "the angle at the start"),
      decimal(mtf.to().value, "the angle at the end"),
      mtf.length(),
      mtf.length().exact() ? Decimal() : decimal(mtf.length(), "the length"),
      decimal(mtf.own_twist(),
              is_to_erf ? "the twist of the Euler-Rodrigues frame" : "the twist of the frame of v"),
      decimal(mtf.nominal_twist(), "the nominal twist"),
      decimal(mtf.twist(), "the twist"),
      decimal(mtf.rate(), "the rate"),
      {},
      query.digits};
  if (!is_to_erf) answer.up = angle.up();
  if (const auto& within = mtf.half_turn_within())
    answer.half_turn_within = upper_bound_text(*within);
  answer.by = query.by;
  answer.values = angle_values(
      named, {query.at, query.by, query.samples, query.digits},
      [&](const Place& at) { return mtf.value(at); }, decimal);
  if (query.rational) add_rational(answer, mtf, *query.rational);
  return answer;
}

}  // namespace phrame
