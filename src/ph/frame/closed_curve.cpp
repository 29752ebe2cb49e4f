#include "phrame/ph/frame/closed_curve.hpp"

#include <array>

#include "phrame/algebra/argument.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/shape.hpp"

// The frame of v turns as e₂ = v × e₁ does, and so does e₃, the part of v across the tangent: a
// copy of the curve shifted a little along e₃ is linked with it as one shifted along v.
//
// Of a PH curve, α = arg(v·AjA* + i v·AkA*) is the angle from the Euler–Rodrigues frame to e₃, so
// that the frame of v turns by ∫2h/σ + α(1) − α(0). With f < 0 the tangent is −e₁.

namespace phrame {
namespace {

const std::array<Vector<Rational>, 9> projections{{{0, 0, 1},
                                                   {1, 2, 5},
                                                   {-3, 1, 4},
                                                   {5, 3, -2},
                                                   {2, -7, 3},
                                                   {7, 4, 1},
                                                   {1, -11, -6},
                                                   {-13, 5, 17},
                                                   {19, -23, 29}}};

void check_closed(const PhPath& path) {
  if (!path.closing_turn()) throw DomainError("the curve is not closed with a continuous tangent");
  Signs signs;
  for (const Curve& curve : path.segments()) {
    const Signs of = multiplier_signs(curve);
    signs.positive = signs.positive || of.positive;
    signs.negative = signs.negative || of.negative;
  }
  if (signs.positive && signs.negative)
    throw DomainError("the curve turns back at a cusp, so that it has no writhe");
}

void check_closed(const Path& path) {
  if (!path.ends_meet()) throw DomainError("the curve is not closed: its ends do not meet");
  if (!path.is_closed())
    throw DomainError("the curve is not closed: its tangent breaks where its ends meet");
  for (const Segment& segment : path.segments())
    if (const RationalCurve* curve = rational_curve(segment);
        curve != nullptr && count_real_roots(curve->multiplier(), {0, 1}) > 0)
      throw DomainError("the curve has a cusp, so that it has no writhe");
}

RealBall in_turns(const RealBall& angle, long bits) {
  return divide(angle, times_power_of_two(pi(bits), 1), bits);
}

template <class C>
ClosedFrame first_closed_frame(const C& curve) {
  for (const Vector<Rational>& v : projections)
    if (auto frame = closed_frame(curve, v)) return *std::move(frame);
  throw Undecided(
      "the crossings of the curve are not told apart within arcs of 2^-30 of it, by 9 projections: "
      "it meets itself, or nearly so");
}

/// v·AjA* + i v·AkA*.
GaussianPolynomial part_across(const QuaternionPolynomial& a, const Vector<Rational>& v) {
  const Vector<Polynomial> second = rotated_j(a);
  const Vector<Polynomial> third = rotated_k(a);
  GaussianPolynomial part{{}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    part.re += Polynomial{v[k]} * second[k];
    part.im += Polynomial{v[k]} * third[k];
  }
  return part;
}

}  // namespace

std::optional<ClosedFrame> closed_frame(const PhPath& path, const Vector<Rational>& v) {
  check_closed(path);
  std::vector<ContinuousArgument> angles;
  try {
    for (const Curve& curve : path.segments())
      angles.emplace_back(part_across(without_real_content(curve.preimage()), v));
  } catch (const DomainError&) {
    return std::nullopt;  // v is tangent somewhere
  }
  const auto crossings = self_crossings(series_of(path), v);
  if (!crossings) return std::nullopt;
  const Real own_turn = erf_twist(path).value;
  const auto twist = [angles, own_turn](long bits) {
    const long more = bits + 16;
    RealBall turn = own_turn.enclose(more);
    for (const ContinuousArgument& angle : angles)
      turn = add(turn, angle.difference(1, more), more);
    return in_turns(turn, more);
  };
  return ClosedFrame{v, sum_of_signs(*crossings), Real(twist)};
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
  const Real turn = -angle->value({path.segments().size() - 1, Rational(1)});
  return ClosedFrame{v, sum_of_signs(*crossings), Real([turn](long bits) {
                       return in_turns(turn.enclose(bits + 8), bits + 8);
                     })};
}

ClosedFrame closed_frame(const Path& path) { return first_closed_frame(path); }
ClosedFrame closed_frame(const PhPath& path) { return first_closed_frame(path); }

Real writhe(const ClosedFrame& frame) { return Real(Rational(frame.linking)) + -frame.twist; }

namespace {

/// In a plane all three vectors of Gauss's determinant are.
template <class P>
Real writhe_of(const P& path) {
  check_closed(path);
  if (plane_normal(path)) return Rational(0);
  return writhe(closed_frame(path));
}

}  // namespace

Real writhe(const PhPath& path) { return writhe_of(path); }
Real writhe(const Path& path) { return writhe_of(path); }

Real holonomy(const ClosedFrame& frame) {
  const Real turn([twist = frame.twist](long bits) {
    const RealBall turns = subtract({}, twist.enclose(bits + 8), bits + 8);
    return multiply(turns, times_power_of_two(pi(bits + 8), 1), bits + 8);
  });
  return reduced(turn).angle;
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

long linking_number(const CurveSeries& first, const CurveSeries& second) {
  for (const Vector<Rational>& v : projections)
    if (const auto crossings = mutual_crossings(first, second, v))
      return sum_of_signs(*crossings) / 2;
  throw Undecided(
      "the crossings of the curves are not told apart within arcs of 2^-30 of them, by 9 "
      "projections: they meet, or nearly so");
}

}  // namespace phrame
