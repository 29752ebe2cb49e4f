#include "answers.hpp"
#include "arrays.hpp"

namespace phrame::inline v0::python {
namespace {

/// The columns x, y, z.
std::array<Vector<Rational>, 3> columns_of(nb::handle matrix, const std::string& place) {
  std::array<Vector<Rational>, 3> columns;
  std::size_t i = 0;
  for (const nb::handle row : nb::list(matrix)) {
    const Vector<Rational> numbers = vector(row, place + "[" + std::to_string(i) + "]");
    for (std::size_t j = 0; j < 3; ++j) columns[j][i] = numbers[j];
    ++i;
  }
  return columns;
}

Orientation orientation(nb::handle x, const std::string& place) {
  if (!is_list(x)) refuse_type(place, "a quaternion of 4 numbers or a matrix of 3 rows", x);
  const std::size_t n = nb::len(x);
  if (n == 4) {
    const auto q = rationals(x, place);
    const RationalQuaternion p{q[3], q[0], q[1], q[2]};
    if (norm(p) == 0) refuse(place, "the quaternion is 0, which is no rotation", x);
    return {p, 0};
  }
  if (n != 3)
    refuse(place, "a quaternion has 4 numbers, a matrix 3 rows, not " + std::to_string(n), x);
  const auto found = nearest_rotation(columns_of(x, place));
  if (!found)
    refuse(place,
           "it is no rotation: its columns are not orthonormal to within 1/100, or left-handed", x);
  return *found;
}

}  // namespace

TangentAxis tangent_axis(const std::string& name) {
  for (const auto& [known, axis] : tangent_axes())
    if (known == name) return axis;
  refuse("tangent_axis", "it is none of x, y, z, -x, -y, -z", nb::str(name.c_str()));
}

std::vector<Orientation> orientations_of(nb::handle given, std::size_t count) {
  nb::object list = nb::borrow(given);
  if (nb::hasattr(list, "as_quat")) list = list.attr("as_quat")();
  if (!is_list(list)) refuse_type("orientations", "a list of quaternions or matrices", given);
  std::vector<Orientation> found;
  for (const nb::handle x : nb::list(list))
    found.push_back(orientation(x, "orientations[" + std::to_string(found.size()) + "]"));
  if (found.size() != count)
    refuse("orientations",
           std::to_string(found.size()) + " for " + std::to_string(count) + " points", given);
  return found;
}

namespace {

struct PathTwistObject {
  PathTwist twist;
  NamedPath named;
  nb::object recipe;
};

nb::object twist_of(nb::handle self, nb::handle up) {
  const NamedPath& named = path_of(self).named;
  if (!named.frame)
    throw DomainError(
        "no orientations come with this path: Path.through(points, orientations=...) has some");
  const PathAngle angle = up.is_none()
                              ? without_gil([path = named.path] { return PathAngle(path); })
                              : angle_to_up(named.path, up);
  return nb::cast(PathTwistObject{
      without_gil([=, frame = *named.frame] { return PathTwist(angle, frame); }), named,
      method_recipe(self, "twist", up.is_none() ? nb::none() : to_python(vector(up, "up")))});
}

nb::object turns_of(nb::handle self) {
  const PathTwist& twist = nb::cast<const PathTwistObject&>(self).twist;
  nb::list list;
  for (std::size_t k = 0; k < twist.legs().size(); ++k)
    list.append(
        to_python(twist.legs()[k].twist.twist(),
                  recipe(imported("phrame._pickle", "element"), self, nb::str("turns"), k)));
  return nb::tuple(list);
}

}  // namespace

nb::object twist_frames(const PathTwist& twist, nb::handle ts, nb::handle progress) {
  const auto at = std::make_shared<Parameters>(parameters(ts, "ts"));
  const std::size_t segments = twist.rmf().path().segments().size();
  require_inside(*at, twist.rmf().path().end());
  TableColumns columns{.frames = {TabulatedFrame::exact_mtf}};
  columns.exact_mtf = twist;
  const auto numbers = std::make_shared<DoubleArray>(at->size() * 9);
  run({.n = at->size(),
       .grain = 16,
       .work =
           [=](std::size_t from, std::size_t to) {
             std::vector<Place> places;
             for (std::size_t k = from; k < to; ++k)
               places.emplace_back(locate_inside(segments, (*at)[k]));
             const FrameTable table = frame_table(twist.rmf(), columns, places);
             for (std::size_t k = from; k < to; ++k)
               std::copy_n(table.rows[k - from].begin() + 4, 9, numbers->data() + 9 * k);
           }},
      progress);
  return array(numbers, {at->size(), 3, 3});
}

void bind_path_twist(nb::module_& m, PathClass& path) {
  path.def("twist", twist_of, argument("up") = nb::none(),
           nb::sig("def twist(self, " PHRAME_UP_SIG ") -> PathTwist"),
           "The frame of least twist, or the smooth one, through the orientations that come with "
           "the path: docs/poses.md.");
  auto type = nb::class_<PathTwistObject>(
      m, "PathTwist", "The frame through orientations at joints of a path: docs/poses.md.");
  using T = PathTwistObject;
  type.def_prop_ro(
          "is_smooth", [](const T& self) { return self.twist.is_smooth(); },
          "Is its rate about the tangent continuous? Else it is constant from each orientation to "
          "the next.")
      .def_prop_ro(
          "joints",
          [](const T& self) {
            nb::list list;
            for (const auto& joint : self.named.frame->joints) list.append(joint.joint);
            return nb::tuple(list);
          },
          nb::sig("def joints(self) -> tuple[int, ...]"), "The t at which orientations are given.")
      .def_prop_ro("turns", turns_of,
                   nb::sig("def turns(self) -> tuple[fractions.Fraction | Real, ...]"),
                   "How far it turns about the tangent from each to the next, in (-π, π] but for "
                   "turns that were asked for.")
      .def_prop_ro(
          "squared_rate",
          [](nb::handle self) {
            return to_python(nb::cast<const T&>(self).twist.squared_rate(),
                             attribute_recipe(self, "squared_rate"));
          },
          nb::sig("def squared_rate(self) -> " PHRAME_REAL_SIG),
          "∫ω² ds, ω the rate about the tangent: the least there is, where it is not smooth.")
      .def_prop_ro(
          "squared_slope",
          [](nb::handle self) {
            return to_python(nb::cast<const T&>(self).twist.squared_slope(),
                             attribute_recipe(self, "squared_slope"));
          },
          nb::sig("def squared_slope(self) -> " PHRAME_REAL_SIG),
          "∫ω′² ds of a smooth one: the least there is.")
      .def(
          "rate",
          [](nb::handle self, nb::handle t) {
            const T& twist = nb::cast<const T&>(self);
            const Rational at = rational(t, "t");
            const Rational end = twist.named.path.end();
            if (at < 0 || at > end) refuse("t", "it is outside [0, " + to_string(end) + "]", t);
            return to_python(
                twist.twist.rate(locate_inside(twist.named.path.segments().size(), at)),
                method_recipe(self, "rate", to_python(at)));
          },
          argument("t"), nb::sig("def rate(self, t: Number) -> " PHRAME_REAL_SIG),
          "ω at t, of the later leg at a joint.")
      .def(
          "frames",
          [](const T& self, nb::handle ts, nb::handle progress) {
            return twist_frames(self.twist, ts, progress);
          },
          argument("ts"), nb::kw_only(), argument("progress") = nb::none(),
          nb::sig("def frames(self, ts: Numbers, *, " PHRAME_PROGRESS ") -> " PHRAME_ARRAY),
          "Frames as an array (n, 3, 3) with the rows e1, f2, f3, every number correctly rounded; "
          "where an orientation is given, it is met exactly.")
      .def("__repr__", [](const T& self) {
        return "<PathTwist through " + std::to_string(self.twist.legs().size() + 1) +
               " orientations" + (self.twist.is_smooth() ? ", smooth>" : ">");
      });
  bind_recipe(type);
}

}  // namespace phrame::python
