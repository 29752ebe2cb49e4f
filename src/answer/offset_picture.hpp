#pragma once
#include "phrame/answer/offset_drawing.hpp"

namespace phrame::inline v0 {

/// A point of an offset or an envelope, by the point of the path that it belongs to.
struct OffsetSample {
  Rational t;                  ///< of the path
  bool is_join;                ///< is it on what joins the offsets at the corner there?
  std::array<Decimal, 2> at;   ///< x and y, correctly rounded
  std::array<Rational, 2> of;  ///< the point of the path there
};

/// The path and its offsets, or the axis and its envelope, as a page shows them.
struct OffsetPicture {
  /// One of the distances of an answer; of a pocket one of its branches; all of an envelope.
  struct Layer {
    std::vector<OffsetCubics> paths;    ///< the offset, or what is left of it
    std::vector<OffsetCubics> whole;    ///< all of a trimmed offset, once for each distance
    std::vector<OffsetSample> samples;  ///< along `paths`
  };
  std::vector<OffsetCubics> path;  ///< as asked
  std::vector<Layer> layers;       ///< in the order of the answer
};
/// Within drawing_tolerance(), as cubics_of() has it.
OffsetPicture picture(const OffsetAnswer& answer);
/// The same; points belong to the centers of their discs.
OffsetPicture picture(const EnvelopeAnswer& answer);

}  // namespace phrame
