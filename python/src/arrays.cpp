#include "arrays.hpp"

#include "paths.hpp"

namespace phrame::inline v0::python {
namespace {

FrameKind frame_kind(const std::string& name, const PathObject& self) {
  const auto kind = chosen<TabulatedFrame>(name, "kind",
                                           {{"rmf", TabulatedFrame::rmf},
                                            {"erf", TabulatedFrame::euler_rodrigues},
                                            {"up", TabulatedFrame::up},
                                            {"mtf", TabulatedFrame::exact_mtf},
                                            {"frenet", TabulatedFrame::frenet},
                                            {"frenet-signed", TabulatedFrame::signed_frenet}});
  if (kind == TabulatedFrame::exact_mtf && !self.named.frame && !self.named.path.is_closed())
    refuse("kind",
           "\"mtf\" is through the orientations that come with a path, or around a closed one; "
           "path.minimal_twist(start, end).frames(ts) is between two ends",
           nb::str(name.c_str()));
  const auto& segments = self.named.path.segments();
  if (kind == TabulatedFrame::euler_rodrigues && std::ranges::none_of(segments, ph_curve))
    refuse("kind", "\"erf\" is of PH curves, and " + why_not_ph(self.named.path),
           nb::str(name.c_str()));
  return kind;
}

/// What is asked of a path at many places.
struct ArrayQuery {
  nb::handle ts;
  nb::handle start;
  nb::handle start_normal;
  nb::handle up;
  FrameKind kind;
  ParameterKind by;
  nb::handle progress;
  std::size_t width;  ///< so many numbers for each place
  Roll roll = {};     ///< by which frames are turned about e₁ beside
};

/// A place on a path with its frame, which the source computes when it is asked for.
struct SourcePlace {
  const FrameSource& source;
  const Parameters& at;
  std::size_t k;
  const Frame<double>* found;  ///< its frame, where that is known

