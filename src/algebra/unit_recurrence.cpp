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
    : now_(static_cast<std::size_t>(fmpz_poly_length(p.get()))), full_bits_(most_bits) {
  for (std::size_t k = 0; k < now_.size(); ++k) {
    Integer c;
    fmpz_mul_2exp(c.raw(), p.get()->coeffs + k, static_cast<ulong>(full_bits_));
    fmpz_fdiv_q(c.raw(), c.raw(), divisor.raw());
    if constexpr (std::same_as<Number, Integer>)
      full_.push_back(std::move(c));
    else
      now_[k] = from_integer<Number>(c);
  }
}

template <class Number>
void FixedCoefficients<Number>::round_to(long bits) {
  if constexpr (std::same_as<Number, Integer>)
    for (std::size_t k = 0; k < full_.size(); ++k)
      now_[k] = full_[k] >> static_cast<unsigned long>(full_bits_ - bits);
}

bool BitsInUse::choose(long needed) {
  if (now != 0 && needed <= now && (needed > now - 48 || now <= 32)) return false;
  const long before = now;
  now = std::min(full, std::max(needed, 16L) + 16);
  return now != before;
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
void FixedSeries<Number>::count_errors(std::size_t count, long bits_of_numbers, long bits) {
  const long e = std::clamp(bits_of_numbers - bits, -1000L, 1000L);
  left_over += 1 + std::ldexp(static_cast<double>(count), static_cast<int>(e));
}

namespace {

/// What a recurrence takes of its coefficients now: fewer bits where the numbers have fewer.
template <class Number, class... Lists>
void choose_bits(BitsInUse& bits, long needed, Lists&... lists) {
  if constexpr (std::same_as<Number, Integer>) {
    if (bits.choose(needed)) (lists.round_to(bits.now), ...);
  } else {
    bits.now = bits.full;
  }
}

}  // namespace

template <class Number>
RootRecurrence<Number>::RootRecurrence(const UnitQuotient& f, long Q, long most_bits)
    : sigma_(f.radicand, Integer(f.radicand.get()->coeffs), most_bits),
      bits_{most_bits},
      w_(std::max(sigma_.size(), static_cast<std::size_t>(fmpz_poly_length(f.numerator.get())))) {
  w_.push(from_integer<Number>(Integer(1) << static_cast<unsigned long>(Q)));
}

template <class Number>
void RootRecurrence<Number>::step() {
  const std::size_t n = w_.c.size();
  const std::size_t degree = sigma_.size() - 1;
  choose_bits<Number>(bits_, w_.most + bits_for(degree), sigma_);
  ProductSum<Number> sum;
  for (std::size_t i = 1; i <= std::min(n, degree); ++i)
    sum.add(sigma_[i], w_.c[n - i], static_cast<long>(2 * n) - static_cast<long>(i));
  w_.count_errors(degree, w_.most, bits_.now);
  w_.push(-floor_quotient(sum.upper(bits_.now + 1), n));
}

template <class Number>
QuotientRecurrence<Number>::QuotientRecurrence(const UnitQuotient& f, long most_bits)
    : nu_(f.numerator, Integer(1) << static_cast<unsigned long>(unit_exponent(f.numerator)),
          most_bits),
      delta_(f.denominator, Integer(f.denominator.get()->coeffs), most_bits),
      bits_{most_bits},
      y_(delta_.size()) {}

template <class Number>
void QuotientRecurrence<Number>::step(const FixedSeries<Number>& w) {
  const std::size_t n = y_.c.size();
  const std::size_t count = nu_.size() + delta_.size() - 1;
  const long most = std::max(w.most, y_.most);
  choose_bits<Number>(bits_, most + bits_for(count), nu_, delta_);
  ProductSum<Number> sum;
  for (std::size_t j = 0; j < nu_.size() && j <= n; ++j) sum.add(nu_[j], w.c[n - j]);
  for (std::size_t i = 1; i < delta_.size() && i <= n; ++i) sum.subtract(delta_[i], y_.c[n - i]);
  y_.count_errors(count, most, bits_.now);
  y_.push(sum.upper(bits_.now));
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
