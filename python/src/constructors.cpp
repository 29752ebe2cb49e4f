#include "paths.hpp"

namespace phrame::inline v0::python {
namespace {

std::string basis_named(const std::string& name) {
  return chosen<const char*>(name, "basis", {{"power", "power"}, {"bernstein", "bernstein"}});
}

NamedPath of_preimage(QuaternionPolynomial a, nb::handle multiplier, nb::handle start,
                      const std::string& name, const std::string& basis) {
  Vector<Rational> from{};
  if (!start.is_none()) from = vector(start, "start");
  if (nb::isinstance<RationalFunction>(multiplier)) {
    const auto f = nb::cast<RationalFunction>(multiplier);
    return NamedPhPath(name,
                       at_argument("multiplier", [&] { return rational_ph_curve(a, f, from); }));
  }
  Polynomial f{1};
  if (!multiplier.is_none()) f = polynomial(multiplier, "multiplier", basis);
  return NamedPhPath(name, Curve(std::move(a), std::move(f), std::move(from)));
}

/// Lists in the Bernstein basis are of one degree.
NamedPath from_preimage(nb::handle u, nb::handle v, nb::handle p, nb::handle q,
                        nb::handle multiplier, nb::handle start, const Text<"name">& name,
                        const Text<"basis">& basis_name) {
  const std::string basis = basis_named(basis_name);
  if (basis == "bernstein")
    for (const auto& [list, place] : {std::pair{v, "v"}, {p, "p"}, {q, "q"}})
      if (nb::len(list) != nb::len(u))
        refuse(place, "in the Bernstein basis it is as long as u: " + std::to_string(nb::len(u)),
               list);
  return of_preimage({polynomial(u, "u", basis), polynomial(v, "v", basis),
                      polynomial(p, "p", basis), polynomial(q, "q", basis)},
                     multiplier, start, name, basis);
}

nb::object from_quaternions(nb::handle rows, nb::handle multiplier, nb::handle start,
                            const Text<"name">& name, const Text<"basis">& basis_name) {
  const std::string basis = basis_named(basis_name);
  std::array<std::vector<Rational>, 4> parts;
  std::size_t k = 0;
  for (const nb::handle row :
       python::rows(rows, "quaternions", "a list of quaternions", {"u", "v", "p", "q"})) {
    const std::string place = "quaternions[" + std::to_string(k++) + "]";
    const auto list = rationals(row, place);
    if (list.size() != 4)
      refuse(place, "4 numbers are wanted, there are " + std::to_string(list.size()), row);
    for (std::size_t i = 0; i < 4; ++i) parts[i].push_back(list[i]);
  }
  if (k == 0) refuse("quaternions", "there are none", rows);
  const auto made = [&](std::size_t i) {
    return basis == "power" ? Polynomial(parts[i]) : from_bernstein(parts[i]);
  };
  return wrap(of_preimage({made(0), made(1), made(2), made(3)}, multiplier, start, name, basis));
}

/// Lists of complex coefficients: (re, im) each, or numbers.
GaussianPolynomial complex_list(nb::handle list, const std::string& place,
                                const std::string& basis) {
  std::vector<Rational> re;
  std::vector<Rational> im;
  if (!is_list(list)) refuse_type(place, "a list of complex numbers or pairs (re, im)", list);
  for (const nb::handle x : nb::list(list)) {
    const std::string here = place + "[" + std::to_string(re.size()) + "]";
    if (!is_list(x) && nb::hasattr(x, "imag")) {
      re.push_back(rational(x.attr("real"), here));
      im.push_back(rational(x.attr("imag"), here));
      continue;
    }
    const auto pair = rationals(x, here);
    if (pair.size() != 2) refuse(here, "a pair (re, im) is wanted", x);
    re.push_back(pair[0]);
    im.push_back(pair[1]);
  }
  if (re.empty()) refuse(place, "there are no coefficients", list);
  if (basis == "power") return {Polynomial(re), Polynomial(im)};
  return {from_bernstein(re), from_bernstein(im)};
}

nb::object from_hopf(nb::handle alpha, nb::handle beta, nb::handle multiplier, nb::handle start,
                     const Text<"name">& name, const Text<"basis">& basis_name) {
  const std::string basis = basis_named(basis_name);
  if (basis == "bernstein" && nb::len(alpha) != nb::len(beta))
    refuse("beta", "in the Bernstein basis it is as long as alpha", beta);
  const HopfForm form{complex_list(alpha, "alpha", basis), complex_list(beta, "beta", basis)};
  return wrap(of_preimage(from_hopf_form(form), multiplier, start, name, basis));
}

nb::object from_complex(nb::handle w, nb::handle multiplier, nb::handle start,
                        const Text<"name">& name, const Text<"basis">& basis_name) {
  const std::string basis = basis_named(basis_name);
  return wrap(
      of_preimage(from_complex_root(complex_list(w, "w", basis)), multiplier, start, name, basis));
}

nb::object from_control_points(nb::handle points, const Text<"name">& name) {
  const auto given = given_points(points, "points", 2);
  auto found = without_gil([=] { return answer({name, bezier_hodograph(given), given.front()}); });
  if (auto* curve = std::get_if<Curve>(&found.result))
    return wrap(NamedPhPath(name, std::move(*curve)));
  std::string reason = "not a PH curve: " + to_string(std::get<NotPythagorean>(found.result));
  if (found.suggestion)
    reason += "; Path.near(points, " + distance_text(found.suggestion->epsilon) +
              ") has one that is at most " + distance_text(found.suggestion->distance) + " away";
  refuse("points", reason, points);
}

nb::object near(nb::handle points, nb::handle eps, const Text<"name">& name) {
  const auto given = given_points(points, "points", 2);
  const Rational epsilon = rational(eps, "eps");
  if (epsilon.sign() <= 0) refuse("eps", "it is not positive", eps);
  const auto found = without_gil([=] {
    const Vector<Polynomial> rate = bezier_hodograph(given);
    auto exact = identify(rate, given.front());
    if (auto* curve = std::get_if<Curve>(&exact))
      return std::variant<NearCurve, NotNear>(NearCurve{std::move(*curve), Nearness{}});
    return near_curve(rate, given.front(), epsilon);
  });
  if (const auto* none = std::get_if<NotNear>(&found)) refuse("eps", to_line(*none, epsilon), eps);
  const NearCurve& curve = std::get<NearCurve>(found);
  return wrap(
      NamedPhPath(name, curve.curve,
                  curve.nearness.epsilon == 0 ? std::nullopt : std::optional(curve.nearness)));
}

CurveKind kind_named(const std::string& name) {
  std::string names;
  for (const NamedKind& kind : curve_kinds()) {
    if (kind.name == name) return kind.kind;
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  refuse("kind", "\"" + abbreviated(name) + "\" is not one of " + names, nb::str(name.c_str()));
}

nb::object constructed(const GivenPoints& given, ConstructQuery query) {
  query.is_measured = false;  // the path is all that is kept
  try {
    auto found = without_gil([=] { return answer(given, query); });
    return wrap(std::move(found.path));
  } catch (const InputError& error) {
    if (!error.place().empty()) throw;
    refuse("kind", error.reason(), nb::none());
  }
}

std::vector<Vector<Rational>> as_many(nb::handle list, const std::string& place,
                                      const GivenPoints& given) {
  if (list.is_none()) return {};
  auto found = given_points(list, place, 0);
  if (found.size() != given.points.size())
    refuse(place,
           std::to_string(found.size()) + " for " + std::to_string(given.points.size()) + " points",
           list);
  return found;
}

/// How near, and which of several curves.
void choose_solution(ConstructQuery& query, nb::handle tolerance, nb::handle solution,
                     nb::handle select, nb::handle angles) {
  query.solution = count(solution, "solution", 1, 1000);
  if (!tolerance.is_none()) query.tolerance = rational(tolerance, "tolerance");
  if (query.tolerance <= 0 || query.tolerance >= 1)
    refuse("tolerance", "it is not between 0 and 1", tolerance);
  if (!select.is_none() && !angles.is_none())
    refuse("select", "it and angles exclude each other", select);
  if (query.kind != CurveKind::quintic && !(select.is_none() && angles.is_none()))
    refuse(select.is_none() ? "angles" : "select", "it is of the kind quintic", select);
  if (!select.is_none())
    query.choice = chosen<QuinticSelection>(text(select, "select"), "select",
                                            {{"auto", QuinticSelection::automatic},
                                             {"minimal", QuinticSelection::minimal},
                                             {"bv", QuinticSelection::bv},
                                             {"cc", QuinticSelection::cc},
                                             {"shortest", QuinticSelection::shortest},
                                             {"longest", QuinticSelection::longest},
                                             {"energy", QuinticSelection::energy}});
  if (angles.is_none()) return;
  if (!is_list(angles)) refuse_type("angles", "two or three angles", angles);
  std::vector<Angle> list;
  for (const nb::handle x : nb::list(angles))
    list.push_back(angle_number(x, "angles[" + std::to_string(list.size()) + "]"));
  const auto value = [&](std::size_t k) { return round_to_double(to_real(list[k])); };
  if (list.size() == 2)
    query.choice = FreeAngles{list[0], list[1]};
  else if (list.size() == 3)
    query.choice = SolutionAngles{value(0), value(1), value(2)};
  else
    refuse("angles", "two are wanted, Delta and phi, or three, phi0, phi1, phi2", angles);
}

/// No value without orientations.
std::optional<GivenPoses> poses_of(nb::handle orientations, const GivenPoints& given,
                                   const std::string& axis, bool is_smooth, nb::handle turns,
                                   bool is_closed) {
  GivenPoses poses{{}, tangent_axis(axis), {}, is_smooth};
  if (orientations.is_none()) {
    if (is_smooth) refuse("smooth_twist", "it is of orientations", nb::bool_(is_smooth));
    if (!turns.is_none()) refuse("turns", "they are of orientations", turns);
    return std::nullopt;
  }
  if (!given.derivatives.empty() || !given.tangents.empty())
    refuse("orientations", "they have tangents: derivatives and tangents are not taken beside them",
           orientations);
  poses.bodies = orientations_of(orientations, given.points.size());
  if (turns.is_none()) return poses;
  for (const Rational& x : rationals(turns, "turns")) {
    const std::string place = "turns[" + std::to_string(poses.turns.size()) + "]";
    if (denominator(x) != 1 || abs(x) > 1'000'000)
      refuse(place, "it is no whole number, at most a million", turns);
    poses.turns.push_back(static_cast<long>(numerator(x)));
  }
  const std::size_t n = given.points.size();
  if (poses.turns.size() != n - 1 && !(is_closed && poses.turns.size() == n))
    refuse("turns",
           std::to_string(poses.turns.size()) + " for " + std::to_string(n) + " points; " +
               std::to_string(n - 1) + " are wanted, or of a closed curve as many as points",
           turns);
  return poses;
}

/// Of the kind length.
std::vector<Rational> given_lengths(nb::handle lengths) {
  if (lengths.is_none()) return {};
  std::vector<Rational> found = is_list(lengths)
                                    ? rationals(lengths, "lengths")
                                    : std::vector<Rational>{rational(lengths, "lengths")};
  for (const Rational& x : found)
    if (x <= 0) refuse("lengths", "one is not positive", lengths);
  return found;
}

nb::object through(nb::handle points, nb::handle derivatives, nb::handle tangents,
                   nb::handle accelerations, nb::handle parameters, Flag<"closed"> closed,
                   const Text<"kind">& kind, Flag<"exact"> exact, nb::handle tolerance,
                   nb::handle solution, nb::handle select, nb::handle angles,
                   const Text<"name">& name, nb::handle orientations,
                   const Text<"tangent_axis">& axis, Flag<"smooth_twist"> is_smooth,
                   nb::handle turns, nb::handle lengths) {
  GivenPoints given;
  given.name = name;
  given.points = given_points(points, "points", 2);
  given.derivatives = as_many(derivatives, "derivatives", given);
  given.tangents = as_many(tangents, "tangents", given);
  given.accelerations = as_many(accelerations, "accelerations", given);
  given.poses = poses_of(orientations, given, axis, is_smooth, turns, closed);
  if (!parameters.is_none()) {
    given.parameters = rationals(parameters, "parameters");
    const std::size_t n = given.parameters.size();
    if (n != given.points.size() && !(closed && n == given.points.size() + 1))
      refuse("parameters",
             std::to_string(n) + " for " + std::to_string(given.points.size()) + " points",
             parameters);
    for (std::size_t k = 1; k < n; ++k)
      if (given.parameters[k] <= given.parameters[k - 1])
        refuse("parameters[" + std::to_string(k) + "]", "it does not increase", parameters);
  }
  for (std::size_t k = 0; k < given.tangents.size(); ++k)
    if (given.tangents[k] == Vector<Rational>{})
      refuse("tangents[" + std::to_string(k) + "]", "it is 0, which is no direction", tangents);
  if (given.derivatives.empty())
    for (std::size_t k = 1; k < given.points.size(); ++k)
      if (given.points[k] == given.points[k - 1])
        refuse("points[" + std::to_string(k) + "]", "it is the point before it", points);
  ConstructQuery query;
  query.kind = kind_named(kind);
  query.points = exact ? PointRule::exact : PointRule::near;
  query.is_closed = closed;
  query.lengths = given_lengths(lengths);
  choose_solution(query, tolerance, solution, select, angles);
  return constructed(given, query);
}

nb::object hermite(nb::handle p0, nb::handle d0, nb::handle p1, nb::handle d1, nb::handle a0,
                   nb::handle a1, const Text<"kind">& kind, Flag<"exact"> exact,
                   nb::handle tolerance, nb::handle solution, nb::handle select, nb::handle angles,
                   const Text<"name">& name, nb::handle length) {
  GivenPoints given;
  given.name = name;
  given.points = {given_point(p0, "p0"), given_point(p1, "p1")};
  given.derivatives = {given_point(d0, "d0"), given_point(d1, "d1")};
  ConstructQuery query;
  query.kind = kind_named(kind);
  query.points = exact ? PointRule::exact : PointRule::near;
  if (!length.is_none()) query.lengths = {rational(length, "length")};
  if (a0.is_none() != a1.is_none()) refuse(a0.is_none() ? "a0" : "a1", "it is wanted", a0);
  if (!a0.is_none()) given.accelerations = {given_point(a0, "a0"), given_point(a1, "a1")};
  choose_solution(query, tolerance, solution, select, angles);
  return constructed(given, query);
}

nb::object parsed(const std::string& bytes, nb::handle near, const FileReading& reading = {}) {
  if (!near.is_none()) {
    const Rational epsilon = rational(near, "near");
    if (epsilon.sign() <= 0) refuse("near", "it is not positive", near);
    auto found = at_place("near", [&] {
      return without_gil([=] {
        return reading.is_plain() && !curve_file_format(bytes).empty()
                   ? read_path_near(bytes, epsilon)
                   : near_path(read_any_path(bytes, {}, reading), epsilon);
      });
    });
    if (const auto* none = std::get_if<NotNear>(&found))
      refuse("near", to_line(*none, epsilon), near);
    return wrap(std::get<NamedPhPath>(found));
  }
  NamedPath read = [&] {
    try {
      return without_gil([bytes, reading] { return read_any_path(bytes, {}, reading); });
    } catch (const InputError& error) {
      if (error.place() == "--skip-invalid")
        refuse("skip_invalid", error.reason(), nb::bool_(reading.skips_invalid));
      if (error.place() == "--pick") refuse("pick", error.reason(), nb::cast(reading.pick));
      std::string reason = error.reason();
      for (const auto& [option, keyword] : {std::pair<std::string, std::string>("--pick", "pick="),
                                            {"--skip-invalid", "skip_invalid="}})
        if (const auto at = reason.find(option); at != std::string::npos)
          reason.replace(at, option.size(), keyword);
      throw InputError(error.place(), reason);
    }
  }();
  for (const std::string& note : read.notes)
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw nb::python_error();
  return wrap(std::move(read));
}

nb::object parse(nb::handle text, nb::handle near, Flag<"skip_invalid"> skip_invalid,
                 const Text<"pick">& pick) {
  const FileReading reading{skip_invalid, pick};
  if (PyBytes_Check(text.ptr()) != 0)
    return parsed(
        {PyBytes_AsString(text.ptr()), static_cast<std::size_t>(PyBytes_Size(text.ptr()))}, near,
        reading);
  if (PyUnicode_Check(text.ptr()) == 0) refuse_type("text", "a str or bytes", text);
  return parsed(python::text(text, "text"), near, reading);
}

nb::object read(nb::handle file, nb::handle near, Flag<"skip_invalid"> skip_invalid,
                const Text<"pick">& pick) {
  FileReading reading{skip_invalid, pick};
  reading.beside = files_beside(text(file_name(file, "file"), "file"));
  try {
    return parsed(bytes_of_file(file, "file"), near, reading);
  } catch (const InputError& error) {
    // Where it is not of an argument, but of a place in the file.
    const std::string name = nb::str(file).c_str();
    throw InputError(error.place().empty() ? name : name + ":" + error.place(), error.reason());
  }
}

/// Of the doubles that the object has.
nb::object from_scipy(nb::handle curve) {
  const nb::object text = imported("phrame._convert", "scipy_text")(curve);
  return parsed(python::text(text, "curve"), nb::none());
}

nb::object from_object(nb::handle curve) { return imported("phrame._foreign", "path")(curve); }

/// Paths one after the other.
NamedPath of_paths(nb::handle curves, const std::string& name) {
  if (PySequence_Check(curves.ptr()) == 0) refuse_type("curves", "a list of paths", curves);
  std::optional<Path> path;
  std::size_t k = 0;
  for (const nb::handle x : nb::list(curves)) {
    const std::string place = "curves[" + std::to_string(k++) + "]";
    try {
      for (const Segment& segment : path_argument(x, place).named.path.segments())
        if (path)
          path->append(segment);
        else
          path.emplace(segment);
    } catch (const DomainError& error) {
      refuse(place, error.what(), x);
    }
  }
  if (!path) refuse("curves", "there are none", curves);
  return {name, *std::move(path)};
}

#define PHRAME_CURVE_PARAMETERS                                                       \
  nb::kw_only(), argument("multiplier") = nb::none(), argument("start") = nb::none(), \
                 argument("name") = "", argument("basis") = "power"
#define PHRAME_CURVE_SIG                                                                      \
  "*, multiplier: Polynomial | RationalFunction | collections.abc.Sequence[Number] | None = " \
  "None, start: "                                                                             \
  "Vector | None = None, name: str = '', basis: str = 'power'"
#define PHRAME_CHOICE_SIG                                                                   \
  "tolerance: Number | None = None, solution: int = 1, select: str | None = None, angles: " \
  "collections.abc.Sequence[Number] | None = None"
#define PHRAME_LIST "Polynomial | collections.abc.Sequence[Number]"

}  // namespace

void bind_constructors(nb::module_& m, PathClass& path) {
#define PHRAME_PREIMAGE_SIG                                                     \
  "u: " PHRAME_LIST ", v: " PHRAME_LIST ", p: " PHRAME_LIST ", q: " PHRAME_LIST \
  ", " PHRAME_CURVE_SIG
  path.def(
          "__init__",
          [](PathObject* self, nb::handle curves, const Text<"name">& name) {
            new (self) PathObject(of_paths(curves, name));
          },
          argument("curves"), argument("name") = "",
          nb::sig("def __init__(self, curves: collections.abc.Sequence[Path], name: str = '') -> "
                  "None"),
          "Paths one after the other, position and tangent checked to be continuous; or the PH "
          "curve that from_preimage() makes.")
      .def(
          "__init__",
          [](PathObject* self, nb::handle u, nb::handle v, nb::handle p, nb::handle q,
             nb::handle multiplier, nb::handle start, const Text<"name">& name,
             const Text<"basis">& basis) {
            new (self) PathObject(from_preimage(u, v, p, q, multiplier, start, name, basis));
          },
          argument("u"), argument("v"), argument("p"), argument("q"), PHRAME_CURVE_PARAMETERS,
          nb::sig("def __init__(self, " PHRAME_PREIMAGE_SIG ") -> None"))
      .def_static(
          "from_preimage",
          [](nb::handle u, nb::handle v, nb::handle p, nb::handle q, nb::handle multiplier,
             nb::handle start, const Text<"name">& name, const Text<"basis">& basis) {
            return wrap(from_preimage(u, v, p, q, multiplier, start, name, basis));
          },
          argument("u"), argument("v"), argument("p"), argument("q"), PHRAME_CURVE_PARAMETERS,
          nb::sig("def from_preimage(" PHRAME_PREIMAGE_SIG ") -> Path"),
          "The PH curve of the components of the preimage A = u + vi + pj + qk, each a list of "
          "coefficients.")
      .def_static("from_quaternions", from_quaternions, argument("quaternions"),
                  PHRAME_CURVE_PARAMETERS,
                  nb::sig("def from_quaternions(quaternions: collections.abc.Sequence["
                          "collections.abc.Sequence[Number]], " PHRAME_CURVE_SIG ") -> Path"),
                  "Of the coefficients (u, v, p, q) of A.")
      .def_static(
          "from_hopf", from_hopf, argument("alpha"), argument("beta"), PHRAME_CURVE_PARAMETERS,
          nb::sig("def from_hopf(alpha: collections.abc.Sequence[complex | "
                  "collections.abc.Sequence[Number]], beta: collections.abc.Sequence[complex "
                  "| collections.abc.Sequence[Number]], " PHRAME_CURVE_SIG ") -> Path"),
          "Of A = α + kβ: pairs (re, im) of coefficients of α = u + iv, β = q + ip.")
      .def_static(
          "from_complex", from_complex, argument("w"), PHRAME_CURVE_PARAMETERS,
          nb::sig("def from_complex(w: collections.abc.Sequence[complex | "
                  "collections.abc.Sequence[Number]], " PHRAME_CURVE_SIG ") -> Path"),
          "The plane PH curve x′ + iy′ = f·w² of numbers or pairs (re, im), the coefficients "
          "of w.")
      .def_static("from_control_points", from_control_points, argument("points"),
                  argument("name") = "",
                  nb::sig("def from_control_points(points: Vectors, name: str = '') -> Path"),
                  "The Bézier curve with these points, if it is PH, exactly.")
      .def_static("near", near, argument("points"), argument("eps"), argument("name") = "",
                  nb::sig("def near(points: Vectors, eps: Number, name: str = '') -> Path"),
                  "An exact PH curve whose control points are at most eps from those given.")
      .def_static(
          "hermite", hermite, argument("p0"), argument("d0"), argument("p1"), argument("d1"),
          nb::kw_only(), argument("a0") = nb::none(), argument("a1") = nb::none(),
          argument("kind") = "quintic", argument("exact") = false,
          argument("tolerance") = nb::none(), argument("solution") = 1,
          argument("select") = nb::none(), argument("angles") = nb::none(), argument("name") = "",
          argument("length") = nb::none(),
          nb::sig("def hermite(p0: Vector, d0: Vector, p1: Vector, d1: Vector, *, a0: Vector | "
                  "None = None, a1: Vector | None = None, kind: str = 'quintic', exact: bool = "
                  "False, " PHRAME_CHOICE_SIG
                  ", name: str = '', length: Number | None = None) -> Path"),
          "From p0 to p1 with the derivatives d0 and d1 and, of the kind c2-hermite, the second "
          "ones a0 and a1; of most kinds one curve. The kind length has the `length` that is "
          "given, "
          "and of d0 and d1 the directions.")
      .def_static(
          "through", through, argument("points"), nb::kw_only(),
          argument("derivatives") = nb::none(), argument("tangents") = nb::none(),
          argument("accelerations") = nb::none(), argument("parameters") = nb::none(),
          argument("closed") = false, argument("kind") = "quintic", argument("exact") = false,
          argument("tolerance") = nb::none(), argument("solution") = 1,
          argument("select") = nb::none(), argument("angles") = nb::none(), argument("name") = "",
          argument("orientations") = nb::none(), argument("tangent_axis") = "x",
          argument("smooth_twist") = false, argument("turns") = nb::none(),
          argument("lengths") = nb::none(),
          nb::sig("def through(points: Vectors, *, derivatives: Vectors | None = None, "
                  "tangents: Vectors | None = None, accelerations: Vectors | None = None, "
                  "parameters: collections.abc.Sequence[Number] | None = None, closed: bool "
                  "= False, kind: str = 'quintic', exact: bool = False, " PHRAME_CHOICE_SIG
                  ", name: str = '', orientations: typing.Any = None, tangent_axis: str = 'x', "
                  "smooth_twist: bool = False, turns: collections.abc.Sequence[int] | None = None, "
                  "lengths: Number | collections.abc.Sequence[Number] | None = None) -> Path"),
          "A spline of exact PH curves through points: docs/construct.md names the kinds. Of the "
          "kind length `lengths` are those of the segments, or one of the whole. With "
          "`orientations`, quaternions (x, y, z, w), matrices or a Rotation of SciPy, the frame of "
          "its twist() meets them, and their axis `tangent_axis` is the tangent: docs/poses.md.")
#define PHRAME_READ_SIG \
  ", near: Number | None = None, *, skip_invalid: bool = False, pick: str = '') -> Path"
#define PHRAME_READ_PARAMETERS                                                    \
  argument("near") = nb::none(), nb::kw_only(), argument("skip_invalid") = false, \
  argument("pick") = ""
      .def_static("read", read, argument("file"), PHRAME_READ_PARAMETERS,
                  nb::sig("def read(file: str | os.PathLike[str]" PHRAME_READ_SIG),
                  "The path that a file of any format has (docs/curve-files.md). With `near`, "
                  "control points that are not PH are replaced by some at most so far away; "
                  "`skip_invalid` leaves out rows of tables that miss a number or repeat a point, "
                  "and `pick` names one of several curves.")
      .def_static("from_json", parse, argument("text"), PHRAME_READ_PARAMETERS,
                  nb::sig("def from_json(text: str | bytes" PHRAME_READ_SIG),
                  "The same of what such a file has in it.")
      .def_static("of", from_object, argument("curve"), nb::sig("def of(curve: object) -> Path"),
                  "The curve that an object of another package is: of scipy.interpolate (as "
                  "from_scipy), splipy, geomdl, rhino3dm, ezdxf, or, as a polyline, of shapely, "
                  "trimesh, pyvista.")
      .def_static("from_scipy", from_scipy, argument("curve"),
                  nb::sig("def from_scipy(curve: object) -> Path"),
                  "The curve of an object of scipy.interpolate with t, c and k (BSpline) or with c "
                  "and x (PPoly, CubicSpline), or of the list (t, c, k) of splprep, exactly.");
  m.def("read", read, argument("file"), PHRAME_READ_PARAMETERS,
        nb::sig("def read(file: str | os.PathLike[str]" PHRAME_READ_SIG), "Path.read.");
  m.def("parse", parse, argument("text"), PHRAME_READ_PARAMETERS,
        nb::sig("def parse(text: str | bytes" PHRAME_READ_SIG), "Path.from_json.");
}

}  // namespace phrame::python
