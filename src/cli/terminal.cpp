#include "phrame/cli/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

namespace phrame::inline v0::cli {
namespace {

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::size_t line_width() {
  constexpr std::size_t least = 40;
  constexpr std::size_t most = 110;
  std::size_t width = 0;
  const std::string_view columns = variable("COLUMNS");
  std::from_chars(columns.data(), columns.data() + columns.size(), width);
  winsize size{};
  if (width == 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) width = size.ws_col;
  return width == 0 ? most : std::clamp(width, least, most);
}

bool has_colour(int descriptor) {
  if (!variable("NO_COLOR").empty()) return false;
  const std::string_view forced = variable("CLICOLOR_FORCE");
  if (!forced.empty() && forced != "0") return true;
  return isatty(descriptor) != 0 && variable("TERM") != "dumb";
}

std::string styled(const std::string& text, Emphasis emphasis, bool in_colour) {
  if (!in_colour || emphasis == Emphasis::plain) return text;
  const char* const code = emphasis == Emphasis::bold      ? "1"
                           : emphasis == Emphasis::heading ? "1;34"
                                                           : "1;31";
  return "\033[" + std::string(code) + "m" + text + "\033[0m";
}

}  // namespace phrame::cli
