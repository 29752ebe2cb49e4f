// Any bytes: points, of JSON or of a table, or an error of one line.
#include "phrame/io/read/point_file.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "phrame/algebra/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const phrame::GivenPoints given =
        phrame::read_points({reinterpret_cast<const char*>(data), size});
    const std::size_t n = given.points.size();
    const auto has_all = [&](std::size_t entries) { return entries == 0 || entries == n; };
    if (n < 2 || !has_all(given.derivatives.size()) || !has_all(given.tangents.size()) ||
        !has_all(given.accelerations.size()))
      std::abort();
  } catch (const phrame::Error& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
