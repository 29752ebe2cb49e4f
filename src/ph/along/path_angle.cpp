#include "phrame/ph/along/path_angle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/ph/along/frame_angle.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/transform.hpp"

// Every segment is a curve on [0, 1], and so is a part of one, reparametrised. Hence θ(t) is one
// integral from 0 to 1, of the sum of all rates, and that logarithms of different segments cancel
// is decided as within one.

namespace phrame {

std::string frenet_jump(std::size_t joint, const Real& angle) {
  const double by = std::abs(approximate(angle.enclose(64)));
  return fmt::format("Frenet frame: at the joint t = {} it jumps, by {:.3g} radians", joint, by);
}

namespace {

constexpr long rational_bits = 256;

/// The antiderivative of θ′; of the angle to the Euler–Rodrigues frame that to it.
const Antiderivative& whole(const RmfAngle& angle) {
  return angle.bend() ? angle.antiderivative() : angle.angle_to_erf();
}

/// Does the Frenet frame go on through the joints, up to the half turn of an inflection? With one
/// Euler–Rodrigues frame there it does where the two g have the same argument, up to that.
void require_frenet_joints(const PhPath& path) {
  const auto& segments = path.segments();
  GaussianRational before;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const QuaternionPolynomial& a = segments[k].preimage();
    if (is_zero(bend_numerator(a)))
      throw DomainError(fmt::format(
          "Frenet frame: segment {} is a straight line, it has no principal normal", k + 1));
    const GaussianPolynomial g = regular_bend(a);
    const GaussianRational turn = GaussianRational{g.re(0), g.im(0)} * conjugate(before);
    if (k > 0 && turn.im != 0)
      throw DomainError(frenet_jump(
          k, to_real(angle_of(turn.re < 0 ? GaussianRational{-turn.re, -turn.im} : turn))));
    before = {g.re(1), g.im(1)};
  }
}

/// Of the angle at t, which begins at 0.
Rational without_logarithms(const RmfAngle& angle, const Rational& t) {
  return difference_without_logarithms(angle.angle_to_erf(), 0, t);
}

}  // namespace

struct PathAngle::State {
  /// A joint, the start of a segment, with a rational θ.
  struct Joint {
    std::size_t segment = 0;
    Rational theta;
  };

  PhPath path;
  Reference reference;
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

  State(PhPath of, Reference to, std::vector<RmfAngle> of_segments)
      : path(std::move(of)), reference(to), angles(std::move(of_segments)) {}

  RealBall sum_before(std::size_t segment, long bits);
  RealBall enclose(const PathParameter& at, long bits);
  RealBall enclose(const PathParameter& at, const FrameAngle& start, long bits);
  Rational rational_part(std::size_t from, const PathParameter& at) const;
  RealBall rational_ball(const PathParameter& at);
  Antiderivative over_unit_interval(std::size_t from, const PathParameter& at) const;
  bool may_be_rational(const PathParameter& at, const FrameAngle& start);
};

PathAngle::PathAngle(PhPath path, Reference reference, Form form) {
  if (reference == Reference::frenet && !path.is_curve()) require_frenet_joints(path);
  std::vector<RmfAngle> angles;
  Stage stage("segments", path.segments().size());
  for (const Curve& curve : path.segments()) {
    angles.emplace_back(curve, reference, form);
    stage.advance();
  }
  state_ = std::make_shared<State>(std::move(path), reference, std::move(angles));
}

const PhPath& PathAngle::path() const { return state_->path; }

Reference PathAngle::reference() const { return state_->reference; }

const RmfAngle& PathAngle::segment(std::size_t k) const { return state_->angles[k]; }

void PathAngle::take(Route route) {
  std::vector<RmfAngle> angles = state_->angles;
  for (RmfAngle& angle : angles) angle.take(route);
  state_ = std::make_shared<State>(state_->path, state_->reference, std::move(angles));
}

/// θ at the start of the segment.
RealBall PathAngle::State::sum_before(std::size_t segment, long bits) {
  const std::lock_guard lock(sums_lock);
  std::vector<RealBall>& known = sums[bits];
  if (known.empty()) known.emplace_back();
  while (known.size() <= segment)
    known.push_back(add(known.back(), angles[known.size() - 1].enclose(1, bits), bits));
  return known[segment];
}

RealBall PathAngle::State::enclose(const PathParameter& at, long bits) {
  for (long more = bits + 32;; more += 64) {
    const RealBall sum =
        add(sum_before(at.segment, more), angles[at.segment].enclose(at.t, more), more);
    if (sum.is_accurate(bits)) return sum;
  }
}

RealBall PathAngle::State::enclose(const PathParameter& at, const FrameAngle& start, long bits) {
  return add(enclose(at, bits), to_real(start).enclose(bits), bits);
}

RealBall PathAngle::enclose(const PathParameter& at, long bits) const {
  return state_->enclose(at, bits);
}

RealBall PathAngle::enclose(const PathParameter& at, const FrameAngle& start, long bits) const {
  return state_->enclose(at, start, bits);
}

/// θ(at) less that at the start of segment `from`, without the logarithms.
Rational PathAngle::State::rational_part(std::size_t from, const PathParameter& at) const {
  Rational sum = without_logarithms(angles[at.segment], at.t);
  for (std::size_t k = from; k < at.segment; ++k) sum += without_logarithms(angles[k], 1);
  return sum;
}

