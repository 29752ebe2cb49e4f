#include <algorithm>

#include "phrame/cli/command.hpp"

namespace phrame::inline v0::cli {

const CommandTable& all_commands() {
  static const auto table = [] {
    CommandTable all = answering_commands();
    const auto is_compile = [](const auto& entry) { return entry.first == "compile"; };
    all.insert(std::ranges::find_if(all, is_compile), {"batch", add_batch});
    all.push_back({"reference", add_reference_collection});
    all.insert(all.end(), {{"help", add_help}, {"completion", add_completion}, {"man", add_man}});
    return all;
  }();
  return table;
}

}  // namespace phrame::cli
