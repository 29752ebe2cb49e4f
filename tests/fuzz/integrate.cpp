// Any rational function with small coefficients: integrate() and real_form() check themselves and
// throw where the derivative of the result is not the integrand. A definite integral is compared
// with its value in finite terms, where it has one.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/real_form.hpp"

namespace {

using namespace phrame;

RealBall value(const ExactValue& exact, long bits) {
  RealBall sum =
      add(RealBall(exact.rational, bits), multiply(RealBall(exact.pi, bits), pi(bits), bits), bits);
  const auto add_terms = [&](const std::vector<ExactValue::Term>& terms, auto function) {
    for (const auto& [factor, of] : terms) {
      RealBall term(of, bits);
      function(term.raw(), term.raw(), bits);
      sum = add(sum, multiply(RealBall(factor, bits), term, bits), bits);
    }
  };
  add_terms(exact.logarithms, [](auto y, auto x, long b) { arb_log(y, x, b); });
  add_terms(exact.arctangents, [](auto y, auto x, long b) { arb_atan(y, x, b); });
  return sum;
}

void check_definite(const Antiderivative& F, const Endpoint& a, const Endpoint& b) {
  try {
    const DefiniteIntegral integral = definite_integral(F, a, b, AtPoles::principal_value);
    if (integral.exact && !value(*integral.exact, 200).overlaps(integral.value.enclose(100)))
      throw Error("the value in finite terms is wrong");
  } catch (const DomainError&) {  // it does not exist
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2 || size > 24) return 0;
  const auto coefficient = [&](std::size_t k) {
    return Rational(static_cast<std::int8_t>(data[k]));
  };
  const std::size_t split = data[0] % size;
  std::vector<Rational> n;
  std::vector<Rational> d;
  for (std::size_t k = 1; k < size; ++k) (k <= split ? n : d).push_back(coefficient(k));
  Polynomial denominator(d);
  if (denominator.is_zero()) return 0;
  if (data[0] % 3 == 0 && denominator.degree() <= 4) denominator *= denominator;
  const RationalFunction f(Polynomial(n), denominator);
  for (const Form form :
       {Form::partial_fractions, Form::rothstein_trager, Form::lazard_rioboo_trager})
    integrate(f, form);
  const Antiderivative F = integrate(f);
  real_form(F);
  check_definite(F, Rational(data[0] % 7) - 3, Rational(data[1] % 9) / 2);
  check_definite(F, Rational(data[1] % 5), Infinity::negative);
  return 0;
}
