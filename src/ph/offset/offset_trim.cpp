// All points at the distance |d| from the path are on its boundary curves: the offsets to both
// sides, the arcs about corners on their outer sides, and half-circles about the ends of an open
// path, and about places where it turns back: of these the offset's points at the distance |d| are
// known, which is all that is asked. Along an offset the distance from the path is at most |d|, and
// where it changes from |d| to less, at a point Q, there are points of the path as near to Q as |d|
// beside the one that Q belongs to, so that another boundary curve goes through Q; or that one is
// next to it, and 1 + dκ changes its sign. So between two such places one point tells for all. A
// part of which one point of the path is seen to be nearer than |d| has no such place. Where 1 + dκ
// < 0 the distance from the path has no least value at the foot, but is less next to it, and for
// points next to that, too: such parts are cut, and no other curve is where it meets one.
//
// With mitres, what is between them and the path counts as nearer, too, and they are boundary
// curves in place of the arcs.
#include "phrame/ph/offset/offset_trim.hpp"

#include <algorithm>

#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/disc_cover.hpp"
#include "phrame/ph/offset/mitre_kites.hpp"
#include "phrame/ph/offset/offset_join.hpp"
#include "phrame/ph/offset/plane_tangent.hpp"
#include "phrame/ph/offset/shadow.hpp"
#include "phrame/ph/offset/turning_parts.hpp"
#include "phrame/ph/offset/turning_place.hpp"
#include "phrame/ph/offset/two_sides.hpp"

namespace phrame::inline v0 {
namespace {

/// The boundary curves.
struct Stroke {
  OffsetBranches branches;                               ///< first those of the offset itself
  std::vector<std::optional<Vector<Rational>>> centers;  ///< of the arcs
  /// What they are at the distance |d| from, at the same t: X, Y and W.
  std::vector<Vector<Polynomial>> bases;
  std::vector<int> signs;  ///< as BoundaryCurves has them
  std::vector<std::optional<SideFoot>> feet;
};

Vector<Polynomial> constant(const Vector<Rational>& at) {
  return {Polynomial{at[0]}, Polynomial{at[1]}, Polynomial{1}};
}

Vector<Polynomial> base_of(const Curve& curve) {
  const Vector<Polynomial> X = numerator(curve);
  return {X[0], X[1], curve.weight()};
}

class StrokeMaker {
 public:
  StrokeMaker(const PhPath& path, const Offset& offset) : path_(path), offset_(offset) {}

  Stroke make() {
    const auto& segments = path_.segments();
    add(offset_, path_, false);
    if (path_.closing_turn()) {
      add(phrame::offset(path_, -offset_.distance), path_, false);
      return std::move(stroke_);
    }
    const Curve& first = segments.front();
    const Curve& last = segments.back();
    const int start_sign = sign_after_zero(first.multiplier());
    const int end_sign = sign_before_one(last.multiplier());
    add_cap(end_point(last), direction(plane_tangent(last), 1), end_sign,
            {segments.size() - 1, 1, true});
    if (std::ranges::all_of(segments, constant_sign, &Curve::multiplier)) {
      const PhPath back = *reversed(Path(path_)).with_preimages();
      add(phrame::offset(back, offset_.distance), back, true);
    } else {  // e₁ of the reversed path may be on either side
      stroke_.branches.behind.back() = no_segment;
      add(phrame::offset(path_, -offset_.distance), path_, false);
      stroke_.branches.behind.back() = no_segment;
    }
    const PlaneDirection start = direction(plane_tangent(first), 0);
    add_cap(first.start(), {-start.x, -start.y}, start_sign, {0, 0, true});
    stroke_.branches.behind.back() = 0;
    return std::move(stroke_);
  }

