#include "phrame/integrate/rothstein_trager.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"

namespace phrame::inline v0 {

namespace {

/// One fraction for each denominator.
std::vector<SimpleFraction> with_different_poles(const std::vector<SimpleFraction>& fractions) {
  std::vector<SimpleFraction> different;
  for (const auto& [n, d] : fractions) {
    const auto at = std::find_if(different.begin(), different.end(),
                                 [&d = d](const auto& f) { return f.denominator == d; });
    if (at == different.end())
      different.push_back({n, d});
    else
      at->numerator += n;
  }
  std::erase_if(different, [](const auto& f) { return f.numerator.is_zero(); });
  return different;
}

}  // namespace

// The poles of an irreducible denominator are conjugate, so that every residue occurs equally often
// and their polynomial is a power of an irreducible one. Residue polynomials of different
// denominators are multiplied.
std::vector<EqualResidues> by_residues(const std::vector<SimpleFraction>& fractions) {
  std::vector<EqualResidues> groups;
  std::vector<Polynomial> irreducible;
  for (const auto& [n, d] : with_different_poles(fractions)) {
    Polynomial residues = residue_polynomial(n, d);
    const Polynomial q = squarefree_part(residues);
    const auto at = std::find(irreducible.begin(), irreducible.end(), q);
    if (at == irreducible.end()) {
      irreducible.push_back(q);
      groups.push_back({RationalFunction(n, d), std::move(residues), true});
      continue;
    }
    EqualResidues& group = groups[static_cast<std::size_t>(at - irreducible.begin())];
    group.sum = group.sum + RationalFunction(n, d);
    group.residues *= residues;
    group.is_one = false;
  }
  return groups;
}

std::vector<LogSum> rothstein_trager(const std::vector<SimpleFraction>& fractions) {
  std::vector<LogSum> sums;
  for (const EqualResidues& group : by_residues(fractions))
    sums.push_back(lazard_rioboo_trager(group.sum, group.residues).front());
  return sums;
}

std::vector<LogSum> over_residues(const std::vector<SimpleFraction>& fractions) {
  std::vector<LogSum> sums;
  for (const EqualResidues& group : by_residues(fractions)) {
    sums.push_back(lazard_rioboo_trager(group.sum, group.residues).front());
    if (!(differentiate(sums.back()) == group.sum))
      throw Error("over_residues: the check failed, the derivative is not the fraction");
  }
  return sums;
}

std::vector<LogSum> merge_equal_residues(std::vector<LogSum> sums) {
  std::vector<LogSum> merged;
  for (LogSum& sum : sums) {
    const auto same = [&](const LogSum& other) {
      return other.index == sum.index && other.residue == sum.residue;
    };
    const auto at = std::find_if(merged.begin(), merged.end(), same);
    if (at == merged.end()) {
      merged.push_back(std::move(sum));
      continue;
    }
    const QuotientRing ring(sum.index);
    std::vector<Polynomial> product(
        static_cast<std::size_t>(at->argument.degree() + sum.argument.degree() + 1));
    for (long i = 0; i <= at->argument.degree(); ++i)
      for (long j = 0; j <= sum.argument.degree(); ++j)
        product[static_cast<std::size_t>(i + j)] +=
            ring.multiply(at->argument.coefficient(i), sum.argument.coefficient(j));
    at->argument = Bivariate(std::move(product));
  }
  return merged;
}

/// The residue polynomial is a power of the irreducible polynomial of one residue.
bool has_residues_of_degree_at_most(const SimpleFraction& f, long most) {
  const auto& [n, d] = f;
  if (d.degree() <= most) return true;
  if (distinct_residues_modulo_a_prime(n, d) > most) return false;
  return squarefree_part(residue_polynomial(n, d)).degree() <= most;
}

}  // namespace phrame
