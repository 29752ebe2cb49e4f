#pragma once
#include "phrame/answer/angle.hpp"
#include "phrame/answer/twist_frame.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0 {

/// Asks for the frame that turns least from one orientation at the start of a path to another at
/// its end.
struct MinimalTwistQuery {
  FrameStart from = {};  ///< θ_i, or f₂ at the start
  /// θ_f, or f₂ at the end. Without it the path is closed, and the frame ends as it starts.
  std::optional<FrameStart> to = LeastRotation();
  long extra_turns = 0;           ///< the number of revolutions beyond the least turn
  std::vector<Rational> at = {};  ///< where θ is asked for: values of t, or of `by`
  long digits = 17;               ///< of all numbers
  /// v, where angles are measured from the frame of v. Without it they are measured from the
  /// Euler–Rodrigues frame on PH paths, and on others from the frame of a v that is chosen.
  std::optional<Vector<Rational>> up = {};
  /// How a rational frame is looked for.
  struct RationalFrame {
    RationalTwistOptions rotation;  ///< the degree of its rotations, and their ends
    Subdivision subdivision;        ///< its pieces
    bool is_needed;                 ///< is it an error if there is none?
  };
  /// Without it only the exact frame is found. Only PH paths have a rational frame, and not with
  /// `up`.
  std::optional<RationalFrame> rational = {};
  ParameterKind by = ParameterKind::t;  ///< what `at` are values of
  long samples = 0;                     ///< and so many, equally spaced; none or 2 and more
};

/// The exact frame of minimal twist, and a rational one near to it.
struct MinimalTwistAnswer {
  NamedPath path;                 ///< as asked
  FrameStart start;               ///< as asked
  std::optional<FrameStart> end;  ///< as asked
  Decimal from;                   ///< θ_i
  Decimal to;                     ///< θ_f
  Real length;                    ///< S, of the path
  Decimal rounded_length;         ///< where it is irrational
  Decimal own_twist;  ///< of the Euler–Rodrigues frame, ∫ 2h/σ dt; or of that of v, ∫ e₂′·e₃ dt
  Decimal nominal_twist;           ///< T
  Decimal twist;                   ///< T_min, with the extra turns
  Decimal rate;                    ///< the twist over S
  std::vector<AngleValue> values;  ///< θ where it is asked for
  long digits;                     ///< of all numbers
  /// Where T_min is π, or cannot be told from it: an upper bound of the difference, "0" or
  /// "1.2e-76". A turn by −π is as short.
  std::string half_turn_within = {};
  std::optional<TwistFrameAnswer> rational = {};  ///< where it was asked for and found
  std::string why_not_rational = {};              ///< where there is none
  std::string why_undecided = {};                 ///< where none was found, or could be shown
  std::optional<Vector<Rational>> up = {};        ///< v, where angles are to the frame of it
  ParameterKind by = ParameterKind::t;            ///< what the values were asked for by
};

/// Throws DomainError as minimal_twist(), and as twist_frame() where a rational frame is needed;
/// Undecided, naming what it is, where a number cannot be rounded.
PHRAME_API MinimalTwistAnswer answer(const NamedPath& path, const MinimalTwistQuery& query);

}  // namespace phrame
