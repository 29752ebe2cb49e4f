#include <algorithm>

#include "frame_source.hpp"
#include "jobs.hpp"
#include "paths.hpp"

namespace phrame::python {
namespace {

FrameKind frame_kind(const std::string& name) {
  return chosen<FrameKind>(
      name, "kind",
      {{"rmf", FrameKind::rmf}, {"erf", FrameKind::erf}, {"frenet", FrameKind::frenet}});
}

bool is_by_arc_length(const std::string& by) {
  return chosen<bool>(by, "by", {{"parameter", false}, {"arc_length", true}});
}

/// A place on a path with its frame, which a source computes when it is asked for.
struct SourcePlace {
  const FrameSource& source;
  const Parameters& at;
  std::size_t k;

  Frame<double> frame() const { return source.frame(at, k); }
  Vector<double> point() const { return source.point(at, k); }
  std::array<double, 4> quaternion() const { return source.quaternion(at, k); }
};

/// The same from a row of a table: t, r, e₁, f₂, f₃.
struct TablePlace {
  const double* row;

  Vector<double> vector(std::size_t k) const { return {row[k], row[k + 1], row[k + 2]}; }
  Frame<double> frame() const { return {vector(4), vector(7), vector(10)}; }
  Vector<double> point() const { return vector(1); }
};

constexpr std::size_t many = 1024;

std::size_t product(const std::vector<std::size_t>& shape) {
  std::size_t n = 1;
  for (const std::size_t k : shape) n *= k;
  return n;
}

/// The array of write(place, out) for the places of a path at the parameters ts.
template <class Write>
nb::object by_parameter(const PathObject& self, FrameKind kind, const FrameStart& start,
                        nb::handle ts, nb::handle progress, std::vector<std::size_t> shape,
                        const Write& write) {
  const Path& path = self.named.path;
  const auto at = std::make_shared<Parameters>(parameters(ts, "ts"));
  for (std::size_t k = 0; k < at->size() && !path.is_curve(); ++k)
    if (const Rational t = (*at)[k]; t < 0 || t > path.end())
      refuse("ts[" + std::to_string(k) + "]",
             to_string(t) + " is outside [0, " + to_string(path.end()) + "]", ts);
  const auto source = std::make_shared<FrameSource>(
      path, kind, kind == FrameKind::rmf ? start_angle(start, path) : FrameAngle());
  const std::size_t width = product(shape);
  shape.insert(shape.begin(), at->size());
  const auto numbers = std::make_shared<std::vector<double>>(product(shape));
  run({.n = at->size(),
       .grain = at->are_doubles() ? many : 16,
       .prepare = [source, at] { source->prepare(*at); },
       .work =
           [source, at, numbers, width, write](std::size_t from, std::size_t to) {
             for (std::size_t k = from; k < to; ++k)
               write(SourcePlace{*source, *at, k}, numbers->data() + k * width);
           }},
      progress);
  return array(numbers, shape);
}

/// The same at the places where the arc length from the start is s.
template <class Write>
nb::object by_arc_length(const PathObject& self, FrameKind kind, const FrameStart& start,
                         nb::handle s, nb::handle progress, std::vector<std::size_t> shape,
                         const Write& write) {
  const auto at = std::make_shared<Parameters>(parameters(s, "ts"));
  const TabulatedFrame frame = kind == FrameKind::rmf   ? TabulatedFrame::rmf
                               : kind == FrameKind::erf ? TabulatedFrame::euler_rodrigues
                                                        : TabulatedFrame::frenet;
  TableColumns columns{.frames = {frame}};
  columns.start = start;
  const std::size_t width = product(shape);
  shape.insert(shape.begin(), at->size());
  const auto numbers = std::make_shared<std::vector<double>>(product(shape));
  run({.n = at->size(),
       .grain = 16,
       .work =
           [path = self.named.path, columns, at, numbers, write, width](std::size_t from,
                                                                        std::size_t to) {
             const PathLength length(path);
             std::vector<PathPoint> points;
             for (std::size_t k = from; k < to; ++k) points.push_back(length.point((*at)[k]));
             const FrameTable table = frame_table(path, columns, points);
             for (std::size_t k = from; k < to; ++k)
               write(TablePlace{table.rows[k - from].data()}, numbers->data() + k * width);
           }},
      progress);
  return array(numbers, shape);
}

/// A function (self, ts, start, start_normal, kind, by, progress) that makes arrays of this shape.
template <class Write>
auto tabulated(const std::vector<std::size_t>& shape, const Write& write) {
  return [=](const PathObject& self, nb::handle ts, nb::handle start, nb::handle start_normal,
             const std::string& kind_name, const std::string& by, nb::handle progress) {
    const FrameKind kind = frame_kind(kind_name);
    const FrameStart from =
        frame_start(start, start_normal, self.named.path, Reference::euler_rodrigues);
    return is_by_arc_length(by) ? by_arc_length(self, kind, from, ts, progress, shape, write)
                                : by_parameter(self, kind, from, ts, progress, shape, write);
  };
}

void write_rows(const Frame<double>& f, double* out) {
  for (const auto* v : {&f.e1, &f.e2, &f.e3}) out = std::copy(v->begin(), v->end(), out);
}

/// A matrix with the columns e₁, f₂, f₃, r; (0, 0, 0, 1) below.
void write_pose(const Frame<double>& f, const Vector<double>& r, double* out) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array row{f.e1[i], f.e2[i], f.e3[i], r[i]};
    out = std::copy(row.begin(), row.end(), out);
  }
  const std::array<double, 4> last{0, 0, 0, 1};
  std::copy(last.begin(), last.end(), out);
}

