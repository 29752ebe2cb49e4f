#include "phrame/answer/info.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/corner.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/rational_ph.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/frame/erf_turning.hpp"

namespace phrame::inline v0 {
namespace {

InfoAnswer::Length rounded_length(const Real& length, const std::string& name, long digits) {
  return {length.exact(), rounded(length, name, digits)};
}

void add_lengths(InfoAnswer& answer, long digits) {
  const PathTotal length = total_length(answer.path.path);
  answer.lengths.reserve(length.segments.size());
  answer.length = rounded_length(length.value, "the length", digits);
  for (const auto& segment : length.segments)
    answer.lengths.push_back(
        length.segments.size() == 1
            ? answer.length
            : rounded_length(value_of(segment),
                             fmt::format("the length of segment {}", answer.lengths.size() + 1),
                             digits));
}

void add_energy(InfoAnswer& answer, long digits) {
  const auto energy = bending_energy(answer.path.path);
  if (const auto* finite = std::get_if<PathTotal>(&energy))
    answer.bending_energy = rounded(*finite, "the bending energy", digits);
}

std::vector<Decimal> rounded(const std::vector<RealRoot>& points, long digits) {
  std::vector<Decimal> decimals;
  for (const RealRoot& point : odd_inside(points))
    decimals.push_back(round_to_decimal(to_real(point.at), digits));
  return decimals;
}

/// Of a PH curve by itself.
void add_turning(InfoAnswer& answer, const Curve& curve, long digits) {
  const ErfTurning turning = erf_turning(curve);
  answer.erf_inflections = rounded(turning.zeros, digits);
  answer.erf_extrema = rounded(turning.extrema, digits);
}

void add_bends(InfoAnswer& answer, long digits) {
  const Path& path = answer.path.path;
  const auto normal = upper_normal(path);
  if (!normal || rational_curve(path.segments().front()) == nullptr) return;
  if (path.is_ph())
    answer.offset = OffsetKind{OffsetKind::Kind::each_side, {1}};
  else
    answer.offset = offset_kind(*rational_curve(path.segments().front()));
  answer.bends.emplace();
  for (const CurvaturePlace& place : curvature_places(path.segments().front(), *normal))
    answer.bends->push_back(
        {place.t, place.kind, rounded(place.curvature, "an extremum of the curvature", digits)});
}

void add_plane_forms(InfoAnswer& answer, const Curve& curve, long digits) {
  answer.complex = complex_form(curve);
  answer.tschirnhausen = tschirnhausen_cubic(curve);
  if (answer.tschirnhausen)
    answer.tschirnhausen_scale =
        rounded_length(square_root_of(answer.tschirnhausen->squared_scale), "the scale", digits);
}

void add_holonomy(InfoAnswer& answer, const PathAngle& angle, long digits) {
  try {
    if (const auto turn = angle.holonomy())
      answer.holonomy = rounded_or_zero(*turn, "holonomy", digits);
  } catch (const Undecided& undecided) {
    answer.no_holonomy = undecided.what();
  }
}

std::array<std::array<Decimal, 2>, 3> box_of(const Path& path, long digits) {
  std::array<std::array<Decimal, 2>, 3> box;
  const auto ranges = bounding_box(path);
  for (std::size_t k = 0; k < 3; ++k)
    box[k] = {rounded_or_zero(ranges[k].least.value, "the box", digits),
              rounded_or_zero(ranges[k].greatest.value, "the box", digits)};
  return box;
}

InfoAnswer::Nearest nearest_to(const Path& path, const Vector<Rational>& p, long digits) {
  const PathExtreme found = nearest_point(path, p);
  InfoAnswer::Nearest nearest{
      p,
      rounded_or_zero(parameter(found.at), "t of the nearest point", digits),
      {},
      rounded_or_zero(found.value, "the distance", digits)};
  const Vector<Real> r = position(path, found.at);
  for (std::size_t k = 0; k < 3; ++k)
    nearest.point[k] = rounded_or_zero(r[k], "the nearest point", digits);
  return nearest;
}

}  // namespace

InfoAnswer answer(NamedPath named, const InfoQuery& query) {
  const Path path = named.path;
  InfoAnswer answer{std::move(named), {}, {}, {}, {}, {}, is_straight(path), plane_normal(path)};
  const PathAngle angle(path);
  if (angle.reference() == Reference::up) {
    answer.up = angle.up();
    find_together(path, {length_rate(), up_frame_rate(angle.up()), bending_rate()});
  }
  add_lengths(answer, query.digits);
  add_energy(answer, query.digits);
  for (const Corner& corner : corners(path))
    answer.corners.push_back(
        {corner.segment, rounded_or_zero(corner.angle, "the angle of a corner", query.digits)});
  const Real twist = reference_twist(angle);
  answer.twist = answer.up ? rounded_or_zero(twist, "the twist of the frame of v", query.digits)
                           : rounded(twist, "the twist", query.digits);
  const bool is_single = path.segments().size() == 1;
  const Curve* ph = is_single ? ph_curve(path.segments().front()) : nullptr;
  if (ph != nullptr && ph->is_polynomial()) {
    add_turning(answer, *ph, query.digits);
    add_plane_forms(answer, *ph, query.digits);
  } else {
    add_holonomy(answer, angle, query.digits);
  }
  if (ph != nullptr && !ph->is_polynomial() && complex_form(*ph))
    answer.tangents = line_coordinates(tangent_lines(*ph));
  if (is_single) {
    answer.cusps = cusps(path.segments().front());
    add_bends(answer, query.digits);
  }
  if (query.wants_box) answer.box = box_of(path, query.digits);
  if (query.nearest) answer.nearest = nearest_to(path, *query.nearest, query.digits);
  return answer;
}

}  // namespace phrame
