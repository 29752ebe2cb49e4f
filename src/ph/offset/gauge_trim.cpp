// As offset_trim.cpp, with |d|·U for the circle of radius |d|: a point at the distance |d| from the
// path is on |d|·U about its nearest point there, where that touches the path, or about an end of
// the path or a corner.
#include "phrame/ph/offset/gauge_trim.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/gauge_cover.hpp"
#include "phrame/ph/offset/gauge_offset.hpp"
#include "phrame/ph/offset/mitre_kites.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"
#include "phrame/ph/offset/turning_place.hpp"

namespace phrame::inline v0 {
namespace {

std::vector<RationalCurve> curves_of(const Path& path) {
  std::vector<RationalCurve> curves;
  for (const Segment& segment : path.segments()) curves.push_back(*rational_curve(segment));
  return curves;
}

/// All boundary curves, those of the offset first, and the signs that BoundaryCurves has of them.
struct Stroke {
  OffsetBranches branches;
  std::vector<int> signs;
};

Stroke stroke_of(const std::vector<RationalCurve>& path, bool is_closed,
                 const GaugeOffsets& offsets, const Offset& own) {
  Stroke made;
  OffsetBranches& stroke = made.branches;
  const auto add = [&](const Offset& offset) {
    const std::size_t first = stroke.curves.size();
    const OffsetBranches more = branches_of(offset);
    for (std::size_t k = 0; k < more.curves.size(); ++k) {
      stroke.curves.push_back(more.curves[k]);
      stroke.behind.push_back(more.behind[k] == no_segment ? no_segment : first + more.behind[k]);
      stroke.turns.push_back(more.turns[k]);
      const OffsetPiece& piece = offset.pieces[k];
      made.signs.push_back(piece.is_join ? 0 : constant_sign(path[piece.segment].multiplier()));
    }
  };
  const auto add_cap = [&](const std::vector<RationalCurve>& cap) {
    for (const RationalCurve& arc : cap) {
      stroke.curves.push_back(arc);
      stroke.behind.push_back(stroke.curves.size());
      stroke.turns.emplace_back();
      made.signs.push_back(0);
    }
  };
  add(own);
  if (!is_closed && !own.pieces.empty()) {
    stroke.behind.back() = stroke.curves.size();
    add_cap(offsets.end_cap(own.distance));
    stroke.behind.back() = no_segment;
    add_cap(offsets.start_cap(own.distance));
    stroke.behind.back() = 0;
  }
  add(offsets.at(-own.distance));
  return made;
}

}  // namespace

TrimmedOffset trimmed_offset(const Path& path, const Gauge& gauge, const Rational& d,
                             OffsetJoin join) {
  const GaugeOffsets offsets(path, gauge);
  if (!offsets.none().empty())
    throw DomainError(fmt::format(
        "trimmed_offset: segment {} has no rational offset under this gauge, so that what is left "
        "is not known",
        offsets.none().front().segment + 1));
  const std::vector<RationalCurve> along = curves_of(path);
  TrimmedOffset result{offsets.at(d, join == OffsetJoin::mitre ? join : OffsetJoin::round), {}, {}};
  const auto& pieces = result.offset.pieces;
  const Stroke stroke = stroke_of(along, path.is_closed(), offsets, result.offset);
  const GaugeCover cover(along, gauge, d);
  const MitreKites kites(result.offset, [&](std::size_t k) { return point(along[k], 0); });
  const auto center_around = [&](std::size_t piece, const Rational& t) {
    const OffsetPiece& of = pieces[piece];
    const Vector<Rational> at = point(of.curve, t);
    return of.is_join ? cover.center_around(at)
                      : cover.center_around(at, of.segment, double_zero(t));
  };
  BoundaryCurves curves{
      stroke.branches, pieces.size(), {}, events_at_turns(along, result.offset, cover.form())};
  curves.centers.resize(stroke.branches.curves.size());
  curves.signs = stroke.signs;
  curves.covers = [&](const PlaneBox& box) { return cover.covers(box); };
  curves.is_cut = [&](std::size_t piece, const Rational& t) {
    return center_around(piece, t) || kites.contain(point(pieces[piece].curve, t));
  };
  curves.is_covered = [&](std::size_t piece, const Rational& from, const Rational& to) {
    const auto center = center_around(piece, (from + to) / 2);
    return center && cover.is_nearer_along(pieces[piece].curve, from, to, *center);
  };
  if (!std::ranges::all_of(along, constant_sign,
                           &RationalCurve::multiplier))  // then all go along e₁
    curves.is_backward = [&](std::size_t piece, const Rational& t) {
      return pieces[piece].curve.multiplier()(t).sign() ==
             -sign_after_zero(along.front().multiplier());
    };
  TrimmedCurves left = trimmed(curves, "trimmed_offset");
  result.branches = std::move(left.branches);
  result.undecided = std::move(left.undecided);
  if (join == OffsetJoin::open) result.branches = without_joins(result);
  return result;
}

BranchMeasure measure(const TrimmedOffset& trimmed, const TrimmedBranch& branch) {
  std::vector<Real> lengths;
  std::vector<Real> areas;
  for (const OffsetPart& part : branch.parts) {
    const RationalCurve& curve = trimmed.offset.pieces[part.piece].curve;
    const PathLength length{Path(segment_of(curve))};
    const auto between = [&](const auto& f) { return cached(f(part.to) + -f(part.from)); };
    lengths.push_back(Real(Rational(way_along(part))) *
                      between([&](const Real& t) { return length.value(Place(0, t)); }));
    const auto& [x, y, z] = curve.numerator();
    const SegmentIntegral area{TaylorIntegral(
        {Rational(1, 2) * (x * differentiate(y) - y * differentiate(x)), pow(curve.weight(), 2)})};
    areas.push_back(between([&](const Real& t) { return area.value(t); }));
  }
  return {sum_of(std::move(lengths)),
          branch.is_closed ? std::optional(sum_of(std::move(areas))) : std::nullopt};
}

}  // namespace phrame
