#include "phrame/ph/sweep/profile_curve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {
namespace {

/// Is the curve a Bézier curve with positive weights, which one?
std::optional<PlaneBezier> as_bezier(const PlaneRational& curve) {
  const long degree = std::max({1L, curve.x.degree(), curve.y.degree(), curve.weight.degree()});
  PlaneBezier bezier{{}, to_bernstein(curve.weight, degree)};
  const auto x = to_bernstein(curve.x, degree);
  const auto y = to_bernstein(curve.y, degree);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Rational& weight = bezier.weights[k];
    if (weight <= 0) return std::nullopt;
    bezier.points.push_back({x[k] / weight, y[k] / weight});
  }
  return bezier;
}

void require_pieces(const std::vector<PlaneBezier>& pieces) {
  if (pieces.empty()) throw DomainError("profile: it has no pieces");
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto& [points, weights] = pieces[k];
    if (points.size() < 2 || weights.size() != points.size())
      throw DomainError(
          fmt::format("profile: the piece {} has {} points and {} weights, at least 2 are needed",
                      k + 1, points.size(), weights.size()));
    for (const Rational& weight : weights)
      if (weight <= 0)
        throw DomainError(fmt::format("profile: the piece {} has a weight that is not > 0", k + 1));
    const std::size_t next = (k + 1) % pieces.size();
    if (!pieces[next].points.empty() && points.back() != pieces[next].points.front())
      throw DomainError(fmt::format("profile: the piece {} does not begin where the piece {} ends",
                                    next + 1, k + 1));
  }
}

/// ½∫ (x y′ − x′ y) = ½∫ (X Y′ − X′ Y)/W²
Real signed_area(const std::vector<PlaneBezier>& pieces) {
  Real sum = Rational(0);
  for (const PlaneBezier& piece : pieces) {
    const auto [x, y, weight] = polynomials(piece);
    const RationalFunction rate(x * differentiate(y) - differentiate(x) * y,
                                Rational(2) * weight * weight);
    sum = sum + definite_integral(rate, Rational(0), Rational(1)).value;
  }
  return sum;
}

int sign_of_area(const Real& area) {
  if (area.exact()) return area.exact()->sign();
  for (const long bits : {64L, 1024L})
    if (const int found = sign(area.enclose(bits)); found != 0) return found;
  throw Undecided("profile: its area is not told from 0");
}

/// From the last piece to the first.
std::vector<PlaneBezier> reversed_ring(std::vector<PlaneBezier> pieces) {
  std::reverse(pieces.begin(), pieces.end());
  for (PlaneBezier& piece : pieces) piece = reversed(std::move(piece));
  return pieces;
}

/// A closed curve, counterclockwise.
struct CurveRing {
  std::vector<PlaneBezier> pieces;
  Real area;  ///< > 0
};

CurveRing counterclockwise(std::vector<PlaneBezier> pieces) {
  require_pieces(pieces);
  const Real area = signed_area(pieces);
  const int direction = sign_of_area(area);
  if (direction == 0) throw DomainError("profile: its area is 0");
  if (direction > 0) return {std::move(pieces), area};
  return {reversed_ring(std::move(pieces)), -area};
}

}  // namespace

PlaneBezier reversed(PlaneBezier bezier) {
  std::reverse(bezier.points.begin(), bezier.points.end());
  std::reverse(bezier.weights.begin(), bezier.weights.end());
  return bezier;
}

PlaneRational polynomials(const PlaneBezier& bezier) {
  std::array<std::vector<Rational>, 2> products;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t k = 0; k < bezier.points.size(); ++k)
      products[axis].push_back(bezier.weights[k] * bezier.points[k][axis]);
  return {from_bernstein(products[0]), from_bernstein(products[1]), from_bernstein(bezier.weights)};
}

std::vector<PlaneBezier> bezier_pieces(const PlaneRational& curve) {
  if (const auto whole = as_bezier(curve)) return {*whole};
  std::vector<PlaneBezier> pieces;
  for (const Polynomial& half :
       {Polynomial{0, Rational(1, 2)}, Polynomial{Rational(1, 2), Rational(1, 2)}}) {
    const auto of_half = bezier_pieces(
        {compose(curve.x, half), compose(curve.y, half), compose(curve.weight, half)});
    pieces.insert(pieces.end(), of_half.begin(), of_half.end());
  }
  return pieces;
}

void ProfileCurve::append_ring(const std::vector<PlaneBezier>& pieces) {
  rings_.push_back(pieces_.size());
  pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
}

ProfileCurve::ProfileCurve(std::vector<PlaneBezier> pieces) {
  const CurveRing ring = counterclockwise(std::move(pieces));
  append_ring(ring.pieces);
  area_ = ring.area;
}

ProfileCurve ProfileCurve::of_rings(std::vector<std::vector<PlaneBezier>> given) {
  if (given.size() == 1) return ProfileCurve(std::move(given.front()));
  if (given.empty()) throw DomainError("profile: it has no ring");
  std::vector<CurveRing> rings;
  std::size_t outer = 0;
  for (std::size_t k = 0; k < given.size(); ++k) {
    try {
      rings.push_back(counterclockwise(std::move(given[k])));
    } catch (const DomainError& complaint) {
      throw DomainError(fmt::format("{} (of the ring {})", complaint.what(), k + 1));
    }
    if (approximate(rings[k].area.enclose(64)) > approximate(rings[outer].area.enclose(64)))
      outer = k;
  }
  ProfileCurve profile;
  profile.append_ring(rings[outer].pieces);
  profile.area_ = rings[outer].area;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    if (k == outer) continue;
    profile.append_ring(reversed_ring(std::move(rings[k].pieces)));
    profile.area_ = profile.area_ + -rings[k].area;
  }
  // So the outer ring is seen to have the greatest area, however near the guess was.
  if (sign_of_area(profile.area_) <= 0)
    throw DomainError("profile: the holes have not less area than the outline around them");
  return profile;
}

std::vector<PlaneBezier> reversed_pieces(const ProfileCurve& profile) {
  const auto& rings = profile.rings();
  const auto piece = [&](std::size_t ring) {
    return profile.pieces().begin() + static_cast<std::ptrdiff_t>(rings[ring]);
  };
  std::vector<PlaneBezier> all;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const auto end = k + 1 < rings.size() ? piece(k + 1) : profile.pieces().end();
    const auto ring = reversed_ring({piece(k), end});
    all.insert(all.end(), ring.begin(), ring.end());
  }
  return all;
}

ProfileCurve circle_curve(const Rational& radius) {
  if (radius <= 0) throw DomainError("profile: the radius is not > 0: " + as_written(radius));
  std::vector<PlaneBezier> quarters;
  ProfilePoint axis{radius, 0};
  for (int k = 0; k < 4; ++k) {
    const ProfilePoint next{-axis[1], axis[0]};
    quarters.push_back({{axis, {axis[0] + next[0], axis[1] + next[1]}, next}, {1, 1, 2}});
    axis = next;
  }
  return ProfileCurve(std::move(quarters));
}

ProfileCurve polygon_curve(const Profile& polygon) {
  const auto& corners = polygon.corners();
  std::vector<std::vector<PlaneBezier>> rings;
  for (const std::size_t first : polygon.rings()) {
    auto& sides = rings.emplace_back();
    std::size_t k = first;
    do {
      const std::size_t next = polygon.next(k);
      sides.push_back({{corners[k], corners[next]}, {1, 1}});
      k = next;
    } while (k != first);
  }
  return ProfileCurve::of_rings(std::move(rings));
}

}  // namespace phrame
