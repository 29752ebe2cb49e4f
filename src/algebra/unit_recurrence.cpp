#include "phrame/algebra/unit_recurrence.hpp"

#include <algorithm>
#include <cmath>

namespace phrame::inline v0 {
namespace {

long bits_for(std::size_t count) { return bit_length(Integer(static_cast<long>(count))); }

}  // namespace

FixedCoefficients::FixedCoefficients(const IntegerPolynomial& p, const Integer& divisor,
                                     long most_bits)
    : full_(static_cast<std::size_t>(fmpz_poly_length(p.get()))),
      now_(full_.size()),
      full_bits_(most_bits) {
  for (std::size_t k = 0; k < full_.size(); ++k) {
    fmpz* c = full_[k].raw();
    fmpz_mul_2exp(c, p.get()->coeffs + k, static_cast<ulong>(full_bits_));
    fmpz_fdiv_q(c, c, divisor.raw());
  }
}

void FixedCoefficients::round_to(long bits) {
  for (std::size_t k = 0; k < full_.size(); ++k)
    fmpz_fdiv_q_2exp(now_[k].raw(), full_[k].raw(), static_cast<ulong>(full_bits_ - bits));
}

bool BitsInUse::choose(long needed) {
  if (now != 0 && needed <= now && (needed > now - 48 || now <= 32)) return false;
  const long before = now;
  now = std::min(full, std::max(needed, 16L) + 16);
  return now != before;
}

void FixedSeries::push(Integer x) {
  c.push_back(std::move(x));
  most = std::max(most, bit_length(c.back()));
  if (c.size() % 8 != 0) return;
  most = 0;
  for (std::size_t k = c.size() - std::min(window, c.size()); k < c.size(); ++k)
    most = std::max(most, bit_length(c[k]));
}

void FixedSeries::count_errors(std::size_t count, long bits_of_numbers, long bits) {
  const long e = std::clamp(bits_of_numbers - bits, -1000L, 1000L);
  left_over += 1 + std::ldexp(static_cast<double>(count), static_cast<int>(e));
}

RootRecurrence::RootRecurrence(const UnitQuotient& f, long Q, long most_bits)
    : sigma_(f.radicand, Integer(f.radicand.get()->coeffs), most_bits),
      bits_{most_bits},
      weighted_(sigma_.size()),
      twice_(sigma_.size()),
      w_(std::max(sigma_.size(), static_cast<std::size_t>(fmpz_poly_length(f.numerator.get())))) {
  w_.push(Integer(1) << static_cast<unsigned long>(Q));
}

void RootRecurrence::step() {
  const std::size_t n = w_.c.size();
  const std::size_t degree = sigma_.size() - 1;
  weigh(n);
  fmpz* sum = sum_.raw();
  fmpz_zero(sum);
  for (std::size_t i = 1; i <= std::min(n, degree); ++i)
    fmpz_addmul(sum, weighted_[i].raw(), w_.c[n - i].raw());
  fmpz_fdiv_q_2exp(sum, sum, static_cast<ulong>(bits_.now + 1));
  fmpz_fdiv_q_ui(sum, sum, n);
  w_.count_errors(degree, w_.most, bits_.now);
  w_.push(-sum_);
}

/// (2n − i)·σᵢ from the ones for n − 1.
void RootRecurrence::weigh(std::size_t n) {
  const std::size_t degree = sigma_.size() - 1;
  const bool is_new = bits_.choose(w_.most + bits_for(degree));
  if (is_new) sigma_.round_to(bits_.now);
  for (std::size_t i = 1; i <= degree; ++i) {
    if (is_new) {
      fmpz_mul_2exp(twice_[i].raw(), sigma_[i].raw(), 1);
      fmpz_mul_si(weighted_[i].raw(), sigma_[i].raw(),
                  static_cast<slong>(2 * n) - static_cast<slong>(i));
    } else {
      fmpz_add(weighted_[i].raw(), weighted_[i].raw(), twice_[i].raw());
    }
  }
}

QuotientRecurrence::QuotientRecurrence(const UnitQuotient& f, long most_bits)
    : nu_(f.numerator, Integer(1) << static_cast<unsigned long>(unit_exponent(f.numerator)),
          most_bits),
      delta_(f.denominator, Integer(f.denominator.get()->coeffs), most_bits),
      bits_{most_bits},
      y_(delta_.size()) {}

void QuotientRecurrence::step(const FixedSeries& w) {
  const std::size_t n = y_.c.size();
  const std::size_t count = nu_.size() + delta_.size() - 1;
  const long most = std::max(w.most, y_.most);
  if (bits_.choose(most + bits_for(count))) {
    nu_.round_to(bits_.now);
    delta_.round_to(bits_.now);
  }
  fmpz* sum = sum_.raw();
  fmpz_zero(sum);
  for (std::size_t j = 0; j < nu_.size() && j <= n; ++j)
    fmpz_addmul(sum, nu_[j].raw(), w.c[n - j].raw());
  for (std::size_t i = 1; i < delta_.size() && i <= n; ++i)
    fmpz_submul(sum, delta_[i].raw(), y_.c[n - i].raw());
  fmpz_fdiv_q_2exp(sum, sum, static_cast<ulong>(bits_.now));
  y_.count_errors(count, most, bits_.now);
  y_.push(sum_);
}

}  // namespace phrame
