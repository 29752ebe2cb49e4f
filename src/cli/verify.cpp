#include "phrame/ph/proof/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "phrame/cli/command.hpp"
#include "phrame/io/read/certificate_file.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/exact_form.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/sha256.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/proof/check_table.hpp"
#include "phrame/ph/proof/path_certificate.hpp"
#include "phrame/ph/proof/statement.hpp"
#include "phrame/ph/proof/verify_integral.hpp"

namespace phrame::inline v0::cli {
namespace {

struct VerifyOptions {
  std::string path;
  std::vector<std::string> more;
  std::optional<std::string> curve;
  std::optional<std::string> table;
  std::string output = "-";
  CertificateLimits limits;
  bool is_unlimited = false;
  TextLength length;
};

/// The exact forms of the curves of a certificate, one behind the other.
std::string exact_form_of(const std::vector<Curve>& curves) {
  std::string text;
  for (const Curve& curve : curves) text += exact_form(curve);
  return text;
}
std::vector<Curve> curves_of(const Certificate& c) { return {c.curve}; }
std::vector<Curve> curves_of(const PathCertificate& c) {
  std::vector<Curve> curves;
  for (const Certificate& segment : c.segments) curves.push_back(segment.curve);
  return curves;
}
std::string exact_form_of(const Certificate& c) { return exact_form_of(curves_of(c)); }
std::string exact_form_of(const PathCertificate& c) { return exact_form_of(curves_of(c)); }
std::string exact_form_of(const IntegralCertificate& c) {
  std::string text;
  for (const CertifiedSegment& segment : c.segments) {
    const auto* s = std::get_if<IntegralSegment>(&segment);
    text += s != nullptr ? exact_form(s->position, s->weight)
                         : exact_form(std::get<FormulaSegment>(segment));
  }
  return text;
}

std::string frame_of(const Certificate& c) { return name_of(c.reference); }
std::string frame_of(const PathCertificate&) { return name_of(Reference::euler_rodrigues); }
std::string frame_of(const IntegralCertificate& c) {
  if (c.frame == Reference::up) return "up " + abbreviated(c.up);
  return c.frame ? name_of(*c.frame) : "none";
}

std::string other_curve(const std::string& exact_form) {
  return "that one has sha256 " + sha256(exact_form);
}

/// Why the certificate is not of the curves in a file, or "". Euler–Rodrigues frames are the same
/// but for a constant turn where h/σ is.
template <class C>
std::string objection_to_curves(const C& c, const CurveOptions& file) {
  const std::vector<Curve> own = curves_of(c);
  const std::vector<Curve> other = file.read_path_with_preimages().path.segments();
  if (exact_form_of(other) != exact_form_of(own)) return other_curve(exact_form_of(other));
  const bool is_to_erf = frame_of(c) == name_of(Reference::euler_rodrigues);
  const bool is_same =
      !is_to_erf || std::ranges::equal(other, own, [](const Curve& a, const Curve& b) {
        return rate_to_erf(a.preimage()) == rate_to_erf(b.preimage());
      });
  return is_same ? "" : "its preimage, and so its Euler-Rodrigues frame, is another one";
}
std::string objection_to_curves(const IntegralCertificate& c, const CurveOptions& file) {
  std::string other;
  const Path path = file.read_any_path().path;
  for (const Segment& segment : path.segments()) {
    if (const auto* by_formulas = std::get_if<ExpressionCurve>(&segment)) {
      const Vector<Formula>& r = by_formulas->position();
      other += exact_form({{canonical(r[0]), canonical(r[1]), canonical(r[2])},
                           canonical(by_formulas->from()),
                           canonical(by_formulas->to()),
                           {}});
      continue;
    }
    const Curve* ph = ph_curve(segment);
    const RationalCurve* curve = rational_curve(segment);
    other += ph != nullptr ? exact_form(*ph) : exact_form(curve->numerator(), curve->weight());
  }
  return other == exact_form_of(c) ? "" : other_curve(other);
}

template <class C>
Statement check_curves(const C& c, const std::string& path, const CurveLimits& limits) {
  CurveOptions file;
  file.path = path;
  file.limits = limits;
  file.is_for_frames = false;
  return {"curve of " + path, objection_to_curves(c, file)};
}

/// The rows of a table, as phrame frames writes it. Throws InputError.
std::vector<std::vector<Rational>> read_table(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  const auto next_line = [&] {
    if (!std::getline(lines, line)) return false;
    if (line.ends_with('\r')) line.pop_back();
    return true;
  };
  const std::string head = fmt::format("{}", fmt::join(certified_columns(), ","));
  if (!next_line() || line != head) throw InputError("line 1", "it is not " + head);
  static const std::regex number("-?[0-9]+([.][0-9]+)?(e[-+]?[0-9]{1,3})?");
  std::vector<std::vector<Rational>> rows;
  while (next_line()) {
    const std::vector<std::string> cells = split({line});
    const auto is_number = [&](const std::string& cell) {
      return cell.size() <= 400 && std::regex_match(cell, number);
    };
    if (line.find_first_of(" \t\v\f\r") != std::string::npos ||
        cells.size() != certified_columns().size() || !std::ranges::all_of(cells, is_number))
      throw InputError(line_place(static_cast<long>(rows.size()) + 2),
                       fmt::format("{} decimal numbers are wanted", certified_columns().size()));
    rows.emplace_back();
    for (const std::string& cell : cells) rows.back().push_back(parse_rational(cell));
  }
  return rows;
}

/// What is stated, with what the options add.
template <class C>
std::vector<Statement> statements_of(const C& certificate, const CertificateLimits& limits,
                                     const VerifyOptions& options) {
  std::vector<Statement> statements;
  if (options.curve) statements.push_back(check_curves(certificate, *options.curve, limits.curve));
  for (Statement& statement : verify(certificate)) statements.push_back(std::move(statement));
  if (options.table) {
    const std::string rows = read_file(*options.table);
    const std::string file = name_of_file(*options.table);
    statements.push_back({"table " + file, objection_to_table(certificate, at_place(file, ":", [&] {
                                                                return read_table(rows);
                                                              }))});
  }
  return statements;
}

NamedAnyCertificate read_named(const std::string& path, const CertificateLimits& limits) {
  const std::string text = read_file(path);
  return at_place(name_of_file(path), ":", [&] { return read_any_certificate(text, limits); });
}

/// A line for each file.
void check_each(const CertificateLimits& limits, const VerifyOptions& options) {
  std::vector<std::string> paths{options.path};
  paths.insert(paths.end(), options.more.begin(), options.more.end());
  Output output(options.output);
  bool is_proved = true;
  std::size_t refused = 0;
  for (const std::string& path : paths) try {
      const auto statements = std::visit(
          [&](const auto& named) { return statements_of(named.certificate, limits, options); },
          read_named(path, limits));
      is_proved = is_proved && are_proved(statements);
      output.write(fmt::format("{}: {}\n", name_of_file(path), summary(statements)));
    } catch (const InputError& error) {
      ++refused;
      output.write(fmt::format("{}\n", error.what()));
    }
  output.finish();
  if (refused > 0)
    throw InputError(fmt::format("{} of {} files", refused, paths.size()),
                     "no certificate, or beyond the limits");
  if (!is_proved) throw AnswerNo{};
}

void run(const VerifyOptions& options) {
  CertificateLimits limits = options.limits;
  limits.is_limited = !options.is_unlimited;
  if (!options.more.empty()) return check_each(limits, options);
  const auto print = [&](const auto& named) {
    const auto statements = statements_of(named.certificate, limits, options);
    constexpr std::size_t longest_name = 200;
    options.length.write(
        options.output,
        fmt::format("curve       {}\nsha256      {}\nframe       {}\n",
                    named.name.empty() ? "without a name" : abbreviated(named.name, longest_name),
                    sha256(exact_form_of(named.certificate)), frame_of(named.certificate)) +
            to_text(statements));
    if (!are_proved(statements)) throw AnswerNo{};
  };
  std::visit(print, read_named(options.path, limits));
}

}  // namespace

void add_verify(Program& program) {
  Command& command = program.add("verify", "check a certificate");
  const auto options = std::make_shared<VerifyOptions>();
  command.add_argument("CERT", options->path, "a certificate (JSON), \"-\" for standard input");
  command.add_optional_arguments("MORE", options->more,
                                 "other certificates: then there is one line for each");
  command.add_option("--curve", "FILE", options->curve, "the curve or path that it must be of");
  command.add_option("--table", "FILE", options->table,
                     "frames, as phrame frames writes them, at the t of the certificate: is each\n"
                     "number the double next to the exact one?");
  command.add_output(options->output);
  command.writes("text", {"txt"});
  command.not_with({"--table"}, {"MORE"});
  add_max_degree(command, options->limits.curve);
  command.add_flag("--unlimited", options->is_unlimited,
                   "check it even if that may take longer than docs/certificate.md promises");
  command.add_flag("--full", options->length.is_full, "abridge nothing: a long t");
  command.set_notes(
      "Starts from the curve in the certificate and proves every statement by another way than it\n"
      "was found. Exit status 0: all are proved, 1: not all, 2: what is refused is among the "
      "files.\n"
      "Examples:\n"
      "  phrame verify angle.cert\n"
      "  phrame verify angle.cert --curve curve.json\n"
      "  phrame verify angle.cert --table frames.csv\n"
      "  phrame verify collection/certificates/*.json");
  command.does(options, run);
}

}  // namespace phrame::cli
