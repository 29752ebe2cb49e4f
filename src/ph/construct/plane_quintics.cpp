#include "phrame/ph/construct/plane_quintics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/quintic_family.hpp"

// In the plane A = u + qk, so that H(A₀, A₂) and H(A₀ + A₂, B) are real: positive or negative.

namespace phrame::inline v0 {
namespace {

void require_plane(const std::vector<Vector<Rational>>& list, std::string_view what) {
  for (std::size_t k = 0; k < list.size(); ++k)
    if (list[k][2] != 0)
      throw DomainError(fmt::format("the {} {} has z = {}, but a plane curve is wanted, in z = 0",
                                    what, k + 1, as_written(list[k][2])));
}

FreeAngles nth_by_turning(const QuinticFamily& family, long solution) {
  struct Candidate {
    double turning;
    FreeAngles angles;
  };
  std::vector<Candidate> candidates;
  for (const long delta : {0, 1})
    for (const long phi : {0, 1}) {
      const auto radians = [](long half_turns) {
        return static_cast<double>(half_turns) * std::numbers::pi;
      };
      candidates.push_back({approximate_turning(family.member(radians(delta), radians(phi))),
                            {Angle(delta, 0), Angle(phi, 0)}});
    }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.turning < b.turning; });
  return candidates[static_cast<std::size_t>(solution - 1)].angles;
}

}  // namespace

Construction plane_quintics(const HermiteSpline& data, long solution, const Deviation& tolerance,
                            PointRule rule) {
  require_plane(data.points, "point");
  require_plane(data.derivatives, "derivative at point");
  std::vector<FreeAngles> angles;
  for (std::size_t k = 0; k < data.segments(); ++k)
    angles.push_back(nth_by_turning(quintic_family(data, k), solution));
  return quintic_spline(data, angles, tolerance, rule);
}

}  // namespace phrame
