#pragma once
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "phrame/io/read/json_node.hpp"
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

  /// What is in a file: text, JSON of a line, in which a curve may be without "phrame", or what a
  /// file with a curve stands for that is not there.
  using Content = std::variant<std::string, JsonNode, NamedPath>;
  /// By their names. Any other name of a file is taken for what is in it.
  std::map<std::string, Content> files;
  std::string output;              ///< for standard output
  std::vector<std::string> notes;  ///< for stderr

  /// Of this type, in the file of that name of this thread's exchange; else null.
  template <class T>
  static const T* content(const std::string& file) {
    if (current() == nullptr) return nullptr;
    const auto found = current()->files.find(file);
    return found == current()->files.end() ? nullptr : std::get_if<T>(&found->second);
  }
};

}  // namespace phrame::cli
