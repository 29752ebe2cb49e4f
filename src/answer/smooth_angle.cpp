#include "phrame/answer/smooth_angle.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/frame/smooth_frame.hpp"

namespace phrame {
namespace {

SmoothAngle angle_for(const Path& path, const SmoothAngleQuery& query) {
  if (query.reference == SmoothReference::frenet) return {path, query.reference};
  return query.up ? SmoothAngle(path, *query.up) : SmoothAngle(path);
}

void add_holonomy(SmoothAngleAnswer& answer, const SmoothAngle& angle) {
  if (answer.reference == SmoothReference::frenet) return;
  try {
    if (const auto turn = holonomy(angle))
      answer.holonomy = rounded_or_zero(*turn, "holonomy", answer.digits);
  } catch (const Undecided& undecided) {
    answer.no_holonomy = undecided.what();
  }
}

}  // namespace

SmoothAngleAnswer answer(const NamedPath& named, const SmoothAngleQuery& query) {
  const SmoothAngle angle = angle_for(named.path, query);
  const Real start = phrame::start_angle(query.start, angle);
  const Decimal start_angle = rounded_or_zero(start, "theta at t = 0", query.digits);
  SmoothAngleAnswer answer{
      named, query.reference, angle.up(), query.start, start_angle, angle.is_zero(),
      {},    query.digits,    {},         {}};
  const auto theta = [&](const Rational& t) { return angle.value(locate(named.path, t)); };
  for (const Rational& t : query.at)
    answer.values.push_back(
        {t, rounded_or_zero(theta(t) + start, "theta at t = " + as_written(t), query.digits)});
  answer.total = rounded_or_zero(theta(named.path.end()), "the total angle", query.digits);
  add_holonomy(answer, angle);
  answer.is_straight = is_straight(named.path);
  return answer;
}

}  // namespace phrame
