#pragma once
#include "phrame/answer/check.hpp"
#include "phrame/io/read/frame_csv.hpp"

namespace phrame::inline v0 {

/// Another reading of a table of frames than the one by which they fail.
struct BetterReading {
  FrameReading reading;
  bool passes;  ///< the frames pass by it; else their tangents are right, at least
};

/// Do the frames pass, or are their tangents given and right? Then no other reading is looked for.
bool is_read_right(const CheckAnswer& found, const GivenTable& table);

/// Of the other_readings(), the first by which the frames pass; where it takes for positions what
/// `reading` took for vectors, they are to be the curve's, as are_on_curve() tells with the
/// tolerance, but 1/100 at most: else what is wrong with a vector would be out of sight. If there
/// is none, the first by which all tangents are right, where they are not by `reading`. Both are
/// proved, as check_frames() does it. `table` and `found` are what `bytes` mean by `reading`.
std::optional<BetterReading> better_reading(const CheckAnswer& found, std::string_view bytes,
                                            const FrameReading& reading, const GivenTable& table);

}  // namespace phrame
