#include "phrame/ph/construct/refine.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {
namespace {

Rational largest_of(const std::vector<Rational>& list) {
  Rational size;
  for (const Rational& x : list) size = std::max(size, abs(x));
  return size;
}

void round_all(std::vector<Rational>& parameters, long bits) {
  for (Rational& x : parameters) x = rounded_to_places(x, bits);
}

/// parameters − J⁺F; no change where that is no number.
std::vector<Rational> improved(std::vector<Rational> parameters,
                               const std::vector<Rational>& defect, const ParameterStep& step,
                               long exponent) {
  const Rational scale = power_of_two(-exponent);
  std::vector<double> in_doubles;
  for (const Rational& x : defect) in_doubles.push_back(static_cast<double>(scale * x));
  const std::vector<double> change = step(in_doubles);
  if (!std::ranges::all_of(change, [](double x) { return std::isfinite(x); })) return parameters;
  const Rational back = power_of_two(exponent);
  for (std::size_t k = 0; k < parameters.size(); ++k)
    parameters[k] -= back * exact_rational(change[k]);
  return parameters;
}

}  // namespace

ParameterStep least_change(const JacobianRows& jacobian, double nothing) {
  return [inverse = LeastSquares(jacobian, nothing)](const std::vector<double>& wanted) {
    return inverse(wanted);
  };
}

RefinedParameters refine(std::vector<Rational> parameters, const ExactDefect& defect,
                         const ParameterStep& step, long bits) {
  constexpr int most_passes = 400;
  round_all(parameters, bits);
  std::vector<Rational> lacking = defect(parameters);
  RefinedParameters best{std::move(parameters), std::move(lacking)};
  Rational size = largest_of(best.defect);
  for (int pass = 0; pass < most_passes && size != 0; ++pass) {
    std::vector<Rational> next =
        improved(best.parameters, best.defect, step, binary_exponent(size));
    round_all(next, bits);
    std::vector<Rational> next_defect = defect(next);
    const Rational next_size = largest_of(next_defect);
    const bool is_done = 2 * next_size > size;
    if (next_size < size) {
      best = {std::move(next), std::move(next_defect)};
      size = next_size;
    }
    if (is_done) break;
  }
  return best;
}

}  // namespace phrame
