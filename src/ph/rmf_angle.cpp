#include "phrame/ph/rmf_angle.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/gaussian_logs.hpp"
#include "phrame/integrate/short_integral.hpp"

namespace phrame {
namespace {

/// z with arg z = arg p(t) − arg p(0).
GaussianRational turn(const GaussianPolynomial& p, const Rational& t) {
  return GaussianRational{p.re(t), p.im(t)} * GaussianRational{p.re(0), -p.im(0)};
}

}  // namespace

GaussianPolynomial regular_bend(const QuaternionPolynomial& a) {
  const GaussianPolynomial g = bend_numerator(a);
  if (is_zero(g))
    throw DomainError(
        "Frenet frame: the curve is a straight line (r′ × r″ = 0), it has no principal normal");
  const Polynomial common = gcd(g.re, g.im);
  return {exact_quotient(g.re, common), exact_quotient(g.im, common)};
}

RationalFunction rate_of_argument(const GaussianPolynomial& g) {
  return {(differentiate(g) * conjugate(g)).im, norm(g)};
}

RationalFunction erf_rate(const QuaternionPolynomial& a) {
  return {Rational(-2) * twist_numerator(a), sigma(a)};
}

RationalFunction frenet_rate(const QuaternionPolynomial& a) {
  return erf_rate(a) + rate_of_argument(regular_bend(a));
}

RmfAngle::RmfAngle(const Curve& curve, Reference reference, Form form)
    : rate_(erf_rate(curve.preimage())) {
  if (reference == Reference::frenet) {
    bend_ = regular_bend(curve.preimage());
    const RationalFunction bend_rate = rate_of_argument(*bend_);
    if (rate_ + bend_rate == RationalFunction()) {
      // A plane curve: its Frenet frame is rotation-minimizing, θ ≡ 0.
      rate_ = {};
      bend_.reset();
    } else if (degree(*bend_) == 0) {
      bend_.reset();  // a constant argument
    } else {
      argument_.emplace(*bend_);
    }
  }
  twist_ = integrate(rate_, form);
  antiderivative_ = twist_;
  evaluator_ = Evaluator(twist_, rate_);
  if (!bend_) return;
  antiderivative_.logs.push_back(argument_as_logs(*bend_));
  rate_ = rate_ + rate_of_argument(*bend_);
  if (!(differentiate(antiderivative_) == rate_))
    throw Error("RmfAngle: the check failed, the derivative of the angle is not its rate");
}

/// The two parts may nearly cancel, as near 0, where they are not taken apart: else the precision
/// rises until their sum is as accurate as asked.
RealBall RmfAngle::enclose(const Rational& t, long bits) {
  if (!argument_) return evaluator_.difference(0, t, bits);
  if (evaluator_.route() == Route::automatic)
    if (const auto value = short_integral(rate_, Rational(0), t, bits)) return *value;
  for (long more = bits + 8;; more += 64) {
    RealBall sum = add(evaluator_.difference(0, t, more), argument_->difference(t, more), more);
    if (sum.is_accurate(bits)) return sum;
  }
}

Real RmfAngle::value(const Rational& t, const Angle& start) {
  const Real offset = to_real(start);
  if (t == 0) return offset;
  const auto sum = [this, t, offset](long bits) {
    const RealBall theta = enclose(t, bits);
    return offset.exact() == Rational(0) ? theta : add(theta, offset.enclose(bits), bits);
  };
  return evaluator_.value(0, t, bend_.value_or(GaussianPolynomial{{1}, {}}), sum, start);
}

std::optional<GaussianRational> RmfAngle::direction(const Rational& t) {
  if (!phase_) phase_ = evaluator_.single_argument();
  if (!*phase_) return std::nullopt;
  const GaussianRational z = turn(**phase_, t);
  return bend_ ? z * turn(*bend_, t) : z;
}

std::optional<Antiderivative> frenet_angle_by_linear_system(const Curve& curve) {
  const QuaternionPolynomial& preimage = curve.preimage();
  const auto split = split_by_linear_system(preimage);
  if (!split) return std::nullopt;
  Antiderivative sum = integrate({-split->a, sigma(preimage)});
  const Antiderivative bend = integrate({-split->b, rho(preimage)});
  sum.rational = sum.rational + bend.rational;
  sum.logs.insert(sum.logs.end(), bend.logs.begin(), bend.logs.end());
  return sum;
}

}  // namespace phrame
