#include "phrame/answer/info.hpp"

#include <fmt/format.h>

#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/frame/erf_turning.hpp"

namespace phrame {
namespace {

void add_totals(InfoAnswer& answer, long digits) {
  const PhPath& path = answer.path.path;
  const PathTotal length = total_length(path);
  for (const Total& segment : length.segments) {
    const std::string name =
        path.is_curve() ? "the length"
                        : fmt::format("the length of segment {}", answer.lengths.size() + 1);
    answer.lengths.push_back({segment.value.exact(), rounded(segment.value, name, digits)});
  }
  answer.length = {length.value.exact(), rounded(length.value, "the length", digits)};
  const auto energy = bending_energy(path);
  if (const auto* finite = std::get_if<PathTotal>(&energy))
    answer.bending_energy = rounded(finite->value, "the bending energy", digits);
}

std::vector<Decimal> rounded(const std::vector<RealRoot>& points, long digits) {
  std::vector<Decimal> decimals;
  for (const RealRoot& point : odd_inside(points))
    decimals.push_back(round_to_decimal(to_real(point.at), digits));
  return decimals;
}

}  // namespace

InfoAnswer answer(const NamedPhPath& named, const InfoQuery& query) {
  const PhPath& path = named.path;
  const PathAngle angle(path);
  InfoAnswer answer{named, {}, {}, {}, {}, {}, {}, {}, {}};
  add_totals(answer, query.digits);
  answer.twist_erf = rounded(-angle.value(path.end()), "the twist", query.digits);
  if (path.is_curve()) {
    const Curve& curve = path.segments().front();
    const ErfTurning turning = erf_turning(curve);
    answer.cusps = cusps(curve);
    answer.erf_inflections = rounded(turning.zeros, query.digits);
    answer.erf_extrema = rounded(turning.extrema, query.digits);
  } else if (const auto holonomy = angle.holonomy()) {
    answer.holonomy = rounded(*holonomy, "holonomy", query.digits);
  }
  return answer;
}

}  // namespace phrame
