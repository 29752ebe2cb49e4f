#include "answers.hpp"

namespace phrame::python {

Form form_named(const std::string& name) {
  return chosen<Form>(name, "form",
                      {{"auto", Form::automatic},
                       {"partial-fractions", Form::partial_fractions},
                       {"rothstein-trager", Form::rothstein_trager},
                       {"lazard-rioboo-trager", Form::lazard_rioboo_trager}});
}

Style style_named(const std::string& name) {
  return chosen<Style>(name, "style",
                       {{"logarithms", Style::logarithms},
                        {"textbook", Style::textbook},
                        {"real", Style::real},
                        {"radicals", Style::radicals}});
}

nb::object number_or_digits(const Real& x, nb::handle digits, const nb::object& recipe) {
  if (digits.is_none()) return to_python(x, recipe);
  const long n = count(digits, "digits", 1, 1'000'000);
  return to_decimal(without_gil([&] { return round_to_decimal(x, n).value; }));
}

}  // namespace phrame::python
