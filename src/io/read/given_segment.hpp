#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/curve/rational_bezier.hpp"

namespace phrame::inline v0 {

/// A piece of a path as it was read, before it is known what all pieces make.
struct GivenSegment {
  /// A PH curve, X/W, or formulas.
  using Form = std::variant<Curve, RationalCurve, ExpressionCurve>;
  Form form;              ///< what it is
  std::string place;      ///< where it is in the file
  std::string part = {};  ///< which part of that it is, "between the knots 0 and 1"; may be empty
  /// From where to where the parameter that the file has goes, where it has one of its own.
  std::optional<std::array<Rational, 2>> parameters = std::nullopt;
};

/// Throws InputError with the place and part of the segment.
[[noreturn]] void fail_at(const GivenSegment& segment, const std::string& reason);

/// A Bézier curve as a segment. Throws InputError where it is a point.
GivenSegment bezier_segment(const RationalBezier& bezier, const std::string& place,
                            const std::string& part = {});
/// The same between two knots, or other values of the parameter of the file.
GivenSegment span_segment(const BezierPiece& piece, const std::string& place,
                          const std::string& part = {});

/// The segments between the knots of a spline without a fault. Throws as bezier_segment().
std::vector<GivenSegment> span_segments(const BSpline& spline, const std::string& place);

/// The PH curve that the segment is, or in words why it is none.
std::variant<Curve, std::string> identify_segment(const GivenSegment& segment);

/// r(1). Throws InputError where that of formulas is not seen to be of fractions.
Vector<Rational> end_point(const GivenSegment& segment);

/// The path of segments, at least one, each PH where it is known or found to be. Throws InputError
/// at the one that does not go on where the one before ends, or turns back there.
Path joined_segments(std::vector<GivenSegment> segments);

/// Of segments, at least one, the path: that of PH curves where all of them are; of others those
/// that are PH are known to be. They are identified where they are polynomial. Gaps are closed as
/// close_gaps() does, which a note says; NamedPath::parameters are those of the segments where they
/// all have some that follow each other, and of formulas by themselves. Throws InputError at the
/// segment that does not go on where the one before ends, or turns back there.
NamedPath path_of(std::string name, std::vector<GivenSegment> segments,
                  const std::optional<Rational>& gap = {});

}  // namespace phrame
