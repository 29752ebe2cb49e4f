// Lines in, lines out, in order, on all cores. The output has whole lines only, whenever the run
// ends, so that a later run can go on.
#include "phrame/cli/batch_line.hpp"
#include "phrame/cli/progress_line.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <unordered_set>

#include "phrame/cli/command.hpp"
#include "phrame/cli/line_stream.hpp"
#include "phrame/cli/prepared_threads.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0::cli {
namespace {

struct BatchOptions {
  std::string path = "-";
  std::string output = "-";
  std::optional<std::string> skip_done;
  long threads = 0;
  std::string question = default_question;
  std::string frame = "erf";
  std::vector<std::string> at;
  StartOptions start;
  std::optional<std::string> near;
  long digits = 17;
  bool values_only = false;
  CurveLimits limits;
};

/// What an earlier run has answered.
struct Done {
  std::unordered_set<std::string> ids;
  off_t whole_bytes = 0;  ///< up to the end of the last whole line
  std::string cut_off;    ///< what follows it
  bool is_open = false;   ///< the last line is an answer, but for the end of the line
  long others = 0;        ///< lines that are no answers
};

Done read_done(const std::string& path) {
  Done done;
  if (path.empty() || access(path.c_str(), F_OK) != 0) return done;  // nothing is done yet
  std::ifstream file(path, std::ios::binary);
  if (!file) fail_with_errno(path, "cannot be read");
  for (std::string line; std::getline(file, line);) {
    auto id = answered_id(line);
    done.is_open = file.eof();
    if (done.is_open && !id) {
      done.cut_off = std::move(line);
      done.is_open = false;
      break;
    }
    if (id)
      done.ids.insert(*std::move(id));
    else
      ++done.others;
    done.whole_bytes += static_cast<off_t>(line.size() + (done.is_open ? 0 : 1));
  }
  return done;
}

Descriptor open_input(const std::string& path) {
  return {path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC),
          name_of_file(path)};
}

/// A line that was cut off goes from the file to another beside it.
void keep_aside(const std::string& path, const std::string& cut_off) {
  const std::string aside = path + ".damaged";
  const Descriptor file(::open(aside.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666),
                        aside);
  write_whole(file, cut_off + "\n");
  note(fmt::format("{}: the last line was cut off; its {} {} kept in {}", path,
                   counted(cut_off.size(), "byte"), cut_off.size() == 1 ? "is" : "are", aside));
}

