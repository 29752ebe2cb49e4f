#include <cmath>
#include <sstream>
#include <tuple>

#include "answers.hpp"

namespace phrame::inline v0::python {
namespace {

struct IntegralObject {
  IntegralQuery query;
  std::string style;
  std::optional<DefiniteIntegral> value;
  Antiderivative antiderivative;
  nb::object recipe;
};

PathEnd path_end(nb::handle x, const std::string& place) {
  if (PyFloat_Check(x.ptr()) && std::isinf(PyFloat_AsDouble(x.ptr())))
    return PyFloat_AsDouble(x.ptr()) > 0 ? Infinity::positive : Infinity::negative;
  if (PyUnicode_Check(x.ptr()) == 0) return rational(x, place);
  try {
    return parse_endpoint(text(x, place));
  } catch (const InputError& error) {
    refuse(place, error.what(), x);
  }
}

/// The end as it was read, for the recipe: what was given may change later.
nb::object kept_end(nb::handle given, const PathEnd& end) {
  const auto* number = std::get_if<Rational>(&end);
  return number == nullptr ? nb::borrow(given) : to_python(*number);
}

Expression integrand_of(nb::handle f, nb::handle variable) {
  const auto letter = [&]() -> std::optional<std::string> {
    if (variable.is_none()) return std::nullopt;
    return text(variable, "variable");
  }();
  if (letter && !is_variable_name(*letter))
    refuse("variable", "\"" + abbreviated(*letter) + "\" is no name of a variable", variable);
  if (nb::isinstance<RationalFunction>(f))
    return {nb::cast<const RationalFunction&>(f), letter.value_or("t")};
  if (nb::isinstance<Polynomial>(f))
    return {RationalFunction(nb::cast<const Polynomial&>(f)), letter.value_or("t")};
  if (PyUnicode_Check(f.ptr()) == 0) refuse_type("f", "a str, RationalFunction or Polynomial", f);
  try {
    return parse_expression(text(f, "f"), letter);
  } catch (const InputError& error) {
    refuse("f", error.what(), f);
  }
}

nb::object integral(nb::handle f, nb::handle from, nb::handle to, nb::handle variable,
                    Flag<"principal_value"> principal_value, const Text<"style">& style,
                    const Text<"form">& form) {
  Expression expression = integrand_of(f, variable);
  IntegralQuery query{.integrand = std::move(expression.value)};
  query.variable = expression.variable.empty() ? "x" : expression.variable;
  query.style = style_named(style);
  query.form = form_named(form);
  query.most_poles = 100;
  if (from.is_none() != to.is_none())
    refuse(from.is_none() ? "lower" : "upper", "both ends are wanted, or none", nb::none());
  if (!from.is_none())
    query.ends = IntegralQuery::Ends{path_end(from, "lower"), path_end(to, "upper"),
                                     principal_value ? AtPoles::principal_value : AtPoles::refuse};
  IntegralObject made{query, style, std::nullopt, {}, {}};
  std::tie(made.antiderivative, made.value) = without_gil([query] {
    std::pair<Antiderivative, std::optional<DefiniteIntegral>> found(
        integrate(query.integrand, query.form), std::nullopt);
    if (query.ends)
      found.second =
          path_integral(query.integrand, query.ends->from, query.ends->to, query.ends->at_poles);
    return found;
  });
  const auto kept = [&query](nb::handle given, PathEnd IntegralQuery::Ends::*end) {
    return query.ends ? kept_end(given, *query.ends.*end) : nb::none();
  };
  made.recipe =
      remade("_integral", nb::cast(query.integrand), kept(from, &IntegralQuery::Ends::from),
             kept(to, &IntegralQuery::Ends::to), nb::str(query.variable.c_str()),
             nb::bool_(principal_value), nb::str(style.c_str()), nb::str(form.c_str()));
  return nb::cast(std::move(made));
}

IntegralAnswer integral_answer(const IntegralObject& self) {
  return without_gil([query = self.query] { return answer(query); });
}

/// An end for SymPy, exactly.
nb::object sympy_end(const Rational& x) { return imported("sympy", "Rational")(to_python(x)); }

nb::object sympy_end(const RealAlgebraic& x) {
  if (const auto rational = x.rational()) return sympy_end(*rational);
  const Interval below{std::nullopt, x.interval().lower};
  return imported("sympy", "rootof")(
      imported("phrame._convert", "sympy_polynomial")(nb::cast(x.polynomial())),
      count_real_roots(x.polynomial(), below));
}

nb::object sympy_end(Infinity x) {
  const nb::object& infinity = imported("sympy", "oo");
  return x == Infinity::positive ? infinity : -infinity;
}

nb::object sympy_end(const PiValue& x) {
  return imported("phrame._convert", "at_pi")(nb::cast(x.of_pi));
}

nb::object integral_for_sympy(const IntegralObject& self, nb::handle symbol) {
  const auto script = [](const IntegralQuery& query) {
    return to_script(without_gil([query] { return answer(query); }), Language::sympy);
  };
  const nb::object& run = imported("phrame._convert", "run_script");
  if (!self.value) return run(script(self.query), self.query.variable, symbol);
  if (!symbol.is_none())
    refuse("symbol", "a definite integral is a number; integrate(f).sympy(x) is of x", symbol);
  if (const auto rational = self.value->value.exact()) return sympy_end(*rational);
  if (self.value->exact) return run(script(self.query), self.query.variable, symbol, "definite");
  const auto end = [](const PathEnd& at) {
    return std::visit([](const auto& x) { return sympy_end(x); }, at);
  };
  return imported("phrame._convert", "sympy_integral")(
      self.query.integrand, end(self.query.ends->from), end(self.query.ends->to), self.style);
}

}  // namespace

void bind_integral(nb::module_& m) {
  m.def("_integral", integral, nb::arg(), nb::arg().none(), nb::arg().none(), nb::arg().none(),
        nb::arg(), nb::arg(), nb::arg());
  m.def("integrate", integral, argument("f"), argument("lower") = nb::none(),
        argument("upper") = nb::none(), nb::kw_only(), argument("variable") = nb::none(),
        argument("principal_value") = false, argument("style") = "textbook",
        argument("form") = "auto",
        nb::sig(
            "def integrate(f: str | RationalFunction | Polynomial, lower: Number | None = None, "
            "upper: Number | None = None, *, variable: str | None = None, principal_value: bool = "
            "False, style: str = 'textbook', form: str = 'auto') -> Integral"),
        "The integral of a rational function, and its value between two ends: numbers, "
        "\"inf\", \"sqrt(2)\", \"pi/4\".");
  auto type = nb::class_<IntegralObject>(m, "Integral",
                                         "The integral of a rational function, in closed form.");
  type.def_prop_ro(
          "integrand", [](const IntegralObject& self) { return self.query.integrand; },
          "What is integrated.")
      .def_prop_ro(
          "variable", [](const IntegralObject& self) { return self.query.variable; },
          "What it is called.")
      .def(
          "value",
          [](nb::handle self, nb::handle digits) {
            const auto& of = nb::cast<const IntegralObject&>(self);
            if (!of.value) throw InputError("value", "no ends were given to integrate()");
            return number_or_digits(of.value->value, digits, method_recipe(self, "value"));
          },
          argument("digits") = nb::none(),
          nb::sig("@typing.overload\ndef value(self, digits: None = None) -> fractions.Fraction | "
                  "Real: ...\n@typing.overload\ndef value(self, digits: int) -> decimal.Decimal"),
          "The value between the ends; with `digits` a Decimal with so many.")
      .def_prop_ro(
          "exact",
          [](const IntegralObject& self) -> std::optional<std::string> {
            if (!self.value || !self.value->exact) return std::nullopt;
            return formatted_sum(formatted_terms(*self.value->exact, Notation::unicode), "",
                                 Notation::unicode);
          },
          "The value in finite terms where it is known so, as a text.")
      .def(
          "poles",
          [](const IntegralObject& self) {
            return to_python(without_gil([f = self.query.integrand] {
              return pole_table(integrate(f, Form::partial_fractions), 100);
            }));
          },
          nb::sig("def poles(self) -> " PHRAME_POLES_SIG),
          "The poles of the integrand that have a residue, with it, to 12 digits or more; none of "
          "more than 100.")
      .def(
          "text",
          [](const IntegralObject& self) {
            return for_reading(to_text(integral_answer(self)), true);
          },
          "The closed form and the value, for reading.")
      .def(
          "latex", [](const IntegralObject& self) { return to_latex(integral_answer(self)); },
          "The same for LaTeX.")
      .def(
          "json", [](const IntegralObject& self) { return to_json(integral_answer(self)); },
          "integral/1.")
      .def("sympy", integral_for_sympy, argument("symbol") = nb::none(),
           nb::sig("def sympy(self, symbol: typing.Any = None) -> typing.Any"),
           "The value where there are ends, exactly; else the antiderivative, of this symbol or a "
           "real one of the same name. A SymPy expression.")
      .def("__repr__",
           [](const IntegralObject& self) {
             std::ostringstream out;
             out << self.query.integrand;
             std::string text = "<Integral of " + abbreviated(out.str(), 200);
             if (!self.value) return text + ">";
             const auto& [from, to, at_poles] = *self.query.ends;
             return text + " from " + to_text(from) + " to " + to_text(to) + ">";
           })
      .def("__str__",
           [](const IntegralObject& self) {
             return for_reading(to_text(integral_answer(self)), false);
           })
      .def("_repr_latex_", [](const IntegralObject& self) {
        const IntegralAnswer found = integral_answer(self);
        if (found.definite) return between_dollars(to_latex(found));
        const Letters letters = letters_for(found.variable, Notation::latex);
        const auto terms = [&] {
          if (const auto* book = std::get_if<TextbookForm>(&found.other))
            return formatted_terms(*book, Notation::latex, letters);
          return formatted_terms(found.antiderivative, Notation::latex, letters);
        }();
        return "$\\displaystyle " + formatted_sum(terms, "", Notation::latex) + "$";
      });
  bind_python(type, "_repr_html_", "phrame._show", "integral_html", "def _repr_html_(self) -> str");
  bind_recipe(type);
}

}  // namespace phrame::python
