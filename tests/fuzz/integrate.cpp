// Any rational function with small coefficients: integrate() checks itself and throws where the
// derivative of the result is not the integrand.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "phrame/integrate/integrate.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace phrame;
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
  for (const Form form : {Form::automatic, Form::partial_fractions, Form::rothstein_trager})
    integrate(f, form);
  return 0;
}
