#pragma once
#include <memory>

#include "phrame/algebra/rounding.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0 {

class PiecewisePolynomial;

/// Asks for the angle and the frame as polynomials with proved errors: docs/compiled.md.
struct CompiledQuery {
  /// The frame that θ is measured from. Without it, the one that PathAngle(path) takes.
  std::optional<Reference> reference = {};
  std::optional<Vector<Rational>> up = {};  ///< v, where it is the frame of this vector
  FrameStart start = {};                    ///< θ(0), or where f₂ is at t = 0
  /// The least t, of a single PH curve by erf or frenet; others are compiled from start to end.
  double from = 0;
  double to = 1;  ///< the greatest t, likewise; > from
};

/// Polynomials for a whole path: to_c_header() writes them.
struct CompiledAnswer {
  NamedPath path;                                 ///< as asked
  Reference reference;                            ///< the frame that θ is measured from
  FrameStart start;                               ///< as asked
  std::variant<FrameAngle, Decimal> start_angle;  ///< θ(0)
  /// @{ The angle, and the unit quaternion of the frame; null for that of a Frenet frame.
  std::shared_ptr<const PiecewisePolynomial> angle;
  std::shared_ptr<const PiecewisePolynomial> rotation = nullptr;
  /// @}
  /// v, where the angle is to the frame of one.
  std::optional<Vector<Rational>> up = {};
};

/// Throws as PathAngle, start_angle(), CompiledAngle and CompiledFrames.
PHRAME_API CompiledAnswer answer(const NamedPath& path, const CompiledQuery& query);

/// @{ With rounding, what is computed from the polynomials in doubles is off by at most so much:
PHRAME_API double angle_error(const CompiledAnswer& answer);  ///< in radians
PHRAME_API double component_error(
    const CompiledAnswer& answer);  ///< of a frame vector; 0 without a rotation
/// @}

}  // namespace phrame
