#pragma once
#include <string>

namespace phrame::inline v0::cli {

/// While it lives, and until end_progress(), a line on the terminal says which command is at work,
/// how far it is (Stage) and for how long; after the first second, and gone at the end. Nothing
/// where stderr is no terminal. There is one at a time.
class ProgressLine {
 public:
  explicit ProgressLine(std::string command);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
};

/// Writes a line to stderr; that of the progress, if there is one, comes below it again.
void print_above_progress(const std::string& line);

/// Before anything is written to stdout: there is no such line any more.
void end_progress();

}  // namespace phrame::cli
