// The documents show what the program prints and what the examples say; here they are held to that.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "cli/workshop.hpp"
#include "support/data.hpp"
#include "support/text.hpp"

namespace readme_test {

namespace {

using phrame::test::contains;

const std::string root = phrame::test::root("");

std::string content(const std::string& path) {
  std::ifstream file(path);
  REQUIRE(file.good());
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The fenced blocks of that language.
std::vector<std::string> blocks(const std::string& text, const std::string& language) {
  std::vector<std::string> found;
  const std::string fence = "```" + language + "\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
    at += fence.size();
    const std::size_t end = text.find("```", at);
    found.push_back(text.substr(at, end - at));
    at = end;
  }
  return found;
}

std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  char block[4096];
  while (const std::size_t n = std::fread(block, 1, sizeof block, pipe)) text.append(block, n);
  const int status = pclose(pipe);
  const bool may_say_no = contains(command, "phrame check ") ||
                          contains(command, "phrame identify ") || contains(command, " --check ");
  const bool is_no =
      may_say_no && WIFEXITED(status) && WEXITSTATUS(status) == 1;  // an answer as good as yes
  CHECK((status == 0 || is_no));
  return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at)) {
    text.replace(at, what.size(), by);
    at += by.size();
  }
  return text;
}

}  // namespace

TEST_CASE("documents: every command shown prints what is shown") {
  const char* program = std::getenv("PHRAME_PROGRAM");
  REQUIRE(program != nullptr);
  const phrame::test::Workshop here;
  const std::string own = here.file("").string();  // for /tmp/, where others may have files, too
  long all = 0;
  for (const std::string document : {"/README.md",
                                     "/docs/any-curve.md",
                                     "/docs/certificate.md",
                                     "/docs/check.md",
                                     "/docs/classification.md",
                                     "/docs/cluster.md",
                                     "/docs/compiled.md",
                                     "/docs/construct.md",
                                     "/docs/corners.md",
                                     "/docs/curve-files.md",
                                     "/docs/from-your-data.md",
                                     "/docs/integration.md",
                                     "/docs/minimal-twist.md",
                                     "/docs/minkowski.md",
                                     "/docs/motion.md",
                                     "/docs/near.md",
                                     "/docs/offsets.md",
                                     "/docs/poses.md",
                                     "/docs/splines.md",
                                     "/docs/sweep.md",
                                     "/docs/totals.md",
                                     "/docs/transform.md"}) {
    CAPTURE(document);
    long commands = 0;
    for (const std::string& block : blocks(content(root + document), "console")) {
      const std::size_t end = block.find('\n');
      const std::string command = block.substr(0, end);
      if (!contains(command, " phrame ")) continue;
      CAPTURE(command);
      ++commands;
      const std::string found =
          output_of("cd '" + root + "' && phrame() { '" + program + "' \"$@\"; } && " +
                    replaced(command.substr(2), "/tmp/", own));
      CHECK(replaced(found, own, "/tmp/") == block.substr(end + 1));
    }
    CHECK(commands >= 1);
    all += commands;
  }
  CHECK(all >= 24);
}

TEST_CASE("README: the C++ shown is examples/quickstart.cpp, which is compiled and run") {
  const auto shown = blocks(content(root + "/README.md"), "cpp");
  REQUIRE(shown.size() == 1);
  CHECK(shown.front() == content(root + "/examples/quickstart.cpp"));
}

TEST_CASE("documents: the functions and files of docs/architecture.md are in src") {
  std::string sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root + "/src"))
    if (entry.is_regular_file()) sources += entry.path().string() + content(entry.path().string());
  const std::string text = content(root + "/docs/architecture.md");
  long all = 0;
  const std::regex named("`(?:\\w+::)?(\\w+\\()|`((?:\\w+/)+\\w+)`");
  for (std::sregex_iterator it(text.begin(), text.end(), named), end; it != end; ++it, ++all) {
    const std::string name = (*it)[1].matched ? (*it)[1].str() : "/src/" + (*it)[2].str();
    CAPTURE(name);
    CHECK(contains(sources, name));
  }
  CHECK(all > 50);
}

}  // namespace readme_test
