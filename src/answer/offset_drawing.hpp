#pragma once
#include "phrame/answer/envelope.hpp"
#include "phrame/answer/offset.hpp"
#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/plane_cubics.hpp"

namespace phrame::inline v0 {

/// One of the paths of an answer by cubic Bézier curves, for formats that have no others.
struct OffsetCubics {
  std::vector<PlaneCubic> cubics;  ///< one after the other, as plane_cubics() has them
  bool is_closed;                  ///< do they end where they begin?
  Rational tolerance;              ///< each is within that of the path, which is proved
};
/// All paths of an answer.
struct OffsetDrawing {
  std::string question;             ///< "offset" or "envelope"
  std::string name;                 ///< of the path
  std::vector<OffsetCubics> paths;  ///< in their order
};
/// Within the tolerance, each, or, where that is less, within about 10⁻⁹ of its size: of distances
/// that are far apart no curve is drawn to more than can be seen.
std::vector<OffsetCubics> cubics_of(const std::vector<Path>& paths, const Rational& tolerance);
/// 10⁻⁶ of the least distance, or of the greatest radius.
Rational drawing_tolerance(const OffsetAnswer& answer);
Rational drawing_tolerance(const EnvelopeAnswer& answer);
/// The least and the greatest tolerance of some paths.
struct ToleranceRange {
  Rational least = 0;
  Rational greatest = 0;

  void add(const std::vector<OffsetCubics>& paths);
};
/// Within that.
OffsetDrawing drawing(const OffsetAnswer& answer);
OffsetDrawing drawing(const EnvelopeAnswer& answer);

/// All paths of an answer by lines, for machines that go along lines.
struct OffsetPolylines {
  using Point = std::array<Integer, 2>;  ///< x and y, times 10^places

  std::string question;                   ///< "offset" or "envelope"
  std::vector<std::vector<Point>> paths;  ///< in their order
  long places;                            ///< decimals
  Rational tolerance;                     ///< each is within that of the path, which is proved
};
/// Within the tolerance, by default a thousandth of the least distance or of the greatest radius.
/// Throws InputError where that is less than 10⁻⁸ of the size of a path, or asks for more than a
/// million lines.
OffsetPolylines polylines(const OffsetAnswer& answer, const std::optional<Rational>& tolerance);
OffsetPolylines polylines(const EnvelopeAnswer& answer, const std::optional<Rational>& tolerance);

/// The paths of an answer, each as one curve, exactly.
struct OffsetNurbs {
  /// One of them.
  struct Part {
    BSpline curve;   ///< as_bspline()
    bool is_closed;  ///< does it end where it begins?
  };
  std::string question;     ///< "offset" or "envelope"
  std::string name;         ///< of the path
  std::vector<Part> parts;  ///< in their order
};
OffsetNurbs nurbs(const OffsetAnswer& answer);
OffsetNurbs nurbs(const EnvelopeAnswer& answer);

}  // namespace phrame
