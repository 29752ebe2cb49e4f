#include "phrame/io/read/file_reading.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"

namespace phrame {

void FileReading::refuse_skipping(std::string_view kind) const {
  if (skips_invalid && !skips_where_possible)
    throw InputError(fmt::format("--skip-invalid is for rows of points, and this is {}", kind));
}

void FileReading::refuse_picking(std::string_view kind) const {
  if (!pick.empty())
    throw InputError(
        fmt::format("--pick is for files of several curves that have names, and this is {}", kind));
}

}  // namespace phrame
