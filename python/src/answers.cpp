#include "answers.hpp"

namespace phrame::inline v0::python {

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

std::string between_dollars(std::string latex) {
  constexpr std::string_view environment = "{align*}";
  for (std::size_t at = 0; (at = latex.find(environment)) != std::string::npos;)
    latex.replace(at, environment.size(), "{aligned}");
  latex.erase(latex.find_last_not_of('\n') + 1);
  return "$\\displaystyle " + latex + "$";
}

nb::object to_python(const std::optional<PoleTable>& poles) {
  nb::list list;
  const auto near = [](const PolePart& x) {
    return x.ball.contains_zero() ? 0 : approximate(x.ball);
  };
  const auto append = [&](const PoleRow& row, int sign) {
    const auto number = [&](const PolePart& re, const PolePart& im) {
      const double y = near(im);
      return nb::steal(PyComplex_FromDoubles(near(re), y == 0 ? 0 : sign * y));
    };
    list.append(nb::make_tuple(number(row.re, row.im), number(row.residue_re, row.residue_im)));
  };
  if (poles)
    for (const PoleRow& row : poles->rows) {
      append(row, 1);
      if (near(row.im) != 0) append(row, -1);
    }
  return nb::tuple(list);
}

nb::object number_or_digits(const Real& x, nb::handle digits, const nb::object& recipe) {
  if (digits.is_none()) return to_python(x, recipe);
  const long n = count(digits, "digits", 1, 1'000'000);
  return to_decimal(without_gil([x, n] { return round_to_decimal(x, n).value; }));
}

}  // namespace phrame::python
