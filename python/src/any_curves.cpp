#include "paths.hpp"

namespace phrame::inline v0::python {
namespace {

/// The path of these pieces; what is wrong with one is an error of the argument.
nb::object made_of(const std::string& name, const std::vector<GivenSegment>& segments,
                   const char* place, nb::handle value) {
  try {
    return wrap(without_gil([=] { return path_of(name, segments); }));
  } catch (const InputError& error) {
    refuse(place, error.reason(), value);
  }
}

/// The same of Bézier curves, perhaps with weights, between values of the parameter.
nb::object path_of_beziers(const std::string& name, const std::vector<BezierPiece>& pieces,
                           const char* place, nb::handle value) {
  std::vector<GivenSegment> segments;
  try {
    for (const BezierPiece& piece : pieces) segments.push_back(span_segment(piece, place));
  } catch (const InputError& error) {
    refuse(place, error.reason(), value);
  }
  return made_of(name, segments, place, value);
}

/// As many numbers > 0 as there are points.
std::vector<Rational> weights_of(nb::handle weights, std::size_t points) {
  if (weights.is_none()) return {};
  const auto list = rationals(weights, "weights");
  if (list.size() != points)
    refuse("weights", std::to_string(list.size()) + " for " + std::to_string(points) + " points",
           weights);
  for (std::size_t k = 0; k < list.size(); ++k)
    if (list[k] <= 0)
      refuse("weights[" + std::to_string(k) + "]", to_string(list[k]) + " is not > 0", weights);
  return list;
}

nb::object bezier(nb::handle points, nb::handle weights, const Text<"name">& name) {
  RationalBezier curve{given_points(points, "points", 2)};
  curve.weights = weights_of(weights, curve.points.size());
  return path_of_beziers(name, {{curve, 0, 1}}, "points", points);
}

nb::object polyline(nb::handle points, Flag<"closed"> closed, const Text<"name">& name) {
  std::vector<Vector<Rational>> corners = given_points(points, "points", 2);
  if (closed && corners.front() != corners.back()) corners.push_back(corners.front());
  std::vector<BezierPiece> pieces;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    pieces.push_back({{{corners[k], corners[k + 1]}},
                      Rational(static_cast<long>(k)),
                      Rational(static_cast<long>(k + 1))});
  return path_of_beziers(name, pieces, "points", points);
}

/// Knots of which the first and the last count p + 1 times, and the others are 1, 2, ….
std::vector<Rational> clamped_knots(std::size_t points, long degree) {
  const long last = static_cast<long>(points) - degree;
  std::vector<Rational> knots(static_cast<std::size_t>(degree), Rational(0));
  for (long k = 0; k <= last; ++k) knots.emplace_back(k);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), Rational(last));
  return knots;
}

nb::object nurbs(nb::handle points, nb::handle weights, nb::handle knots, nb::handle degree,
                 const Text<"name">& name) {
  BSpline spline;
  spline.points = given_points(points, "points", 2);
  spline.degree = count(degree, "degree", 1, 1001);
  spline.weights = weights_of(weights, spline.points.size());
  if (!knots.is_none()) {
    spline.knots = rationals(knots, "knots");
  } else {
    if (spline.degree >= static_cast<long>(spline.points.size()))
      refuse("degree",
             std::to_string(spline.degree) + " needs more than " +
                 std::to_string(spline.points.size()) + " points",
             degree);
    spline.knots = clamped_knots(spline.points.size(), spline.degree);
  }
  if (const auto fault = fault_of(spline)) {
    using Member = BSplineFault::Member;
    const auto refuse_in = [&](std::string place, nb::handle value) {
      if (fault->index) place += "[" + std::to_string(*fault->index) + "]";
      refuse(place, fault->reason, value);
    };
    if (fault->member == Member::degree) refuse_in("degree", degree);
    if (fault->member == Member::points) refuse_in("points", points);
    if (fault->member == Member::weights) refuse_in("weights", weights);
    refuse_in("knots", knots);
  }
  return path_of_beziers(name, without_gil([spline] { return bezier_pieces(spline); }), "points",
                         points);
}

