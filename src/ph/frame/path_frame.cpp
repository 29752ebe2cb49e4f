#include "phrame/ph/frame/path_frame.hpp"

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

Vector<Real> over_size(const Vector<Real>& v, const Real& squared_size) {
  return {over_square_root(v[0], squared_size), over_square_root(v[1], squared_size),
          over_square_root(v[2], squared_size)};
}

/// The angle about H from e₂, which `second` is along, to n. Its form is known where all are exact.
Real angle_to(const Vector<Real>& n, const Vector<Real>& H, const Vector<Real>& second) {
  const Real x = dot(n, second);
  const Real y = dot(n, cross(H, second));
  const Real sigma = dot(H, H);
  const Real sine = over_square_root(y, sigma);
  if (!x.exact() || !y.exact() || !sigma.exact()) return argument_of(x, sine);
  return argument_of(
      x, sine, [x = *x.exact(), y = Rational(*y.exact() / *sigma.exact()), sigma = *sigma.exact()] {
        return AlgebraicAngle::argument(x, y, sigma);
      });
}

/// As least_rotation_normal() of H/|H|; exact where that may be, or is a multiple of it.
Vector<Real> least_rotation_normal_along(const Vector<Real>& H) {
  const Vector<Real> j = as_reals({0, 1, 0});
  if (H[1].exact() == Rational(0)) return j;
  const Real sigma = dot(H, H);
  const Real second = over_square_root(sigma, sigma) + H[0];  // |H| = σ/√σ
  return sign_of(H[1]) == 0 && sign_of(second) == 0 ? j : Vector<Real>{-H[1], second, Rational(0)};
}

/// The same numbers, which are exact.
Frame<Rational> exactly(const Frame<Real>& frame) {
  return {exactly(frame.e1).value(), exactly(frame.e2).value(), exactly(frame.e3).value()};
}

/// v/σ there.
Vector<Real> quotient_at(const Vector<Polynomial>& v, const Polynomial& sigma, const Place& at) {
  const auto component = [&](std::size_t k) { return value(RationalFunction(v[k], sigma), at); };
  return {component(0), component(1), component(2)};
}

/// By the primitive A and its g: a component of n or b is N/(σ|g|).
Frame<Real> algebraic_frenet_frame(const QuaternionPolynomial& a, const GaussianPolynomial& g,
                                   const Place& at) {
  const AlgebraicPoint& t = *at.algebraic;
  require_bend(g);
  const Polynomial size = norm(g);
  if (sign_at(size, t.number()) == 0)
    throw DomainError("Frenet frame: " + place_text("t", t.number()) +
                      " is an inflection, the principal normal is undefined");
  const Polynomial length = sigma(a);
  const Vector<Polynomial> j = rotated_j(a);
  const Vector<Polynomial> k = rotated_k(a);
  const auto vector = [&](const Polynomial& x, const Polynomial& y) {
    const auto component = [&](std::size_t i) {
      return t.over_square_root(x * j[i] + y * k[i], length, size);
    };
    return Vector<Real>{component(0), component(1), component(2)};
  };
  return {quotient_at(rotated_i(a), length, at), vector(g.re, -g.im), vector(g.im, g.re)};
}

void require_across(const Vector<Rational>& normal, const Vector<Real>& H) {
  if (is_zero(cross(H, as_reals(normal))))
    throw DomainError("the vector " + abbreviated(normal) + " has no part in the normal plane" +
                      (normal == Vector<Rational>{} ? "" : ": it is along the tangent"));
}

}  // namespace

Frame<Real> frame_along(const Vector<Real>& H, const Vector<Real>& n) {
  const Real sigma = cached(dot(H, H));
  const Real size = cached(dot(n, n));
  return {over_size(H, sigma), over_size(n, size), over_size(cross(H, n), sigma * size)};
}

Frame<Real> up_frame(const Path& path, const Vector<Rational>& up, const Place& at) {
  const Vector<Real> H = direction(path, at);
  return frame_along(H, cross(as_reals(up), H));
}

Vector<Real> tangent(const Path& path, const Place& at) {
  const auto* ph = std::get_if<PhSegment>(&path.segments()[at.segment]);
  if (ph == nullptr) {
    const Vector<Real> H = direction(path, at);
    return over_size(H, cached(dot(H, H)));
  }
  const QuaternionPolynomial& a = ph->primitive_preimage();
  if (at.t.exact()) return as_reals(euler_rodrigues_frame(a, *at.t.exact()).e1);
  return quotient_at(rotated_i(a), sigma(a), at);
}

