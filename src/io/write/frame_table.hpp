#pragma once
#include <string>

#include "phrame/answer/frame_table.hpp"

namespace phrame {

/// Shortest decimal texts that read back to the same doubles.
std::string to_csv(const FrameTable& table);
std::string to_json(const FrameTable& table);  ///< {"phrame": format, …}
/// NumPy's .npy format, version 1.0: rows × columns of little-endian doubles, row after row.
std::string to_npy(const FrameTable& table);

}  // namespace phrame
