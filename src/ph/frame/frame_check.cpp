#include "phrame/ph/frame/frame_check.hpp"

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/frame_deviation.hpp"
#include "phrame/ph/frame/near_deviation.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame::inline v0 {
namespace {

/// The sign of p next to t.
int side_of(const RationalCurve& curve, const Rational& t) {
  return sign_beside(curve.multiplier(), t);
}

/// e₁ is r′/|r′| all along, or its opposite.
int side_of(const ExpressionCurve& curve, const Rational&) { return curve.orientation(); }

int side_of(const Path& path, const PathParameter& at) {
  return visit_curve([&](const auto& curve) { return side_of(curve, at.t); },
                     path.segments()[at.segment]);
}

/// How well a frame fits a tangent along T, the greater the better: by its own one or f₂ × f₃, in
/// either direction, or by how far f₂ is across T.
Real fit(const GivenFrame& frame, const Vector<Real>& T) {
  const auto squared_cosine = [&, size = dot(T, T)](const Vector<Rational>& v) {
    const Real cosine = over_square_root(dot(as_reals(v), T), size);
    return cosine * cosine;
  };
  if (frame.tangent) return squared_cosine(*frame.tangent);
  if (frame.f3) return squared_cosine(cross(frame.f2, *frame.f3));
  return -squared_cosine(frame.f2);
}

/// Where the frame is: at a corner on the side whose tangent it fits better, else on the later one.
PathParameter place_of(const Path& path, const GivenFrame& frame) {
  const PathParameter after = locate(path, frame.t);
  if (after.t != 0 || !path.has_corner(after.segment)) return after;
  const PathParameter before{after.segment - 1, 1};
  const Real gain = fit(frame, direction(path, before)) + -fit(frame, direction(path, after));
  return sign_of(gain) > 0 ? before : after;
}

/// What the frames take for forward, by their tangents or else f₂ × f₃: e₁ if most of those where
/// p < 0 do, else r′.
Forward forward_of(const Path& path, const std::vector<GivenFrame>& frames) {
  long balance = 0;
  for (const GivenFrame& frame : frames) {
    if (!frame.tangent && !frame.f3) continue;
    const PathParameter at = place_of(path, frame);
    if (side_of(path, at) >= 0) continue;
    const Vector<Rational> forward = frame.tangent ? *frame.tangent : cross(frame.f2, *frame.f3);
    balance += sign_of(dot(as_reals(forward), direction(path, at)));
  }
  return balance > 0 ? Forward::preimage : Forward::motion;
}

/// Of the path there; n only where it is defined.
ExactFrame exact_frame(const PathAngle& angle, const PathParameter& at, const RealBall& theta,
                       int side) {
  const Path& path = angle.path();
  ExactFrame exact{direction(path, at), second_axis(angle, at), std::nullopt, theta, side};
  try {
    exact.normal = frenet_frame(path, at).e2;
  } catch (const DomainError&) {  // an inflection, or a straight line
  }
  return exact;
}

/// In balls where these tell all that is asked, else exactly.
FrameDeviation deviation_of(const PathAngle& angle, const GivenFrame& frame, Forward forward,
                            long bits) {
  const Path& path = angle.path();
  const PathParameter at = place_of(path, frame);
  const RealBall theta = angle.value(at).enclose(bits);
  const int side = forward == Forward::preimage ? 1 : side_of(path, at);
  const auto* ph = std::get_if<PhSegment>(&path.segments()[at.segment]);
  if (ph != nullptr && angle.reference() == Reference::euler_rodrigues)
    if (auto near = near_deviation(*ph, at.t, theta, side, frame, bits)) return *std::move(near);
  return deviation_from(exact_frame(angle, at, theta, side), frame, bits);
}

/// The arc length from a to b; no value where that is not told from 0.
std::optional<RealBall> length_between(const PathLength& length, const Path& path,
                                       const Rational& a, const Rational& b, long bits) {
  if (a == b) return std::nullopt;
  const RealBall way = subtract(length.value(locate(path, b)).enclose(bits),
                                length.value(locate(path, a)).enclose(bits), bits);
  if (way.contains_zero()) return std::nullopt;
  return way;
}

}  // namespace

FrameVerdict check_frames(const PathAngle& angle, const std::vector<GivenFrame>& frames,
                          const FrameCheckOptions& options) {
  const Path& path = angle.path();
  const Forward forward = forward_of(path, frames);
  std::optional<Real> start;
  if (options.start) start = start_angle(*options.start, angle).value;
  const PathLength length(path);
  const ExactFrames exact{
      [&](const GivenFrame& frame, long bits) { return deviation_of(angle, frame, forward, bits); },
      [&](const Rational& a, const Rational& b, long bits) {
        return length_between(length, path, a, b, bits);
      },
      angle.reference() == Reference::up ? std::optional(angle.up()) : std::nullopt};
  return judge_frames(exact, frames, start, options.tolerance);
}

bool are_along_curve(const Path& path, const std::vector<GivenFrame>& frames,
                     const Rational& tolerance) {
  return std::all_of(frames.begin(), frames.end(), [&](const GivenFrame& frame) {
    if (!frame.tangent) return true;
    const Vector<Rational> tangent = near(direction(path, place_of(path, frame)));
    const Vector<Rational> c = cross(*frame.tangent, tangent);
    const Rational squared_size = dot(*frame.tangent, *frame.tangent) * dot(tangent, tangent);
    return squared_size != 0 && dot(c, c) <= tolerance * tolerance * squared_size;
  });
}

std::optional<Rational> squared_deviation(const Path& path,
                                          const std::vector<GivenPosition>& positions) {
  std::optional<Vector<Rational>> start;
  Rational farthest;  // squared, as is
  Rational worst;
  for (const auto& [t, given] : positions) {
    const Vector<Rational> r = near(position(path, locate(path, t)));
    if (!start) start = r;
    const Vector<Rational> way = r - *start;
    const Vector<Rational> off = given - positions.front().r - way;
    farthest = std::max(farthest, dot(way, way));
    worst = std::max(worst, dot(off, off));
  }
  if (farthest == 0) return std::nullopt;
  return worst / farthest;
}

bool are_on_curve(const Path& path, const std::vector<GivenPosition>& positions,
                  const Rational& tolerance) {
  const auto found = squared_deviation(path, positions);
  return found && *found <= tolerance * tolerance;
}

}  // namespace phrame
