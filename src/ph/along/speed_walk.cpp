#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/speed_span.hpp"
#include "phrame/ph/curve/real_vector.hpp"

// The greatest w ≤ B with |w′| ≤ 2A is found by two walks. Along the path a line of slope 2A leaves
// B where B′ > 2A or B jumps up, and ends where it meets B again; that is the greatest one with
// w′ ≤ 2A. The same walk back over it bounds −w′, and keeps the other bound: where a line of slope
// −2A is the least, w′ = −2A.
//
// On each part of a segment one limit is the least, and the signs of its B′ ± 2A do not change:
// then a line meets it at most once, and whether it does is told by the end of the part.

namespace phrame::inline v0 {
namespace {

using Kind = SpeedLimit::Kind;

/// A walk along the spans, forward or back.
class Walk {
 public:
  Walk(const SpeedLimits& limits, const PathLength& length, const Rational& acceleration,
       int direction)
      : limits_(limits), length_(length), slope_(2 * acceleration), direction_(direction) {}

  /// From the speed at the end where it starts on, or from the limit there.
  SpeedSpans operator()(const SpeedSpans& spans, const Rational& start_speed);

 private:
  bool forward() const { return direction_ > 0; }
  const Real& entry(const SpeedSpan& span) const { return forward() ? span.s0 : span.s1; }
  const Real& exit(const SpeedSpan& span) const { return forward() ? span.s1 : span.s0; }
  const SquaredSpeed& w_entry(const SpeedSpan& span) const { return forward() ? span.w0 : span.w1; }
  const SquaredSpeed& w_exit(const SpeedSpan& span) const { return forward() ? span.w1 : span.w0; }
  std::string where(const Real& s) const {
    return fmt::format("at s = {:.9g}", approximate(s.enclose(64)));
  }

  Real line(const Real& s) const {
    return anchor_w_ + Real(direction_ * slope_) * (s + -anchor_s_);
  }
  void leave(const Real& s, const Real& w);
  void finish_line(const Real& s);
  void pass(const SpeedSpan& span);
  SpeedSpan cut(const SpeedSpan& span, const Real& t, const Real& s, const Real& w) const;
  void meet(const SpeedSpan& span);

