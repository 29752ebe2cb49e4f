#include "phrame/algebra/unreduced.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

Polynomial shifted(const Polynomial& p, long k) {
  Polynomial result;
  if (k >= 0)
    fmpq_poly_shift_left(result.raw(), p.raw(), k);
  else
    fmpq_poly_shift_right(result.raw(), p.raw(), -k);
  return result;
}

/// Divides p ≠ 0 by the highest power tᵏ that divides it; k.
long take_power(Polynomial& p) {
  long k = 0;
  while (p.coefficient(k) == 0) ++k;
  if (k > 0) p = shifted(p, -k);
  return k;
}

/// ⌊log₂⌋ of the larger of the two integers in c ≠ 0; 0 only for ±1.
long log_size(const Rational& c) {
  return std::max(bit_length(numerator(c)), bit_length(denominator(c))) - 1;
}

long log_size(const Polynomial& p) {
  const slong coefficients = std::abs(_fmpz_vec_max_bits(p.raw()->coeffs, p.raw()->length));
  return std::max(coefficients, static_cast<slong>(fmpz_bits(fmpq_poly_denref(p.raw()))));
}

void require_degree(const Integer& degree, const SizeLimits& limits) {
  if (degree > limits.max_degree)
    throw Undecided(fmt::format("the degree {} exceeds the limit {}", abbreviated(degree.str()),
                                limits.max_degree));
}

void require_bits(const Integer& bits, const SizeLimits& limits) {
  if (bits > limits.max_bits)
    throw Undecided(fmt::format("its numbers exceed the limit of {} bits", limits.max_bits));
}

void require(const RationalFunction& f, const SizeLimits& limits) {
  require_degree(std::max(f.numerator().degree(), f.denominator().degree()), limits);
  require_bits(std::max(log_size(f.numerator()), log_size(f.denominator())), limits);
}

Rational power(const Rational& c, long exponent) {
  const auto e = static_cast<unsigned>(exponent);
  return {pow(numerator(c), e), pow(denominator(c), e)};
}

}  // namespace

Unreduced::Unreduced(const RationalFunction& f) {
  if (f.is_zero()) return;
  numerator_ = f.numerator();
  denominator_ = f.denominator();
  shift_ = take_power(numerator_) - take_power(denominator_);
  scale_ = 1;
  if (numerator_.is_constant()) {
    scale_ = numerator_.coefficient(0);
    numerator_ = Polynomial{1};
  }
  if (denominator_.is_constant()) {
    scale_ /= denominator_.coefficient(0);
    denominator_ = Polynomial{1};
  }
}

Unreduced Unreduced::monomial(const Rational& c, long k) {
  Unreduced result(c);
  if (c != 0) result.shift_ = k;
  return result;
}

std::optional<Rational> Unreduced::constant() const {
  Unreduced copy = *this;
  if (!is_monomial()) copy.cancel();
  return copy.is_monomial() && copy.shift_ == 0 ? std::optional(copy.scale_) : std::nullopt;
}

RationalFunction Unreduced::reduced(const SizeLimits& limits) const {
  Polynomial n = scale_ * shifted(numerator_, std::max(shift_, 0L));
  RationalFunction result =
      is_polynomial() || is_zero()
          ? RationalFunction(std::move(n))
          : RationalFunction(std::move(n), shifted(denominator_, std::max(-shift_, 0L)));
  require(result, limits);
  return result;
}

void Unreduced::invert() {
  scale_ = 1 / scale_;
  shift_ = -shift_;
  std::swap(numerator_, denominator_);
}

void Unreduced::cancel() {
  Unreduced rest(RationalFunction(numerator_, denominator_));  // its shift is 0, by the invariant
  scale_ *= rest.scale_;
  numerator_ = std::move(rest.numerator_);
  denominator_ = std::move(rest.denominator_);
}

long Unreduced::degree() const {
  return std::max(numerator_.degree() + std::max(shift_, 0L),
                  denominator_.degree() + std::max(-shift_, 0L));
}

void Unreduced::settle(const SizeLimits& limits) {
  if (degree() > limits.max_degree && !is_monomial()) cancel();
  require_degree(degree(), limits);
  require_bits(log_size(scale_), limits);
}

