#include "phrame/answer/sweep.hpp"

#include <cmath>
#include <numbers>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/end_normal.hpp"
#include "phrame/answer/sweep_stream.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/sweep/sweep_section.hpp"
#include "phrame/ph/sweep/sweep_stream.hpp"
#include "phrame/ph/twist/path_twist.hpp"

namespace phrame::inline v0 {
namespace {

/// The angle from the last frame to f₂ along v, in (−π, π].
double angle_to(const Vector<double>& v, const Frame<double>& last) {
  const double x = dot(v, last.e2);
  const double y = dot(v, last.e3);
  if (std::hypot(x, y) <= 0x1p-40 * std::hypot(v[0], v[1], v[2]))
    throw DomainError("end normal: it has no part in the normal plane at the end");
  // Half a turn is as short both ways, and rounding is not to say which.
  const double angle = std::atan2(y, x);
  return angle < 0x1p-44 - std::numbers::pi ? angle + 2 * std::numbers::pi : angle;
}

/// Orientations close a body where the last of them is the first.
double turn_of(const SweepPath& path, const SweepQuery& query) {
  const Frame<double> last = frame_at_end(path);
  const double twist = round_to_double(to_real(FrameAngle(query.twist)));
  if (!path.is_closed)
    return twist + (query.end_normal ? angle_to(round_to_double(*query.end_normal), last) : 0);
  require_open(query.end_normal, true);
  const bool is_whole = query.twist.radians == 0 && denominator(query.twist.half_turns / 2) == 1;
  if (!is_whole) throw DomainError("twist: the path is closed, only whole turns close the body");
  if (query.scale.at_start() != query.scale.at(Rational(static_cast<long>(path.series.segments))))
    throw DomainError("scale: the path is closed, and the scale differs at its ends");
  const std::size_t segments = path.series.segments;
  const Angle roll_at_start = query.roll.at(PathParameter{0, 0});
  const Angle roll_at_end = query.roll.at(PathParameter{segments - 1, 1});
  if (roll_at_start.radians != roll_at_end.radians ||
      denominator(Rational((roll_at_end.half_turns - roll_at_start.half_turns) / 2)) != 1)
    throw DomainError("roll: the path is closed, and the roll differs at its ends");
  if (!query.through) return twist + angle_to(path.frames(0).e2, last);
  if (query.through->joints.front().f2 != query.through->joints.back().f2)
    throw DomainError("the path is closed, and the orientations differ at its ends");
  return twist;
}

/// How the profile turns from one of the orientations to the next.
std::vector<SweepLeg> legs_of(const PathTwist& twist) {
  std::vector<SweepLeg> legs;
  for (std::size_t k = 0; k < twist.legs().size(); ++k) {
    const auto& leg = twist.legs()[k];
    legs.push_back({leg.end(), round_to_double(leg.twist.twist())});
    if (!twist.is_smooth()) continue;
    const Real even = leg.twist.rate();
    legs.back().rate_at_start = approximate((twist.rate_at_start(k) + -even).enclose(96));
    legs.back().rate_at_end = approximate((twist.rate_at_end(k) + -even).enclose(96));
  }
  return legs;
}

/// Not above it.
std::optional<double> normal_tolerance_of(const SweepQuery& query) {
  if (!query.normal_tolerance) return std::nullopt;
  if (std::holds_alternative<long>(query.tolerance_or_sections))
    throw DomainError("normal tolerance: so many sections have no bound of their normals");
  const double angle = round_to_double(to_real(FrameAngle(*query.normal_tolerance)));
  if (!(angle > 0 && angle <= 1.57))
    throw DomainError("normal tolerance: " + to_string(*query.normal_tolerance) +
                      " is not between 0 and pi/2");
  return angle * (1 - 0x1p-50);
}

/// By sweep_as(path, form), one of the ways of sweep().
template <class SweepAs>
SweepAnswer swept(const SweepPath& path, const SweepQuery& query, std::vector<SweepLeg> legs,
                  SweepAs sweep_as) {
  query.scale.require_along(path.series.segments);
  query.roll.require_along(path.series.segments);
  const auto normal_tolerance = normal_tolerance_of(query);
  // What rounding leaves of no turn is none.
  const double found = turn_of(path, query);
  const double turn = std::abs(found) > 0x1p-44 ? found : 0;
  SweepForm form{query.profile,    query.scale,  turn,          query.tolerance_or_sections,
                 normal_tolerance, query.origin, query.numbers, std::move(legs),
                 query.roll};
  double all_turn = turn;
  for (const SweepLeg& leg : form.legs) all_turn += leg.turn;
  if (normal_tolerance && query.profile_within)
    form.profile = query.profile_within(
        exact_rational(*normal_tolerance / (2 * side_angle_factor(path, form))));
  return {sweep_as(path, form), path.is_closed, all_turn};
}

template <class SweepAs>
SweepAnswer answer_by(const NamedPath& named, const SweepQuery& query, SweepAs sweep_as) {
  const PathAngle angle = angle_to(query.up, named.path);
  if (!query.through)
    return swept(sweep_path(named.path, CompiledFrames(angle, start_angle(query.start, angle))),
                 query, {}, sweep_as);
  const PathTwist twist(angle, *query.through);
  return swept(sweep_path(named.path, CompiledFrames(angle, twist.legs().front().twist.from())),
               query, legs_of(twist), sweep_as);
}

}  // namespace

SweepAnswer answer(const NamedPath& named, const SweepQuery& query) {
  return answer_by(named, query,
                   [](const SweepPath& path, const SweepForm& form) { return sweep(path, form); });
}

SweepAnswer answer(const NamedPath& named, const SweepQuery& query, MeshSink& out) {
  return answer_by(named, query, [&out](const SweepPath& path, const SweepForm& form) {
    return sweep(path, form, out);
  });
}

}  // namespace phrame
