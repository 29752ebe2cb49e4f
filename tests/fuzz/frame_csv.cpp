// Any bytes: frames, or an InputError of one line. The first byte chooses the convention.
#include "phrame/io/frame_csv.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "phrame/algebra/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const phrame::QuaternionConvention convention{std::size_t{data[0]} % 3, data[0] >= 128};
  try {
    phrame::read_frames({reinterpret_cast<const char*>(data) + 1, size - 1}, convention);
  } catch (const phrame::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
