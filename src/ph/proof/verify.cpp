#include "phrame/ph/proof/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "phrame/algebra/argument.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/proof/check_decisions.hpp"
#include "phrame/ph/proof/check_weight.hpp"
#include "phrame/ph/proof/disc_laws.hpp"

namespace phrame::inline v0 {
namespace {

std::string objection_to_invariants(const Certificate& c) {
  const QuaternionPolynomial& a = c.curve.preimage();
  if (!(c.sigma == sigma(a))) return "sigma is another polynomial";
  if (!(c.h == twist_numerator(a))) return "h is another polynomial";
  if (!(c.g == bend_numerator(a))) return "g is another polynomial";
  return unless(c.hodograph == hodograph_numerator(c.curve), "the hodograph is another one");
}

/// Why Euclid's algorithm modulo m ≥ 2 does not prove that n and d are coprime. m need not be
/// prime.
std::string objection_to_modulus(const Polynomial& n, const Polynomial& d, const Integer& m) {
  if (n.is_zero()) return "";  // then d is constant
  using Residues = std::vector<Integer>;
  const auto residues = [&m](const Polynomial& p) {
    Residues list;
    for (const Rational& c : primitive_part(p).coefficients())
      list.push_back(modulo(Integer(numerator(c)), m));
    return list;
  };
  Residues a = residues(n);
  Residues b = residues(d);
  if (a.back() == 0 || b.back() == 0) return "the modulus divides a leading coefficient";
  while (!b.empty()) {
    const auto unit = inverse_modulo(b.back(), m);
    if (!unit) return "the modulus is no prime";
    for (Integer& x : b) x = modulo(x * *unit, m);
    while (a.size() >= b.size()) {
      const Integer factor = a.back();
      const std::size_t low = a.size() - b.size();
      for (std::size_t k = 0; k < b.size(); ++k) a[low + k] = modulo(a[low + k] - factor * b[k], m);
      while (!a.empty() && a.back() == 0) a.pop_back();
    }
    std::swap(a, b);
  }
  return unless(a.size() == 1, "numerator and denominator have a common factor modulo the modulus");
}

/// That N/D is in lowest terms is decided over ℚ, and whether `modulus` proves it, too.
std::string objection_to_rate(const Certificate& c) {
  const auto& [n, d, common, modulus] = c.rate;
  const QuaternionPolynomial& a = c.curve.preimage();
  if (!(Rational(-2) * twist_numerator(a) == n * common)) return "-2h is not numerator * common";
  if (!(sigma(a) == d * common)) return "sigma is not denominator * common";
  if (!gcd(n, d).is_constant()) return "numerator and denominator have a common factor";
  return objection_to_modulus(n, d, modulus);
}

/// Σ c(z)·log(t − z) over the roots of q.
LogSum over_poles(const Polynomial& q, const Polynomial& c) {
  return {q, c % q, Bivariate({Polynomial{0, -1}, Polynomial{1}})};
}

/// No pole of θ′ is lost by asking for that.
std::string objection_to_index(const Polynomial& q, const Curve& curve) {
  if (q.degree() > 2 * degree(curve.preimage())) return "the index has a higher degree than sigma";
  return unless(!q.is_constant() && is_squarefree(q),
                "the index is constant or has a repeated root");
}

std::string objection_to_antiderivative(const Certificate& c) {
  RationalFunction derivative = differentiate(c.rational);
  for (const CertifiedLogs& sum : c.logs) {
    std::string objection = objection_to_index(sum.index, c.curve);
    if (!objection.empty()) return objection;
    derivative = derivative + differentiate(over_poles(sum.index, sum.residue));
  }
  return unless(derivative == rate_to_erf(c.curve.preimage()), "its derivative is not -2h/sigma");
}

/// The discs of one sum: a root in each by Newton's step m − q(m)/q′(Z) ⊂ Z, and the residue there;
/// and by the inequalities of docs/certificate.md, so that no disc is proved here alone.
class DiscCheck {
 public:
  DiscCheck(const CertifiedLogs& sum, long bits)
      : sum_(sum),
        bits_(bits),
        unit_(power_of_two(-bits)),
        slope_(differentiate(sum.index)),
        numerator_((sum.residue * slope_) % sum.index),
        precision_(2 * bits + primitive_bits(sum.index) + 4 * sum.index.degree() + 128) {}