/// Locked as long as it is open, where it is a regular file of its own or what is skipped: two at a
/// time would write the same answers. /dev/null and pipes are anybody's. Throws InputError where
/// another has it; a file system that has no locks is taken as it is.
Descriptor open_output(const std::string& path, const std::string& skip_done) {
  constexpr int flags = O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC;
  Descriptor file(path == "-" ? STDOUT_FILENO : ::open(path.c_str(), flags, 0666),
                  path == "-" ? "standard output" : path);
  struct stat status = {};
  fstat(file.number(), &status);
  const bool is_own = S_ISREG(status.st_mode) &&
                      (path != "-" || (!skip_done.empty() && is_same_file(file, skip_done)));
  if (is_own && flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw InputError(file.name(), "another phrame batch is writing to it");
  return file;
}

/// Where the output is what is skipped, it is continued; a line that was cut off is kept aside, and
/// one that lacks but its end gets it.
void start_output(const Descriptor& file, const BatchOptions& options, const Done& done) {
  const std::string skip_done = options.skip_done.value_or("");
  const bool continues = !skip_done.empty() && is_same_file(file, skip_done);
  if (options.output == "-" && !continues) return;
  if (continues && !done.cut_off.empty()) keep_aside(skip_done, done.cut_off);
  struct stat status = {};
  fstat(file.number(), &status);
  if (S_ISREG(status.st_mode) && ftruncate(file.number(), continues ? done.whole_bytes : 0) != 0)
    fail_with_errno(file.name(), "cannot be written");
  if (continues && done.is_open) write_whole(file, "\n");
}

/// On a terminal, twice a second, and at the end to stay.
class BatchProgress {
 public:
  void report(long lines, long failures) {
    if (!is_terminal_) return;
    const auto now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(500)) return;
    last_ = now;
    print(lines, failures, '\r');
  }
  void finish(long lines, long failures) const {
    if (is_terminal_) print(lines, failures, '\n');
  }

 private:
  using Clock = std::chrono::steady_clock;

  void print(long lines, long failures, char end) const {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    std::fprintf(stderr, "\r\033[K%ld lines, %ld failed, %.0f lines/s%c", lines, failures,
                 static_cast<double>(lines) / std::max(seconds, 1e-3), end);
  }

  bool is_terminal_ = isatty(STDERR_FILENO) != 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

/// A line of the input, and its answer.
template <class T>
struct Numbered {
  long number;
  T of;
};

/// "2 of 5 lines failed: 3, 4; line 3: /curve: an object is wanted, not null".
class Failures {
 public:
  void add(long line, const std::string& complaint) {
    constexpr long most = 10;
    if (count_ == 0) first_ = fmt::format("line {}: {}", line, complaint);
    if (count_ < most) numbers_ += fmt::format("{}{}", count_ == 0 ? "" : ", ", line);
    if (count_ == most) numbers_ += ", …";
    ++count_;
  }
  long count() const { return count_; }
  std::string text(long lines) const {
    return fmt::format("{} of {} failed: {}; {}", count_,
                       counted(static_cast<std::size_t>(lines), "line"), numbers_, first_);
  }

 private:
  long count_ = 0;
  std::string numbers_;
  std::string first_;
};

/// What is wrong with an option is said before a line is read.
BatchDefaults defaults_of(const Command& command, const BatchOptions& options) {
  choose("--question", options.question, answering_commands());
  chosen_reference(options.frame);
  parse_list_option("--at", options.at);
  if (!options.start.rule.empty() && options.start.rule != "least")
    throw InputError("--start", "each line has a frame of its own that its angle is measured from");
  options.start.start();
  parse_near_option(options.near);
  auto of_all = command.given();
  // PH curves are measured from the Euler–Rodrigues frame anyway, and others have none.
  std::erase(of_all, std::pair<std::string, std::string>("--frame", "erf"));
  return {{options.question, std::move(of_all)}, command.time_limit()};
}

/// The file that --skip-done names, "" for none. Throws InputError for one that cannot be it.
std::string done_file(const BatchOptions& options, const Descriptor& input) {
  if (!options.skip_done) return "";
  const std::string& path = *options.skip_done;
  if (path.empty()) throw InputError("--skip-done", "\"\" is not a file's name");
  if (is_same_file(input, path)) throw InputError("--skip-done", "\"" + path + "\" is the input");
  if (access(path.c_str(), F_OK) == 0 && access(path.c_str(), R_OK) != 0)
    fail_with_errno(path, "cannot be read");
  return path;
}

/// Those that are done, so that they can be left out.
Done done_before(const std::string& path) {
  Done done = read_done(path);
  if (done.others > 0)
    note(fmt::format("{}: {} of its lines {} no answer of phrame batch", path, done.others,
                     done.others == 1 ? "is" : "are"));
  return done;
}

/// Answers the lines on so many threads, in their order; how many they were.
long answer_lines(LineReader& reader, const BatchDefaults& defaults, std::size_t threads,
                  const Descriptor& output, const Interruption& interruption, Failures& failures) {
  end_progress();
  BatchProgress progress;
  long lines = 0;
  namespace tbb = oneapi::tbb;
  using Line = Numbered<std::string>;
  using Answer = Numbered<BatchAnswer>;
  const auto read_line = [&](tbb::flow_control& control) -> Line {
    auto line = reader.next();
    if (line) return {reader.number(), *std::move(line)};
    control.stop();
    return {};
  };
  const auto answer = [&](const Line& line) -> Answer {
    return {line.number, batch_answer(line.of, defaults)};
  };
  const auto write_answer = [&](Answer found) {
    if (interruption.has_come()) return;  // the answers that are missing were stopped
    if (found.of.line.empty()) return;    // it is done
    write_whole(output, found.of.line += '\n');
    ++lines;
    if (found.of.is_failure) failures.add(found.number, found.of.complaint);
    progress.report(lines, failures.count());
  };
  // So many lines in memory at a time; one that takes long, up to its limit, holds up the others.
  const std::size_t lines_in_flight = 64 * threads;
  tbb::parallel_pipeline(
      lines_in_flight,
      tbb::make_filter<void, Line>(tbb::filter_mode::serial_in_order, read_line) &
          tbb::make_filter<Line, Answer>(tbb::filter_mode::parallel, answer) &
          tbb::make_filter<Answer, void>(tbb::filter_mode::serial_in_order, write_answer));
  progress.finish(lines, failures.count());
  return lines;
}

void run(const Command& command, const BatchOptions& options) {
  BatchDefaults defaults = defaults_of(command, options);
  const Descriptor input = open_input(options.path);
  if (options.output != "-" && is_same_file(input, options.output))
    throw InputError("--output", "\"" + options.output + "\" is the input");
  const std::string skip_done = done_file(options, input);
  const Descriptor output = open_output(options.output, skip_done);
  const Done done = done_before(skip_done);
  start_output(output, options, done);
  if (!done.ids.empty())
    defaults.is_done = [&done](const std::string& id) { return done.ids.contains(id); };
  const Interruption interruption;
  LineReader reader(input, interruption);
  Failures failures;
  const auto threads = static_cast<std::size_t>(
      options.threads > 0 ? options.threads : oneapi::tbb::info::default_concurrency());
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                          threads);
  const PreparedThreads prepared;
  const long lines = answer_lines(reader, defaults, threads, output, interruption, failures);
  interruption.pass_on();
  if (failures.count() > 0) throw AnswerNo{failures.text(lines)};
}

}  // namespace

