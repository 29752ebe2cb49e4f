#pragma once
#include <map>
#include <string>
#include <vector>

#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0::cli {

/// While it lives, a command of this thread reads and writes here, not files and streams: it
/// answers a line of a batch, beside others in other threads. There is one at a time in a thread.
class Exchange {
 public:
  Exchange();
  ~Exchange();
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  /// That of this thread, or null.
  static Exchange* current();

  /// What is in a file, by its name. Any other name of a file is taken for what is in it.
  std::map<std::string, std::string> files;
  std::map<std::string, NamedPath> paths;  ///< what files with curves stand for that are not there
  std::string output;                      ///< for standard output
  std::vector<std::string> notes;          ///< for stderr
};

}  // namespace phrame::cli
