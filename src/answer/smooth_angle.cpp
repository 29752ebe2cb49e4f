#include "phrame/answer/smooth_angle.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame {
namespace {

PathAngle angle_for(const Path& path, const SmoothAngleQuery& query) {
  return query.up && query.reference == Reference::up ? PathAngle(path, *query.up)
                                                      : PathAngle(path, query.reference);
}

void add_holonomy(SmoothAngleAnswer& answer, const PathAngle& angle) {
  if (answer.reference == Reference::frenet) return;
  try {
    if (const auto turn = angle.holonomy())
      answer.holonomy = rounded_or_zero(*turn, "holonomy", answer.digits);
  } catch (const Undecided& undecided) {
    answer.no_holonomy = undecided.what();
  }
}

}  // namespace

SmoothAngleAnswer answer(const NamedPath& named, const SmoothAngleQuery& query) {
  const PathAngle angle = angle_for(named.path, query);
  const StartAngle start = phrame::start_angle(query.start, angle);
  const Decimal start_angle = rounded_or_zero(start.value, "theta at t = 0", query.digits);
  SmoothAngleAnswer answer{
      named, query.reference, angle.up(), query.start, start_angle, angle.is_zero(),
      {},    query.digits,    {},         {}};
  const auto theta = [&](const Rational& t) { return angle.value(locate(named.path, t)); };
  for (const Rational& t : query.at)
    answer.values.push_back({t, rounded_or_zero(angle.value(locate(named.path, t), start),
                                                "theta at t = " + as_written(t), query.digits)});
  answer.total = rounded_or_zero(theta(named.path.end()), "the total angle", query.digits);
  add_holonomy(answer, angle);
  answer.is_straight = is_straight(named.path);
  return answer;
}

}  // namespace phrame
