#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/cli/program.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/ph/along/parametrization.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/roll.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0::cli {

/// What is undefined for the value of an option is an error there.
template <class Make>
auto at_option(const std::string& option, Make make) {
  try {
    return make();
  } catch (const DomainError& error) {
    throw InputError(option, error.what());
  }
}

/// --near
void add_near(Command& command, std::optional<std::string>& near);
/// What it says, where it is given. Throws InputError where that is not > 0.
std::optional<Rational> parse_near_option(const std::optional<std::string>& near);

/// --skip-invalid
void add_skip_invalid(Command& command, FileReading& reading);

/// What the commands that read a curve or a spline share: CURVE, --near, --max-corner,
/// --skip-invalid, --kind, --gap, --pick, --max-degree, -o.
struct CurveOptions {
  std::string path;
  std::optional<std::string> near;
  std::optional<std::string> max_corner;
  std::optional<std::string> gap;
  CurveLimits limits;
  FileReading reading;
  std::string output = "-";
  std::optional<std::string> bytes = {};  ///< of the file, where it was read before
  /// Does read_any_path() tell on stderr of corners and of PH curves nearby?
  bool is_for_frames = true;

  void add_to(Command& command);
  /// All but -o, for a command with another one.
  void add_input_to(Command& command);
  std::optional<Rational> epsilon() const { return parse_near_option(near); }
  // Read the curve, with --near the one that is near what is no PH curve, which a line on stderr
  // then says; an InputError's place starts with the path.
  NamedCurve read_curve() const;
  /// With the t that are asked for. Throws InputError for one that is no fraction.
  std::pair<NamedCurve, std::vector<Rational>> read_curve_at(const struct Parameters& asked) const;
  /// The same, a path, too.
  std::pair<NamedPhPath, std::vector<Rational>> read_path_at(const struct Parameters& asked) const;
  NamedPhPath read_path() const;
  NamedPhPath read_path_with_preimages() const;
  /// The path, or a PH path at most --near from it.
  std::variant<NamedPhPath, NotNear> read_path_near() const;
  /// One of any kind. Where it is no PH path but one is very near, as of rounded control points, a
  /// line on stderr says what --near gives closed forms. Another one tells of corners that are no
  /// rounding; those beyond --max-corner are refused.
  NamedPath read_any_path() const;
  /// What is in the file. Standard input is read once.
  std::string content() const;
  /// The numbers of a column of the table that the curve is read from, a row for each point. Throws
  /// InputError, at the option where the curve is on standard input.
  std::vector<Rational> column(const std::string& option, const std::string& name) const;

 private:
  NamedCurve one_curve(const NamedPhPath& named) const;
  NamedPath read_near_or_any() const;
  void add_curve_to(Command& command);
};

/// "needs a Pythagorean-hodograph curve, and this is none", with what finds one: nothing does for a
/// straight line, where every frame that does not turn is right. Of rational PH curves "needs a
/// polynomial Pythagorean-hodograph curve, and this is a rational one".
std::string needs_ph(const Path& path);

/// --by, of which `what` tells up to its first name, t; it may be by times of a motion, too.
void add_by(Command& command, std::string& by, const std::string& what, bool has_times = false);

/// Throws InputError where it is t by another name.
void require_parameter(const Path& path, ParameterKind kind);

/// The t of a path that has this parameter. Throws InputError at the option where there is no such
/// parameter, and DomainError for what is not on the path.
Real t_by(const NamedPath& named, ParameterKind kind, const Rational& x);

/// Where a path is asked: --at, --samples and --by.
struct Parameters {
  std::vector<std::string> at;  ///< lists, separated by commas
  long samples = 0;
  std::string by = "t";

  /// `others` take values of t, too.
  void add_to(Command& command, const std::vector<std::string>& others = {},
              bool has_times = false);
  bool are_times() const { return by == "time"; }
  ParameterKind kind() const;
  /// Throws InputError where it is by a parameter that the path does not have.
  Parametrization on(const NamedPath& named) const;
  std::vector<Rational> given() const;  ///< of --at, in that order
  /// All of them as values of t. Throws InputError where one is no fraction.
  std::vector<Rational> fractions_on(const NamedPath& named) const;
};

