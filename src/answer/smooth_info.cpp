#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/answer/info.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/smooth_totals.hpp"
#include "phrame/ph/along/up_vector.hpp"

namespace phrame {
namespace {

InfoAnswer::Length rounded_length(const Real& length, const std::string& name, long digits) {
  return {length.exact(), rounded(length, name, digits)};
}

void add_lengths(SmoothInfoAnswer& answer, long digits) {
  const std::size_t count = answer.path.path.segments().size();
  const PathLength length(answer.path.path);
  for (std::size_t k = 0; k < count; ++k)
    answer.lengths.push_back(rounded_length(
        length.of_segment(k), fmt::format("the length of segment {}", k + 1), digits));
  answer.length =
      count == 1 ? answer.lengths.front() : rounded_length(length.total(), "the length", digits);
}

}  // namespace

SmoothInfoAnswer answer(const NamedPath& named, const InfoQuery& query) {
  const Path& path = named.path;
  const PathAngle angle(path, Reference::up);
  find_together(path, {length_rate(), up_frame_rate(angle.up()), bending_rate()});
  SmoothInfoAnswer answer{
      named,
      {},
      {},
      angle.up(),
      rounded_or_zero(up_frame_twist(angle), "the twist of the frame of v", query.digits),
      {},
      is_straight(path),
      plane_normal(path),
      {}};
  add_lengths(answer, query.digits);
  const auto energy = bending_energy(path);
  if (const auto* finite = std::get_if<Real>(&energy))
    answer.bending_energy = rounded_or_zero(*finite, "the bending energy", query.digits);
  try {
    if (const auto turn = angle.holonomy())
      answer.holonomy = rounded_or_zero(*turn, "holonomy", query.digits);
  } catch (const Undecided& undecided) {
    answer.no_holonomy = undecided.what();
  }
  if (const RationalCurve* curve = rational_curve(path.segments().front());
      curve != nullptr && path.segments().size() == 1 && !curve->multiplier().is_constant())
    answer.cusps = real_roots(curve->multiplier(), closed(0, 1));
  return answer;
}

}  // namespace phrame
