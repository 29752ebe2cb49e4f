#include "phrame/integrate/integrate.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/hermite.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame::inline v0 {
namespace {

/// Full partial fractions have the smallest field extension exactly where a sum's residues are
/// pairwise distinct; a fraction whose residues repeat, among themselves or those of another
/// fraction, is written over its residues.
std::vector<LogSum> smallest_extension(const RationalFunction& f,
                                       const std::vector<SimpleFraction>& parts) {
  std::vector<LogSum> over_poles;
  if (residues_are_distinct_modulo_a_prime(f.numerator(), f.denominator())) {
    for (const auto& part : parts) over_poles.push_back(full_partial_fraction(part));
    return over_poles;
  }
  std::vector<LogSum> sums;
  for (const EqualResidues& group : by_residues(parts)) {
    if (group.is_one && is_squarefree(group.residues))
      over_poles.push_back(full_partial_fraction({group.sum.numerator(), group.sum.denominator()}));
    else
      sums.push_back(lazard_rioboo_trager(group.sum, group.residues).front());
  }
  sums.insert(sums.end(), over_poles.begin(), over_poles.end());
  return sums;
}

std::vector<LogSum> logarithms(const RationalFunction& f, Form form) {
  if (f.is_zero()) return {};
  if (form == Form::lazard_rioboo_trager) return lazard_rioboo_trager(f);
  const auto parts = simple_fractions(f);
  if (form == Form::automatic) return smallest_extension(f, parts);
  if (form == Form::rothstein_trager) return rothstein_trager(parts);
  std::vector<LogSum> sums;
  for (const auto& part : parts) sums.push_back(full_partial_fraction(part));
  return sums;
}

}  // namespace

AlgebraicPart algebraic_part(const RationalFunction& f) {
  const Division whole = divide(f.numerator(), f.denominator());
  RationalPart part = hermite_reduce({whole.remainder, f.denominator()});
  return {{antiderivative(whole.quotient), std::move(part.rational), {}}, std::move(part.rest)};
}

Antiderivative integrate(const RationalFunction& f, Form form) {
  auto [F, rest] = algebraic_part(f);
  F.logs = logarithms(rest, form);
  if (!(differentiate(F) == f))
    throw Error("integrate: the check failed, the derivative of the result is not the integrand");
  return F;
}

}  // namespace phrame
