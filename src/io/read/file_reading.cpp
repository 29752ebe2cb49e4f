#include "phrame/io/read/file_reading.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {

void FileReading::refuse_skipping(std::string_view what) const {
  if (skips_invalid && !skips_where_possible)
    throw InputError("--skip-invalid",
                     fmt::format("it is for rows of points, and this is {}", what));
  if (!kind.empty())
    throw InputError("--kind", fmt::format("it is for tables of points, and this is {}", what));
}

void FileReading::refuse_picking(std::string_view what) const {
  if (!pick.empty())
    throw InputError(
        "--pick",
        fmt::format("it is for files of several curves that have names, and this is {}", what));
}

std::function<std::string(const std::string& name)> files_beside(const std::string& path) {
  return [folder = std::filesystem::path(path).parent_path()](const std::string& name) {
    std::ifstream file(folder / name, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    if (!file || !bytes) throw InputError((folder / name).string(), "cannot be read");
    return bytes.str();
  };
}

}  // namespace phrame
