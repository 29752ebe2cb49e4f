// What commands read and write: files and streams, or of a line of a batch its Exchange.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "phrame/cli/command.hpp"
#include "phrame/cli/exchange.hpp"
#include "phrame/cli/progress_line.hpp"
#include "phrame/cli/watchdog.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::cli {
namespace {

constexpr std::size_t max_file_size = std::size_t{1} << 28;

/// What note_at_end() keeps.
std::vector<std::string>& notes() {
  static std::vector<std::string> list;
  return list;
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// Writes and closes; false, with errno, where any step failed.
bool write_and_close(File file, const std::string& bytes) {
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  // To the disk before its name: or a crash leaves a file of that name with nothing in it. A pipe
  // has no disk.
  const bool flushed = std::fflush(file.get()) == 0 &&
                       (fsync(fileno(file.get())) == 0 || errno == EINVAL || errno == ENOTSUP);
  return std::fclose(file.release()) == 0 && written && flushed;
}

}  // namespace

void fail_with_errno(const std::string& place, std::string_view what) {
  throw InputError(place.empty() ? "\"\"" : place,
                   fmt::format("{}: {}", what, std::strerror(errno)));
}

std::string name_of_file(const std::string& path) {
  if (const Exchange* here = Exchange::current())
    return here->files.contains(path) || here->paths.contains(path)
               ? path
               : fmt::format("for a file, \"{}\"", abbreviated(path));
  return path == "-" ? "standard input" : path;
}

std::string read_file(const std::string& path) {
  if (const Exchange* here = Exchange::current()) {
    if (here->paths.contains(path))
      throw InputError(path, "it is made already: what is in a file is wanted");
    const auto file = here->files.find(path);
    return file == here->files.end() ? path : file->second;
  }
  std::error_code ignored;
  if (path != "-" && std::filesystem::is_directory(path, ignored))
    throw InputError(path, "is a directory, not a file");
  const File opened(path == "-" ? nullptr : std::fopen(path.c_str(), "rb"));
  if (path != "-" && !opened) fail_with_errno(path, "cannot be read");
  std::FILE* file = path == "-" ? stdin : opened.get();
  std::string text;
  char block[65536];
  while (const std::size_t n = std::fread(block, 1, sizeof block, file)) {
    text.append(block, n);
    if (text.size() > max_file_size)
      throw InputError(name_of_file(path), fmt::format("is larger than {} bytes", max_file_size));
  }
  if (std::ferror(file) != 0) fail_with_errno(name_of_file(path), "cannot be read");
  return text;
}

void write_output(const std::string& path, const std::string& bytes) {
  if (Exchange* here = Exchange::current()) {
    here->output += bytes;
    return;
  }
  end_watch();
  end_progress();
  if (path == "-") {
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
    if (std::fflush(stdout) != 0 || !written)
      fail_with_errno("standard output", "cannot be written");
    return;
  }
  std::error_code ignored;
  const bool exists = std::filesystem::exists(path, ignored);
  if (exists && !std::filesystem::is_regular_file(path, ignored)) {
    // A device or a pipe: there is nothing to rename.
    File file(std::fopen(path.c_str(), "wb"));
    if (!file || !write_and_close(std::move(file), bytes))
      fail_with_errno(path, "cannot be written");
    return;
  }
  // Through a link the file is replaced, not the link; who may read it stays as it was.
  const std::string target = exists ? std::filesystem::canonical(path, ignored).string() : path;
  const std::string draft = fmt::format("{}.{}.part", target, getpid());
  File file(std::fopen(draft.c_str(), "wb"));
  if (!file) fail_with_errno(path, "cannot be written");
  if (exists)
    std::filesystem::permissions(draft, std::filesystem::status(target, ignored).permissions(),
                                 ignored);
  if (!write_and_close(std::move(file), bytes) || std::rename(draft.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    std::remove(draft.c_str());
    errno = reason;
    fail_with_errno(path, "cannot be written");
  }
}

void note(std::string_view text) {
  if (Exchange* here = Exchange::current())
    here->notes.emplace_back(text);
  else
    print_above_progress("phrame: " + printable(text));
}

void note_at_end(std::string text) {
  Exchange* here = Exchange::current();
  (here != nullptr ? here->notes : notes()).push_back(std::move(text));
}

void print_notes_at_end() {
  for (const std::string& text : notes()) note(text);
  notes().clear();
}

}  // namespace phrame::cli