/// The parts of lists separated by commas, in order, without blanks around them; an empty part is a
/// part.
std::vector<std::string> split(const std::vector<std::string>& lists);
/// The numbers in such lists; the place of an InputError is the option.
std::vector<Rational> parse_list_option(const std::string& option,
                                        const std::vector<std::string>& lists);

/// The text with "-" for each "−" (U+2212), which reports have for a minus sign.
std::string with_plain_minus(std::string text);

/// Reads a number given on the command line; the place of an InputError is the option.
Rational parse_option(const std::string& option, const std::string& text);
/// The same of one that must be > 0.
Rational parse_positive_option(const std::string& option, const std::string& text);
/// The same of an angle: "pi/4", "45deg", "0.5".
Angle parse_angle_option(const std::string& option, const std::string& text);
/// The same of a vector: "1,0,1/2".
Vector<Rational> parse_vector_option(const std::string& option, const std::string& text);
/// The same of one that has a part across the tangent there.
Vector<Rational> parse_normal_option(const std::string& option, const std::string& text,
                                     const Path& path, const Place& at);

/// --digits, from 1 to 100 000.
void add_digits(Command& command, long& digits);

/// Where a rotation-minimizing frame starts: --start with --theta0, or --start-normal.
struct StartOptions {
  /// What f₂(0) is turned from where neither --start nor --start-normal is given.
  enum class Rule {
    least_rotation,  ///< of frames and bodies
    reference,       ///< of angles: the frame that they are measured from
  };

  std::string rule;
  std::optional<std::string> angle;
  std::optional<std::string> normal;

  /// `otherwise` says what is so without all of them, where that is not the rule.
  void add_to(Command& command, Rule otherwise, const std::string& text = "");
  /// Is it the frame of a vector v?
  bool is_up() const { return rule == "up"; }
  /// What is given. Throws InputError.
  std::optional<FrameStart> given() const;
  /// The same, or the rule.
  FrameStart start() const;
  /// Throws InputError for a vector that has no part across the tangent, and for a frame that
  /// angles along the path are not measured from: they are from this one.
  void check(const Path& path, Reference reference) const;
  /// The same, from the frame of angle_to().
  void check(const Path& path, const std::optional<Vector<Rational>>& v,
             std::optional<Reference> asked = std::nullopt) const;
  static std::vector<std::string> names() { return {"--start", "--theta0", "--start-normal"}; }

 private:
  Rule otherwise_ = Rule::least_rotation;
};

/// --up: the vector v to whose frame angles are. A PH curve has one, too; without it its angles are
/// those to the Euler–Rodrigues frame.
struct UpOption {
  std::optional<std::string> vector;

  /// `what` goes on after "the vector v that makes the".
  void add_to(Command& command, const std::string& what);
  /// v: what is given, or one that is chosen where that `is_wanted`. Throws InputError for a v that
  /// is 0 or along the tangent.
  std::optional<Vector<Rational>> chosen(const Path& path, bool is_wanted = false) const;
};

/// --roll and --roll-column: by what a frame is turned about e₁ beside.
struct RollOption {
  std::optional<std::string> roll;
  std::optional<std::string> column;

  void add_to(Command& command);
  bool is_given() const { return roll || column; }
  /// Without its unit; empty where there is none.
  std::string column_name() const;
  /// What is asked for, with the table that the curve is read from. Throws InputError.
  Roll chosen(const CurveOptions& curve) const;
  /// Throws InputError where that is not finite all along, or has another number of values.
  void check(const Roll& roll, std::size_t segments) const;
  static std::vector<std::string> names() { return {"--roll", "--roll-column"}; }
};

/// --max-degree
void add_max_degree(Command& command, CurveLimits& limits);

/// --full, of commands that print a text for reading.
struct TextLength {
  bool is_full = false;

  /// After --print.
  void add_to(Command& command);
  /// Writes what is printed: a text for reading in this length, all else as it is.
  void write(const std::string& path, const std::string& printed) const;
};

