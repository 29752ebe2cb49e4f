#pragma once
#include "phrame/answer/error_size.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/twist/twist_frame.hpp"

namespace phrame::inline v0 {

/// What is shown of one piece of a rational frame of minimal twist.
struct TwistPieceAnswer {
  /// @{ The parameters of the path between which it lies.
  Rational from;
  Rational to;
  /// @}
  long frame_degree;           ///< of f₂ and f₃
  long rotation_degree;        ///< of w
  Decimal gamma;               ///< γ = w(1)e^{−iΔθ/2}
  std::string gamma_in_short;  ///< rounded once to six digits
  /// How near w is to the best one, bounds in few digits.
  struct Radii {
    std::string radius;   ///< no coefficient of the best w is farther away
    std::string gamma;    ///< nor its γ
    bool is_of_one_sign;  ///< the best with its sign of γ only
  };
  std::optional<Radii> proved;  ///< where w is proved to be next to the best one
  std::string doubt;            ///< else why not
  std::vector<std::pair<Decimal, Decimal>> coefficients;  ///< of w, Bernstein, complex
  Integer extra_turns;  ///< of the piece, beyond its share of the twist
  ErrorSize
      root_mean_square;  ///< of Ω₁ − Ω̄₁, relative to |Ω̄₁|, or times the length where that is 0
  ErrorSize greatest;                ///< |Ω₁ − Ω̄₁|, likewise
  Monotone monotone;                 ///< has Ω₁ one sign?
  std::vector<Decimal> inflections;  ///< the parameters where Ω₁ changes its sign
  /// The best rotation with the other sign of γ, and its root mean square; not proved.
  std::optional<std::pair<Decimal, ErrorSize>> other;
};

/// What is shown of a rational frame of minimal twist.
struct TwistFrameAnswer {
  std::vector<TwistPieceAnswer> pieces;  ///< from the start of the path to its end
  ErrorSize root_mean_square;            ///< of the whole frame
  Monotone monotone;                     ///< has Ω₁ one sign on all of it?
  bool is_relative;                      ///< are the errors relative to |Ω̄₁|, which is not 0?
};

/// Throws Undecided, naming what it is that cannot be rounded.
PHRAME_API TwistFrameAnswer rounded(const TwistFrame& frame, const MinimalTwist& mtf, long digits);

}  // namespace phrame
