#include "phrame/ph/along/rmf_angle.hpp"

#include <algorithm>

#include "phrame/algebra/argument.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/near_elementary.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/integrate/gaussian_logs.hpp"
#include "phrame/integrate/known_integral.hpp"
#include "phrame/integrate/partial_fractions.hpp"
#include "phrame/integrate/pole_sum.hpp"
#include "phrame/integrate/short_integral.hpp"
#include "phrame/ph/curve/shape.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long first_bits = 128;      // of a value, as Evaluator::value() has them
constexpr long most_quick_bits = 80;  // that poles in doubles give

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

struct PHRAME_INSIDE RmfAngle::Parts {
  /// What values from poles in doubles do not need.
  struct Reduced {
    RationalFunction rate;
    RationalFunction rate_to_erf;  ///< θ′ without that of the argument of the bend
    AlgebraicPart part;            ///< of rate_to_erf
    Evaluator evaluator;           ///< of angle_to_erf

    Reduced(RationalFunction to_erf, const std::optional<GaussianPolynomial>& bend,
            bool has_simple_poles);
  };

  /// θ′ to the Euler–Rodrigues frame, perhaps not in lowest terms, or 0 where θ ≡ 0.
  Polynomial numerator;
  Polynomial denominator;
  Form form;
  std::optional<GaussianPolynomial> bend;
  std::optional<ContinuousArgument> argument{};  ///< of the bend
  Lazy<Reduced> made{};
  Refined<std::optional<std::vector<NearPole>>> poles{};  ///< of θ′ to the Euler–Rodrigues frame
  Lazy<Antiderivative> angle_to_erf{};
  Lazy<Antiderivative> antiderivative{};
  Lazy<std::optional<GaussianPolynomial>> phase{};  ///< whose argument it is, if any

  void join_bend();
  const Reduced& reduced() const;
  Evaluator evaluator(Route route) const;
  const std::vector<NearPole>* near_poles() const;
  std::optional<RealBall> quick(const Rational& t) const;
};

RmfAngle::Parts::Reduced::Reduced(RationalFunction to_erf,
                                  const std::optional<GaussianPolynomial>& bend,
                                  bool has_simple_poles)
    : rate(bend ? to_erf + rate_of_argument(*bend) : to_erf),
      rate_to_erf(std::move(to_erf)),
      part(has_simple_poles ? AlgebraicPart{{}, rate_to_erf} : algebraic_part(rate_to_erf)) {
  // Its denominator is factored only where it is asked whether logarithms cancel.
  const SimpleFraction of_logs{part.rest.numerator(), part.rest.denominator()};
  evaluator = Evaluator(part.F, rate_to_erf, {of_logs});
}

/// What of the bend is left: nothing where its argument is constant or makes θ ≡ 0.
void RmfAngle::Parts::join_bend() {
  const RationalFunction to_erf(numerator, denominator);
  if (to_erf + rate_of_argument(*bend) == RationalFunction()) {
    // As of a plane curve, whose Frenet frame is rotation-minimizing: θ ≡ 0.
    numerator = {};
    denominator = {1};
    bend.reset();
  } else if (degree(*bend) == 0) {
    bend.reset();  // a constant argument
  } else {
    argument.emplace(*bend);
  }
}

namespace {

/// The bend of that frame; none for the Euler–Rodrigues frame.
std::optional<GaussianPolynomial> bend_to(Reference reference, const QuaternionPolynomial& a) {
  switch (reference) {
    case Reference::euler_rodrigues:
      return std::nullopt;
    case Reference::frenet:
      return regular_bend(not_zero(a));
    case Reference::up:
      break;
  }
  throw DomainError("the angle to the frame of a vector v is RmfAngle(preimage, v)");
}

}  // namespace

RmfAngle::RmfAngle(const QuaternionPolynomial& preimage, Reference reference, Form form)
    : RmfAngle(preimage, bend_to(reference, preimage), form) {}

RmfAngle::RmfAngle(const QuaternionPolynomial& preimage, const Vector<Rational>& v, Form form)
    : RmfAngle(preimage, std::optional(regular_bend(not_zero(preimage), v)), form) {}

RmfAngle::RmfAngle(const QuaternionPolynomial& preimage, std::optional<GaussianPolynomial> to_frame,
                   Form form) {
  Parts parts{Rational(-2) * twist_numerator(not_zero(preimage)), sigma(preimage), form,
              std::move(to_frame)};
  if (parts.bend) parts.join_bend();
  parts_ = std::make_shared<const Parts>(std::move(parts));
}

