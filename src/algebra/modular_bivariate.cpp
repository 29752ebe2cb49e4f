#include "phrame/algebra/modular_bivariate.hpp"

namespace phrame {
namespace {

/// f / lead(f), or no value where the leading coefficient is a zero divisor.
bool make_monic(ModularBivariate& f, const ModularPolynomial& q) {
  ModularPolynomial inverse(q.prime());
  if (nmod_poly_invmod(inverse.raw(), f.back().raw(), q.raw()) == 0) return false;
  for (auto& c : f) nmod_poly_mulmod(c.raw(), c.raw(), inverse.raw(), q.raw());
  return true;
}

/// a modulo the monic b, in place.
void reduce(ModularBivariate& a, const ModularBivariate& b, const ModularPolynomial& q) {
  ModularPolynomial product(q.prime());
  while (a.size() >= b.size()) {
    const std::size_t shift = a.size() - b.size();
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
      nmod_poly_mulmod(product.raw(), a.back().raw(), b[k].raw(), q.raw());
      a[shift + k] -= product;
    }
    a.pop_back();
    normalize(a);
  }
}

}  // namespace

void normalize(ModularBivariate& f) {
  while (!f.empty() && f.back().is_zero()) f.pop_back();
}

std::optional<ModularBivariate> monic_gcd(ModularBivariate a, ModularBivariate b,
                                          const ModularPolynomial& q) {
  while (!b.empty()) {
    if (!make_monic(b, q)) return std::nullopt;
    reduce(a, b, q);
    std::swap(a, b);
  }
  if (!make_monic(a, q)) return std::nullopt;
  return a;
}

}  // namespace phrame
