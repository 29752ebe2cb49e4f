// r_d = r + d·n is (xσ + d·σe₁y, yσ − d·σe₁x)/σ, of r = X/W (Xσ + d·σe₁y·W, …)/(σW). With n′ = φ′e₁
// its derivative is (speed + dφ′)·e₁ = (1 + dκ)·r′, for the κ = φ′/speed that is positive where the
// curve turns left: H is along σe₁, which has no zero, and the zeros of p are those of 1 + dκ.
#include "phrame/ph/offset/offset.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/offset/joined_offset.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {
namespace {

RationalCurve offset_along(const Curve& curve, const PlaneTangent& tangent, const Rational& d) {
  Vector<Polynomial> r = numerator(curve);
  for (Polynomial& x : r) x *= tangent.sigma;
  r[0] += d * tangent.y * curve.weight();
  r[1] -= d * tangent.x * curve.weight();
  return with_direction(RationalCurve(r, tangent.sigma * curve.weight()), direction(tangent, 0));
}

/// Is 1 + dκ = 0 all along, as of an arc at the distance of its center?
bool is_point(const Curve& curve, const PlaneTangent& tangent, const Rational& d) {
  return (tangent.speed * tangent.sigma + d * tangent.turn * pow(curve.weight(), 2)).is_zero();
}

void require_distance(const Rational& d) {
  if (d == 0) throw DomainError("offset: the distance is 0");
}

/// The tangents of all segments, which are in one plane.
std::vector<PlaneTangent> tangents_of(const PhPath& path) {
  std::vector<PlaneTangent> tangents;
  for (const Curve& curve : path.segments()) {
    if (!is_level(curve))
      throw DomainError(fmt::format(
          "offset: the path is in no plane z = const{}",
          path.is_curve() ? std::string()
                          : fmt::format(", as segment {} is in none", tangents.size() + 1)));
    tangents.push_back(plane_tangent(curve));
  }
  return tangents;
}

int first_sign(const OffsetPiece& piece) { return sign_after_zero(piece.curve.multiplier()); }
int last_sign(const OffsetPiece& piece) { return sign_before_one(piece.curve.multiplier()); }

}  // namespace

Segment segment_of(const RationalCurve& curve) {
  auto found = identify(curve);
  if (auto* ph = std::get_if<Curve>(&found)) return PhSegment(std::move(*ph));
  return curve;
}

RationalCurve offset(const Curve& curve, const Rational& d) {
  require_distance(d);
  return offset_along(curve, tangents_of(curve).front(), d);
}

Offset offset(const PhPath& path, const Rational& d, OffsetJoin join) {
  require_distance(d);
  const std::vector<PlaneTangent> tangents = tangents_of(path);
  std::vector<OffsetSegment> segments;
  for (std::size_t k = 0; k < tangents.size(); ++k) {
    const Curve& curve = path.segments()[k];
    segments.push_back({std::nullopt, curve.start(), direction(tangents[k], 0),
                        direction(tangents[k], 1), sign_after_zero(curve.multiplier()),
                        sign_changes(curve.multiplier())});
    if (!is_point(curve, tangents[k], d))
      segments.back().curve = offset_along(curve, tangents[k], d);
  }
  const auto at_corner = [&](const PlaneCorner& corner, std::size_t, std::size_t) {
    return corner_join(corner, d, join);
  };
  return joined_offset(d, std::move(segments), path.closing_turn().has_value(), at_corner);
}

std::vector<Path> paths(const Offset& offset) { return joined_paths(branches_of(offset)); }

std::vector<OffsetCusp> cusps(const Offset& offset) {
  std::vector<OffsetCusp> found;
  const std::size_t count = offset.pieces.size();
  for (std::size_t k = 0; k < count; ++k) {
    const OffsetPiece& piece = offset.pieces[k];
    const Polynomial& p = piece.curve.multiplier();
    const std::size_t before = (k + count - 1) % count;
    const OffsetPiece& last = offset.pieces[before];
    const bool is_joined = offset.meets[before];
    const bool turns_back = is_joined && last_sign(last) != first_sign(piece);
    if (turns_back || p(0) == 0 || (is_joined && last.curve.multiplier()(1) == 0))
      found.push_back({k, Rational(0), turns_back});
    for (const RealRoot& root : real_roots(p, open_interval(0, 1)))
      found.push_back({k, root.at, root.order % 2 != 0});
    if (!offset.meets[k] && p(1) == 0) found.push_back({k, Rational(1), false});
  }
  return found;
}

}  // namespace phrame