const RmfAngle::Parts::Reduced& RmfAngle::Parts::reduced() const {
  return made.get([&] {
    const auto known = poles.known();
    return Reduced({numerator, denominator}, bend, known && known->has_value());
  });
}

Evaluator RmfAngle::Parts::evaluator(Route route) const {
  Evaluator evaluator = reduced().evaluator;
  evaluator.set_route(route);
  return evaluator;
}

/// Those of θ′ to the Euler–Rodrigues frame; null where doubles do not tell.
const std::vector<NearPole>* RmfAngle::Parts::near_poles() const {
  const auto found =
      poles.get(0, [&](const auto*) { return phrame::near_poles(numerator, denominator); });
  return *found ? &**found : nullptr;
}

/// θ(t) from these poles, where there is no bend.
std::optional<RealBall> RmfAngle::Parts::quick(const Rational& t) const {
  const std::vector<NearPole>* known = argument ? nullptr : near_poles();
  if (known == nullptr) return std::nullopt;
  return rounding_to_nearest([&]() -> std::optional<RealBall> {
    const NearNumber theta = change(*known, near_number(t));
    return std::isfinite(theta.error) ? std::optional(ball_of(theta)) : std::nullopt;
  });
}

const std::vector<NearPole>* RmfAngle::near_poles() const {
  return bend() || route_ != Route::automatic ? nullptr : parts_->near_poles();
}

const RationalFunction& RmfAngle::rate() const { return parts_->reduced().rate; }

bool RmfAngle::is_zero() const { return parts_->numerator.is_zero() && !bend(); }

const Antiderivative& RmfAngle::without_logarithms() const { return parts_->reduced().part.F; }

const std::optional<GaussianPolynomial>& RmfAngle::bend() const { return parts_->bend; }

const Antiderivative& RmfAngle::angle_to_erf() const {
  return parts_->angle_to_erf.get([&] {
    const std::vector<NearPole>* poles = parts_->near_poles();
    return integrate(parts_->reduced().rate_to_erf, parts_->reduced().part, parts_->form, poles);
  });
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
  if (t == 0) return {};
  const auto& argument = parts_->argument;
  if (route_ == Route::automatic && bits <= most_quick_bits && !is_zero())
    if (auto ball = parts_->quick(t); ball && ball->is_accurate(bits)) return *std::move(ball);
  const Evaluator evaluator = parts_->evaluator(route_);
  if (!argument) return evaluator.difference(0, t, bits);
  if (route_ == Route::automatic)
    if (const auto value = short_integral(rate(), Rational(0), t, bits)) return *value;
  for (long more = bits + 8;; more += 64) {
    RealBall sum = add(evaluator.difference(0, t, more), argument->difference(t, more), more);
    if (sum.is_accurate(bits)) return sum;
  }
}

// With start, θ is a linear form in logarithms of algebraic numbers, plus a rational number. So it
// is transcendental unless it is that number [Baker 1975].
Real RmfAngle::value(const Rational& t, const FrameAngle& start) const {
  const Real offset = to_real(start);
  if (t == 0) return offset;
  const auto with_start = [offset](RealBall theta, long bits) {
    return offset.exact() == Rational(0) ? theta : add(theta, offset.enclose(bits), bits);
  };
  const auto sum = [angle = *this, t, with_start](long bits) {
    return with_start(angle.enclose(t, bits), bits);
  };
  if (auto ball = route_ == Route::automatic ? parts_->quick(t) : std::nullopt) {
    *ball = with_start(*std::move(ball), first_bits);
    if (ball->is_finite() && !ball->contains(start.radians)) {
      const auto at_least = [sum](long bits) { return sum(std::max(bits, first_bits)); };
      const long size = primitive_bits(parts_->numerator) + primitive_bits(parts_->denominator);
      return {at_least, {true, bits_of(t) + 1 + size}, *std::move(ball)};
    }
  }
  return parts_->evaluator(route_).value(0, t, with_turn(bend(), start.direction, t), sum,
                                         Angle(start.half_turns, start.radians));
}

std::optional<GaussianRational> RmfAngle::direction(const Rational& t) const {
  const auto& phase =
      parts_->phase.get([&] { return parts_->evaluator(route_).single_argument(); });
  if (!phase) return std::nullopt;
  const GaussianRational z = turn(*phase, t);
  return bend() ? z * turn(*bend(), t) : z;
}

}  // namespace phrame
