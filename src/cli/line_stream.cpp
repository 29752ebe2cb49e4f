#include "phrame/cli/line_stream.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

#include "phrame/algebra/time_limit.hpp"
#include "phrame/cli/command.hpp"

namespace phrame::inline v0::cli {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 28;

/// Where an Interruption writes to and reads from; a handler has no arguments of its own.
std::array<int, 2> pipe_ends{};

}  // namespace

Descriptor::Descriptor(int number, std::string name) : number_(number), name_(std::move(name)) {
  if (number < 0) fail_with_errno(name_, "cannot be opened");
}

Descriptor::~Descriptor() {
  if (number_ > 2) close(number_);
}

Descriptor::Descriptor(Descriptor&& other) noexcept
    : number_(std::exchange(other.number_, -1)), name_(std::move(other.name_)) {}

bool is_same_file(const Descriptor& file, const std::string& path) {
  struct stat a = {};
  struct stat b = {};
  return fstat(file.number(), &a) == 0 && stat(path.c_str(), &b) == 0 && S_ISREG(a.st_mode) &&
         a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

void write_whole(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = write(file.number(), bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) fail_with_errno(file.name(), "cannot be written");
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

Interruption::Interruption() {
  if (pipe(pipe_ends.data()) != 0) fail_with_errno("batch", "no pipe");
  struct sigaction action = {};
  action.sa_handler = [](int signal) {
    const auto byte = static_cast<char>(signal);
    [[maybe_unused]] const auto written = write(pipe_ends[1], &byte, 1);
    stop_all();
  };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int Interruption::descriptor() const { return pipe_ends[0]; }

bool Interruption::has_come() const {
  pollfd waiting{descriptor(), POLLIN, 0};
  return poll(&waiting, 1, 0) == 1;
}

void Interruption::pass_on() const {
  char signal = 0;
  if (has_come() && read(descriptor(), &signal, 1) == 1) raise(signal);
}

std::optional<std::string> LineReader::next() {
  for (;;) {
    const auto end = buffer_.find('\n', searched_);
    if (end == std::string::npos && !is_at_end_) {
      searched_ = buffer_.size();
      fill();
      continue;
    }
    if (end == std::string::npos && start_ == buffer_.size()) return std::nullopt;
    std::string line = buffer_.substr(start_, end - start_);
    start_ = searched_ = end == std::string::npos ? buffer_.size() : end + 1;
    ++number_;
    if (line.find_first_not_of(" \t\r") != std::string::npos) return line;
  }
}

void LineReader::fill() {
  buffer_.erase(0, start_);
  searched_ -= start_;
  start_ = 0;
  if (buffer_.size() > longest_line)
    throw InputError(file_.name(), fmt::format("a line is longer than {} bytes", longest_line));
  std::array<pollfd, 2> waiting{
      {{file_.number(), POLLIN, 0}, {interruption_.descriptor(), POLLIN, 0}}};
  if (poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR)
    fail_with_errno(file_.name(), "cannot be read");
  if (waiting[1].revents != 0) {  // what is not yet a line is dropped
    buffer_.clear();
    searched_ = 0;
    is_at_end_ = true;
    return;
  }
  if (waiting[0].revents == 0) return;
  std::array<char, 65536> block;
  const auto count = read(file_.number(), block.data(), block.size());
  if (count < 0 && errno != EINTR) fail_with_errno(file_.name(), "cannot be read");
  if (count == 0) is_at_end_ = true;
  if (count > 0) buffer_.append(block.data(), static_cast<std::size_t>(count));
}

}  // namespace phrame::cli