Frame<Real> euler_rodrigues_frame(const Path& path, const Place& at) {
  const QuaternionPolynomial& a = segment_with_erf(path, at.segment).primitive_preimage();
  if (at.t.exact()) return as_real(euler_rodrigues_frame(a, *at.t.exact()));
  const Polynomial size = sigma(a);
  return {quotient_at(rotated_i(a), size, at), quotient_at(rotated_j(a), size, at),
          quotient_at(rotated_k(a), size, at)};
}

Frame<Real> frenet_frame(const Path& path, const Place& at) {
  if (const auto* ph = std::get_if<PhSegment>(&path.segments()[at.segment])) {
    const QuaternionPolynomial& a = ph->primitive_preimage();
    if (at.t.exact()) return frenet_frame(a, ph->bend(), *at.t.exact());
    if (at.algebraic) return algebraic_frenet_frame(a, ph->bend(), at);
  }
  const Vector<Real> H = direction(path, at);
  const Vector<Real> binormal = cross(H, direction_slope(path, at));
  if (is_zero(binormal))
    throw DomainError(
        "Frenet frame: the curvature is 0 there, at an inflection or on a straight line; the "
        "principal normal is undefined");
  // n is along b × e₁, and b along e₁ × n.
  return frame_along(H, cross(binormal, H));
}

Frame<Real> reference_frame(const PathAngle& angle, const Place& at) {
  switch (angle.reference()) {
    case Reference::euler_rodrigues:
      return euler_rodrigues_frame(angle.path(), at);
    case Reference::frenet:
      return frenet_frame(angle.path(), at);
    case Reference::up:
      break;
  }
  return up_frame(angle.path(), angle.up(), at);
}

Vector<Real> second_axis(const PathAngle& angle, const Place& at) {
  const Vector<Real> H = direction(angle.path(), at);
  switch (angle.reference()) {
    case Reference::euler_rodrigues:
      return euler_rodrigues_frame(angle.path(), at).e2;
    case Reference::frenet:
      return cross(cross(H, direction_slope(angle.path(), at)), H);
    case Reference::up:
      break;
  }
  return cross(as_reals(angle.up()), H);
}

StartAngle start_angle(const FrameStart& start, const PathAngle& angle, const Place& at) {
  if (const auto* given = std::get_if<Angle>(&start)) return *given;
  const Curve* ph = ph_curve(angle.path().segments()[at.segment]);
  const bool is_frenet = angle.reference() == Reference::frenet;
  if (ph != nullptr && at.t.exact() &&
      (!is_frenet || (at.segment == 0 && at.t.exact() == Rational(0))))
    return start_angle(start, *ph, angle.reference(),
                       angle.reference() == Reference::up ? angle.up() : Vector<Rational>{},
                       *at.t.exact());
  const Vector<Real> H = direction(angle.path(), at);
  const Vector<Real> second = second_axis(angle, at);
  if (const auto* least = std::get_if<LeastRotation>(&start))
    return angle_to(least_rotation_normal_along(H), H, second) + to_real(least->turn);
  const Vector<Rational>& normal = std::get<StartNormal>(start).vector;
  require_across(normal, H);
  return angle_to(as_reals(normal), H, second);
}

// The frame of v closes with the tangent, but for a corner; the Euler–Rodrigues frame at the start
// is that at the end, turned by 2·arg of closing_turn().
StartAngle closing_angle(const StartAngle& start, const PathAngle& angle) {
  const Path& path = angle.path();
  if (!path.is_closed()) throw DomainError("the path is not closed: no frame ends as it starts");
  if (angle.reference() != Reference::euler_rodrigues) {
    const Real turn = angle.turn_of_ends();
    return turn.exact() == Rational(0) ? start : StartAngle(start.value + -turn);
  }
  const GaussianRational turn = path.closing_turn().value();
  const FrameAngle back = angle_of(turn * turn);
  if (start.exact) return *start.exact + back;
  return start.value + to_real(back);
}

void require_start_normal(const StartNormal& start, const Path& path, const Place& at) {
  require_across(start.vector, direction(path, at));
}

Frame<Real> rotation_minimizing_frame(const PathAngle& angle, const Place& at,
                                      const StartAngle& start) {
  return rotation_minimizing_frame(angle, at, start, reference_frame(angle, at));
}

Frame<Real> rotation_minimizing_frame(const PathAngle& angle, const Place& at,
                                      const StartAngle& start, const Frame<Real>& reference) {
  if (angle.reference() != Reference::euler_rodrigues || !at.t.exact() || !start.exact)
    return turned(reference, angle.value(at, start));
  const PathParameter rational{at.segment, *at.t.exact()};
  return turned(
      exactly(reference), angle.direction(rational),
      [&](const FrameAngle& from) { return angle.value(rational, from); }, *start.exact);
}

}  // namespace phrame
