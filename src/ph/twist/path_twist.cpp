#include "phrame/ph/twist/path_twist.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/spline_slopes.hpp"
#include "phrame/ph/curve/vector.hpp"

// Along a leg with u = s/S ∈ [0, 1], δ = T/S and a, b what ω is beyond δ at its ends,
//   φ = δs + S·(a·u(1 − u)² − b·u²(1 − u)),
//   ω = δ + a(1 − u)(1 − 3u) + b·u(3u − 2),  ω′ = (a(6u − 4) + b(6u − 2))/S,
//   ∫ω² ds = S·(δ² + (2(a² + b²) − ab)/15),  ∫ω′² ds = 4(a² + ab + b²)/S,
// for ∫(1 − u)(1 − 3u) = ∫u(3u − 2) = 0 on [0, 1].

namespace phrame::inline v0 {
namespace {

/// A ball with the bits that it is computed with, as a number of a field.
struct FieldBall {
  RealBall x;
  long bits = 64;

  FieldBall() = default;
  FieldBall(long n) : x(n, 64) {}  // NOLINT(google-explicit-constructor)
  FieldBall(RealBall ball, long with) : x(std::move(ball)), bits(with) {}

  friend long bits_for(const FieldBall& a, const FieldBall& b) { return std::max(a.bits, b.bits); }
  friend FieldBall operator+(const FieldBall& a, const FieldBall& b) {
    return {add(a.x, b.x, bits_for(a, b)), bits_for(a, b)};
  }
  friend FieldBall operator-(const FieldBall& a, const FieldBall& b) {
    return {subtract(a.x, b.x, bits_for(a, b)), bits_for(a, b)};
  }
  friend FieldBall operator-(const FieldBall& a) { return FieldBall(0) - a; }
  friend FieldBall operator*(const FieldBall& a, const FieldBall& b) {
    return {multiply(a.x, b.x, bits_for(a, b)), bits_for(a, b)};
  }
  friend FieldBall operator/(const FieldBall& a, const FieldBall& b) {
    return {divide(a.x, b.x, bits_for(a, b)), bits_for(a, b)};
  }
};

/// Segments of a path as a path.
Path part_of(const Path& path, std::size_t first, std::size_t count) {
  const auto begin = path.segments().begin() + static_cast<std::ptrdiff_t>(first);
  std::vector<std::size_t> corners;
  for (const std::size_t k : path.corners())
    if (k > first && k < first + count) corners.push_back(k - first);
  Path part = Path::of_continuous(
      std::vector<Segment>(begin, begin + static_cast<std::ptrdiff_t>(count)), corners);
  // Of what is not turned over the frames are those of the whole path.
  const Place start(0, Rational(0));
  const Vector<Real> here = direction(part, start);
  const Vector<Real> there = direction(path, {first, Rational(0)});
  if (sign_of(dot(here, there)) < 0)
    throw DomainError(fmt::format(
        "frame through orientations: at t = {} the curve goes against its tangent e1, as behind a "
        "cusp where it turns back",
        first));
  return part;
}

/// At an end of a leg the angle is that of this vector.
StartAngle angle_of_joint(const FrameThrough::Joint& joint, const PathAngle& leg, const Place& at) {
  try {
    return start_angle(StartNormal(joint.f2), leg, at);
  } catch (const DomainError& error) {
    throw DomainError(fmt::format("the orientation at t = {}: {}", joint.joint, error.what()));
  }
}

}  // namespace

/// All at once, to so many bits.
struct PathTwist::Slopes {
  std::vector<PathTwist::Leg> legs;
  bool is_periodic;
  Refined<std::vector<RealBall>> known;