  std::string objection_to_roots() {
    if (2 * static_cast<long>(sum_.roots.size()) != sum_.index.degree())
      return "the discs are not half as many as the degree of the index";
    std::vector<const RootDisc*> discs;
    for (const RootDisc& disc : sum_.roots) {
      if (disc.radius < 0 || disc.center.im <= disc.radius) return "a disc meets the real axis";
      for (const RootDisc* other : discs)
        if (!are_apart(disc, *other)) return "two discs meet";
      discs.push_back(&disc);
      const auto least = radius_of_root(sum_.index, disc.center, bits_);
      if (!least || disc.radius < *least)
        return fmt::format("the radius of disc {} is too small", discs.size() - 1);
      // In a wide disc q′ may vanish; the root is also in this one.
      if (!find_root(disc) && !find_root({disc.center, *least, {}, {}}))
        return fmt::format("no root is proved in disc {}", discs.size() - 1);
    }
    return "";
  }

  /// Precondition: nothing is said against the roots.
  std::string objection_to_residues() const {
    for (std::size_t k = 0; k < roots_.size(); ++k) {
      const RootDisc& disc = sum_.roots[k];
      const ComplexBall residue = divide(evaluate(numerator_, roots_[k], precision_),
                                         evaluate(slope_, roots_[k], precision_), precision_);
      const bool is_exact = disc.residue_radius == 0;
      if (!holds_residue(sum_.index, numerator_, disc, bits_))
        return fmt::format("the radius of residue {} is too small", k);
      if (is_exact ? !is_residue(disc) : !is_within(residue, disc.residue, disc.residue_radius))
        return fmt::format("the residue of disc {} is not proved", k);
    }
    return "";
  }

 private:
  /// Is |z − center| ≤ radius for all numbers of the ball z?
  bool is_within(const ComplexBall& z, const GaussianInteger& center, const Integer& radius) const {
    if (radius < 0) return false;
    const ComplexBall off = subtract(z, ball(center, 0), precision_);
    return is_at_most(absolute(off, precision_), RealBall(radius * unit_, precision_));
  }

  bool find_root(const RootDisc& disc) {
    if (disc.radius == 0) {
      // Exact: the root is a rational point.
      const Polynomial factor = minimal_polynomial(disc.center);
      roots_.push_back(ball(disc.center, 0));
      return (sum_.index % factor).is_zero();
    }
    const ComplexBall box = ball(disc.center, disc.radius);
    const ComplexBall middle = ball(disc.center, 0);
    const ComplexBall value = evaluate(sum_.index, middle, precision_);
    const auto newton = [&](const ComplexBall& z, const ComplexBall& m, const ComplexBall& at_m) {
      return subtract(m, divide(at_m, evaluate(slope_, z, precision_), precision_), precision_);
    };
    const ComplexBall next = newton(box, middle, value);
    if (!is_within(next, disc.center, disc.radius)) return false;
    // Once more, from its own middle, for a narrow enclosure.
    const ComplexBall m = next.midpoint();
    const ComplexBall narrow = newton(next, m, evaluate(sum_.index, m, precision_));
    roots_.push_back(next.contains(narrow) ? narrow : next);
    return true;
  }

  /// (t − z)(t − z̄), whose only root above the axis is the point z.
  Polynomial minimal_polynomial(const GaussianInteger& z) const {
    const Rational re = z.re * unit_;
    const Rational im = z.im * unit_;
    return {re * re + im * im, -2 * re, 1};
  }

  /// Is w = n(z)/q′(z) for the exact root z? Where n − w·q′, over ℚ(i), is divisible by t − z.
  bool is_residue(const RootDisc& disc) const {
    if (disc.radius != 0) return false;
    const Rational re = disc.residue.re * unit_;
    const Rational im = disc.residue.im * unit_;
    const GaussianPolynomial rest{numerator_ - re * slope_, Rational(-1) * (im * slope_)};
    const Polynomial factor = minimal_polynomial(disc.center);
    // Modulo (t − z)(t − z̄) the rest is linear, a + bt over ℚ(i).
    const Polynomial x = rest.re % factor;
    const Polynomial y = rest.im % factor;
    const GaussianRational z{disc.center.re * unit_, disc.center.im * unit_};
    const GaussianRational slope{x.coefficient(1), y.coefficient(1)};
    const GaussianRational product = slope * z;
    return product.re + x.coefficient(0) == 0 && product.im + y.coefficient(0) == 0;
  }