  Frame<double> frame() const { return found != nullptr ? *found : source.frame(at, k); }
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

using At = std::shared_ptr<Parameters>;

/// Is t a linear function of it, between joints?
bool is_linear(ParameterKind by) {
  return by == ParameterKind::native || by == ParameterKind::unit;
}

/// The numbers that write(place, out) writes for each place.
template <class Write>
Numbers numbers_of(const PathObject& self, const At& at, const ArrayQuery& asked, bool is_to_up,
                   const Write& write) {
  const Path& path = self.named.path;
  const bool is_by_t = asked.by == ParameterKind::t;
  if (is_by_t && (is_to_up || !goes_on(path))) require_inside(*at, path.end());
  const FrameStart from = frame_start(asked.start, asked.start_normal, StartRule::least_rotation,
                                      path, is_to_up ? Reference::up : Reference::euler_rodrigues);
  const bool has_start = asked.kind == TabulatedFrame::rmf;
  FrameQuery query{asked.kind, has_start ? from : FrameStart(), is_to_up, {}, asked.by};
  if (!asked.up.is_none()) query.up = vector(asked.up, "up");
  const auto source = self.sources->of(query, [&] {
    std::optional<PathAngle> angle;
    if (is_to_up && asked.kind)
      angle.emplace(angle_to_up(path, asked.up));
    else if (has_start)
      angle.emplace(path.segments().size() == 1 && path.is_ph()
                        ? PathAngle(path)  // sooner than another thread is woken
                        : without_gil([path] { return PathAngle(path); }));
    return std::make_shared<FrameSource>(parametrization(self.named, asked.by), asked.kind, angle,
                                         has_start ? start_angle(from, *angle) : StartAngle());
  });
  const auto numbers = std::make_shared<DoubleArray>(at->size() * asked.width);
  return filled(
      numbers, asked.progress, source, at, at->are_doubles() && is_by_t ? many : 4,
      [source, at, numbers, width = asked.width, has_frames = asked.kind.has_value(), write](
          std::size_t begin, std::size_t end) {
        constexpr std::size_t of_frame = 9;  // and more of a matrix
        std::vector<Frame<double>> frames(has_frames && width >= of_frame ? end - begin : 0);
        source->frames(*at, begin, frames);
        for (std::size_t k = begin; k < end; ++k)
          write(SourcePlace{*source, *at, k, frames.empty() ? nullptr : &frames[k - begin]},
                numbers->data() + k * width);
      });
}

/// The same from tables by this angle: of frames that the source does not have.
template <class Write>
Numbers by_table(const PathObject& self, const PathAngle& angle, TableColumns columns, const At& at,
                 const ArrayQuery& asked, const Write& write) {
  columns.have_quaternions = asked.width == 4;
  columns.have_matrices = asked.width == 16;
  columns.roll = asked.roll;
  const auto numbers = std::make_shared<DoubleArray>(at->size() * asked.width);
  run({.n = at->size(),
       .grain = 16,
       .work =
           [=, along = parametrization(self.named, asked.by), width = asked.width](std::size_t from,
                                                                                   std::size_t to) {
             std::vector<Place> points;
             for (std::size_t k = from; k < to; ++k)
               points.push_back(at_place("ts[" + std::to_string(k) + "]",
                                         [&] { return along.point((*at)[k]).at; }));
             const FrameTable table = frame_table(angle, columns, points);
             for (std::size_t k = from; k < to; ++k) {
               const double* row = table.rows[k - from].data();
               double* out = numbers->data() + k * width;
               if (columns.have_matrices)
                 std::copy_n(row + 13, width, out);  // those of a body, perhaps
               else
                 write(TablePlace{row}, out);
             }
           }},
      asked.progress);
  return numbers;
}

/// The frame of minimal twist through the orientations that come with a path, or around a closed
/// one, or another frame with a roll.
template <class Write>
Numbers tabulated_numbers(const PathObject& self, bool is_general, const At& at,
                          const ArrayQuery& asked, const Write& write) {
  const Path& path = self.named.path;
  if (asked.by == ParameterKind::t && !goes_on(path)) require_inside(*at, path.end());
  const PathAngle angle = is_general ? angle_to_up(path, asked.up) : PathAngle(path);
  TableColumns columns{.frames = {*asked.kind}};
  columns.start = frame_start(asked.start, asked.start_normal, StartRule::least_rotation, path,
                              angle.reference());
  if (asked.kind == TabulatedFrame::exact_mtf)
    columns = without_gil([angle, as_asked = columns, frame = self.named.frame] {
      TableColumns found = as_asked;
      if (frame) {
        found.exact_mtf.emplace(angle, *frame);
        found.body = frame->axis;
      } else {
        found.exact_mtf = minimal_twist(angle, found.start, std::nullopt, 0);
      }
      return found;
    });
  return by_table(self, angle, std::move(columns), at, asked, write);
}

/// An array of these numbers for each place.
template <class Write>
nb::object array_of(const PathObject& self, ArrayQuery asked, const std::vector<std::size_t>& shape,
                    const Write& write) {
  const auto at = std::make_shared<Parameters>(parameters(asked.ts, "ts"));
  if (is_linear(asked.by))
    if (auto t = by_t(parametrization(self.named, asked.by), *at, "ts")) {
      *at = *std::move(t);
      asked.by = ParameterKind::t;
    }
  const bool is_erf = asked.kind == TabulatedFrame::euler_rodrigues;
  if (is_erf && !asked.up.is_none()) refuse("up", "the Euler–Rodrigues frame has none", asked.up);
  const bool is_general =
      is_erf ? !self.ph : asked.kind == TabulatedFrame::up || is_to_up(self, asked.up, asked.start);
  const bool is_tabulated = asked.kind == TabulatedFrame::exact_mtf ||
                            asked.kind == TabulatedFrame::signed_frenet || !asked.roll.is_zero();
  const Numbers numbers = is_tabulated ? tabulated_numbers(self, is_general, at, asked, write)
                                       : numbers_of(self, at, asked, is_general, write);
  if (asked.width == 4 && (is_tabulated || is_general || asked.by != ParameterKind::t ||
                           asked.kind == TabulatedFrame::frenet))
    make_continuous(*numbers);
  std::vector<std::size_t> whole{numbers->size() / asked.width};
  whole.insert(whole.end(), shape.begin(), shape.end());
  return array(numbers, whole);
}

/// A function (self, ts, start, start_normal, up, kind, by, roll, progress) that makes arrays of
/// this shape of frames.
template <class Write>
auto tabulated(const std::vector<std::size_t>& shape, const Write& write) {
  return [=](const PathObject& self, nb::handle ts, nb::handle start, nb::handle start_normal,
             nb::handle up, const Text<"kind">& kind, const Text<"by">& by, nb::handle roll,
             nb::handle progress) {
    ArrayQuery asked{ts,
                     start,
                     start_normal,
                     up,
                     frame_kind(kind, self),
                     parameter_kind(by),
                     progress,
                     product(shape),
                     roll_of(roll, self.named.path.segments().size())};
    if (!asked.roll.is_zero() && asked.kind && is_of_curve(*asked.kind))
      refuse("roll", "it is of the kinds rmf, up and mtf", roll);
    return array_of(self, asked, shape, write);
  };
}

nb::object points(const PathObject& self, nb::handle ts, const Text<"by">& by,
                  nb::handle progress) {
  const nb::object none = nb::none();
  return array_of(self, {ts, none, none, none, std::nullopt, parameter_kind(by), progress, 3}, {3},
                  [](const auto& place, double* out) {
                    const Vector<double> r = place.point();
                    std::copy(r.begin(), r.end(), out);
                  });
}

}  // namespace

Roll roll_of(nb::handle roll, std::size_t segments) {
  if (roll.is_none()) return {};
  const Roll found = [&]() -> Roll {
    if (PyUnicode_Check(roll.ptr()) != 0) {
      try {
        return parse_roll(text(roll, "roll"));
      } catch (const InputError& error) {
        refuse("roll", error.what(), roll);
      }
    }
    if (!is_list(roll)) {
      const Angle angle = angle_number(roll, "roll");
      return Roll::Piece{RationalFunction(Polynomial{angle.half_turns}),
                         RationalFunction(Polynomial{angle.radians})};
    }
    std::vector<Angle> angles;
    for (const nb::handle x : nb::list(listed(roll, "roll", "a list of angles")))
      angles.push_back(angle_number(x, "roll[" + std::to_string(angles.size()) + "]"));
    if (angles.size() < 2) refuse("roll", "of a list there are two angles at least", roll);
    return Roll(angles);
  }();
  at_place("roll", [&] { found.require_along(segments); });
  return found;
}

void require_inside(const Parameters& at, const Rational& end) {
  const double last = round_to_double(end);
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (at.are_doubles() ? at.doubles[k] >= 0 && at.doubles[k] <= last : at[k] >= 0 && at[k] <= end)
      continue;
    throw ArgumentError("ts[" + std::to_string(k) + "]",
                        as_written(at[k]) + " is outside [0, " + to_string(end) + "]");
  }
}

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
CompiledAngles compiled_angles(const PathAngle& angle, const StartAngle& start,
                               const Parameters& at) {
  const std::size_t segments = angle.path().segments().size();
  CompiledAngles compiled(segments);
  std::vector<std::vector<double>> ts(segments);
  for (const double t : at.doubles) ts[place_at(t, segments).first].push_back(t);
  for (std::size_t k = 0; k < segments; ++k) {
    if (ts[k].size() < (segments == 1 ? least_compiled : least_of_segment)) continue;
    const auto [from, to] = std::minmax_element(ts[k].begin(), ts[k].end());
    try {
      if (segments > 1 || angle.closed_form(0) == nullptr || !start.exact)
        compiled[k].emplace(angle, k, start);
      else if (*from < *to)
        compiled[k].emplace(*angle.closed_form(0), *from, *to, *start.exact);
    } catch (const Undecided&) {
      // All of its angles are computed exactly.
    }
  }
  return compiled;
}

/// θ at each t from number `from` to before `to`, many at once where segments are compiled. The
/// numbers of those that these do not tell are added to untold.
void approximate(const CompiledAngles& compiled, const std::vector<double>& t, std::size_t from,
                 std::size_t to, DoubleArray& numbers, std::vector<std::size_t>& untold) {
  const auto segment = [&](std::size_t k) { return place_at(t[k], compiled.size()).first; };
  for (std::size_t end = from; from < to; from = end) {
    const auto& of_run = compiled[segment(from)];
    do ++end;
    while (end < to && &compiled[segment(end)] == &of_run);
    if (of_run)
      for (const std::size_t k :
           of_run->rounded({t.data() + from, end - from}, {numbers.data() + from, end - from}))
        untold.push_back(from + k);
    else
      for (std::size_t k = from; k < end; ++k) untold.push_back(k);
  }
}

}  // namespace

