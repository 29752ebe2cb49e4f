#include "phrame/answer/info.hpp"

#include <fmt/format.h>

#include "phrame/answer/rounded.hpp"
#include "phrame/answer/totals.hpp"
#include "phrame/ph/frame/erf_turning.hpp"
#include "phrame/ph/frame/path_angle.hpp"

namespace phrame {
namespace {

/// Sums over the segments; the energy is infinite where that of one is.
void add_totals(InfoAnswer& answer, long digits) {
  Real length = Rational(0);
  std::optional<Real> energy = Rational(0);
  const bool is_curve = answer.path.path.is_curve();
  for (const Curve& curve : answer.path.path.segments()) {
    const Real part = total_length(curve).value;
    const std::string name =
        is_curve ? "the length"
                 : fmt::format("the length of segment {}", answer.lengths.size() + 1);
    answer.lengths.push_back({part, rounded(part, name, digits)});
    length = length + part;
    const auto bending = bending_energy(curve);
    if (!energy || std::holds_alternative<Infinite>(bending))
      energy.reset();
    else
      energy = *energy + std::get<Total>(bending).value;
  }
  answer.length = {length, rounded(length, "the length", digits)};
  if (energy) answer.bending_energy = rounded(*energy, "the bending energy", digits);
}

std::vector<Decimal> rounded(const std::vector<RealRoot>& points, long digits) {
  std::vector<Decimal> decimals;
  for (const RealRoot& point : odd_inside(points))
    decimals.push_back(round_to_decimal(to_real(point.at), digits));
  return decimals;
}

}  // namespace

InfoAnswer answer(const NamedPath& named, const InfoQuery& query) {
  const Path& path = named.path;
  const PathAngle angle(path);
  InfoAnswer answer{named, {Rational(0), {}}, {}, {}, {}, {}, {}, {}, {}};
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
