#pragma once
#include "phrame/ph/twist/twist_frame.hpp"

namespace phrame {

/// A number that is not negative: correctly rounded, or, where it may be 0, an upper bound.
struct ErrorSize {
  Decimal value;
  std::string in_short;  ///< the number, rounded once to six digits for a table
  bool is_bound = false;
};

/// What is shown of one piece of a rational frame of minimal twist.
struct TwistPieceReport {
  Rational from;
  Rational to;
  long frame_degree;     ///< of f₂ and f₃
  long rotation_degree;  ///< of w
  Decimal gamma;
  std::string gamma_in_short;  ///< rounded once to six digits
  struct Radii {
    std::string radius;   ///< no coefficient of the best w is farther away
    std::string gamma;    ///< nor its γ
    bool is_of_one_sign;  ///< the best with its sign of γ only
  };
  std::optional<Radii> proved;  ///< where w is proved to be next to the best one
  std::string doubt;            ///< else why not
  std::vector<std::pair<Decimal, Decimal>> coefficients;  ///< of w, Bernstein, complex
  Integer extra_turns;
  ErrorSize
      root_mean_square;  ///< of Ω₁ − Ω̄₁, relative to |Ω̄₁|, or times the length where that is 0
  ErrorSize greatest;  ///< |Ω₁ − Ω̄₁|, likewise
  Monotone monotone;
  std::vector<Decimal> inflections;  ///< the parameters where Ω₁ changes its sign
  /// The best rotation with the other sign of γ, and its root mean square; not proved.
  std::optional<std::pair<Decimal, ErrorSize>> other;
};

struct TwistFrameReport {
  std::vector<TwistPieceReport> pieces;
  ErrorSize root_mean_square;  ///< of the whole frame
  Monotone monotone;
  bool is_relative;  ///< are the errors relative to |Ω̄₁|, which is not 0?
};

/// Throws Undecided, naming what it is that cannot be rounded.
TwistFrameReport twist_frame_report(const MinimalTwist& mtf, const TwistFrame& frame, long digits);

std::string to_text(const TwistFrameReport& report);

}  // namespace phrame
