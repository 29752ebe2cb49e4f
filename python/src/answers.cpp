#include <sstream>

#include "paths.hpp"
#include "phrame/io/read/endpoint.hpp"

namespace phrame::python {
namespace {

template <class F>
auto computed(const F& f) {
  const nb::gil_scoped_release released;
  return f();
}

Form form_named(const std::string& name) {
  if (name == "auto") return Form::automatic;
  if (name == "partial-fractions") return Form::partial_fractions;
  if (name == "rothstein-trager") return Form::rothstein_trager;
  if (name == "lazard-rioboo-trager") return Form::lazard_rioboo_trager;
  refuse("form",
         "\"" + abbreviated(name) +
             "\" is not one of auto, partial-fractions, rothstein-trager, lazard-rioboo-trager",
         nb::str(name.c_str()));
}

Style style_named(const std::string& name) {
  if (name == "logarithms") return Style::logarithms;
  if (name == "textbook") return Style::textbook;
  if (name == "real") return Style::real;
  if (name == "radicals") return Style::radicals;
  refuse("style",
         "\"" + abbreviated(name) + "\" is not one of logarithms, textbook, real, radicals",
         nb::str(name.c_str()));
}

/// x, or with `digits` a Decimal with so many.
nb::object number_or_digits(const Real& x, nb::handle digits, const nb::object& recipe) {
  if (digits.is_none()) return to_python(x, recipe);
  const long n = count(digits, "digits", 1, 1'000'000);
  return to_decimal(computed([&] { return round_to_decimal(x, n).value; }));
}

// ---- the angle

struct AngleObject {
  NamedPath named;
  PathAngle angle;
  FrameStart start;
  FrameAngle start_angle;
  std::string form;
  nb::object recipe;
};

AngleAnswer formula(const AngleObject& self, const std::string& style) {
  AngleQuery query;
  query.reference = self.angle.reference();
  query.start = self.start;
  query.form = form_named(self.form);
  query.style = style_named(style);
  query.most_poles = 100;
  return computed([&] { return answer(self.named, query); });
}

nb::object make_angle(nb::handle self, const std::string& frame, nb::handle start,
                      nb::handle start_normal, const std::string& form) {
  const auto& named = nb::cast<const PathObject&>(self).named;
  const Reference reference = reference_named(frame, "frame");
  const Form how = form_named(form);
  const FrameStart from = frame_start(start, start_normal, named.path, reference);
  auto [angle, at_zero] = computed([&] {
    return std::pair{PathAngle(named.path, reference, how),
                     start_angle(from, named.path, reference)};
  });
  return nb::cast(AngleObject{
      named, std::move(angle), from, std::move(at_zero), form,
      remade("_angle", self, nb::str(frame.c_str()), start, start_normal, nb::str(form.c_str()))});
}

const RmfAngle& segment_angle(const AngleObject& self, std::size_t k) {
  const std::size_t n = self.angle.path().segments().size();
  if (k >= n) refuse("segment", "there are " + std::to_string(n), nb::int_(k));
  return self.angle.segment(k);
}

Real angle_at(const AngleObject& self, nb::handle t) {
  const Rational at = rational(t, "t");
  return computed([&] { return self.angle.value(at, self.start_angle); });
}

nb::object angle_of_what(const AngleObject& self, nb::handle ts, nb::handle progress) {
  if (PyUnicode_Check(ts.ptr()) != 0 || PySequence_Check(ts.ptr()) == 0) {
    const Real theta = angle_at(self, ts);
    return nb::float_(computed([&] { return round_to_double(theta); }));
  }
  return angles(self.angle, self.start_angle, ts, progress);
}

void bind_angle(nb::module_& m, nb::class_<PathObject>& path) {
  m.def("_angle", make_angle, nb::arg("path"), nb::arg("frame"), nb::arg("start").none(),
        nb::arg("start_normal").none(), nb::arg("form"));
  path.def(
      "angle", make_angle, nb::arg("frame") = "erf", PHRAME_START_PARAMETERS,
      nb::arg("form") = "auto",
      nb::sig("def angle(self, frame: str = 'erf', " PHRAME_START_SIG
              ", form: str = 'auto') -> Angle"),
      "The angle of the rotation-minimizing frame to the Euler–Rodrigues (erf) or Frenet frame.");
  auto type = nb::class_<AngleObject>(
      m, "Angle", "The angle θ(t) of the rotation-minimizing frame of a path, in closed form.");
  type.def(
          "value",
          [](nb::handle self, nb::handle t, nb::handle digits) {
            const Real theta = angle_at(nb::cast<const AngleObject&>(self), t);
            if (!digits.is_none()) return number_or_digits(theta, digits, {});
            return to_python(theta, method_recipe(self, "value", t));
          },
          nb::arg("t"), nb::arg("digits") = nb::none(),
          nb::sig("@typing.overload\ndef value(self, t: Number, digits: None = None) -> "
                  "fractions.Fraction | Real: ...\n@typing.overload\ndef value(self, t: Number, "
                  "digits: int) -> decimal.Decimal"),
          "θ(t): a Fraction where it is rational, else a Real; with `digits` a Decimal with so "
          "many.")
      .def("__call__", angle_of_what, nb::arg("ts"), nb::kw_only(),
           nb::arg("progress") = nb::none(),
           nb::sig("@typing.overload\ndef __call__(self, ts: float | fractions.Fraction | "
                   "decimal.Decimal, *, progress: "
                   "collections.abc.Callable[[int, int], object] | None = None) -> float: ...\n"
                   "@typing.overload\ndef __call__(self, ts: Numbers, *, progress: "
                   "collections.abc.Callable[[int, int], object] | None = None) -> "
                   "numpy.typing.NDArray[numpy.float64]"),
           "θ as correctly rounded doubles: of one parameter, or an array of many.")
      .def_prop_ro(
          "path", [](const AngleObject& self) { return wrap(self.named); },
          nb::sig("def path(self) -> Path"))
      .def(
          "rate",
          [](const AngleObject& self, std::size_t k) { return segment_angle(self, k).rate(); },
          nb::arg("segment") = 0, "θ′, a rational function.")
      .def(
          "text",
          [](const AngleObject& self, const std::string& style) {
            return for_reading(to_text(formula(self, style)), true);
          },
          nb::arg("style") = "logarithms", "The closed form and the poles, for reading.")
      .def(
          "latex",
          [](const AngleObject& self, const std::string& style) {
            return to_latex(formula(self, style));
          },
          nb::arg("style") = "logarithms", "The closed form, for LaTeX.")
      .def(
          "json",
          [](const AngleObject& self, const std::string& style) {
            return to_json(formula(self, style));
          },
          nb::arg("style") = "logarithms", "angle/1 or spline-angle/1.")
      .def(
          "sympy",
          [](nb::handle self) {
            const auto& of = nb::cast<const AngleObject&>(self);
            if (!of.named.path.is_curve())
              throw DomainError("sympy: an antiderivative for SymPy is one of a single curve");
            return imported("phrame._convert",
                            "run_script")(to_script(formula(of, "logarithms"), Language::sympy));
          },
          nb::sig("def sympy(self) -> typing.Any"), "θ up to a constant, a SymPy expression.")
      .def("__repr__",
           [](const AngleObject& self) {
             return std::string("<Angle to the ") +
                    (self.angle.reference() == Reference::frenet ? "Frenet" : "Euler–Rodrigues") +
                    " frame" +
                    (self.named.name.empty() ? "" : " of " + abbreviated(self.named.name)) + ">";
           })
      .def("__str__",
           [](const AngleObject& self) {
             return for_reading(to_text(formula(self, "logarithms")), false);
           })
      .def("_repr_latex_",
           [](const AngleObject& self) -> std::optional<std::string> {
             if (!self.named.path.is_curve()) return std::nullopt;
             const AngleAnswer found = formula(self, "textbook");
             const Antiderivative& F = found.formulas.front().antiderivative;
             const std::string terms = [&] {
               if (const auto* book = std::get_if<TextbookForm>(&found.formulas.front().other))
                 return formatted_sum(formatted_terms(*book, Notation::latex), "", Notation::latex);
               return formatted_sum(formatted_terms(F, Notation::latex), "", Notation::latex);
             }();
             return "$\\displaystyle \\theta(t) = " + terms + " + \\mathrm{const}$";
           })
      .def(
          "__reduce__", [](const AngleObject& self) { return self.recipe; }, PHRAME_REDUCE_SIG);
  bind_copies(type);
}

// ---- integrals

struct IntegralObject {
  IntegralQuery query;
  std::optional<DefiniteIntegral> value;
  Antiderivative antiderivative;
  nb::object recipe;
};

PathEnd path_end(nb::handle x, const std::string& place) {
  if (PyFloat_Check(x.ptr()) && std::isinf(PyFloat_AS_DOUBLE(x.ptr())))
    return PyFloat_AS_DOUBLE(x.ptr()) > 0 ? Infinity::positive : Infinity::negative;
  if (PyUnicode_Check(x.ptr()) == 0) return rational(x, place);
  try {
    return parse_endpoint(nb::cast<std::string>(x));
  } catch (const InputError& error) {
    refuse(place, error.what(), x);
  }
}

Expression integrand_of(nb::handle f, nb::handle variable) {
  const auto letter = [&]() -> std::optional<std::string> {
    if (variable.is_none()) return std::nullopt;
    return nb::cast<std::string>(variable);
  }();
  if (letter && !is_variable_name(*letter))
    refuse("variable", "\"" + abbreviated(*letter) + "\" is no name of a variable", variable);
  if (nb::isinstance<RationalFunction>(f))
    return {nb::cast<const RationalFunction&>(f), letter.value_or("t")};
  if (nb::isinstance<Polynomial>(f))
    return {RationalFunction(nb::cast<const Polynomial&>(f)), letter.value_or("t")};
  if (PyUnicode_Check(f.ptr()) == 0) refuse_type("f", "a str, RationalFunction or Polynomial", f);
  try {
    return parse_expression(nb::cast<std::string>(f), letter);
  } catch (const InputError& error) {
    refuse("f", error.what(), f);
  }
}

nb::object integral(nb::handle f, nb::handle from, nb::handle to, nb::handle variable,
                    bool principal_value, const std::string& style, const std::string& form) {
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
  IntegralObject made{query, std::nullopt, {}, {}};
  computed([&] {
    made.antiderivative = integrate(query.integrand, query.form);
    if (query.ends)
      made.value =
          path_integral(query.integrand, query.ends->from, query.ends->to, query.ends->at_poles);
    return 0;
  });
  made.recipe =
      remade("_integral", nb::cast(query.integrand), from, to, nb::str(query.variable.c_str()),
             nb::bool_(principal_value), nb::str(style.c_str()), nb::str(form.c_str()));
  return nb::cast(std::move(made));
}

IntegralAnswer integral_answer(const IntegralObject& self) {
  return computed([&] { return answer(self.query); });
}

void bind_integral(nb::module_& m) {
  m.def("_integral", integral, nb::arg(), nb::arg().none(), nb::arg().none(), nb::arg().none(),
        nb::arg(), nb::arg(), nb::arg());
  m.def("integrate", integral, nb::arg("f"), nb::arg("lower") = nb::none(),
        nb::arg("upper") = nb::none(), nb::kw_only(), nb::arg("variable") = nb::none(),
        nb::arg("principal_value") = false, nb::arg("style") = "textbook", nb::arg("form") = "auto",
        nb::sig(
            "def integrate(f: str | RationalFunction | Polynomial, lower: Number | None = None, "
            "upper: Number | None = None, *, variable: str | None = None, principal_value: bool = "
            "False, style: str = 'textbook', form: str = 'auto') -> Integral"),
        "The integral of a rational function, and its value between two ends: numbers, "
        "\"inf\", \"sqrt(2)\", \"pi/4\".");
  auto type = nb::class_<IntegralObject>(m, "Integral",
                                         "The integral of a rational function, in closed form.");
  type.def_prop_ro("integrand", [](const IntegralObject& self) { return self.query.integrand; })
      .def_prop_ro("variable", [](const IntegralObject& self) { return self.query.variable; })
      .def(
          "value",
          [](nb::handle self, nb::handle digits) {
            const auto& of = nb::cast<const IntegralObject&>(self);
            if (!of.value) throw InputError("value", "no ends were given to integrate()");
            return number_or_digits(of.value->value, digits, method_recipe(self, "value"));
          },
          nb::arg("digits") = nb::none(),
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
      .def("text",
           [](const IntegralObject& self) {
             return for_reading(to_text(integral_answer(self)), true);
           })
      .def("latex", [](const IntegralObject& self) { return to_latex(integral_answer(self)); })
      .def(
          "json", [](const IntegralObject& self) { return to_json(integral_answer(self)); },
          "integral/1.")
      .def(
          "sympy",
          [](const IntegralObject& self) {
            IntegralQuery query = self.query;
            query.ends.reset();
            return imported("phrame._convert", "run_script")(
                to_script(computed([&] { return answer(query); }), Language::sympy));
          },
          nb::sig("def sympy(self) -> typing.Any"), "The antiderivative, a SymPy expression.")
      .def("__repr__",
           [](const IntegralObject& self) {
             std::ostringstream out;
             out << self.query.integrand;
             return "<Integral of " + abbreviated(out.str(), 200) + ">";
           })
      .def("__str__",
           [](const IntegralObject& self) {
             return for_reading(to_text(integral_answer(self)), false);
           })
      .def("_repr_latex_",
           [](const IntegralObject& self) {
             const IntegralAnswer found = integral_answer(self);
             const Letters letters = letters_for(found.variable, Notation::latex);
             const auto terms = [&] {
               if (const auto* book = std::get_if<TextbookForm>(&found.other))
                 return formatted_terms(*book, Notation::latex, letters);
               return formatted_terms(found.antiderivative, Notation::latex, letters);
             }();
             return "$\\displaystyle " + formatted_sum(terms, "", Notation::latex) + "$";
           })
      .def(
          "__reduce__", [](const IntegralObject& self) { return self.recipe; }, PHRAME_REDUCE_SIG);
  bind_copies(type);
}

// ---- classification

struct ClassificationObject {
  ClassificationAnswer found;
  nb::object recipe;
};

const Classification& of_curve(const ClassificationObject& self) {
  if (!self.found.path.path.is_curve())
    throw DomainError("classification: that is asked of single curves; classify path.segments");
  return self.found.classification.segments.front();
}

nb::object vector_or_none(const std::optional<Vector<Rational>>& v) {
  return v ? to_python(*v) : nb::none();
}

#define PHRAME_VECTOR_SIG "tuple[fractions.Fraction, fractions.Fraction, fractions.Fraction]"
#define PHRAME_ROOTS_SIG "tuple[tuple[fractions.Fraction | Real, int], ...]"

void bind_classification(nb::module_& m, nb::class_<PathObject>& path) {
  const auto classify = [](nb::handle self) {
    const auto& named = nb::cast<const PathObject&>(self).named;
    return nb::cast(
        ClassificationObject{computed([&] { return answer(named, ClassificationQuery{}); }),
                             method_recipe(self, "classify")});
  };
  path.def("classify", classify, nb::sig("def classify(self) -> Classification"),
           "Of which kinds the path is, decided exactly.");
  auto type = nb::class_<ClassificationObject>(
      m, "Classification", "Of which kinds a path is, with witnesses: docs/classification.md.");
  using C = ClassificationObject;
  type.def_prop_ro("is_regular", [](const C& c) { return c.found.classification.is_regular; })
      .def_prop_ro(
          "line", [](const C& c) { return vector_or_none(c.found.classification.line); },
          nb::sig("def line(self) -> " PHRAME_VECTOR_SIG " | None"),
          "The direction of a straight line.")
      .def_prop_ro(
          "normal", [](const C& c) { return vector_or_none(c.found.classification.normal); },
          nb::sig("def normal(self) -> " PHRAME_VECTOR_SIG " | None"),
          "Of the plane of a plane path.")
      .def_prop_ro(
          "helix",
          [](const C& c) -> nb::object {
            const auto& helix = c.found.classification.helix;
            if (!helix) return nb::none();
            return nb::make_tuple(to_python(helix->axis), to_python(helix->cosine_squared));
          },
          nb::sig("def helix(self) -> tuple[" PHRAME_VECTOR_SIG ", fractions.Fraction] | None"),
          "The axis and cos² of the constant angle to it.")
      .def_prop_ro("erf_is_rotation_minimizing",
                   [](const C& c) { return c.found.classification.erf_is_rotation_minimizing; })
      .def_prop_ro(
          "cusps", [](const C& c) { return to_python(of_curve(c).cusps); },
          nb::sig("def cusps(self) -> " PHRAME_ROOTS_SIG),
          "On [0, 1], with their orders; of a curve, as all below.")
      .def_prop_ro(
          "inflections", [](const C& c) { return to_python(of_curve(c).inflections); },
          nb::sig("def inflections(self) -> " PHRAME_ROOTS_SIG))
      .def_prop_ro(
          "double_ph",
          [](const C& c) -> nb::object {
            const auto& found = of_curve(c).double_ph;
            if (!found) return nb::none();
            return nb::make_tuple(to_python(found->constant), nb::cast(found->omega));
          },
          nb::sig("def double_ph(self) -> tuple[fractions.Fraction, Polynomial] | None"),
          "(c, ω) with ρ = c·ω².")
      .def_prop_ro(
          "content", [](const C& c) { return of_curve(c).content; }, "gcd(x′, y′, z′).")
      .def_prop_ro(
          "rational_frame",
          [](const C& c) -> nb::object {
            const auto* frame = std::get_if<RationalFrame>(&of_curve(c).rational_frame);
            if (frame == nullptr) return nb::none();
            return nb::make_tuple(nb::cast(frame->w.re), nb::cast(frame->w.im));
          },
          nb::sig("def rational_frame(self) -> tuple[Polynomial, Polynomial] | None"),
          "The parts of w with θ = 2·arg w where the rotation-minimizing frame is rational.")
      .def_prop_ro("erf_is_monotone",
                   [](const C& c) { return of_curve(c).erf_turning.is_monotone; })
      .def("text", [](const C& c) { return for_reading(to_text(c.found), true); })
      .def("latex", [](const C& c) { return to_latex(c.found); })
      .def(
          "json", [](const C& c) { return to_json(c.found); }, "classify/1.")
      .def("__str__", [](const C& c) { return for_reading(to_text(c.found), false); })
      .def("__repr__",
           [](const C& c) {
             const std::string& name = c.found.path.name;
             return "<Classification" + (name.empty() ? "" : " of " + abbreviated(name)) + ">";
           })
      .def(
          "__reduce__", [](const C& c) { return c.recipe; }, PHRAME_REDUCE_SIG);
  bind_copies(type);
}

// ---- minimal twist

struct MinimalTwistObject {
  MinimalTwist twist;
  nb::object recipe;
};

nb::object minimal_twist(nb::handle self, nb::handle from, nb::handle to, nb::handle extra_turns) {
  const auto& named = nb::cast<const PathObject&>(self).named;
  const Angle a = angle_number(from, "start");
  const Angle b = angle_number(to, "end");
  if (PyIndex_Check(extra_turns.ptr()) == 0) refuse_type("extra_turns", "an int", extra_turns);
  const Integer turns = numerator(rational(extra_turns, "extra_turns"));
  return nb::cast(
      MinimalTwistObject{computed([&] { return MinimalTwist(PathAngle(named.path), a, b, turns); }),
                         method_recipe(self, "minimal_twist", from, to, extra_turns)});
}

void bind_minimal_twist(nb::module_& m, nb::class_<PathObject>& path) {
  path.def("minimal_twist", minimal_twist, nb::arg("start"), nb::arg("end"),
           nb::arg("extra_turns") = 0,
           nb::sig("def minimal_twist(self, start: Number, end: Number, extra_turns: int = 0) -> "
                   "MinimalTwist"),
           "The frame that turns least from the angle `start` at the start to `end` at the end.");
  auto type = nb::class_<MinimalTwistObject>(
      m, "MinimalTwist", "The exact frame of minimal twist: docs/minimal-twist.md.");
  using T = MinimalTwistObject;
#define PHRAME_TWIST(name, of, what)                                                         \
  type.def_prop_ro(                                                                          \
      name,                                                                                  \
      [](nb::handle self) {                                                                  \
        return to_python(nb::cast<const T&>(self).twist.of(), attribute_recipe(self, name)); \
      },                                                                                     \
      nb::sig("def " name "(self) -> fractions.Fraction | Real"), what)
  PHRAME_TWIST("twist", twist, "How far it turns about the tangent, in radians.");
  PHRAME_TWIST("nominal_twist", nominal_twist, "The same before whole turns are taken off.");
  PHRAME_TWIST("erf_twist", erf_twist, "Of the Euler–Rodrigues frame.");
  PHRAME_TWIST("rate", rate, "The twist per unit of arc length.");
#undef PHRAME_TWIST
  type.def_prop_ro(
          "length", [](const T& t) { return to_python(t.twist.length()); },
          nb::sig("def length(self) -> fractions.Fraction"))
      .def(
          "value",
          [](nb::handle self, nb::handle t, nb::handle digits) {
            const auto& of = nb::cast<const T&>(self).twist;
            const Rational at = rational(t, "t");
            const Real theta = computed([&] { return of.value(at); });
            if (!digits.is_none()) return number_or_digits(theta, digits, {});
            return to_python(theta, method_recipe(self, "value", t));
          },
          nb::arg("t"), nb::arg("digits") = nb::none(),
          nb::sig("@typing.overload\ndef value(self, t: Number, digits: None = None) -> "
                  "fractions.Fraction | Real: ...\n@typing.overload\ndef value(self, t: Number, "
                  "digits: int) -> decimal.Decimal"),
          "The angle to the Euler–Rodrigues frame.")
      .def("__repr__",
           [](const T& t) {
             return "<MinimalTwist " + round_to_decimal(t.twist.twist(), 6).value + " radians>";
           })
      .def(
          "__reduce__", [](const T& t) { return t.recipe; }, PHRAME_REDUCE_SIG);
  bind_copies(type);
}

// ---- the check of others' frames

struct CheckObject {
  CheckAnswer found;
  nb::object recipe;
};

nb::object check(nb::handle self, nb::handle ts, nb::handle f2, nb::handle f3, nb::handle tangents,
                 nb::handle tolerance, nb::handle start, nb::handle start_normal) {
  const auto& named = nb::cast<const PathObject&>(self).named;
  const auto at = rationals(ts, "ts");
  if (at.empty()) refuse("ts", "it is empty", ts);
  const auto given = [&](nb::handle list, const char* place) {
    if (list.is_none()) return std::vector<Vector<Rational>>();
    auto rows = vectors(list, place, 1);
    if (rows.size() != at.size())
      refuse(place,
             std::to_string(rows.size()) + " for " + std::to_string(at.size()) + " parameters",
             list);
    return rows;
  };
  const auto second = given(f2, "f2");
  if (second.empty()) refuse_type("f2", "a list of vectors", f2);
  const auto third = given(f3, "f3");
  const auto tangent = given(tangents, "tangents");
  CheckQuery query;
  for (std::size_t k = 0; k < at.size(); ++k) {
    GivenFrame frame{at[k], second[k]};
    if (!third.empty()) frame.f3 = third[k];
    if (!tangent.empty()) frame.tangent = tangent[k];
    query.frames.push_back(std::move(frame));
  }
  if (!start.is_none() || !start_normal.is_none())
    query.options.start = frame_start(start, start_normal, named.path, Reference::euler_rodrigues);
  query.options.tolerance = rational(tolerance, "tolerance");
  if (query.options.tolerance.sign() <= 0) refuse("tolerance", "it is not positive", tolerance);
  return nb::cast(CheckObject{
      computed([&] { return answer(named, query); }),
      method_recipe(self, "check", ts, f2, f3, tangents, tolerance, start, start_normal)});
}

void bind_check(nb::module_& m, nb::class_<PathObject>& path) {
  path.def(
      "check", check, nb::arg("ts"), nb::arg("f2"), nb::arg("f3") = nb::none(),
      nb::arg("tangents") = nb::none(), nb::arg("tolerance") = "1e-6", PHRAME_START_PARAMETERS,
      nb::sig("def check(self, ts: Numbers, f2: Vectors, f3: Vectors | None = None, tangents: "
              "Vectors | None = None, tolerance: Number = '1e-6', " PHRAME_START_SIG
              ") -> CheckResult"),
      "How far frames that another program has computed are from the rotation-minimizing one.");
  auto type = nb::class_<CheckObject>(m, "CheckResult", "The verdict on frames: docs/check.md.");
  using C = CheckObject;
  type.def_prop_ro("passes", [](const C& c) { return c.found.verdict.passes; })
      .def("__bool__", [](const C& c) { return c.found.verdict.passes; })
      .def_prop_ro(
          "max_error", [](const C& c) { return ends(c.found.verdict.max_error); },
          nb::sig("def max_error(self) -> tuple[fractions.Fraction, fractions.Fraction]"),
          "Bounds of the greatest angle between f2 and the exact one, in radians.")
      .def_prop_ro(
          "errors",
          [](const C& c) {
            nb::list list;
            for (const auto& error : c.found.verdict.errors)
              list.append(error ? ends(*error) : nb::none());
            return nb::tuple(list);
          },
          nb::sig("def errors(self) -> tuple[tuple[fractions.Fraction, fractions.Fraction] | "
                  "None, ...]"),
          "Bounds of the angle of each f2 to the exact one; None where there is none.")
      .def_prop_ro("worst_sample", [](const C& c) { return c.found.verdict.worst_sample; })
      .def_prop_ro("summary", [](const C& c) { return summary(c.found); })
      .def("text", [](const C& c) { return for_reading(to_text(c.found, {}), true); })
      .def(
          "json", [](const C& c) { return to_json(c.found, {}); }, "check/1.")
      .def("__str__", [](const C& c) { return for_reading(to_text(c.found, {}), false); })
      .def("__repr__",
           [](const C& c) { return "<CheckResult: " + for_reading(summary(c.found), false) + ">"; })
      .def(
          "__reduce__", [](const C& c) { return c.recipe; }, PHRAME_REDUCE_SIG);
  bind_copies(type);
}

// ---- certificates

struct CertificateObject {
  Certificate certificate;
  std::string name;
};

void bind_certificate(nb::module_& m, nb::class_<CurveObject, PathObject>& curve) {
  const auto certify_curve = [](const CurveObject& self, nb::handle at, nb::handle digits,
                                const std::string& frame) {
    const auto ts = rationals(at, "at");
    const long n = count(digits, "digits", 1, 100'000);
    const Reference reference = reference_named(frame, "frame");
    return CertificateObject{computed([&] { return certify(curve_of(self), reference, ts, n); }),
                             self.named.name};
  };
  curve.def("certify", certify_curve, nb::arg("at") = nb::make_tuple(1), nb::arg("digits") = 50,
            nb::arg("frame") = "erf",
            nb::sig("def certify(self, at: Numbers = (1,), digits: int = 50, frame: str = 'erf') "
                    "-> Certificate"),
            "Angles, and what kinds the curve is of, with what proves them.");
  auto type = nb::class_<CertificateObject>(m, "Certificate", "docs/certificate.md.");
  using C = CertificateObject;
  const auto from_json = [](const std::string& text) {
    Certificate read = read_certificate(text);
    return C{std::move(read), ""};
  };
  type.def_static("from_json", from_json, nb::arg("text"), "Of a certificate/1 file, true or not.")
      .def(
          "json", [](const C& c) { return write_certificate(c.certificate, c.name); },
          "The certificate/1 file.")
      .def_prop_ro(
          "curve", [](const C& c) { return wrap(NamedPath(c.name, c.certificate.curve)); },
          nb::sig("def curve(self) -> Curve"))
      .def(
          "objections",
          [](const C& c) {
            std::vector<std::string> list;
            for (const Statement& statement : computed([&] { return verify(c.certificate); })) {
              if (statement.is_proved()) continue;
              const auto* what = std::get_if<std::string>(&statement.what);
              const auto* claim = std::get_if<AngleClaim>(&statement.what);
              list.push_back((what != nullptr ? *what : "angle at " + to_string(claim->t)) + ": " +
                             statement.objection);
            }
            return list;
          },
          "Verifies every statement by another way: what is not proved, and why.")
      .def("is_proved",
           [](const C& c) {
             const auto found = computed([&] { return verify(c.certificate); });
             return std::all_of(found.begin(), found.end(),
                                [](const Statement& s) { return s.is_proved(); });
           })
      .def(
          "__eq__",
          [](const C& c, nb::handle other) {
            return nb::isinstance<C>(other) &&
                   c.certificate == nb::cast<const C&>(other).certificate;
          },
          nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__",
           [](const C& c) {
             return nb::hash(nb::str(write_certificate(c.certificate, "").c_str()));
           })
      .def("__repr__",
           [](const C& c) {
             return "<Certificate of " + std::to_string(c.certificate.claims.size()) + " angles>";
           })
      .def(
          "__reduce__",
          [from_json](const C& c) {
            return remade("_certificate", nb::str(write_certificate(c.certificate, c.name).c_str()),
                          nb::str(c.name.c_str()));
          },
          PHRAME_REDUCE_SIG);
  m.def("_certificate", [](const std::string& text, const std::string& name) {
    return CertificateObject{read_certificate(text), name};
  });
  bind_copies(type);
}

}  // namespace

void bind_answers(nb::module_& m, nb::class_<PathObject>& path,
                  nb::class_<CurveObject, PathObject>& curve) {
  bind_angle(m, path);
  bind_integral(m);
  bind_classification(m, path);
  bind_minimal_twist(m, path);
  bind_check(m, path);
  bind_certificate(m, curve);
}

}  // namespace phrame::python
