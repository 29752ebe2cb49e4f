#pragma once
#include <utility>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/along/parametrization.hpp"
#include "phrame/ph/curve/transform.hpp"

namespace phrame::inline v0 {

/// Asks for all of a rational curve, for parts of a path, for the path the other way round and in
/// another place: in this order.
struct TransformQuery {
  bool is_whole_line = false;           ///< first of all, all of a rational curve, whole_line()?
  ParameterKind by = ParameterKind::t;  ///< what the next two are values of
  std::vector<Rational> split = {};     ///< ascending: where it is cut
  /// From the one to the other, instead of all of it; backwards where that is before it.
  std::optional<std::pair<Rational, Rational>> part = {};
  bool is_reversed = false;  ///< from its end to its start?
  AffineMap map = {};        ///< that it is under
};

/// The parts, one where nothing is cut, with what is to be said of them in their notes. A cut at an
/// irrational t is at the multiple of 2^−64 next to it. Orientations that come with the path are
/// turned by a similarity; else they are left out. Throws DomainError for a cut that is not inside
/// the path, not behind the one before, and as whole_line(), segment() and transformed().
PHRAME_API std::vector<NamedPath> answer(const NamedPath& named, const TransformQuery& query);

}  // namespace phrame
