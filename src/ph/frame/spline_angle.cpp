#include "phrame/ph/frame/spline_angle.hpp"

#include <algorithm>
#include <map>
#include <mutex>

#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/frame/frame_angle.hpp"
#include "phrame/ph/frame/reduced_angle.hpp"

// Every segment is a curve on [0, 1], and so is a part of one, reparametrised. Hence θ(t) is one
// integral from 0 to 1, of the sum of all rates, and that logarithms of different segments cancel
// is decided as within one.

namespace phrame {
namespace {

constexpr long rational_bits = 256;

/// F(t) − F(0) without the logarithms.
Rational without_logarithms(const Antiderivative& F, const Rational& t) {
  return F.polynomial(t) - F.polynomial(0) + F.rational(t) - F.rational(0);
}

}  // namespace

struct SplineAngle::State {
  /// A joint, the start of a segment, with a rational θ.
  struct Joint {
    std::size_t segment = 0;
    Rational theta;
  };

  Spline spline;
  std::vector<RmfAngle> angles;

  // Each is locked while it grows. Joints ask for sums, and sums for the angles of segments, never
  // the other way.
  std::mutex sums_lock;
  std::map<long, std::vector<RealBall>> sums;  ///< θ(0), θ(1), … by precision
  std::mutex rational_sums_lock;
  std::vector<RealBall> rational_sums{RealBall()};  ///< of these, what has no logarithm
  std::mutex joints_lock;
  std::vector<Joint> joints{{}};  ///< with a rational θ, ascending
  std::size_t joints_known = 0;   ///< up to there they are looked for
  std::mutex directions_lock;
  /// Of θ(0), θ(1), …, as far as there are any.
  std::vector<GaussianRational> directions{{1, 0}};

  State(Spline of, std::vector<RmfAngle> of_segments)
      : spline(std::move(of)), angles(std::move(of_segments)) {}

