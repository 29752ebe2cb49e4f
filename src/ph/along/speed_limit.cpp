#include "phrame/ph/along/speed_limit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/recent.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/curve_series.hpp"
#include "phrame/ph/curve/exact_vector.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "phrame/ph/curve/formula_program.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"

// With K = κ² the normal limit is v² = A/√K. Signs are asked of functions without a root of K where
// there are any, as K may be 0: v < V is A² < V⁴K.
//
// dw/ds is 2V·V′/|r′| with the derivative by t, and of the normal limit −A·K′/(2·√K³·|r′|).

namespace phrame::inline v0 {
namespace {

using Kind = SpeedLimit::Kind;
using Of = Feedrate::Of;

BallPolynomial constant_polynomial(const RealBall& c) {
  return BallPolynomial(std::vector<RealBall>{c});
}

}  // namespace

int compare(const SquaredSpeed& a, const SquaredSpeed& b, const std::string& where) {
  if (a.square && b.square) return (*a.square - *b.square).sign();
  const Real difference = a.value + -b.value;
  const int found = sign_of(difference);
  if (found == 0 && !difference.exact())
    throw Undecided("feedrate: which of two limits of the speed is less is not told " + where);
  return found;
}

// ---- |r′| and κ along a segment

/// What they are made of: exact functions of t along rational curves, whose series are narrow.
struct SpeedLimits::ExactMotion {
  std::optional<Polynomial> speed = {};  ///< |r′| along PH curves, on which f keeps its sign
  RationalFunction square;               ///< |r′|²
  RationalFunction squared_curvature;    ///< κ²
  RationalFunction fourth;               ///< (√κ|r′|)⁴
};

SpeedLimits::ExactMotion SpeedLimits::exact_motion(const Segment& segment,
                                                   const RationalCurve& curve) {
  const Polynomial& p = curve.multiplier();
  const Polynomial sigma = dot(curve.direction(), curve.direction());
  ExactMotion found;
  if (const Curve* ph = ph_curve(segment); ph != nullptr && has_polynomial_length(*ph))
    found.speed = differentiate(ArcLength(*ph).polynomial());
  found.square = {p * p * sigma, pow(curve.weight(), 4)};
  found.squared_curvature = phrame::squared_curvature(curve);
  found.fourth = found.squared_curvature * found.square * found.square;
  return found;
}

namespace {

BallPolynomial series_around(const RationalFunction& f, const RealBall& t, long length, long bits) {
  const BallPolynomial above = taylor_series(f.numerator(), t, length, bits);
  return f.is_polynomial()
             ? above
             : divide_series(above, taylor_series(f.denominator(), t, length, bits), length, bits);
}

/// f to the power quarters/4, f > 0, by f·g′ = (quarters/4)·f′·g. Of wide balls it is narrower than
/// by Newton's steps, and of a polynomial f it takes as many products as that has terms.
BallPolynomial power_in_quarters(const BallPolynomial& f, long quarters, long length, long bits) {
  const RealBall first = f.coefficient(0);
  std::vector<RealBall> g{pow(sqrt(sqrt(first, bits), bits), std::abs(quarters), bits)};
  if (quarters < 0) g[0] = divide(RealBall(1, bits), g[0], bits);
  const long most = f.degree_bound();
  std::vector<RealBall> terms;
  for (long k = 0; k <= most; ++k) terms.push_back(f.coefficient(k));
  for (long n = 1; n < length; ++n) {
    RealBall sum;
    for (long k = 1; k <= std::min(n, most); ++k) {
      const RealBall factor(Rational(quarters * k - 4 * (n - k)), bits);
      sum = add_product(std::move(sum), multiply(factor, terms[static_cast<std::size_t>(k)], bits),
                        g[static_cast<std::size_t>(n - k)], bits);
    }
    const RealBall below = multiply(RealBall(Rational(4 * n), bits), first, bits);
    g.push_back(divide(sum, below, bits));
  }
  return BallPolynomial(g);
}

/// r′ × r″ and |r′|² of formulas.
struct Bend {
  Vector<BallPolynomial> cross;
  BallPolynomial square;
};

BallPolynomial sum_of_squares(const Vector<BallPolynomial>& v, long length, long bits) {
  BallPolynomial sum;
  for (const BallPolynomial& x : v) sum = add(sum, multiply_series(x, x, length, bits), bits);
  return sum;
}

Bend bend_of(const Vector<BallPolynomial>& r, long length, long bits) {
  Vector<BallPolynomial> first;
  Vector<BallPolynomial> second;
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = differentiate(r[k], bits);
    second[k] = differentiate(first[k], bits);
  }
  Bend found;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    found.cross[k] = subtract(multiply_series(first[i], second[j], length, bits),
                              multiply_series(first[j], second[i], length, bits), bits);
  }
  found.square = sum_of_squares(first, length, bits);
  return found;
}

}  // namespace

