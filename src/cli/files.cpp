// What commands read and write: files and streams, or of a line of a batch its Exchange.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>

#include "phrame/cli/command.hpp"
#include "phrame/cli/exchange.hpp"
#include "phrame/cli/progress_line.hpp"
#include "phrame/cli/watchdog.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0::cli {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

namespace {

constexpr std::size_t max_file_size = std::size_t{1} << 28;

/// What note_at_end() keeps.
std::vector<std::string>& notes() {
  static std::vector<std::string> list;
  return list;
}

using File = std::unique_ptr<std::FILE, CloseFile>;

/// Closes; false, with errno, where what was written is not all there.
bool close_written(File file) {
  // To the disk before its name: or a crash leaves a file of that name with nothing in it. A pipe
  // has no disk.
  const bool flushed = std::fflush(file.get()) == 0 &&
                       (fsync(fileno(file.get())) == 0 || errno == EINVAL || errno == ENOTSUP);
  return std::fclose(file.release()) == 0 && flushed;
}

/// What would be in a file with this.
std::string file_text(const JsonNode& node) {
  const std::string text = json_text(node);
  if (!node.is(JsonNode::Kind::object) || node.find("phrame")) return text;
  return R"({"phrame":"curve/1")" + std::string(text == "{}" ? "" : ",") + text.substr(1);
}

}  // namespace

void fail_with_errno(const std::string& place, std::string_view what) {
  throw InputError(place.empty() ? "\"\"" : place,
                   fmt::format("{}: {}", what, std::strerror(errno)));
}

std::string name_of_file(const std::string& path) {
  if (const Exchange* here = Exchange::current())
    return here->files.contains(path) ? path : fmt::format("for a file, \"{}\"", abbreviated(path));
  return path == "-" ? "standard input" : path;
}

std::string read_file(const std::string& path) {
  if (Exchange::current() != nullptr) {
    if (Exchange::content<NamedPath>(path) != nullptr)
      throw InputError(path, "it is made already: what is in a file is wanted");
    if (const JsonNode* node = Exchange::content<JsonNode>(path)) return file_text(*node);
    const auto* text = Exchange::content<std::string>(path);
    return text == nullptr ? path : *text;
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

std::optional<PiecewiseFile> file_in_pieces(const std::string& path) {
  std::error_code error;
  if (Exchange::current() != nullptr || path == "-" ||
      !std::filesystem::is_regular_file(path, error))
    return std::nullopt;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  const auto file = std::make_shared<std::ifstream>(path, std::ios::binary);
  if (error || size > max_file_size || !*file) return std::nullopt;
  return PiecewiseFile{size, [file](std::uint64_t from, std::size_t count) {
                         std::string bytes(count, '\0');
                         file->clear();
                         file->seekg(static_cast<std::streamoff>(from));
                         file->read(bytes.data(), static_cast<std::streamsize>(count));
                         bytes.resize(static_cast<std::size_t>(file->gcount()));
                         return bytes;
                       }};
}

struct Output::State {
  std::string path;
  Exchange* here = Exchange::current();
  File file = nullptr;      ///< null for standard output
  std::string target = {};  ///< what the draft is to be called
  std::string draft = {};   ///< empty where there is nothing to rename
};

Output::Output(const std::string& path) : state_(std::make_unique<State>(State{path})) {
  if (state_->here != nullptr) return;
  end_watch();
  end_progress();
  if (path == "-") return;
  std::error_code ignored;
  const bool exists = std::filesystem::exists(path, ignored);
  const bool is_stream = exists && !std::filesystem::is_regular_file(path, ignored);
  // Of a device or a pipe there is nothing to rename. Through a link the file is replaced, not the
  // link; who may read it stays as it was.
  if (!is_stream) {
    state_->target = exists ? std::filesystem::canonical(path, ignored).string() : path;
    state_->draft = fmt::format("{}.{}.part", state_->target, getpid());
  }
  state_->file.reset(std::fopen(is_stream ? path.c_str() : state_->draft.c_str(), "wb"));
  if (!state_->file) fail_with_errno(path, "cannot be written");
  if (exists && !is_stream)
    std::filesystem::permissions(
        state_->draft, std::filesystem::status(state_->target, ignored).permissions(), ignored);
}

Output::~Output() {
  state_->file.reset();
  if (!state_->draft.empty()) std::remove(state_->draft.c_str());
}

void Output::write(const std::string& bytes) {
  if (state_->here != nullptr) {
    state_->here->output += bytes;
    return;
  }
  std::FILE* file = state_->file ? state_->file.get() : stdout;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size()) return;
  fail_with_errno(state_->file ? state_->path : "standard output", "cannot be written");
}

void Output::finish() {
  if (state_->here != nullptr) return;
  if (!state_->file) {
    if (std::fflush(stdout) != 0) fail_with_errno("standard output", "cannot be written");
    return;
  }
  if (!close_written(std::move(state_->file)) ||
      (!state_->draft.empty() && std::rename(state_->draft.c_str(), state_->target.c_str()) != 0))
    fail_with_errno(state_->path, "cannot be written");  // and the draft goes with the output
  state_->draft.clear();
}

void write_output(const std::string& path, const std::string& bytes) {
  Output output(path);
  output.write(bytes);
  output.finish();
}

void write_curves(const std::string& path, const std::string& text) {
  constexpr std::size_t digits = most_number_bits * 3 / 10;  // fewer never are too many bits
  for (std::size_t start = 0; (start = text.find('"', start)) != std::string::npos;) {
    const std::size_t end = text.find('"', start + 1);
    if (end - start > digits) {
      const long bits = bits_of(parse_rational(text.substr(start + 1, end - start - 1)));
      if (bits > most_number_bits)
        throw InputError(
            fmt::format("the curve would have a number of {} bits, of which phrame "
                        "reads no more than {}",
                        bits, most_number_bits));
    }
    start = end + 1;
  }
  write_output(path, text);
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
