#include "phrame/ph/along/turns.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/curve_series.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long place_bits = 96;

bool meets(const Turns& turns, Plotted quantity) {
  return std::find(turns.infinite.begin(), turns.infinite.end(), quantity) != turns.infinite.end();
}

void add_pole(Turns& turns, Plotted quantity) {
  if (!meets(turns, quantity)) turns.infinite.push_back(quantity);
}

/// The root in an isolating interval of a squarefree f, within 2^−place_bits: halved by the signs
/// of balls, which take far less time than exact ones, and exactly where these do not tell.
Rational place_of(const Polynomial& f, const BallPolynomial& near_f, long precision,
                  const Interval& isolating) {
  Rational a = *isolating.lower;
  Rational b = *isolating.upper;
  const Rational goal = power_of_two(-place_bits);
  const auto sign_of = [&](const Rational& t) {
    return sign(evaluate(near_f, RealBall(t, precision), precision));
  };
  const int at_a = sign_of(a);
  while (b - a > goal) {
    const Rational middle = (a + b) / 2;
    const int there = sign_of(middle);
    if (there == 0 || at_a == 0) return *narrowed(f, {a, b, false, false}, goal).lower;
    (there == at_a ? a : b) = middle;
  }
  return a;
}

/// Adds where the slope of a quantity is 0 in [0, 1]; `of` is the quantity or its square.
template <class Function>
void add_turns(Turns& turns, Plotted quantity, const Polynomial& slope, const Function& of) {
  constexpr long highest = 600;  // degree, of which the roots take seconds
  if (slope.is_constant()) return;
  if (slope.degree() > highest) {
    turns.are_all = false;
    return;
  }
  const Polynomial f = squarefree_part(slope);
  const long precision = 2 * place_bits + 4 * f.degree();
  const BallPolynomial near_f(f, precision);
  for (const Interval& isolating : isolate_real_roots(f, closed_interval(0, 1))) {
    const Rational at = place_of(f, near_f, precision, isolating);
    // Next to a cusp balls may not keep the denominator from 0.
    const RealBall value = evaluate(of, RealBall(at, 2 * place_bits), 2 * place_bits);
    const double about = value.is_finite() ? approximate(value) : round_to_double(of(at));
    turns.list.push_back({quantity, at, about});
  }
}

/// The same of a rational quantity, or one with a rational square.
void add_turns(Turns& turns, Plotted quantity, const RationalFunction& of) {
  if (count_real_roots(of.denominator(), closed_interval(0, 1)) > 0) add_pole(turns, quantity);
  add_turns(turns, quantity, differentiate(of).numerator(), of);
}

}  // namespace

Turns turns(const Curve& curve) {
  Turns found;
  const RationalFunction rate = rate_to_erf(curve.preimage());
  add_turns(found, Plotted::theta, rate.numerator(), Polynomial{0});
  add_turns(found, Plotted::theta_rate, rate);
  add_turns(found, Plotted::curvature, squared_curvature(curve));
  if (!line_direction(curve.preimage())) add_turns(found, Plotted::torsion, torsion(curve));
  const RationalFunction speed(curve.multiplier() * sigma(curve.preimage()),
                               pow(curve.weight(), 2));
  add_turns(found, Plotted::speed, differentiate(speed).numerator() * curve.multiplier(),
            speed * speed);
  return found;
}

namespace {

Turns turns_of(const RationalCurve& curve) {
  Turns found;
  add_turns(found, Plotted::curvature, squared_curvature(curve));
  if (!are_on_a_line(direction_span(curve))) add_turns(found, Plotted::torsion, torsion(curve));
  return found;
}

// A curve by formulas: with the series of r around all points of a part, κ² and τ there are in
//   f(middle) + f′(part)·(part − middle),
// which is off by the square of the width.

constexpr long series_bits = 80;

using Series = Vector<BallPolynomial>;

BallPolynomial product(const BallPolynomial& p, const BallPolynomial& q) {
  return multiply_series(p, q, 2, series_bits);
}

BallPolynomial dot_series(const Series& a, const Series& b) {
  BallPolynomial sum;
  for (std::size_t k = 0; k < 3; ++k) sum = add(sum, product(a[k], b[k]), series_bits);
  return sum;
}

Series cross_series(const Series& a, const Series& b) {
  Series c;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    c[k] = subtract(product(a[i], b[j]), product(a[j], b[i]), series_bits);
  }
  return c;
}

