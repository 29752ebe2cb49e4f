#pragma once
#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame {

/// The angle and the frame as polynomials with a proof, docs/compiled.md.
struct CompiledQuery {
  /// The frame that θ is measured from; as PathAngle(path) has it if there is none.
  std::optional<Reference> reference = {};
  std::optional<Vector<Rational>> up = {};  ///< v, where it is the frame of this vector
  FrameStart start = {};                    ///< θ(0), or where f₂ is at t = 0
  double from = 0;  ///< of a PH curve by itself, not to the frame of v; others are compiled whole
  double to = 1;    ///< > from
};

/// Polynomials for a whole path: to_c_header() writes them.
struct CompiledAnswer {
  NamedPath path;                                 ///< as asked
  Reference reference;                            ///< the frame that θ is measured from
  FrameStart start;                               ///< as asked
  std::variant<FrameAngle, Decimal> start_angle;  ///< θ(0)
  PiecewisePolynomial angle;                      ///< of plain_shape(1)
  std::optional<PiecewisePolynomial> rotation;    ///< of plain_shape(4); not of a Frenet frame
  /// v, where the angle is to the frame of one.
  std::optional<Vector<Rational>> up = {};
};

/// Throws as PathAngle, start_angle(), compiled_angle() and compiled_rotation().
CompiledAnswer answer(const NamedPath& path, const CompiledQuery& query);

/// @{ With rounding, what is computed from the polynomials in doubles is off by at most so much:
double angle_error(const CompiledAnswer& answer);      ///< in radians
double component_error(const CompiledAnswer& answer);  ///< of a frame vector; 0 without a rotation
/// @}

}  // namespace phrame
