#include "phrame/algebra/integer_factors.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long factored_bits = 128;  ///< a second at worst

struct FlintFactors {
  fmpz_factor_t value;
  FlintFactors() { fmpz_factor_init(value); }
  ~FlintFactors() { fmpz_factor_clear(value); }
  FlintFactors(const FlintFactors&) = delete;
  FlintFactors& operator=(const FlintFactors&) = delete;
};

/// The prime factors of x < 2¹²⁸, by elliptic curves. (The quadratic sieve, which fmpz_factor
/// takes, writes files into the working directory.)
void append_factors(std::vector<PrimePower>& list, const Integer& x) {
  FlintFactors found;
  fmpz_factor_smooth(found.value, x.raw(), (bit_length(x) - 1) / 2 + 2, 0);
  for (slong k = 0; k < found.value->num; ++k)
    list.push_back({Integer(found.value->p + k), found.value->exp[k]});
}

}  // namespace

std::vector<PrimePower> factors(const Integer& x) {
  std::vector<PrimePower> list;
  Integer rest = x;
  for (unsigned p = 2; p <= largest_divisor && rest > 1; ++p) {
    unsigned long exponent = 0;
    for (; rest % p == 0; rest /= p) ++exponent;
    if (exponent > 0) list.push_back({p, exponent});
  }
  if (rest == 1) return list;
  const Integer root = sqrt(rest);
  const bool is_square = root * root == rest;
  const Integer& last = is_square ? root : rest;
  if (!is_square && bit_length(last) <= factored_bits)
    append_factors(list, last);
  else
    list.push_back({last, is_square ? 2UL : 1UL});
  return list;
}

bool is_prime(const Integer& x) { return x > 1 && fmpz_is_probabprime(x.raw()) != 0; }

}  // namespace phrame
