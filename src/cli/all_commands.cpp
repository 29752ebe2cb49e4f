#include <algorithm>

#include "phrame/cli/command.hpp"

namespace phrame::cli {

const std::vector<AddCommand>& all_commands() {
  static const auto list = [] {
    std::vector<AddCommand> all = answering_commands();
    all.insert(std::ranges::find(all, &add_compile), &add_batch);
    all.insert(all.end(), {add_help, add_completion, add_man});
    return all;
  }();
  return list;
}

}  // namespace phrame::cli
