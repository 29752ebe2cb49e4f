// A stand-in: rational ends, no pole between them.
#include "phrame/integrate/definite_integral.hpp"

#include <memory>

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/definite.hpp"
#include "phrame/integrate/integrate.hpp"

namespace phrame {

DefiniteIntegral definite_integral(const Antiderivative& F, const Endpoint& a, const Endpoint& b,
                                   AtPoles at_poles) {
  const auto* from = std::get_if<Rational>(&a);
  const auto* to = std::get_if<Rational>(&b);
  if (from == nullptr || to == nullptr || at_poles != AtPoles::refuse)
    throw Undecided("definite_integral: only rational ends without a pole between them");
  const auto evaluator = std::make_shared<Evaluator>(F);
  const Real value = evaluator->value(*from, *to);
  if (value.exact()) return {value, ExactValue{*value.exact(), 0, {}, {}}};
  return {Real([evaluator, value](long bits) { return value.enclose(bits); }), std::nullopt};
}

DefiniteIntegral definite_integral(const RationalFunction& f, const Endpoint& a, const Endpoint& b,
                                   AtPoles at_poles) {
  return definite_integral(integrate(f), a, b, at_poles);
}

}  // namespace phrame
