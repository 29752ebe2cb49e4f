// Let d = a·hᵐ + b·hᵐ⁻¹ + …, h = tᵏ + …, h(0) = 0. The k highest coefficients of d are those of
// a·hᵐ, so that with z = 1/t the reversed h is (rev(d)/a)^{1/m} modulo zᵏ: with f = rev(d)/a = 1 +
// … and g = f^{1/m}, m·g′·f = g·f′ gives the coefficients
//   m·j·g_j = Σ_{0<i≤j} (i − m·(j − i))·f_i·g_{j−i}.
// Whether d, and n/h′, are polynomials of h their expansions in powers of h tell, whose
// coefficients are constants then, and only then.
#include "phrame/algebra/decomposition.hpp"

#include "phrame/algebra/resultant.hpp"

namespace phrame::inline v0 {
namespace {

/// The only h that d may be a polynomial of.
Polynomial inner_candidate(const Polynomial& d, long k) {
  const long m = d.degree() / k;
  const auto f = [&](long i) -> Rational {
    return d.coefficient(d.degree() - i) / d.leading_coefficient();
  };
  std::vector<Rational> g = {1};
  for (long j = 1; j < k; ++j) {
    Rational sum = 0;
    for (long i = 1; i <= j; ++i)
      sum += Rational(i - m * (j - i)) * f(i) * g[static_cast<std::size_t>(j - i)];
    g.push_back(sum / (m * j));
  }
  std::vector<Rational> h = {0};
  h.insert(h.end(), g.rbegin(), g.rend());
  return Polynomial(h);
}

/// p₁ with p = p₁∘h, where there is one. Precondition: deg h ≥ 1.
std::optional<Polynomial> outer_of(Polynomial p, const Polynomial& h) {
  std::vector<Rational> digits;
  while (!p.is_zero()) {
    Division division = divide(p, h);
    if (!division.remainder.is_constant()) return std::nullopt;
    digits.push_back(division.remainder.coefficient(0));
    p = std::move(division.quotient);
  }
  return Polynomial(digits);
}

}  // namespace

std::optional<Decomposition> decomposition(const Polynomial& n, const Polynomial& d, long k) {
  const Polynomial h = inner_candidate(d, k);
  const auto outer_d = outer_of(d, h);
  if (!outer_d) return std::nullopt;
  const Division by_slope = divide(n, differentiate(h));
  if (!by_slope.remainder.is_zero()) return std::nullopt;
  const auto outer_n = outer_of(by_slope.quotient, h);
  if (!outer_n) return std::nullopt;
  return Decomposition{*outer_n, *outer_d, h};
}

std::optional<Decomposition> widest_decomposition(const Polynomial& n, const Polynomial& d,
                                                  long most) {
  for (long k = most; k > 1; --k)
    if (d.degree() % k == 0)
      if (auto found = decomposition(n, d, k)) return found;
  return std::nullopt;
}

// From a to b h(t) goes from h(a) back to it, along which outer_n/outer_d has an antiderivative G:
// a pole h(t) on the way would be one at t, also where h′(t) = 0, if d is squarefree. So the
// integral is G(h(b)) − G(h(a)) = 0.
bool closes(const Polynomial& n, const Polynomial& d, const Rational& a, const Rational& b) {
  const long distinct = distinct_residues_modulo_a_prime(n, d);
  const long most = distinct == 0 ? 0 : d.degree() / distinct;  // each is met deg h times
  for (long k = 2; k <= most; ++k) {
    if (d.degree() % k != 0) continue;
    const Polynomial h = inner_candidate(d, k);
    if (h(a) == h(b) && decomposition(n, d, k)) return true;
  }
  return false;
}

}  // namespace phrame
