#pragma once
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"

namespace phrame::inline v0::test {

/// From (0, 0, 0), on [0, 1].
inline HermiteSpline one_segment(const Vector<Rational>& step, const Vector<Rational>& d0,
                                 const Vector<Rational>& d1) {
  return {{{0, 0, 0}, step}, {d0, d1}, {0, 1}};
}

/// Decimals of six places, and parameters at steps from 1/2 to 3/2.
inline HermiteSpline random_spline(Random& random, long segments) {
  const auto decimal = [&] { return Rational(random.integer(-1'000'000, 1'000'000), 1'000'000); };
  HermiteSpline data;
  for (long k = 0; k <= segments; ++k) {
    data.points.push_back({decimal() + k, decimal(), decimal()});
    data.derivatives.push_back({1 + decimal(), decimal(), decimal()});
    data.parameters.push_back(
        k == 0 ? Rational(0) : data.parameters.back() + Rational(random.integer(50, 150), 100));
  }
  return data;
}

/// A tolerance beside the size of the data.
inline Deviation relative(const HermiteSpline& data, const Rational& tolerance) {
  return {tolerance * size_of_points(data), tolerance * size_of_derivatives(data),
          tolerance * size_of_accelerations(data)};
}

/// |off| ≤ bound.
inline bool is_within(const Vector<Rational>& off, const Rational& bound) {
  return dot(off, off) <= bound * bound;
}

/// r, r′ and r″ with respect to the parameter.
struct Motion {
  Vector<Rational> r;
  Vector<Rational> d;
  Vector<Rational> dd;
  friend bool operator==(const Motion&, const Motion&) = default;
};

/// Of a segment with the step h of the parameter, by differentiating its position.
inline Motion motion(const Curve& curve, const Rational& h, const Rational& t) {
  Vector<Polynomial> p = position(curve);
  const auto next = [&] {
    for (Polynomial& x : p) x = differentiate(x);
    return evaluate(p, t);
  };
  Motion result{evaluate(p, t), {}, {}};
  result.d = Rational(1 / h) * next();
  result.dd = Rational(1 / (h * h)) * next();
  return result;
}

}  // namespace phrame::test
