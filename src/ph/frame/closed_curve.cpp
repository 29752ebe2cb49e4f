#include "phrame/ph/frame/closed_curve.hpp"

#include <fmt/format.h>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/crossings.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/special_points.hpp"

// At a corner the frame of v turns as along a small arc in its place, along which the tangent goes
// the shorter way on a great circle.
//
// The frame of v turns as e₂ = v × e₁ does, and so does e₃, the part of v across the tangent: a
// copy of the curve shifted a little along e₃ is linked with it as one shifted along v.

namespace phrame::inline v0 {
namespace {

/// The signs of the multiplier. Throws DomainError where a curve that is not PH has a cusp.
Signs signs_along(const Segment& segment) {
  if (const Curve* ph = ph_curve(segment)) return multiplier_signs(*ph);
  if (!cusps(segment).empty()) throw DomainError("the curve has a cusp, so that it has no writhe");
  return {orientation(segment) > 0, orientation(segment) < 0};
}

void check_closed(const Path& path) {
  if (!path.ends_meet()) throw DomainError("the curve is not closed: its ends do not meet");
  if (!path.is_closed())
    throw DomainError("the curve is not closed: its tangent turns back where its ends meet");
  Signs signs;
  for (const Segment& segment : path.segments()) {
    const Signs of = signs_along(segment);
    signs.positive = signs.positive || of.positive;
    signs.negative = signs.negative || of.negative;
  }
  if (signs.positive && signs.negative)
    throw DomainError("the curve turns back at a cusp, so that it has no writhe");
}

RealBall in_turns(const RealBall& angle, long bits) {
  return divide(angle, times_power_of_two(pi(bits), 1), bits);
}

}  // namespace

const std::array<Vector<Rational>, 9>& writhe_projections() {
  static const std::array<Vector<Rational>, 9> list{{{0, 0, 1},
                                                     {1, 2, 5},
                                                     {-3, 1, 4},
                                                     {5, 3, -2},
                                                     {2, -7, 3},
                                                     {7, 4, 1},
                                                     {1, -11, -6},
                                                     {-13, 5, 17},
                                                     {19, -23, 29}}};
  return list;
}

std::optional<ClosedFrame> closed_frame(const Path& path, const Vector<Rational>& v) {
  check_closed(path);
  std::optional<PathAngle> angle;
  try {
    angle.emplace(path, v);
  } catch (const DomainError&) {
    return std::nullopt;  // v is tangent somewhere
  } catch (const Undecided&) {
    return std::nullopt;  // or may be
  }
  const auto crossings = self_crossings(series_of(path), v);
  if (!crossings) return std::nullopt;
  const Real theta = angle->value({path.segments().size() - 1, Rational(1)});
  const Real turn = -(theta + angle->turn_of_ends());
  return ClosedFrame{v, sum_of_signs(*crossings), Real([turn](long bits) {
                       return in_turns(turn.enclose(bits + 8), bits + 8);
                     })};
}

ClosedFrame closed_frame(const Path& path) {
  for (const Vector<Rational>& v : writhe_projections())
    if (auto frame = closed_frame(path, v)) return *std::move(frame);
  throw Undecided(
      "the crossings of the curve are not told apart within arcs of 2^-30 of it, by 9 projections: "
      "it meets itself, or nearly so");
}

Real writhe(const ClosedFrame& frame) { return Real(Rational(frame.linking)) + -frame.twist; }

// In a plane all three vectors of Gauss's determinant are.
Real writhe(const Path& path) {
  check_closed(path);
  if (plane_normal(path)) return Rational(0);
  return writhe(closed_frame(path));
}

long self_linking_number(const ClosedFrame& frame, const Real& torsion) {
  for (long bits = 32; bits <= 512; bits *= 4) {
    const RealBall turns = in_turns(torsion.enclose(bits), bits);
    const RealBall value = add(writhe(frame).enclose(bits), turns, bits);
    if (const auto whole = unique_integer(value); whole && absolute(value).is_finite())
      return static_cast<long>(*whole);
  }
  throw Undecided("the self-linking number is not told within 512 bits");
}

Real closing_turn_per_length(const Real& holonomy, const Real& length) {
  return Real([holonomy, length](long bits) {
    const long more = bits + 16;
    return divide((-holonomy).enclose(more), length.enclose(more), more);
  });
}

long linking_number(const Path& first, const Path& second) {
  for (const Path* path : {&first, &second})
    if (!path->ends_meet())
      throw DomainError(fmt::format("linking number: the {} curve is not closed",
                                    path == &first ? "first" : "second"));
  return linking_number(series_of(first), series_of(second));
}

long linking_number(const CurveSeries& first, const CurveSeries& second) {
  for (const Vector<Rational>& v : writhe_projections())
    if (const auto crossings = mutual_crossings(first, second, v))
      return sum_of_signs(*crossings) / 2;
  throw Undecided(
      "the crossings of the curves are not told apart within arcs of 2^-30 of them, by 9 "
      "projections: they meet, or nearly so");
}

}  // namespace phrame
