#pragma once
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

#include "io/reference.hpp"
#include "phrame/cli/run_program.hpp"
#include "support/text.hpp"

// The program as its users meet it: arguments, streams, files, exit statuses.
namespace phrame::inline v0::test {

namespace fs = std::filesystem;

struct Run {
  int status;
  std::string out;
  std::string err;
};

inline std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write_file(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// The words of a command line as a shell splits it, if nothing in it is for a shell but blanks and
/// single quotes; none under sanitizers, which look for leaks when the program ends by itself.
inline std::optional<std::vector<std::string>> plain_words(const std::string& line) {
#ifdef __SANITIZE_ADDRESS__
  return {};
#endif
  std::vector<std::string> words;
  bool is_quoted = false, is_in_word = false;
  for (const char c : line) {
    if (c == '\'') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && c == ' ') {
      is_in_word = false;
      continue;
    } else if (!is_quoted &&
               std::string_view("|&;<>()$`\\\"\t\n*?[]#~{}!=%").find(c) != std::string_view::npos) {
      return {};
    }
    if (!is_in_word) words.emplace_back();
    is_in_word = true;
    if (c != '\'') words.back() += c;
  }
  return is_quoted ? std::nullopt : std::optional(words);
}

/// A fresh directory, the working directory of the program, with a few curves in it.
class Workshop {
 public:
  Workshop() {
    std::string name = (fs::temp_directory_path() / "phrame-test-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
    const Json quintic = {{"phrame", "curve/1"},
                          {"name", "quintic"},
                          {"basis", "bernstein"},
                          {"preimage", farouki_2003()["quintic"]["bernstein"]}};
    write("quintic.json", quintic.dump());
    write("line.json", R"({"phrame": "curve/1", "basis": "power",
                           "preimage": {"u": [1], "v": [0], "p": [0], "q": [0]}})");
    // A = 1 + t²k: g = 2t, an inflection at t = 0.
    write("inflected.json", R"({"phrame": "curve/1", "basis": "power",
                                "preimage": {"u": [1], "v": [0], "p": [0], "q": [0, 0, 1]}})");
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    fs::remove_all(streams(), ignored);
  }

  fs::path file(const std::string& name) const { return path_ / name; }
  void write(const std::string& name, const std::string& bytes) const {
    write_file(file(name), bytes);
  }
  /// The names of the files in the directory.
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(path_))
      result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Runs the program, through the shell where there is something for it in `arguments`: a later
  /// redirection overrides ours. Else in a copy of this process, which has loaded the libraries:
  /// that takes longer than most answers.
  Run run(const std::string& arguments, const std::string& input = "") const {
    if (const auto words = plain_words(arguments)) return run_copy(*words, input);
    const char* program = std::getenv("PHRAME_PROGRAM");
    REQUIRE_MESSAGE(program != nullptr, "the environment variable PHRAME_PROGRAM is not set");
    fs::create_directory(streams());
    write_file(streams() / "in", input);
    const std::string s = streams().string();
    const std::string command = "cd '" + path_.string() + "' && '" + program + "' <'" + s +
                                "/in' >'" + s + "/out' 2>'" + s + "/err' " + arguments;
    const int status = std::system(command.c_str());
    REQUIRE(WIFEXITED(status));  // a shell reports a signal as 128 + its number
    return {WEXITSTATUS(status), bytes_of(streams() / "out"), bytes_of(streams() / "err")};
  }

 private:
  Run run_copy(std::vector<std::string> words, const std::string& input) const {
    fs::create_directory(streams());
    write_file(streams() / "in", input);
    const auto opened = [&](const char* name, int flags) {
      return ::open((streams() / name).c_str(), flags, 0600);
    };
    words.insert(words.begin(), "phrame");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    std::cout.flush();
    std::fflush(nullptr);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      dup2(opened("in", O_RDONLY), STDIN_FILENO);
      dup2(opened("out", O_WRONLY | O_CREAT | O_TRUNC), STDOUT_FILENO);
      dup2(opened("err", O_WRONLY | O_CREAT | O_TRUNC), STDERR_FILENO);
      const bool is_there = ::chdir(path_.c_str()) == 0;
      const int status =
          is_there ? cli::run_program(static_cast<int>(argv.size()), argv.data()) : 99;
      std::fflush(nullptr);
      _exit(status);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    return {WEXITSTATUS(status), bytes_of(streams() / "out"), bytes_of(streams() / "err")};
  }

  fs::path streams() const { return path_.string() + ".streams"; }

  fs::path path_;
};

/// Fails with that status, one line on stderr that contains `part`, and nothing on stdout.
inline void check_failure(const Run& run, int status, std::string_view part) {
  CAPTURE(run.out);
  CAPTURE(run.err);
  CHECK(run.status == status);
  CHECK(run.out.empty());
  CHECK(run.err.starts_with("phrame: "));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  CHECK(run.err.ends_with('\n'));
  CHECK(contains(run.err, part));
}

/// The output of a shell script; the program's directory is in PATH, the working directory is ours.
inline std::string output_of(const Workshop& here, const std::string& script) {
  here.write("script", "PATH=${PHRAME_PROGRAM%/*}:$PATH\n" + script);
  const std::string command = "cd '" + here.file("").string() + "' && bash ./script >out 2>&1";
  CHECK(std::system(command.c_str()) == 0);
  return bytes_of(here.file("out"));
}

inline bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// Of `phrame page`: whether the program was built without npm, which what it needs is made with.
inline bool has_no_pages(const Run& run) { return contains(run.err, "built without npm"); }

inline void check_success(const Run& run) {
  CAPTURE(run.err);
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  CHECK_FALSE(run.out.empty());
}

}  // namespace phrame::test
