#pragma once
#include <string>
#include <vector>

#include "phrame/io/read/given_segment.hpp"

namespace phrame::inline v0 {

/// Pieces from a start to an end, each behind the one before.
using CurvePieces = std::vector<RationalBezier>;

/// A curve of a drawing.
struct DrawnCurve {
  CurvePieces pieces;                ///< at least one
  std::vector<Rational> knots = {};  ///< of one spline, where the pieces begin, and the last
};
/// A spline without a fault, between its knots.
DrawnCurve drawn_spline(const BSpline& spline);
/// The lines through points, without those of length 0; maybe none.
CurvePieces lines_through(const std::vector<Vector<Rational>>& points);
/// The part of a spline from a to b, a < b, between its first knot and its last.
DrawnCurve part_between(const DrawnCurve& spline, const Rational& a, const Rational& b);
/// The same from the end to the start, without knots.
void turn_back(DrawnCurve& curve);

/// A curve of a drawing, or several that meet.
struct DrawnChain {
  DrawnCurve curve;
  std::vector<long> lines = {};  ///< of each piece, the line of the file
  std::string layer = {};        ///< curves of one layer may meet
  std::vector<std::string> handles = {};

  /// Of a curve that is on that line.
  DrawnChain(DrawnCurve drawn, long line, std::string its_layer, std::string handle);
};

/// Are they the same but for what rounding of such coordinates leaves, 10⁻⁹ of the greatest?
bool points_meet(const Vector<Rational>& p, const Vector<Rational>& q);

/// Curves of the parts that meet, in whatever order and direction they are, each as long as it can
/// be.
std::vector<DrawnChain> chains_of_drawing(std::vector<DrawnChain> parts);

/// The segments of the only chain of at least one, or of the one that is picked: by its layer,
/// where that has no other, or the handle of a part. Throws InputError as chosen_curve().
std::vector<GivenSegment> chosen_chain(const std::vector<DrawnChain>& chains,
                                       const std::string& pick);

}  // namespace phrame
