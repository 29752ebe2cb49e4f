#include <cmath>

#include "paths.hpp"

namespace phrame::inline v0::python {
namespace {

/// A table as a structured array, with its columns by name.
nb::object structured(const FrameTable& table) {
  const auto numbers = std::make_shared<DoubleArray>();
  for (const auto& row : table.rows) numbers->insert(numbers->end(), row.begin(), row.end());
  nb::list fields;
  for (const std::string& name : table.columns)
    fields.append(nb::make_tuple(name, imported("numpy", "float64")));
  return array(numbers, {table.rows.size(), table.columns.size()})
      .attr("view")(imported("numpy", "dtype")(fields))
      .attr("reshape")(-1);
}

/// Of the acceleration.
Feedrate::Limits motion_limits(nb::handle normal, nb::handle tangential, nb::handle start_speed,
                               nb::handle end_speed) {
  const auto limit = [](nb::handle x, const char* place) {
    if (x.is_none()) return std::optional<Rational>();
    const Rational value = rational(x, place);
    if (value <= 0) refuse(place, "it is not positive", x);
    return std::optional(value);
  };
  const auto speed = [&](nb::handle x, const char* place) {
    if (x.is_none()) return Rational(0);
    if (tangential.is_none()) refuse(place, "it needs max_tangential_acceleration", x);
    const Rational value = rational(x, place);
    if (value < 0) refuse(place, "it is negative", x);
    return value;
  };
  return {limit(normal, "max_normal_acceleration"),
          limit(tangential, "max_tangential_acceleration"), speed(start_speed, "start_speed"),
          speed(end_speed, "end_speed")};
}

nb::object interpolate(const PathObject& self, nb::handle feed, nb::handle period,
                       nb::handle normal, nb::handle tangential, nb::handle start_speed,
                       nb::handle end_speed) {
  InterpolationQuery query;
  query.period = rational(period, "period");
  if (query.period <= 0) refuse("period", "it is not positive", period);
  if (PyUnicode_Check(feed.ptr()) == 0) {
    query.feedrate.speed = RationalFunction(Polynomial{rational(feed, "feed")});
  } else {
    try {
      query.feedrate = parse_feedrate(text(feed, "feed"));
    } catch (const InputError& error) {
      refuse("feed", error.what(), feed);
    }
  }
  query.feedrate.limits = motion_limits(normal, tangential, start_speed, end_speed);
  try {
    return structured(without_gil([named = self.named, query] { return answer(named, query); }));
  } catch (const InputError& error) {
    refuse("period", error.reason(), period);
  }
}

double rounded_end(nb::handle x, const char* place) {
  const double found = round_to_double(rational(x, place));
  if (!std::isfinite(found)) refuse(place, "it is too large for a double", x);
  return found;
}

std::string prefix_of(nb::handle prefix, const std::string& name) {
  if (prefix.is_none()) return prefix_from(name);
  auto given = text(prefix, "prefix");
  if (!is_prefix(given))
    refuse(
        "prefix",
        "\"" + abbreviated(given) + "\" is not a letter followed by letters, digits and single _",
        prefix);
  return given;
}

std::string compile(const PathObject& self, nb::handle prefix, nb::handle frame, nb::handle start,
                    nb::handle start_normal, nb::handle lower, nb::handle upper, nb::handle up) {
  CompiledQuery query;
  query.reference = reference_named(frame, "frame", self, up);
  query.up = chosen_up(self, up, nb::none());
  query.start = frame_start(start, start_normal, StartRule::least_rotation, self.named.path,
                            *query.reference);
  query.from = rounded_end(lower, "lower");
  query.to = rounded_end(upper, "upper");
  const double length = query.to - query.from;
  if (!(length >= 0x1p-900) || length > 0x1p900)
    refuse("upper", "it is not greater than lower by 2^-900 to 2^900", upper);
  if (query.from != 0 || query.to != 1) {
    if (!self.ph || query.reference == Reference::up)
      refuse("lower", "a part is compiled of a PH curve, with its closed form", lower);
    if (!self.ph->path.is_curve()) refuse("lower", "a spline is compiled as a whole", lower);
  }
  const std::string name = prefix_of(prefix, self.named.name);
  return without_gil(
      [named = self.named, query, name] { return to_c_header(answer(named, query), name); });
}

std::vector<GivenFrame> given_frames(nb::handle ts, nb::handle f2) {
  if (ts.is_none() != f2.is_none()) refuse(ts.is_none() ? "ts" : "f2", "it is wanted", nb::none());
  std::vector<GivenFrame> frames;
  if (ts.is_none()) return frames;
  const auto at = rationals(ts, "ts");
  if (at.empty()) refuse("ts", "it is empty", ts);
  const auto rows = vectors(f2, "f2", 1);
  if (rows.size() != at.size())
    refuse("f2", std::to_string(rows.size()) + " for " + std::to_string(at.size()) + " parameters",
           f2);
  for (std::size_t k = 0; k < at.size(); ++k) frames.push_back({at[k], rows[k]});
  return frames;
}

void write_page(const NamedPath& named, PageQuery query, nb::handle samples, nb::handle file) {
  query.samples = count(samples, "samples", 3, 100'000);
  file_name(file, "file");
  if (!has_pages())
    throw DomainError(
        "page: this phrame was built without npm, which bundles what a page needs; where Node.js "
        "with "
        "npm and a network are there, pip install --force-reinstall --no-cache-dir builds it with "
        "pages");
  const std::string page = without_gil([=] { return to_page(answer(named, query)); });
  write_file(file, "file", page);
}

void page(const PathObject& self, nb::handle file, nb::handle ts, nb::handle f2, nb::handle samples,
          nb::handle start, nb::handle start_normal, nb::handle up) {
  PageQuery query;
  query.given = given_frames(ts, f2);
  const bool has_start = !start.is_none() || !start_normal.is_none();
  query.up = chosen_up(self, up, start);
  if (has_start)
    query.start = frame_start(start, start_normal, StartRule::least_rotation, self.named.path,
                              reference_of(self.named.path, query.up));
  write_page(self.named, query, samples, file);
}

}  // namespace

void bind_products(PathClass& path) {
  path.def("interpolate", interpolate, argument("feed"), argument("period"),
           argument("max_normal_acceleration") = nb::none(),
           argument("max_tangential_acceleration") = nb::none(),
           argument("start_speed") = nb::none(), argument("end_speed") = nb::none(),
           nb::sig("def interpolate(self, feed: Number, period: Number, "
                   "max_normal_acceleration: Number | None = None, "
                   "max_tangential_acceleration: Number | None = None, "
                   "start_speed: Number | None = None, end_speed: Number | None = None) -> "
                   "numpy.typing.NDArray[numpy.void]"),
           "The points of a motion with the speed `feed`, a number or a function of s, t or kappa "
           "as a text, at the times 0, period, …: a structured array with k, time, t, s, x, y, "
           "z. With a limit of the acceleration `feed` is the greatest speed, and the motion the "
           "fastest one; then, and with a feed of formulas, there is v, its speed, too.")
      .def("compile", compile, argument("prefix") = nb::none(), argument("frame") = nb::none(),
           PHRAME_START_PARAMETERS, argument("lower") = 0, argument("upper") = 1,
           argument("up") = nb::none(),
           nb::sig("def compile(self, prefix: str | None = None, frame: str | None = "
                   "None, " PHRAME_START_SIG
                   ", lower: Number = 0, upper: Number = 1, " PHRAME_UP_SIG ") -> str"),
           "A header in C that evaluates the angle and the frame in doubles, with proved errors: "
           "docs/compiled.md. `frame` is as that of angle(). A PH curve is compiled for t from "
           "`lower` to `upper`.")
      .def("page", page, argument("file"), argument("ts") = nb::none(), argument("f2") = nb::none(),
           nb::kw_only(), argument("samples") = 241, PHRAME_START_PARAMETERS,
           argument("up") = nb::none(),
           nb::sig("def page(self, file: str | os.PathLike[str], ts: Numbers | None = None, f2: "
                   "Vectors | None = None, *, samples: int = 241, " PHRAME_START_SIG
                   ", " PHRAME_UP_SIG ") -> None"),
           "Writes an HTML file that shows the path, its frames and what is known of it, beside "
           "the frames f2 that somebody else has at ts: docs/page.md.");
}

}  // namespace phrame::python