struct SpeedLimits::State {
  PathLength length;
  Path path;
  CurveSeries curve;
  Feedrate::Limits limits;
  std::optional<Vector<Rational>> normal;
  mutable Recent<ExactMotion> exact{most_kept_integrals};

  State(const PathLength& along, const Path& whole, const Feedrate::Limits& most,
        std::optional<Vector<Rational>> of_plane)
      : length(along),
        path(whole),
        curve(phrame::series_of(whole)),
        limits(most),
        normal(std::move(of_plane)) {}

  std::shared_ptr<const ExactMotion> exactly(std::size_t segment) const {
    const RationalCurve* of = rational_curve(path.segments()[segment]);
    if (of == nullptr) return nullptr;
    return exact.get(segment, [&] { return exact_motion(path.segments()[segment], *of); });
  }
  Bend bend(std::size_t segment, const RealBall& t, long terms, long bits) const {
    return bend_of(curve.position(segment, t, terms + 2, bits), terms, bits);
  }
  BallPolynomial speed(std::size_t segment, const RealBall& t, long terms, long bits) const;
  BallPolynomial squared_curvature(std::size_t segment, const RealBall& t, long terms,
                                   long bits) const;
  BallPolynomial fourth(std::size_t segment, const RealBall& t, long terms, long bits) const;
  BallPolynomial signed_curvature(std::size_t segment, const RealBall& t, long terms,
                                  long bits) const;
  BallPolynomial function(const Feedrate::Function& f, std::size_t segment, const RealBall& t,
                          long terms, long bits) const;
};

BallPolynomial SpeedLimits::State::speed(std::size_t segment, const RealBall& t, long terms,
                                         long bits) const {
  if (const auto known = exactly(segment)) {
    if (known->speed) return taylor_series(*known->speed, t, terms, bits);
    return power_in_quarters(series_around(known->square, t, terms, bits), 2, terms, bits);
  }
  const Vector<BallPolynomial> r = curve.position(segment, t, terms + 1, bits);
  const Vector<BallPolynomial> first{differentiate(r[0], bits), differentiate(r[1], bits),
                                     differentiate(r[2], bits)};
  return power_in_quarters(sum_of_squares(first, terms, bits), 2, terms, bits);
}

BallPolynomial SpeedLimits::State::squared_curvature(std::size_t segment, const RealBall& t,
                                                     long terms, long bits) const {
  if (const auto known = exactly(segment))
    return series_around(known->squared_curvature, t, terms, bits);
  const Bend found = bend(segment, t, terms, bits);
  return divide_series(sum_of_squares(found.cross, terms, bits),
                       pow_series(found.square, 3, terms, bits), terms, bits);
}

/// κ²|r′|⁴.
BallPolynomial SpeedLimits::State::fourth(std::size_t segment, const RealBall& t, long terms,
                                          long bits) const {
  if (const auto known = exactly(segment)) return series_around(known->fourth, t, terms, bits);
  const Bend found = bend(segment, t, terms, bits);
  return divide_series(sum_of_squares(found.cross, terms, bits), found.square, terms, bits);
}

BallPolynomial SpeedLimits::State::signed_curvature(std::size_t segment, const RealBall& t,
                                                    long terms, long bits) const {
  const Bend found = bend(segment, t, terms, bits);
  BallPolynomial along;
  for (std::size_t k = 0; k < 3; ++k)
    along = add(along, multiply(RealBall((*normal)[k], bits), found.cross[k], bits), bits);
  const RealBall size = sqrt(RealBall(dot(*normal, *normal), bits), bits);
  const BallPolynomial inverse = inverse_sqrt_series(found.square, terms, bits);
  return multiply(divide(RealBall(1, bits), size, bits),
                  multiply_series(along, pow_series(inverse, 3, terms, bits), terms, bits), bits);
}