 private:
  /// What is behind an open end is what is added next.
  void add(const Offset& offset, const PhPath& path, bool is_reversed) {
    const std::size_t first = stroke_.branches.curves.size();
    const OffsetBranches more = branches_of(offset);
    for (std::size_t k = 0; k < more.curves.size(); ++k) {
      stroke_.branches.curves.push_back(more.curves[k]);
      stroke_.branches.turns.push_back(more.turns[k]);
      const std::size_t behind = more.behind[k];
      stroke_.branches.behind.push_back(behind == no_segment ? no_segment : first + behind);
      const OffsetPiece& piece = offset.pieces[k];
      const Curve& base = path.segments()[piece.segment];
      const bool is_arc = piece.is_join && !is_line(piece.curve);
      stroke_.centers.push_back(is_arc ? std::optional(base.start()) : std::nullopt);
      stroke_.bases.push_back(piece.is_join ? constant(base.start()) : base_of(base));
      stroke_.signs.push_back(piece.is_join ? 0 : constant_sign(base.multiplier()));
      SideFoot& foot = stroke_.feet.emplace_back(SideFoot{piece.segment, {}, is_reversed}).value();
      if (is_reversed) foot.segment = path.segments().size() - 1 - piece.segment;
      if (piece.is_join) foot.point = is_reversed ? 1 : 0;
      if (piece.is_join && !is_arc) stroke_.feet.back().reset();
    }
    if (!path.closing_turn() && !more.curves.empty())
      stroke_.branches.behind.back() = stroke_.branches.curves.size();
  }

  void add_cap(const Vector<Rational>& at, const PlaneDirection& e1, int sign,
               const SideFoot& foot) {
    for (RationalCurve& curve : end_cap(at, e1, sign, offset_.distance)) {
      stroke_.branches.curves.push_back(std::move(curve));
      stroke_.branches.turns.emplace_back();
      stroke_.branches.behind.push_back(stroke_.branches.curves.size());
      stroke_.centers.emplace_back(at);
      stroke_.bases.push_back(constant(at));
      stroke_.signs.push_back(0);
      stroke_.feet.push_back(sign > 0 ? std::optional(foot) : std::nullopt);
    }
  }

  const PhPath& path_;
  const Offset& offset_;
  Stroke stroke_;
};

/// Its segments that turn back.
std::vector<RationalCurve> turning_curves(const PhPath& path) {
  std::vector<RationalCurve> curves;
  for (const Curve& curve : path.segments())
    if (constant_sign(curve.multiplier()) == 0) curves.push_back(PhSegment(curve).by_positions());
  return curves;
}

/// Of round or mitred offsets.
TrimmedOffset trimmed_whole(const PhPath& path, const Rational& d, OffsetJoin join) {
  TrimmedOffset result{phrame::offset(path, d, join), {}, {}};
  const auto& pieces = result.offset.pieces;
  const Stroke stroke = StrokeMaker(path, result.offset).make();
  const TwoSides sides(path, stroke.feet);
  const DiscCover discs(path, d);
  const MitreKites kites(result.offset, [&](std::size_t k) { return path.segments()[k].start(); });
  const auto disc_around = [&](std::size_t piece, const Rational& t) {
    const OffsetPiece& of = pieces[piece];
    const Vector<Rational> at = point(of.curve, t);
    return of.is_join ? discs.disc_around(at) : discs.disc_around(at, of.segment, double_zero(t));
  };
  BoundaryCurves curves{stroke.branches, pieces.size(), stroke.centers,
                        events_at_turns(turning_curves(path), result.offset, GaugeForm())};
  curves.signs = stroke.signs;
  curves.covers = [&](const PlaneBox& box) { return discs.covers(box); };
  curves.are_apart = [&](const CurveNode& own, const CurveNode& other) {
    return sides.are_apart(own, other);
  };
  curves.is_cut = [&](std::size_t piece, const Rational& t) {
    return disc_around(piece, t) || kites.contain(point(pieces[piece].curve, t));
  };
  curves.is_covered = [&](std::size_t piece, const Rational& from, const Rational& to) {
    const auto disc = disc_around(piece, (from + to) / 2);
    return disc &&
           is_nearer_along(pieces[piece].curve, from, to, constant(disc->center), 0, disc->radius);
  };
  curves.is_covered_beside = [&](const CurvePart& part, const CurvePart& other) {
    const Interval where = interval_of(part);
    const Interval beside = interval_of(other);
    return is_nearer_along(stroke.branches.curves[part.segment], *where.lower, *where.upper,
                           stroke.bases[other.segment], (*beside.lower + *beside.upper) / 2, d);
  };
  if (!std::ranges::all_of(path.segments(), constant_sign,
                           &Curve::multiplier))  // then all go along e₁
    curves.is_backward = [&](std::size_t piece, const Rational& t) {
      return pieces[piece].curve.multiplier()(t).sign() ==
             -sign_after_zero(path.segments().front().multiplier());
    };
  TrimmedCurves left = trimmed(curves, "trimmed_offset");
  result.branches = std::move(left.branches);
  result.undecided = std::move(left.undecided);
  return result;
}

/// Of the offset of a path in parts, as that of the path: what goes on through a cut is one part.
class Reunion {
 public:
  Reunion(const TrimmedOffset& found, const std::vector<SegmentPart>& parts, Offset whole)
      : found_(found), result_{std::move(whole), {}, {}} {
    std::size_t piece = 0;
    for (const OffsetPiece& x : found.offset.pieces) {
      if (x.is_join) {
        origins_.push_back({piece++, 0, 1});
        continue;
      }
      const SegmentPart& part = parts[x.segment];
      origins_.push_back({piece, part.lower, part.upper});
      if (part.upper == 1) ++piece;
    }
  }

