#pragma once
#include "phrame/answer/angle.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/twist/path_twist.hpp"

namespace phrame::inline v0 {

/// How does the frame turn that has the orientations which come with a path?
struct PathTwistQuery {
  std::vector<Rational> at = {};  ///< where θ is asked for: values of t, or of `by`
  long digits = 17;               ///< of all numbers
  /// v of the frame that angles are to; without it as angle_to() has it.
  std::optional<Vector<Rational>> up = {};
  ParameterKind by = ParameterKind::t;  ///< what `at` are values of
  long samples = 0;                     ///< and so many, equally spaced; none or 2 and more
};

/// The frame of least twist through given orientations, or the smooth one.
struct PathTwistAnswer {
  /// From one orientation to the next.
  struct Leg {
    std::size_t from;       ///< the joint where it starts
    std::size_t to;         ///< and where it ends
    Decimal length;         ///< S
    Decimal twist;          ///< T
    Decimal rate_at_start;  ///< ω there
    Decimal rate_at_end;    ///< the same of one that turns evenly
    /// As MinimalTwistAnswer has it.
    std::string half_turn_within;
  };
  NamedPath path;                           ///< as asked, with its orientations
  std::vector<Leg> legs;                    ///< one after the other
  Decimal length;                           ///< of the path
  Decimal twist;                            ///< ∫ω ds
  Decimal squared_rate;                     ///< ∫ω² ds
  Decimal squared_slope;                    ///< ∫ω′² ds of a smooth one
  std::vector<AngleValue> values;           ///< θ where it is asked for
  long digits;                              ///< of all numbers
  std::optional<Vector<Rational>> up = {};  ///< v, where angles are to the frame of it
  ParameterKind by = ParameterKind::t;      ///< of the values
};

/// Throws DomainError for a path without orientations, and as PathTwist; Undecided where a number
/// cannot be rounded.
PHRAME_API PathTwistAnswer answer(const NamedPath& path, const PathTwistQuery& query);

}  // namespace phrame
