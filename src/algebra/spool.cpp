#include "phrame/algebra/spool.hpp"

#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

/// In the folder that TMPDIR names, or else /tmp; nothing where none can be made.
std::FILE* temporary_file() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "phrame-XXXXXX").string();
  const int descriptor = error ? -1 : mkstemp(name.data());
  if (descriptor < 0) return nullptr;
  unlink(name.c_str());
  std::FILE* file = fdopen(descriptor, "w+b");
  if (file == nullptr) close(descriptor);
  return file;
}

[[noreturn]] void fail(const char* what) {
  throw InputError("a temporary file", std::string(what) + ": " + std::strerror(errno));
}

}  // namespace

void Spool::move_to_file() {
  if (!file_) file_.reset(temporary_file());
  if (!file_) {  // it stays in memory
    most_in_memory_ = std::numeric_limits<std::size_t>::max();
    return;
  }
  if (std::fwrite(last_.data(), 1, last_.size(), file_.get()) != last_.size())
    fail("cannot be written");
  in_file_ += last_.size();
  last_.clear();
}

void Spool::read(const std::function<void(const std::string&)>& take) const {
  if (file_) {
    if (std::fseek(file_.get(), 0, SEEK_SET) != 0) fail("cannot be written");
    std::string block;
    for (std::uint64_t left = in_file_; left > 0; left -= block.size()) {
      block.resize(std::min<std::uint64_t>(left, 1U << 16));
      if (std::fread(block.data(), 1, block.size(), file_.get()) != block.size())
        fail("cannot be read");
      take(block);
    }
    std::fseek(file_.get(), 0, SEEK_END);
  }
  take(last_);
}

}  // namespace phrame
