// Any bytes, text or .npy: frames, or an InputError of one line. The first byte chooses the
// convention.
#include "phrame/io/read/frame_csv.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "phrame/algebra/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  using Quaternion = phrame::FrameReading::Quaternion;
  constexpr Quaternion orders[] = {Quaternion::named, Quaternion::wxyz, Quaternion::xyzw};
  const unsigned choice = data[0];
  const phrame::FrameReading reading{orders[choice / 3 % 3], choice % 3, choice % 64 >= 32,
                                     choice >= 128};
  try {
    const std::string_view bytes{reinterpret_cast<const char*>(data) + 1, size - 1};
    const phrame::GivenTable table = phrame::read_frames(bytes, reading);
    // Another reading changes what the numbers mean, not whether they are numbers.
    for (const phrame::FrameReading& other : phrame::other_readings(table, reading))
      if (phrame::read_frames(bytes, other, 2).frames.empty()) std::abort();
  } catch (const phrame::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