nb::object quaternions(const PathObject& self, nb::handle ts, nb::handle start,
                       nb::handle start_normal, nb::handle progress) {
  const FrameStart from =
      frame_start(start, start_normal, self.named.path, Reference::euler_rodrigues);
  return by_parameter(self, FrameKind::rmf, from, ts, progress, {4},
                      [](const SourcePlace& place, double* out) {
                        const auto q = place.quaternion();
                        std::copy(q.begin(), q.end(), out);
                      });
}

}  // namespace

nb::object angles(const PathAngle& angle, const FrameAngle& start, nb::handle ts,
                  nb::handle progress) {
  auto at = std::make_shared<Parameters>(parameters(ts, "ts"));
  auto numbers = std::make_shared<std::vector<double>>(at->size());
  auto compiled = std::make_shared<std::optional<CompiledAngle>>();
  const auto prepare = [=] {
    if (!at->are_doubles() || at->size() < least_compiled) return;
    const auto [from, to] = std::minmax_element(at->doubles.begin(), at->doubles.end());
    try {
      if (angle.path().is_curve() && *from < *to)
        compiled->emplace(angle.segment(0), *from, *to, start);
      else if (!angle.path().is_curve())
        compiled->emplace(angle, start);
    } catch (const Undecided&) {
      // Poles of θ′ are too near: all angles are computed exactly.
    }
  };
  run({.n = at->size(),
       .grain = at->are_doubles() && at->size() >= least_compiled ? many : 1,
       .prepare = prepare,
       .work =
           [=](std::size_t from, std::size_t to) {
             std::optional<CompiledAngle> mine = *compiled;  // it counts, so that each has its own
             for (std::size_t k = from; k < to; ++k)
               (*numbers)[k] = finite(mine ? (*mine)(at->doubles[k])
                                           : round_to_double(angle.value((*at)[k], start)));
           }},
      progress);
  return array(numbers, {at->size()});
}

#define PHRAME_ARRAY "numpy.typing.NDArray[numpy.float64]"
#define PHRAME_TS "ts: Numbers"
#define PHRAME_PROGRESS "progress: collections.abc.Callable[[int, int], object] | None = None"

void bind_arrays(nb::class_<PathObject>& path) {
  path.def(
          "frames",
          tabulated({3, 3}, [](const auto& place, double* out) { write_rows(place.frame(), out); }),
          nb::arg("ts"), nb::kw_only(), PHRAME_START_PARAMETERS, nb::arg("kind") = "rmf",
          nb::arg("by") = "parameter", nb::arg("progress") = nb::none(),
          nb::sig("def frames(self, " PHRAME_TS ", *, " PHRAME_START_SIG
                  ", kind: str = 'rmf', by: str = 'parameter', " PHRAME_PROGRESS
                  ") -> " PHRAME_ARRAY),
          "Frames as an array (n, 3, 3): [k, 0] is the tangent e1, [k, 1] and [k, 2] are f2, f3. "
          "Every number is correctly rounded. `kind` is rmf, erf or frenet; `by` is parameter or "
          "arc_length; a rotation-minimizing frame starts at the angle `start` to the "
          "Euler–Rodrigues frame or with f2 along `start_normal`.")
      .def("quaternions", quaternions, nb::arg("ts"), nb::kw_only(), PHRAME_START_PARAMETERS,
           nb::arg("progress") = nb::none(),
           nb::sig("def quaternions(self, " PHRAME_TS ", *, " PHRAME_START_SIG ", " PHRAME_PROGRESS
                   ") -> " PHRAME_ARRAY),
           "Rotation-minimizing frames as unit quaternions (x, y, z, w), scalar last as in SciPy, "
           "whose matrices have the columns e1, f2, f3; continuous along the path.")
      .def("matrices",
           tabulated({4, 4}, [](const auto& place,
                                double* out) { write_pose(place.frame(), place.point(), out); }),
           nb::arg("ts"), nb::kw_only(), PHRAME_START_PARAMETERS, nb::arg("kind") = "rmf",
           nb::arg("by") = "parameter", nb::arg("progress") = nb::none(),
           nb::sig("def matrices(self, " PHRAME_TS ", *, " PHRAME_START_SIG
                   ", kind: str = 'rmf', by: str = 'parameter', " PHRAME_PROGRESS
                   ") -> " PHRAME_ARRAY),
           "The same as an array (n, 4, 4) of matrices with the columns e1, f2, f3, r.")
      .def(
          "points",
          [write = tabulated({3},
                             [](const auto& place, double* out) {
                               const Vector<double> r = place.point();
                               std::copy(r.begin(), r.end(), out);
                             })](const PathObject& self, nb::handle ts, const std::string& by,
                                 nb::handle progress) {
            return write(self, ts, nb::none(), nb::none(), "erf", by, progress);
          },
          nb::arg("ts"), nb::kw_only(), nb::arg("by") = "parameter",
          nb::arg("progress") = nb::none(),
          nb::sig("def points(self, " PHRAME_TS ", *, by: str = 'parameter', " PHRAME_PROGRESS
                  ") -> " PHRAME_ARRAY),
          "r at each parameter, correctly rounded: an array (n, 3).");
}

}  // namespace phrame::python
