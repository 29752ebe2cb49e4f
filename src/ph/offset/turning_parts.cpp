// The turning φ′ = turn/σ has its poles at the roots of w, and a cut is wanted wherever one is
// near: there Taylor's polynomials, by which crossings are found, tell nothing of long arcs. Where
// the cuts are decides nothing. They are short binary fractions, the same ones where a segment is
// reversed, so that what coincides does so part by part, and not in the middle, where curves with
// symmetries have cusps and crossings.
#include "phrame/ph/offset/turning_parts.hpp"

#include <algorithm>

#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/offset/plane_tangent.hpp"

namespace phrame::inline v0 {
namespace {

/// By Bernstein coefficients on the part, which are near what the polynomials are there.
bool turns_little(const Polynomial& turn, const Polynomial& sigma, const Rational& lower,
                  const Rational& upper) {
  const Polynomial t{lower, upper - lower};
  const auto coefficients = [&](const Polynomial& p) {
    return to_bernstein(compose(p, t), std::max(p.degree(), 0L));
  };
  const std::vector<Rational> sizes = coefficients(sigma);
  const Rational most = *std::ranges::min_element(sizes) / (upper - lower);
  const std::vector<Rational> rates = coefficients(turn);
  return std::ranges::all_of(rates, [&](const Rational& c) { return abs(c) <= most; });
}

void add_cuts(const Polynomial& turn, const Polynomial& sigma, const Rational& lower,
              const Rational& upper, std::vector<Rational>& cuts) {
  if (turns_little(turn, sigma, lower, upper)) return cuts.push_back(upper);
  const Rational one = lower + (upper - lower) * Rational(3, 8);
  const Rational other = lower + (upper - lower) * Rational(5, 8);
  add_cuts(turn, sigma, lower, one, cuts);
  add_cuts(turn, sigma, one, other, cuts);
  add_cuts(turn, sigma, other, upper, cuts);
}

}  // namespace

std::vector<Rational> turning_cuts(const Polynomial& turn, const Polynomial& sigma) {
  std::vector<Rational> cuts{0};
  add_cuts(turn, sigma, 0, 1, cuts);
  return cuts;
}

PathInParts in_turning_parts(const PhPath& path) {
  std::vector<Curve> curves;
  std::vector<std::size_t> corners;
  std::vector<SegmentPart> parts;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    if (std::ranges::binary_search(path.corners(), k)) corners.push_back(curves.size());
    const Curve& curve = path.segments()[k];
    const PlaneTangent tangent = plane_tangent(curve);
    const std::vector<Rational> cuts = turning_cuts(tangent.turn, tangent.sigma);
    for (std::size_t j = 0; j + 1 < cuts.size(); ++j) {
      curves.push_back(cuts.size() == 2 ? curve : segment(curve, cuts[j], cuts[j + 1]));
      parts.push_back({k, cuts[j], cuts[j + 1]});
    }
  }
  return {PhPath::of_continuous(std::move(curves), std::move(corners)), std::move(parts)};
}

}  // namespace phrame
