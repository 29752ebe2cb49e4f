#pragma once
#include <memory>
#include <optional>

#include "phrame/ph/along/feedrate.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/series_function.hpp"

namespace phrame::inline v0 {

/// One of the functions that a speed v is not greater than, on one segment.
struct SpeedLimit {
  /// Which function it is.
  enum class Kind {
    constant,  ///< `speed` does not depend on its quantity; of a line or an arc, √(A/κ)
    function,  ///< V
    normal,    ///< √(A/κ), A the greatest normal acceleration
  };
  Kind kind;
  Feedrate::Function function;  ///< V
  Real constant;                ///< v, where it is one
  /// v⁴ where it is constant and known exactly, which v need not be.
  std::optional<Rational> fourth_power = {};
  bool depends_on_curvature = false;  ///< also where it is constant on the segment
};

/// v² at a place, and where it is known exactly v⁴.
struct SquaredSpeed {
  Real value;
  std::optional<Rational> square = {};
};
/// The sign of a − b. Throws Undecided where it is not told; `where` ends the message.
int compare(const SquaredSpeed& a, const SquaredSpeed& b, const std::string& where);

/// Speeds along a path, with w = v²: their Taylor series, and signs of what is compared.
class SpeedLimits {
 public:
  /// The normal, with the last component that is not 0 positive, is that of the plane for signed
  /// curvatures; the limits are greater than 0.
  SpeedLimits(const PathLength& length, const Path& path, const Feedrate::Limits& limits,
              std::optional<Vector<Rational>> normal);

  /// The function as a limit.
  SpeedLimit limit(const Feedrate::Function& function) const;
  /// That of the normal acceleration on the segment; none on a straight one. Throws DomainError
  /// where the curve has a cusp.
  std::optional<SpeedLimit> normal_limit(std::size_t segment) const;
  /// Throws DomainError where the segment has a cusp: at that s(t) is not analytic.
  void require_regular(std::size_t segment) const;

  /// Does the form of formulas on both sides show that the curvature is the same before and behind
  /// the joint at which the segment starts?
  bool curvature_goes_on(std::size_t segment) const;

  /// v; of Kind::normal it is analytic where κ ≠ 0.
  SeriesFunction speed(const SpeedLimit& limit, std::size_t segment) const;
  /// ds/dt over v.
  SeriesFunction time_rate(const SpeedLimit& limit, std::size_t segment) const;
  /// A function with the sign of v_a − v_b where both are > 0, analytic where κ = 0, too.
  SeriesFunction difference(const SpeedLimit& a, const SpeedLimit& b, std::size_t segment) const;
  /// The same as a polynomial in t, of the normal limit and a constant along a rational curve.
  std::optional<Polynomial> algebraic_difference(const SpeedLimit& a, const SpeedLimit& b,
                                                 std::size_t segment) const;
  /// A function with the sign of dw/ds − 2·side·A, A the greatest tangential acceleration.
  SeriesFunction excess(const SpeedLimit& limit, int side, std::size_t segment) const;
  /// w at t of the segment.
  SquaredSpeed squared(const SpeedLimit& limit, std::size_t segment, const Real& t) const;

 private:
  struct ExactMotion;
  struct State;

  static ExactMotion exact_motion(const Segment& segment, const RationalCurve& curve);

  std::shared_ptr<const State> state_;
};

}  // namespace phrame
