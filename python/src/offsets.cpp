#include "offsets.hpp"
#include "answers.hpp"

namespace phrame::inline v0::python {
namespace {

struct GaugeObject {
  NamedPath path;
  Gauge gauge;
};

/// All that is said of it is found when it is asked for, as cusps and self-intersections take
/// longer than the curves.
struct OffsetObject {
  NamedPath path;
  OffsetQuery query;
  nb::tuple paths;
  nb::object recipe;
  Lazy<OffsetAnswer> found = {};

  const OffsetAnswer& answer() const {
    const auto make = [path = path, query = query] { return phrame::answer(path, query); };
    without_gil([found = found, make] { return &found.get(make); });
    return found.get(make);
  }
};

struct OffsetCheckObject {
  OffsetCheckAnswer found;
  nb::object recipe;
};

Gauge gauge_along(const Path& path, const std::string& argument) {
  return at_argument(argument, [path] { return Gauge(path); });
}

nb::object gauge_of(nb::handle path) {
  const NamedPath named = path_argument(path, "path").named;
  return nb::cast(GaugeObject{named, gauge_along(named.path, "path")});
}

/// A Gauge, or the curve that it is.
std::optional<Gauge> asked_gauge(nb::handle x) {
  if (x.is_none()) return std::nullopt;
  if (nb::isinstance<GaugeObject>(x)) return nb::cast<const GaugeObject&>(x).gauge;
  if (!nb::isinstance<PathObject>(x)) refuse_type("gauge", "a Gauge or a Path", x);
  return gauge_along(path_of(x).named.path, "gauge");
}

Rational asked_distance(nb::handle distance) {
  const Rational d = rational(distance, "distance");
  if (d == 0) refuse("distance", "0 is no distance", distance);
  return d;
}

OffsetJoin asked_join(nb::handle join) {
  return chosen<OffsetJoin>(text(join, "join"), "join", offset_joins());
}

nb::object offset_of(nb::handle self, nb::handle distance, nb::handle join, Flag<"trim"> trim,
                     Flag<"pocket"> pocket, nb::handle gauge) {
  const NamedPath& named = path_of(self).named;
  OffsetQuery query{{asked_distance(distance)}, asked_join(join)};
  query.trim = trim.value;
  query.pocket = pocket.value;
  query.gauge = asked_gauge(gauge);
  require_plane(named.path, "path");
  const Lazy<OffsetAnswer> found;
  const bool is_report_wanted =
      query.trim || query.pocket || query.gauge || !named.path.with_preimages();
  const std::vector<Path> paths = without_gil([=] {
    if (is_report_wanted) return all_paths(found.get([&] { return answer(named, query); }));
    return phrame::paths(
        phrame::offset(*named.path.with_preimages(), query.distances.front(), query.join));
  });
  return nb::cast(OffsetObject{named, query, tuple_of(paths),
                               method_recipe(self, "offset", to_python(query.distances.front()),
                                             join, trim.value, pocket.value, gauge),
                               found});
}

nb::object near_ph(nb::handle self, nb::handle epsilon) {
  const Rational within = rational(epsilon, "epsilon");
  if (within.sign() <= 0) refuse("epsilon", "it is not positive", epsilon);
  return wrap(at_argument(
      "path", [=, named = path_of(self).named] { return near_ph_path(named, within); }));
}

const OffsetAnswer& offset_answer(nb::handle self) {
  return nb::cast<const OffsetObject&>(self).answer();
}

/// That of the offset that is not trimmed, if it is not.
const OffsetAnswer::Part* whole(nb::handle self) {
  const auto& offsets = offset_answer(self).offsets;
  return offsets.empty() ? nullptr : &offsets.front();
}

nb::object number(const OffsetAnswer::Measure& x, const nb::object& recipe) {
  return to_python(x.value, recipe);
}

/// Of all that it has, for each of `list`, what `make` makes of it and of its number.
template <class List, class F>
nb::tuple tuple_by(const List* list, const F& make) {
  nb::list made;
  if (list != nullptr)
    for (std::size_t k = 0; k < list->size(); ++k) made.append(make((*list)[k], k));
  return nb::tuple(made);
}

nb::object offset_cusps(nb::handle self) {
  const auto* part = whole(self);
  return tuple_by(part == nullptr ? nullptr : &part->cusps, [](const auto& cusp, std::size_t) {
    return record("OffsetCusp", to_python(cusp.t), cusp.turns_back, to_python(cusp.at));
  });
}

nb::object offset_meetings(nb::handle self) {
  const auto* part = whole(self);
  return tuple_by(part == nullptr ? nullptr : &part->meetings, [](const auto& x, std::size_t) {
    return record("OffsetMeeting",
                  nb::make_tuple(to_decimal(x.first.t.value), to_decimal(x.second.t.value)),
                  nb::make_tuple(x.first.is_join, x.second.is_join), to_python(x.at), x.touches);
  });
}

nb::object offset_coincident(nb::handle self) {
  const auto* part = whole(self);
  const auto range = [](const std::array<OffsetAnswer::Place, 2>& t) {
    return nb::make_tuple(to_decimal(t[0].t.value), to_decimal(t[1].t.value));
  };
  return tuple_by(part == nullptr ? nullptr : &part->coincident, [&](const auto& x, std::size_t) {
    return record("OffsetCoincidence", range(x.first), range(x.second),
                  nb::make_tuple(x.first[0].is_join, x.second[0].is_join));
  });
}

nb::object offset_stretches(nb::handle self) {
  const auto* part = whole(self);
  return tuple_by(part == nullptr ? nullptr : &part->stretches, [&](const auto& x, std::size_t k) {
    return record("OffsetStretch", to_python(x.from), to_python(x.to),
                  number(x.length, within(self, "stretches", k, "length")));
  });
}

nb::object offset_inner_corners(nb::handle self) {
  const auto* part = whole(self);
  return part == nullptr ? nb::object(nb::tuple()) : to_python(part->inner_corners);
}

nb::object offset_branches(nb::handle self) {
  nb::list made;
  for (const OffsetAnswer::Trimmed& trimmed : offset_answer(self).trimmed)
    for (const OffsetAnswer::Branch& branch : trimmed.branches) {
      const std::size_t n = made.size();
      const nb::tuple parts = tuple_by(&branch.pieces, [&](const auto& x, std::size_t k) {
        return part_record(
            x.from, x.to, x.is_join ? "join" : "offset", x.is_cut_from, x.is_cut_to,
            [&](const char* end) { return within(self, "branches", n, "parts", k, end); });
      });
      made.append(record(
          "OffsetBranch", to_python(trimmed.distance), branch.is_closed, parts,
          tuple_of(branch.paths), number(branch.length, within(self, "branches", n, "length")),
          branch.area ? number(*branch.area, within(self, "branches", n, "area")) : nb::none()));
    }
  return nb::tuple(made);
}

nb::object offset_undecided(nb::handle self) {
  nb::list made;
  const auto range = [](const std::array<Decimal, 2>& t) {
    return nb::make_tuple(to_decimal(t[0].value), to_decimal(t[1].value));
  };
  if (const auto* part = whole(self))
    for (const auto& x : part->undecided) {
      made.append(range(x.first));
      made.append(range(x.second));
    }
  for (const auto& trimmed : offset_answer(self).trimmed)
    for (const auto& x : trimmed.undecided) made.append(range(x.t));
  return nb::tuple(made);
}

bool offset_is_complete(nb::handle self) {
  const OffsetAnswer& found = offset_answer(self);
  return std::ranges::all_of(found.offsets,
                             [](const auto& x) { return x.undecided.empty() && !x.is_cut_off; }) &&
         std::ranges::all_of(found.trimmed, [](const auto& x) { return x.undecided.empty(); });
}

nb::object offset_two_sided(nb::handle self) {
  const auto& both = offset_answer(self).both;
  if (both.empty()) return nb::none();
  const TwoSidedOffset& x = both.front().offset;
  return record(
      "TwoSidedOffset",
      nb::make_tuple(nb::cast(x.parameter.numerator()), nb::cast(x.parameter.denominator())),
      nb::cast(x.numerator[0]), nb::cast(x.numerator[1]), nb::cast(x.weight), nb::cast(x.once));
}

/// Of all of it; of one that is trimmed the sum over its branches.
nb::object offset_length(nb::handle self) {
  if (const auto* part = whole(self)) return number(part->length, attribute_recipe(self, "length"));
  if (!offset_answer(self).both.empty())
    throw DomainError(
        "length: it is asked of PH paths, and under a gauge; path.length of the paths is another "
        "one");
  Real sum = Rational(0);
  for (const auto& trimmed : offset_answer(self).trimmed)
    for (const auto& branch : trimmed.branches) sum = sum + branch.length.value;
  return to_python(sum, attribute_recipe(self, "length"));
}

nb::object offset_area(nb::handle self) {
  if (const auto* part = whole(self))
    return part->area ? number(*part->area, attribute_recipe(self, "area")) : nb::none();
  Real sum = Rational(0);
  const auto& trimmed = offset_answer(self).trimmed;
  if (trimmed.size() != 1 || trimmed.front().branches.empty()) return nb::none();
  for (const auto& branch : trimmed.front().branches) {
    if (!branch.area) return nb::none();
    sum = sum + branch.area->value;
  }
  return to_python(sum, attribute_recipe(self, "area"));
}

nb::object offset_without(nb::handle self) {
  return tuple_by(&offset_answer(self).without, [](const GaugeOffsets::None& x, std::size_t) {
    return nb::make_tuple(x.segment, nb::tuple(nb::cast(x.degrees)));
  });
}

nb::object check_offset(nb::handle self, nb::handle given, nb::handle distance, nb::handle join,
                        Flag<"trim"> trim, nb::handle tolerance) {
  const NamedPath& named = path_of(self).named;
  OffsetCheckQuery query{
      asked_distance(distance), asked_join(join), trim.value, {}, rational(tolerance, "tolerance")};
  if (query.tolerance.sign() <= 0) refuse("tolerance", "it is not positive", tolerance);
  query.given = foreign_offset(given);
  return nb::cast(OffsetCheckObject{
      without_gil([=] { return answer(named, query); }),
      method_recipe(self, "check_offset", imported("phrame._pickle", "kept_offset")(given),
                    to_python(query.distance), join, trim.value, to_python(query.tolerance))});
}

nb::object checked_side(const OffsetCheckAnswer::Side& side) {
  const auto place = [](const OffsetCheckAnswer::Place& x) {
    return record("CheckedPlace", to_decimal(x.t.value), to_python(x.point));
  };
  const nb::tuple stretches = tuple_by(&side.stretches, [&](const auto& x, std::size_t) {
    return record("CheckedStretch", place(x.from), place(x.to), place(x.farthest),
                  to_python(x.at_least), x.is_proved);
  });
  return record("CheckedSide", nb::make_tuple(to_python(side.at_least), to_python(side.at_most)),
                place(side.farthest), stretches, side.count);
}

std::string offset_verdict(const OffsetCheckAnswer& found) {
  return found.passes ? "within" : found.is_decided ? "not within" : "not proved to be within";
}

void bind_gauge(nb::module_& m) {
  auto type = nb::class_<GaugeObject>(
      m, "Gauge",
      "A norm of the plane by its unit circle U(φ), a rational curve: docs/offsets.md.");
  using G = GaugeObject;
  m.def("_gauge", gauge_of, argument("path"));
  type.def_static(
          "of", gauge_of, argument("path"), nb::sig("def of(path: Path) -> Gauge"),
          "That of the whole curve of which this is a part, for φ from −∞ to ∞: closed, strictly "
          "convex, symmetric about (0, 0), in the plane z = 0.")
      .def_prop_ro(
          "path", [](const G& g) { return wrap(g.path); }, nb::sig("def path(self) -> Path"),
          "As given.")
      .def_prop_ro(
          "x", [](const G& g) { return g.gauge.x(); }, "X of U = (X, Y)/W.")
      .def_prop_ro(
          "y", [](const G& g) { return g.gauge.y(); }, "Y.")
      .def_prop_ro(
          "weight", [](const G& g) { return g.gauge.weight(); }, "W, without a real zero.")
      .def_prop_ro(
          "degree", [](const G& g) { return g.gauge.degree(); }, "Of U.")
      .def(
          "__eq__",
          [](const G& g, nb::handle other) {
            if (!nb::isinstance<G>(other)) return false;
            const Gauge& h = nb::cast<const G&>(other).gauge;
            return g.gauge.x() == h.x() && g.gauge.y() == h.y() && g.gauge.weight() == h.weight();
          },
          nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__",
           [](const G& g) {
             return nb::hash(nb::make_tuple(nb::cast(g.gauge.x()), nb::cast(g.gauge.y()),
                                            nb::cast(g.gauge.weight())));
           })
      .def("__repr__",
           [](const G& g) { return "<Gauge of degree " + std::to_string(g.gauge.degree()) + ">"; })
      .def(
          "__reduce__", [](const G& g) { return remade("_gauge", wrap(g.path)); },
          PHRAME_REDUCE_SIG);
  bind_copies(type);
}

void bind_offset(nb::module_& m) {
  auto type = nb::class_<OffsetObject>(
      m, "Offset",
      "An offset of a plane path, a sequence of the paths that it is: docs/offsets.md.");
  using O = OffsetObject;
  bind_paths(type);
  type.def_prop_ro(
          "path", [](const O& o) { return wrap(o.path); }, nb::sig("def path(self) -> Path"),
          "That it is the offset of.")
      .def_prop_ro(
          "distance", [](const O& o) { return to_python(o.query.distances.front()); },
          nb::sig("def distance(self) -> fractions.Fraction"), "d, > 0 to the right of travel.")
      .def_prop_ro("length", offset_length, nb::sig("def length(self) -> " PHRAME_REAL_SIG),
                   "Of all of it.")
      .def_prop_ro("area", offset_area, nb::sig("def area(self) -> " PHRAME_REAL_SIG " | None"),
                   "Signed, of a closed one.")
      .def_prop_ro("cusps", offset_cusps,
                   nb::sig("def cusps(self) -> tuple[phrame._offsets.OffsetCusp, ...]"),
                   "All of them: t, turns_back, point. None of one that is trimmed.")
      .def_prop_ro(
          "self_intersections", offset_meetings,
          nb::sig("def self_intersections(self) -> tuple[phrame._offsets.OffsetMeeting, ...]"),
          "Where it meets itself: t, on_joins, point, touches. None of one that is trimmed.")
      .def_prop_ro(
          "coincident", offset_coincident,
          nb::sig("def coincident(self) -> tuple[phrame._offsets.OffsetCoincidence, ...]"),
          "Where it runs along itself: first, second, on_joins. None of one that is trimmed.")
      .def_prop_ro("is_complete", offset_is_complete,
                   "Are these all there are, and is nothing undecided?")
      .def_prop_ro("undecided", offset_undecided,
                   nb::sig("def undecided(self) -> " PHRAME_RANGES_SIG),
                   "Ranges of t where it is not told whether branches meet.")
      .def_prop_ro("stretches", offset_stretches,
                   nb::sig("def stretches(self) -> tuple[phrame._offsets.OffsetStretch, ...]"),
                   "From cusp to cusp: start, end, length.")
      .def_prop_ro("inner_corners", offset_inner_corners,
                   nb::sig("def inner_corners(self) -> tuple[fractions.Fraction, ...]"),
                   "The t of corners at whose inner side it crosses itself.")
      .def_prop_ro("branches", offset_branches,
                   nb::sig("def branches(self) -> tuple[phrame._offsets.OffsetBranch, ...]"),
                   "Of one that is trimmed, or of a pocket: distance, is_closed, parts, paths, "
                   "length, area.")
      .def_prop_ro("two_sided", offset_two_sided,
                   nb::sig("def two_sided(self) -> phrame._offsets.TwoSidedOffset | None"),
                   "Of a curve that is not PH, where both sides are one rational curve: t, x, y, "
                   "weight, of m.")
      .def_prop_ro("without", offset_without,
                   nb::sig("def without(self) -> tuple[tuple[int, tuple[int, ...]], ...]"),
                   "Segments without a rational offset under the gauge, with the degrees in φ of "
                   "the factors of r′ × U′.")
      .def(
          "text", [](const O& o) { return for_reading(to_text(o.answer()), true); },
          "All of it, for reading.")
      .def(
          "latex", [](const O& o) { return to_latex(o.answer()); }, "For LaTeX.")
      .def(
          "json", [](const O& o) { return to_json(o.answer()); }, "offset/1.")
      .def("__str__", [](const O& o) { return for_reading(to_text(o.answer()), false); });
  bind_python(type, "marks", "phrame._plot", "marks",
              "def marks(self) -> dict[str, numpy.typing.NDArray[numpy.float64]]",
              "\"cusps\", \"self_intersections\" and \"cuts\" as points, (n, 2).");
  bind_python(type, "plot", "phrame._plot", "one_offset",
              "def plot(self, *, ax: typing.Any = None, **style: typing.Any) -> typing.Any",
              "It, by Matplotlib, as Path.plot_offset has it; the axes.");
  bind_python(type, "__repr__", "phrame._show", "offset_repr", "def __repr__(self) -> str");
  bind_python(type, "_repr_html_", "phrame._show", "offset_html", "def _repr_html_(self) -> str");
  bind_recipe(type);
}

void bind_offset_check(nb::module_& m) {
  auto type = nb::class_<OffsetCheckObject>(
      m, "OffsetCheck", "How far somebody else's offset is from the exact one: docs/offsets.md.");
  using C = OffsetCheckObject;
  type.def_prop_ro(
          "passes", [](const C& c) { return c.found.passes; },
          "Is all of both proved to be within the tolerance?")
      .def("__bool__", [](const C& c) { return c.found.passes; })
      .def_prop_ro(
          "is_decided", [](const C& c) { return c.found.passes || c.found.is_decided; },
          "If it does not pass, is it proved that it is not?")
      .def_prop_ro(
          "distance", [](const C& c) { return to_python(c.found.query.distance); },
          nb::sig("def distance(self) -> fractions.Fraction"), "As asked.")
      .def_prop_ro(
          "tolerance", [](const C& c) { return to_python(c.found.query.tolerance); },
          nb::sig("def tolerance(self) -> fractions.Fraction"), "As asked.")
      .def_prop_ro(
          "missing", [](const C& c) { return checked_side(c.found.missing); },
          nb::sig("def missing(self) -> phrame._offsets.CheckedSide"),
          "From the exact offset to what is given: distance, two bounds, farthest, stretches, "
          "number.")
      .def_prop_ro(
          "too_much", [](const C& c) { return checked_side(c.found.excess); },
          nb::sig("def too_much(self) -> phrame._offsets.CheckedSide"),
          "From what is given to the exact offset.")
      .def_prop_ro(
          "closed_polylines", [](const C& c) { return c.found.closed; },
          "How many polylines were closed, since all of the offset is.")
      .def(
          "text", [](const C& c) { return for_reading(to_text(c.found), true); },
          "All of it, for reading.")
      .def(
          "json", [](const C& c) { return to_json(c.found); }, "offset-check/1.")
      .def("__str__", [](const C& c) { return for_reading(to_text(c.found), false); })
      .def("__repr__", [](const C& c) {
        return "<OffsetCheck: " + offset_verdict(c.found) + " " +
               upper_bound_text(c.found.query.tolerance, 3) + ">";
      });
  bind_python(type, "_repr_html_", "phrame._show", "offset_check_html",
              "def _repr_html_(self) -> str");
  bind_recipe(type);
}

}  // namespace

nb::tuple tuple_of(const std::vector<Path>& paths) {
  nb::list list;
  for (const Path& path : paths) list.append(wrap(NamedPath("", path)));
  return nb::tuple(list);
}

nb::object to_python(const std::array<Decimal, 2>& point) {
  return nb::make_tuple(to_decimal(point[0].value), to_decimal(point[1].value));
}

ForeignOffset foreign_offset(nb::handle given) {
  ForeignOffset found;
  const auto add_polyline = [&](nb::handle list, const std::string& place) {
    std::vector<Vector<Rational>> line;
    for (const nb::handle row : rows(list, place, "a list of points, or a Path", {"x", "y"})) {
      const auto point = rationals(row, place + "[" + std::to_string(line.size()) + "]");
      if (point.size() != 2 && point.size() != 3)
        refuse(place, "points have x and y, or x, y and z", row);
      line.push_back({point[0], point[1], 0});
    }
    if (line.size() < 2) refuse(place, "two points are wanted at least", list);
    found.polylines.push_back(std::move(line));
  };
  const auto add = [&](nb::handle x, const std::string& place) {
    if (nb::isinstance<PathObject>(x))
      found.paths.push_back(path_of(x).named.path);
    else
      add_polyline(x, place);
  };
  const auto first_of = [](nb::handle x) -> nb::object {
    if (!is_list(x) || nb::isinstance<nb::dict>(x)) return nb::none();
    const nb::object first = nb::steal(PySequence_GetItem(x.ptr(), 0));
    if (!first.is_valid()) PyErr_Clear();
    return first.is_valid() ? first : nb::none();
  };
  const nb::object element = nb::isinstance<PathObject>(given) ? nb::none() : first_of(given);
  if (!nb::isinstance<PathObject>(element) && !is_list(first_of(element))) {
    add(given, "given");
    return found;
  }
  std::size_t k = 0;
  for (const nb::handle x : given) add(x, "given[" + std::to_string(k++) + "]");
  return found;
}

void bind_offsets(nb::module_& m, PathClass& path) {
  path.def("offset", offset_of, argument("distance"), argument("join") = "round",
           argument("trim") = false, argument("pocket") = false, argument("gauge") = nb::none(),
           nb::sig("def offset(self, distance: Number, join: str = \"round\", trim: bool = False, "
                   "pocket: bool = False, gauge: Gauge | Path | None = None) -> Offset"),
           "The exact offset of a PH path in a plane z = const, > 0 to the right of travel, as "
           "rational curves; several paths where corners are not joined or it turns back at a "
           "joint. `join` is \"round\", \"mitre\" or \"open\". With `trim` what is nearer to the "
           "path than |distance| is cut away, and the paths are the branches that are left, within "
           "17 digits of it where they are cut. With `pocket` they are those of a closed path at "
           "that distance inwards and at its multiples until nothing is left, one room after the "
           "other. With `gauge` the unit circle is another curve, and the path any rational one.")
      .def("near_ph", near_ph, argument("epsilon"),
           nb::sig("def near_ph(self, epsilon: Number) -> Path"),
           "A PH path in place of this one, of which no point is farther than epsilon from it, "
           "proved: itself where it is PH, one of the same degrees where there is one, and else, "
           "in a plane z = const, lines and quintics, as many as are needed.")
      .def("check_offset", check_offset, argument("given"), argument("distance"),
           argument("join") = "round", argument("trim") = false, argument("tolerance") = "1e-6",
           nb::sig("def check_offset(self, given: Path | Numbers | Vectors | "
                   "collections.abc.Sequence[Path | Vectors], "
                   "distance: Number, join: str = \"round\", trim: bool = False, tolerance: Number "
                   "= \"1e-6\") -> OffsetCheck"),
           "How far somebody else's offset is from the exact one, to both sides: a path or a "
           "polyline, or several.");
  bind_gauge(m);
  bind_offset(m);
  bind_offset_check(m);
}

}  // namespace phrame::python
