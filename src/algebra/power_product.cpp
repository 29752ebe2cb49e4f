#include "phrame/algebra/power_product.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

constexpr unsigned long largest_result_bits = 1UL << 24U;

GaussianRational inverse(const GaussianRational& a) {
  const Rational norm = a.re * a.re + a.im * a.im;
  if (norm == 0) throw DomainError("product of powers: a base is 0");
  return {a.re / norm, -a.im / norm};
}

GaussianRational power(GaussianRational base, unsigned long exponent) {
  GaussianRational result{1, 0};
  for (; exponent != 0; exponent >>= 1U) {
    if ((exponent & 1U) != 0) result = result * base;
    if (exponent != 1) base = base * base;
  }
  return result;
}

unsigned long bits(const GaussianRational& a) {
  unsigned long most = 1;
  for (const Rational& part : {a.re, a.im})
    for (const Integer& x : {Integer(numerator(part)), Integer(denominator(part))})
      if (x != 0) most = std::max<unsigned long>(most, msb(abs(x)) + 1);
  return most;
}

}  // namespace

Integer common_denominator(const std::vector<Power>& powers) {
  Integer n = 1;
  for (const Power& p : powers) n = lcm(n, Integer(denominator(p.exponent)));
  return n;
}

std::optional<GaussianRational> product(const std::vector<Power>& powers, const Integer& n) {
  GaussianRational result{1, 0};
  Integer total_bits = 0;
  for (const Power& p : powers) {
    const Integer exponent(numerator(Rational(n) * p.exponent));
    total_bits += abs(exponent) * bits(p.base);
    if (total_bits > largest_result_bits) return std::nullopt;
    result = result * power(exponent < 0 ? inverse(p.base) : p.base,
                            abs(exponent).convert_to<unsigned long>());
  }
  return result;
}

}  // namespace phrame
