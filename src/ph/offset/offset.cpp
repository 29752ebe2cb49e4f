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
#include "phrame/ph/offset/offset_join.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {
namespace {

/// With H along e₁.
RationalCurve offset_along(const Curve& curve, const PlaneTangent& tangent, const Rational& d) {
  Vector<Polynomial> r = numerator(curve);
  for (Polynomial& x : r) x *= tangent.sigma;
  r[0] += d * tangent.y * curve.weight();
  r[1] -= d * tangent.x * curve.weight();
  RationalCurve found(r, tangent.sigma * curve.weight());
  const Vector<Rational> h = evaluate(found.direction(), 0);
  const bool is_along = h[0] * tangent.x(0) + h[1] * tangent.y(0) > 0;
  return is_along ? found : found.turned_over();
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

/// What is between two segments; of a path that closes, between the last and the first one, too.
class OffsetMaker {
 public:
  OffsetMaker(const PhPath& path, const Rational& d, OffsetJoin join)
      : path_(path), d_(d), join_(join), tangents_(tangents_of(path)), made_{d, {}, {}, {}} {}

  Offset make() {
    const auto& segments = path_.segments();
    for (std::size_t k = 0; k < segments.size(); ++k) {
      if (k > 0) add_joint(k - 1, k);
      const bool is_a_point = is_point(segments[k], tangents_[k], d_);
      if (is_a_point) points_.push_back(made_.pieces.size());
      made_.pieces.push_back({is_a_point ? PhSegment(segments[k]).by_positions()
                                         : offset_along(segments[k], tangents_[k], d_),
                              k});
    }
    if (path_.closing_turn())
      add_joint(segments.size() - 1, 0);
    else
      made_.meets.push_back(false);
    drop_points();
    return std::move(made_);
  }

 private:
  /// Behind such a point the tangent is another one: the offset is cut there.
  void drop_points() {
    for (std::size_t j = points_.size(); j-- > 0;) {
      const auto at = static_cast<std::ptrdiff_t>(points_[j]);
      made_.pieces.erase(made_.pieces.begin() + at);
      made_.meets.erase(made_.meets.begin() + at);
      if (!made_.meets.empty())
        made_.meets[(points_[j] + made_.meets.size() - 1) % made_.meets.size()] = false;
    }
  }

  void add_joint(std::size_t before, std::size_t after) {
    const Curve& next = path_.segments()[after];
    const PlaneCorner corner{next.start(), direction(tangents_[before], 1),
                             direction(tangents_[after], 0), sign_after_zero(next.multiplier())};
    if (corner.before == corner.after) return made_.meets.push_back(true);
    const bool is_outer = is_outside(corner, d_);
    if (!is_outer) made_.inner_corners.push_back(after);
    const bool is_joined = is_outer && join_ != OffsetJoin::open;
    made_.meets.push_back(is_joined);
    if (!is_joined) return;
    for (RationalCurve& curve : corner_join(corner, d_, join_)) {
      made_.pieces.push_back({std::move(curve), after, true});
      made_.meets.push_back(true);
    }
  }

  const PhPath& path_;
  const Rational& d_;
  OffsetJoin join_;
  std::vector<PlaneTangent> tangents_;
  std::vector<std::size_t> points_{};  ///< the pieces that are points, ascending
  Offset made_;
};

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
  return OffsetMaker(path, d, join).make();
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
