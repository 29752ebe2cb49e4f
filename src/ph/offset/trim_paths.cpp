// (X/W)(t) + δ·w(1 − t)ⁿ/W(t), w = W(0), is a rational curve of the same degree that starts at
// X(0)/W(0) + δ, and differs from X/W by δ at most where no W is less than w·(1 − t)ⁿ, as where all
// Bernstein coefficients of W are positive.
#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/offset_trim.hpp"

namespace phrame::inline v0 {
namespace {

Rational rounded(const Rational& x, long places) {
  const Rational unit = power_of_ten(-places);
  return unit * Rational(floor(x / unit + Rational(1, 2)));
}

Rational rounded(const Real& t, long places) {
  if (t.exact()) return *t.exact();
  return rounded(t.enclose(4 * places + 64).midpoint(), places);
}

/// The part from t to t, with its ends moved.
RationalCurve part_of(const RationalCurve& curve, const Rational& from, const Rational& to,
                      const Vector<Rational>& start, const Vector<Rational>& end) {
  const Polynomial t{from, to - from};
  Polynomial weight = compose(curve.weight(), t);
  Vector<Polynomial> numerator;
  long degree = weight.degree();
  for (std::size_t k = 0; k < 3; ++k) {
    numerator[k] = compose(curve.numerator()[k], t);
    degree = std::max(degree, numerator[k].degree());
  }
  const Polynomial near_start = weight(0) * pow(Polynomial{1, -1}, degree);
  const Polynomial near_end = weight(1) * Polynomial::monomial(1, degree);
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational at_start = start[k] - numerator[k](0) / weight(0);
    const Rational at_end = end[k] - numerator[k](1) / weight(1);
    numerator[k] += at_start * near_start + at_end * near_end;
  }
  return RationalCurve(numerator, weight);
}

/// A part with its ends as fractions.
struct CutPart {
  const RationalCurve& curve;
  Rational from;
  Rational to;
  Vector<Rational> start;
  Vector<Rational> end;

  /// Does the curve turn back at the end t, known to so many places? There it may not be moved by
  /// more than the square of a unit, or it would do so on the part.
  bool turns_at(const Rational& t, long places) const {
    const Rational unit = power_of_ten(-places);
    const auto sign_at = [&](const Rational& x) { return curve.multiplier()(x).sign(); };
    return sign_at(t - unit) * sign_at(t + unit) < 0;
  }
  /// The end as a fraction, on the part where the curve turns back there.
  Rational end_at(const Real& t, const Rational& other, long places) const {
    const Rational near = rounded(t, places);
    if (t.exact() || !turns_at(near, places)) return near;
    const Rational unit = power_of_ten(-places);
    return near + (near < other ? unit : -unit);
  }
};

class BranchPath {
 public:
  BranchPath(const TrimmedBranch& branch,
             const std::function<const RationalCurve&(std::size_t piece)>& curve_of,
             const Rational& size, long digits)
      : places_(digits + 1 - decimal_exponent(abs(size))),
        parameter_places_(std::max(places_, digits) + 4) {
    for (const OffsetPart& part : branch.parts) add(curve_of(part.piece), part);
    for (std::size_t k = 0; k + 1 < parts_.size(); ++k)
      join(branch.parts[k].to, parts_[k], branch.parts[k + 1].from, parts_[k + 1]);
    if (branch.is_closed)
      join(branch.parts.back().to, parts_.back(), branch.parts.front().from, parts_.front());
  }

  std::vector<Path> make() const {
    std::vector<Path> found;
    for (const CutPart& part : parts_) {
      const bool is_whole = part.from == 0 && part.to == 1;
      Segment segment = segment_of(
          is_whole ? part.curve : part_of(part.curve, part.from, part.to, part.start, part.end));
      if (found.empty() || !goes_on(found.back(), segment)) found.emplace_back(std::move(segment));
    }
    return found;
  }

 private:
  void add(const RationalCurve& curve, const OffsetPart& part) {
    long places = parameter_places_;
    while (rounded(part.from, places) == rounded(part.to, places) && is_known(part.from) &&
           is_known(part.to))
      places *= 2;  // it is shorter than that
    const Rational from = rounded(part.from, places);
    const Rational to = rounded(part.to, places);
    CutPart cut{curve, from, to, {}, {}};
    cut.from = cut.end_at(part.from, to, places);
    cut.to = cut.end_at(part.to, from, places);
    cut.start = point(curve, cut.from);
    cut.end = point(curve, cut.to);
    parts_.push_back(std::move(cut));
  }

  /// The ends are made to meet.
  void join(const Real& s, CutPart& before, const Real& t, CutPart& after) const {
    if (before.end == after.start) return;
    const auto is_near = [&] {
      const Vector<Rational> gap = before.end - after.start;
      return abs(gap[0]) + abs(gap[1]) < power_of_ten(-places_);
    };
    // What is long has more digits to its parameters.
    long places = parameter_places_;
    while (!is_near() && places < 64 * parameter_places_ && is_known(s) && is_known(t)) {
      places *= 2;
      before.to = before.end_at(s, before.from, places);
      after.from = after.end_at(t, after.to, places);
      before.end = point(before.curve, before.to);
      after.start = point(after.curve, after.from);
    }
    if (!is_near()) return;  // and they are apart
    const bool turns_before = !s.exact() && before.turns_at(before.to, places - 1);
    const bool turns_after = !t.exact() && after.turns_at(after.from, places - 1);
    if (!s.exact() && !t.exact() && !turns_before && !turns_after)
      for (std::size_t k = 0; k < 2; ++k) before.end[k] = rounded(before.end[k], places_ + 1);
    if (t.exact() || turns_after) before.end = after.start;
    after.start = before.end;
  }

  /// Are there enclosures as narrow as one asks?
  static bool is_known(const Real& t) { return t.enclose(128).is_accurate(100); }

  static bool goes_on(Path& path, const Segment& next) {
    try {
      path.append(next);
    } catch (const DomainError&) {  // it turns back
      return false;
    }
    return true;
  }

  long places_;            ///< of points
  long parameter_places_;  ///< of t
  std::vector<CutPart> parts_;
};

}  // namespace

std::vector<Path> paths(const TrimmedOffset& trimmed, const TrimmedBranch& branch, long digits) {
  return branch_paths(
      branch,
      [&](std::size_t piece) -> const RationalCurve& { return trimmed.offset.pieces[piece].curve; },
      trimmed.offset.distance, digits);
}

std::vector<Path> branch_paths(
    const TrimmedBranch& branch,
    const std::function<const RationalCurve&(std::size_t piece)>& curve_of, const Rational& size,
    long digits) {
  return BranchPath(branch, curve_of, size, digits).make();
}

}  // namespace phrame