  TrimmedOffset make() {
    for (const TrimmedBranch& branch : found_.branches) result_.branches.push_back(whole(branch));
    for (const UndecidedStretch& x : found_.undecided) {
      const SegmentPart& of = origins_[x.piece];
      result_.undecided.push_back({of.segment, on_segment(of, x.t, 320)});
    }
    return std::move(result_);
  }

 private:
  OffsetPart whole(const OffsetPart& part) const {
    const auto& [piece, lower, upper] = origins_[part.piece];
    if (lower == 0 && upper == 1) return {piece, part.from, part.to};
    const auto along = [&from = lower, width = upper - lower](const Real& t) {
      return cached(Real(from) + Real(width) * t);
    };
    return {piece, along(part.from), along(part.to)};
  }

  static bool goes_on(const OffsetPart& a, const OffsetPart& b) {
    return a.piece == b.piece && a.to.exact() && a.to.exact() == b.from.exact();
  }

  TrimmedBranch whole(const TrimmedBranch& branch) const {
    TrimmedBranch made{{}, branch.is_closed};
    for (const OffsetPart& fine : branch.parts) {
      OffsetPart part = whole(fine);
      if (made.parts.empty() || !goes_on(made.parts.back(), part))
        made.parts.push_back(std::move(part));
      else
        made.parts.back().to = std::move(part.to);
    }
    if (made.is_closed && made.parts.size() > 1 && goes_on(made.parts.back(), made.parts.front())) {
      made.parts.front().from = made.parts.back().from;
      made.parts.pop_back();
    }
    return made;
  }

  const TrimmedOffset& found_;
  TrimmedOffset result_;
  std::vector<SegmentPart> origins_;  ///< what the pieces are of those of the whole offset
};

}  // namespace

std::vector<TrimmedBranch> without_joins(const TrimmedOffset& trimmed) {
  std::vector<TrimmedBranch> found;
  for (const TrimmedBranch& branch : trimmed.branches) {
    const auto is_join = [&](const OffsetPart& part) {
      return trimmed.offset.pieces[part.piece].is_join;
    };
    std::vector<OffsetPart> parts = branch.parts;
    const auto first = std::ranges::find_if(parts, is_join);
    const bool is_cut = first != parts.end();
    if (branch.is_closed) std::rotate(parts.begin(), first, parts.end());
    TrimmedBranch open{{}, branch.is_closed && !is_cut};
    for (const OffsetPart& part : parts) {
      if (!is_join(part)) open.parts.push_back(part);
      if (is_join(part) && !open.parts.empty()) found.push_back(std::exchange(open, {{}, false}));
    }
    if (!open.parts.empty()) found.push_back(std::move(open));
  }
  return found;
}

TrimmedOffset trimmed_offset(const PhPath& path, const Rational& d, OffsetJoin join) {
  const OffsetJoin kept = join == OffsetJoin::mitre ? join : OffsetJoin::round;
  Offset whole = phrame::offset(path, d, kept);
  const PathInParts fine = in_turning_parts(path);
  const TrimmedOffset found = trimmed_whole(fine.path, d, kept);
  TrimmedOffset result = Reunion(found, fine.parts, std::move(whole)).make();
  if (join == OffsetJoin::open) result.branches = without_joins(result);
  return result;
}

}  // namespace phrame
