#include "phrame/answer/machine_path.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/fixed_point.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/ph/along/travel_time.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/twist/path_twist.hpp"

namespace phrame::inline v0 {
namespace {

RealBall in_degrees(const RealBall& radians, long bits) {
  return divide(multiply(RealBall(Rational(180), bits), radians, bits), pi(bits), bits);
}

RealBall opposite(const RealBall& a, long bits) {
  return subtract(RealBall(Rational(0), bits), a, bits);
}

/// The angle from 0 to 180 degrees between the axis and z.
Real tilt_of(const Vector<Real>& axis) {
  return Real([axis](long asked) {
    const long bits = asked + 32;
    const RealBall x = axis[0].enclose(bits);
    const RealBall y = axis[1].enclose(bits);
    const RealBall z = axis[2].enclose(bits);
    const RealBall sine =
        sqrt_of_nonnegative(add(multiply(x, x, bits), multiply(y, y, bits), bits), bits);
    if (sign(z) >= 0) return in_degrees(argument(ComplexBall(z, sine), bits), bits);
    const RealBall rest = in_degrees(argument(ComplexBall(opposite(z, bits), sine), bits), bits);
    return subtract(RealBall(Rational(180), bits), rest, bits);
  });
}

/// One of the angles C, in degrees, with (x, y) in the direction of (sin C, −cos C).
Real turn_of(const Vector<Real>& axis) {
  return Real([x = axis[0], y = axis[1]](long asked) {
    const long bits = asked + 32;
    const RealBall sine = x.enclose(bits);
    const RealBall cosine = opposite(y.enclose(bits), bits);
    if (sign(cosine) >= 0) return in_degrees(argument(ComplexBall(cosine, sine), bits), bits);
    const RealBall rest =
        in_degrees(argument(ComplexBall(opposite(cosine, bits), opposite(sine, bits)), bits), bits);
    return add(RealBall(Rational(180), bits), rest, bits);
  });
}

/// 60/x, 1/minutes of x seconds.
Real inverse_minutes(const Real& seconds) {
  if (seconds.exact()) return Rational(60) / *seconds.exact();
  return Real([seconds](long bits) {
    return divide(RealBall(Rational(60), bits + 8), seconds.enclose(bits + 8), bits + 8);
  });
}

/// n/m to the nearest integer, m > 0.
Integer nearest_quotient(const Integer& n, const Integer& m) {
  return floor(Rational(n, m) + Rational(1, 2));
}

/// The rotary angles of one axis after the other.
class RotaryAngles {
 public:
  explicit RotaryAngles(long places)
      : places_(places), half_turn_(180 * numerator(power_of_ten(places))) {}

  /// Sets those of the move.
  void add(MachineMove& move, const Vector<Real>& axis);
  /// C before the first one that is known.
  const Integer& first_turn() const { return first_turn_; }

 private:
  void take_nearest(MachineMove& move, const Integer& tilt, const Integer& turn);

  long places_;
  Integer half_turn_;
  std::optional<std::pair<Integer, Integer>> last_;  ///< A and C
  bool has_turn_ = false;
  Integer first_turn_ = 0;
};

void RotaryAngles::add(MachineMove& move, const Vector<Real>& axis) {
  const Integer tilt = round_to_places(tilt_of(axis), places_);
  move.is_pole = tilt == 0 || tilt == half_turn_;
  if (move.is_pole) {
    const bool is_negative = last_ && last_->first < 0;
    move.a = is_negative ? Integer(-tilt) : tilt;
    move.c = last_ ? last_->second : Integer(0);
  } else {
    take_nearest(move, tilt, round_to_places(turn_of(axis), places_));
  }
  last_ = {move.a, move.c};
}

void RotaryAngles::take_nearest(MachineMove& move, const Integer& tilt, const Integer& turn) {
  const Integer whole = 2 * half_turn_;
  if (!has_turn_) {
    has_turn_ = true;
    move.a = tilt;
    move.c = turn > half_turn_ ? Integer(turn - whole) : turn;
    first_turn_ = move.c;
    return;
  }
  const auto& [a, c] = *last_;
  std::optional<Integer> least;
  for (const auto& [other, at] :
       {std::pair(tilt, turn), std::pair(Integer(-tilt), Integer(turn + half_turn_))}) {
    const Integer near = at + whole * nearest_quotient(c - at, whole);
    const Integer way = std::max(abs(Integer(other - a)), abs(Integer(near - c)));
    if (least && way >= *least) continue;
    least = way;
    move.a = other;
    move.c = near;
  }
}

/// Makes moves of points and axes, in their order.
class MachineMoves {
 public:
  explicit MachineMoves(const MachineQuery& query)
      : angles_(query.places), path_{query.tool, query.start, {}, query.places, {}} {}

