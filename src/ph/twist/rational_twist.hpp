#pragma once
#include <memory>

#include "phrame/export.hpp"
#include "phrame/ph/twist/twist_piece.hpp"

namespace phrame::inline v0 {

struct Rotation;
struct SignChanges;

/// A rational frame along a piece: the Euler–Rodrigues frame turned by θ(τ) = θ(0) + 2·arg w(τ),
/// with w of degree n, so that f₂, f₃ are rational of degree 2m + 2n where the preimage has degree
/// m. Copies share what has been computed; any thread may ask them. To move one is to copy it.
class PHRAME_API RationalTwist {
 public:
  /// The member of a family with these parameters. A guess of its mean square, where there is one,
  /// saves precision.
  RationalTwist(TwistPiece piece, long degree, EndRates rates, std::vector<Rational> parameters,
                double mean_square_guess = 0);
  RationalTwist(const RationalTwist&) = default;
  RationalTwist& operator=(const RationalTwist&) = default;
  ~RationalTwist() = default;

  const TwistPiece& piece() const;  ///< along which it is
  long degree() const;              ///< n

  /// w, with w(0) = 1.
  const Rotation& rotation(long bits) const;
  /// w(1) = γ·e^{iΔθ/2}.
  Real end_factor() const;
  /// By how much γ changes at most where the one parameter of the family does by this.
  Rational end_factor_change(const Rational& radius) const;
  /// The n + 1 Bernstein coefficients of w times e^{iθ(0)/2}, as the paper has them.
  std::vector<std::pair<Real, Real>> coefficients() const;

  /// The turn about e₁ is piece().twist + 2π·extra_turns(). Throws Undecided where w cannot be told
  /// to have no zero on [0, 1].
  Integer extra_turns() const;
  /// The root mean square of Ω₁ − Ω̄₁ along the piece, times its length.
  Real root_mean_square() const;
  /// The maximum of |Ω₁ − Ω̄₁| along the piece, times its length.
  Real greatest_error() const;
  /// Where Ω₁ changes its sign, as values of τ, to 2^−bits or better.
  SignChanges inflections(long bits) const;
  /// The sign of Ω₁ at τ; 0 where it cannot be told.
  int sign_of_rate(const Rational& tau) const;

  /// θ at τ ∈ [0, 1].
  Real value(const Real& tau) const;

 private:
  struct State;

  std::shared_ptr<const State> state_;
};

/// The quadratic w with matched rates whose γ is this one, up to 2^−100 of its size: not the best
/// one. Throws DomainError for γ = 0, where w would have a zero at the end, and where the rates fix
/// γ or Δθ ∈ 2πℤ (rotation_family()); Undecided where 8192 bits are too few, as for γ = 10^−3000.
PHRAME_API RationalTwist twist_with_end_factor(const TwistPiece& piece, const Rational& gamma);

/// The member of a family with one parameter that has the least mean square G, proved: it is the
/// only one and within `radius` of this parameter.
struct TwistMinimum {
  Rational parameter;      ///< p₁ of the RotationFamily
  Rational radius;         ///< > 0
  bool is_for_both_signs;  ///< of γ; else among those with its sign
};

/// Whether a rotation is proved to be the best of its degree. Where there is one for each sign of
/// γ, the best is the one whose frame turns by T, and the better of both if that is true of both or
/// of neither.
struct BestTwist {
  RationalTwist twist;  ///< the best that was found
  /// Where it is proved: the best of all, or, if the other one is better, of those with its sign.
  std::optional<TwistMinimum> minimum;
  std::string doubt;  ///< else why not
  /// The best with the other sign of γ, not proved; where it was looked for.
  std::optional<RationalTwist> other;
};

/// The rotations that are looked for, and how exactly.
struct RationalTwistOptions {
  long degree = 2;                     ///< of w, 1 to 8
  EndRates rates = EndRates::matched;  ///< of degree ≥ 2
  bool prove = true;                   ///< that it is the best, where there is one parameter
  long bits = 80;                      ///< for the parameter then: its radius is about 2^−bits
};

/// The rotation of this degree, or a lower one if none better was found, whose Ω₁ deviates least
/// from Ω̄₁ in the mean square (36): for degree 1, and for degree 2 with matched rates, Brent's
/// method and the proof; else NLopt's SLSQP from the best of the degree below. Throws DomainError
/// for a degree that is not offered, and where there is no such rotation; Undecided where none was
/// found.
PHRAME_API BestTwist best_twist(const TwistPiece& piece, const RationalTwistOptions& options);

}  // namespace phrame
