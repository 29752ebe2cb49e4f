#include "phrame/ph/along/smooth_travel_time.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/decimal_between.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/travel_time.hpp"
#include "phrame/ph/along/up_vector.hpp"

// V(t) of a rational curve leaves N/(D√S), an AbsoluteIntegral as the length is one. V(t) and V(κ)
// of formulas, and V(κ) of rational curves as formulas, are integrands of Taylor series in balls.
// With V(s) the time is G(s(t)), G(s) = ∫ du/V(u) up to s in closed form: for a ball of s it is
// G(m) + (s − m)/V with an exact m of the ball.

namespace phrame {

/// T along one segment, from its start, for t as one number or as a ball; and dT/dt.
struct SmoothSegmentTime {
  std::function<Real(const Real& t)> value;
  std::function<RealBall(const RealBall& t, long bits)> rate;
};

/// G(s) = ∫₀ˢ du/V(u), for s in [0, length].
class SmoothTimeOfLength {
 public:
  explicit SmoothTimeOfLength(const RationalFunction& speed)
      : speed_(speed),
        evaluator_(integrate(RationalFunction(speed.denominator(), speed.numerator()))) {}

  Real value(const Real& s) const {
    if (s.exact()) return evaluator_.value(0, *s.exact());
    return Real([*this, s](long bits) {
      const RealBall ball = s.enclose(bits + 8);
      const Rational m = std::max(Rational(0), ball.lower());
      const RealBall rest = subtract(ball, RealBall(m, bits + 8), bits + 8);
      const RealBall all = hull(m, ball.upper(), bits + 8);
      return add(evaluator_.difference(0, m, bits + 8),
                 divide(rest, evaluate(speed_, all, bits + 8), bits + 8), bits + 8);
    });
  }
  RealBall rate(const RealBall& s, long bits) const {
    return divide(RealBall(1, bits), evaluate(speed_, s, bits), bits);
  }

