#pragma once
#include <array>
#include <memory>
#include <optional>

#include "phrame/ph/curve/curve_series.hpp"

namespace phrame::inline v0 {

/// [lower, upper]; without an end where that is infinite.
struct DoubleInterval {
  double lower;
  double upper;
};
/// With all numbers of the ball; of all numbers where it has no bounds.
DoubleInterval doubles_around(const RealBall& x);
/// Two coordinates.
using PlaneBox = std::array<DoubleInterval, 2>;
/// Two coordinates of a curve.
using PlaneSeries = std::array<BallPolynomial, 2>;

/// Have the boxes no point in common?
bool are_apart(const PlaneBox& a, const PlaneBox& b);
/// What both have in common, where that is not nothing.
PlaneBox common_of(const PlaneBox& a, const PlaneBox& b);
/// The least box around both.
PlaneBox hull_of(const PlaneBox& a, const PlaneBox& b);
/// Are all vectors of the box in an open half-plane?
bool is_one_way(const PlaneBox& velocity);
/// Is a × b ≠ 0 for all vectors of the boxes?
bool are_transversal(const PlaneBox& a, const PlaneBox& b);

/// A part of a curve: [lower, upper] of one segment, or several whole segments. Where the turning
/// of the curve is not known, its velocity is its direction, and nothing turns back.
struct CurveNode {
  std::size_t first_segment = 0;
  std::size_t last_segment = 0;  ///< included
  double lower = 0;              ///< of the parameter of the first segment
  double upper = 1;              ///< of that of the last one
  PlaneBox box{};                ///< the projected part is in it
  PlaneBox velocity{};           ///< and its derivative in this one
  PlaneBox middle{};             ///< of an arc, the point in the middle of its parameters
  PlaneBox slope{};              ///< the derivative there
  PlaneBox bend{};               ///< half of the second derivative on the arc is in this one
  PlaneBox direction{};          ///< H is in this one
  long reversals = 0;  ///< how often it turns back; more than 1 where there is a gap in it, too
  int first_sign = 1;  ///< of p where it starts
  int last_sign = 1;   ///< and where it ends
  int turn = 0;        ///< the sign of H × H′ on an arc; 0 where it is not known or changes
  bool is_straight = false;          ///< is an arc known to be one?
  bool parts_at_reversals = false;   ///< as SegmentTurning has it, and all joints are smooth
  bool has_break = false;            ///< of these, at an end, too
  std::optional<bool> is_idle = {};  ///< what a CrossingQuery says of it, once it was asked
  std::array<std::unique_ptr<CurveNode>, 2> halves = {};

  bool is_arc() const { return first_segment == last_segment; }  ///< is it of one segment?
};

/// All t of an arc.
RealBall arc_parameter(const CurveNode& arc);
/// The middle of a ball, exactly.
RealBall midpoint_of(const RealBall& x);

/// Do the arcs lie apart, seen along a normal of the first one? So do those of nearly parallel
/// branches, whose boxes have points in common.
bool are_apart_across(const CurveNode& a, const CurveNode& b);
/// Are both long beside how far they go across the first one, or that beside what doubles are
/// rounded by?
bool are_nearly_parallel(const CurveNode& a, const CurveNode& b);

/// A curve, projected along v to a plane, in parts of parts.
class CurveTree {
 public:
  CurveTree(CurveSeries curve, const Vector<Rational>& v);

  CurveNode& root() { return *root_; }
  /// Makes the halves of the node, where it has none. An arc is cut near its middle.
  void split(CurveNode& node);
  /// Does the one end where the other begins?
  bool share_end(const CurveNode& a, const CurveNode& b) const;
  /// @{ Is it seen that the part does not meet itself, or the two parts, which share an end, not
  /// each other anywhere else? Or, that is, not where it goes one way, if only one of the branches
  /// is asked for where it turns back.
  bool is_simple(const CurveNode& node, bool is_one_branch_asked) const;
  bool are_simple(const CurveNode& a, const CurveNode& b, bool is_one_branch_asked) const;
  /// @}
  /// Is it seen that one of two parts leads to the other on a way that does not turn back, or once
  /// where branches part, all directions of which are in one open half-plane? Then they do not
  /// meet, but where they share an end. What is between them is halved as far as it turns.
  bool are_on_one_way(const CurveNode& a, const CurveNode& b);
  /// Does what is behind the segment begin along the tangent at its end?
  bool is_smooth_behind(std::size_t segment) const;

  /// The projected curve, and the curve itself, around t.
  PlaneSeries series(std::size_t segment, const RealBall& t, long length, long bits) const;
  Vector<BallPolynomial> space_series(std::size_t segment, const RealBall& t, long length,
                                      long bits) const {
    return curve_.position(segment, t, length, bits);
  }

 private:
  std::unique_ptr<CurveNode> make_segment(std::size_t segment) const;
  std::unique_ptr<CurveNode> make_arc(std::size_t segment, double lower, double upper,
                                      const PlaneBox& around) const;
  std::unique_ptr<CurveNode> make_group(std::size_t first, std::size_t last) const;
  void add_turning(CurveNode& arc, const RealBall& all, const RealBall& middle) const;
  PlaneSeries projected(const Vector<BallPolynomial>& r, long bits) const;
  std::size_t behind(std::size_t segment) const;
  DoubleInterval curvature_of(const CurveNode& arc) const;
  bool are_parted(const CurveNode& one, const CurveNode& other) const;
  bool goes_on_into(const CurveNode& a, const CurveNode& b) const;
  bool leads_one_way(const CurveNode& a, const CurveNode& b);

  CurveSeries curve_;
  std::array<Vector<Rational>, 2> axes_;  ///< across v
  std::unique_ptr<CurveNode> root_;
  /// Of each segment the last one up to which each is behind the one before.
  std::vector<std::size_t> last_in_order_;
};

}  // namespace phrame