  RealBall sum_before(std::size_t segment, long bits);
  RealBall enclose(const SplineParameter& at, long bits);
  RealBall enclose(const SplineParameter& at, const Angle& start, long bits);
  Rational rational_part(std::size_t from, const SplineParameter& at) const;
  RealBall rational_ball(const SplineParameter& at);
  Antiderivative over_unit_interval(std::size_t from, const SplineParameter& at) const;
  bool may_be_rational(const SplineParameter& at, const Angle& start);
};

SplineAngle::SplineAngle(Spline spline, Form form) {
  std::vector<RmfAngle> angles;
  for (const Curve& curve : spline.segments()) angles.emplace_back(curve, Reference::erf, form);
  state_ = std::make_shared<State>(std::move(spline), std::move(angles));
}

const Spline& SplineAngle::spline() const { return state_->spline; }

const RmfAngle& SplineAngle::segment(std::size_t k) const { return state_->angles[k]; }

void SplineAngle::take(Route route) {
  std::vector<RmfAngle> angles = state_->angles;
  for (RmfAngle& angle : angles) angle.take(route);
  state_ = std::make_shared<State>(state_->spline, std::move(angles));
}

/// θ at the start of the segment.
RealBall SplineAngle::State::sum_before(std::size_t segment, long bits) {
  const std::lock_guard lock(sums_lock);
  std::vector<RealBall>& known = sums[bits];
  if (known.empty()) known.emplace_back();
  while (known.size() <= segment)
    known.push_back(add(known.back(), angles[known.size() - 1].enclose(1, bits), bits));
  return known[segment];
}

RealBall SplineAngle::State::enclose(const SplineParameter& at, long bits) {
  for (long more = bits + 32;; more += 64) {
    const RealBall sum =
        add(sum_before(at.segment, more), angles[at.segment].enclose(at.t, more), more);
    if (sum.is_accurate(bits)) return sum;
  }
}

RealBall SplineAngle::State::enclose(const SplineParameter& at, const Angle& start, long bits) {
  return add(enclose(at, bits), to_real(start).enclose(bits), bits);
}

RealBall SplineAngle::enclose(const SplineParameter& at, long bits) const {
  return state_->enclose(at, bits);
}

RealBall SplineAngle::enclose(const SplineParameter& at, const Angle& start, long bits) const {
  return state_->enclose(at, start, bits);
}

/// θ(at) less that at the start of segment `from`, without the logarithms.
Rational SplineAngle::State::rational_part(std::size_t from, const SplineParameter& at) const {
  Rational sum = without_logarithms(angles[at.segment].twist(), at.t);
  for (std::size_t k = from; k < at.segment; ++k) sum += without_logarithms(angles[k].twist(), 1);
  return sum;
}

/// A ball around θ without the logarithms, at a cost that does not grow with the segments before.
RealBall SplineAngle::State::rational_ball(const SplineParameter& at) {
  const auto part = [&](std::size_t k, const Rational& t) {
    return RealBall(without_logarithms(angles[k].twist(), t), rational_bits);
  };
  const std::lock_guard lock(rational_sums_lock);
  while (rational_sums.size() <= at.segment)
    rational_sums.push_back(
        add(rational_sums.back(), part(rational_sums.size() - 1, 1), rational_bits));
  return add(rational_sums[at.segment], part(at.segment, at.t), rational_bits);
}

/// F with F(1) − F(0) = θ(at) less that at the start of segment `from`; what has no logarithm is in
/// the polynomial.
Antiderivative SplineAngle::State::over_unit_interval(std::size_t from,
                                                      const SplineParameter& at) const {
  Antiderivative sum{Polynomial{0, rational_part(from, at)}, {}, {}};
  const auto add = [&](const Antiderivative& F) {
    sum.logs.insert(sum.logs.end(), F.logs.begin(), F.logs.end());
  };
  for (std::size_t k = from; k < at.segment; ++k) add(angles[k].twist());
  if (at.t == 1)
    add(angles[at.segment].twist());
  else if (at.t != 0)
    add(integrate(erf_rate(phrame::segment(spline.segments()[at.segment], 0, at.t).preimage())));
  return sum;
}

/// As in Evaluator::value: what is apart from its rational part is irrational.
bool SplineAngle::State::may_be_rational(const SplineParameter& at, const Angle& start) {
  constexpr long bits = 128;
  return enclose(at, start, bits)
      .overlaps(add(rational_ball(at), RealBall(start.radians, bits), bits));
}

/// θ(at) + start, given a joint before and θ there: that logarithms cancel is decided for the
/// segments in between.
Real SplineAngle::value_after(std::size_t joint, const Rational& theta, const SplineParameter& at,
                              const Angle& start) const {
  if (joint == at.segment) return state_->angles[at.segment].value(at.t, start) + theta;
  const auto enclosure = [state = state_, at, theta, start](long bits) {
    return add(state->enclose(at, start, bits), RealBall(-theta, bits), bits);
  };
  return Evaluator(state_->over_unit_interval(joint, at)).value(0, 1, {{1}, {}}, enclosure, start) +
         theta;
}

/// The same from the last joint up to the start of the segment at which θ is seen to be rational.
/// Where segments cancel again and again, each decision is about few of them.
Real SplineAngle::value_after_last_joint(const SplineParameter& at, const Angle& start) const {
  const auto last_joint = [&] {
    const std::lock_guard lock(state_->joints_lock);
    std::vector<State::Joint>& joints = state_->joints;
    std::size_t& known = state_->joints_known;
    while (known < at.segment) {
      const SplineParameter end{known++, 1};
      if (!state_->may_be_rational(end, {})) continue;
      const Real theta = value_after(joints.back().segment, joints.back().theta, end, {});
      if (theta.exact()) joints.push_back({known, *theta.exact()});
    }
    return *(std::upper_bound(
                 joints.begin(), joints.end(), at.segment,
                 [](std::size_t k, const State::Joint& joint) { return k < joint.segment; }) -
             1);
  };
  const State::Joint joint = last_joint();
  return value_after(joint.segment, joint.theta, at, start);
}

Real SplineAngle::value(const Rational& t, const Angle& start) const {
  return value(locate(spline(), t), start);
}

Real SplineAngle::value(const SplineParameter& at, const Angle& start) const {
  if (at.segment == 0) return state_->angles[0].value(at.t, start);
  if (state_->may_be_rational(at, start)) return value_after_last_joint(at, start);
  return {[state = state_, at, start](long bits) { return state->enclose(at, start, bits); },
          {true, bits_of(at.t)}};
}

// Logarithms and a rational number ρ ≠ 0 do not add up to a rational multiple of π [Baker 1975].
std::optional<Rational> SplineAngle::multiple_of_pi(const SplineParameter& at,
                                                    const GaussianPolynomial& phase,
                                                    const Rational& offset) const {
  if (state_->rational_part(0, at) + offset != 0) return std::nullopt;
  return Evaluator(state_->over_unit_interval(0, at)).multiple_of_pi(0, 1, phase);
}

std::optional<GaussianRational> SplineAngle::direction(const SplineParameter& at) const {
  const auto& angles = state_->angles;
  const std::lock_guard lock(state_->directions_lock);
  std::vector<GaussianRational>& directions = state_->directions;
  while (directions.size() <= at.segment) {
    const auto next = angles[directions.size() - 1].direction(1);
    if (!next) return std::nullopt;
    const GaussianInteger z = primitive_multiple(directions.back() * *next);
    directions.push_back({Rational(z.re), Rational(z.im)});
  }
  const auto last = angles[at.segment].direction(at.t);
  if (!last) return std::nullopt;
  return directions[at.segment] * *last;
}

std::optional<Real> SplineAngle::holonomy() const {
  const auto closing = spline().closing_turn();
  if (!closing) return std::nullopt;
  // θ(end) + 2·arg back, up to whole turns.
  const GaussianRational back = angle_of({closing->re, -closing->im}).direction;
  const SplineParameter end{state_->angles.size() - 1, 1};
  const bool is_reversed = sign_after_zero(spline().segments().front().multiplier()) < 0;  // e₁
  const auto enclosure = [state = state_, end, back, is_reversed](long bits) {
    const long more = bits + 8;
    const RealBall closing_turn =
        multiply(RealBall(2, more), argument(back.re, back.im, more), more);
    const RealBall sum = add(state->enclose(end, more), closing_turn, more);
    return is_reversed ? subtract({}, sum, more) : sum;
  };
  long size = 0;
  for (const RmfAngle& angle : state_->angles) size += bits_of(angle.rate());
  const Real turned(enclosure, {false, size});
  const GaussianPolynomial path = path_to(back);
  return reduced(turned, [&] { return multiple_of_pi(end, path * path); }).angle;
}

}  // namespace phrame
