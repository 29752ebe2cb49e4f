#include "phrame/ph/frame/algebraic_frame.hpp"

#include "phrame/algebra/error.hpp"

// Components of the Euler–Rodrigues frame are rational functions of t. One of n or b is N/(σ|g|),
// the square root of the rational function N²/(σ²|g|²) with the sign of N. As in Frames, a real
// factor of A is left out: it is a factor of σ, g and N.

namespace phrame {

AlgebraicFrames::AlgebraicFrames(const Curve& curve) {
  const QuaternionPolynomial a = without_real_content(curve.preimage());
  numerators_ = {rotated_i(a), rotated_j(a), rotated_k(a)};
  sigma_ = sigma(a);
  bend_ = bend_numerator(a);
  const RationalFunction rate = rate_to_erf(a);
  is_rotation_minimizing_ = rate.is_zero();
  twist_ = Evaluator(integrate(rate), rate);
}

Frame<Real> AlgebraicFrames::euler_rodrigues(const AlgebraicPoint& t) const {
  const auto vector = [&](const Vector<Polynomial>& v) {
    const auto component = [&](std::size_t k) { return t.value(RationalFunction(v[k], sigma_)); };
    return Vector<Real>{component(0), component(1), component(2)};
  };
  return {vector(numerators_.e1), vector(numerators_.e2), vector(numerators_.e3)};
}

Frame<Real> AlgebraicFrames::frenet(const AlgebraicPoint& t) const {
  if (is_zero(bend_))
    throw DomainError("Frenet frame: the curve is a straight line, it has no principal normal");
  const Polynomial size = norm(bend_);
  if (sign_at(size, t.number()) == 0)
    throw DomainError("Frenet frame: " + place("t", t.number()) +
                      " is an inflection, the principal normal is undefined");
  const auto vector = [&](const Polynomial& x, const Polynomial& y) {
    const auto component = [&](std::size_t k) {
      const Polynomial n = x * numerators_.e2[k] + y * numerators_.e3[k];
      const Real root = t.square_root(RationalFunction(n * n, sigma_ * sigma_ * size));
      return sign_at(n, t.number()) < 0 ? -root : root;
    };
    return Vector<Real>{component(0), component(1), component(2)};
  };
  return {euler_rodrigues(t).e1, vector(bend_.re, -bend_.im), vector(bend_.im, bend_.re)};
}

Real AlgebraicFrames::angle(const AlgebraicPoint& t) const {
  if (is_rotation_minimizing_) return Rational(0);
  const auto enclosure = [twist = twist_, t](long bits) {
    return twist.branch_difference(Rational(0), t.number(), bits + 8);
  };
  return {enclosure, {false, bits_of(t.number()) + bits_of(twist_.derivative())}};
}

Frame<Real> AlgebraicFrames::rotation_minimizing(const AlgebraicPoint& t) const {
  return turned(euler_rodrigues(t), angle(t));
}

}  // namespace phrame
