#include "phrame/ph/proof/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "phrame/cli/command.hpp"
#include "phrame/io/read/certificate_file.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/exact_form.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/sha256.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/proof/check_table.hpp"
#include "phrame/ph/proof/path_certificate.hpp"
#include "phrame/ph/proof/statement.hpp"

namespace phrame::inline v0::cli {
namespace {

struct VerifyOptions {
  std::string path;
  std::optional<std::string> curve;
  std::optional<std::string> table;
  std::string output = "-";
  CertificateLimits limits;
  bool is_unlimited = false;
  TextLength length;
};

/// The curves of a certificate, one behind the other.
std::vector<Curve> curves_of(const Certificate& c) { return {c.curve}; }
std::vector<Curve> curves_of(const PathCertificate& c) {
  std::vector<Curve> curves;
  for (const Certificate& segment : c.segments) curves.push_back(segment.curve);
  return curves;
}

std::string exact_form_of(const std::vector<Curve>& curves) {
  std::string text;
  for (const Curve& curve : curves) text += exact_form(curve);
  return text;
}

Reference reference_of(const Certificate& c) { return c.reference; }
Reference reference_of(const PathCertificate&) { return Reference::euler_rodrigues; }

/// That the certificate is of the curves in a file. Euler–Rodrigues frames are the same but for a
/// constant turn where h/σ is.
Statement check_curves(const std::vector<Curve>& own, Reference reference, const std::string& path,
                       const CurveLimits& limits) {
  CurveOptions file;
  file.path = path;
  file.limits = limits;
  const std::vector<Curve> other = file.read_path_with_preimages().path.segments();
  std::string objection;
  if (exact_form_of(other) != exact_form_of(own))
    objection = "that one has sha256 " + sha256(exact_form_of(other));
  else if (reference == Reference::euler_rodrigues &&
           !std::ranges::equal(other, own, [](const Curve& a, const Curve& b) {
             return rate_to_erf(a.preimage()) == rate_to_erf(b.preimage());
           }))
    objection = "its preimage, and so its Euler-Rodrigues frame, is another one";
  return {"curve of " + path, objection};
}

/// The rows of a table, as phrame frames writes it. Throws InputError.
std::vector<std::vector<Rational>> read_table(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::string head = fmt::format("{}", fmt::join(certified_columns(), ","));
  if (line != head) throw InputError("line 1", "it is not " + head);
  static const std::regex number("-?[0-9]+([.][0-9]+)?(e[-+]?[0-9]{1,3})?");
  std::vector<std::vector<Rational>> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = split({line});
    const auto is_number = [&](const std::string& cell) {
      return cell.size() <= 400 && std::regex_match(cell, number);
    };
    if (cells.size() != certified_columns().size() || !std::ranges::all_of(cells, is_number))
      throw InputError(line_place(static_cast<long>(rows.size()) + 2),
                       fmt::format("{} decimal numbers are wanted", certified_columns().size()));
    rows.emplace_back();
    for (const std::string& cell : cells) rows.back().push_back(parse_rational(cell));
  }
  return rows;
}

/// Of a curve or a path.
template <class Named>
void check(const Named& named, const CertificateLimits& limits, const VerifyOptions& options) {
  const auto& [name, certificate] = named;
  const std::vector<Curve> curves = curves_of(certificate);
  const Reference reference = reference_of(certificate);
  std::vector<Statement> statements;
  if (options.curve)
    statements.push_back(check_curves(curves, reference, *options.curve, limits.curve));
  for (Statement& statement : verify(certificate)) statements.push_back(std::move(statement));
  if (options.table) {
    const std::string rows = read_file(*options.table);
    const std::string file = name_of_file(*options.table);
    statements.push_back({"table " + file, objection_to_table(certificate, at_place(file, ":", [&] {
                                                                return read_table(rows);
                                                              }))});
  }
  constexpr std::size_t longest_name = 200;
  options.length.write(
      options.output, fmt::format("curve       {}\nsha256      {}\nframe       {}\n",
                                  name.empty() ? "without a name" : abbreviated(name, longest_name),
                                  sha256(exact_form_of(curves)), name_of(reference)) +
                          to_text(statements));
  if (!std::all_of(statements.begin(), statements.end(),
                   [](const Statement& statement) { return statement.is_proved(); }))
    throw AnswerNo{};
}

void run(const VerifyOptions& options) {
  CertificateLimits limits = options.limits;
  limits.is_limited = !options.is_unlimited;
  const std::string text = read_file(options.path);
  const auto found =
      at_place(name_of_file(options.path), ":", [&] { return read_any_certificate(text, limits); });
  std::visit([&](const auto& named) { check(named, limits, options); }, found);
}

}  // namespace

void add_verify(Program& program) {
  Command& command = program.add("verify", "check a certificate");
  const auto options = std::make_shared<VerifyOptions>();
  command.add_argument("CERT", options->path, "a certificate (JSON), \"-\" for standard input");
  command.add_option("--curve", "FILE", options->curve, "the curve or path that it must be of");
  command.add_option("--table", "FILE", options->table,
                     "frames, as phrame frames writes them, at the t of the certificate: is each\n"
                     "number the double next to the exact one?");
  command.add_output(options->output);
  command.writes("text", {"txt"});
  add_max_degree(command, options->limits.curve);
  command.add_flag("--unlimited", options->is_unlimited,
                   "check it even if that may take longer than docs/certificate.md promises");
  command.add_flag("--full", options->length.is_full, "abridge nothing: a long t");
  command.set_notes(
      "Starts from the curve in the certificate and proves every statement by another way than it\n"
      "was found. Exit status 0: all are proved, 1: not all.\n"
      "Examples:\n"
      "  phrame verify angle.cert\n"
      "  phrame verify angle.cert --curve curve.json\n"
      "  phrame verify angle.cert --table frames.csv");
  command.does(options, run);
}

}  // namespace phrame::cli
