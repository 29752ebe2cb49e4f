#pragma once
#include "phrame/algebra/shared.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/frame_through.hpp"
#include "phrame/ph/twist/twist_frame.hpp"

namespace phrame::inline v0 {

/// A frame along a path that has given orientations at the ends and at joints of it, and turns
/// about e₁ as little as it can. With ω the rate of its turning per unit of length and φ = ∫ω ds,
/// the angle against the rotation-minimizing frame, φ is known at those joints up to whole turns,
/// so many of which are taken that each leg from one to the next turns by an angle in (−π, π].
///   - Even: ω is constant along each leg. By Cauchy and Schwarz ∫ω² ds ≥ T²/S along a leg of the
///     length S with the turn T, where ω is constant only equal: no frame that has these
///     orientations has a lesser ∫ω² ds. ω jumps at the joints.
///   - Smooth: φ is the natural cubic spline of s, of a path that closes with its frame the
///   periodic
///     one: ω is continuous and ω′, too, and of all such the one with the least ∫ω′² ds [Holladay
///     1957]. (With ω continuous there is none with the least ∫ω² ds: the even one is their limit.)
/// Copies share what was found; any thread may ask.
class PHRAME_API PathTwist {
 public:
  /// From a joint with an orientation to the next one.
  struct Leg {
    std::size_t first;                                    ///< its first segment
    std::size_t segments;                                 ///< so many
    MinimalTwist twist;                                   ///< along these, by themselves
    std::size_t end() const { return first + segments; }  ///< the joint where it ends
  };

  /// One leg, the whole path.
  PathTwist(MinimalTwist whole);  // NOLINT(google-explicit-constructor)
  /// Throws DomainError as start_angle(), for an f₂ along the tangent, and where e₁ is not r′/|r′|
  /// at the start of a leg, as behind a cusp; for the angle to a Frenet frame, and for joints that
  /// are not of the path.
  PathTwist(const PathAngle& rmf, const FrameThrough& through);

  const PathAngle& rmf() const { return rmf_; }           ///< θ_RMF of the whole path
  const std::vector<Leg>& legs() const { return legs_; }  ///< at least one
  bool is_smooth() const { return slopes_ != nullptr; }   ///< is ω continuous?
  std::size_t leg_at(const Place& at) const;              ///< the number of the one of the segment
  Place on_leg(const Place& at) const;                    ///< the same place on that
  bool is_joint(const Place& at) const;                   ///< is an orientation given there?

  /// @{ The angle of the frame to (e₂, e₃) there, where the orientation is given exact as that is;
  /// the second less whole turns.
  Real value(const Place& at) const;
  Real reduced_value(const Place& at) const;
  /// @}
  /// φ at the end of leg k, counted from the start: the turns of the legs up to there.
  Real turn_after(std::size_t k) const;
  Real rate(const Place& at) const;        ///< ω, of the later leg at a joint
  Real rate_slope(const Place& at) const;  ///< ω′ by s
  /// @{ ω at the start and the end of leg k.
  Real rate_at_start(std::size_t k) const;
  Real rate_at_end(std::size_t k) const;
  /// @}
  Real squared_rate() const;   ///< ∫ω² ds
  Real squared_slope() const;  ///< ∫ω′² ds; 0 along legs that turn evenly

  /// The frame there, exact where the orientation is given and that is exact.
  Frame<Real> frame(const Place& at) const { return frame(at, reference_frame(rmf_, at)); }
  /// The same, the reference frame there being given.
  Frame<Real> frame(const Place& at, const Frame<Real>& reference) const;

 private:
  struct Slopes;  ///< ω at the joints of a smooth frame
  struct Bend;    ///< what ω is beyond T/S on a leg
  Bend bend_of(std::size_t k) const;
  Real share(const Leg& leg, const Place& at) const;
  Real beyond_even(const Place& at) const;

  PathAngle rmf_;
  std::vector<Leg> legs_;
  std::vector<Integer> turns_before_;  ///< whole ones, that θ at the start of a leg lacks
  std::shared_ptr<const Slopes> slopes_;
};

/// Rational frames near one that turns evenly, a frame for each leg, with its orientations at both
/// ends. Points of the subdivision are parameters of the whole path. Throws as twist_frame(), and
/// DomainError for a smooth frame.
PHRAME_API std::vector<TwistFrame> twist_frames(const PathTwist& twist,
                                                const RationalTwistOptions& options,
                                                const Subdivision& subdivision);

}  // namespace phrame
