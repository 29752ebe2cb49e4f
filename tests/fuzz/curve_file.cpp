// Any bytes: a curve or spline, or an InputError of one line.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/curve_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    phrame::read_curve_or_spline({reinterpret_cast<const char*>(data), size});
  } catch (const phrame::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