  /// `duration` is that of the move, none at the start.
  void add(const Vector<Real>& tip, const Vector<Real>& axis, const std::optional<Real>& duration);
  /// All of them: poles at the start have the C that comes first.
  MachinePath path();

 private:
  RotaryAngles angles_;
  MachinePath path_;
};

void MachineMoves::add(const Vector<Real>& tip, const Vector<Real>& axis,
                       const std::optional<Real>& duration) {
  MachineMove move;
  for (std::size_t k = 0; k < 3; ++k) move.tip[k] = round_to_places(tip[k], path_.places);
  angles_.add(move, axis);
  if (duration) {
    move.feed = round_to_places(inverse_minutes(*duration), path_.places);
    if (move.feed == 0)
      throw InputError("places", "the feed, 1/minutes of a move, is 0 in " +
                                     std::to_string(path_.places) + " decimals");
  }
  path_.moves.push_back(std::move(move));
}

MachinePath MachineMoves::path() {
  for (MachineMove& move : path_.moves) {
    if (!move.is_pole) break;
    move.c = angles_.first_turn();
  }
  return std::move(path_);
}

Vector<Real> tool_of(const Frame<Real>& frame, ToolAxis tool) {
  return tool == ToolAxis::f2 ? frame.e2 : tool == ToolAxis::f3 ? frame.e3 : frame.e1;
}

/// Of the motion along the path; `axis_at` gives the axis of the tool at a place.
template <class AxisAt>
MachinePath machine_path(const Path& path, const MachineQuery& query, const AxisAt& axis_at) {
  TravelTime time(path, query.motion.feedrate);
  const Rational& period = query.motion.period;
  const Integer ticks = time.ticks(period);
  require_few_rows(query.motion, ticks);
  MachineMoves moves(query);
  const auto add = [&](const Place& at, const std::optional<Real>& duration) {
    moves.add(position(path, at), axis_at(at), duration);
  };
  Stage stage("moves", static_cast<std::size_t>(static_cast<long>(ticks)));
  for (Integer k = 0; k < ticks; ++k) {
    add(time.at_time(Rational(k) * period).at, k == 0 ? std::nullopt : std::optional<Real>(period));
    stage.advance();
  }
  add(time.end().at, time.total() + -Rational(ticks - 1) * period);
  return moves.path();
}

}  // namespace

MachinePath answer(const NamedPath& named, const MachineQuery& query) {
  const Path& path = named.path;
  const PathAngle angle = angle_to(query.up, path);
  if (query.through && query.tool != ToolAxis::e1) {
    const PathTwist twist(angle, *query.through);
    return machine_path(path, query,
                        [&](const Place& at) { return tool_of(twist.frame(at), query.tool); });
  }
  const StartAngle start = start_angle(query.start, angle);
  MachinePath found = machine_path(path, query, [&](const Place& at) {
    return query.tool == ToolAxis::e1
               ? tangent(path, at)
               : tool_of(rotation_minimizing_frame(angle, at, start), query.tool);
  });
  if (angle.reference() == Reference::up) found.up = angle.up();
  return found;
}

}  // namespace phrame
