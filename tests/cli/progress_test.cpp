// What is seen on a terminal, which `script` makes.
#include "cli/workshop.hpp"
#include "support/skip.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

/// In containers there is often no pseudo-terminal. Nothing waits for ever, whatever fails.
bool has_terminal() {
  static const bool has =
      std::system("timeout 20 script -qec true /dev/null </dev/null >/dev/null 2>&1") == 0;
  if (!has) skip("there is no program script, or no pseudo-terminal for it");
  return has;
}

}  // namespace

TEST_CASE("progress: help has the terminal's width, and colours there") {
  if (!has_terminal()) return;
  const Workshop here;
  const auto seen = [&](const std::string& command) {
    return output_of(
        here, "unset COLUMNS NO_COLOR; export TERM=xterm; timeout 20 script -qec 'stty cols 60; " +
                  command + "' /dev/null < /dev/null | tr -d '\\r'");
  };
  CHECK(seen("NO_COLOR=1 phrame help info") == output_of(here, "COLUMNS=60 phrame help info"));
  CHECK(seen("phrame help info") ==
        output_of(here, "CLICOLOR_FORCE=1 COLUMNS=60 phrame help info"));
}

TEST_CASE("progress: who waits for more than a second sees what is done, on a terminal only") {
  if (!has_terminal()) return;
  const Workshop here;
  here.write("doubles.json", bytes_of(root("/examples/curves/bezier-doubles.json")));
  // What is read comes late.
  const std::string seen = output_of(
      here,
      "mkfifo late later; (sleep 1.4; timeout 20 tee late < doubles.json > later) & "
      "timeout 20 phrame angle later --near 1e-15 -o other 2> silent & "
      "timeout 20 script -qec 'phrame angle late --near 1e-15 -o answer' /dev/null < /dev/null; "
      "wait");
  const std::string clear = "\r\033[K";
  CAPTURE(seen);
  CHECK(seen.starts_with(clear + "angle: 1 s"));
  // It is gone before anything else is written.
  CHECK(contains(seen, clear + "phrame: "));
  CHECK_FALSE(contains(seen.substr(seen.find("phrame: ")), clear));
  CHECK(contains(bytes_of(here.file("answer")), "θ"));
  const std::string silent = bytes_of(here.file("silent"));
  CHECK(silent.starts_with("phrame: "));
  CHECK_FALSE(contains(silent, "angle: "));
}