/// V around t, its quantity as a series in z.
BallPolynomial SpeedLimits::State::function(const Feedrate::Function& f, std::size_t segment,
                                            const RealBall& t, long terms, long bits) const {
  BallPolynomial x;
  if (f.of == Of::parameter) {
    const RealBall start(Rational(static_cast<long>(segment)), bits);
    x = truncated(BallPolynomial({add(start, t, bits), RealBall(1, bits)}), terms);
  } else if (f.of == Of::arc_length) {
    const Real at([t](long) { return t; });
    if (terms > 1) x = antiderivative(speed(segment, t, terms - 1, bits), bits);
    x = with_constant(x, t.is_zero() ? length.before(segment).enclose(bits)
                                     : length.enclose({segment, at}, bits));
  } else {
    x = signed_curvature(segment, t, terms, bits);
  }
  return evaluate_steps(f.speed.steps(), x, terms, bits).back();
}

// ---- limits

SpeedLimits::SpeedLimits(const PathLength& length, const Path& path, const Feedrate::Limits& limits,
                         std::optional<Vector<Rational>> normal)
    : state_(std::make_shared<const State>(length, path, limits, std::move(normal))) {}

SpeedLimit SpeedLimits::limit(const Feedrate::Function& function) const {
  if (!is_constant(function.speed))
    return {Kind::function, function, Rational(0), {}, function.of == Of::curvature};
  if (const auto v = rational_value(function.speed))
    return {Kind::constant, function, *v, *v * *v * *v * *v};
  return {Kind::constant, function,
          Real([f = function.speed](long bits) { return constant_value(f, bits + 8); })};
}

std::optional<SpeedLimit> SpeedLimits::normal_limit(std::size_t segment) const {
  const Segment& of = state_->path.segments()[segment];
  if (is_straight(Path(of))) return std::nullopt;
  require_regular(segment);
  if (const auto known = state_->exactly(segment))
    if (const auto K = constant(known->squared_curvature))
      return SpeedLimit{Kind::constant,
                        {},
                        square_root_of(over_square_root(*state_->limits.normal, *K)),
                        *state_->limits.normal * *state_->limits.normal / *K,
                        true};
  return SpeedLimit{Kind::normal, {}, Rational(0), {}, true};
}

void SpeedLimits::require_regular(std::size_t segment) const {
  const auto found = cusps(state_->path.segments()[segment]);
  if (found.empty()) return;
  throw DomainError(fmt::format(
      "feedrate: the curve has a cusp at {}, where only a constant is a limit of the speed",
      place_text("t", affine(found.front().at, 1, Rational(static_cast<long>(segment))))));
}

bool SpeedLimits::curvature_goes_on(std::size_t segment) const {
  const auto& segments = state_->path.segments();
  const auto* before = std::get_if<ExpressionCurve>(&segments[segment - 1]);
  const auto* behind = std::get_if<ExpressionCurve>(&segments[segment]);
  if (before == nullptr || behind == nullptr) return false;
  FormulaProgram program;
  for (std::size_t order = 1; order <= 2; ++order)
    if (exact_derivative(*before, order, 1, program) !=
        exact_derivative(*behind, order, 0, program))
      return false;
  return true;
}

SeriesFunction SpeedLimits::speed(const SpeedLimit& limit, std::size_t segment) const {
  return [state = state_, limit, segment](const RealBall& t, long length, long bits) {
    if (limit.kind == Kind::constant) return constant_polynomial(limit.constant.enclose(bits));
    if (limit.kind == Kind::function)
      return state->function(limit.function, segment, t, length, bits);
    return multiply(
        sqrt(RealBall(*state->limits.normal, bits), bits),
        power_in_quarters(state->squared_curvature(segment, t, length, bits), -1, length, bits),
        bits);
  };
}

SeriesFunction SpeedLimits::time_rate(const SpeedLimit& limit, std::size_t segment) const {
  return [state = state_, limit, segment](const RealBall& t, long length, long bits) {
    if (limit.kind == Kind::function)
      return divide_series(state->speed(segment, t, length, bits),
                           state->function(limit.function, segment, t, length, bits), length, bits);
    return multiply(
        divide(RealBall(1, bits), sqrt(RealBall(*state->limits.normal, bits), bits), bits),
        power_in_quarters(state->fourth(segment, t, length, bits), 1, length, bits), bits);
  };
}

