#include "phrame/ph/frame/frame_check.hpp"

#include <algorithm>

#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/frame_deviation.hpp"

namespace phrame {
FrameCheck::FrameCheck(const PhPath& path) : angle_(path) {
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
  const int side = forward == Forward::preimage ? 1 : sign_beside(curve.multiplier(), at.t);
  ExactFrame exact{as_reals(erf.e1), as_reals(erf.e2), std::nullopt, angle_.value(at).enclose(bits),
                   side};
  const Rational re = bends_[at.segment].re(at.t);
  const Rational im = bends_[at.segment].im(at.t);
  // n = (Re g e₂ − Im g e₃)/|g|.
  if (re != 0 || im != 0) exact.normal = as_reals(re * erf.e2 - im * erf.e3);
  return deviation_from(exact, frame, bits);
}

std::optional<Rational> FrameCheck::length(const Rational& a, const Rational& b) const {
  const PhPath& path = angle_.path();
  const PathParameter from = locate(path, std::min(a, b));
  const PathParameter to = locate(path, std::max(a, b));
  Rational sum = 0;
  for (std::size_t k = from.segment; k <= to.segment; ++k) {
    const auto part = arc_length(path.segments()[k], k == from.segment ? from.t : Rational(0),
                                 k == to.segment ? to.t : Rational(1));
    if (!part) return std::nullopt;
    sum += *part;
  }
  return sum;
}

bool are_along(const PointFunction& tangent_at, const std::vector<GivenFrame>& frames,
               const Rational& tolerance) {
  return std::all_of(frames.begin(), frames.end(), [&](const GivenFrame& frame) {
    if (!frame.tangent) return true;
    const Vector<Rational> tangent = tangent_at(frame.t);
    const Vector<Rational> c = cross(*frame.tangent, tangent);
    const Rational squared_size = dot(*frame.tangent, *frame.tangent) * dot(tangent, tangent);
    return squared_size != 0 && dot(c, c) <= tolerance * tolerance * squared_size;
  });
}

bool are_along_curve(const PhPath& path, const std::vector<GivenFrame>& frames,
                     const Rational& tolerance) {
  std::vector<Frames> exact;
  for (const Curve& curve : path.segments()) exact.emplace_back(curve);
  const auto tangent_at = [&](const Rational& t) {
    const PathParameter at = locate(path, t);
    return exact[at.segment].euler_rodrigues(at.t).e1;
  };
  return are_along(tangent_at, frames, tolerance);
}

bool are_on(const PointFunction& position_at, const std::vector<GivenPosition>& positions,
            const Rational& tolerance) {
  std::optional<Vector<Rational>> start;
  Rational farthest;  // squared, as is
  Rational worst;
  for (const auto& [t, given] : positions) {
    const Vector<Rational> r = position_at(t);
    if (!start) start = r;
    const Vector<Rational> way = r - *start;
    const Vector<Rational> off = given - positions.front().r - way;
    farthest = std::max(farthest, dot(way, way));
    worst = std::max(worst, dot(off, off));
  }
  return farthest > 0 && worst <= tolerance * tolerance * farthest;
}

bool are_on_curve(const PhPath& path, const std::vector<GivenPosition>& positions,
                  const Rational& tolerance) {
  std::vector<Vector<Polynomial>> exact;
  for (const Curve& curve : path.segments()) exact.push_back(position(curve));
  const auto position_at = [&](const Rational& t) {
    const PathParameter at = locate(path, t);
    return evaluate(exact[at.segment], at.t);
  };
  return are_on(position_at, positions, tolerance);
}

FrameVerdict check_frames(const PhPath& path, const std::vector<GivenFrame>& frames,
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
      },
      std::nullopt};
  return judge_frames(exact, frames, start, options.tolerance);
}

}  // namespace phrame
