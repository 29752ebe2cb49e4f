#include "phrame/ph/frame/frame_verdict.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/frame/up_frame.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = FrameFinding::Kind;

void raise_to(RealBall& x, const RealBall& y, long bits) { x = max(x, y, bits); }

void lower_to(RealBall& x, const RealBall& y, long bits) { x = min(x, y, bits); }

/// The samples in the order of t.
std::vector<std::size_t> by_parameter(const std::vector<GivenFrame>& frames) {
  std::vector<std::size_t> order(frames.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return frames[a].t < frames[b].t; });
  return order;
}

/// The errors in the order of t, each next to the one before modulo turns, flips undone.
struct ErrorWalk {
  std::vector<RealBall> errors;
  std::size_t first;  ///< the sample of the first
  RealBall way;       ///< last − first
  RealBall range;     ///< largest − least
  RealBall distance;  ///< max |error − first|
  RealBall step;      ///< the largest |difference| of one to the next
};

/// One attempt with balls of so many bits.
class Judgement {
 public:
  Judgement(const std::vector<GivenFrame>& frames, const std::optional<Real>& start,
            const Rational& tolerance, long bits)
      : frames_(frames),
        start_(start),
        tolerance_(tolerance),
        bits_(bits),
        order_(by_parameter(frames)),
        parameters_(number_of_parameters(frames)) {}

  FrameVerdict verdict(const ExactFrames& exact);
  bool is_decided() const { return decided_; }

 private:
  using Angles = std::vector<std::optional<RealBall>>;

  /// |x| ≤ tolerance? Remembers where the ball does not tell.
  bool is_small(const RealBall& x) {
    const RealBall size = absolute(x);
    if (size.upper() <= tolerance_) return true;
    if (size.lower() <= tolerance_) decided_ = false;
    return false;
  }
  void find_errors(FrameVerdict& verdict) const;
  void find_defects(FrameVerdict& verdict);
  void find_flips(FrameVerdict& verdict) const;
  ErrorWalk walk(const FrameVerdict& verdict) const;
  void explain(FrameVerdict& verdict, const std::optional<Vector<Rational>>& up) const;
  std::optional<FrameFinding> recognized(const FrameVerdict& verdict, const ErrorWalk& walk,
                                         const std::optional<Vector<Rational>>& up) const;
  std::optional<RealBall> variation(const Angles& angles, bool up_to_half_turns) const;
  std::optional<FrameFinding> of_fixed_up(const FrameVerdict& verdict, const ErrorWalk& walk) const;
  void find_drift(FrameVerdict& verdict, const ExactFrames& exact) const;

  const std::vector<GivenFrame>& frames_;
  const std::optional<Real>& start_;  ///< of the frame that is compared with
  const Rational& tolerance_;
  long bits_;
  std::vector<std::size_t> order_;
  std::size_t parameters_;
  bool decided_ = true;
};

void Judgement::find_errors(FrameVerdict& verdict) const {
  std::optional<RealBall> start;
  if (start_) start = start_->enclose(bits_);
  for (const FrameDeviation& at : verdict.deviations) {
    verdict.errors.emplace_back();
    if (!at.f2) continue;
    const RealBall angle = subtract(*at.f2, at.theta, bits_);
    if (!start) start = angle;
    const RealBall error = reduced(subtract(angle, *start, bits_), bits_);
    verdict.errors.back() = error;
    if (absolute(error).upper() > verdict.max_error.upper())
      verdict.worst_sample = verdict.errors.size() - 1;
    raise_to(verdict.max_error, absolute(error), bits_);
  }
}

void Judgement::find_defects(FrameVerdict& verdict) {
  std::map<Kind, std::vector<std::size_t>> found;
  for (std::size_t k = 0; k < verdict.deviations.size(); ++k) {
    const FrameDeviation& at = verdict.deviations[k];
    raise_to(verdict.orthogonality, at.orthogonality, bits_);
    raise_to(verdict.length, at.length, bits_);
    if (!at.f2) found[Kind::undefined].push_back(k);
    const bool is_along = is_small(at.tangent_sine);
    if (at.is_reversed && at.tangent_sine.upper() <= recognition_tolerance)
      found[Kind::reversed_tangent].push_back(k);
    else if (at.is_reversed || !is_along)
      found[Kind::wrong_tangent].push_back(k);
    if (at.handedness < 0) found[Kind::left_handed].push_back(k);
    if (!is_small(at.orthogonality)) found[Kind::not_orthogonal].push_back(k);
    if (!is_small(at.length)) found[Kind::not_unit].push_back(k);
  }
  for (auto& [kind, samples] : found) verdict.findings.push_back({kind, std::move(samples)});
}

