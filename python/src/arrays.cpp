#include "arrays.hpp"

#include "frame_source.hpp"
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
  std::array<double, 4> quaternion() const { return {row[13], row[14], row[15], row[16]}; }
};

/// The numbers that write(place, out) writes, `width` for each place of a path at a parameter.
template <class Write>
Numbers by_parameter(const PathObject& self, FrameKind kind, const FrameStart& start, nb::handle ts,
                     nb::handle progress, std::size_t width, const Write& write) {
  const PhPath& path = self.named.path;
  const auto at = std::make_shared<Parameters>(parameters(ts, "ts"));
  for (std::size_t k = 0; k < at->size() && !path.is_curve(); ++k)
    if (const Rational t = (*at)[k]; t < 0 || t > path.end())
      refuse("ts[" + std::to_string(k) + "]",
             as_written(t) + " is outside [0, " + to_string(path.end()) + "]", ts);
  const FrameAngle at_zero = kind == FrameKind::rmf ? start_angle(start, path) : FrameAngle();
  const auto source = self.sources->of(
      {kind, at_zero}, [&] { return std::make_shared<FrameSource>(path, kind, at_zero); });
  const auto numbers = std::make_shared<DoubleArray>(at->size() * width);
  const auto work = [source, at, numbers, width, write](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k)
      write(SourcePlace{*source, *at, k}, numbers->data() + k * width);
  };
  return filled(numbers, progress, source, at, at->are_doubles() ? many : 16, work);
}

/// The same at the places where the arc length from the start is s.
template <class Write>
Numbers by_arc_length(const PathObject& self, FrameKind kind, const FrameStart& start, nb::handle s,
                      nb::handle progress, std::size_t width, bool has_quaternions,
                      const Write& write) {
  const auto at = std::make_shared<Parameters>(parameters(s, "ts"));
  const TabulatedFrame frame = kind == FrameKind::rmf      ? TabulatedFrame::rmf
                               : kind == FrameKind::frenet ? TabulatedFrame::frenet
                                                           : TabulatedFrame::euler_rodrigues;
  TableColumns columns{.frames = {frame}};
  columns.start = start;
  columns.have_quaternions = has_quaternions;
  const auto numbers = std::make_shared<DoubleArray>(at->size() * width);
  run({.n = at->size(),
       .grain = 16,
       .work =
           [path = self.named.path, columns, at, numbers, write, width](std::size_t from,
                                                                        std::size_t to) {
             const PathLength length(path);
             std::vector<PathPoint> points;
             for (std::size_t k = from; k < to; ++k)
               points.push_back(at_place("ts[" + std::to_string(k) + "]",
                                         [&] { return length.point((*at)[k]); }));
             const FrameTable table = frame_table(path, columns, points);
             for (std::size_t k = from; k < to; ++k)
               write(TablePlace{table.rows[k - from].data()}, numbers->data() + k * width);
           }},
      progress);
  return numbers;
}

/// A function (self, ts, start, start_normal, kind, by, progress) that makes arrays of this shape.
template <class Write>
auto tabulated(const std::vector<std::size_t>& shape, const Write& write) {
  return [=](const PathObject& self, nb::handle ts, nb::handle start, nb::handle start_normal,
             const Text<"kind">& kind_name, const Text<"by">& by, nb::handle progress) {
    const std::size_t width = product(shape);
    const FrameKind kind = width == 3 ? FrameKind::none : frame_kind(kind_name);
    const FrameStart from =
        frame_start(start, start_normal, StartRule::least_rotation, self.named.path);
    const bool is_by_length = is_by_arc_length(by);
    const bool has_quaternions = width == 4;
    const Numbers numbers =
        is_by_length ? by_arc_length(self, kind, from, ts, progress, width, has_quaternions, write)
                     : by_parameter(self, kind, from, ts, progress, width, write);
    if (has_quaternions && (is_by_length || kind == FrameKind::frenet)) make_continuous(*numbers);
    std::vector<std::size_t> whole{numbers->size() / width};
    whole.insert(whole.end(), shape.begin(), shape.end());
    return array(numbers, whole);
  };
}

}  // namespace

void make_continuous(DoubleArray& quaternions) {
  const auto negate = [&](std::size_t from) {
    for (std::size_t i = from; i < from + 4; ++i)
      if (quaternions[i] != 0) quaternions[i] = -quaternions[i];
  };
  for (std::size_t at = 0; at < quaternions.size(); at += 4) {
    double product = 0;
    for (std::size_t i = at; at > 0 && i < at + 4; ++i)
      product += quaternions[i] * quaternions[i - 4];
    if (at == 0)
      for (std::size_t i = 0; i < 4; ++i)
        if (quaternions[i] != 0) product = quaternions[i];
    if (product < 0) negate(at);
  }
}

