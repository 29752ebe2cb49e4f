#include "phrame/ph/along/path_angle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/partial_sums.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/recent.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/ph/along/antisymmetric_rate.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/plane_turns.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/corner.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"

// At a corner the rotation-minimizing frame is carried by the least rotation, and the frame of v is
// not: behind it θ is greater by the angle from the one to the image of the other. The
// Euler–Rodrigues frame is carried, too, by the choice of preimages, and so is that of Frenet where
// it goes on, since binormals that agree are along the axis of the rotation.
//
// Every PH curve is one on [0, 1], and so is a part of one, reparametrised. Hence θ(t) behind some
// of them is one integral from 0 to 1, of the sum of all rates, and that logarithms of different
// segments cancel is decided as within one.

namespace phrame::inline v0 {
namespace {

constexpr long rational_bits = 256;

/// An antiderivative of θ′; of an angle to the Euler–Rodrigues frame angle_to_erf() is one.
const Antiderivative& whole(const RmfAngle& angle) {
  return angle.bend() ? angle.antiderivative() : angle.angle_to_erf();
}

/// θ(t) − θ(0) without its logarithms.
Rational without_logarithms(const RmfAngle& angle, const Rational& t) {
  return difference_without_logarithms(angle.without_logarithms(), 0, t);
}

/// θ(t), by θ at a rational number m next to t, and θ′ on a ball that contains m and t.
RealBall enclosed(const RmfAngle& angle, const Real& t, long bits) {
  if (t.exact()) return angle.enclose(*t.exact(), bits);
  const RealBall near = t.enclose(bits + 16);
  const Rational m = near.midpoint();
  const RealBall way = subtract(near, RealBall(m, bits + 64), bits + 16);
  return add(angle.enclose(m, bits + 16),
             multiply(evaluate(angle.rate(), near, bits + 16), way, bits + 16), bits + 16);
}

void require_on_segment(const Real& t) {
  if (t.exact() && (*t.exact() < 0 || *t.exact() > 1))
    throw DomainError(fmt::format("t = {} is outside [0, 1]", as_written(*t.exact())));
}

}  // namespace

struct PHRAME_INSIDE PathAngle::State {
  /// What an angle is measured from, and how its closed forms are written.
  struct Measure {
    Reference reference;
    std::optional<Vector<Rational>> up;  ///< v, where it is to the frame of v
    Form form = Form::automatic;

    RmfAngle along(const Curve& curve) const {
      return up ? RmfAngle(curve.preimage(), *up, form) : RmfAngle(curve, reference, form);
    }
  };

  /// A joint, the start of a segment, with a rational θ.
  struct Joint {
    std::size_t segment = 0;
    Rational theta;
  };

  Path path;
  Measure measure;
  std::vector<std::optional<RmfAngle>> closed_forms;    ///< of the segments that are PH curves
  Recent<SegmentIntegral> others{most_kept_integrals};  ///< of the others
  std::size_t closed_segments = 0;  ///< PH curves that come first, without a turn between
  std::map<std::size_t, Real> corner_turns{};  ///< for each segment that begins with a corner
  std::size_t still_segments = 0;              ///< that come first, with θ = 0 all along
  Lazy<Vector<Rational>> chosen_up{};
  Lazy<PlaneTurns> plane_turns{};

  // Each is locked while it grows. Joints ask for sums, and sums for the angles of segments, never
  // the other way.
  PartialSums sums{};  ///< θ(0), θ(1), …
  std::mutex rational_sums_lock;
  std::vector<RealBall> rational_sums{RealBall()};  ///< the parts of these without logarithms
  std::mutex joints_lock;
  std::vector<Joint> joints{{}};  ///< with a rational θ, ascending
  std::size_t joints_known = 0;   ///< joints beyond this one have not been tried yet
  std::mutex directions_lock;
  /// The directions e^{iθ} at joints 0, 1, …, as far as they are in ℚ(i).
  std::vector<GaussianRational> directions{{1, 0}};

  State(const Path& along, Measure by);
  void find_corner_turns();
  bool is_normal_to_plane() const;
  /// By how much θ grows at the corner between these segments.
  Real corner_turn(std::size_t before, std::size_t after) const;
  /// The same angle, whose values are found by this route.
  State(const State& other, Route route);