 private:
  RationalFunction speed_;
  Evaluator evaluator_;
};

namespace {

constexpr long most_bits = 4096;

SmoothSegmentTime segment_time(const SegmentIntegral& integral) {
  return {[integral](const Real& t) { return integral.value(t); },
          [integral](const RealBall& t, long bits) { return integral.rate(t, bits); }};
}

/// All numbers of the ball, as if it were one.
Real any_of(const RealBall& t) {
  return Real([t](long) { return t; });
}

[[noreturn]] void refuse_speed(const char* what, const std::string& place) {
  throw DomainError(fmt::format("feedrate: the speed {} at {}", what, place));
}

/// Is x ≤ end?
bool is_up_to(const RealAlgebraic& x, const Real& end) {
  if (end.exact()) return compare(x, *end.exact()) <= 0;
  for (long bits = 64; bits <= most_bits; bits *= 2) {
    const RealBall a = enclose(x, bits);
    const RealBall b = end.enclose(bits);
    if (is_less(a, b)) return true;
    if (is_less(b, a)) return false;
  }
  throw Undecided("feedrate: a zero or pole of the speed is not told from the end of the path");
}

/// p has no zero on [0, end].
void require_no_zero(const Polynomial& p, const Real& end, const char* what, const char* letter) {
  if (p.is_constant()) return;
  const Rational beyond = end.exact() ? *end.exact() : end.enclose(64).upper();
  for (const RealRoot& root : real_roots(p, closed(0, beyond)))
    if (is_up_to(root.at, end)) refuse_speed(what, place(letter, root.at));
}

/// V, a function of the letter from 0 to end, is positive and finite there.
void require_positive(const RationalFunction& speed, const Real& end, const char* letter) {
  if (speed.is_zero()) throw DomainError("feedrate: the speed is 0");
  require_no_zero(speed.numerator(), end, "is 0", letter);
  require_no_zero(speed.denominator(), end, "is infinite", letter);
  if (speed(0) < 0)
    throw DomainError(fmt::format("feedrate: the speed is negative, {}{}", as_written(speed(0)),
                                  constant(speed) ? "" : fmt::format(" at {} = 0", letter)));
}

/// V(0), as a constant.
RationalFunction speed_without_curvature(const RationalFunction& speed) {
  if (speed.denominator()(0) == 0)
    throw DomainError("feedrate: it divides by zero all along a straight line");
  return RationalFunction(Polynomial{speed(0)});
}

// ---- V(t)

SmoothSegmentTime time_of(const RationalCurve& curve, const RationalFunction& speed,
                          const Rational& start) {
  RootQuotient rate = phrame::length_rate(curve);
  const RationalFunction of_t = compose(speed, Polynomial{start, 1});
  rate.numerator *= of_t.denominator();
  rate.denominator *= of_t.numerator();
  return segment_time(SegmentIntegral(AbsoluteIntegral(rate)));
}

/// Of an integrand that is analytic where V has no zero and no pole; `refuse` is told where it is
/// not seen to be.
template <class Refuse>
SmoothSegmentTime time_of(const ExpressionCurve& curve, const CurveIntegrand& rate,
                          const Refuse& refuse) {
  if (const auto fault = taylor_parts(curve, rate)->fault) refuse(*fault);
  return segment_time(SegmentIntegral(ExpressionIntegral(curve, rate)));
}

[[noreturn]] void refuse_near_zero(const Rational& t) {
  throw Undecided(fmt::format("feedrate: the speed is 0 or infinite, or nearly so, near t = {:.9g}",
                              static_cast<double>(t)));
}

SmoothSegmentTime time_of(const ExpressionCurve& curve, const RationalFunction& speed,
                          const Rational& start) {
  return time_of(curve, time_by_parameter(speed, start),
                 [&start](const NarrowPart& part) { refuse_near_zero(start + part.lower); });
}

// ---- V(κ)

Formula polynomial_formula(const Polynomial& p) {
  Formula value(p.leading_coefficient());
  for (long k = p.degree(); k-- > 0;)
    value = value * Formula::variable() + Formula(p.coefficient(k));
  return value;
}

ExpressionCurve by_formulas(const ExpressionCurve& curve) { return curve; }

ExpressionCurve by_formulas(const RationalCurve& curve) {
  if (const auto cusps = real_roots(curve.multiplier(), closed(0, 1)); !cusps.empty())
    throw DomainError("feedrate: the curve has a cusp, where its curvature is undefined");
  const Formula below = polynomial_formula(curve.weight());
  const Vector<Polynomial>& X = curve.numerator();
  return {{polynomial_formula(X[0]) / below, polynomial_formula(X[1]) / below,
           polynomial_formula(X[2]) / below},
          Formula(0),
          Formula(1),
          "t"};
}

/// With the last component that is not 0 positive.
Vector<Rational> upward(const Vector<Rational>& n) {
  const Rational& last = n[2] != 0 ? n[2] : n[1] != 0 ? n[1] : n[0];
  return last > 0 ? n : Vector<Rational>{-n[0], -n[1], -n[2]};
}

/// On a straight line, which has no curvature.
SmoothSegmentTime time_of_line(const Segment& segment, const Rational& speed) {
  const SegmentIntegral length = arc_length(segment);
  return {[length, speed](const Real& t) { return Rational(1 / speed) * length.value(t); },
          [length, speed](const RealBall& t, long bits) {
            return divide(length.rate(t, bits), RealBall(speed, bits), bits);
          }};
}

SmoothSegmentTime time_of_curvature(const Segment& segment, const RationalFunction& speed,
                                    const Vector<Rational>& normal, const Rational& start) {
  if (is_straight(Path(segment))) {
    require_positive(speed_without_curvature(speed), Rational(0), "t");
    return time_of_line(segment, speed(0));
  }
  const ExpressionCurve curve =
      visit_curve([](const auto& of) { return by_formulas(of); }, segment);
  const CurveIntegrand rate = time_by_curvature(speed, normal);
  const ExpressionIntegral probe(curve, rate);
  const auto sign_at = [&probe](const Rational& t) {
    return sign(probe.rate(RealBall(t, 256), 256));
  };
  const int first = sign_at(0);
  if (first < 0)
    throw DomainError(fmt::format("feedrate: the speed is negative at t = {}", to_string(start)));
  const SmoothSegmentTime time = time_of(curve, rate, [&](const NarrowPart& part) {
    if (const int other = first * sign_at(widened_part(part).upper); other < 0)
      refuse_speed(
          "is 0 or infinite",
          "t ≈ " + decimal_between(start + part.lower, start + widened_part(part).upper, 9));
    refuse_near_zero(start + part.lower);
  });
  if (first == 0) refuse_near_zero(start);
  return time;
}

}  // namespace

struct SmoothTravelTime::State {
  Path path;
  PathLength length;
  std::optional<Rational> constant_speed;
  std::optional<SmoothTimeOfLength> of_length;  ///< with V(s)
  std::vector<SmoothSegmentTime> segments;      ///< with V(t) and V(κ)
  std::vector<Real> starts;                     ///< T at the starts of the segments and at the end

  explicit State(const Path& along) : path(along), length(along) {}