  ComplexBall ball(const GaussianInteger& z, const Integer& radius) const {
    const auto interval = [&](const Integer& x) {
      return widened(RealBall(x * unit_, precision_), RealBall(radius * unit_, precision_));
    };
    return {interval(z.re), interval(z.im)};
  }

  const CertifiedLogs& sum_;
  long bits_;
  Rational unit_;
  Polynomial slope_;
  Polynomial numerator_;
  long precision_;
  std::vector<ComplexBall> roots_;
};

std::string objection_to_bend(const Certificate::Bend& bend, const GaussianPolynomial& g) {
  if (!(bend.content * bend.polynomial == g)) return "g is not content * polynomial";
  return unless(gcd(bend.polynomial.re, bend.polynomial.im).is_constant(),
                "the parts of the polynomial have a common factor");
}

/// The angle to the frame of a certificate, by other ways than its discs.
class AngleCheck {
 public:
  /// Precondition: the curve has the frame.
  explicit AngleCheck(const Certificate& c)
      : c_(c), angle_(c.curve, c.reference), rate_(angle_.rate()) {
    if (c.reference == Reference::frenet) {
      const GaussianPolynomial bend = regular_bend(c.curve.preimage());
      argument_.emplace(bend);
      bend_rate_ = rate_of_argument(bend);
    }
    if (!c.logs.empty() || !bend_rate_.is_zero()) return;
    if (const Antiderivative F = integrate(rate_); F.logs.empty())
      rational_ = RationalFunction(F.polynomial) + F.rational;
  }

  /// |θ(t) − theta| ≤ radius, exactly where θ is rational, else by quadrature.
  std::string objection(const AngleClaim& claim) const {
    const Rational value = parse_rational(claim.theta);
    const Rational radius = parse_rational(claim.radius);
    if (radius < 0) return "the radius is negative";
    const bool is_frenet = c_.reference == Reference::frenet;
    if (claim.t == 0 || (is_frenet && rate_.is_zero())) return unless(abs(value) <= radius, wrong);
    if (rational_)
      return unless(abs((*rational_)(claim.t) - (*rational_)(0) - value) <= radius, wrong);
    if (radius == 0)
      return "theta is not rational as far as seen, so that no radius of 0 is proved";
    std::string objection = objection_to_value(claim.t, value, radius);
    return objection.empty() ? objection_to_discs(claim.t, value, radius) : objection;
  }

  /// None for the Euler–Rodrigues frame.
  std::string objection_to_turn(const AngleClaim& claim) const {
    if (!argument_) return "";
    if (!(argument_->turn(claim.t) == *claim.turn)) return "the Sturm sequence has other signs";
    // Independent of Sturm: the argument by quadrature of its derivative.
    const RealBall rest =
        subtract(quadrature(bend_rate_, 0, claim.t, 60), argument_->difference(claim.t, 60), 60);
    return unless(rest.is_finite() && rest.lower() > -1 && rest.upper() < 1,
                  "quadrature does not confirm the turn");
  }

 private:
  static constexpr auto wrong = "theta is further off";

  /// Quadrature up to some 300 digits, which takes the third power of their number; where that does
  /// not decide, an antiderivative that is found anew.
  std::string objection_to_value(const Rational& t, const Rational& value,
                                 const Rational& radius) const {
    const long needed = std::max(0L, -binary_exponent(radius)) + 16;
    constexpr long most_for_quadrature = 1100;
    for (const bool by_quadrature : {true, false})
      for (const long bits : {64L, needed, needed + 40, needed + 200}) {
        if (by_quadrature && bits > most_for_quadrature) break;
        const RealBall theta =
            by_quadrature ? quadrature(rate_, 0, t, bits) : angle_.enclose(t, bits);
        if (!theta.is_finite()) continue;
        const Rational lower = theta.lower() - value;
        const Rational upper = theta.upper() - value;
        if (-radius <= lower && upper <= radius) return "";
        if (upper < -radius || radius < lower) return wrong;
      }
    return "the angle is too close to the end of the interval";
  }

