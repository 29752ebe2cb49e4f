#pragma once
#include "phrame/answer/angle.hpp"
#include "phrame/ph/along/path_angle.hpp"

namespace phrame {

/// Which angle is the rotation-minimizing frame of a curve of any kind at? Beside what an
/// AngleQuery has that needs a closed form.
struct SmoothAngleQuery {
  Reference reference = Reference::up;      ///< the frame that θ is measured from
  std::optional<Vector<Rational>> up = {};  ///< v; one that does is chosen if there is none
  FrameStart start = Angle();               ///< θ(0), or where f₂ is at t = 0
  std::vector<Rational> at = {};            ///< the t where θ is asked for
  long digits = 17;                         ///< of its values
};

/// The angle of the rotation-minimizing frame of a path of any kind.
struct SmoothAngleAnswer {
  NamedPath path;                   ///< as asked
  Reference reference;              ///< the frame that θ is measured from
  Vector<Rational> up;              ///< v, given or chosen
  FrameStart start;                 ///< as asked
  Decimal start_angle;              ///< θ(0); of a vector in (−π, π]
  bool is_zero;                     ///< is θ − θ(0) = 0 all along?
  std::vector<AngleValue> values;   ///< at the t asked for, in their order
  long digits;                      ///< of the values
  Decimal total;                    ///< θ(end) − θ(0)
  std::optional<Decimal> holonomy;  ///< of a closed path, to the frame of v
  /// Why a number that a closed path has is not there: it is undecided.
  std::string no_holonomy = {};
  bool is_straight = false;  ///< a line, where any frame that does not turn is the right one?
};

/// Throws DomainError as PathAngle and locate(); Undecided, with the name of what it is, where a
/// value cannot be rounded.
SmoothAngleAnswer answer(const NamedPath& path, const SmoothAngleQuery& query);

}  // namespace phrame
