#include "phrame/io/write/boundary_fields.hpp"

#include <fmt/format.h>

#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/io/write/heading.hpp"

namespace phrame::inline v0 {

bool is_long(const Rational& x) {
  constexpr std::size_t longest = 16;
  return to_string(x).size() > longest;
}

std::string at(const std::string& t, Notation notation) { return formula("t = " + t, notation); }

Value paths_value(const std::vector<Path>& paths) {
  const auto rows = [&](Notation) {
    std::vector<std::string> list;
    for (const Path& path : paths) list.push_back(heading(NamedPath("", path), false));
    return list;
  };
  const auto json = [](const Path& path) { return json_of(NamedPath("", path)); };
  return {Value::Rows(rows), [&paths, json] { return array_of(paths, json); }};
}

std::string in_words(const BoundaryEnd& end, const std::string& before, Notation notation) {
  const bool is_fraction = end.t.exact() && !is_long(*end.t.exact());
  return before + (is_fraction ? at_place(*end.t.exact(), notation)
                               : at(in_words(end.rounded, Notation::unicode), notation));
}

std::string point_in_words(const std::array<Decimal, 2>& point, Notation notation) {
  return formula(
      fmt::format("({}, {})", with_minus_sign(point[0].value), with_minus_sign(point[1].value)),
      notation);
}

JsonOutput json_of(const BoundaryEnd& end) {
  return {{"t", json_of(end.t, end.rounded)}, {"point", {json_of(end.at[0]), json_of(end.at[1])}}};
}

std::string in_words(const OffsetAnswer::Place& place, Notation notation) {
  return (place.is_join ? "the join at " : "") + at(place.t.value, notation);
}

std::string in_words(const OffsetAnswer::Measure& x, Notation notation) {
  const std::string digits = in_words(x.rounded, notation);
  if (!x.exact) return digits;
  if (notation == Notation::unicode && is_rational(*x.exact) && is_long(x.exact->rational))
    return digits;
  const std::string exact =
      formula(formatted_sum(formatted_terms(*x.exact, notation), " ", notation), notation);
  constexpr std::size_t longest = 100;  // beyond that nobody reads it, and JSON has it
  if (notation == Notation::unicode && exact.size() > longest) return digits;
  if (is_rational(*x.exact) || notation == Notation::latex) return exact;
  return exact + " ≈ " + digits;
}

std::string in_words(const OffsetKind& offset, const std::string& radicand, Notation notation) {
  using Kind = OffsetKind::Kind;
  const auto field = [&] {
    return offset.radicand == 1
               ? ""
               : ", over " + formula(fmt::format("ℚ(√{})", to_string(offset.radicand)), notation);
  };
  switch (offset.kind) {
    case Kind::each_side:
      return "rational to each side" + field();
    case Kind::none:
      return fmt::format("not rational: {} has {} simple roots", radicand,
                         offset.squarefree.degree());
    case Kind::undecided:
      return "undecided";
    case Kind::two_sided:
      break;
  }
  if (offset.prime != 0)
    return fmt::format(
        "rational for both sides together{}, as $y² = $ {} has no point modulo powers of {}",
        field(), in_words(offset.squarefree, notation), to_string(offset.prime));
  if (!offset.conic) return "rational for both sides together";
  const std::string by =
      formula(formatted_quotient((*offset.conic->form)[0], notation, "m"), notation);
  if (!offset.once)
    return "rational for both sides together, by " + formula("t =", notation) + " " + by;
  return "rational for both sides together, traced several times by " + formula("s =", notation) +
         " " + formula(formatted_quotient(offset.once->parameter, notation, "t"), notation) +
         ", by " + formula("s =", notation) + " " + by;
}

JsonOutput json_of(const OffsetKind& offset) {
  using Kind = OffsetKind::Kind;
  JsonOutput said = {{"kind", offset.kind == Kind::each_side   ? "each-side"
                              : offset.kind == Kind::two_sided ? "two-sided"
                              : offset.kind == Kind::none      ? "none"
                                                               : "undecided"},
                     {"squarefree", json_of(offset.squarefree)},
                     {"radicand", to_string(offset.radicand)}};
  if (offset.prime != 0) said["no_point_modulo"] = to_string(offset.prime);
  if (offset.once) said["s"] = json_of(offset.once->parameter);
  if (offset.conic) said["t"] = json_of((*offset.conic->form)[0]);
  return said;
}

std::string write_named(const std::string& name, const std::vector<Path>& paths) {
  std::vector<NamedPath> named;
  for (const Path& path : paths) named.emplace_back(name, path);
  return write_paths(named);
}

}  // namespace phrame
