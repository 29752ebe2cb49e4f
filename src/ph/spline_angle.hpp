#pragma once
#include <deque>
#include <map>

#include "phrame/ph/rmf_angle.hpp"
#include "phrame/ph/spline.hpp"

namespace phrame {

/// The angle θ of the rotation-minimizing frame relative to the continuous Euler–Rodrigues frame of
/// a spline: θ(0) = 0, θ continuous on [0, end], θ′ = −2h/σ on each segment.
/// Not for concurrent use: evaluations share isolated roots.
class SplineAngle {
 public:
  explicit SplineAngle(Spline spline, Form form = Form::automatic);
  // Stays where it is: a Real from value() refers to its angle.
  SplineAngle(const SplineAngle&) = delete;
  SplineAngle& operator=(const SplineAngle&) = delete;
  ~SplineAngle() = default;

  const Spline& spline() const { return spline_; }
  /// The angle along segment k, counted from its start.
  const RmfAngle& segment(std::size_t k) const { return angles_[k]; }

  /// The way to the values of the segments from now on.
  void take(Route route) {
    for (RmfAngle& angle : angles_) angle.take(route);
  }

  /// θ(t) + start, exact where it is seen to be rational; also where the contributions of different
  /// segments cancel. Refers to this object. Throws DomainError for t outside [0, end].
  Real value(const Rational& t, const Angle& start = {});
  /// The same; at.t may be any number, with which the segment is continued.
  Real value(const SplineParameter& at, const Angle& start = {});
  /// A ball around θ(at) with a radius ≤ 2^−bits · max(1, |θ(at)|); the sums up to the joints are
  /// kept. at.t may be any number.
  RealBall enclose(const SplineParameter& at, long bits);
  /// Around θ(at) + start, likewise but for what the two cancel.
  RealBall enclose(const SplineParameter& at, const Angle& start, long bits);
  /// z ∈ ℚ(i) with e^{iθ} = z/|z|, where each segment up to there has an RmfAngle::direction().
  std::optional<GaussianRational> direction(const SplineParameter& at);

  /// (θ(at) + offset + arg phase(1) − arg phase(0))/π where that is rational: decided or recognised
  /// as Evaluator::multiple_of_pi does. No value means that it is irrational or not recognised. The
  /// phase has no zero on [0, 1].
  std::optional<Rational> multiple_of_pi(const SplineParameter& at, const GaussianPolynomial& phase,
                                         const Rational& offset = 0) const;

  /// By which angle in (−π, π] the rotation-minimizing frame comes back turned about the tangent
  /// r′/|r′| of a closed spline: f₂(end) = cos(·) f₂(0) + sin(·) T × f₂(0). It does not depend on
  /// the preimages. Exact where it is seen to be 0. No value where the spline has no
  /// closing_turn(). Refers to this object. Throws Undecided where it can't be told from ±π.
  std::optional<Real> holonomy();

 private:
  /// A joint, the start of a segment, with a rational θ.
  struct Joint {
    std::size_t segment = 0;
    Rational theta;
  };

  RealBall sum_before(std::size_t segment, long bits);
  RealBall rational_ball(const SplineParameter& at);
  bool may_be_rational(const SplineParameter& at, const Angle& start);
  const Joint& last_joint(std::size_t segment);
  Real value_after(const Joint& joint, const SplineParameter& at, const Angle& start);
  Rational rational_part(std::size_t from, const SplineParameter& at) const;
  Antiderivative over_unit_interval(std::size_t from, const SplineParameter& at) const;

  Spline spline_;
  std::deque<RmfAngle> angles_;
  std::map<long, std::vector<RealBall>> sums_;       ///< θ(0), θ(1), … by precision
  std::vector<RealBall> rational_sums_{RealBall()};  ///< of these, what has no logarithm
  std::vector<Joint> joints_{{}};                    ///< with a rational θ, ascending
  std::size_t joints_known_ = 0;                     ///< up to there they are looked for
  std::vector<GaussianRational> directions_{{1, 0}};  ///< of θ(0), θ(1), …, as far as there are any
};

}  // namespace phrame