/// A ball around θ without the logarithms, at a cost that does not grow with the segments before.
RealBall PathAngle::State::rational_ball(const PathParameter& at) {
  const auto part = [&](std::size_t k, const Rational& t) {
    return RealBall(without_logarithms(angles[k], t), rational_bits);
  };
  const std::lock_guard lock(rational_sums_lock);
  while (rational_sums.size() <= at.segment)
    rational_sums.push_back(
        add(rational_sums.back(), part(rational_sums.size() - 1, 1), rational_bits));
  return add(rational_sums[at.segment], part(at.segment, at.t), rational_bits);
}

/// F with F(1) − F(0) = θ(at) less that at the start of segment `from`; what has no logarithm is in
/// the polynomial.
Antiderivative PathAngle::State::over_unit_interval(std::size_t from,
                                                    const PathParameter& at) const {
  Antiderivative sum{Polynomial{0, rational_part(from, at)}, {}, {}};
  const auto add = [&](const Antiderivative& F) {
    sum.logs.insert(sum.logs.end(), F.logs.begin(), F.logs.end());
  };
  for (std::size_t k = from; k < at.segment; ++k) add(whole(angles[k]));
  if (at.t == 1)
    add(whole(angles[at.segment]));
  else if (at.t != 0)
    add(whole(RmfAngle(phrame::segment(path.segments()[at.segment], 0, at.t), reference)));
  return sum;
}

/// As in Evaluator::value: what is apart from its rational part is irrational.
bool PathAngle::State::may_be_rational(const PathParameter& at, const FrameAngle& start) {
  constexpr long bits = 128;
  return enclose(at, start, bits)
      .overlaps(add(rational_ball(at), RealBall(start.radians, bits), bits));
}

/// θ(at) + start, given a joint before and θ there: that logarithms cancel is decided for the
/// segments in between.
Real PathAngle::value_after(std::size_t joint, const Rational& theta, const PathParameter& at,
                            const FrameAngle& start) const {
  if (joint == at.segment) return state_->angles[at.segment].value(at.t, start) + theta;
  const auto enclosure = [state = state_, at, theta, start](long bits) {
    return add(state->enclose(at, start, bits), RealBall(-theta, bits), bits);
  };
  const Evaluator from_joint(state_->over_unit_interval(joint, at));
  return from_joint.value(0, 1, path_to(start.direction), enclosure,
                          Angle(start.half_turns, start.radians)) +
         theta;
}

/// The same from the last joint up to the start of the segment at which θ is seen to be rational.
/// Where segments cancel again and again, each decision is about few of them.
Real PathAngle::value_after_last_joint(const PathParameter& at, const FrameAngle& start) const {
  const auto last_joint = [&] {
    const std::lock_guard lock(state_->joints_lock);
    std::vector<State::Joint>& joints = state_->joints;
    std::size_t& known = state_->joints_known;
    while (known < at.segment) {
      const PathParameter end{known++, 1};
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

Real PathAngle::value(const Rational& t, const FrameAngle& start) const {
  return value(locate(path(), t), start);
}

Real PathAngle::value(const PathParameter& at, const FrameAngle& start) const {
  if (at.segment == 0) return state_->angles[0].value(at.t, start);
  if (state_->may_be_rational(at, start)) return value_after_last_joint(at, start);
  return {[state = state_, at, start](long bits) { return state->enclose(at, start, bits); },
          {true, bits_of(at.t)}};
}

// Logarithms and a rational number ρ ≠ 0 do not add up to a rational multiple of π [Baker 1975].
std::optional<Rational> PathAngle::multiple_of_pi(const PathParameter& at,
                                                  const GaussianPolynomial& phase,
                                                  const Rational& offset) const {
  if (state_->rational_part(0, at) + offset != 0) return std::nullopt;
  return Evaluator(state_->over_unit_interval(0, at)).multiple_of_pi(0, 1, phase);
}

std::optional<GaussianRational> PathAngle::direction(const PathParameter& at) const {
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

std::optional<Real> PathAngle::holonomy() const {
  if (reference() != Reference::euler_rodrigues)
    throw DomainError("holonomy: it is found from the angle to the Euler–Rodrigues frame");
  const auto closing = path().closing_turn();
  if (!closing) return std::nullopt;
  // θ(end) + 2·arg back, up to whole turns.
  const GaussianRational back = angle_of({closing->re, -closing->im}).direction;
  const PathParameter end{state_->angles.size() - 1, 1};
  const auto enclosure = [state = state_, end, back](long bits) {
    const long more = bits + 8;
    const RealBall closing_turn =
        multiply(RealBall(2, more), argument(back.re, back.im, more), more);
    return add(state->enclose(end, more), closing_turn, more);
  };
  long size = 0;
  for (const RmfAngle& angle : state_->angles) size += bits_of(angle.rate());
  const Real turned(enclosure, {false, size});
  const GaussianPolynomial turn = path_to(back);
  return reduced(turned, [&] { return multiple_of_pi(end, turn * turn); }).angle;
}

}  // namespace phrame
