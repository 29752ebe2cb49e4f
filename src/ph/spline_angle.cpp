#include "phrame/ph/spline_angle.hpp"

#include <algorithm>

#include "phrame/ph/frame_angle.hpp"
#include "phrame/ph/reduced_angle.hpp"
#include "phrame/ph/transform.hpp"

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

SplineAngle::SplineAngle(Spline spline, Form form) : spline_(std::move(spline)) {
  for (const Curve& curve : spline_.segments()) angles_.emplace_back(curve, Reference::erf, form);
}

/// θ at the start of the segment.
RealBall SplineAngle::sum_before(std::size_t segment, long bits) {
  std::vector<RealBall>& sums = sums_[bits];
  if (sums.empty()) sums.emplace_back();
  while (sums.size() <= segment)
    sums.push_back(add(sums.back(), angles_[sums.size() - 1].enclose(1, bits), bits));
  return sums[segment];
}

RealBall SplineAngle::enclose(const SplineParameter& at, long bits) {
  for (long more = bits + 32;; more += 64) {
    const RealBall sum =
        add(sum_before(at.segment, more), angles_[at.segment].enclose(at.t, more), more);
    if (sum.is_accurate(bits)) return sum;
  }
}

RealBall SplineAngle::enclose(const SplineParameter& at, const Angle& start, long bits) {
  return add(enclose(at, bits), to_real(start).enclose(bits), bits);
}

/// θ(at) less that at the start of segment `from`, without the logarithms.
Rational SplineAngle::rational_part(std::size_t from, const SplineParameter& at) const {
  Rational sum = without_logarithms(angles_[at.segment].twist(), at.t);
  for (std::size_t k = from; k < at.segment; ++k) sum += without_logarithms(angles_[k].twist(), 1);
  return sum;
}

/// A ball around θ without the logarithms, at a cost that does not grow with the segments before.
RealBall SplineAngle::rational_ball(const SplineParameter& at) {
  const auto part = [&](std::size_t k, const Rational& t) {
    return RealBall(without_logarithms(angles_[k].twist(), t), rational_bits);
  };
  while (rational_sums_.size() <= at.segment)
    rational_sums_.push_back(
        add(rational_sums_.back(), part(rational_sums_.size() - 1, 1), rational_bits));
  return add(rational_sums_[at.segment], part(at.segment, at.t), rational_bits);
}

/// F with F(1) − F(0) = θ(at) less that at the start of segment `from`; what has no logarithm is in
/// the polynomial.
Antiderivative SplineAngle::over_unit_interval(std::size_t from, const SplineParameter& at) const {
  Antiderivative sum{Polynomial{0, rational_part(from, at)}, {}, {}};
  const auto add = [&](const Antiderivative& F) {
    sum.logs.insert(sum.logs.end(), F.logs.begin(), F.logs.end());
  };
  for (std::size_t k = from; k < at.segment; ++k) add(angles_[k].twist());
  if (at.t == 1)
    add(angles_[at.segment].twist());
  else if (at.t != 0)
    add(integrate(erf_rate(phrame::segment(spline_.segments()[at.segment], 0, at.t).preimage())));
  return sum;
}

/// As in Evaluator::value: what is apart from its rational part is irrational.
bool SplineAngle::may_be_rational(const SplineParameter& at, const Angle& start) {
  constexpr long bits = 128;
  return enclose(at, start, bits)
      .overlaps(add(rational_ball(at), RealBall(start.radians, bits), bits));
}

/// θ(at) + start, given a joint before: that logarithms cancel is decided for the segments in
/// between.
Real SplineAngle::value_after(const Joint& joint, const SplineParameter& at, const Angle& start) {
  if (joint.segment == at.segment) return angles_[at.segment].value(at.t, start) + joint.theta;
  const auto theta = [this, at, before = joint.theta, start](long bits) {
    return add(enclose(at, start, bits), RealBall(-before, bits), bits);
  };
  return Evaluator(over_unit_interval(joint.segment, at)).value(0, 1, {{1}, {}}, theta, start) +
         joint.theta;
}

/// The last joint up to the start of the segment at which θ is seen to be rational. Where segments
/// cancel again and again, each decision is about few of them.
const SplineAngle::Joint& SplineAngle::last_joint(std::size_t segment) {
  while (joints_known_ < segment) {
    const SplineParameter end{joints_known_++, 1};
    if (!may_be_rational(end, {})) continue;
    const Real theta = value_after(joints_.back(), end, {});
    if (theta.exact()) joints_.push_back({joints_known_, *theta.exact()});
  }
  return *(std::upper_bound(joints_.begin(), joints_.end(), segment,
                            [](std::size_t k, const Joint& joint) { return k < joint.segment; }) -
           1);
}

Real SplineAngle::value(const Rational& t, const Angle& start) {
  return value(locate(spline_, t), start);
}

Real SplineAngle::value(const SplineParameter& at, const Angle& start) {
  if (at.segment == 0) return angles_[0].value(at.t, start);
  if (may_be_rational(at, start)) return value_after(last_joint(at.segment), at, start);
  return {[this, at, start](long bits) { return enclose(at, start, bits); }, {true, bits_of(at.t)}};
}

// Logarithms and a rational number ρ ≠ 0 do not add up to a rational multiple of π [Baker 1975].
std::optional<Rational> SplineAngle::multiple_of_pi(const SplineParameter& at,
                                                    const GaussianPolynomial& phase,
                                                    const Rational& offset) const {
  if (rational_part(0, at) + offset != 0) return std::nullopt;
  return Evaluator(over_unit_interval(0, at)).multiple_of_pi(0, 1, phase);
}

std::optional<GaussianRational> SplineAngle::direction(const SplineParameter& at) {
  while (directions_.size() <= at.segment) {
    const auto next = angles_[directions_.size() - 1].direction(1);
    if (!next) return std::nullopt;
    const GaussianInteger z = primitive_multiple(directions_.back() * *next);
    directions_.push_back({Rational(z.re), Rational(z.im)});
  }
  const auto last = angles_[at.segment].direction(at.t);
  if (!last) return std::nullopt;
  return directions_[at.segment] * *last;
}

std::optional<Real> SplineAngle::holonomy() {
  const auto closing = spline_.closing_turn();
  if (!closing) return std::nullopt;
  // θ(end) + 2·arg back, up to whole turns.
  const GaussianRational back = angle_of({closing->re, -closing->im}).direction;
  const SplineParameter end{angles_.size() - 1, 1};
  const bool is_reversed = sign_after_zero(spline_.segments().front().multiplier()) < 0;  // e₁
  const auto enclosure = [this, end, back, is_reversed](long bits) {
    const long more = bits + 8;
    const RealBall closing_turn =
        multiply(RealBall(2, more), argument(back.re, back.im, more), more);
    const RealBall sum = add(enclose(end, more), closing_turn, more);
    return is_reversed ? subtract({}, sum, more) : sum;
  };
  long size = 0;
  for (const RmfAngle& angle : angles_) size += bits_of(angle.rate());
  const Real turned(enclosure, {false, size});
  const GaussianPolynomial path = path_to(back);
  return reduced(turned, [&] { return multiple_of_pi(end, path * path); }).angle;
}

}  // namespace phrame