  std::vector<RealBall> at(long bits) const;
  Real of(const std::shared_ptr<const Slopes>& self, std::size_t joint) const {
    return cached(Real([self, joint](long bits) {
      return (*self->known.get(bits, [&](const auto*) { return self->at(bits); }))[joint];
    }));
  }
};

std::vector<RealBall> PathTwist::Slopes::at(long bits) const {
  const long working = bits + 32;
  std::vector<FieldBall> lengths;
  std::vector<Vector<FieldBall>> rates;
  for (const Leg& leg : legs) {
    lengths.emplace_back(leg.twist.length().enclose(working), working);
    rates.push_back({FieldBall(leg.twist.rate().enclose(working), working), {0}, {0}});
  }
  std::vector<RealBall> slopes;
  for (const Vector<FieldBall>& slope : cubic_spline_slopes(
           lengths, rates, is_periodic ? SplineEnds::periodic : SplineEnds::natural))
    slopes.push_back(slope[0].x);
  return slopes;
}

/// a and b.
struct PathTwist::Bend {
  Real at_start;
  Real at_end;
};

PathTwist::PathTwist(MinimalTwist whole)
    : rmf_(whole.rmf()), legs_{{0, whole.path().segments().size(), whole}}, turns_before_{0} {}

PathTwist::PathTwist(const PathAngle& rmf, const FrameThrough& through) : rmf_(rmf) {
  const Path& path = rmf.path();
  const auto& joints = through.joints;
  if (joints.size() < 2 || joints.front().joint != 0 ||
      joints.back().joint != path.segments().size())
    throw DomainError("frame through orientations: they are not at both ends of the path");
  std::optional<Vector<Rational>> up;
  if (rmf.reference() == Reference::up) up = rmf.up();
  Integer turns;
  for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
    const std::size_t first = joints[k].joint;
    const std::size_t count = joints[k + 1].joint - first;
    if (joints[k + 1].joint <= first)
      throw DomainError("frame through orientations: their joints do not ascend");
    const bool is_all = count == path.segments().size();
    const PathAngle leg = is_all ? rmf : angle_to(up, part_of(path, first, count), rmf.reference());
    const StartAngle from = angle_of_joint(joints[k], leg, {0, Rational(0)});
    const StartAngle to = angle_of_joint(joints[k + 1], leg, end_of(leg.path()));
    legs_.push_back({first, count, MinimalTwist(leg, from, to, joints[k + 1].turns)});
    turns_before_.push_back(turns);
    turns += legs_.back().twist.turns_at_end();
  }
  const bool turns_at_all = std::any_of(legs_.begin(), legs_.end(), [](const Leg& leg) {
    return leg.twist.twist().exact() != Rational(0);
  });
  if (!through.is_smooth || !turns_at_all) return;
  const bool is_periodic = path.is_closed() && joints.front().f2 == joints.back().f2;
  slopes_ = std::make_shared<const Slopes>(Slopes{legs_, is_periodic, {}});
}

std::size_t PathTwist::leg_at(const Place& at) const {
  const auto after =
      std::upper_bound(legs_.begin(), legs_.end(), at.segment,
                       [](std::size_t segment, const Leg& leg) { return segment < leg.first; });
  return static_cast<std::size_t>(after - legs_.begin()) - 1;
}

Place PathTwist::on_leg(const Place& at) const {
  Place local = at;
  local.segment -= legs_[leg_at(at)].first;
  return local;
}

bool PathTwist::is_joint(const Place& at) const {
  const Leg& leg = legs_[leg_at(at)];
  return (at.segment == leg.first && at.t.exact() == Rational(0)) ||
         (at.segment + 1 == leg.end() && at.t.exact() == Rational(1));
}

PathTwist::Bend PathTwist::bend_of(std::size_t k) const {
  const Real even = legs_[k].twist.rate();
  return {slopes_->of(slopes_, k) + -even, slopes_->of(slopes_, k + 1) + -even};
}

Real PathTwist::share(const Leg& leg, const Place& at) const {
  return cached(quotient_of(leg.twist.arc_length().value(on_leg(at)), leg.twist.length()));
}

/// What φ is beyond δs.
Real PathTwist::beyond_even(const Place& at) const {
  if (!is_smooth() || is_joint(at)) return Rational(0);
  const std::size_t k = leg_at(at);
  const auto [a, b] = bend_of(k);
  const Real u = share(legs_[k], at);
  const Real v = Rational(1) + -u;
  return legs_[k].twist.length() * u * v * (a * v + -(b * u));
}

Real PathTwist::value(const Place& at) const {
  const std::size_t k = leg_at(at);
  const Real even = legs_[k].twist.value(on_leg(at));
  const Real theta = is_smooth() ? even + beyond_even(at) : even;
  return turns_before_[k] == 0 ? theta : theta + whole_turn(turns_before_[k]);
}

