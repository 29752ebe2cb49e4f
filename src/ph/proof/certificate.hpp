#pragma once
#include "phrame/integrate/root_discs.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/proof/closed_claims.hpp"
#include "phrame/ph/proof/stated_decisions.hpp"
#include "phrame/ph/proof/statement.hpp"

namespace phrame::inline v0 {

/// Σ c(z)·log(t − z) over the roots z of q.
struct CertifiedLogs {
  Polynomial index;             ///< q
  Polynomial residue;           ///< c, modulo q
  std::vector<RootDisc> roots;  ///< those above the real axis; the others are their conjugates
  friend bool operator==(const CertifiedLogs&, const CertifiedLogs&) = default;
};

/// Claims about the rotation-minimizing frame of one curve, and what proves them by arithmetic with
/// integers: docs/certificate.md. This is what is stated, true or not; `certify` makes true ones,
/// `verify` decides.
struct Certificate {
  Curve curve;                   ///< what the claims are about, polynomial or rational
  Reference reference;           ///< what θ is measured from
  Vector<Polynomial> hodograph;  ///< W²r′ = f · A i A*
  Polynomial sigma;              ///< σ = |A|²
  Polynomial h;                  ///< uv′ − u′v − pq′ + p′q
  GaussianPolynomial g;          ///< αβ′ − α′β
  /// θ_ERF′ in lowest terms.
  struct Rate {  ///< −2h = numerator·common, σ = denominator·common
    /// @{ As the equations above say.
    Polynomial numerator;
    Polynomial denominator;
    Polynomial common;
    /// @}
    Integer modulus;  ///< numerator and denominator are coprime modulo this number, mostly a prime
    friend bool operator==(const Rate&, const Rate&) = default;
  } rate;                           ///< −2h/σ
  RationalFunction rational;        ///< of the antiderivative
  std::vector<CertifiedLogs> logs;  ///< of the antiderivative
  long bits;                        ///< the unit of the discs is 2^−bits
  /// What the Frenet frame turns with beside −2h/σ.
  struct Bend {  ///< g = content·polynomial
    /// @{ As the equation above says; the polynomial has no real zero.
    GaussianPolynomial polynomial;
    Polynomial content;
    /// @}
    friend bool operator==(const Bend&, const Bend&) = default;
  };
  std::optional<Bend> bend;        ///< with the Frenet frame
  std::vector<AngleClaim> claims;  ///< values of θ
  StatedDecisions decisions;       ///< of what kinds the curve is
  friend bool operator==(const Certificate&, const Certificate&) = default;
};

/// Claims about the rotation-minimizing frame along several PH curves, one behind the other: θ to
/// the Euler–Rodrigues frame is the sum of those of the segments. What proves them are the
/// certificates of these, with the angles that the sums need (docs/certificate.md).
struct PathCertificate {
  std::vector<Certificate> segments;        ///< at least one, each to the Euler–Rodrigues frame
  std::vector<AngleClaim> claims;           ///< of t from 0 to the number of segments
  std::optional<ClosedClaims> closed = {};  ///< of a closed path
  friend bool operator==(const PathCertificate&, const PathCertificate&) = default;
};

}  // namespace phrame
