#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace phrame::inline v0::cli {

/// A file descriptor, closed at the end unless it is a standard one.
class Descriptor {
 public:
  /// Throws InputError, by errno, for a negative number.
  Descriptor(int number, std::string name);
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&&) = delete;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  const std::string& name() const { return name_; }

 private:
  int number_;
  std::string name_;
};

/// Is it the regular file with that path?
bool is_same_file(const Descriptor& file, const std::string& path);
/// All of the bytes. Throws InputError.
void write_whole(const Descriptor& file, std::string_view bytes);

/// SIGINT and SIGTERM as bytes in a pipe, so that who waits for input sees them; they stop what is
/// computed. The second one ends the program at once. One of these a process.
class Interruption {
 public:
  Interruption();
  int descriptor() const;
  bool has_come() const;
  /// Ends the program as the signal would have done, if there was one.
  void pass_on() const;
};

/// The lines of a file, until a signal comes.
class LineReader {
 public:
  /// Refers to both.
  LineReader(const Descriptor& file, const Interruption& interruption)
      : file_(file), interruption_(interruption) {}

  /// The next line that is not blank; no value at the end of the file and after a signal. Throws
  /// InputError, also for a line longer than 2²⁸ bytes.
  std::optional<std::string> next();
  /// Of the last line, from 1 on; blank lines count.
  long number() const { return number_; }

 private:
  void fill();

  const Descriptor& file_;
  const Interruption& interruption_;
  std::string buffer_;
  std::size_t start_ = 0;     ///< of the next line
  std::size_t searched_ = 0;  ///< no end of a line before
  bool is_at_end_ = false;
  long number_ = 0;
};

}  // namespace phrame::cli
