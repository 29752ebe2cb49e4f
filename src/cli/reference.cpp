// The reference collection: lines for a batch, or a folder of curves, values and tables of frames.
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "phrame/algebra/progress.hpp"
#include "phrame/cli/certified.hpp"
#include "phrame/cli/collection.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/cli/prepared_threads.hpp"
#include "phrame/io/read/certificate_file.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/proof/path_certificate.hpp"
#include "phrame/ph/proof/verify.hpp"
#include "phrame/ph/proof/verify_integral.hpp"

namespace phrame::inline v0::cli {
namespace {

namespace fs = std::filesystem;

struct ReferenceOptions {
  std::string name;
  std::vector<std::string> groups;
  bool is_list = false;
  std::string folder;
  std::vector<std::string> samples;
  bool has_certificates = false;
  std::string output = "-";
};

std::vector<CollectedCurve> chosen_curves(const ReferenceOptions& options) {
  auto curves = reference_collection(split(options.groups));
  if (options.name.empty()) return curves;
  std::erase_if(curves, [&](const CollectedCurve& curve) { return curve.name != options.name; });
  if (curves.empty())
    throw InputError("NAME", fmt::format("\"{}\" is no curve of it (phrame reference --list)",
                                         abbreviated(options.name)));
  return curves;
}

/// What the line gives the curve by: "formulas".
std::string kind_of(const CollectedCurve& curve) {
  const JsonNode node(curve.json);
  if (node.find("segments")) return fmt::format("{} segments", node.at("segments").size());
  if (node.find("preimage")) return "preimage";
  if (node.find("position")) return "power basis";
  if (node.find("weights")) return "control points, weights";
  return node.find("expressions") ? "formulas" : "control points";
}

/// What is known of it besides its frames.
std::string values_of(const CollectedCurve& curve) {
  std::string values = "frames";
  const JsonNode expected = JsonNode(curve.json).at("expected");
  for (const std::string& key : expected.keys())
    if (key != "at" && key != "frames") values += ", " + key;
  return values;
}

std::string list_of(const std::vector<CollectedCurve>& curves) {
  std::vector<std::vector<std::string>> rows{{"name", "group", "given by", "values"}};
  for (const CollectedCurve& curve : curves)
    rows.push_back({curve.name, curve.group, kind_of(curve), values_of(curve)});
  return columns_text(rows);
}

std::string lines_of(const std::vector<CollectedCurve>& curves) {
  std::string lines;
  for (const CollectedCurve& curve : curves) lines += curve.line + "\n";
  return lines;
}

/// A row for each t of each curve, and one for each curve.
std::pair<std::string, std::string> value_tables(const std::vector<CollectedCurve>& curves) {
  const auto optional_text = [](const JsonNode& node, const std::string& key) {
    const auto value = node.find(key);
    return value ? value->text() : std::string();
  };
  std::string frames =
      "name,t,x,y,z,e1x,e1y,e1z,f2x,f2y,f2z,f3x,f3y,f3z,theta_erf,twist2x,twist2y,twist2z,"
      "twist3x,twist3y,twist3z,offset_x,offset_y,offset_z,snx,sny,snz,sbx,sby,sbz,"
      "signed_curvature\n";
  std::string totals = "name,group,length,holonomy,twist,offset_distance,offset_length,writhe\n";
  for (const CollectedCurve& curve : curves) {
    const JsonNode values = JsonNode(curve.json).at("expected");
    const auto twist = values.find("minimal_twist");
    const auto offset = values.find("offset");
    const auto signed_frenet = values.find("signed_frenet");
    const auto item = [](const std::optional<JsonNode>& node, const char* key, std::size_t k) {
      return node ? std::optional(node->at(key).item(k)) : std::nullopt;
    };
    const auto append_numbers = [&](const std::optional<JsonNode>& list, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i)
        frames += "," + (list ? list->item(i).text() : std::string());
    };
    const JsonNode at = values.at("at");
    for (std::size_t k = 0; k < at.size(); ++k) {
      frames += curve.name + "," + at.item(k).text();
      append_numbers(values.at("frames").item(k), 12);
      const auto theta = values.find("theta_erf");
      frames += "," + (theta ? theta->item(k).text() : std::string());
      append_numbers(item(twist, "frames", k), 6);
      append_numbers(item(offset, "points", k), 3);
      append_numbers(item(signed_frenet, "frames", k), 6);
      const auto curvature = item(signed_frenet, "curvature", k);
      frames += "," + (curvature ? curvature->text() : std::string()) + "\n";
    }
    totals += fmt::format(
        "{},{},{},{},{},{},{},{}\n", curve.name, curve.group, values.at("length").text(),
        optional_text(values, "holonomy"), twist ? twist->at("twist").text() : "",
        offset ? offset->at("distance").text() : "", offset ? offset->at("length").text() : "",
        optional_text(values, "writhe"));
  }
  return {frames, totals};
}

void write_plainly(const fs::path& file, const std::string& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream << bytes;
  stream.close();
  if (!stream) fail_with_errno(file.string(), "cannot be written");
}

/// At n equally spaced t.
FrameTable sampled_frames(const NamedPath& named, long n) {
  std::vector<Place> at;
  for (ParameterPoint& point : Parametrization(named, ParameterKind::t).samples(n))
    at.push_back(std::move(point.at));
  return frame_table(angle_to(std::nullopt, named.path), TableColumns{{TabulatedFrame::rmf}}, at);
}

std::vector<long> sample_counts(const std::vector<std::string>& lists) {
  if (lists.empty()) return {101};
  std::vector<long> counts;
  for (const std::string& text : split(lists)) {
    const Rational n = parse_option("--samples", text);
    if (denominator(n) != 1 || n < 2 || n > 100'000)
      throw InputError("--samples", fmt::format("\"{}\" is no whole number from 2 to 100000",
                                                abbreviated(text)));
    counts.push_back(static_cast<long>(numerator(n)));
  }
  return counts;
}

/// As one that reads it without --unlimited finds. Throws InputError where that is too much work.
bool is_accepted(const std::string& certificate) {
  return std::visit([](const auto& named) { return are_proved(verify(named.certificate)); },
                    read_any_certificate(certificate));
}

/// A certificate of the angle at the t of a curve's values, or why there is none there.
struct CurveCertificate {
  std::string text;    ///< may be empty
  std::string reason;  ///< of the curve, or of some t; may be empty
};

/// To 50 digits, or to five less, and so on, until phrame verify takes it. Throws InputError where
/// it does not, and as certify().
std::string accepted_certificate(const NamedPath& named, const std::vector<Rational>& at) {
  for (long digits = 50;; digits -= 5) try {
      std::string text = angle_certificate(named, at, digits);
      if (!is_accepted(text)) throw Undecided("phrame verify does not prove it");
      return text;
    } catch (const InputError&) {
      if (digits <= 5) throw;
    }
}

/// Without the t at which the angle is not told from 0 by 1024 bits: it may be 0, and then rounding
/// it does not end.
CurveCertificate certificate_of(const CollectedCurve& curve) try {
  const NamedPath named = curve.path();
  const PathAngle angle = angle_to(std::nullopt, named.path);
  std::vector<Rational> at;
  std::vector<std::string> left_out;
  const JsonNode expected = JsonNode(curve.json).at("expected").at("at");
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Rational t = expected.item(k).number();
    const Real theta = angle.value(t);
    if (theta.exact() || !theta.enclose(1024).contains(Rational(0)))
      at.push_back(t);
    else
      left_out.push_back(expected.item(k).text());
  }
  CurveCertificate found{accepted_certificate(named, at), ""};
  if (!left_out.empty())
    found.reason =
        fmt::format("no certificate at t = {}: the angle is not told from 0 by 1024 bits",
                    fmt::join(left_out, ", "));
  return found;
} catch (const Error& error) {
  return {"", std::string("no certificate: ") + error.what()};
}

/// Gives the curves that have no certificate, or none at some t, with the reasons.
std::vector<std::string> write_certificates(const std::vector<CollectedCurve>& curves,
                                            const fs::path& folder) {
  fs::create_directories(folder);
  std::vector<std::string> reasons(curves.size());
  Stage stage("certificates", curves.size());
  const PreparedThreads prepared;
  oneapi::tbb::parallel_for(std::size_t{0}, curves.size(), [&](std::size_t k) {
    const CurveCertificate found = certificate_of(curves[k]);
    if (!found.text.empty()) write_plainly(folder / (curves[k].name + ".json"), found.text);
    if (!found.reason.empty()) reasons[k] = fmt::format("{}: {}", curves[k].name, found.reason);
    stage.advance();
  });
  std::erase(reasons, "");
  return reasons;
}

void write_collection(const std::vector<CollectedCurve>& curves, const std::vector<long>& counts,
                      const fs::path& folder) {
  fs::create_directories(folder / "curves");
  write_plainly(folder / "curves.jsonl", lines_of(curves));
  const auto [frames, totals] = value_tables(curves);
  write_plainly(folder / "values.csv", frames);
  write_plainly(folder / "totals.csv", totals);
  for (const long n : counts) fs::create_directories(folder / "frames" / std::to_string(n));
  Stage stage("curves", curves.size());
  const PreparedThreads prepared;
  oneapi::tbb::parallel_for(std::size_t{0}, curves.size(), [&](std::size_t k) {
    const CollectedCurve& curve = curves[k];
    write_plainly(folder / "curves" / (curve.name + ".json"), curve.line + "\n");
    const NamedPath named = curve.path();
    for (const long n : counts) {
      const FrameTable table = sampled_frames(named, n);
      const fs::path file = folder / "frames" / std::to_string(n) / curve.name;
      write_plainly(file.string() + ".csv", to_csv(table));
      write_plainly(file.string() + ".npy", to_npy(table));
    }
    stage.advance();
  });
}

/// All or nothing: the folder has another name until it is whole.
void export_collection(const std::vector<CollectedCurve>& curves, const std::vector<long>& counts,
                       const std::string& target, bool has_certificates) {
  std::error_code error;
  if (fs::exists(target, error) &&
      !(fs::is_directory(target, error) && fs::is_empty(target, error)))
    throw InputError(target, "is there already");
  const fs::path draft =
      (fs::path(target) / "").parent_path().string() + fmt::format(".{}.part", getpid());
  try {
    write_collection(curves, counts, draft);
    std::vector<std::string> notes;
    if (has_certificates) notes = write_certificates(curves, draft / "certificates");
    fs::rename(draft, target);
    for (const std::string& text : notes) note(text);
  } catch (const fs::filesystem_error& failure) {
    fs::remove_all(draft, error);
    throw InputError(target, "cannot be written: " + failure.code().message());
  } catch (...) {
    fs::remove_all(draft, error);
    throw;
  }
}

void run(const ReferenceOptions& options) {
  const auto curves = chosen_curves(options);
  if (!options.folder.empty())
    return export_collection(curves, sample_counts(options.samples), options.folder,
                             options.has_certificates);
  write_output(options.output, options.is_list ? list_of(curves) : lines_of(curves));
}

}  // namespace

