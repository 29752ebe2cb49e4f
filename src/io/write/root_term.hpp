#pragma once
#include "phrame/integrate/real_form.hpp"
#include "phrame/io/write/radical_text.hpp"

namespace phrame::inline v0 {

/// factor·function(argument) with roots of numbers of a quadratic or biquadratic field, written
/// out.
struct RootTerm {
  Radical factor;
  std::string argument;
};

/// "√2·x + 1", "(4x + 1 − √5)/√(10 + 2√5)": factor·arctan(argument).
RootTerm written(const RealForm::Arctangent& term, std::string_view variable,
                 const RadicalNotation& notation);
/// "(x − √2)/(x + √2)": factor·log|argument|.
RootTerm written(const RealForm::LogQuotient& term, std::string_view variable,
                 const RadicalNotation& notation);

}  // namespace phrame
