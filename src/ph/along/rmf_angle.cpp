#include "phrame/ph/along/rmf_angle.hpp"

#include "phrame/algebra/argument.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/integrate/gaussian_logs.hpp"
#include "phrame/integrate/partial_fractions.hpp"
#include "phrame/integrate/short_integral.hpp"
#include "phrame/ph/curve/shape.hpp"

namespace phrame::inline v0 {
namespace {

/// z with arg z = arg p(t) − arg p(0).
GaussianRational turn(const GaussianPolynomial& p, const Rational& t) {
  return GaussianRational{p.re(t), p.im(t)} * GaussianRational{p.re(0), -p.im(0)};
}

const QuaternionPolynomial& not_zero(const QuaternionPolynomial& preimage) {
  if (is_zero(preimage)) throw DomainError("RmfAngle: the preimage is zero, so there is no frame");
  return preimage;
}

/// g ≠ 0.
GaussianPolynomial bend_of(const QuaternionPolynomial& a) {
  GaussianPolynomial g = bend_numerator(a);
  if (is_zero(g))
    throw DomainError(
        "Frenet frame: the curve is a straight line (r′ × r″ = 0), it has no principal normal");
  return g;
}

/// n = (Re g·e₂ − Im g·e₃)/|g| is along v × e₁ = (v·e₃) e₂ − (v·e₂) e₃.
GaussianPolynomial bend_of(const QuaternionPolynomial& a, const Vector<Rational>& v) {
  GaussianPolynomial g{dot(v, rotated_k(a)), dot(v, rotated_j(a))};
  if (is_zero(g)) throw DomainError("the up vector is along the tangent all along");
  return g;
}

GaussianPolynomial without_real_factor(const GaussianPolynomial& g) {
  const Polynomial common = gcd(g.re, g.im);
  return {exact_quotient(g.re, common), exact_quotient(g.im, common)};
}

GaussianRational lowest_coefficient(const GaussianPolynomial& g) {
  GaussianRational lowest;
  for (long k = 0; lowest == GaussianRational(); ++k)
    lowest = {g.re.coefficient(k), g.im.coefficient(k)};
  return lowest;
}

/// Its argument is that of the bend, where there is one, plus that of z at t, and 0 of the latter
/// at 0.
GaussianPolynomial with_turn(const std::optional<GaussianPolynomial>& bend,
                             const GaussianRational& z, const Rational& t) {
  GaussianPolynomial turn = path_to(z);
  if (z.im != 0) {
    const Polynomial over_t{0, 1 / t};
    turn = {compose(turn.re, over_t), compose(turn.im, over_t)};
  }
  return bend ? *bend * turn : turn;
}

}  // namespace

GaussianPolynomial regular_bend(const QuaternionPolynomial& a) {
  return without_real_factor(bend_of(a));
}

GaussianPolynomial regular_bend(const QuaternionPolynomial& a, const Vector<Rational>& v) {
  return without_real_factor(bend_of(a, v));
}

GaussianRational bend_after_zero(const QuaternionPolynomial& a) {
  return lowest_coefficient(bend_of(a));
}

RationalFunction rate_of_argument(const GaussianPolynomial& g) {
  return {(differentiate(g) * conjugate(g)).im, norm(g)};
}

RationalFunction rate_to_erf(const QuaternionPolynomial& a) {
  return {Rational(-2) * twist_numerator(a), sigma(a)};
}

struct RmfAngle::Parts {
  RationalFunction rate;
  RationalFunction rate_to_erf;  ///< θ′ without that of the argument of the bend
  Form form;
  Antiderivative without_logarithms;
  std::optional<GaussianPolynomial> bend;
  std::optional<ContinuousArgument> argument;  ///< of the bend
  Lazy<Antiderivative> angle_to_erf{};
  Lazy<Antiderivative> antiderivative{};
  Lazy<std::optional<GaussianPolynomial>> phase{};  ///< whose argument it is, if any
};

RmfAngle::RmfAngle(const QuaternionPolynomial& preimage, Reference reference, Form form)
    : RmfAngle(preimage,
               reference == Reference::frenet ? std::optional(regular_bend(not_zero(preimage)))
                                              : std::nullopt,
               form) {}

RmfAngle::RmfAngle(const QuaternionPolynomial& preimage, const Vector<Rational>& v, Form form)
    : RmfAngle(preimage, std::optional(regular_bend(not_zero(preimage), v)), form) {}

RmfAngle::RmfAngle(const QuaternionPolynomial& preimage, std::optional<GaussianPolynomial> to_frame,
                   Form form) {
  Parts parts{{}, rate_to_erf(not_zero(preimage)), form, {}, std::move(to_frame), {}};
  auto& bend = parts.bend;
  RationalFunction& to_erf = parts.rate_to_erf;
  parts.rate = to_erf;
  if (bend) {
    const RationalFunction bend_rate = rate_of_argument(*bend);
    if (to_erf + bend_rate == RationalFunction()) {
      // As of a plane curve, whose Frenet frame is rotation-minimizing: θ ≡ 0.
      parts.rate = {};
      to_erf = {};
      bend.reset();
    } else if (degree(*bend) == 0) {
      bend.reset();  // a constant argument
    } else {
      parts.rate = to_erf + bend_rate;
      parts.argument.emplace(*bend);
    }
  }
  const AlgebraicPart part = algebraic_part(to_erf);
  parts.without_logarithms = part.F;
  // Its denominator is factored only where it is asked whether logarithms cancel.
  const SimpleFraction of_logs{part.rest.numerator(), part.rest.denominator()};
  evaluator_ = Evaluator(part.F, to_erf, {of_logs});
  parts_ = std::make_shared<const Parts>(std::move(parts));
}

const RationalFunction& RmfAngle::rate() const { return parts_->rate; }

const Antiderivative& RmfAngle::without_logarithms() const { return parts_->without_logarithms; }

const std::optional<GaussianPolynomial>& RmfAngle::bend() const { return parts_->bend; }

const Antiderivative& RmfAngle::angle_to_erf() const {
  return parts_->angle_to_erf.get([&] { return integrate(parts_->rate_to_erf, parts_->form); });
}

const Antiderivative& RmfAngle::antiderivative() const {
  return parts_->antiderivative.get([&] {
    Antiderivative theta = angle_to_erf();
    if (!bend()) return theta;
    theta.logs.push_back(argument_as_logs(*bend()));
    if (!(differentiate(theta) == rate()))
      throw Error("RmfAngle: the check failed, the derivative of the angle is not its rate");
    return theta;
  });
}

/// The two parts may nearly cancel, as near 0, where they are not taken apart: else the precision
/// rises until their sum is as accurate as asked.
RealBall RmfAngle::enclose(const Rational& t, long bits) const {
  const auto& argument = parts_->argument;
  if (!argument) return evaluator_.difference(0, t, bits);
  if (evaluator_.route() == Route::automatic)
    if (const auto value = short_integral(rate(), Rational(0), t, bits)) return *value;
  for (long more = bits + 8;; more += 64) {
    RealBall sum = add(evaluator_.difference(0, t, more), argument->difference(t, more), more);
    if (sum.is_accurate(bits)) return sum;
  }
}

Real RmfAngle::value(const Rational& t, const FrameAngle& start) const {
  const Real offset = to_real(start);
  if (t == 0) return offset;
  const auto sum = [angle = *this, t, offset](long bits) {
    const RealBall theta = angle.enclose(t, bits);
    return offset.exact() == Rational(0) ? theta : add(theta, offset.enclose(bits), bits);
  };
  return evaluator_.value(0, t, with_turn(bend(), start.direction, t), sum,
                          Angle(start.half_turns, start.radians));
}

std::optional<GaussianRational> RmfAngle::direction(const Rational& t) const {
  const auto& phase = parts_->phase.get([&] { return evaluator_.single_argument(); });
  if (!phase) return std::nullopt;
  const GaussianRational z = turn(*phase, t);
  return bend() ? z * turn(*bend(), t) : z;
}

}  // namespace phrame