void Unreduced::multiply(const Unreduced& b, const SizeLimits& limits) {
  if (is_zero() || b.is_zero()) {
    *this = Unreduced();
    return;
  }
  scale_ *= b.scale_;
  shift_ += b.shift_;
  if (!b.is_monomial()) {
    // Degrees are at most twice too high before settle() cancels; the integers must fit at once.
    require_bits(log_size(numerator_) + log_size(b.numerator_), limits);
    require_bits(log_size(denominator_) + log_size(b.denominator_), limits);
    numerator_ *= b.numerator_;
    denominator_ *= b.denominator_;
  }
  settle(limits);
}

void Unreduced::divide(const Unreduced& b, const SizeLimits& limits) {
  if (b.is_zero()) throw DomainError("Unreduced: division by 0");
  Unreduced inverse = b;
  inverse.invert();
  multiply(inverse, limits);
}

void Unreduced::raise(const Integer& exponent, const SizeLimits& limits) {
  if (is_zero()) {
    if (exponent <= 0)
      throw DomainError(fmt::format("Unreduced: 0 to the power {}", abbreviated(exponent.str())));
    return;
  }
  if (exponent < 0) invert();
  if (!is_monomial()) cancel();
  const Integer size = abs(exponent);
  const long least_growth = log_size(scale_);
  if (size == 0 || (degree() == 0 && least_growth == 0)) {  // a power of ±1 may be any
    if (size % 2 == 0) *this = Unreduced(1);
    return;
  }
  require_degree(size * degree(), limits);
  require_bits(size * least_growth, limits);
  const long e = static_cast<long>(size);
  for (Polynomial* p : {&numerator_, &denominator_}) {
    if (p->is_constant()) continue;
    require_bits(Integer(e) * log_size(*p), limits);
    *p = pow(*p, e);
  }
  scale_ = power(scale_, e);
  shift_ *= e;
  settle(limits);
}

void UnreducedSum::add(const Unreduced& a) {
  if (a.is_zero()) return;
  if (a.is_monomial()) {
    Rational& c = monomials_[a.shift()];
    c += a.scale();
    if (c != 0) require_bits(log_size(c), limits_);
    return;
  }
  RationalFunction f = a.reduced(limits_);
  if (f.is_polynomial()) {
    polynomial_ += f.numerator();
    require_bits(log_size(polynomial_), limits_);
    return;
  }
  for (auto& digit : fractions_) {
    if (!digit) {
      digit = std::move(f);
      return;
    }
    f = *digit + f;
    require(f, limits_);
    digit.reset();
  }
  fractions_.emplace_back(std::move(f));
}

/// All but the fractions.
RationalFunction UnreducedSum::laurent_part() const {
  const long low = monomials_.empty() ? 0 : std::min(0L, monomials_.begin()->first);
  const long high = monomials_.empty() ? 0 : std::max(0L, monomials_.rbegin()->first);
  // Brought to the common denominator here, because FLINT would do so once for every coefficient.
  Integer common = 1;
  for (const auto& [k, c] : monomials_) {
    common = lcm(common, denominator(c));
    require_bits(bit_length(common) - 1, limits_);
  }
  std::vector<Rational> coefficients(static_cast<std::size_t>(high - low + 1));
  for (const auto& [k, c] : monomials_)
    coefficients[static_cast<std::size_t>(k - low)] = numerator(c) * (common / denominator(c));
  Polynomial p = Rational(1, common) * Polynomial(coefficients);
  p += shifted(polynomial_, -low);
  return low == 0 ? RationalFunction(std::move(p))
                  : RationalFunction(std::move(p), Polynomial::monomial(1, -low));
}

Unreduced UnreducedSum::total() const {
  if (polynomial_.is_zero() && fractions_.empty() && monomials_.size() <= 1)
    return monomials_.empty()
               ? Unreduced()
               : Unreduced::monomial(monomials_.begin()->second, monomials_.begin()->first);
  RationalFunction sum;
  for (const auto& digit : fractions_)
    if (digit) sum = sum + *digit;
  sum = sum + laurent_part();
  require(sum, limits_);
  return Unreduced(sum);
}

}  // namespace phrame
