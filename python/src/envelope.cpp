#include "answers.hpp"
#include "offsets.hpp"

namespace phrame::inline v0::python {
namespace {

struct EnvelopeObject {
  EnvelopeAnswer found;
  nb::tuple paths;
  nb::object recipe;
};

nb::object envelope_of_file(const std::string& file, bool trim) {
  EnvelopeAnswer found = without_gil([=] { return answer(read_axis(file), EnvelopeQuery{trim}); });
  nb::tuple paths = tuple_of(all_paths(found));
  return nb::cast(EnvelopeObject{std::move(found), std::move(paths),
                                 remade("_envelope", nb::str(file.c_str()), trim)});
}

nb::object envelope_of(nb::handle axis, Flag<"trim"> trim) {
  const nb::object file = imported("phrame._offsets", "axis_file")(axis);
  try {
    return envelope_of_file(nb::cast<std::string>(file), trim);
  } catch (const InputError& error) {
    refuse("axis" + (error.place() == "/" ? "" : error.place()), error.reason(), axis);
  }
}

const EnvelopeAnswer& envelope_answer(nb::handle self) {
  return nb::cast<const EnvelopeObject&>(self).found;
}

const char* envelope_part_name(EnvelopePiece::Kind kind) {
  return kind == EnvelopePiece::Kind::right  ? "right"
         : kind == EnvelopePiece::Kind::left ? "left"
                                             : "arc";
}

nb::object envelope_segments(nb::handle self) {
  nb::list made;
  for (const EnvelopeAnswer::Segment& x : envelope_answer(self).segments) {
    nb::list lightlike;
    for (const RealAlgebraic& t : x.lightlike) lightlike.append(to_python(t));
    const auto& [u, v, p, q] = x.curve.preimage;
    const auto side = [](const EnvelopeAnswer::OneSide& of) {
      return of.curve ? wrap(NamedPath("", *of.curve)) : nb::object(nb::none());
    };
    made.append(record("EnvelopeSegment", x.degree,
                       nb::make_tuple(nb::cast(u), nb::cast(v), nb::cast(p), nb::cast(q)),
                       nb::cast(x.curve.multiplier), nb::tuple(nb::cast(x.null_factors)),
                       nb::cast(x.sigma), nb::tuple(lightlike), side(x.right), side(x.left)));
  }
  return nb::tuple(made);
}

nb::object envelope_branches(nb::handle self) {
  nb::list made;
  for (const EnvelopeAnswer::Branch& branch : envelope_answer(self).branches) {
    nb::list parts;
    for (const EnvelopeAnswer::Piece& x : branch.pieces) {
      const auto is_cut = [](const BoundaryEnd& end) {
        return !end.t.exact() || denominator(*end.t.exact()) != 1;
      };
      parts.append(part_record(x.from, x.to, envelope_part_name(x.kind), is_cut(x.from),
                               is_cut(x.to), [&](const char* end) {
                                 return within(self, "branches", made.size(), "parts", parts.size(),
                                               end);
                               }));
    }
    made.append(
        record("EnvelopeBranch", branch.is_closed, nb::tuple(parts), tuple_of(branch.paths)));
  }
  return nb::tuple(made);
}

nb::object envelope_undecided(nb::handle self) {
  nb::list made;
  for (const auto& x : envelope_answer(self).undecided)
    made.append(nb::make_tuple(to_decimal(x.t[0].value), to_decimal(x.t[1].value)));
  return nb::tuple(made);
}

}  // namespace

void bind_envelope(nb::module_& m) {
  m.def("_envelope", envelope_of_file);
  m.def(
      "envelope", envelope_of, argument("axis"), argument("trim") = false,
      nb::sig("def envelope(axis: str | os.PathLike[str] | dict[str, typing.Any] | Vectors | "
              "collections.abc.Sequence[Vectors], trim: bool = False) -> Envelope"),
      "The envelope of the discs along curves with radii, Minkowski PH curves: the name of an "
      "mph/1 file, a dict with what is in one, or rows of x, y, r, the control points of a curve, "
      "or a list of such. With `trim` what bounds the union of the discs: docs/minkowski.md.");
  auto type = nb::class_<EnvelopeObject>(
      m, "Envelope",
      "An envelope of discs, a sequence of the paths that it is: docs/minkowski.md.");
  using E = EnvelopeObject;
  bind_paths(type);
  type.def_prop_ro("segments", envelope_segments,
                   nb::sig("def segments(self) -> tuple[phrame._offsets.EnvelopeSegment, ...]"),
                   "Of the curves with radii: degree, preimage, multiplier, null_factors, sigma, "
                   "lightlike, right, left.")
      .def_prop_ro("branches", envelope_branches,
                   nb::sig("def branches(self) -> tuple[phrame._offsets.EnvelopeBranch, ...]"),
                   "Of one that is trimmed: is_closed, parts, paths.")
      .def_prop_ro("undecided", envelope_undecided,
                   nb::sig("def undecided(self) -> " PHRAME_RANGES_SIG),
                   "Ranges of t of which it is not told whether they are inside of a disc.")
      .def(
          "text", [](const E& e) { return for_reading(to_text(e.found), true); },
          "All of it, for reading.")
      .def(
          "latex", [](const E& e) { return to_latex(e.found); }, "For LaTeX.")
      .def(
          "json", [](const E& e) { return to_json(e.found); }, "envelope/1.")
      .def("__str__", [](const E& e) { return for_reading(to_text(e.found), false); })
      .def("__repr__", [](const E& e) {
        const std::size_t n = e.found.segments.size();
        const std::size_t parts = e.found.is_trimmed ? e.found.branches.size() : e.paths.size();
        return "<Envelope of " + std::to_string(n) + (n == 1 ? " curve" : " curves") +
               " with radii, " + std::to_string(parts) +
               (e.found.is_trimmed ? (parts == 1 ? " loop>" : " loops>")
                                   : (parts == 1 ? " path>" : " paths>"));
      });
  bind_python(type, "plot", "phrame._plot", "envelope",
              "def plot(self, *, ax: typing.Any = None, **style: typing.Any) -> typing.Any",
              "It, by Matplotlib; the axes.");
  bind_python(type, "_repr_html_", "phrame._show", "envelope_html", "def _repr_html_(self) -> str");
  bind_recipe(type);
}

}  // namespace phrame::python