void Judgement::find_flips(FrameVerdict& verdict) const {
  FrameFinding flips{Kind::flip};
  const RealBall* before = nullptr;
  for (const std::size_t k : order_) {
    if (!verdict.errors[k]) continue;
    const RealBall& error = *verdict.errors[k];
    if (before != nullptr && absolute(reduced(subtract(error, *before, bits_), bits_)).lower() > 3)
      flips.samples.push_back(k);
    before = &error;
  }
  if (!flips.samples.empty()) verdict.findings.push_back(std::move(flips));
}

ErrorWalk Judgement::walk(const FrameVerdict& verdict) const {
  ErrorWalk walk{};
  const RealBall half_turn = pi(bits_);
  RealBall least;
  RealBall largest;
  const RealBall* before = nullptr;
  for (const std::size_t k : order_) {
    if (!verdict.errors[k]) continue;
    const RealBall& error = *verdict.errors[k];
    if (before == nullptr) {
      walk.errors.push_back(error);
      walk.first = k;
    } else {
      RealBall step = reduced(subtract(error, *before, bits_), bits_);
      if (absolute(step).lower() > 3)  // a flip, as in find_flips
        step = sign(step) > 0 ? subtract(step, half_turn, bits_) : add(step, half_turn, bits_);
      raise_to(walk.step, absolute(step), bits_);
      walk.way = add(walk.way, step, bits_);
      walk.errors.push_back(add(walk.errors.back(), step, bits_));
      raise_to(walk.distance, absolute(walk.way), bits_);
      raise_to(largest, walk.way, bits_);
      lower_to(least, walk.way, bits_);
    }
    before = &error;
  }
  walk.range = subtract(largest, least, bits_);
  return walk;
}

/// The largest |angle − first angle|; no value for less than three samples.
std::optional<RealBall> Judgement::variation(const Angles& angles, bool up_to_half_turns) const {
  const RealBall factor(up_to_half_turns ? 2 : 1, bits_);
  const RealBall* first = nullptr;
  std::set<Rational> parameters;
  RealBall largest;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    if (!angles[k]) continue;
    if (first == nullptr) first = &*angles[k];
    parameters.insert(frames_[k].t);
    const RealBall change = multiply(factor, subtract(*angles[k], *first, bits_), bits_);
    raise_to(largest, absolute(reduced(change, bits_)), bits_);
  }
  if (parameters.size() < 3) return std::nullopt;
  return divide(largest, factor, bits_);
}

/// Does a kind of frame that leaves `residual` explain errors of that size?
bool explains(const RealBall& residual, const RealBall& size) {
  return residual.upper() <= std::min(recognition_tolerance, Rational(size.lower() / 100));
}

/// Which other frame is it? `up` is v of the reference frame.
std::optional<FrameFinding> Judgement::recognized(const FrameVerdict& verdict,
                                                  const ErrorWalk& walk,
                                                  const std::optional<Vector<Rational>>& up) const {
  const RealBall offset = walk.errors.front();
  if (start_ && parameters_ >= 2 && explains(walk.distance, absolute(offset)))
    return FrameFinding{Kind::constant_offset, {}, offset, walk.distance};
  Angles reference;
  Angles frenet;
  Angles backwards;
  for (const FrameDeviation& at : verdict.deviations) {
    reference.push_back(at.f2);
    frenet.push_back(at.from_normal);
    backwards.emplace_back();
    if (at.f2) backwards.back() = add(*at.f2, at.theta, bits_);
  }
  const std::pair<Kind, std::optional<RealBall>> candidates[] = {
      {Kind::frenet, variation(frenet, true)},
      {up ? Kind::fixed_up : Kind::euler_rodrigues, variation(reference, false)},
      {Kind::turned_backwards, variation(backwards, false)}};
  for (const auto& [kind, residual] : candidates)
    if (residual && explains(*residual, walk.distance))
      return FrameFinding{
          kind, {}, std::nullopt, residual, kind == Kind::frenet ? std::nullopt : up};
  return of_fixed_up(verdict, walk);
}