SeriesFunction SpeedLimits::difference(const SpeedLimit& a, const SpeedLimit& b,
                                       std::size_t segment) const {
  if (a.kind != Kind::normal && b.kind != Kind::normal)
    return [first = speed(a, segment), second = speed(b, segment)](const RealBall& t, long length,
                                                                   long bits) {
      return subtract(first(t, length, bits), second(t, length, bits), bits);
    };
  const bool is_first = a.kind == Kind::normal;
  return [state = state_, is_first, V = speed(is_first ? b : a, segment), segment](
             const RealBall& t, long length, long bits) {
    const BallPolynomial product =
        multiply_series(pow_series(V(t, length, bits), 4, length, bits),
                        state->squared_curvature(segment, t, length, bits), length, bits);
    const RealBall A(*state->limits.normal, bits);
    const BallPolynomial square = constant_polynomial(multiply(A, A, bits));
    return is_first ? subtract(square, product, bits) : subtract(product, square, bits);
  };
}

std::optional<Polynomial> SpeedLimits::algebraic_difference(const SpeedLimit& a,
                                                            const SpeedLimit& b,
                                                            std::size_t segment) const {
  if (a.kind != Kind::normal) {
    if (b.kind != Kind::normal) return std::nullopt;
    const auto found = algebraic_difference(b, a, segment);
    return found ? std::optional(-*found) : std::nullopt;
  }
  const auto known = state_->exactly(segment);
  if (!known || b.kind != Kind::constant || !b.fourth_power) return std::nullopt;
  const Rational& A = *state_->limits.normal;
  const RationalFunction& K = known->squared_curvature;  // its denominator is positive
  return A * A * K.denominator() - *b.fourth_power * K.numerator();
}

SeriesFunction SpeedLimits::excess(const SpeedLimit& limit, int side, std::size_t segment) const {
  const Rational bound = Rational(side) * *state_->limits.tangential;
  return [state = state_, limit, bound, segment](const RealBall& t, long length, long bits) {
    const BallPolynomial most =
        multiply(RealBall(bound, bits), state->speed(segment, t, length, bits), bits);
    if (limit.kind == Kind::function) {
      const BallPolynomial V = state->function(limit.function, segment, t, length + 1, bits);
      return subtract(multiply_series(V, differentiate(V, bits), length, bits), most, bits);
    }
    const BallPolynomial K = state->squared_curvature(segment, t, length + 1, bits);
    const BallPolynomial cube =  // √K³
        power_in_quarters(K, 6, length, bits);
    return subtract(multiply(RealBall(-*state->limits.normal, bits), differentiate(K, bits), bits),
                    multiply(RealBall(4, bits), multiply_series(cube, most, length, bits), bits),
                    bits);
  };
}

SquaredSpeed SpeedLimits::squared(const SpeedLimit& limit, std::size_t segment,
                                  const Real& t) const {
  if (limit.kind == Kind::constant) {
    if (limit.fourth_power) return {square_root_of(*limit.fourth_power), limit.fourth_power};
    return {limit.constant * limit.constant};
  }
  if (limit.kind == Kind::function && limit.function.of != Of::curvature && t.exact()) {
    const Real x = limit.function.of == Of::arc_length
                       ? state_->length.value({segment, t})
                       : t + Real(Rational(static_cast<long>(segment)));
    const auto v = x.exact() ? rational_value(limit.function.speed, *x.exact()) : std::nullopt;
    if (v) return {*v * *v, *v * *v * *v * *v};
  }
  const auto known = state_->exactly(segment);
  if (limit.kind == Kind::normal && t.exact() && known) {
    const Rational K = known->squared_curvature(*t.exact());
    const Rational& A = *state_->limits.normal;
    if (K != 0) return {over_square_root(A, K), A * A / K};
  }
  return {cached(Real([V = speed(limit, segment), t](long bits) {
    const RealBall at = V(t.enclose(bits + 8), 1, bits + 8).coefficient(0);
    return multiply(at, at, bits + 8);
  }))};
}

}  // namespace phrame
