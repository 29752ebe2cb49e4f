#include "phrame/ph/proof/verify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/cli/command.hpp"
#include "phrame/io/read/certificate_file.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::cli {
namespace {

struct VerifyOptions {
  std::string path;
  std::string output = "-";
  CurveLimits limits;
  TextLength length;
};

/// "|theta(t) - 0.5| <= 1e-9", a long t as a passage.
std::string shown(const std::string& what) {
  constexpr std::string_view before = "theta(";
  constexpr std::size_t limit = 240;
  const std::size_t at = what.find(before);
  if (at == std::string::npos) return what;
  const std::size_t begin = at + before.size();
  const std::size_t end = std::min(what.find(')', begin), what.size());
  return what.substr(0, begin) + readable_exact(what.substr(begin, end - begin), limit) +
         what.substr(end);
}

void run(const VerifyOptions& options) {
  const std::string text = read_file(options.path);
  const Certificate certificate = at_place(name_of_file(options.path), ":",
                                           [&] { return read_certificate(text, options.limits); });
  const std::vector<Statement> statements = verify(certificate);
  std::string report;
  for (const auto& [what, objection] : statements)
    report += objection.empty() ? fmt::format("proved      {}\n", shown(what))
                                : fmt::format("not proved  {}: {}\n", shown(what), objection);
  const auto not_proved =
      std::count_if(statements.begin(), statements.end(),
                    [](const Statement& statement) { return !statement.is_proved(); });
  report += not_proved == 0 ? fmt::format("all {} statements are proved\n", statements.size())
                            : fmt::format("{} of {} statements {} not proved\n", not_proved,
                                          statements.size(), not_proved == 1 ? "is" : "are");
  options.length.write(options.output, report);
  if (not_proved > 0) throw AnswerNo{};
}

}  // namespace

void add_verify(Program& program) {
  Command& command = program.add("verify", "check a certificate");
  const auto options = std::make_shared<VerifyOptions>();
  command.add_argument("CERT", options->path, "a certificate (JSON), \"-\" for standard input");
  command.add_output(options->output);
  add_max_degree(command, options->limits);
  command.add_flag("--full", options->length.is_full, "abridge nothing: a long t");
  command.set_notes(
      "Starts from the curve in the certificate and proves every statement by another way than it\n"
      "was found. Exit status 0: all are proved, 1: not all.\n"
      "Examples:\n"
      "  phrame verify angle.cert");
  command.does([options] { run(*options); });
}

}  // namespace phrame::cli