void add_reference_collection(Program& program) {
  Command& command = program.add("reference", "curves with values to 50 digits, to test against");
  const auto options = std::make_shared<ReferenceOptions>();
  command.add_optional_argument("NAME", options->name, "the curve of this name only");
  command.add_list("--group", "NAME,...", options->groups, "the curves of these groups only");
  command.add_flag("--list", options->is_list, "a table of the curves, instead of their lines");
  command.add_option("--export", "DIR", options->folder,
                     "write a folder: curves.jsonl, a file for each curve, values.csv and\n"
                     "totals.csv, and tables of frames as doubles in CSV and NPY");
  command.add_list("--samples", "N,...", options->samples,
                   "of --export, so many rows in each of these tables (default 101)");
  command.add_flag("--certificates", options->has_certificates,
                   "of --export, also certificates of the angles at the t of the values, as\n"
                   "phrame certify writes them, to 50 digits where phrame verify takes that");
  command.add_output(options->output);
  command.writes("JSON lines", {"jsonl", "json", "txt"});
  command.only_with({"--samples", "--certificates"}, {"--export"});
  command.not_with({"--list", "--output"}, {"--export"});
  command.set_notes(
      "Without --list and --export the curves are written as JSON lines, as phrame batch reads\n"
      "them, with their values under \"expected\": docs/reference.md. phrame check --suite judges\n"
      "frames that another program found for them.\n"
      "Examples:\n"
      "  phrame reference --list\n"
      "  phrame reference tame-01 -o curve.json\n"
      "  phrame reference --group closed,near-cusp | phrame batch --question totals\n"
      "  phrame reference --export collection --samples 51,101,201");
  command.does(options, run);
}

}  // namespace phrame::cli
