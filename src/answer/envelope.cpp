#include "phrame/answer/envelope.hpp"

#include <algorithm>

#include "phrame/answer/rounded.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/domain_boundary.hpp"

namespace phrame::inline v0 {
namespace {

std::vector<RealAlgebraic> places_of(const std::vector<RealRoot>& roots) {
  std::vector<RealAlgebraic> places;
  for (const RealRoot& root : roots) places.push_back(root.at);
  return places;
}

EnvelopeAnswer::OneSide one_side(const MinkowskiCurve& curve, Side side) {
  const PlaneDirection n = envelope_normal(curve, side, 0);
  const auto& [x, y, r] = curve.start;
  EnvelopeAnswer::OneSide found{std::nullopt, {x + r * n.x, y + r * n.y, 0}, {}};
  if (const auto made = envelope_side(curve, side)) {
    found.curve = Path(segment_of(*made));
    found.cusps = places_of(odd(real_roots(made->multiplier(), open_interval(0, 1))));
  }
  return found;
}

EnvelopeAnswer::Segment described(const MinkowskiCurve& curve) {
  long degree = 0;
  for (const Polynomial& x : position(curve)) degree = std::max(degree, x.degree());
  const Polynomial sigma = curve.multiplier * spacelike_root(curve);
  return {curve,
          degree,
          null_factors(curve),
          sigma,
          places_of(real_roots(sigma, closed_interval(0, 1))),
          one_side(curve, Side::right),
          one_side(curve, Side::left)};
}

/// That of a point of a piece.
Real parameter(const EnvelopePiece& piece, const Real& t) {
  const Rational first(static_cast<long>(piece.segment));
  switch (piece.kind) {
    case EnvelopePiece::Kind::left:
      return Real(first + 1) + -t;
    case EnvelopePiece::Kind::start_cap:
      return first;
    case EnvelopePiece::Kind::end_cap:
      return Rational(first + 1);
    case EnvelopePiece::Kind::right:
      break;
  }
  return Real(first) + t;
}

void add_boundary(const DomainBoundary& boundary, long digits, EnvelopeAnswer& answer) {
  const auto& pieces = boundary.envelope.pieces;
  const auto end = [&](const EnvelopePiece& piece, const Real& t) {
    return boundary_end(piece.curve, t, parameter(piece, t), digits);
  };
  for (const TrimmedBranch& branch : boundary.branches) {
    EnvelopeAnswer::Branch made{branch.is_closed, {}, paths(boundary, branch, digits)};
    for (const OffsetPart& part : branch.parts) {
      const EnvelopePiece& piece = pieces[part.piece];
      made.pieces.push_back({end(piece, part.from), end(piece, part.to), piece.kind});
    }
    answer.branches.push_back(std::move(made));
  }
  for (const UndecidedStretch& x : boundary.undecided) {
    const auto place = [&](const Rational& t) {
      return round_to_decimal(parameter(pieces[x.piece], t), 12);
    };
    answer.undecided.push_back({{place(x.t.lower()), place(x.t.upper())}, pieces[x.piece].kind});
  }
}

}  // namespace

EnvelopeAnswer answer(const NamedAxis& axis, const EnvelopeQuery& query) {
  EnvelopeAnswer made{axis.name, {}, 0, {}, query.trim, {}, {}};
  if (query.trim)
    add_boundary(domain_boundary(axis.segments), query.digits, made);
  else
    made.paths = paths(envelope(axis.segments));
  made.greatest_radius = greatest_radius(axis.segments);
  for (const MinkowskiCurve& curve : axis.segments) made.segments.push_back(described(curve));
  return made;
}

std::vector<Path> all_paths(const EnvelopeAnswer& answer) {
  std::vector<Path> all = answer.paths;
  for (const auto& branch : answer.branches)
    all.insert(all.end(), branch.paths.begin(), branch.paths.end());
  return all;
}

}  // namespace phrame
