#pragma once
#include <variant>

#include "phrame/export.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// A rotation-minimizing frame that is rational: θ = 2·arg w, that is Im(w′/w) = −h/σ [Han 2008].
struct RationalFrame {
  /// Monic, without real factor and without zero in common with its conjugate.
  GaussianPolynomial w;
  /// B = A·w without its greatest real factor, A being α + kβ and B = αw + kβw: the
  /// Euler–Rodrigues frame of B is rotation-minimizing and has the tangent of A. The components
  /// of the frame are quotients of polynomials of degree ≤ 2·degree(B), and no other frame of
  /// this form has a lower degree.
  QuaternionPolynomial preimage;
};

/// Why there is none: e^{iθ} is rational iff 2h/σ has only simple poles and residues in iℤ.
struct NoRationalFrame {
  /// What 2h/σ has.
  enum class Reason { multiple_pole, residue };
  Reason reason;  ///< which of the two
  /// Of multiple poles: the polynomial that has them all, each once. Else the factor of the
  /// squarefree residue polynomial of 2h/σ that has the roots which are not in iℤ.
  Polynomial factor;
  friend bool operator==(const NoRationalFrame&, const NoRationalFrame&) = default;
};

/// Decides whether the curves with the preimage A ≠ 0 have a rational rotation-minimizing frame
/// ("RRMF curves"). Cost: the residue polynomial of 2h/σ.
PHRAME_API std::variant<RationalFrame, NoRationalFrame> rational_frame(
    const QuaternionPolynomial& a);

}  // namespace phrame
