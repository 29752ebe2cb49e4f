#pragma once
#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/ph/along/path_angle.hpp"

namespace phrame::inline v0 {

/// The unit quaternion B = A/|A|·e^{i(θ + start_angle)/2} on [from, to] as Taylor polynomials of
/// its four components; the rotation-minimizing frame is (B i B*, B j B*, B k B*), and A is the
/// preimage without its real factor, θ the angle to the Euler–Rodrigues frame. The sign of B may
/// change from piece to piece. Each piece is proved afterwards, whatever it was found by: B
/// satisfies
///   σB′ = V·B − h·B·i,  V the vector part of A′A*,
/// a linear equation with a skew-symmetric matrix, so that for polynomials Q
///   |Q − B| ≤ |Q − B|(center) + ∫|σQ′ − V·Q + h·Q·i|/min σ.
/// `angle` is that of this curve relative to the ERF; shape.width = 4. Throws as compiled_angle.
PiecewisePolynomial compiled_rotation(const Curve& curve, const RmfAngle& angle,
                                      const FrameAngle& start_angle, double from, double to,
                                      const DoubleShape& shape);

/// @{ The unit quaternion B whose (B i B*, B j B*, B k B*) is the rotation-minimizing frame along a
/// path, up to its sign, on [0, end] and on [k, k + 1] for its segment k; θ + start_angle is its
/// angle to the frame that θ is measured from. To the Euler–Rodrigues frame it is found as above.
/// In general the frame turns at e₁ × e₁′, about no part of e₁, so that
///   σB′ = (H × H′)/2·B:
/// a linear equation without roots, by which each piece is proved (rotation_piece, of formulas
/// formula_piece). Precondition: θ is not measured from the Frenet frame.
PiecewisePolynomial compiled_rotation(const PathAngle& angle, const StartAngle& start_angle,
                                      const DoubleShape& shape);
PiecewisePolynomial compiled_rotation(const PathAngle& angle, std::size_t segment,
                                      const StartAngle& start_angle, const DoubleShape& shape);
/// @}

/// The same of a frame that needs no integral: B = A/|A|·e^{iφ/2} with φ = 0 for the
/// Euler–Rodrigues frame and −arg g for Frenet's, g without its real factors, so that it goes on
/// through inflections. With 2dφ′ = −k, where d = σ and k = 0, or d = σ|g|² and k = σ Im(g′ḡ),
///   dB′ = (d/σ)V·B − (k/2)·B·i.
/// [from, to] is of t + origin. Throws DomainError for the Frenet frame of a straight line and for
/// the frame of a vector.
PiecewisePolynomial compiled_rotation(const Curve& curve, Reference reference, double from,
                                      double to, double origin, const DoubleShape& shape);

/// error ← what the components of the frame of a quaternion Q with |Q − B| ≤ error are off by, |B|
/// = 1, not rounded down. T is double or Wide<n>.
template <class T>
[[gnu::always_inline]] inline void to_frame_error(T& error) {
  error = (2.0 * error + 2.0 * error * error) * (1 + 0x1p-51);
}
inline double frame_error(double error) {
  to_frame_error(error);
  return error;
}

}  // namespace phrame
