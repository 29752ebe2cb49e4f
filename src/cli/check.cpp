#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/cli/collection.hpp"
#include "phrame/cli/exchange.hpp"
#include "phrame/cli/given_frames.hpp"
#include "phrame/io/better_reading.hpp"
#include "phrame/io/read/computing_times.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/sifted_frames.hpp"
#include "phrame/io/write/check.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/suite.hpp"

namespace phrame::inline v0::cli {
namespace {

struct CheckOptions {
  CurveOptions curve;
  std::string frames;
  std::string tolerance = "1e-6";
  std::string by = "t";
  StartOptions start;
  UpOption up;
  std::string quaternion;
  std::string tangent_axis = "x";
  bool is_inverse = false;
  std::vector<std::string> header;
  bool is_suite = false;
  bool is_order = false;
  std::string print = "text";
  TextLength length;
};

FrameReading reading(const Command& command, const CheckOptions& options) {
  using Quaternion = FrameReading::Quaternion;
  FrameReading reading;
  if (command.is_given("--quaternion"))
    reading.quaternion =
        choose<Quaternion>("--quaternion", options.quaternion,
                           {{"wxyz", Quaternion::wxyz}, {"xyzw", Quaternion::xyzw}});
  std::tie(reading.tangent_axis, reading.is_axis_reversed) =
      choose<std::pair<std::size_t, bool>>("--tangent-axis", options.tangent_axis,
                                           {{"x", {0, false}},
                                            {"y", {1, false}},
                                            {"z", {2, false}},
                                            {"-x", {0, true}},
                                            {"-y", {1, true}},
                                            {"-z", {2, true}}});
  reading.is_inverse = options.is_inverse;
  reading.names = split(options.header);
  reading.skips_invalid = options.curve.reading.skips_invalid;
  return reading;
}

/// Throws InputError where the frame that is compared with agrees with all there is.
void require_enough(const std::vector<GivenFrame>& frames, const FrameCheckOptions& options,
                    const std::string& file) {
  if (options.start || number_of_parameters(frames) > 1) return;
  throw InputError(
      file, fmt::format("all samples are at t = {}: without --theta0 and --start-normal they "
                        "are compared with the frame that agrees with the first, so that samples "
                        "at other t are wanted",
                        as_written(frames.front().t)));
}

/// What frames are compared with, but for v, which is of a curve.
FrameCheckOptions measure_of(const CheckOptions& options) {
  FrameCheckOptions measure;
  measure.tolerance = parse_option("--tol", options.tolerance);
  if (measure.tolerance < 0)
    throw InputError("--tol", as_written(measure.tolerance) + " is negative");
  measure.start = options.start.given();
  return measure;
}

/// A table, and what is found in it.
struct Checked {
  FramesOnCurve given;
  CheckAnswer answer;
};

Checked checked(const Command& command, const NamedPath& named, const std::string& bytes,
                const std::string& file, const std::optional<ParameterKind>& by,
                const FrameCheckOptions& measure, FrameReading& reading) {
  FramesOnCurve given = read_on_curve(named, bytes, file, by, reading);
  const GivenTable& table = given.table;
  if (!table.has_quaternions && !table.has_matrices)
    command.refuse({"--quaternion", "--tangent-axis", "--inverse"},
                   "is for quaternions; the table has vectors");
  if (table.has_matrices)
    command.refuse({"--quaternion"}, "is for quaternions; the table has matrices");
  require_enough(table.frames, measure, file);
  CheckAnswer found = answer(named, CheckQuery{table.frames, measure});
  return {std::move(given), std::move(found)};
}

/// What is printed.
struct Report {
  std::string text;
  bool passes;
};

/// A long table, by the rows that decide; no value where that is not the way. What is wrong is then
/// found, and said, by reading all of it.
std::optional<Report> report_by_few(const Command& command, const NamedPath& named,
                                    const std::string& path, const std::optional<ParameterKind>& by,
                                    const FrameCheckOptions& measure, FrameReading reading) {
  const auto file = file_in_pieces(path);
  if (!file) return std::nullopt;
  try {
    const auto few = sifted_frames(file->read, file->size, reading, named, by, measure);
    if (!few) return std::nullopt;
    const Checked found =
        checked(command, named, few->text, path, by.value_or(ParameterKind::t), measure, reading);
    const GivenTable& table = found.given.table;
    const bool has_one_reading =
        is_read_right(found.answer, table) || other_readings(table, reading).empty();
    if (!has_one_reading || !is_for_all(found.answer, *few)) return std::nullopt;
    TableReading shown{table.columns, table.skipped};
    shown.part = {few->numbers, samples_of_all(found.answer.verdict, *few), few->rows};
    return Report{to_text(found.answer, shown), found.answer.verdict.passes};
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// A table in a folder.
struct TableFile {
  std::string path;
  std::optional<Rational> seconds;  ///< that it took to compute, where the folder has times
};

/// What DIR/times.csv tells, by the paths of tables in the folder without their endings; nothing
/// where it is not there.
std::map<std::string, ComputingTime> times_in(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  try {
    return computing_times(read_file(file));
  } catch (const InputError& failure) {
    if (failure.place() == file) throw;
    throw InputError(file + ":" + failure.place(), failure.reason());
  }
}

/// The tables in a folder, and in the folders there, by their names without endings.
std::map<std::string, std::vector<TableFile>> tables_in(const std::string& option,
                                                        const std::string& folder) {
  if (Exchange::current() != nullptr)
    throw InputError(option, "a folder has no place in a line of a batch");
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw InputError(folder, "is no folder");
  const fs::path times_path = fs::path(folder) / "times.csv";
  const auto times = times_in(times_path.string());
  std::set<std::string> timed;
  std::map<std::string, std::vector<TableFile>> tables;
  for (fs::recursive_directory_iterator at(folder, error), end; at != end; at.increment(error)) {
    const std::string ending = at->path().extension().string();
    if (at->path() == times_path || (ending != ".csv" && ending != ".npy" && ending != ".txt"))
      continue;
    const std::string name =
        at->path().lexically_relative(folder).replace_extension().generic_string();
    const auto time = times.find(name);
    TableFile& table = tables[at->path().stem().string()].emplace_back();
    table.path = at->path().string();
    if (time == times.end()) continue;
    table.seconds = time->second.seconds;
    timed.insert(name);
  }
  if (tables.empty()) throw InputError(folder, "no tables are in it: .csv, .npy or .txt");
  for (const auto& [name, time] : times)
    if (!timed.contains(name))
      throw InputError(times_path.string() + ":" + line_place(time.line),
                       fmt::format("no table \"{}\" is in the folder", abbreviated(name)));
  for (auto& [name, files] : tables)
    std::sort(files.begin(), files.end(),
              [](const TableFile& a, const TableFile& b) { return a.path < b.path; });
  return tables;
}

/// Of the tables for one curve of the collection; t is ours.
SuiteRow suite_row_of(const Command& command, const CheckOptions& options,
                      const CollectedCurve& curve, const std::vector<TableFile>& files,
                      const FrameCheckOptions& measure) {
  try {
    const NamedPath named = curve.path();
    std::vector<SuiteTable> tables;
    for (const auto& [file, seconds] : files) {
      FrameReading reading = cli::reading(command, options);
      tables.push_back(
          {checked(command, named, read_file(file), file, ParameterKind::t, measure, reading)
               .answer,
           seconds});
    }
    return suite_row(curve.name, curve.group, tables);
  } catch (const Error& error) {
    return SuiteRow{curve.name, curve.group, error.what()};
  }
}

void run_suite(const Command& command, const CheckOptions& options) {
  const auto print = choose<std::string (*)(const SuiteAnswer&)>("--print", options.print,
                                                                 {{"text", to_text},
                                                                  {"json", to_json},
                                                                  {"latex", to_latex},
                                                                  {"html", to_html},
                                                                  {"svg", to_badge}});
  if (command.is_given("--start") && options.start.rule != "least")
    throw InputError("--start", "\"" + options.start.rule + "\" is for one curve, not for --suite");
  const FrameCheckOptions measure = measure_of(options);
  auto tables = tables_in("--suite", options.curve.path);
  SuiteAnswer found;
  found.tolerance = measure.tolerance;
  const auto curves = reference_collection();
  Stage stage("curves", curves.size());
  for (const CollectedCurve& curve : curves) {
    stage.advance();
    const auto files = tables.find(curve.name);
    if (files == tables.end()) {
      found.missing.push_back(curve.name);
      continue;
    }
    found.rows.push_back(suite_row_of(command, options, curve, files->second, measure));
    tables.erase(files);
  }
  if (!tables.empty())
    throw InputError(tables.begin()->second.front().path,
                     "no curve of the collection has this name (phrame reference --list)");
  options.length.write(options.curve.output, print(found));
  if (!found.passes()) throw AnswerNo{};
}

void run_order(const Command& command, const CheckOptions& options) {
  const auto print = choose<std::string (*)(const OrderAnswer&)>(
      "--print", options.print,
      {{"text", to_text}, {"json", to_json}, {"latex", to_latex}, {"html", to_html}});
  FrameCheckOptions measure = measure_of(options);
  const NamedPath named = options.curve.read_any_path();
  measure.up = options.up.chosen(named.path, options.start.is_up());
  options.start.check(named.path, measure.up);
  std::optional<ParameterKind> by = ParameterKind::t;
  if (command.is_given("--by")) by = choose("--by", options.by, parameter_kinds());
  require_parameter(named.path, *by);
  std::vector<StepError> steps;
  for (const auto& [name, files] : tables_in("--order", options.frames))
    for (const auto& [file, seconds] : files) {
      FrameReading reading = cli::reading(command, options);
      const Checked table = checked(command, named, read_file(file), file, by, measure, reading);
      steps.push_back(step_error(table.answer.frames, table.answer.verdict));
      steps.back().seconds = seconds;
    }
  options.length.write(options.curve.output,
                       print(OrderAnswer{named.name, convergence(std::move(steps))}));
}

void run(const Command& command, const CheckOptions& options) {
  if (options.is_suite) return run_suite(command, options);
  if (options.print == "svg") throw InputError("--print", "\"svg\", a badge, is for --suite");
  if (options.is_order) return run_order(command, options);
  if (options.print == "latex" || options.print == "html")
    throw InputError("--print", "\"" + options.print + "\" is for --suite and --order");
  const auto print = choose<std::string (*)(const CheckAnswer&, const TableReading&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}});
  FrameReading reading = cli::reading(command, options);
  FrameCheckOptions measure = measure_of(options);
  if (options.curve.path == "-" && options.frames == "-")
    throw InputError("check", "the curve and the frames are both to be read from standard input");

  const NamedPath named = options.curve.read_any_path();
  measure.up = options.up.chosen(named.path, options.start.is_up());
  options.start.check(named.path, measure.up);
  std::optional<ParameterKind> by;
  if (command.is_given("--by")) by = choose("--by", options.by, parameter_kinds());
  if (options.print == "text")
    if (const auto report = report_by_few(command, named, options.frames, by, measure, reading)) {
      options.length.write(options.curve.output, report->text);
      if (!report->passes) throw AnswerNo{};
      return;
    }
  const std::string bytes = read_file(options.frames);
  const std::string file = name_of_file(options.frames);
  const Checked found = checked(command, named, bytes, file, by, measure, reading);
  const auto& [table, taken] = found.given;
  TableReading shown{table.columns, table.skipped};
  shown.parameters = taken;
  if (const auto better = better_reading(found.answer, bytes, reading, table))
    shown.better = {to_options(better->reading), better->passes};
  options.length.write(options.curve.output, print(found.answer, shown));
  if (!found.answer.verdict.passes) throw AnswerNo{};
}

}  // namespace

void add_check(Program& program) {
  Command& command = program.add("check", "how far somebody's frames are from the exact one");
  const auto options = std::make_shared<CheckOptions>();
  options->curve.add_to(command);
  options->curve.reading.skips_where_possible = true;  // the frames have rows, too
  command.add_optional_argument("FRAMES", options->frames,
                                "a table of frames (text, JSON or .npy), \"-\" for standard input");
  command.add_flag("--suite", options->is_suite,
                   "CURVE is a folder of tables for the reference collection, NAME.csv, .npy or\n"
                   ".txt, those at several steps in folders there; one report on all of them,\n"
                   "with the seconds that each took where DIR/times.csv tells them");
  command.add_flag("--order", options->is_order,
                   "FRAMES is a folder of tables of one method at several steps: how fast its\n"
                   "errors fall");
  command.add_option("--tol", "BOUND", options->tolerance,
                     "radians, cosines and lengths that may be off (default 1e-6)");
  add_by(command, options->by, "what t is in the table (default: found out, if it is not ours): t");
  options->start.add_to(command, StartOptions::Rule::least_rotation,
                        "the default is as the first sample");
  options->up.add_to(command,
                     "frame e2 = v x e1/|v x e1| (default: one that is nowhere along the tangent)");
  command.add_choice("--quaternion", options->quaternion, {"wxyz", "xyzw"},
                     "of quaternions: the order of the columns, wxyz or xyzw (default: as they\n"
                     "are named, else wxyz)");
  command.add_choice("--tangent-axis", options->tangent_axis, {"x", "y", "z", "-x", "-y", "-z"},
                     "of quaternions and matrices: the axis of the body along the tangent, x\n"
                     "(default), y or z; =-x, =-y or =-z for the opposite");
  command.add_flag("--inverse", options->is_inverse,
                   "of quaternions and matrices: they turn the world to the body");
  command.add_list("--header", "NAME,...", options->header,
                   "the names of the columns of a table without them");
  command.add_format("--print", options->print, {"text", "json", "latex", "html", "svg"},
                     "text (default), json, of --suite and --order latex and html: the table, of\n"
                     "--suite svg: a badge");
  options->length.add_to(command);
  command.require_but_with("--suite", "FRAMES");
  command.not_with({"--order", "--near", "--max-corner", "--kind", "--gap", "--pick",
                    "--max-degree", "--by", "--up", "--theta0", "--start-normal", "FRAMES"},
                   {"--suite"});
  command.set_notes(
      "FRAMES has a header: t and f2x,f2y,f2z, optionally f3x,... and e1x,... (the tangent), or t\n"
      "and qw,qx,qy,qz. Other columns are skipped. Without a header their number tells: 4: t, f2;\n"
      "5: t, q; 7: t, f2, f3; 8: t, position, q; 10: t, e1, f2, f3; 13 or more: t, position, e1,\n"
      "f2, f3; 12 or 16: a 3 x 4 or 4 x 4 matrix. Frames with positions, but without t, are "
      "placed\n"
      "on the curve by these. Separators are commas, semicolons, tabs or blanks.\n"
      "Exit status 0: within the tolerance, 1: not.\n"
      "phrame reference --export writes the curves and the t that --suite is about.\n"
      "Examples:\n"
      "  phrame check curve.json frames.csv --tol 1e-9\n"
      "  phrame check curve.json frames.npy --theta0 0\n"
      "  phrame check curve.json poses.csv --tangent-axis z --print json -o check.json\n"
      "  phrame check --suite my-frames --print latex\n"
      "  phrame check curve.json my-frames --order");
  command.does(options, run);
}

}  // namespace phrame::cli