/// Is it the frame of a fixed vector?
std::optional<FrameFinding> Judgement::of_fixed_up(const FrameVerdict& verdict,
                                                   const ErrorWalk& walk) const {
  if (parameters_ < 4) return std::nullopt;  // three frames of any kind have nearly such a vector
  for (const Vector<Rational>& up : guessed_up_vectors(frames_, verdict.deviations)) {
    Angles angles;
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      angles.emplace_back();
      if (verdict.deviations[k].f2)
        angles.back() = angle_to_up(frames_[k].f2, up, verdict.deviations[k].e1, bits_);
    }
    const auto residual = variation(angles, false);
    if (residual && residual->is_finite() && explains(*residual, walk.distance))
      return FrameFinding{Kind::fixed_up, {}, std::nullopt, residual, up};
  }
  return std::nullopt;
}

/// Why errors are beyond the tolerance.
void Judgement::explain(FrameVerdict& verdict, const std::optional<Vector<Rational>>& up) const {
  const ErrorWalk walk = this->walk(verdict);
  if (const auto finding = recognized(verdict, walk, up)) {
    verdict.findings.push_back(*finding);
    return;
  }
  const bool is_elsewhere = start_ && absolute(walk.errors.front()).lower() > tolerance_;
  if (is_elsewhere)
    verdict.findings.push_back(
        {Kind::other_start, {walk.first}, walk.errors.front(), std::nullopt});
  const bool is_explained =
      is_elsewhere || (!verdict.findings.empty() && verdict.findings.back().kind == Kind::flip);
  if (walk.errors.size() < 2 || (is_explained && walk.range.lower() <= tolerance_)) return;
  // A drift makes its way without coming back by half of it, and without a jump: no step is more
  // than a quarter of the way or, of a few samples, twice its share.
  const Rational way = absolute(walk.way).lower();
  const Rational share =
      std::max(Rational(1, 4), Rational(2, static_cast<long>(walk.errors.size()) - 1));
  const bool is_drift = 2 * way >= walk.range.upper() && walk.step.upper() <= share * way;
  verdict.findings.push_back({is_drift ? Kind::drift : Kind::irregular,
                              {},
                              is_drift ? walk.way : walk.range,
                              std::nullopt});
}

void Judgement::find_drift(FrameVerdict& verdict, const ExactFrames& exact) const {
  const auto is_defined = [&](std::size_t k) { return verdict.errors[k].has_value(); };
  const auto first = std::find_if(order_.begin(), order_.end(), is_defined);
  const auto last = std::find_if(order_.rbegin(), order_.rend(), is_defined);
  if (first == order_.end()) return;
  const auto length = exact.length(frames_[*first].t, frames_[*last].t, bits_);
  if (!length || length->is_zero()) return;
  verdict.drift = divide(walk(verdict).way, *length, bits_);
}

FrameVerdict Judgement::verdict(const ExactFrames& exact) {
  FrameVerdict verdict{};
  for (const GivenFrame& frame : frames_)
    verdict.deviations.push_back(exact.deviation(frame, bits_));
  find_errors(verdict);
  find_defects(verdict);
  find_flips(verdict);
  const bool is_close = is_small(verdict.max_error);
  verdict.passes = is_close && verdict.findings.empty();
  if (!is_close) explain(verdict, exact.up);
  find_drift(verdict, exact);
  return verdict;
}

}  // namespace

std::size_t number_of_parameters(const std::vector<GivenFrame>& frames) {
  std::set<Rational> parameters;
  for (const GivenFrame& frame : frames) parameters.insert(frame.t);
  return parameters.size();
}

FrameVerdict judge_frames(const ExactFrames& exact, const std::vector<GivenFrame>& frames,
                          const std::optional<Real>& start, const Rational& tolerance) {
  for (long bits = 128; bits <= 4096; bits *= 2) {
    Judgement judgement(frames, start, tolerance, bits);
    FrameVerdict verdict = judgement.verdict(exact);
    if (judgement.is_decided()) return verdict;
  }
  throw Undecided(
      "check of frames: 4096 bits of precision do not tell an error from the tolerance");
}

}  // namespace phrame
