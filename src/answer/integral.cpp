#include "phrame/answer/integral.hpp"

namespace phrame::inline v0 {
namespace {

/// Of what is shown with sums over poles.
std::optional<PoleTable> poles(const IntegralAnswer& answer, long most) {
  if (const auto* textbook = std::get_if<TextbookForm>(&answer.other))
    return pole_table({{}, {}, textbook->sums}, most);
  if (std::holds_alternative<std::monostate>(answer.other))
    return pole_table(answer.antiderivative, most);
  return std::nullopt;
}

}  // namespace

IntegralAnswer answer(const IntegralQuery& query) {
  IntegralAnswer answer{
      query.integrand, query.variable, integrate(query.integrand, query.form), {}, {}, {},
      query.digits};
  answer.other = other_form(answer.antiderivative, query.style);
  if (query.most_poles) answer.poles = poles(answer, *query.most_poles);
  if (query.ends) {
    const auto& [from, to, at_poles] = *query.ends;
    const DefiniteIntegral integral = path_integral(query.integrand, from, to, at_poles);
    answer.definite = {from, to, at_poles == AtPoles::principal_value,
                       round_to_decimal(integral.value, query.digits), integral.exact};
  }
  return answer;
}

}  // namespace phrame
