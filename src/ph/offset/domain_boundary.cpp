// The boundary curves are the envelope: a point of the boundary of the union is on a disc, which it
// touches, or on the cap of one at an end. What is folded back, and where another stretch ends on
// that, is inside of discs; so is where s changes its sign, as the gap |center − Q|² − radius² has
// the derivatives 0, 0, 0 and 2f·s′·(radius·n′·τ) there, unless that is a cusp.
#include "phrame/ph/offset/domain_boundary.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/axis_end.hpp"
#include "phrame/ph/offset/disc_cover.hpp"
#include "phrame/ph/offset/shadow.hpp"

namespace phrame::inline v0 {
namespace {

bool is_cap(const EnvelopePiece& piece) {
  return piece.kind == EnvelopePiece::Kind::start_cap || piece.kind == EnvelopePiece::Kind::end_cap;
}

/// Where a piece goes the other way than the boundary would: 2f·s is negative there.
class Folds {
 public:
  Folds(const EnvelopePiece& piece, const Polynomial& s) {
    if (is_cap(piece)) return;
    const Polynomial sign = piece.curve.multiplier() * s;
    for (const RealRoot& root : real_roots(sign, open_interval(0, 1)))
      roots_.push_back(enclose(root.at, 64));
    for (std::size_t k = 0; k <= roots_.size(); ++k) {
      const Rational from = k == 0 ? Rational(0) : roots_[k - 1].upper();
      const Rational to = k == roots_.size() ? Rational(1) : roots_[k].lower();
      is_folded_.push_back(from < to && sign((from + to) / 2) < 0);
    }
  }

  bool contain(const Interval& part) const {
    if (is_folded_.empty()) return false;
    std::size_t k = 0;
    while (k < roots_.size() && roots_[k].upper() < *part.lower) ++k;
    return is_folded_[k] && (k == roots_.size() || *part.upper < roots_[k].lower());
  }

 private:
  std::vector<RealBall> roots_;
  std::vector<bool> is_folded_;  ///< before each of them, and behind the last one
};

/// Of its segment.
Rational parameter(const EnvelopePiece& piece, const Rational& t) {
  return piece.kind == EnvelopePiece::Kind::left ? 1 - t : t;
}

/// Of each segment the start and the end.
std::vector<AxisEnd> ends_of(const MedialAxis& axis) {
  std::vector<AxisEnd> ends;
  for (const MinkowskiCurve& curve : axis)
    for (const long t : {0L, 1L}) ends.push_back(end_of(curve, t));
  return ends;
}

/// The disc of a cap.
const Vector<Rational>& disc_of(const EnvelopePiece& cap, const std::vector<AxisEnd>& ends) {
  return ends[2 * cap.segment + (cap.kind == EnvelopePiece::Kind::end_cap ? 1 : 0)].disc;
}

/// Where sides end on caps.
std::vector<BoundaryEvent> events_of(const Envelope& envelope, const std::vector<AxisEnd>& ends) {
  std::vector<BoundaryEvent> events;
  for (std::size_t k = 0; k < envelope.pieces.size(); ++k) {
    const EnvelopePiece& piece = envelope.pieces[k];
    if (!is_cap(piece)) continue;
    const Vector<Rational>& disc = disc_of(piece, ends);
    for (const AxisEnd& end : ends) {
      if (end.disc != disc) continue;
      for (const PlaneDirection& n : {end.right, end.left}) {
        const Vector<Rational> at{disc[0] + disc[2] * n.x, disc[1] + disc[2] * n.y, 0};
        for (const RealAlgebraic& x : through(piece.curve, at, open_interval(0, 1)))
          events.push_back({k, x});
      }
    }
  }
  return events;
}

}  // namespace

DomainBoundary domain_boundary(MedialAxis axis) {
  DomainBoundary result{envelope(std::move(axis)), {}, {}};
  const Envelope& whole = result.envelope;
  std::vector<DiscTrack> tracks;
  for (std::size_t k = 0; k < whole.axis.size(); ++k) {
    const auto turns = odd(real_roots(whole.axis[k].multiplier, open_interval(0, 1)));
    if (!turns.empty())
      throw DomainError(
          fmt::format("domain_boundary: the axis turns back at a cusp, in segment {} at {}", k + 1,
                      place_text("t", turns.front().at)));
    const Vector<Polynomial> disc = position(whole.axis[k]);
    tracks.push_back({disc[0], disc[1], disc[2], {1}});
  }
  const DiscCover discs(tracks);
  const auto& pieces = whole.pieces;
  std::vector<Polynomial> s;  // at the parameter of each piece
  std::vector<Folds> folds;
  for (const EnvelopePiece& piece : pieces) {
    s.push_back(spacelike_root(whole.axis[piece.segment]));
    if (piece.kind == EnvelopePiece::Kind::left) s.back() = compose(s.back(), {1, -1});
    folds.emplace_back(piece, s.back());
  }
  const auto disc_around = [&](std::size_t k, const Rational& t) {
    const EnvelopePiece& piece = pieces[k];
    const Polynomial known = !is_cap(piece) ? double_zero(parameter(piece, t))
                             : piece.kind == EnvelopePiece::Kind::start_cap ? Polynomial{0, 1}
                                                                            : Polynomial{1, -1};
    return discs.disc_around(point(piece.curve, t), piece.segment, known);
  };
  const std::vector<AxisEnd> ends = ends_of(whole.axis);
  BoundaryCurves curves{branches_of(whole), pieces.size(), {}, events_of(whole, ends), true};
  for (const EnvelopePiece& piece : pieces) {
    curves.centers.emplace_back();
    if (!is_cap(piece)) continue;
    const auto& [x, y, radius] = disc_of(piece, ends);
    curves.centers.back() = Vector<Rational>{x, y, 0};
  }
  curves.covers = [&](const PlaneBox& box) { return discs.covers(box); };
  curves.is_folded = [&](const CurvePart& part) {
    return folds[part.segment].contain(interval_of(part));
  };
  curves.is_cut = [&](std::size_t k, const Rational& t) { return disc_around(k, t).has_value(); };
  curves.is_covered = [&](std::size_t k, const Rational& from, const Rational& to) {
    const auto disc = disc_around(k, (from + to) / 2);
    return disc && is_nearer_along(pieces[k].curve, from, to, as_polynomials(disc->center), 0,
                                   disc->radius);
  };
  curves.is_backward = [&](std::size_t k, const Rational& t) {
    return !is_cap(pieces[k]) && s[k](t) < 0;
  };
  TrimmedCurves left = trimmed(curves, "domain_boundary");
  result.branches = std::move(left.branches);
  result.undecided = std::move(left.undecided);
  return result;
}

std::vector<Path> paths(const DomainBoundary& boundary, const TrimmedBranch& branch, long digits) {
  return branch_paths(
      branch,
      [&](std::size_t piece) -> const RationalCurve& {
        return boundary.envelope.pieces[piece].curve;
      },
      greatest_radius(boundary.envelope.axis), digits);
}

}  // namespace phrame