void add_batch(Program& program) {
  Command& command =
      program.add("batch", "any question about many curves: JSON lines in, JSON lines out");
  const auto options = std::make_shared<BatchOptions>();
  command.add_optional_argument("LINES", options->path,
                                "a file of JSON lines, standard input if not given");
  command.add_option("-o,--output", "FILE", options->output,
                     "write to this file, as the answers come, instead of standard output");
  command.writes("JSON lines", {"jsonl", "json"});
  command.add_option(
      "--skip-done", "FILE", options->skip_done,
      "leave out the lines whose id has an answer in this file; if it is the output,\n"
      "it is continued, by one process at a time, and a last line that was cut off is\n"
      "kept in FILE.damaged");
  command.add_number("--threads", options->threads, {1, 4096},
                     "so many at a time (default: all cores)");
  command.add_flag("--values-only", options->values_only,
                   "answers without integrand and antiderivative");
  command.add_option("--question", "COMMAND", options->question,
                     "what lines without \"question\" ask (default angle)");
  add_reference(command, options->frame, "for lines without \"frame\": erf (default) or frenet");
  command.add_list("--at", "T,...", options->at, "for lines without \"at\": 0,1/2,1");
  options->start.add_to(command, StartOptions::Rule::reference,
                        "default; for lines without \"theta0\" and \"start_normal\"");
  add_near(command, options->near);
  add_digits(command, options->digits);
  add_max_degree(command, options->limits);
  command.set_notes(
      "A line is {\"id\": \"a7\", \"curve\": {...}, \"frame\": \"erf\", \"at\": [\"1\"], "
      "\"digits\": 17,\n"
      "\"theta0\": \"pi/4\", \"note\": ...}; all but \"curve\", a curve or a spline, may be left "
      "out,\n"
      "and \"start_normal\": [0, 0, 1] may stand for \"theta0\". A line may also be the curve or\n"
      "spline by itself, with its key \"phrame\"; its name is the id. Of a curve that is not\n"
      "Pythagorean-hodograph \"frame\" is \"up\" or \"frenet\", and \"up\": [0, 0, 1] the vector "
      "v.\n"
      "With \"question\": \"totals\", or another command, the keys are its arguments and options,\n"
      "with _ for -: {\"question\": \"frames\", \"curve\": {...}, \"samples\": 5}; for a file "
      "stands\n"
      "what is in it. The answer is what the command gives in JSON, on one line and with the id;\n"
      "else {\"id\": \"a7\", \"output\": \"...\"} with its text; or {\"id\": \"a7\", \"error\": "
      "{\"status\":\n"
      "2, \"message\": \"...\"}}. The answers are in the "
      "order "
      "of\n"
      "the lines. Exit status 1 if a line failed; stderr tells the numbers of the first ten.\n"
      "Ctrl-C and SIGTERM end it at once; the output has whole lines only.\n"
      "Examples:\n"
      "  phrame batch curves.jsonl --at 1 -o angles.jsonl\n"
      "  phrame batch curves.jsonl --at 1 -o angles.jsonl --skip-done angles.jsonl\n"
      "  phrame batch curves.jsonl --question totals --digits 30\n"
      "  generate | phrame batch --values-only | filter");
  command.limits_time_of(
      "a line without an answer after so many seconds gets an error with status 4");
  command.does(options, run);
}

}  // namespace phrame::cli
