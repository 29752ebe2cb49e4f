// Any rational function with small coefficients: integrate() and real_form() check themselves and
// throw where the derivative of the result is not the integrand. Definite integrals between ends of
// all kinds are compared with their values in finite terms, with each other and their sums.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/endpoint.hpp"
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

/// Rational, infinite and algebraic ends.
Endpoint end(std::uint8_t byte) {
  const long number = byte / 8;
  switch (byte % 8) {
    case 0:
      return Infinity::positive;
    case 1:
      return Infinity::negative;
    case 2:
      return real_root({-2 - number, 0, 1}, {Rational(0), std::nullopt});
    case 3:
      return real_root({-2 - number, 0, 1}, {std::nullopt, Rational(0)});
    case 4:
      return real_root({number, 1, 0, 1}, real_line());
    default:
      return Rational(byte - 128) / (byte % 8 - 4);
  }
}

std::optional<RealBall> definite(const RationalFunction& f, const Endpoint& a, const Endpoint& b,
                                 AtPoles at_poles) {
  try {
    const DefiniteIntegral integral = definite_integral(f, a, b, at_poles);
    RealBall enclosure = integral.value.enclose(100);
    if (integral.exact && !value(*integral.exact, 200).overlaps(enclosure))
      throw Error("the value in finite terms is wrong");
    return enclosure;
  } catch (const DomainError&) {  // it does not exist
    return std::nullopt;
  }
}

/// ∫ₐᵇ + ∫ᵇᶜ = ∫ₐᶜ, and an integral is its own principal value.
void check_definite(const RationalFunction& f, const Endpoint& a, const Endpoint& b,
                    const Endpoint& c) {
  const auto principal = AtPoles::principal_value;
  const auto whole = definite(f, a, c, principal);
  const auto first = definite(f, a, b, principal);
  const auto second = definite(f, b, c, principal);
  if (whole && first && second && !whole->overlaps(add(*first, *second, 100)))
    throw Error("the parts do not add up");
  const auto plain = definite(f, a, c, AtPoles::refuse);
  if (plain && (!whole || !whole->overlaps(*plain)))
    throw Error("the principal value is another one");
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
  textbook_form(F);
  check_definite(f, end(data[0]), end(data[1]), end(data[size - 1]));
  return 0;
}
