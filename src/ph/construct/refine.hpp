#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "phrame/algebra/least_squares.hpp"
#include "phrame/algebra/rational.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {

// An exact family has rational parameters, and whatever they are, its law holds as an identity:
// h = 0, a helix, C². What is left are conditions on the parameters, such as the end point.

/// What each condition lacks with these parameters; 0 where it is met.
using ExactDefect = std::function<std::vector<Rational>(const std::vector<Rational>& parameters)>;
/// The change of the parameters that adds, to first order, so much to what the conditions lack, in
/// doubles.
using ParameterStep = std::function<std::vector<double>(const std::vector<double>& defect)>;
/// ∂(condition)/∂(parameter): a row for each condition, with an entry for each parameter.
using JacobianRows = DoubleRows;

/// The least change that does it, by the pseudo-inverse of this derivative: there may be more
/// parameters than conditions. What is less than `nothing` beside the greatest is taken for 0.
ParameterStep least_change(const JacobianRows& jacobian, double nothing);

/// Parameters that are multiples of 2^−bits, and what they lack.
struct RefinedParameters {
  std::vector<Rational> parameters;
  std::vector<Rational> defect;
};

/// Newton's iteration θ ↦ θ − J⁺F(θ) to the nearest parameters that meet the conditions, until the
/// rounding to multiples of 2^−bits keeps the greatest |F| from becoming half of what it was. F is
/// computed exactly and brought to about 1 by a power of 2 before it becomes doubles, so a J known
/// to few digits is enough: the digits of F come one after the other. Parameters are wanted near a
/// solution, and of about the same size. What `defect` throws goes through.
RefinedParameters refine(std::vector<Rational> parameters, const ExactDefect& defect,
                         const ParameterStep& step, long bits);

/// The parameters of a segment as multiples of 2^−bits, with more bits each time until accept(x,
/// bits) has a value: they are refined to some bits more than that and then rounded, so that the
/// way there does not decide the last ones. `defect_for(bits)` is what is lacking.
template <class DefectFor, class Accept>
auto rounded_solution(std::vector<Rational> parameters, const DefectFor& defect_for,
                      const ParameterStep& step, long bits, long more_bits, const Accept& accept)
    -> decltype(accept(parameters, bits)) {
  constexpr int most_passes = 12;
  constexpr long spare_bits = 24;
  for (int pass = 0; pass < most_passes; ++pass, bits += more_bits) {
    parameters =
        refine(std::move(parameters), defect_for(bits), step, bits + spare_bits).parameters;
    std::vector<Rational> rounded;
    for (const Rational& x : parameters) rounded.push_back(rounded_to_places(x, bits));
    if (auto found = accept(rounded, bits)) return found;
  }
  return std::nullopt;
}

}  // namespace phrame