Series derivative_series(const Series& a) {
  return {differentiate(a[0], series_bits), differentiate(a[1], series_bits),
          differentiate(a[2], series_bits)};
}

/// f and f′ at t, or on a ball of t.
struct Jet {
  RealBall value;
  RealBall slope;
};

/// κ² or τ on one curve.
class Shape {
 public:
  Shape(const Segment& segment, Plotted quantity)
      : curve_(series_of(Path(segment))), quantity_(quantity) {}

  Jet at(const RealBall& t) const {
    const Series first = derivative_series(curve_.position(0, t, 5, series_bits));
    const Series second = derivative_series(first);
    const Series bend = cross_series(first, second);
    const BallPolynomial rho = dot_series(bend, bend);
    const BallPolynomial sigma = dot_series(first, first);
    const BallPolynomial f =
        quantity_ == Plotted::curvature
            ? divide_series(rho, product(sigma, product(sigma, sigma)), 2, series_bits)
            : divide_series(dot_series(bend, derivative_series(second)), rho, 2, series_bits);
    return {f.coefficient(0), f.coefficient(1)};
  }

  /// A ball that contains f on [a, b].
  RealBall on(const Rational& a, const Rational& b) const {
    const Rational middle = (a + b) / 2;
    const RealBall half = hull(Rational(a - middle), Rational(b - middle), series_bits);
    const Jet jet = at(hull(a, b, series_bits));
    return add(at(RealBall(middle, series_bits)).value, multiply(jet.slope, half, series_bits),
               series_bits);
  }

 private:
  CurveSeries curve_;
  Plotted quantity_;
};

/// The least and the greatest value seen so far.
struct Extremes {
  Turn least;
  Turn greatest;

  void see(const Rational& t, double value) {
    if (value < least.about) least = {least.quantity, t, value};
    if (value > greatest.about) greatest = {greatest.quantity, t, value};
  }
  bool contain(const RealBall& range, double slack) const {
    if (!range.is_finite()) return false;
    const double more = slack * std::max(std::abs(least.about), std::abs(greatest.about));
    return -upper_double(subtract(RealBall(), range, series_bits)) >= least.about - more &&
           upper_double(range) <= greatest.about + more;
  }
};

void add_extremes(Turns& turns, const Segment& segment, Plotted quantity) {
  constexpr int most_parts = 4000;
  constexpr long first_parts = 64;
  const Shape shape(segment, quantity);
  const auto value = [&](const Rational& t) {
    return approximate(shape.at(RealBall(t, series_bits)).value);
  };
  Extremes seen{{quantity, 0, value(0)}, {quantity, 0, value(0)}};
  std::vector<std::pair<Rational, Rational>> parts;
  for (long k = first_parts; k-- > 0;) {
    parts.emplace_back(Rational(k, first_parts), Rational(k + 1, first_parts));
    seen.see(parts.back().second, value(parts.back().second));
  }
  for (int done = 0; !parts.empty(); ++done) {
    if (done == most_parts) {
      turns.are_all = false;
      break;
    }
    const auto [a, b] = parts.back();
    parts.pop_back();
    if (seen.contain(shape.on(a, b), turns.slack)) continue;
    const Rational middle = (a + b) / 2;
    seen.see(middle, value(middle));
    parts.emplace_back(middle, b);
    parts.emplace_back(a, middle);
  }
  for (const Turn* turn : {&seen.least, &seen.greatest})
    if (turn->at > 0 && turn->at < 1) turns.list.push_back(*turn);
}

}  // namespace

Turns turns(const Segment& segment) {
  if (const RationalCurve* rational = rational_curve(segment)) return turns_of(*rational);
  Turns found;
  // κ is seen by its square: of that, twice as much.
  found.slack = 1e-3;
  const auto span = direction_span(segment);
  add_extremes(found, segment, Plotted::curvature);
  if (!are_on_a_line(span) && !common_normal(span)) add_extremes(found, segment, Plotted::torsion);
  return found;
}

}  // namespace phrame
