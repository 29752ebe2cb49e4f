#include "phrame/ph/frame/frame_check.hpp"

#include <algorithm>
#include <cstdlib>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/arc_length.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {
namespace {

RealBall root(const Rational& x, long bits) { return sqrt(RealBall(x, bits), bits); }

void grow_to(RealBall& x, const RealBall& y, long bits) { x = max(x, y, bits); }

/// |cos| of the angle between a and b; 0 where one of them is 0.
RealBall cosine(const Vector<Rational>& a, const Vector<Rational>& b, long bits) {
  const Rational sizes = dot(a, a) * dot(b, b);
  const Rational c = dot(a, b);
  return sizes == 0 ? RealBall() : root(c * c / sizes, bits);
}

/// The sign of f next to t: 0 where it changes there.
int sign_beside(const Polynomial& f, const Rational& t) {
  Polynomial derivative = f;
  for (long order = 0;; ++order, derivative = differentiate(derivative))
    if (const Rational value = derivative(t); value != 0)
      return order % 2 == 1 ? 0 : value < 0 ? -1 : 1;
}

}  // namespace

FrameCheck::FrameCheck(const Path& path) : angle_(path) {
  for (const Curve& curve : path.segments()) {
    frames_.emplace_back(curve);
    bends_.push_back(bend_numerator(without_real_content(curve.preimage())));
  }
}

Forward FrameCheck::forward(const std::vector<GivenFrame>& frames) const {
  long balance = 0;
  for (const GivenFrame& frame : frames) {
    if (!frame.tangent) continue;
    const PathParameter at = locate(angle_.path(), frame.t);
    if (sign_beside(angle_.path().segments()[at.segment].multiplier(), at.t) >= 0) continue;
    balance += dot(*frame.tangent, frames_[at.segment].euler_rodrigues(at.t).e1).sign();
  }
  return balance > 0 ? Forward::preimage : Forward::motion;
}

FrameDeviation FrameCheck::deviation(const GivenFrame& frame, Forward forward, long bits) const {
  const PathParameter at = locate(angle_.path(), frame.t);
  const Frame<Rational> erf = frames_[at.segment].euler_rodrigues(at.t);
  const Curve& curve = angle_.path().segments()[at.segment];

  FrameDeviation result;
  for (std::size_t k = 0; k < 3; ++k) result.e1[k] = RealBall(erf.e1[k], bits);
  result.theta = angle_.value(at).enclose(bits);
  const Rational x = dot(frame.f2, erf.e2);
  const Rational y = dot(frame.f2, erf.e3);
  if (x != 0 || y != 0) {
    result.f2 = argument(x, y, bits);
    const Rational re = bends_[at.segment].re(at.t);
    const Rational im = bends_[at.segment].im(at.t);
    // n = (Re g e₂ − Im g e₃)/|g|.
    if (re != 0 || im != 0) result.from_normal = argument(x * re - y * im, x * im + y * re, bits);
  }
  std::vector<Vector<Rational>> normals{frame.f2};
  if (frame.f3) normals.push_back(*frame.f3);
  for (const auto& f : normals) {
    grow_to(result.orthogonality, cosine(f, erf.e1, bits), bits);
    grow_to(result.length, absolute(subtract(root(dot(f, f), bits), RealBall(1, bits), bits)),
            bits);
  }
  if (frame.f3) {
    grow_to(result.orthogonality, cosine(frame.f2, *frame.f3, bits), bits);
    result.handedness = dot(frame.tangent.value_or(erf.e1), cross(frame.f2, *frame.f3)).sign();
  }
  const int side = forward == Forward::preimage ? 1 : sign_beside(curve.multiplier(), at.t);
  if (frame.tangent) {
    const Vector<Rational>& given = *frame.tangent;
    result.is_reversed = dot(given, erf.e1).sign() * side < 0;
    const Rational squared_size = dot(given, given);
    grow_to(result.length, absolute(subtract(root(squared_size, bits), RealBall(1, bits), bits)),
            bits);
    const Vector<Rational> c = cross(given, erf.e1);
    result.tangent_sine =  // a vector that is 0 has no direction at all
        squared_size == 0 ? RealBall(1, bits) : root(dot(c, c) / squared_size, bits);
  } else {  // the determinant was that with e₁
    result.handedness = side == 0 ? std::abs(result.handedness) : result.handedness * side;
  }
  return result;
}

std::optional<Rational> FrameCheck::length(const Rational& a, const Rational& b) const {
  const Path& path = angle_.path();
  return PathLength(path).between(locate(path, std::min(a, b)), locate(path, std::max(a, b)));
}

bool are_along_curve(const Path& path, const std::vector<GivenFrame>& frames,
                     const Rational& tolerance) {
  std::vector<Frames> exact;
  for (const Curve& curve : path.segments()) exact.emplace_back(curve);
  return std::all_of(frames.begin(), frames.end(), [&](const GivenFrame& frame) {
    if (!frame.tangent) return true;
    const PathParameter at = locate(path, frame.t);
    const Vector<Rational> c = cross(*frame.tangent, exact[at.segment].euler_rodrigues(at.t).e1);
    const Rational squared_size = dot(*frame.tangent, *frame.tangent);
    return squared_size != 0 && dot(c, c) <= tolerance * tolerance * squared_size;
  });
}

bool are_on_curve(const Path& path, const std::vector<GivenPosition>& positions,
                  const Rational& tolerance) {
  std::vector<Vector<Polynomial>> exact;
  for (const Curve& curve : path.segments()) exact.push_back(position(curve));
  std::optional<Vector<Rational>> start;
  Rational farthest;  // squared, as is
  Rational worst;
  for (const auto& [t, given] : positions) {
    const PathParameter at = locate(path, t);
    const Vector<Rational> r = evaluate(exact[at.segment], at.t);
    if (!start) start = r;
    const Vector<Rational> way = r - *start;
    const Vector<Rational> off = given - positions.front().r - way;
    farthest = std::max(farthest, dot(way, way));
    worst = std::max(worst, dot(off, off));
  }
  return farthest > 0 && worst <= tolerance * tolerance * farthest;
}

FrameVerdict check_frames(const Path& path, const std::vector<GivenFrame>& frames,
                          const FrameCheckOptions& options) {
  const FrameCheck check(path);
  const Forward forward = check.forward(frames);
  std::optional<Real> start;
  if (options.start) start = to_real(start_angle(*options.start, path));
  const ExactFrames exact{
      [&](const GivenFrame& frame, long bits) { return check.deviation(frame, forward, bits); },
      [&](const Rational& a, const Rational& b, long bits) -> std::optional<RealBall> {
        if (const auto length = check.length(a, b)) return RealBall(*length, bits);
        return std::nullopt;
      }};
  return judge_frames(exact, frames, start, options.tolerance);
}

}  // namespace phrame
