// The turning φ′ = turn/σ has its poles at the roots of w, and a cut is wanted wherever one is
// near: there Taylor's polynomials, by which crossings are found, tell nothing of long arcs. Where
// the cuts are decides nothing. They are short binary fractions, the same ones where a segment is
// reversed, so that what coincides does so part by part, and not in the middle, where curves with
// symmetries have cusps and crossings.
#include "phrame/ph/offset/turning_parts.hpp"

#include <algorithm>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/offset/joined_offset.hpp"
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

/// Part of a curve, with H as it is.
RationalCurve part_of(const RationalCurve& curve, const Rational& lower, const Rational& upper) {
  const Polynomial t{lower, upper - lower};
  Vector<Polynomial> numerator = curve.numerator();
  for (Polynomial& x : numerator) x = compose(x, t);
  const auto& [x, y, z] = curve.direction();
  return with_direction(RationalCurve(numerator, compose(curve.weight(), t)), {x(lower), y(lower)});
}

/// Those of the places that are in a part, at its ends, too, as parameters of it.
std::vector<RealAlgebraic> inside(const std::vector<RealAlgebraic>& places,
                                  const SegmentPart& part) {
  const Rational scale = 1 / (part.upper - part.lower);
  std::vector<RealAlgebraic> found;
  for (const RealAlgebraic& t : places)
    if (t >= part.lower && t <= part.upper) found.push_back(affine(t, scale, -part.lower * scale));
  return found;
}

}  // namespace

std::vector<Rational> turning_cuts(const Polynomial& turn, const Polynomial& sigma) {
  std::vector<Rational> cuts{0};
  add_cuts(turn, sigma, 0, 1, cuts);
  return cuts;
}

RealBall on_segment(const SegmentPart& part, const RealBall& t, long bits) {
  const RealBall width(part.upper - part.lower, bits);
  return add(RealBall(part.lower, bits), multiply(width, t, bits), bits);
}

PathInParts in_turning_parts(const PhPath& path) {
  std::vector<Curve> curves;
  std::vector<std::size_t> corners;
  std::vector<SegmentPart> parts;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    if (std::ranges::binary_search(path.corners(), k)) corners.push_back(curves.size());
    const Curve& curve = path.segments()[k];
    const PlaneTangent tangent = plane_tangent(curve);
    std::vector<Rational> cuts = turning_cuts(tangent.turn, tangent.sigma);
    for (std::size_t j = 1; j + 1 < cuts.size(); ++j)  // no path turns back at a joint
      while (curve.multiplier()(cuts[j]) == 0) cuts[j] += (cuts[j + 1] - cuts[j]) / 8;
    for (std::size_t j = 0; j + 1 < cuts.size(); ++j) {
      curves.push_back(cuts.size() == 2 ? curve : segment(curve, cuts[j], cuts[j + 1]));
      parts.push_back({k, cuts[j], cuts[j + 1]});
    }
  }
  return {PhPath::of_continuous(std::move(curves), std::move(corners)), std::move(parts)};
}

std::vector<std::vector<Rational>> turning_cuts(const OffsetBranches& pieces) {
  std::vector<std::vector<Rational>> cuts;
  for (const RationalCurve& curve : pieces.curves) {
    const auto& [x, y, z] = curve.direction();
    const RationalFunction rate(x * differentiate(y) - y * differentiate(x), x * x + y * y);
    cuts.push_back(turning_cuts(rate.numerator(), rate.denominator()));
  }
  return cuts;
}

BranchesInParts in_parts(const OffsetBranches& pieces,
                         const std::vector<std::vector<Rational>>& cuts) {
  BranchesInParts made;
  std::vector<std::size_t> first;  // of the parts of each piece
  for (std::size_t k = 0; k < pieces.curves.size(); ++k) {
    const RationalCurve& curve = pieces.curves[k];
    first.push_back(made.parts.size());
    for (std::size_t j = 0; j + 1 < cuts[k].size(); ++j) {
      const Rational& lower = cuts[k][j];
      const Rational& upper = cuts[k][j + 1];
      made.branches.curves.push_back(cuts[k].size() == 2 ? curve : part_of(curve, lower, upper));
      made.parts.push_back({k, lower, upper});
      if (!pieces.turns.empty())
        made.branches.turns.push_back(inside(pieces.turns[k], made.parts.back()));
    }
  }
  for (std::size_t k = 0; k < made.parts.size(); ++k) {
    const auto& [piece, lower, upper] = made.parts[k];
    const std::size_t behind = pieces.behind[piece];
    made.branches.behind.push_back(upper < 1              ? k + 1
                                   : behind == no_segment ? no_segment
                                                          : first[behind]);
  }
  return made;
}

}  // namespace phrame
