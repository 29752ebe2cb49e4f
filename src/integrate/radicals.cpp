#include "phrame/integrate/radicals.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/radical_roots.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long largest_solved_degree = 4;

/// The sums, with those over residues first, where equal residues become one logarithm.
std::vector<LogSum> solvable_sums(const RationalFunction& f) {
  std::vector<SimpleFraction> unsolved;
  std::vector<LogSum> over_poles;
  for (const SimpleFraction& part : simple_fractions(f)) {
    const long degree = part.denominator.degree();
    const LogSum poles = full_partial_fraction(part);
    if (degree == 1 || (degree <= largest_solved_degree && !poles.residue.is_constant())) {
      over_poles.push_back(poles);
      continue;
    }
    if (!has_residues_of_degree_at_most(part, largest_solved_degree))
      throw DomainError("radicals: the poles and the residues at the roots of " +
                        abbreviated(to_string(part.denominator), 200) + " have a degree > 4");
    unsolved.push_back(part);
  }
  std::vector<LogSum> all = rothstein_trager(unsolved);
  all.insert(all.end(), over_poles.begin(), over_poles.end());
  return all;
}

RadicalSum in_radicals(const LogSum& sum) {
  RadicalSum result{sum,
                    roots_by_radicals(sum.index),
                    {},
                    static_cast<std::size_t>(count_real_roots(sum.index, real_line()))};
  for (const Radical& x : result.roots) result.residues.push_back(evaluate(sum.residue, x));
  return result;
}

}  // namespace

Antiderivative antiderivative(const RadicalForm& F) {
  Antiderivative G{F.polynomial, F.rational, {}};
  for (const RadicalSum& sum : F.logs) G.logs.push_back(sum.sum);
  return G;
}

RadicalForm radical_form(const Antiderivative& F) {
  RadicalForm result{F.polynomial, F.rational, {}};
  const RationalFunction of_logs = differentiate(Antiderivative{{}, {}, F.logs});
  for (const LogSum& sum : solvable_sums(of_logs)) result.logs.push_back(in_radicals(sum));
  if (!(differentiate(antiderivative(result)) == differentiate(F)))
    throw Error("radical_form: the check failed, the derivative is not that of the antiderivative");
  return result;
}

}  // namespace phrame