nb::object polynomial_curve(nb::handle x, nb::handle y, nb::handle z, nb::handle w,
                            const Text<"name">& name, const Text<"basis">& basis_name) {
  const std::string basis =
      chosen<const char*>(basis_name, "basis", {{"power", "power"}, {"bernstein", "bernstein"}});
  const Vector<Polynomial> numerator{polynomial(x, "x", basis), polynomial(y, "y", basis),
                                     polynomial(z, "z", basis)};
  const Polynomial weight = w.is_none() ? Polynomial{1} : polynomial(w, "w", basis);
  if (weight.is_zero()) refuse("w", "it is 0", w);
  if (basis == "bernstein")
    for (const auto& [list, place] : {std::pair{y, "y"}, {z, "z"}, {w, "w"}})
      if (!list.is_none() && nb::len(list) != nb::len(x))
        refuse(place, "in the Bernstein basis it is as long as x: " + std::to_string(nb::len(x)),
               list);
  std::vector<GivenSegment> segments;
  try {
    segments.push_back({RationalCurve(numerator, weight), "x"});
  } catch (const DomainError& error) {
    refuse(w.is_none() ? "x" : "w", error.what(), w.is_none() ? x : w);
  }
  return made_of(name, segments, "x", x);
}

/// A number or the text of a function of the variable, which is learnt from the first that has one.
Formula formula(nb::handle x, const char* place, std::optional<std::string>& variable,
                bool is_constant = false) {
  if (PyUnicode_Check(x.ptr()) == 0) return {rational(x, place)};
  try {
    auto given = parse_formula(text(x, place), is_constant ? "" : variable);
    if (!is_constant && !variable && !given.variable.empty()) variable = given.variable;
    return std::move(given.value);
  } catch (const InputError& error) {
    refuse(place, error.what(), x);
  }
}

nb::object expressions(nb::handle x, nb::handle y, nb::handle z, nb::handle lower, nb::handle upper,
                       nb::handle variable, const Text<"name">& name) {
  std::optional<std::string> letter;
  if (!variable.is_none()) {
    letter = text(variable, "variable");
    if (letter->empty()) refuse("variable", "it is empty", variable);
  }
  // One after the other: the first that has a variable names it.
  Formula first = formula(x, "x", letter);
  Formula second = formula(y, "y", letter);
  Formula third = formula(z, "z", letter);
  const Vector<Formula> r{std::move(first), std::move(second), std::move(third)};
  const Formula from = formula(lower, "lower", letter, true);
  const Formula to = formula(upper, "upper", letter, true);
  std::vector<GivenSegment> segments;
  try {
    segments = without_gil([=, s = letter.value_or("s")]() -> std::vector<GivenSegment> {
      if (auto curve = rational_form(r, from, to, s)) return {{*std::move(curve), "x"}};
      return {{ExpressionCurve(r, from, to, s), "x"}};
    });
  } catch (const DomainError& error) {
    const std::string reason = error.what();  // "z has a pole at s = 1", or of all three
    for (const auto& [letter_of, of] : {std::pair("x", x), std::pair("y", y), std::pair("z", z)})
      if (reason.starts_with(std::string(letter_of) + " ")) refuse(letter_of, reason.substr(2), of);
    refuse("x, y, z", reason, x);
  }
  return made_of(name, segments, "x", x);
}

std::vector<Rational> spline_parameters(const CubicInterpolation& data, nb::handle points,
                                        nb::handle parameters, const std::string& spacing) {
  const auto choice = chosen<ParameterChoice>(spacing, "spacing",
                                              {{"chord-length", ParameterChoice::chord_lengths},
                                               {"uniform", ParameterChoice::uniform},
                                               {"centripetal", ParameterChoice::centripetal}});
  if (parameters.is_none()) {
    try {
      return parameters_of(data.points, choice);
    } catch (const DomainError& error) {
      refuse("points", error.what(), points);
    }
  }
  auto given = rationals(parameters, "parameters");
  if (given.size() != data.points.size())
    refuse("parameters",
           std::to_string(given.size()) + " for " + std::to_string(data.points.size()) + " points",
           parameters);
  for (std::size_t k = 1; k < given.size(); ++k)
    if (given[k] <= given[k - 1])
      refuse("parameters[" + std::to_string(k) + "]", "it does not increase", parameters);
  return given;
}

