#include "phrame/integrate/integrate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/near_arithmetic.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/hermite.hpp"
#include "phrame/integrate/known_integral.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame::inline v0 {
namespace {

std::vector<LogSum> full_partial_fractions(const std::vector<SimpleFraction>& parts) {
  std::vector<LogSum> sums;
  for (const SimpleFraction& part : parts) sums.push_back(full_partial_fraction(part));
  return sums;
}

/// Full partial fractions have the smallest field extension exactly where a sum's residues are
/// pairwise distinct; a fraction whose residues repeat, among themselves or those of another
/// fraction, is written over its residues.
std::vector<LogSum> smallest_extension(const RationalFunction& f,
                                       const std::vector<SimpleFraction>& parts) {
  std::vector<LogSum> over_poles;
  if (residues_are_distinct_modulo_a_prime(f.numerator(), f.denominator()))
    return full_partial_fractions(parts);
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

/// Of all sets of these, the empty one first; each up to an integer, in [0, 1).
std::vector<double> sums_modulo_one(std::span<const double> of) {
  std::vector<double> sums{0};
  for (const double x : of) {
    const std::size_t count = sums.size();
    for (std::size_t k = 0; k < count; ++k) {
      const double sum = sums[k] + x;
      sums.push_back(sum - std::floor(sum));
    }
  }
  return sums;
}

/// Is the sum of some of the numbers, at least one, within `error` of an integer? Cost: twice the
/// root of the number of all sums, to sort them and to look them up.
bool has_sum_near_integer(std::span<const double> numbers, double error) {
  const std::size_t half = numbers.size() / 2;
  const std::vector<double> first = sums_modulo_one(numbers.first(half));
  std::vector<double> second = sums_modulo_one(numbers.subspan(half));
  const auto is_near_integer = [error](double x) { return std::abs(x - std::round(x)) <= error; };
  if (std::any_of(second.begin() + 1, second.end(), is_near_integer)) return true;
  std::sort(second.begin(), second.end());
  return std::any_of(first.begin() + 1, first.end(), [&](double x) {
    // Next to 1 − x, also where that goes around from 1 to 0.
    const auto above = std::lower_bound(second.begin(), second.end(), 1 - x);
    const double next = above == second.end() ? second.front() : *above;
    const double before = above == second.begin() ? second.back() : *std::prev(above);
    return is_near_integer(x + next) || is_near_integer(x + before);
  });
}

// A factor of an integer polynomial a·tⁿ + … has an integer leading coefficient b that divides a
// (Gauss), and −b times the sum of its roots is an integer, too; so is a times that sum. Over ℚ a
// root and its conjugate belong to the same factor. That one factor has no root of the last pair
// can be assumed.
bool has_irreducible_denominator(const std::vector<NearPole>& poles, const Polynomial& d) {
  constexpr std::size_t most_pairs = 22;
  if (poles.size() > most_pairs || 2 * static_cast<long>(poles.size()) != d.degree()) return false;
  const NearNumber twice = near_number(Rational(2) * primitive_part(d).leading_coefficient());
  std::vector<double> pairs;  // but the last
  double size = 1;
  for (std::size_t k = 0; k + 1 < poles.size(); ++k) {
    const NearComplex& z = poles[k].place;
    const NearNumber sum = twice * NearNumber{z.re, z.error};
    if (!(raised(sum.error) <= 0x1p-48 * std::abs(sum.value.high))) return false;
    pairs.push_back(sum.value.high);
    size += std::max(1.0, std::abs(pairs.back()));
  }
  // The errors together are at most 2^−48 of size; a sum is rounded once for each, by
  // 2^−53 of size + 1 at most. All that is less than 2^−46 of size.
  return !has_sum_near_integer(pairs, size * 0x1p-44);
}

/// Those of one irreducible denominator with distinct residues, which is what most are.
bool is_simple(const RationalFunction& f, const std::vector<NearPole>* poles) {
  return poles != nullptr && have_distinct_residues(*poles) &&
         rounding_to_nearest([&] { return has_irreducible_denominator(*poles, f.denominator()); });
}

/// Is each sum over the poles of one of the fractions, in their order?
bool are_over_poles(const std::vector<LogSum>& sums, const std::vector<SimpleFraction>& parts) {
  return std::ranges::equal(sums, parts, [](const LogSum& sum, const SimpleFraction& part) {
    return is_over_poles(sum) && sum.index == part.denominator;
  });
}

/// Of the integral of f, which is what Hermite's reduction leaves beside that rational part. The
/// fractions become `over`, where the logarithms are those over the poles of them.
std::vector<LogSum> logarithms(const RationalFunction& f, const RationalFunction& rational,
                               Form form, const std::vector<NearPole>* poles,
                               std::vector<SimpleFraction>& over) {
  if (f.is_zero()) return {};
  if (form == Form::lazard_rioboo_trager) return lazard_rioboo_trager(f);
  if (form == Form::automatic && is_simple(f, poles))
    return {full_partial_fraction({f.numerator(), f.denominator()})};
  // The poles that were multiple ones, as of σ beside those of ρ, divide the denominator.
  auto parts = simple_fractions(f, gcd(f.denominator(), rational.denominator()));
  if (form == Form::automatic) {
    std::vector<LogSum> sums = smallest_extension(f, parts);
    if (are_over_poles(sums, parts)) over = std::move(parts);
    return sums;
  }
  if (form == Form::rothstein_trager) return rothstein_trager(parts);
  return full_partial_fractions(parts);
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

namespace {

FactoredIntegral integral(const RationalFunction& f, const AlgebraicPart& part, Form form,
                          const std::vector<NearPole>* poles) {
  FactoredIntegral result{part.F, {}};
  Antiderivative& F = result.F;
  F.logs = logarithms(part.rest, F.rational, form, poles, result.parts);
  if (!(differentiate(F) == f))
    throw Error("integrate: the check failed, the derivative of the result is not the integrand");
  return result;
}

}  // namespace

Antiderivative integrate(const RationalFunction& f, const AlgebraicPart& part, Form form,
                         const std::vector<NearPole>* poles) {
  return integral(f, part, form, poles).F;
}

FactoredIntegral factored_integral(const RationalFunction& f) {
  return integral(f, algebraic_part(f), Form::automatic, nullptr);
}

}  // namespace phrame