  /// Do the discs of the certificate prove it, too?
  std::string objection_to_discs(const Rational& t, const Rational& value,
                                 const Rational& radius) const {
    const RationalFunction& R = c_.rational;
    if (R.denominator()(t) == 0 || R.denominator()(0) == 0) return "the rational part has a pole";
    long bits = std::max(0L, -binary_exponent(radius)) + 128;
    for (const CertifiedLogs& sum : c_.logs)
      for (const RootDisc& disc : sum.roots) {
        if (disc.center.im <= disc.radius) return "a disc meets the real axis";
        bits = std::max(bits, bit_length(disc.residue.re) + bit_length(disc.residue.im) - c_.bits +
                                  std::max(0L, -binary_exponent(radius)) + 128);
      }
    const auto [at_centers, off] = logs_by_discs(c_, t, bits);
    RealBall theta = add(at_centers, RealBall(R(t) - R(0), bits), bits);
    if (argument_) theta = add(theta, argument_->difference(t, bits), bits);
    const RealBall distance = absolute(subtract(theta, RealBall(value, bits), bits));
    return unless(is_at_most(add(distance, off, bits), RealBall(radius, bits)),
                  "the discs are too large");
  }

  const Certificate& c_;
  RmfAngle angle_;
  RationalFunction rate_;
  /// θ up to a constant, where it is that and the certificate has no logarithm and no turn.
  std::optional<RationalFunction> rational_;
  std::optional<ContinuousArgument> argument_;  ///< of the bend, with the Frenet frame
  RationalFunction bend_rate_;                  ///< the derivative of that
};

/// For "decision rrmf: no" the certificate has to show a pole that is not simple, or a residue.
std::string objection_to_poles(const Certificate& c) {
  return unless(
      !differentiate(c.rational).is_zero() || shows_residue_outside_multiples_of_i(c.logs, c.bits),
      "no disc shows a residue outside iZ");
}

}  // namespace

std::vector<Statement> verify(const Certificate& c) {
  const std::string no_frame = "a straight line has no Frenet frame";
  std::vector<Statement> list{{"invariants", objection_to_invariants(c)}};
  if (!c.curve.is_polynomial()) list.push_back({"weight", objection_to_weight(c.curve)});
  list.push_back({"rate", objection_to_rate(c)});
  list.push_back({"antiderivative", objection_to_antiderivative(c)});
  for (std::size_t k = 0; k < c.logs.size(); ++k) {
    const std::string number = std::to_string(k);
    std::string roots = objection_to_index(c.logs[k].index, c.curve);
    std::string residues = "the roots are not proved";
    if (roots.empty()) {
      DiscCheck check(c.logs[k], c.bits);
      roots = check.objection_to_roots();
      if (roots.empty()) residues = check.objection_to_residues();
    }
    list.push_back({"roots of log " + number, roots});
    list.push_back({"residues of log " + number, residues});
  }
  const GaussianPolynomial bend = bend_numerator(c.curve.preimage());
  const bool has_frame = c.reference == Reference::euler_rodrigues || !is_zero(bend);
  if (c.reference == Reference::frenet)
    list.push_back({"bend", has_frame ? objection_to_bend(*c.bend, bend) : no_frame});
  std::optional<AngleCheck> check;
  if (has_frame && !c.claims.empty()) check.emplace(c);
  for (const AngleClaim& claim : c.claims) {
    std::string objection = check ? check->objection_to_turn(claim) : no_frame;
    if (objection.empty()) objection = check->objection(claim);
    list.push_back({claim, objection});
  }
  for (Statement& decision : check_decisions(c.decisions, c.curve)) {
    if (decision.is_proved() && std::get<std::string>(decision.what) == "decision rrmf: no")
      decision.objection = objection_to_poles(c);
    list.push_back(std::move(decision));
  }
  return list;
}

}  // namespace phrame
