#pragma once
#include "paths.hpp"

namespace phrame::inline v0::python {

#define PHRAME_RANGES_SIG "tuple[tuple[decimal.Decimal, decimal.Decimal], ...]"

/// A named tuple of phrame._offsets.
template <class... T>
nb::object record(const char* name, T&&... fields) {
  return imported("phrame._offsets", name)(std::forward<T>(fields)...);
}
/// How a number of what an object has is pickled: by the way there.
template <class... T>
nb::object within(nb::handle self, T&&... way) {
  return recipe(imported("phrame._pickle", "within"), self, std::forward<T>(way)...);
}

nb::tuple tuple_of(const std::vector<Path>& paths);
nb::object to_python(const std::array<Decimal, 2>& point);

/// An OffsetPart; recipe_of("start") is that of t there.
template <class F>
nb::object part_record(const BoundaryEnd& from, const BoundaryEnd& to, const char* kind,
                       bool is_cut_from, bool is_cut_to, const F& recipe_of) {
  return record("OffsetPart", to_python(from.t, recipe_of("start")),
                to_python(to.t, recipe_of("end")), to_python(from.at), to_python(to.at), kind,
                is_cut_from, is_cut_to);
}

/// What an object that is a sequence of `paths` has of these.
template <class T>
void bind_paths(nb::class_<T>& type) {
  type.def("__len__", [](const T& x) { return x.paths.size(); })
      .def(
          "__getitem__",
          [](const T& x, nb::handle k) { return nb::object(x.paths.attr("__getitem__")(k)); },
          argument("k"),
          nb::sig("@typing.overload\ndef __getitem__(self, k: typing.SupportsIndex) -> Path: ...\n"
                  "@typing.overload\ndef __getitem__(self, k: slice) -> tuple[Path, ...]"))
      .def(
          "__iter__", [](const T& x) { return nb::iter(x.paths); },
          nb::sig("def __iter__(self) -> collections.abc.Iterator[Path]"))
      .def_prop_ro(
          "paths", [](const T& x) { return x.paths; },
          nb::sig("def paths(self) -> tuple[Path, ...]"), "It, in as few paths as possible.");
  bind_python(type, "outlines", "phrame._plot", "outlines",
              "def outlines(self) -> tuple[numpy.typing.NDArray[numpy.float64], ...]",
              "Points of each path, (n, 2), as dense as a picture needs them.");
}

/// A path or a polyline, or a list of such.
ForeignOffset foreign_offset(nb::handle given);

void bind_offsets(nb::module_& m, PathClass& path);
void bind_envelope(nb::module_& m);

}  // namespace phrame::python
