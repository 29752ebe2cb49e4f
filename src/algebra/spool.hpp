#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace phrame::inline v0 {

/// Bytes that are appended, and read again from the first on: the last of them in memory, what is
/// before them in a temporary file without a name, where one can be made.
class Spool {
 public:
  /// About a megabyte is in memory.
  static Spool with_file() { return Spool(std::size_t{1} << 20); }
  /// All is.
  static Spool in_memory() { return Spool(std::numeric_limits<std::size_t>::max()); }

  std::uint64_t size() const { return in_file_ + last_.size(); }
  /// Appends what add(bytes) appends to some bytes. Throws InputError where the disk is full.
  template <class Add>
  void append(const Add& add) {
    add(last_);
    if (last_.size() >= most_in_memory_) move_to_file();
  }
  /// Calls take(bytes) for all of them, in blocks. Throws InputError where they cannot be read.
  void read(const std::function<void(const std::string&)>& take) const;

 private:
  explicit Spool(std::size_t most_in_memory) : most_in_memory_(most_in_memory) {}
  void move_to_file();

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::size_t most_in_memory_;
  std::string last_ = {};
  std::unique_ptr<std::FILE, Close> file_ = nullptr;
  std::uint64_t in_file_ = 0;
};

}  // namespace phrame
