// Any bytes behind the magic of NumPy's files: numbers, or an InputError of one line.
#include "phrame/io/read/npy.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "phrame/algebra/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  if (!phrame::NpyTable::is_one(bytes)) return -1;
  const auto is_line = [](const phrame::InputError& error) {
    return std::string_view(error.what()).find('\n') == std::string_view::npos;
  };
  try {
    const phrame::NpyTable table(bytes);
    for (std::size_t row = 0; row < table.rows(); ++row)
      for (std::size_t column = 0; column < table.columns(); ++column) try {
          table.number(row, column);
        } catch (const phrame::InputError& error) {
          if (!is_line(error)) std::abort();
        }
  } catch (const phrame::InputError& error) {
    if (!is_line(error)) std::abort();
  }
  return 0;
}
