#include "phrame/ph/curve/ph_path.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/vector.hpp"

// Unit tangents are ±A i A*/σ, A without its real content, the sign that of f on the inner side.
// Let v = A(end), w = B(start) and v̄w = z + y·j with z, y ∈ ℚ(i). The tangents v i v* and w i w*
// have the same direction iff y = 0, and opposite ones iff z = 0. Else z/|z| = e^{iφ} with v̄w ∥ (r
// + x·j) e^{iφ}, r > 0: seen from the frame of v, r + x·j is the least rotation that takes i to the
// new tangent, since its axis is normal to i, and from there the frame is turned by 2φ about it.
// With w·z̄ in the place of w there is no such turn.

namespace phrame::inline v0 {
namespace {

/// What the frame at an end of a curve depends on: A up to a positive factor, and the sign of f.
struct End {
  RationalQuaternion a;
  int sign;
};

End start_of(const Curve& curve) {
  return {evaluate(without_real_content(curve.preimage()), 0), sign_after_zero(curve.multiplier())};
}

End end_of(const Curve& curve) {
  return {evaluate(without_real_content(curve.preimage()), 1), sign_before_one(curve.multiplier())};
}

/// The tangent, r′/|r′|, scaled such that its largest component is ±1.
Vector<Rational> direction(const End& end) {
  Vector<Rational> d = rotated_i(end.a);
  const Rational size = std::max({Rational(abs(d[0])), Rational(abs(d[1])), Rational(abs(d[2]))});
  for (Rational& x : d) x *= end.sign / size;
  return d;
}

/// How two ends meet.
struct Meeting {
  GaussianRational turn;  ///< z, which is not 0
  bool is_corner;         ///< do the tangents differ?
};
/// No value where the tangent turns back, or e₁ would be reversed.
std::optional<Meeting> meeting(const End& v, const End& w) {
  const RationalQuaternion q = conjugate(v.a) * w.a;
  if (v.sign != w.sign || (q.u == 0 && q.v == 0)) return std::nullopt;
  return Meeting{{q.u, q.v}, q.p != 0 || q.q != 0};
}

/// The same curve with A·c and f/|c|².
Curve turned(const Curve& curve, const GaussianInteger& c) {
  if (c == GaussianInteger{1, 0}) return curve;
  const QuaternionPolynomial factor{Polynomial{Rational(c.re)}, Polynomial{Rational(c.im)}, {}, {}};
  const Polynomial slower{Rational(1) / Rational(norm(c))};
  return curve.with_form(curve.preimage() * factor, slower * curve.multiplier());
}

}  // namespace

PhPath::PhPath(Curve first) : segments_{std::move(first)} {
  Curve& curve = segments_.front();
  if (sign_after_zero(curve.multiplier()) < 0) curve = turned_over(curve);
}

PhPath PhPath::of_continuous(std::vector<Curve> segments, std::vector<std::size_t> corners) {
  PhPath path;
  path.segments_ = std::move(segments);
  path.corners_ = std::move(corners);
  return path;
}

void PhPath::append(const Curve& next) {
  Continuation found = continuation(segments_.back(), next);
  if (found.is_corner) corners_.push_back(segments_.size());
  segments_.push_back(std::move(found.curve));
}

Continuation continuation(const Curve& last, const Curve& next) {
  const Vector<Rational> here = end_point(last);
  if (next.start() != here)
    throw DomainError(fmt::format("it starts at {}, but the spline ends at {}",
                                  abbreviated(next.start()), abbreviated(here)));
  const End before = end_of(last);
  const Curve same_side =
      before.sign == sign_after_zero(next.multiplier()) ? next : turned_over(next);
  const auto found = meeting(before, start_of(same_side));
  if (!found)
    throw DomainError(
        fmt::format("the tangent turns back: the spline ends in the direction {}, and it starts in "
                    "the opposite "
                    "one, so that frames are undefined there",
                    abbreviated(direction(before))));
  return {turned(same_side, conjugate(primitive_multiple(found->turn))), found->is_corner};
}

PhPath joined(const std::vector<Curve>& curves) {
  PhPath path(curves.front());
  for (std::size_t k = 1; k < curves.size(); ++k) path.append(curves[k]);
  return path;
}

bool PhPath::ends_meet() const { return ends_at(segments_.back(), segments_.front().start()); }

std::optional<GaussianRational> PhPath::closing_turn() const {
  return phrame::closing_turn(segments_.front(), segments_.back());
}

std::optional<GaussianRational> closing_turn(const Curve& first, const Curve& last) {
  if (!ends_at(last, first.start())) return std::nullopt;
  const auto found = meeting(end_of(last), start_of(first));
  return found ? std::optional(found->turn) : std::nullopt;
}

PathParameter locate(const PhPath& path, const Rational& t) {
  return path.is_curve() ? PathParameter{0, t} : locate_inside(path, t);
}

PathParameter locate_inside(const PhPath& path, const Rational& t) {
  return locate_inside(path.segments().size(), t);
}

PathParameter locate_inside(std::size_t count, const Rational& t) {
  if (t < 0 || t > Rational(count))
    throw DomainError(fmt::format("t = {} is outside [0, {}]", as_written(t), count));
  const std::size_t k = std::min(static_cast<std::size_t>(static_cast<long>(floor(t))), count - 1);
  return {k, t - Rational(k)};
}

Rational parameter(const PathParameter& at) {
  return Rational(static_cast<long>(at.segment)) + at.t;
}

}  // namespace phrame
