#pragma once
#include <array>
#include <memory>

#include "phrame/ph/curve/curve_series.hpp"

namespace phrame {

/// [lower, upper]; without an end where that is infinite.
struct DoubleInterval {
  double lower;
  double upper;
};
/// Two coordinates.
using PlaneBox = std::array<DoubleInterval, 2>;
/// Two coordinates of a curve.
using PlaneSeries = std::array<BallPolynomial, 2>;

/// Have the boxes no point in common?
bool are_apart(const PlaneBox& a, const PlaneBox& b);
/// The least box around both.
PlaneBox hull_of(const PlaneBox& a, const PlaneBox& b);
/// Are all vectors of the box in an open half-plane?
bool is_one_way(const PlaneBox& velocity);
/// Is a × b ≠ 0 for all vectors of the boxes?
bool are_transversal(const PlaneBox& a, const PlaneBox& b);

/// A part of a curve: [lower, upper] of one segment, or several whole segments.
struct CurveNode {
  std::size_t first_segment = 0;
  std::size_t last_segment = 0;  ///< included
  double lower = 0;              ///< of the parameter of the first segment
  double upper = 1;              ///< of that of the last one
  PlaneBox box{};                ///< the projected part is in it
  PlaneBox velocity{};           ///< and its derivative in this one
  std::array<std::unique_ptr<CurveNode>, 2> halves = {};

  bool is_arc() const { return first_segment == last_segment; }  ///< is it of one segment?
};

/// All t of an arc.
RealBall arc_parameter(const CurveNode& arc);
/// The middle of a ball, exactly.
RealBall midpoint_of(const RealBall& x);

/// A closed curve, projected along v to a plane, in parts of parts.
class CurveTree {
 public:
  CurveTree(CurveSeries curve, const Vector<Rational>& v);

  CurveNode& root() { return *root_; }
  /// Makes the halves of the node, where it has none. An arc is cut near its middle.
  void split(CurveNode& node);
  /// Does the one end where the other begins?
  bool share_end(const CurveNode& a, const CurveNode& b) const;

  /// The projected curve, and the curve itself, around t.
  PlaneSeries series(std::size_t segment, const RealBall& t, long length, long bits) const;
  Vector<BallPolynomial> space_series(std::size_t segment, const RealBall& t, long length,
                                      long bits) const {
    return curve_.position(segment, t, length, bits);
  }

 private:
  std::unique_ptr<CurveNode> make_arc(std::size_t segment, double lower, double upper) const;
  std::unique_ptr<CurveNode> make_group(std::size_t first, std::size_t last) const;

  CurveSeries curve_;
  std::array<Vector<Rational>, 2> axes_;  ///< across v
  std::unique_ptr<CurveNode> root_;
};

}  // namespace phrame