  void set_speed(const Feedrate& feedrate);
  void set_segments(const Feedrate& feedrate);
  void set_starts();
  Real time(const Place& at) const;
  RealBall rate(std::size_t segment, const RealBall& t, long bits) const;
  std::size_t segment_at(const Rational& time) const;
};

void SmoothTravelTime::State::set_speed(const Feedrate& feedrate) {
  RationalFunction speed = feedrate.speed;
  if (feedrate.of == Feedrate::Of::curvature && !constant(speed) && is_straight(path)) {
    speed = speed_without_curvature(speed);
  }
  constant_speed = constant(speed);
  if (constant_speed) return require_positive(speed, Rational(0), "s");
  if (feedrate.of != Feedrate::Of::arc_length) return set_segments(feedrate);
  require_positive(speed, length.total(), "s");
  of_length.emplace(speed);
}

void SmoothTravelTime::State::set_segments(const Feedrate& feedrate) {
  const bool is_by_parameter = feedrate.of == Feedrate::Of::parameter;
  Vector<Rational> normal{};
  if (is_by_parameter) {
    require_positive(feedrate.speed, path.end(), "t");
  } else {
    const auto found = plane_normal(path);
    if (!found) throw DomainError("feedrate: the signed curvature is that of a path in one plane");
    normal = upward(*found);
  }
  for (const Segment& segment : path.segments()) {
    const Rational start(static_cast<long>(segments.size()));
    segments.push_back(
        is_by_parameter
            ? visit_curve([&](const auto& curve) { return time_of(curve, feedrate.speed, start); },
                          segment)
            : time_of_curvature(segment, feedrate.speed, normal, start));
  }
}

void SmoothTravelTime::State::set_starts() {
  starts.emplace_back(Rational(0));
  for (std::size_t k = 1; k <= path.segments().size(); ++k)
    starts.push_back(remembered(time({k - 1, Rational(1)})));
}

Real SmoothTravelTime::State::time(const Place& at) const {
  if (!segments.empty()) return starts[at.segment] + segments[at.segment].value(at.t);
  const Real s = length.value(at);
  return of_length ? of_length->value(s) : Rational(1 / *constant_speed) * s;
}

RealBall SmoothTravelTime::State::rate(std::size_t segment, const RealBall& t, long bits) const {
  if (!segments.empty()) return segments[segment].rate(t, bits);
  const RealBall s = length.value({segment, any_of(t)}).enclose(bits);
  return multiply(length.rate(segment, t, bits), of_length->rate(s, bits), bits);
}

/// The last one that starts at that time or before.
std::size_t SmoothTravelTime::State::segment_at(const Rational& time) const {
  std::size_t low = 0;
  for (std::size_t high = path.segments().size(); high - low > 1;) {
    const std::size_t middle = (low + high) / 2;
    const bool is_later =
        compare_time(time, starts[middle], fmt::format("that at t = {}", middle)) >= 0;
    (is_later ? low : high) = middle;
  }
  return low;
}

SmoothTravelTime::SmoothTravelTime(const Path& path, const Feedrate& feedrate)
    : state_(std::make_shared<State>(path)) {
  state_->set_speed(feedrate);
  state_->set_starts();
}

const PathLength& SmoothTravelTime::length() const { return state_->length; }
const Real& SmoothTravelTime::total() const { return state_->starts.back(); }
Real SmoothTravelTime::time(const Place& at) const { return state_->time(at); }

SmoothTravelTime::Point SmoothTravelTime::at_time(const Rational& time) const {
  if (is_rounded_total(time, total()))
    return {{state_->path.segments().size() - 1, Rational(1)}, state_->length.total()};
  if (state_->constant_speed) {
    const Rational s = *state_->constant_speed * time;
    return {state_->length.point(s), s};
  }
  const auto point_at = [this](std::size_t k, const Real& t) {
    return Point{{k, t}, state_->length.value({k, t})};
  };
  if (time < 0 || compare_time(time, total(), "the total") > 0)
    throw DomainError(fmt::format("travel time: the time {} is outside [0, {}]", as_written(time),
                                  to_string(total().enclose(64), 9)));
  const std::size_t k = state_->segment_at(time);
  if (state_->starts[k].exact() == time) return point_at(k, Rational(0));
  if (state_->starts[k + 1].exact() == time) return point_at(k, Rational(1));
  const auto F = std::make_shared<const IncreasingFunction>(IncreasingFunction{
      [state = state_, k](const RealBall& t, long bits) {
        return state->time({k, Real(t.midpoint())}).enclose(bits);
      },
      [state = state_, k](const RealBall& t, long bits) { return state->rate(k, t, bits); }});
  const Real t = preimage(F, time, guess_preimage(*F, time));
  return point_at(k, recognized(t, [&](const Rational& r) {
                    return this->time({k, r}).exact() == time;
                  }));
}

}  // namespace phrame
