#include "answers.hpp"

namespace phrame::inline v0::python {
namespace {

/// A list as it is now: what was given may change later.
nb::object kept(nb::handle list) {
  return list.is_none() ? nb::none() : imported("phrame._pickle", "kept")(list);
}

struct CheckObject {
  CheckAnswer found;
  nb::object recipe;
};

/// The frames and the tolerance, without where they start.
CheckQuery check_query(nb::handle ts, nb::handle f2, nb::handle f3, nb::handle tangents,
                       nb::handle tolerance) {
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
  query.options.tolerance = rational(tolerance, "tolerance");
  if (query.options.tolerance.sign() <= 0) refuse("tolerance", "it is not positive", tolerance);
  return query;
}

nb::object check(nb::handle self, nb::handle ts, nb::handle f2, nb::handle f3, nb::handle tangents,
                 nb::handle tolerance, nb::handle start, nb::handle start_normal, nb::handle up) {
  const PathObject& path = path_of(self);
  CheckQuery query = check_query(ts, f2, f3, tangents, tolerance);
  const bool has_start = !start.is_none() || !start_normal.is_none();
  query.options.up = chosen_up(path, up, start);
  if (has_start)
    query.options.start =
        frame_start(start, start_normal, StartRule::least_rotation, path.named.path,
                    reference_of(path.named.path, query.options.up));
  return nb::cast(
      CheckObject{without_gil([named = path.named, query] { return answer(named, query); }),
                  method_recipe(self, "check", kept(ts), kept(f2), kept(f3), kept(tangents),
                                tolerance, start, kept(start_normal), kept(up))});
}

}  // namespace

void bind_check(nb::module_& m, PathClass& path) {
  path.def(
      "check", check, argument("ts"), argument("f2"), argument("f3") = nb::none(),
      argument("tangents") = nb::none(), argument("tolerance") = "1e-6", PHRAME_START_PARAMETERS,
      argument("up") = nb::none(),
      nb::sig("def check(self, ts: Numbers, f2: Vectors, f3: Vectors | None = None, tangents: "
              "Vectors | None = None, tolerance: Number = '1e-6', " PHRAME_START_SIG
              ", " PHRAME_UP_SIG ") -> CheckResult"),
      "How far frames that another program has computed are from the rotation-minimizing one.");
  auto type = nb::class_<CheckObject>(m, "CheckResult", "The verdict on frames: docs/check.md.");
  using C = CheckObject;
  type.def_prop_ro(
          "passes", [](const C& c) { return c.found.verdict.passes; },
          "Are all errors within the tolerance?")
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
      .def_prop_ro(
          "worst_sample", [](const C& c) { return c.found.verdict.worst_sample; },
          "The number of the one with the greatest error.")
      .def_prop_ro(
          "summary", [](const C& c) { return summary(c.found); }, "The verdict in a line.")
      .def(
          "text", [](const C& c) { return for_reading(to_text(c.found, {}), true); },
          "All of it, for reading.")
      .def(
          "json", [](const C& c) { return to_json(c.found, {}); }, "check/1.")
      .def("__str__", [](const C& c) { return for_reading(to_text(c.found, {}), false); })
      .def("__repr__", [](const C& c) {
        return "<CheckResult: " + for_reading(summary(c.found), false) + ">";
      });
  bind_python(type, "_repr_html_", "phrame._show", "check_html", "def _repr_html_(self) -> str");
  bind_recipe(type);
}

}  // namespace phrame::python