/// The value with that name. Throws InputError, which lists the names there are.
template <class T>
T choose(const std::string& option, const std::string& name,
         const std::vector<std::pair<std::string, T>>& values) {
  std::string names;
  for (const auto& [key, value] : values) {
    if (key == name) return value;
    names += (names.empty() ? "" : ", ") + key;
  }
  throw InputError(option, "\"" + abbreviated(name) + "\" is not one of " + names);
}

/// What choose() takes.
template <class T>
std::vector<std::string> keys(const std::vector<std::pair<std::string, T>>& values) {
  std::vector<std::string> names;
  for (const auto& [key, value] : values) names.push_back(key);
  return names;
}

/// --frame of an angle: erf or frenet.
void add_reference(Command& command, std::string& name, const std::string& what);
Reference chosen_reference(const std::string& name);
/// Throws InputError where the path has no frame of that name, or --up is given with another name
/// than "up".
void require_reference(const std::optional<Reference>& asked, const UpOption& up, const Path& path);

/// "--to: "2" is for single curves; this is a spline". Throws InputError.
[[noreturn]] void fail_for_spline(const std::string& option, const std::string& value);

/// What `read` reads; the place of an InputError is within `place`, after the separator.
template <class Read>
auto at_place(const std::string& place, const std::string& separator, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw InputError(error.place().empty() ? place : place + separator + error.place(),
                     error.reason());
  }
}

/// "`place`: `what`: No such file or directory". Throws InputError.
[[noreturn]] void fail_with_errno(const std::string& place, std::string_view what);

// Of a command that answers a line of a batch, files and streams are those of its Exchange.

/// The path, or "standard input" for "-".
std::string name_of_file(const std::string& path);

/// The whole of a file, "-" being standard input. Throws InputError.
std::string read_file(const std::string& path);

/// A file that is read in pieces.
struct PiecewiseFile {
  std::uint64_t size;
  /// The bytes from some place on: so many, or those that there are.
  std::function<std::string(std::uint64_t from, std::size_t count)> read;
};
/// No value for standard input, for what is no file that can be read anywhere, or larger than
/// read_file() reads, and in an Exchange.
std::optional<PiecewiseFile> file_in_pieces(const std::string& path);

/// Writes all or nothing: a file is written beside its place and renamed. "-" is standard output.
/// Throws InputError.
void write_output(const std::string& path, const std::string& bytes);
/// The same of curve files. Throws InputError where a number is too long to be read again.
void write_curves(const std::string& path, const std::string& text);

/// The same in parts: what was written before finish() is of no file yet, though it may have left
/// by a stream.
class Output {
 public:
  explicit Output(const std::string& path);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output();

  void write(const std::string& bytes);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// "phrame: …", a line on stderr about a result that there is.
void note(std::string_view text);
/// The same once the command has done, or says no: where it fails, the reason is the only line.
void note_at_end(std::string text);
void print_notes_at_end();

/// Thrown by a command whose answer is "no": exit status 1.
struct AnswerNo {
  std::string complaint;  ///< for stderr; empty where the answer was printed
};

// Each adds a command and what it does.
void add_angle(Program& program);
void add_info(Program& program);
void add_classify(Program& program);
void add_totals(Program& program);
void add_frames(Program& program);
void add_mtf(Program& program);
void add_interpolate(Program& program);
void add_construct(Program& program);
void add_identify(Program& program);
void add_integrate(Program& program);
void add_sweep(Program& program);
void add_offset(Program& program);
void add_envelope(Program& program);
void add_transform(Program& program);
void add_batch(Program& program);
void add_compile(Program& program);
void add_check(Program& program);
void add_certify(Program& program);
void add_verify(Program& program);
void add_prove(Program& program);
void add_page(Program& program);
void add_reference_collection(Program& program);
void add_help(Program& program);
void add_completion(Program& program);  ///< hidden
void add_man(Program& program);         ///< hidden

using AddCommand = void (*)(Program&);
/// Commands by their names.
using CommandTable = std::vector<std::pair<std::string, AddCommand>>;
/// @{ Those that answer a question about an argument, and all, in the order of the help.
const CommandTable& answering_commands();
const CommandTable& all_commands();
/// @}

}  // namespace phrame::cli
