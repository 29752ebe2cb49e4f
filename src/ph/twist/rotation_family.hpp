#pragma once
#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/ph/twist/twist_piece.hpp"

namespace phrame::inline v0 {

/// w(τ) = a(τ) + i·b(τ), which turns by θ = 2·arg w [Farouki, Moon 2018, (29)].
struct Rotation {
  BallPolynomial a;  ///< Re w
  BallPolynomial b;  ///< Im w
};

/// The rotations w of one degree that turn a piece's frame as its ends ask: w = w⁰ + Σ pₖ wᵏ with
/// real p. All have w(0) = 1 (θ is counted from there) and w(1) = γ·e^{iΔθ/2}. Where the rates at
/// the ends are to be matched, they have
///   Im w₁ = ρ₀/(2n),  Im(w̄ₙ₋₁wₙ) = γ²ρ₁/(2n);
/// of degree 2 these are the line 4sx − ρ₁γ = ρ₀c in the plane of γ and x = Re w₁, with s, c the
/// sine and cosine of Δθ/2, which needs no division by s as (35) does.
struct RotationFamily {
  std::vector<Rotation> basis;       ///< w⁰, w¹, …
  std::vector<RealBall> end_factor;  ///< γ = γ⁰ + Σ pₖ γᵏ
  /// How many p there are.
  std::size_t parameters() const { return basis.size() - 1; }
};

/// Degree n ≥ 1; the rates can be matched from n = 2 on. Throws DomainError for others, and where
/// no quadratic w matches them: for Δθ ∈ 2πℤ and ρ₁ = 0 ≠ ρ₀. Throws Undecided where that cannot be
/// told at `bits`.
RotationFamily rotation_family(const TwistPiece& piece, long degree, EndRates rates, long bits);

/// @{ The w with these parameters, numbers or balls around them, and its γ.
Rotation member(const RotationFamily& family, const std::vector<RealBall>& parameters, long bits);
Rotation member(const RotationFamily& family, const std::vector<Rational>& parameters, long bits);
RealBall end_factor(const RotationFamily& family, const std::vector<Rational>& parameters,
                    long bits);
/// @}

/// The n + 1 Bernstein coefficients of a w of degree n or less.
std::vector<ComplexBall> to_bernstein(const Rotation& w, long n, long bits);
/// @{ a² + b² and a·b′ − a′·b: θ′ = 2(ab′ − a′b)/(a² + b²) (24).
BallPolynomial norm(const Rotation& w, long bits);
BallPolynomial wronskian(const Rotation& w, long bits);
/// @}

/// ∫ θ′ = 2(arg w(to) − arg w(from)), the argument continuous. No value where it cannot be told
/// that w has no zero on [from, to] ⊂ [0, 1].
std::optional<RealBall> turn(const Rotation& w, const Rational& from, const Rational& to,
                             long bits);

}  // namespace phrame
