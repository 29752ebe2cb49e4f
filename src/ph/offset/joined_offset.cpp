#include "phrame/ph/offset/joined_offset.hpp"

#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// What is between two segments; of a path that closes, between the last and the first one, too.
class OffsetJoiner {
 public:
  OffsetJoiner(const Rational& d, std::vector<OffsetSegment> segments, const JoinAtCorner& join)
      : segments_(std::move(segments)), join_(join), made_{d, {}, {}, {}} {
    for (const OffsetSegment& segment : segments_) has_curve_.push_back(segment.curve.has_value());
  }

  Offset make(bool is_closed) {
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      if (k > 0) add_joint(k - 1, k);
      if (has_curve_[k])
        made_.pieces.push_back(
            {*std::move(segments_[k].curve), k, false, std::move(segments_[k].turns)});
    }
    if (is_closed)
      add_joint(segments_.size() - 1, 0);
    else if (has_curve_.back())
      made_.meets.push_back(false);
    return std::move(made_);
  }

 private:
  void add_joint(std::size_t before, std::size_t after) {
    const OffsetSegment& next = segments_[after];
    const PlaneCorner corner{next.start, segments_[before].at_end, next.at_start, next.sign};
    bool goes_on = true;
    std::vector<RationalCurve> joins;
    if (cross(corner.before, corner.after) != 0) {
      if (is_outside(corner, made_.distance))
        joins = join_(corner, before, after);
      else
        made_.inner_corners.push_back(after);
      goes_on = !joins.empty();
    }
    if (has_curve_[before]) made_.meets.push_back(goes_on && (has_curve_[after] || !joins.empty()));
    for (std::size_t k = 0; k < joins.size(); ++k) {
      made_.pieces.push_back({std::move(joins[k]), after, true});
      made_.meets.push_back(k + 1 < joins.size() || has_curve_[after]);
    }
  }

  std::vector<OffsetSegment> segments_;
  std::vector<bool> has_curve_{};
  const JoinAtCorner& join_;
  Offset made_;
};

}  // namespace

RationalCurve with_direction(const RationalCurve& curve, const PlaneDirection& e1) {
  const Vector<Rational> h = evaluate(curve.direction(), 0);
  return h[0] * e1.x + h[1] * e1.y > 0 ? curve : curve.turned_over();
}

Offset joined_offset(const Rational& d, std::vector<OffsetSegment> segments, bool is_closed,
                     const JoinAtCorner& join) {
  return OffsetJoiner(d, std::move(segments), join).make(is_closed);
}

}  // namespace phrame