  const RmfAngle* closed_form(std::size_t k) const {
    return closed_forms[k] ? &*closed_forms[k] : nullptr;
  }
  /// Is θ there a sum of closed forms?
  bool is_closed_up_to(std::size_t segment) const { return segment < closed_segments; }

  std::shared_ptr<const SegmentIntegral> other(std::size_t k) {
    return others.get(k, [&] {
      const Segment& segment = path.segments()[k];
      return measure.up ? up_frame_angle(segment, *measure.up) : frenet_angle(segment);
    });
  }
  RealBall enclose_on(std::size_t k, const Real& t, long bits) {
    return closed_forms[k] ? enclosed(*closed_forms[k], t, bits) : other(k)->enclose(t, bits);
  }
  /// θ up to whole turns, along lines and plane curves.
  std::optional<AngleForm> algebraic_form(const Place& at) const {
    if (!measure.up) return std::nullopt;
    return plane_turns.get([&] { return PlaneTurns(path, *measure.up); }).at(at);
  }

  bool is_zero() const { return still_segments == path.segments().size(); }
  /// Is θ there seen to be 0, as none has turned before?
  bool is_zero_at(const Place& at) const {
    if (at.segment < still_segments) return true;
    return at.segment == still_segments && at.t.exact() == Rational(0) &&
           !corner_turns.contains(at.segment);
  }
  std::optional<Antisymmetry> antisymmetry_up_to(const Place& at);
  RealBall sum_before(std::size_t segment, long bits);
  RealBall enclose(const Place& at, long bits);
  RealBall enclose(const Place& at, const Real& start, long bits);
  Rational rational_part(std::size_t from, const PathParameter& at) const;
  RealBall rational_ball(const PathParameter& at);
  Antiderivative over_unit_interval(std::size_t from, const PathParameter& at) const;
  bool may_be_rational(const PathParameter& at, const FrameAngle& start);
};

PathAngle::State::State(const Path& along, Measure by) : path(along), measure(std::move(by)) {
  const auto& segments = path.segments();
  closed_forms.reserve(segments.size());
  Stage stage("segments", segments.size());
  for (std::size_t k = 0; k < segments.size(); ++k, stage.advance()) {
    closed_forms.emplace_back();
    if (const Curve* curve = ph_curve(segments[k])) closed_forms[k] = measure.along(*curve);
    if (closed_forms[k] && closed_segments == k) ++closed_segments;
    if (still_segments == k && (closed_forms[k] ? closed_forms[k]->is_zero() : other(k)->is_zero()))
      ++still_segments;
  }
  if (measure.up) find_corner_turns();
}

void PathAngle::State::find_corner_turns() {
  if (path.corners().empty() || is_normal_to_plane()) return;
  for (const std::size_t k : path.corners()) {
    Real turn = cached(corner_turn(k - 1, k));
    if (turn.exact() == Rational(0)) continue;
    still_segments = std::min(still_segments, k);
    closed_segments = std::min(closed_segments, k);
    corner_turns.emplace(k, std::move(turn));
  }
}

/// Then the least rotations at corners are about v.
bool PathAngle::State::is_normal_to_plane() const {
  const auto normal = plane_normal(path);
  return normal && cross(*normal, measure.up.value()) == Vector<Rational>{};
}

Real PathAngle::State::corner_turn(std::size_t before, std::size_t after) const {
  const Vector<Real> v = as_reals(measure.up.value());
  const Vector<Real> a = phrame::direction(path, {before, Rational(1)});
  const Vector<Real> b = phrame::direction(path, {after, Rational(0)});
  return carried_angle(a, cross(v, a), b, cross(v, b));
}

PathAngle::State::State(const State& other, Route route)
    : path(other.path),
      measure(other.measure),
      closed_forms(other.closed_forms),
      closed_segments(other.closed_segments),
      corner_turns(other.corner_turns),
      still_segments(other.still_segments) {
  for (auto& angle : closed_forms)
    if (angle) angle->set_route(route);
}

PathAngle::PathAngle(const Path& path) : PathAngle(path, reference_of(path, std::nullopt)) {}

PathAngle::PathAngle(const Path& path, Reference reference, Form form) {
  if (reference == Reference::euler_rodrigues)
    for (std::size_t k = 0; k < path.segments().size(); ++k) segment_with_erf(path, k);
  if (reference == Reference::frenet) require_frenet_joints(path);
  State::Measure measure{reference, std::nullopt, form};
  if (reference == Reference::up) measure.up = up_vector(path);
  state_ = std::make_shared<State>(path, std::move(measure));
}

PathAngle::PathAngle(const Path& path, const Vector<Rational>& v, Form form) {
  require_up_vector(path, v);
  state_ = std::make_shared<State>(path, State::Measure{Reference::up, v, form});
}

const Path& PathAngle::path() const { return state_->path; }

Reference PathAngle::reference() const { return state_->measure.reference; }

const Vector<Rational>& PathAngle::up() const {
  if (state_->measure.up) return *state_->measure.up;
  return state_->chosen_up.get([&] { return up_vector(path()); });
}

const RmfAngle* PathAngle::closed_form(std::size_t k) const { return state_->closed_form(k); }

bool PathAngle::is_zero() const { return state_->is_zero(); }

void PathAngle::set_route(Route route) { state_ = std::make_shared<State>(*state_, route); }

/// θ at the start of the segment.
RealBall PathAngle::State::sum_before(std::size_t segment, long bits) {
  // Few precisions are kept.
  const long enough = bits <= first_bits_of_sums ? first_bits_of_sums : (bits + 31) / 32 * 32;
  return sums.before(segment, enough, [&](std::size_t k, long wanted) {
    const RealBall along = enclose_on(k, Rational(1), wanted);
    const auto turn = corner_turns.find(k + 1);
    return turn == corner_turns.end() ? along
                                      : add(along, turn->second.enclose(wanted), wanted + 32);
  });
}

RealBall PathAngle::State::enclose(const Place& at, long bits) {
  if (is_zero_at(at)) return {};
  constexpr long most = 1L << 20;
  for (long more = bits + 8;; more += 24 + more / 4) {
    const RealBall sum =
        add(sum_before(at.segment, more), enclose_on(at.segment, at.t, more), more);
    if (sum.is_accurate(bits)) return sum;
    if (more > most) throw Undecided("the angle was not found to so many bits");
  }
}

/// Why θ there is 0, where none has turned before that segment, which is no PH curve. What the
/// rates at a few places exclude is not looked into.
std::optional<Antisymmetry> PathAngle::State::antisymmetry_up_to(const Place& at) {
  const std::optional<Rational>& t = at.t.exact();
  if (at.segment > still_segments || closed_forms[at.segment] || !t || *t <= 0 ||
      corner_turns.contains(at.segment))
    return std::nullopt;
  const Segment& segment = path.segments()[at.segment];
  constexpr long most_work = 1'000'000'000;
  constexpr long bits = 64;
  const auto rate = [along = other(at.segment)](const Rational& s) {
    return along->rate(RealBall(s, bits), bits);
  };
  const RealBall at_start = rate(0);
  const RealBall at_t = rate(*t);
  const bool may_be_mirrored = add(at_start, at_t, bits).contains(Rational(0));
  const bool may_be_shifted = at_start.overlaps(at_t);
  if (!may_be_mirrored && !may_be_shifted) return std::nullopt;
  return find_antisymmetry(*t, [&](const Antisymmetry& symmetry) {
    const auto& shift = symmetry.shift;
    if (shift ? !may_be_shifted || !add(at_start, rate(*shift), bits).contains(Rational(0))
              : !may_be_mirrored)
      return false;
    if (const auto* formulas = std::get_if<ExpressionCurve>(&segment))
      return has_antisymmetry(formulas->position(), formulas->from(), formulas->to(), measure.up,
                              *t, symmetry, most_work);
    const RationalCurve* curve = rational_curve(segment);
    return has_antisymmetry(
        measure.up ? up_frame_turning(*curve, *measure.up) : frenet_turning(*curve), *t, symmetry);
  });
}

RealBall PathAngle::State::enclose(const Place& at, const Real& start, long bits) {
  return add(enclose(at, bits), start.enclose(bits), bits);
}

RealBall PathAngle::enclose(const Place& at, long bits) const {
  if (closed_form(at.segment) == nullptr) require_on_segment(at.t);
  return state_->enclose(at, bits);
}

RealBall PathAngle::enclose(const Place& at, const StartAngle& start, long bits) const {
  if (closed_form(at.segment) == nullptr) require_on_segment(at.t);
  return state_->enclose(at, start.value, bits);
}

RealBall PathAngle::rate(const Place& at, long bits) const {
  const RealBall t = at.t.enclose(bits + 8);
  if (const RmfAngle* angle = closed_form(at.segment)) return evaluate(angle->rate(), t, bits);
  require_on_segment(at.t);
  return state_->other(at.segment)->rate(t, bits);
}

/// θ(at) less that at the start of segment `from`, without the logarithms.
Rational PathAngle::State::rational_part(std::size_t from, const PathParameter& at) const {
  Rational sum = without_logarithms(*closed_forms[at.segment], at.t);
  for (std::size_t k = from; k < at.segment; ++k) sum += without_logarithms(*closed_forms[k], 1);
  return sum;
}

/// A ball around θ without the logarithms, at a cost that does not grow with the segments before.
RealBall PathAngle::State::rational_ball(const PathParameter& at) {
  const auto part = [&](std::size_t k, const Rational& t) {
    return RealBall(without_logarithms(*closed_forms[k], t), rational_bits);
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
  for (std::size_t k = from; k < at.segment; ++k) add(whole(*closed_forms[k]));
  if (at.t == 1) {
    add(whole(*closed_forms[at.segment]));
  } else if (at.t != 0) {
    const Curve part = segment(*ph_curve(path.segments()[at.segment]), 0, at.t);
    add(whole(Measure{measure.reference, measure.up}.along(part)));
  }
  return sum;
}

/// As in Evaluator::value: what is apart from its rational part is irrational.
bool PathAngle::State::may_be_rational(const PathParameter& at, const FrameAngle& start) {
  constexpr long bits = 128;
  return enclose(at, to_real(start), bits)
      .overlaps(add(rational_ball(at), RealBall(start.radians, bits), bits));
}

/// θ(at) + start, given a joint before and θ there: that logarithms cancel is decided for the
/// segments in between.
Real PathAngle::value_after(std::size_t joint, const Rational& theta, const PathParameter& at,
                            const FrameAngle& start) const {
  if (joint == at.segment) return closed_form(at.segment)->value(at.t, start) + theta;
  const auto enclosure = [state = state_, at, offset = to_real(start) + -theta](long bits) {
    return state->enclose(at, offset, bits);
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

/// A sum of closed forms.
Real PathAngle::exact_value(const PathParameter& at, const FrameAngle& start) const {
  if (at.segment == 0) return closed_form(0)->value(at.t, start);
  if (state_->may_be_rational(at, start)) return value_after_last_joint(at, start);
  return {[state = state_, at, from = to_real(start)](long bits) {
            return state->enclose(at, from, bits);
          },
          {true, bits_of(at.t)}};
}

Real PathAngle::value(const Rational& t, const StartAngle& start) const {
  return value(locate(path(), t), start);
}

Real PathAngle::value(const Place& at, const StartAngle& start) const {
  const RmfAngle* closed = closed_form(at.segment);
  if (closed == nullptr) require_on_segment(at.t);
  if (state_->is_zero_at(at)) return start.value;
  if (!start.exact) return value(at) + start.value;
  auto form = state_->algebraic_form(at);
  if (!form && state_->is_closed_up_to(at.segment)) {
    if (at.t.exact()) return exact_value({at.segment, *at.t.exact()}, *start.exact);
    if (closed->is_zero()) return exact_value({at.segment, 0}, *start.exact);
  }
  if (!form && state_->antisymmetry_up_to(at)) return start.value;
  const auto enclosure = [*this, at](long bits) { return enclose(at, bits); };
  const Real theta = form ? real_angle(enclosure, *std::move(form), at.t.origin().bits)
                          : Real(enclosure, {false, at.t.origin().bits});
  return *start.exact == FrameAngle() ? theta : theta + start.value;
}

// Logarithms and a rational number ρ ≠ 0 do not add up to a rational multiple of π [Baker 1975].
std::optional<Rational> PathAngle::multiple_of_pi(const PathParameter& at,
                                                  const GaussianPolynomial& phase,
                                                  const Rational& offset) const {
  if (!state_->is_closed_up_to(at.segment)) return std::nullopt;
  if (state_->rational_part(0, at) + offset != 0) return std::nullopt;
  return Evaluator(state_->over_unit_interval(0, at)).multiple_of_pi(0, 1, phase);
}

std::optional<GaussianRational> PathAngle::direction(const PathParameter& at) const {
  if (!state_->is_closed_up_to(at.segment)) return std::nullopt;
  const std::lock_guard lock(state_->directions_lock);
  std::vector<GaussianRational>& directions = state_->directions;
  while (directions.size() <= at.segment) {
    const auto next = closed_form(directions.size() - 1)->direction(1);
    if (!next) return std::nullopt;
    const GaussianInteger z = primitive_multiple(directions.back() * *next);
    directions.push_back({Rational(z.re), Rational(z.im)});
  }
  const auto last = closed_form(at.segment)->direction(at.t);
  if (!last) return std::nullopt;
  return directions[at.segment] * *last;
}

/// The Euler–Rodrigues frame at the start is that at the end, turned by 2·arg of closing_turn().
std::optional<Real> PathAngle::holonomy_to_erf() const {
  const auto closing = path().closing_turn();
  if (!closing) return std::nullopt;
  // θ(end) + 2·arg back, up to whole turns.
  const GaussianRational back = angle_of({closing->re, -closing->im}).direction;
  const PathParameter end{path().segments().size() - 1, 1};
  const auto enclosure = [state = state_, end, back](long bits) {
    const long more = bits + 8;
    const RealBall closing_turn =
        multiply(RealBall(2, more), argument(back.re, back.im, more), more);
    return add(state->enclose(end, more), closing_turn, more);
  };
  long size = 0;
  for (const auto& angle : state_->closed_forms) size += bits_of(angle->rate());
  const Real turned(enclosure, {false, size});
  const GaussianPolynomial turn = path_to(back);
  return reduced(turned, [&] { return multiple_of_pi(end, turn * turn); }).angle;
}

Real PathAngle::turn_of_ends() const {
  if (state_->measure.up && path().closes_at_corner() && !state_->is_normal_to_plane())
    return state_->corner_turn(path().segments().size() - 1, 0);
  return Rational(0);
}

// Where there is no corner e₁ at both ends is the same, the tangent, and so is the frame of v.
std::optional<Real> PathAngle::holonomy() const {
  if (reference() == Reference::frenet)
    throw DomainError("holonomy: it is not found from the angle to the Frenet frame");
  if (reference() == Reference::euler_rodrigues) return holonomy_to_erf();
  if (!path().is_closed()) return std::nullopt;
  const Real turn = turn_of_ends();
  const bool has_turn = turn.exact() != Rational(0);
  if (is_zero() && !has_turn) return Rational(0);
  const PathParameter end{path().segments().size() - 1, 1};
  const Real theta = value(end) + turn;
  if (has_turn || !state_->is_closed_up_to(end.segment)) return reduced(theta).angle;
  return reduced(theta, [&] { return multiple_of_pi(end, path_to({1, 0})); }).angle;
}

Reference reference_of(const Path& path, const std::optional<Vector<Rational>>& v,
                       std::optional<Reference> asked) {
  if (v) return Reference::up;
  return asked.value_or(path.is_ph() ? Reference::euler_rodrigues : Reference::up);
}

PathAngle angle_to(const std::optional<Vector<Rational>>& v, const Path& path,
                   std::optional<Reference> asked, Form form) {
  return v ? PathAngle(path, *v, form) : PathAngle(path, reference_of(path, v, asked), form);
}

}  // namespace phrame