  const SpeedLimits& limits_;
  const PathLength& length_;
  Rational slope_;
  int direction_;
  bool on_line_ = false;
  Real anchor_s_ = Rational(0);
  Real anchor_w_ = Rational(0);
  bool stops_ = false;  ///< does the line start at a stop?
  SpeedSpans out_;
};

void Walk::leave(const Real& s, const Real& w) {
  on_line_ = true;
  anchor_s_ = s;
  anchor_w_ = w;
}

/// The line ends at s.
void Walk::finish_line(const Real& s) {
  SpeedSpan span;
  const Real w = line(s);
  span.s0 = forward() ? anchor_s_ : s;
  span.s1 = forward() ? s : anchor_s_;
  span.w0 = {forward() ? anchor_w_ : w};
  span.w1 = {forward() ? w : anchor_w_};
  span.rise = forward() ? 0 : -1;
  span.fall = forward() ? 1 : 0;
  span.stops = std::exchange(stops_, false);
  out_.push_back(std::move(span));
  on_line_ = false;
}

/// What is left of the span behind the place where the line meets it.
SpeedSpan Walk::cut(const SpeedSpan& span, const Real& t, const Real& s, const Real& w) const {
  SpeedSpan rest = span;
  (forward() ? rest.t0 : rest.t1) = t;
  (forward() ? rest.s0 : rest.s1) = s;
  (forward() ? rest.w0 : rest.w1) = {w};
  if (forward()) rest.jumps = rest.stops = false;
  return rest;
}

/// The line is below the span where that starts and above it where it ends.
void Walk::meet(const SpeedSpan& span) {
  if (!span.limit || span.limit->kind == Kind::constant) {
    // Exact where the anchor is: w there, or half way between the two lines, of which the one of
    // the first walk rises as this one falls.
    const Real from_anchor =
        Real(Rational(direction_ / slope_)) * ((span.limit ? span.w0 : span.w1).value + -anchor_w_);
    const Real s = cached(span.limit ? anchor_s_ + from_anchor
                                     : Real(Rational(1, 2)) * (anchor_s_ + from_anchor + span.s1));
    const Real w = span.limit ? span.w0.value : cached(line(s));
    finish_line(s);
    out_.push_back(cut(span, Rational(0), s, w));
    return;
  }
  const std::size_t k = span.segment;
  const SeriesFunction V = limits_.speed(*span.limit, k);
  // 2A(s − s_anchor) + w_anchor − V² rises along the walk.
  const auto gap = [length = length_, V, k, w = anchor_w_, from = anchor_s_,
                    steep = direction_ * slope_](const RealBall& t, long terms, long bits) {
    const BallPolynomial v = V(t, terms, bits);
    const Real at([t](long) { return t; });
    const RealBall s = length.enclose({k, at}, bits);
    const RealBall v0 = v.coefficient(0);
    const RealBall rise =
        multiply(RealBall(steep, bits), subtract(s, from.enclose(bits), bits), bits);
    const RealBall value = subtract(add(rise, w.enclose(bits), bits), multiply(v0, v0, bits), bits);
    if (terms == 1) return BallPolynomial(std::vector<RealBall>{value});
    const RealBall slope =
        subtract(multiply(RealBall(steep, bits), length.rate(k, t, bits), bits),
                 times_power_of_two(multiply(v0, v.coefficient(1), bits), 1), bits);
    return BallPolynomial(std::vector<RealBall>{value, slope});
  };
  const auto at =
      sign_changes(gap, span.t0, span.t1, "feedrate: where the motion meets its limit is not told");
  if (at.size() != 1) throw Undecided("feedrate: where the motion meets its limit is not told");
  const Real s = cached(length_.value({k, at[0]}));
  const Real w = limits_.squared(*span.limit, k, at[0]).value;
  finish_line(s);
  out_.push_back(cut(span, at[0], s, w));
}

void Walk::pass(const SpeedSpan& span) {
  const int excess = forward() ? span.rise : -span.fall;
  if (!on_line_ && excess > 0) leave(entry(span), w_entry(span).value);
  if (!on_line_) {
    out_.push_back(span);
    return;
  }
  if (excess > 0) return;
  const int above = compare(w_exit(span), {line(exit(span))}, where(exit(span)));
  if (above > 0) return;
  if (above == 0) return finish_line(exit(span));
  meet(span);
}

SpeedSpans Walk::operator()(const SpeedSpans& spans, const Rational& start_speed) {
  const SpeedSpan* before = nullptr;
  for (std::size_t j = 0; j < spans.size(); ++j) {
    const SpeedSpan& span = forward() ? spans[j] : spans[spans.size() - 1 - j];
    const bool stops = before != nullptr && (forward() ? span : *before).stops;
    const bool jumps = before != nullptr && (forward() ? span : *before).jumps;
    if (before == nullptr) {
      const Rational w = start_speed * start_speed;
      const int above = compare(w_entry(span), {w, Rational(w * w)}, where(entry(span)));
      if (above < 0)
        throw DomainError(fmt::format(
            "feedrate: the speed {} at the {} of the path is more than the motion {}: at most {}",
            as_written(start_speed), forward() ? "start" : "end",
            forward() ? "may have there" : "reaches",
            to_string(sqrt_of_nonnegative(w_entry(span).value.enclose(64), 64), 9)));
      if (above > 0) leave(entry(span), w);
    } else if (stops) {
      if (on_line_) finish_line(entry(span));
      leave(entry(span), Rational(0));
      stops_ = forward();
    } else if (jumps) {
      const SquaredSpeed reached = on_line_ ? SquaredSpeed{line(entry(span))} : w_exit(*before);
      const int above = compare(w_entry(span), reached, where(entry(span)));
      if (above > 0 && !on_line_) leave(entry(span), w_exit(*before).value);
      if (above <= 0 && on_line_) finish_line(entry(span));
    }
    pass(span);
    before = &span;
  }
  if (on_line_ && !forward())
    throw DomainError(
        fmt::format("feedrate: from the speed at the start of the path the motion cannot brake in "
                    "time: at most {}",
                    to_string(sqrt_of_nonnegative(line(exit(*before)).enclose(64), 64), 9)));
  if (on_line_) finish_line(exit(*before));
  if (!forward()) std::reverse(out_.begin(), out_.end());
  return std::move(out_);
}

}  // namespace

SpeedSpans with_bounded_slope(const SpeedSpans& spans, const SpeedLimits& limits,
                              const PathLength& length, const Feedrate::Limits& of) {
  const SpeedSpans rising = Walk(limits, length, *of.tangential, 1)(spans, of.start_speed);
  return Walk(limits, length, *of.tangential, -1)(rising, of.end_speed);
}

}  // namespace phrame
