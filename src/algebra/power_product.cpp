// N·Σ exponent·arg base is the argument of a product z of Gaussian rationals, and that is a
// rational multiple of π iff z lies on one of eight rays (Niven, Irrational Numbers, 1956, §3.3),
// iff z/z̄ is a unit. Written over coprime elements b, z/z̄ is one iff every b has the exponent 0 in
// it.
#include "phrame/algebra/power_product.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

bool is_unit(const GaussianInteger& a) { return norm(a) == 1; }

/// Splits the elements until each given number is a unit times a product of them.
std::vector<GaussianInteger> coprime_base(std::vector<GaussianInteger> numbers) {
  std::vector<GaussianInteger> base;
  while (!numbers.empty()) {
    const GaussianInteger x = first_quadrant(numbers.back());
    numbers.pop_back();
    if (is_unit(x)) continue;
    bool is_new = true;
    for (std::size_t k = 0; k < base.size() && is_new; ++k) {
      const GaussianInteger common = gcd(x, base[k]);
      if (is_unit(common)) continue;
      is_new = false;
      if (x == base[k]) break;
      numbers.push_back(*exact_quotient(x, common));
      numbers.push_back(*exact_quotient(base[k], common));
      numbers.push_back(common);
      base.erase(base.begin() + static_cast<long>(k));
    }
    if (is_new) base.push_back(x);
  }
  return base;
}

/// The exponent of b in x ≠ 0.
long multiplicity(const GaussianInteger& b, GaussianInteger x) {
  long count = 0;
  while (const auto quotient = exact_quotient(x, b)) {
    x = *quotient;
    ++count;
  }
  return count;
}

struct IntegerPower {
  GaussianInteger base;
  Rational exponent;
};

/// Is ∏ base^exponent a unit, that is, trivial up to a root of unity?
bool is_trivial(const std::vector<IntegerPower>& powers) {
  std::vector<GaussianInteger> numbers;
  for (const IntegerPower& p : powers) numbers.push_back(p.base);
  for (const GaussianInteger& b : coprime_base(numbers)) {
    Rational exponent = 0;
    for (const IntegerPower& p : powers) exponent += p.exponent * multiplicity(b, p.base);
    if (exponent != 0) return false;
  }
  return true;
}

void require_nonzero(const GaussianRational& base) {
  if (base.re == 0 && base.im == 0) throw DomainError("product of powers: a base is 0");
}

}  // namespace

Integer common_denominator(const std::vector<Power>& powers) {
  Integer n = 1;
  for (const Power& p : powers) n = lcm(n, Integer(denominator(p.exponent)));
  return n;
}

bool sizes_cancel(const std::vector<Power>& powers) {
  std::vector<IntegerPower> parts;
  for (const auto& [base, exponent] : powers) {
    require_nonzero(base);
    parts.push_back({{Integer(numerator(base.re)), 0}, exponent});
    parts.push_back({{Integer(denominator(base.re)), 0}, -exponent});
  }
  return is_trivial(parts);
}

bool turns_are_rational(const std::vector<Power>& powers) {
  std::vector<IntegerPower> parts;
  for (const auto& [base, exponent] : powers) {
    require_nonzero(base);
    if (exponent == 0) continue;
    const GaussianInteger z = primitive_multiple(base);
    if (norm(z) <= 2) continue;  // on a ray
    parts.push_back({z, exponent});
    parts.push_back({conjugate(z), -exponent});
  }
  return is_trivial(parts);
}

}  // namespace phrame
