// At a zero z of a base p with the exponent e, with t = z + h, p = h·p₁ and q the product of the
// other powers,
//   n/(p₁^e·q) = Σ aₖ·hᵏ,  f = Σ_{k < e} aₖ·h^{k−e} + …,
// so that the integral has a_{e−1}·log((1 − z)/(0 − z)) and aₖ·h^{k−e+1}/(k − e + 1) from h = −z to
// 1 − z for k < e − 1. These and the polynomial part of f are all there is, by partial fractions.
#include "phrame/integrate/pole_change.hpp"

#include "phrame/algebra/ball_log.hpp"
#include "phrame/algebra/complex_series.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

/// A power that is not constant, to some number of bits.
struct KnownPower {
  const PolePower* exact;
  BallPolynomial base;
  std::shared_ptr<const Roots> roots;
};

/// The parts of an integral, of complex numbers.
struct PoleParts {
  ComplexBall rational;
  ComplexBall logarithm;
};

class PoleExpansions {
 public:
  PoleExpansions(const Polynomial& numerator, std::vector<KnownPower> powers, long bits)
      : numerator_(numerator, bits), powers_(std::move(powers)), bits_(bits) {}

  PoleChange change() const {
    PoleChange sum;
    for (const KnownPower& power : powers_) {
      for (const RealBall& z : power.roots->real) add_real_parts(sum, at(power, {z, {}}), 0);
      for (const ComplexBall& z : power.roots->upper) add_real_parts(sum, at(power, z), 1);
    }
    return sum;
  }

 private:
  /// 2ᵏ times the real parts.
  void add_real_parts(PoleChange& sum, const PoleParts& parts, long k) const {
    sum.rational = add(sum.rational, times_power_of_two(parts.rational.re(), k), bits_);
    sum.logarithm = add(sum.logarithm, times_power_of_two(parts.logarithm.re(), k), bits_);
  }

  PoleParts at(const KnownPower& here, const ComplexBall& z) const {
    const long e = here.exact->exponent;
    ComplexSeries below({ComplexBall(RealBall(1, bits_), {})});
    for (const KnownPower& power : powers_) {
      const ComplexSeries p = &power == &here
                                  ? without_constant(series_at(power.base, z, e + 1, bits_))
                                  : series_at(power.base, z, e, bits_);
      const auto exponent = static_cast<unsigned long>(power.exact->exponent);
      below =
          multiply_series(below, exponent == 1 ? p : pow_series(p, exponent, e, bits_), e, bits_);
    }
    const ComplexSeries a = divide_series(series_at(numerator_, z, e, bits_), below, e, bits_);
    const ComplexBall from = inverse(subtract({}, z, bits_), bits_);  // 1/h at the ends
    const ComplexBall to = inverse(subtract({RealBall(1, bits_), {}}, z, bits_), bits_);
    PoleParts parts;
    // Horner's rule in 1/h, with a₀ at its highest power e − 1.
    ComplexBall at_start;
    ComplexBall at_end;
    for (long k = 0; k + 1 < e; ++k) {
      const ComplexBall c =
          multiply(RealBall(Rational(-1, e - 1 - k), bits_), a.coefficient(k), bits_);
      at_start = multiply(add(at_start, c, bits_), from, bits_);
      at_end = multiply(add(at_end, c, bits_), to, bits_);
    }
    parts.rational = subtract(at_end, at_start, bits_);
    parts.logarithm = multiply(a.coefficient(e - 1), log1p(from, bits_), bits_);
    return parts;
  }

  BallPolynomial numerator_;
  std::vector<KnownPower> powers_;
  long bits_;
};

/// The change of the polynomial part of f.
RealBall polynomial_change(const FactoredFunction& f, long bits) {
  long degree = 0;
  for (const auto& [base, exponent] : f.denominator)
    degree += exponent * base.polynomial().degree();
  if (f.numerator.degree() < degree) return {};
  Polynomial product{1};
  for (const auto& [base, exponent] : f.denominator) product *= pow(base.polynomial(), exponent);
  return {antiderivative(divide(f.numerator, product).quotient)(1), bits};
}

/// That power; no value where its zeros are not simple, or not told apart, and where one may be in
/// [0, 1].
std::optional<KnownPower> known_power(const PolePower& power, long bits) {
  KnownPower known{&power, BallPolynomial(power.base.polynomial(), bits), power.base.roots(bits)};
  if (!known.roots) return std::nullopt;
  for (const RealBall& z : known.roots->real)
    if (z.overlaps(hull(0, 1, 8))) return std::nullopt;
  return known;
}

}  // namespace

std::shared_ptr<const Roots> PoleBase::roots(long bits) const {
  if (!roots_.known() && !is_squarefree(p_)) return nullptr;
  try {
    return roots_.get(bits, [&](const Roots* known) {
      if (known == nullptr) return p_.is_constant() ? Roots() : isolate_roots(p_, bits);
      Roots roots = *known;
      refine(p_, roots, bits);
      return roots;
    });
  } catch (const Undecided&) {
    return nullptr;
  }
}

std::optional<PoleChange> pole_change(const FactoredFunction& f, long bits) {
  if (f.numerator.is_zero()) return PoleChange();
  const long first = bits + 32;
  const RealBall known = polynomial_change(f, first);
  for (long more = first; more <= 8 * first; more *= 2) {
    std::vector<KnownPower> powers;
    for (const PolePower& power : f.denominator) {
      auto next = known_power(power, more);
      if (!next) return std::nullopt;
      powers.push_back(*std::move(next));
    }
    PoleChange change = PoleExpansions(f.numerator, std::move(powers), more).change();
    change.rational = add(change.rational, known, more);
    const RealBall whole = change.whole(more);
    if (whole.accuracy_bits() >= bits || (more > first && whole.is_accurate(bits))) return change;
  }
  return std::nullopt;
}

}  // namespace phrame
