#include "paths.hpp"

// What there is of one PH curve, polynomial or rational: of another path a DomainError says which
// segment is none, or that there are several. And transformations, which are there of all.
namespace phrame::inline v0::python {
namespace {

nb::tuple polynomials(const Vector<Polynomial>& v) { return nb::make_tuple(v[0], v[1], v[2]); }

void bind_properties(PathClass& path) {
#define PHRAME_PROPERTY_OF(asked_of, name, of, type, what) \
  path.def_prop_ro(                                        \
      name,                                                \
      [](const PathObject& self) {                         \
        const Curve& curve = asked_of(self, name);         \
        return of;                                         \
      },                                                   \
      nb::sig("def " name "(self) -> " type), what)
#define PHRAME_PROPERTY(name, of, type, what) \
  PHRAME_PROPERTY_OF(curve_with_preimage_of, name, of, type, what)
#define PHRAME_POLYNOMIALS_SIG "tuple[Polynomial, Polynomial, Polynomial]"
  PHRAME_PROPERTY("preimage",
                  nb::make_tuple(curve.preimage().u, curve.preimage().v, curve.preimage().p,
                                 curve.preimage().q),
                  "tuple[Polynomial, Polynomial, Polynomial, Polynomial]", "A = u + vi + pj + qk.");
  PHRAME_PROPERTY("multiplier", curve.multiplier(), "Polynomial",
                  "f of r′ = f·A i A*, or of r′ = f/W²·A i A*.");
  PHRAME_PROPERTY("weight", curve.weight(), "Polynomial", "W of r = X/W, 1 if r is polynomial.");
  PHRAME_PROPERTY("numerator", polynomials(numerator(curve)), PHRAME_POLYNOMIALS_SIG,
                  "X of r = X/W, r if that is polynomial.");
  PHRAME_PROPERTY("start", to_python(curve.start()), PHRAME_VECTOR_SIG, "r(0).");
  PHRAME_PROPERTY("degree", degree(curve), "int", "Of r.");
  PHRAME_PROPERTY_OF(curve_of, "hodograph", polynomials(hodograph(curve)), PHRAME_POLYNOMIALS_SIG,
                     "r′ of a polynomial curve.");
  PHRAME_PROPERTY_OF(curve_of, "position", polynomials(position(curve)), PHRAME_POLYNOMIALS_SIG,
                     "r of a polynomial curve.");
  PHRAME_PROPERTY("sigma", sigma(curve.preimage()), "Polynomial", "σ = |A|².");
  PHRAME_PROPERTY("h", twist_numerator(curve.preimage()), "Polynomial", "uv′ − u′v − pq′ + p′q.");
  PHRAME_PROPERTY("rho", rho(curve.preimage()), "Polynomial", "4|g|².");
  PHRAME_PROPERTY("squared_curvature", squared_curvature(curve), "RationalFunction", "κ².");
  PHRAME_PROPERTY("torsion_function", torsion(curve), "RationalFunction", "τ of t.");
#undef PHRAME_PROPERTY
#undef PHRAME_PROPERTY_OF
  path.def_prop_ro(
          "g",
          [](const PathObject& self) {
            const GaussianPolynomial g =
                bend_numerator(curve_with_preimage_of(self, "g").preimage());
            return nb::make_tuple(g.re, g.im);
          },
          nb::sig("def g(self) -> tuple[Polynomial, Polynomial]"),
          "αβ′ − α′β: its real and its imaginary part.")
      .def_prop_ro(
          "control_points",
          [](const PathObject& self) {
            nb::list list;
            for (const auto& point : control_points(curve_of(self, "control_points")))
              list.append(to_python(point));
            return nb::tuple(list);
          },
          nb::sig("def control_points(self) -> tuple[" PHRAME_VECTOR_SIG ", ...]"),
          "Of the Bézier curve that it is.");
}

/// What make(curve) is of one PH curve, which goes on for all t, and make(path) of another path,
/// under the same name.
template <class F>
NamedPath remade_path(const PathObject& self, const F& make) {
  if (self.ph && self.ph->path.is_curve())
    return NamedPhPath(self.named.name, make(self.ph->path.segments().front()));
  return {self.named.name, without_gil([path = self.named.path, make] { return make(path); })};
}

/// The same with the same parameters.
template <class F>
nb::object moved_path(const PathObject& self, const F& make) {
  NamedPath made = remade_path(self, make);
  made.parameters = self.named.parameters;
  return wrap(std::move(made));
}

/// Of 3 rows of 3 numbers, or of 4, or of 4 rows of 4.
AffineMap map_of_rows(nb::handle matrix) {
  const nb::object rows = listed(matrix, "matrix", "a list of rows");
  const std::size_t count = nb::len(rows);
  std::vector<Rational> numbers;
  for (std::size_t k = 0; k < count; ++k) {
    const auto row = rationals(rows[k], "matrix[" + std::to_string(k) + "]");
    if (row.size() != 4 && !(row.size() == 3 && count == 3))
      refuse("matrix", "3 rows of 3 or 4 numbers are wanted, or 4 rows of 4", matrix);
    numbers.insert(numbers.end(), row.begin(), row.end());
  }
  try {
    return affine_map(numbers);
  } catch (const DomainError& error) {
    refuse("matrix", error.what(), matrix);
  }
}

/// A tuple of the parts from each of these places to the next.
nb::object split(const PathObject& self, nb::handle ts, const std::string& by) {
  TransformQuery query;
  query.by = parameter_kind(by);
  query.split = rationals(listed(ts, "ts", "a list of numbers"), "ts");
  const auto parts = at_place("ts", [&] {
    return without_gil([named = self.named, query] { return answer(named, query); });
  });
  nb::list list;
  for (const NamedPath& part : parts) list.append(wrap(part));
  return nb::tuple(list);
}

void bind_transformations(PathClass& path) {
  path.def(
          "segment",
          [](const PathObject& self, nb::handle from, nb::handle to) {
            const Rational a = rational(from, "a"), b = rational(to, "b");
            return wrap(remade_path(self, [=](const auto& of) { return segment(of, a, b); }));
          },
          argument("a"), argument("b"), nb::sig("def segment(self, a: Number, b: Number) -> Path"),
          "The part from t = a to b: of one segment on [0, 1]; backwards for a > b.")
      .def(
          "reversed",
          [](const PathObject& self) {
            return wrap(remade_path(self, [](const auto& of) { return reversed(of); }));
          },
          nb::sig("def reversed(self) -> Path"), "t ↦ r(end − t).")
      .def(
          "whole_line",
          [](const PathObject& self) {
            return wrap(NamedPath{self.named.name, without_gil([path = self.named.path] {
                                    return whole_line(path);
                                  })});
          },
          nb::sig("def whole_line(self) -> Path"),
          "All of a rational curve as a closed path: t from −1 to 1, and from 1 through ∞ to −1.")
      .def(
          "translated",
          [](const PathObject& self, nb::handle v) {
            const auto by = vector(v, "v");
            return moved_path(self, [=](const auto& of) { return translated(of, by); });
          },
          argument("v"), nb::sig("def translated(self, v: Vector) -> Path"), "r + v.")
      .def(
          "scaled",
          [](const PathObject& self, nb::handle c) {
            const Rational by = rational(c, "c");
            return moved_path(self, [=](const auto& of) { return scaled(of, by); });
          },
          argument("c"), nb::sig("def scaled(self, c: Number) -> Path"), "c·r.")
      .def(
          "rotated",
          [](const PathObject& self, nb::handle u) {
            const auto list = rationals(u, "u");
            if (list.size() != 4)
              refuse("u", "4 numbers are wanted, there are " + std::to_string(list.size()), u);
            const RationalQuaternion by{list[0], list[1], list[2], list[3]};
            return moved_path(self, [=](const auto& of) { return rotated(of, by); });
          },
          argument("u"), nb::sig("def rotated(self, u: collections.abc.Sequence[Number]) -> Path"),
          "Rotated as the quaternion u, its real part first, says, and scaled by |u|².")
      .def(
          "transformed",
          [](const PathObject& self, nb::handle matrix) {
            TransformQuery query;
            query.map = map_of_rows(matrix);
            NamedPath made = at_place("matrix", [&] {
              return without_gil(
                  [named = self.named, query] { return answer(named, query).front(); });
            });
            made.parameters = self.named.parameters;
            return wrap(std::move(made));
          },
          argument("matrix"),
          nb::sig("def transformed(self, matrix: collections.abc.Sequence[Vector] | "
                  "numpy.typing.NDArray[typing.Any]) -> Path"),
          "Under a 3 × 3 matrix, or one of 3 × 4 or 4 × 4 numbers whose last column is added; what "
          "is PH stays so under rotations, scalings and reflections.")
      .def(
          "split",
          [](const PathObject& self, nb::handle ts, const Text<"by">& by) {
            return split(self, ts, by);
          },
          argument("ts"), argument("by") = "t",
          nb::sig("def split(self, ts: Numbers, " PHRAME_BY_SIG ") -> tuple[Path, ...]"),
          "The parts from each of these places to the next; at an irrational t it is cut next to "
          "that.");
}

}  // namespace

void bind_ph_curve(PathClass& path) {
  bind_properties(path);
  bind_transformations(path);
}

}  // namespace phrame::python
