#pragma once
#include <string>

#include "phrame/answer/frame_table.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// Shortest decimal texts that read back to the same doubles.
PHRAME_API std::string to_csv(const FrameTable& table);
PHRAME_API std::string to_json(const FrameTable& table);  ///< {"phrame": format, …}
/// NumPy's .npy format, version 1.0: rows × columns of little-endian doubles, row after row.
PHRAME_API std::string to_npy(const FrameTable& table);

}  // namespace phrame