Real PathTwist::reduced_value(const Place& at) const {
  const Leg& leg = legs_[leg_at(at)];
  const Real even = leg.twist.reduced_value(on_leg(at));
  return is_smooth() ? even + beyond_even(at) : even;
}

Real PathTwist::turn_after(std::size_t k) const {
  std::vector<Real> turns;
  for (std::size_t j = 0; j <= k; ++j) turns.push_back(legs_[j].twist.twist());
  return sum_of(std::move(turns));
}

Real PathTwist::rate_at_start(std::size_t k) const {
  return is_smooth() ? slopes_->of(slopes_, k) : legs_[k].twist.rate();
}

Real PathTwist::rate_at_end(std::size_t k) const {
  return is_smooth() ? slopes_->of(slopes_, k + 1) : legs_[k].twist.rate();
}

Real PathTwist::rate(const Place& at) const {
  const std::size_t k = leg_at(at);
  const Leg& leg = legs_[k];
  if (!is_smooth()) return leg.twist.rate();
  const auto [a, b] = bend_of(k);
  const Real u = share(leg, at);
  const Real one = Rational(1);
  return leg.twist.rate() + a * ((one + -u) * (one + Real(Rational(-3)) * u)) +
         b * (u * (Real(Rational(3)) * u + Rational(-2)));
}

Real PathTwist::rate_slope(const Place& at) const {
  if (!is_smooth()) return Rational(0);
  const std::size_t k = leg_at(at);
  const auto [a, b] = bend_of(k);
  const Real six_u = Real(Rational(6)) * share(legs_[k], at);
  return quotient_of(a * (six_u + Rational(-4)) + b * (six_u + Rational(-2)),
                     legs_[k].twist.length());
}

Real PathTwist::squared_rate() const {
  std::vector<Real> terms;
  for (std::size_t k = 0; k < legs_.size(); ++k) {
    const MinimalTwist& twist = legs_[k].twist;
    terms.push_back(twist.twist() * twist.rate());
    if (!is_smooth()) continue;
    const auto [a, b] = bend_of(k);
    terms.push_back(twist.length() *
                    (Real(Rational(2, 15)) * (a * a + b * b) + Real(Rational(-1, 15)) * a * b));
  }
  return cached(sum_of(std::move(terms)));
}

Real PathTwist::squared_slope() const {
  std::vector<Real> terms;
  for (std::size_t k = 0; is_smooth() && k < legs_.size(); ++k) {
    const auto [a, b] = bend_of(k);
    terms.push_back(
        quotient_of(Real(Rational(4)) * (a * a + a * b + b * b), legs_[k].twist.length()));
  }
  return cached(sum_of(std::move(terms)));
}

// Where an orientation is given its angle is the argument of a number in ℚ(i), if all is rational.
Frame<Real> PathTwist::frame(const Place& at, const Frame<Real>& reference) const {
  if (is_joint(at)) {
    const Leg& leg = legs_[leg_at(at)];
    const bool is_start = at.segment == leg.first && at.t.exact() == Rational(0);
    const auto& angle = (is_start ? leg.twist.from() : leg.twist.to()).exact;
    const auto known = exactly(reference.e2) && exactly(reference.e3) && exactly(reference.e1);
    if (angle && known)
      if (const auto z = direction_of(*angle))
        return turned(
            Frame<Rational>{*exactly(reference.e1), *exactly(reference.e2), *exactly(reference.e3)},
            *z);
  }
  return turned(reference, cached(reduced_value(at)));
}

std::vector<TwistFrame> twist_frames(const PathTwist& twist, const RationalTwistOptions& options,
                                     const Subdivision& subdivision) {
  if (twist.is_smooth())
    throw DomainError(
        "a rational frame is near one that turns evenly; that of a smooth twist is not known");
  std::vector<TwistFrame> frames;
  Stage stage("legs", twist.legs().size());
  for (const PathTwist::Leg& leg : twist.legs()) {
    Subdivision own = subdivision;
    own.at.clear();
    const Rational first(static_cast<long>(leg.first));
    for (const Rational& t : subdivision.at)
      if (t > first && t < Rational(static_cast<long>(leg.end()))) own.at.push_back(t - first);
    frames.push_back(twist_frame(leg.twist, options, own));
    stage.advance();
  }
  return frames;
}

}  // namespace phrame