nb::object cubic_spline(nb::handle points, nb::handle parameters, const Text<"ends">& ends,
                        const Text<"spacing">& spacing, nb::handle start_derivative,
                        nb::handle end_derivative, const Text<"name">& name) {
  CubicInterpolation data{given_points(points, "points", 2), {}};
  data.ends = chosen<SplineEnds>(ends, "ends",
                                 {{"natural", SplineEnds::natural},
                                  {"clamped", SplineEnds::clamped},
                                  {"periodic", SplineEnds::periodic}});
  if (data.ends == SplineEnds::periodic && data.points.front() != data.points.back())
    data.points.push_back(data.points.front());
  data.parameters = spline_parameters(data, points, parameters, spacing);
  const bool is_clamped = data.ends == SplineEnds::clamped;
  for (const auto& [given, place] :
       {std::pair{start_derivative, "start_derivative"}, {end_derivative, "end_derivative"}})
    if (given.is_none() == is_clamped)
      refuse(place, is_clamped ? "clamped ends want it" : "it is of clamped ends", given);
  if (is_clamped) {
    data.start_derivative = given_point(start_derivative, "start_derivative");
    data.end_derivative = given_point(end_derivative, "end_derivative");
  }
  std::vector<BezierPiece> pieces;
  try {
    pieces = without_gil([data] {
      const auto derivatives = cubic_derivatives(data);
      std::vector<BezierPiece> all;
      for (std::size_t k = 0; k + 1 < data.points.size(); ++k)
        all.push_back(
            {{cubic_piece(data, derivatives, k)}, data.parameters[k], data.parameters[k + 1]});
      return all;
    });
  } catch (const DomainError& error) {
    refuse("points", error.what(), points);
  }
  return path_of_beziers(name, pieces, "points", points);
}

}  // namespace

void bind_any_curves(PathClass& path) {
#define PHRAME_LIST "Polynomial | collections.abc.Sequence[Number]"
  path.def_static("bezier", bezier, argument("points"), argument("weights") = nb::none(),
                  nb::kw_only(), argument("name") = "",
                  nb::sig("def bezier(points: Vectors, weights: Numbers | None = None, *, name: "
                          "str = '') -> Path"),
                  "The Bézier curve of these control points, rational where there are weights; "
                  "known to be PH where it is.")
      .def_static("polyline", polyline, argument("points"), nb::kw_only(),
                  argument("closed") = false, argument("name") = "",
                  nb::sig("def polyline(points: Vectors, *, closed: bool = False, name: str = '') "
                          "-> Path"),
                  "The lines from point to point, and back to the first where it is closed.")
      .def_static(
          "nurbs", nurbs, argument("points"), argument("weights") = nb::none(),
          argument("knots") = nb::none(), argument("degree") = 3, nb::kw_only(),
          argument("name") = "",
          nb::sig("def nurbs(points: Vectors, weights: Numbers | None = None, knots: Numbers | "
                  "None = None, degree: int = 3, *, name: str = '') -> Path"),
          "The B-spline of these control points, rational where there are weights. The knots are "
          "one more than points and degree together, or one less, without the outermost two; "
          "without knots they are clamped and equally spaced.")
      .def_static("polynomial", polynomial_curve, argument("x"), argument("y"),
                  argument("z") = nb::make_tuple(0), argument("w") = nb::none(), nb::kw_only(),
                  argument("name") = "", argument("basis") = "power",
                  nb::sig("def polynomial(x: " PHRAME_LIST ", y: " PHRAME_LIST ", z: " PHRAME_LIST
                          " = (0,), w: " PHRAME_LIST
                          " | None = None, *, name: str = '', basis: str = 'power') "
                          "-> Path"),
                  "The curve (x, y, z)/w for t from 0 to 1, of lists of coefficients.")
      .def_static(
          "expressions", expressions, argument("x"), argument("y"), argument("z"),
          argument("lower"), argument("upper"), nb::kw_only(), argument("variable") = nb::none(),
          argument("name") = "",
          nb::sig("def expressions(x: Number, y: Number, z: Number, lower: Number, upper: Number, "
                  "*, variable: str | None = None, name: str = '') -> Path"),
          "The curve of three formulas such as \"cos(3*s)\" of one variable, from `lower` to "
          "`upper`, which may be \"2*pi\".")
      .def_static(
          "cubic_spline", cubic_spline, argument("points"), nb::kw_only(),
          argument("parameters") = nb::none(), argument("ends") = "natural",
          argument("spacing") = "chord-length", argument("start_derivative") = nb::none(),
          argument("end_derivative") = nb::none(), argument("name") = "",
          nb::sig("def cubic_spline(points: Vectors, *, parameters: Numbers | None = None, ends: "
                  "str = 'natural', spacing: str = 'chord-length', start_derivative: Vector | "
                  "None = None, end_derivative: Vector | None = None, name: str = '') "
                  "-> Path"),
          "The C² cubic spline through points, which is no PH curve as a rule; `ends` is natural, "
          "clamped or periodic, `spacing` chord-length, uniform or centripetal.");
#undef PHRAME_LIST
}

}  // namespace phrame::python