namespace {

/// Of the segments that have one.
using CompiledAngles = std::vector<std::optional<CompiledAngle>>;

/// Of those segments that are asked for often enough, where poles of θ′ are not too near.
CompiledAngles compiled_angles(const PathAngle& angle, const FrameAngle& start,
                               const Parameters& at) {
  const std::size_t segments = angle.path().segments().size();
  CompiledAngles compiled(segments);
  std::vector<std::vector<double>> ts(segments);
  for (const double t : at.doubles) ts[place_at(t, segments).first].push_back(t);
  for (std::size_t k = 0; k < segments; ++k) {
    if (ts[k].size() < (segments == 1 ? least_compiled : least_of_segment)) continue;
    const auto [from, to] = std::minmax_element(ts[k].begin(), ts[k].end());
    try {
      if (!angle.path().is_curve())
        compiled[k].emplace(angle, k, start);
      else if (*from < *to)
        compiled[k].emplace(angle.segment(0), *from, *to, start);
    } catch (const Undecided&) {
      // All of its angles are computed exactly.
    }
  }
  return compiled;
}

std::optional<double> approximated(const CompiledAngles& compiled, const Parameters& at,
                                   std::size_t k) {
  if (!at.are_doubles()) return std::nullopt;
  const auto& segment = compiled[place_at(at.doubles[k], compiled.size()).first];
  return segment ? segment->rounded(at.doubles[k]) : std::nullopt;
}

}  // namespace

nb::object angles(const PathAngle& angle, const FrameAngle& start, nb::handle ts,
                  nb::handle progress) {
  auto at = std::make_shared<Parameters>(parameters(ts, "ts"));
  auto numbers = std::make_shared<DoubleArray>(at->size());
  auto compiled = std::make_shared<CompiledAngles>();
  run({.n = at->size(),
       .grain = at->are_doubles() && at->size() >= least_compiled ? many : 1,
       .prepare = [=] { *compiled = compiled_angles(angle, start, *at); },
       .work =
           [=](std::size_t from, std::size_t to) {
             for (std::size_t k = from; k < to; ++k) {
               const auto near = approximated(*compiled, *at, k);
               (*numbers)[k] = near ? *near : finite(round_to_double(angle.value((*at)[k], start)));
             }
           }},
      progress);
  return array(numbers, {at->size()});
}

void bind_arrays(nb::class_<PathObject>& path) {
  path.def(
          "frames",
          tabulated({3, 3}, [](const auto& place, double* out) { write_rows(place.frame(), out); }),
          argument("ts"), nb::kw_only(), PHRAME_START_PARAMETERS, PHRAME_ARRAY_OPTIONS("rmf"),
          nb::sig("def frames(self, " PHRAME_TS ", *, " PHRAME_START_SIG
                  ", " PHRAME_ARRAY_OPTIONS_SIG ") -> " PHRAME_ARRAY),
          "Frames as an array (n, 3, 3): [k, 0] is the tangent e1, [k, 1] and [k, 2] are f2, f3. "
          "Every number is correctly rounded. `kind` is rmf, erf or frenet; `by` is parameter or "
          "arc_length; where a rotation-minimizing frame starts, `start` or "
          "`start_normal` says: see docs/python.md.")
      .def(
          "quaternions",
          tabulated({4},
                    [](const auto& place, double* out) {
                      const std::array<double, 4> q = place.quaternion();
                      std::copy(q.begin(), q.end(), out);
                    }),
          argument("ts"), nb::kw_only(), PHRAME_START_PARAMETERS, PHRAME_ARRAY_OPTIONS("rmf"),
          nb::sig("def quaternions(self, " PHRAME_TS ", *, " PHRAME_START_SIG
                  ", " PHRAME_ARRAY_OPTIONS_SIG ") -> " PHRAME_ARRAY),
          "The same as unit quaternions (x, y, z, w), scalar last as in SciPy, whose matrices have "
          "the columns e1, f2, f3; continuous along the path.")
      .def("matrices",
           tabulated({4, 4}, [](const auto& place,
                                double* out) { write_pose(place.frame(), place.point(), out); }),
           argument("ts"), nb::kw_only(), PHRAME_START_PARAMETERS, PHRAME_ARRAY_OPTIONS("rmf"),
           nb::sig("def matrices(self, " PHRAME_TS ", *, " PHRAME_START_SIG
                   ", " PHRAME_ARRAY_OPTIONS_SIG ") -> " PHRAME_ARRAY),
           "The same as an array (n, 4, 4) of matrices with the columns e1, f2, f3, r.")
      .def(
          "points",
          [write = tabulated({3},
                             [](const auto& place, double* out) {
                               const Vector<double> r = place.point();
                               std::copy(r.begin(), r.end(), out);
                             })](const PathObject& self, nb::handle ts, const Text<"by">& by,
                                 nb::handle progress) {
            return write(self, ts, nb::none(), nb::none(), {"erf"}, by, progress);
          },
          argument("ts"), nb::kw_only(), argument("by") = "parameter",
          argument("progress") = nb::none(),
          nb::sig("def points(self, " PHRAME_TS ", *, by: str = 'parameter', " PHRAME_PROGRESS
                  ") -> " PHRAME_ARRAY),
          "r at each parameter, correctly rounded: an array (n, 3).");
}

}  // namespace phrame::python
