#include "phrame/answer/path_twist.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/answer/rounded.hpp"

namespace phrame::inline v0 {

PathTwistAnswer answer(const NamedPath& named, const PathTwistQuery& query) {
  if (!named.frame) throw DomainError("no orientations come with this path");
  const PathAngle angle = angle_to(query.up, named.path);
  const PathTwist twist(angle, *named.frame);
  const auto decimal = [&](const Real& x, const std::string& what) {
    return rounded_or_zero(x, what, query.digits);
  };
  PathTwistAnswer answer{named,
                         {},
                         decimal(PathLength(named.path).total(), "the length"),
                         decimal(twist.turn_after(twist.legs().size() - 1), "the twist"),
                         decimal(twist.squared_rate(), "the integral of the squared rate"),
                         decimal(twist.squared_slope(), "the integral of the squared slope"),
                         {},
                         query.digits};
  if (angle.reference() == Reference::up) answer.up = angle.up();
  Stage stage("legs", twist.legs().size());
  for (std::size_t k = 0; k < twist.legs().size(); ++k, stage.advance()) {
    const PathTwist::Leg& leg = twist.legs()[k];
    const std::string of = fmt::format(" of leg {}", k + 1);
    const auto& within = leg.twist.half_turn_within();
    answer.legs.push_back({leg.first, leg.end(), decimal(leg.twist.length(), "the length" + of),
                           decimal(leg.twist.twist(), "the twist" + of),
                           decimal(twist.rate_at_start(k), "the rate at the start" + of),
                           decimal(twist.rate_at_end(k), "the rate at the end" + of),
                           within ? upper_bound_text(*within) : ""});
  }
  answer.by = query.by;
  answer.values = angle_values(
      named, {query.at, query.by, query.samples, query.digits},
      [&](const Place& at) { return twist.value(at); }, decimal);
  return answer;
}

}  // namespace phrame
