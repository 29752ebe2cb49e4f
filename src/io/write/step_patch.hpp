#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace phrame::inline v0 {

/// A rational Bézier patch in doubles: rows along the path, each around the profile.
struct StepPatch {
  std::vector<std::vector<std::array<double, 3>>> points;
  std::vector<std::vector<double>> weights;
};

/// What a writer of STEP makes a solid of. It is a library of its own, step/, so that nothing else
/// needs Open CASCADE.
struct StepBody {
  std::vector<StepPatch> patches;  ///< along the path, and around the profile at each place
  std::size_t sides = 0;           ///< of the profile
  std::vector<std::size_t> rings;  ///< of each of its rings, the first side: holes come last
  bool is_closed = false;          ///< it needs no caps
};

/// The function of that library, by the name of `step_writer_name`: the bytes of a file, or no
/// bytes and a complaint.
using StepWriter = void (*)(const StepBody& body, std::string& bytes, std::string& complaint);
/// Another where the types above are others.
constexpr const char* step_writer_name = "phrame_write_step_2";

}  // namespace phrame
