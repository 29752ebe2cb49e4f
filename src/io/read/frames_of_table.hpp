#pragma once
#include <memory>

#include "phrame/io/read/frame_csv.hpp"
#include "phrame/io/read/number_table.hpp"

namespace phrame::inline v0 {

/// read_frames() of a table that is read.
GivenTable frames_of_table(std::unique_ptr<NumberTable> table, const FrameReading& reading,
                           std::size_t at_most = std::string_view::npos);

}  // namespace phrame
