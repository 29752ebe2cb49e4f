#include "phrame/integrate/integrate.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/hermite.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame {
namespace {

/// Full partial fractions have the smallest field extension exactly where a sum's residues are
/// pairwise distinct; a fraction whose residues repeat, among themselves or those of another
/// fraction, is written over its residues.
std::vector<LogSum> smallest_extension(const RationalFunction& f,
                                       const std::vector<SimpleFraction>& parts) {
  std::vector<LogSum> over_poles;
  if (residues_are_distinct(f.numerator(), f.denominator())) {
    for (const auto& part : parts) over_poles.push_back(full_partial_fraction(part));
    return over_poles;
  }
  std::vector<Polynomial> residues;  // each a power of an irreducible polynomial
  for (const auto& part : parts)
    residues.push_back(residue_polynomial(part.numerator, part.denominator));
  std::vector<LogSum> repeated;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto& [n, d] = parts[k];
    bool distinct = is_squarefree(residues[k]);
    for (std::size_t j = 0; j < parts.size(); ++j)
      distinct = distinct && (j == k || gcd(residues[j], residues[k]).is_constant());
    if (distinct)
      over_poles.push_back(full_partial_fraction(parts[k]));
    else
      repeated.push_back(lazard_rioboo_trager({n, d}, residues[k]).front());
  }
  std::vector<LogSum> all = merge_equal_residues(std::move(repeated));
  all.insert(all.end(), over_poles.begin(), over_poles.end());
  return all;
}

std::vector<LogSum> logarithms(const RationalFunction& f, Form form) {
  if (f.is_zero()) return {};
  if (form == Form::lazard_rioboo_trager) return lazard_rioboo_trager(f);
  const auto parts = simple_fractions(f);
  if (form == Form::automatic) return smallest_extension(f, parts);
  std::vector<LogSum> sums;
  for (const auto& part : parts)
    sums.push_back(form == Form::partial_fractions ? full_partial_fraction(part)
                                                   : rothstein_trager(part));
  return form == Form::partial_fractions ? sums : merge_equal_residues(std::move(sums));
}

}  // namespace

Antiderivative integrate(const RationalFunction& f, Form form) {
  const Division whole = divide(f.numerator(), f.denominator());
  const RationalPart part = hermite_reduce({whole.remainder, f.denominator()});
  Antiderivative F{antiderivative(whole.quotient), part.rational, logarithms(part.rest, form)};
  if (!(differentiate(F) == f))
    throw Error("integrate: the check failed, the derivative of the result is not the integrand");
  return F;
}

}  // namespace phrame
