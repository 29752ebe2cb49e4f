#pragma once
#include <string>
#include <vector>

#include "phrame/io/read/given_segment.hpp"

namespace phrame::inline v0 {

/// Pieces from a start to an end, each behind the one before.
using CurvePieces = std::vector<RationalBezier>;

/// The same from the end to the start.
void turn_back(CurvePieces& pieces);

/// A curve of a drawing, or several that meet.
struct DrawnChain {
  CurvePieces pieces;                ///< at least one
  std::vector<Rational> knots = {};  ///< of one spline, where the pieces begin, and the last
  std::vector<long> lines = {};      ///< of each piece, the line of the file
  std::string layer = {};            ///< curves of one layer may meet
  std::vector<std::string> handles = {};
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
