#pragma once
#include "phrame/answer/boundary_end.hpp"
#include "phrame/answer/offset.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

// What the reports of offsets and of envelopes share.

/// Is the fraction so long that a text has its decimal instead? JSON has it.
bool is_long(const Rational& x);
/// "t = 1/2".
std::string at(const std::string& t, Notation notation);
/// The same of a number in words.
template <class T>
std::string at_place(const T& t, Notation notation) {
  return formula("t =", notation) + " " + in_words(t, notation);
}
/// A heading for each, in JSON as curve files.
Value paths_value(const std::vector<Path>& paths);
/// "the join at t = 1/2"; a long fraction as its decimal.
std::string in_words(const BoundaryEnd& end, const std::string& before, Notation notation);
/// "(1.5, 2)".
std::string point_in_words(const std::array<Decimal, 2>& point, Notation notation);
JsonOutput json_of(const BoundaryEnd& end);
/// "t = 1/2", or "the join at t = 1/2".
std::string in_words(const OffsetAnswer::Place& place, Notation notation);
/// "17/3 + 2π ≈ 11.9", "17/3", or the digits alone where it is not known or long.
std::string in_words(const OffsetAnswer::Measure& x, Notation notation);
/// "rational to each side, over ℚ(√3)", by what is under the square root, in words.
std::string in_words(const OffsetKind& offset, const std::string& radicand, Notation notation);
JsonOutput json_of(const OffsetKind& offset);
/// As curve files, each with that name.
std::string write_named(const std::string& name, const std::vector<Path>& paths);

}  // namespace phrame
