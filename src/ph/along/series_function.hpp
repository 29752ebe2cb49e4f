#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {

/// The Taylor series of a real function around t, in z, t + z; of a ball t the balls of all series
/// around its points. Not finite where the function is not seen to be analytic there.
using SeriesFunction = std::function<BallPolynomial(const RealBall& t, long length, long bits)>;

/// The sign of f at t. Throws Undecided where 1024 bits do not tell it from 0, and it is not
/// computed without an error.
int sign_at(const SeriesFunction& f, const Rational& t);

/// Where f changes its sign in (lower, upper), ascending, each to any number of bits. Parts are
/// halved until f or f′ has no zero in one. Throws Undecided where that is not seen
/// within 2^−40, as at a multiple zero; its message is `what`, "feedrate: …", and where.
std::vector<Real> sign_changes(const SeriesFunction& f, const Rational& lower,
                               const Rational& upper, const std::string& what);

/// The same in (a, b). f is asked for next to these, too, if they are not exact.
std::vector<Real> sign_changes(const SeriesFunction& f, const Real& a, const Real& b,
                               const std::string& what);
/// The sign of a − b. Throws Undecided where 2048 bits do not tell it.
int order(const Real& a, const Real& b);
/// @{ A number of [0, 1] that is at most t, and one that is at least t; t where that is exact.
Rational below(const Real& t);
Rational above(const Real& t);
/// @}

/// t ↦ ∫ f from `lower` to t, by Taylor polynomials on parts of [lower, upper], of which the rest
/// is bounded by the next coefficient on the whole part (Lagrange). Copies share what was found;
/// any thread may ask.
class SeriesIntegral {
 public:
  SeriesIntegral(SeriesFunction f, const Rational& lower, const Rational& upper);

  /// A ball with a radius of about 2^−bits, of all t of a ball. Throws Undecided where f is not
  /// seen to be analytic within parts of 2^−60.
  RealBall enclose(const RealBall& t, long bits) const;
  /// f on the ball.
  RealBall rate(const RealBall& t, long bits) const;

 private:
  struct Part;
  struct State;

  std::shared_ptr<State> state_;
};

}  // namespace phrame
