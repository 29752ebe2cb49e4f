#pragma once
#include "phrame/ph/frame/frame_check.hpp"

namespace phrame {

/// Where on a path frames are that say their positions, but not their parameters.
struct FrameParameters {
  std::vector<Rational> t;
  std::string what;  ///< "the times, from start to end of the curve", for a note
};

/// Tries the joints of the path one after the other, where there are as many; the times, which are
/// the t of the positions, from 0 to the end of the path; and equal steps. Takes what has the
/// positions on the curve (are_on_curve): of several, where they are nearest. Throws InputError,
/// without a place, where none has to within 1/1000.
FrameParameters frame_parameters(const Path& path, const std::vector<GivenPosition>& positions);

}  // namespace phrame