/// θ at places that are not at fractions of t.
nb::object angles_by_places(const NamedPath& named, const PathAngle& angle, const StartAngle& start,
                            const At& at, ParameterKind by, nb::handle progress) {
  const auto numbers = std::make_shared<DoubleArray>(at->size());
  run({.n = at->size(),
       .grain = 1,
       .work =
           [=, along = Parametrization(named, by)](std::size_t from, std::size_t to) {
             for (std::size_t k = from; k < to; ++k) {
               const Place place = at_place("ts[" + std::to_string(k) + "]",
                                            [&] { return along.point((*at)[k]).at; });
               (*numbers)[k] = finite(round_to_double(angle.value(place, start)));
             }
           }},
      progress);
  return array(numbers, {at->size()});
}

nb::object angles(const NamedPath& named, const PathAngle& angle, const StartAngle& start,
                  nb::handle ts, ParameterKind by, nb::handle progress) {
  const auto at = std::make_shared<Parameters>(parameters(ts, "ts"));
  if (by != ParameterKind::t) {
    const auto t = is_linear(by) ? by_t(parametrization(named, by), *at, "ts") : std::nullopt;
    if (!t) return angles_by_places(named, angle, start, at, by, progress);
    *at = *t;
  }
  if (!goes_on(angle.path())) require_inside(*at, angle.path().end());
  const auto numbers = std::make_shared<DoubleArray>(at->size());
  const auto compiled = std::make_shared<CompiledAngles>();
  run({.n = at->size(),
       .grain = at->are_doubles() && at->size() >= least_compiled ? many : 1,
       .prepare =
           [=] {
             if (at->are_doubles()) *compiled = compiled_angles(angle, start, *at);
           },
       .work =
           [=](std::size_t from, std::size_t to) {
             std::vector<std::size_t> untold;
             if (at->are_doubles())
               approximate(*compiled, at->doubles, from, to, *numbers, untold);
             else
               for (std::size_t k = from; k < to; ++k) untold.push_back(k);
             for (const std::size_t k : untold)
               (*numbers)[k] = finite(round_to_double(angle.value((*at)[k], start)));
           }},
      progress);
  return array(numbers, {at->size()});
}

