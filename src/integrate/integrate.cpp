#include "phrame/integrate/integrate.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/hermite.hpp"
#include "phrame/integrate/known_integral.hpp"
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

/// Are all residues, those at the conjugates of the poles too, seen to be distinct?
bool have_distinct_residues(const std::vector<NearPole>& poles) {
  for (auto p = poles.begin(); p != poles.end(); ++p) {
    if (p->residue.im().contains_zero()) return false;
    for (auto q = poles.begin(); q != p; ++q)
      if (p->residue.overlaps(q->residue) || p->residue.overlaps(conjugate(q->residue)))
        return false;
  }
  return true;
}

// A factor of an integer polynomial a·tⁿ + … has an integer leading coefficient b that divides a
// (Gauss), and −b times the sum of its roots is an integer, too; so is a times that sum. Over ℚ a
// root and its conjugate belong to the same factor. That one factor has no root of the last pair
// can be assumed.
bool has_irreducible_denominator(const std::vector<NearPole>& poles, const Polynomial& d) {
  constexpr std::size_t most_pairs = 10;
  constexpr long bits = 64;
  if (poles.size() > most_pairs || 2 * static_cast<long>(poles.size()) != d.degree()) return false;
  const RealBall twice(Rational(2) * primitive_part(d).leading_coefficient(), bits);
  std::vector<double> sums;  // of all sets of the pairs before this one, but none
  double size = 1;
  for (std::size_t k = 0; k + 1 < poles.size(); ++k) {
    const RealBall ball = multiply(twice, poles[k].place.re(), bits);
    if (!ball.is_accurate(bits - 16)) return false;
    const double pair = approximate(ball);
    size += std::abs(pair);
    const std::size_t count = sums.size();
    sums.push_back(pair);
    for (std::size_t j = 0; j < count; ++j) sums.push_back(sums[j] + pair);
  }
  // Each is off by the radii of ten balls and ten roundings at most.
  const double error = size * 0x1p-40;
  return std::all_of(sums.begin(), sums.end(),
                     [error](double x) { return std::abs(x - std::round(x)) > error; });
}

/// Those of one irreducible denominator with distinct residues, which is what most are.
bool is_simple(const RationalFunction& f, const std::vector<NearPole>* poles) {
  return poles != nullptr && have_distinct_residues(*poles) &&
         has_irreducible_denominator(*poles, f.denominator());
}

std::vector<LogSum> logarithms(const RationalFunction& f, Form form,
                               const std::vector<NearPole>* poles) {
  if (f.is_zero()) return {};
  if (form == Form::lazard_rioboo_trager) return lazard_rioboo_trager(f);
  if (form == Form::automatic && is_simple(f, poles))
    return {full_partial_fraction({f.numerator(), f.denominator()})};
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
  return integrate(f, algebraic_part(f), form, nullptr);
}

Antiderivative integrate(const RationalFunction& f, const AlgebraicPart& part, Form form,
                         const std::vector<NearPole>* poles) {
  Antiderivative F = part.F;
  F.logs = logarithms(part.rest, form, poles);
  if (!(differentiate(F) == f))
    throw Error("integrate: the check failed, the derivative of the result is not the integrand");
  return F;
}

}  // namespace phrame
