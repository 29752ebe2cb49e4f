#include "phrame/answer/identification.hpp"

namespace phrame::inline v0 {

IdentificationAnswer answer(const NamedHodograph& query, const std::optional<Rational>& epsilon) {
  IdentificationAnswer result{query.name, identify(query.hodograph, query.start)};
  if (std::holds_alternative<Curve>(result.result)) return result;
  if (epsilon)
    result.near.emplace(
        IdentificationAnswer::Near{*epsilon, near_curve(query.hodograph, query.start, *epsilon)});
  else
    result.suggestion = near_suggestion(query.hodograph, query.start);
  return result;
}

IdentificationAnswer answer(const NamedRationalCurve& query) {
  IdentificationAnswer result{query.name, identify(query.curve)};
  result.is_rational = true;
  return result;
}

}  // namespace phrame
