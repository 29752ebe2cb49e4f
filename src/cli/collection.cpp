#include "phrame/cli/collection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/cli/command.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/json_node.hpp"

namespace phrame::inline v0::cli {
namespace {

std::filesystem::path collection_folder() {
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return (program.parent_path() / PHRAME_BIN_TO_DATA / "phrame" / "reference").lexically_normal();
}

std::vector<std::string> group_names(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".jsonl") names.push_back(entry.path().stem().string());
  if (names.empty())
    throw InputError(folder.string(), "the reference collection is not there, where it belongs");
  std::sort(names.begin(), names.end());
  return names;
}

void append_group(std::vector<CollectedCurve>& curves, const std::filesystem::path& file) {
  const std::string text = read_file(file.string());
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    CollectedCurve curve{"", file.stem().string(), text.substr(from, end - from), {}};
    curve.json = at_place(file.string(), ":", [&] { return parse_json(curve.line); });
    curve.name = JsonNode(curve.json).at("name").string();
    curves.push_back(std::move(curve));
    from = end + 1;
  }
}

}  // namespace

NamedPath CollectedCurve::path() const { return read_any_path(JsonNode(json)); }

std::vector<CollectedCurve> reference_collection(const std::vector<std::string>& groups) {
  const std::filesystem::path folder = collection_folder();
  const std::vector<std::string> names = group_names(folder);
  for (const std::string& group : groups)
    if (std::find(names.begin(), names.end(), group) == names.end())
      throw InputError("--group", fmt::format("\"{}\" is not one of {}", abbreviated(group),
                                              fmt::join(names, ", ")));
  std::vector<CollectedCurve> curves;
  for (const std::string& name : names)
    if (groups.empty() || std::find(groups.begin(), groups.end(), name) != groups.end())
      append_group(curves, folder / (name + ".jsonl"));
  return curves;
}

}  // namespace phrame::cli