void bind_arrays(PathClass& path) {
#define PHRAME_FRAMES(name, of, what)                                                        \
  path.def(name, of, argument("ts"), nb::kw_only(), PHRAME_START_PARAMETERS,                 \
           argument("up") = nb::none(), argument("kind") = "rmf", argument("by") = "t",      \
           argument("roll") = nb::none(), argument("progress") = nb::none(),                 \
           nb::sig("def " name "(self, ts: Numbers, *, " PHRAME_START_SIG ", " PHRAME_UP_SIG \
                   ", kind: str = 'rmf', by: str = 't', " PHRAME_ROLL ", " PHRAME_PROGRESS   \
                   ") -> " PHRAME_ARRAY),                                                    \
           what)
  PHRAME_FRAMES(
      "frames",
      tabulated({3, 3}, [](const auto& place, double* out) { write_rows(place.frame(), out); }),
      "Frames as an array (n, 3, 3): [k, 0] is the tangent e1, [k, 1] and [k, 2] are f2, f3. "
      "Every number is correctly rounded. `kind` is rmf, erf (on PH curves), up, frenet, or mtf, "
      "of "
      "minimal twist through the orientations that come with the path, or around a closed one; "
      "`roll` turns frames about e1 beside: a number or text such as '15deg' or '30*t deg', or "
      "angles at the joints; `by` "
      "says what ts are: t, native, unit, arc-length or fraction; where a rotation-minimizing "
      "frame "
      "starts, `start` or "
      "`start_normal` says: see docs/python.md.");
  PHRAME_FRAMES("quaternions",
                tabulated({4},
                          [](const auto& place, double* out) {
                            const std::array<double, 4> q = place.quaternion();
                            std::copy(q.begin(), q.end(), out);
                          }),
                "The same as unit quaternions (x, y, z, w), scalar last as in SciPy, whose "
                "matrices have the columns e1, f2, f3; continuous along PH curves, else each the "
                "nearer to that before it of the two.");
  PHRAME_FRAMES(
      "matrices",
      tabulated({4, 4}, [](const auto& place,
                           double* out) { write_pose(place.frame(), place.point(), out); }),
      "The same as an array (n, 4, 4) of matrices with the columns e1, f2, f3, r.");
#undef PHRAME_FRAMES
  path.def("points", points, argument("ts"), nb::kw_only(), argument("by") = "t",
           argument("progress") = nb::none(),
           nb::sig("def points(self, ts: Numbers, *, by: str = 't', " PHRAME_PROGRESS
                   ") -> " PHRAME_ARRAY),
           "r at each parameter, correctly rounded: an array (n, 3).");
}

}  // namespace phrame::python
