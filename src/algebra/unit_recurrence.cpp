#include "phrame/algebra/unit_recurrence.hpp"

#include <algorithm>
#include <cmath>

namespace phrame::inline v0 {
namespace {

long bits_for(std::size_t count) { return static_cast<long>(std::bit_width(count)); }

}  // namespace

template <class Number>
FixedCoefficients<Number>::FixedCoefficients(const IntegerPolynomial& p, const Integer& divisor,
                                             long most_bits)
    : now_(static_cast<std::size_t>(fmpz_poly_length(p.get()))),
      divisor_(divisor.sign() < 0 ? -divisor : divisor),
      most_bits_(most_bits) {
  for (std::size_t k = 0; k < now_.size(); ++k) {
    Integer c(p.get()->coeffs + k);
    if (divisor.sign() < 0) c = -c;
    if constexpr (std::same_as<Number, Integer>)
      exact_.push_back(std::move(c));
    else
      now_[k] = from_integer<Number>(quotient(std::move(c), most_bits));
  }
  if constexpr (!std::same_as<Number, Integer>) bits_ = most_bits;
}

/// ⌊c·2^bits/divisor⌋.
template <class Number>
Integer FixedCoefficients<Number>::quotient(Integer c, long bits) const {
  fmpz_mul_2exp(c.raw(), c.raw(), static_cast<ulong>(bits));
  fmpz_fdiv_q(c.raw(), c.raw(), divisor_.raw());
  return c;
}

template <class Number>
void FixedCoefficients<Number>::choose(long needed) {
  if constexpr (std::same_as<Number, Integer>) {
    if (bits_ != 0 && needed <= bits_ && (needed > bits_ - 48 || bits_ <= 32)) return;
    const long before = bits_;
    bits_ = std::min(most_bits_, std::max(needed, 16L) + 16);
    if (bits_ == before) return;
    // To divide by the divisor takes about as long as a product with it.
    const bool were_exact = are_exact_;
    are_exact_ = 2 * bit_length(divisor_) <= bits_;
    if (are_exact_ && were_exact) return;
    for (std::size_t k = 0; k < exact_.size(); ++k)
      now_[k] = are_exact_ ? exact_[k] : quotient(exact_[k], bits_);
  }
}

template <class Number>
Number FixedCoefficients<Number>::share(const ProductSum<Number>& sum, std::size_t n) const {
  if constexpr (std::same_as<Number, Integer>)
    if (are_exact_) return floor_quotient(sum.over(divisor_), n);
  return floor_quotient(sum.upper(bits_), n);
}

template <class Number>
void FixedSeries<Number>::push(Number x) {
  c.push_back(std::move(x));
  most = std::max(most, bit_length(c.back()));
  if (c.size() % 8 != 0) return;
  most = 0;
  for (std::size_t k = c.size() - std::min(window, c.size()); k < c.size(); ++k)
    most = std::max(most, bit_length(c[k]));
}

template <class Number>
void FixedSeries<Number>::count_errors(const FixedCoefficients<Number>& coefficients,
                                       std::size_t count, long bits_of_numbers) {
  if (coefficients.are_exact()) return;
  const long e = std::clamp(bits_of_numbers - coefficients.bits(), -1000L, 1000L);
  left_over += std::ldexp(static_cast<double>(count), static_cast<int>(e));
}

template <class Number>
RootRecurrence<Number>::RootRecurrence(const UnitQuotient& f, long Q, long most_bits)
    : sigma_(f.radicand, Integer(f.radicand.get()->coeffs), most_bits),
      w_(std::max(sigma_.size(), static_cast<std::size_t>(fmpz_poly_length(f.numerator.get())))) {
  w_.push(from_integer<Number>(Integer(1) << static_cast<unsigned long>(Q)));
}

template <class Number>
void RootRecurrence<Number>::step() {
  const std::size_t n = w_.c.size();
  const std::size_t degree = sigma_.size() - 1;
  sigma_.choose(w_.most + bits_for(degree));
  ProductSum<Number> sum;
  for (std::size_t i = 1; i <= std::min(n, degree); ++i)
    sum.add(sigma_[i], w_.c[n - i], static_cast<long>(2 * n) - static_cast<long>(i));
  w_.left_over += 1;
  w_.count_errors(sigma_, degree, w_.most);
  w_.push(-sigma_.share(sum, 2 * n));
}

template <class Number>
QuotientRecurrence<Number>::QuotientRecurrence(const UnitQuotient& f, long most_bits)
    : nu_(f.numerator, Integer(1) << static_cast<unsigned long>(unit_exponent(f.numerator)),
          most_bits),
      delta_(f.denominator, Integer(f.denominator.get()->coeffs), most_bits),
      y_(delta_.size()) {}

template <class Number>
void QuotientRecurrence<Number>::step(const FixedSeries<Number>& w) {
  const std::size_t n = y_.c.size();
  nu_.choose(w.most + bits_for(nu_.size()));
  delta_.choose(y_.most + bits_for(delta_.size()));
  ProductSum<Number> of_w;
  ProductSum<Number> of_y;
  for (std::size_t j = 0; j < nu_.size() && j <= n; ++j) of_w.add(nu_[j], w.c[n - j]);
  for (std::size_t i = 1; i < delta_.size() && i <= n; ++i) of_y.add(delta_[i], y_.c[n - i]);
  y_.left_over += 1;  // of the difference of two numbers that are rounded down
  y_.count_errors(nu_, nu_.size(), w.most);
  y_.count_errors(delta_, delta_.size() - 1, y_.most);
  y_.push(nu_.share(of_w) - delta_.share(of_y));
}

template class FixedCoefficients<Integer>;
template class FixedCoefficients<TwoWords>;
template struct FixedSeries<Integer>;
template struct FixedSeries<TwoWords>;
template class RootRecurrence<Integer>;
template class RootRecurrence<TwoWords>;
template class QuotientRecurrence<Integer>;
template class QuotientRecurrence<TwoWords>;

}  // namespace phrame
