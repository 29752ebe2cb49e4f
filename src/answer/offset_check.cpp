// Both are cubics within a thousandth of the tolerance, or of |d| where that is less, or what
// doubles tell anyway, and of these greatest_gap() tells.
#include "phrame/answer/offset_check.hpp"

#include <algorithm>
#include <functional>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/boundary.hpp"
#include "phrame/ph/offset/offset_trim.hpp"
#include "phrame/ph/offset/plane_gap.hpp"

namespace phrame::inline v0 {
namespace {

/// Parts of curves, and what is said of a place on them.
class CheckedParts {
 public:
  explicit CheckedParts(const Rational& error) : parts{{}, {}, error} {}

  void add(const RationalCurve& curve, const Rational& from, const Rational& to,
           const Rational& first, bool is_join) {
    for (CubicPart& part : plane_cubics(curve, from, to, parts.error / 2)) add(std::move(part));
    curves_.push_back({first, is_join});
  }
  void add_line(const Vector<Rational>& a, const Vector<Rational>& b, std::size_t number) {
    PlaneCubic cubic;
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 2; ++k)
        cubic[j][k] = a[k] + Rational(static_cast<long>(j), 3) * (b[k] - a[k]);
    add({cubic, 0, 1});
    curves_.push_back({static_cast<long>(number), false});
  }

  OffsetCheckAnswer::Side said(PlaneGap gap) const {
    constexpr std::size_t most = 100;
    OffsetCheckAnswer::Side side{
        gap.lower, gap.upper, place(gap.farthest), {}, gap.stretches.size()};
    std::ranges::stable_sort(gap.stretches, std::greater(), &GapStretch::at_least);
    for (const GapStretch& x : gap.stretches) {
      if (side.stretches.size() == most) break;
      side.stretches.push_back(
          {place(x.from), place(x.to), place(x.farthest), exact_rational(x.at_least), x.is_proved});
    }
    return side;
  }

  PlaneParts parts;

 private:
  struct Of {
    Rational first;  ///< t where it begins
    bool is_join;
  };

  void add(CubicPart part) {
    parts.parts.push_back(std::move(part));
    parts.curves.push_back(curves_.size());
  }

  OffsetCheckAnswer::Place place(const GapPlace& at) const {
    constexpr long digits = 9;
    const auto& [first, is_join] = curves_[parts.curves[at.part]];
    const Rational t = is_join ? first : first + parameter(parts, at);
    const auto [x, y] = point(parts, at);
    return {round_to_decimal(t, digits),
            is_join,
            {round_to_decimal(x, digits), round_to_decimal(y, digits)}};
  }

  std::vector<Of> curves_;
};

/// The exact offset, and whether all of it is closed.
struct ExactParts {
  CheckedParts parts;
  bool is_closed = true;
};

void add_piece(ExactParts& exact, const PhPath& path, const OffsetPiece& piece,
               const Rational& from, const Rational& to) {
  const bool is_last = piece.is_join && piece.segment == 0;
  exact.parts.add(piece.curve, from, to,
                  is_last ? path.end() : Rational(static_cast<long>(piece.segment)), piece.is_join);
}

/// A fraction by which the point is moved by less than the tolerance.
Rational end_of(const RationalCurve& curve, const Real& t, const Rational& tolerance) {
  if (t.exact()) return *t.exact();
  const RealBall near = t.enclose(256);
  const Vector<Rational> gap = point(curve, near.upper()) - point(curve, near.lower());
  if (abs(gap[0]) + abs(gap[1]) > tolerance)
    throw Undecided("offset: where the trimmed offset is cut is not told well enough to check it");
  return near.midpoint();
}

ExactParts exact_parts(const PhPath& path, const OffsetCheckQuery& query, const Rational& error) {
  ExactParts exact{CheckedParts(error)};
  if (!query.trim) {
    const Offset made = offset(path, query.distance, query.join);
    for (const OffsetPiece& piece : made.pieces) add_piece(exact, path, piece, 0, 1);
    exact.is_closed = std::ranges::all_of(made.meets, [](bool meets) { return meets; });
    return exact;
  }
  const TrimmedOffset trimmed = trimmed_offset(path, query.distance, query.join);
  if (!trimmed.undecided.empty())
    throw Undecided(
        "offset: places of the trimmed offset are undecided, so that nothing can be "
        "checked against it (\"phrame offset --trim\" lists them)");
  if (trimmed.branches.empty())
    throw DomainError("offset: nothing is left of the trimmed offset to check against");
  for (const TrimmedBranch& branch : trimmed.branches) {
    exact.is_closed = exact.is_closed && branch.is_closed;
    for (const OffsetPart& part : branch.parts) {
      const OffsetPiece& piece = trimmed.offset.pieces[part.piece];
      const Rational from = end_of(piece.curve, part.from, error / 4);
      const Rational to = end_of(piece.curve, part.to, error / 4);
      if (from < to) add_piece(exact, path, piece, from, to);
    }
  }
  return exact;
}

}  // namespace

OffsetCheckAnswer answer(const NamedPath& named, const OffsetCheckQuery& query) {
  require_plane(named.path, "path");
  const auto path = named.path.with_preimages();
  if (!path) throw InputError("path", "it is not Pythagorean-hodograph");
  if (query.distance == 0) throw InputError("distance", "0 is no distance");
  const Rational distance = abs(query.distance);
  const Rational error =
      std::max(std::min(query.tolerance, distance) / 1000, distance * power_of_ten(-11));
  const ExactParts exact = exact_parts(*path, query, error);
  CheckedParts given(error);
  std::size_t number = 0;
  std::size_t closed = 0;
  for (auto points : query.given.polylines) {
    if (exact.is_closed && points.front() != points.back()) {
      points.push_back(points.front());
      ++closed;
    }
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      given.add_line(points[k], points[k + 1], number++);
  }
  for (const Path& other : query.given.paths) {
    std::vector<const RationalCurve*> curves;
    for (const Segment& segment : other.segments()) {
      curves.push_back(rational_curve(segment));
      if (curves.back() == nullptr) throw InputError("given", "a curve by formulas is not checked");
      given.add(*curves.back(), 0, 1, static_cast<long>(number++), false);
    }
    const Vector<Rational> start = point(*curves.front(), 0);
    const Vector<Rational> end = point(*curves.back(), 1);
    if (exact.is_closed &&
        std::ranges::all_of(curves, [](const auto* curve) { return is_line(*curve); }) &&
        start != end) {
      given.add_line(end, start, number++);
      ++closed;
    }
  }
  if (number == 0) throw InputError("given", "there is nothing to check");
  OffsetCheckAnswer found{
      named,
      query,
      closed,
      exact.parts.said(greatest_gap(exact.parts.parts, given.parts, query.tolerance)),
      given.said(greatest_gap(given.parts, exact.parts.parts, query.tolerance)),
      false,
      false};
  found.passes = std::max(found.missing.at_most, found.excess.at_most) <= query.tolerance;
  found.is_decided =
      found.passes || std::max(found.missing.at_least, found.excess.at_least) > query.tolerance;
  return found;
}

}  // namespace phrame
