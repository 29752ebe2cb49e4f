#include "phrame/ph/proof/verify.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/ph/proof/statement.hpp"

#include <algorithm>

#include "phrame/cli/command.hpp"
#include "phrame/io/read/certificate_file.hpp"

namespace phrame::cli {
namespace {

struct VerifyOptions {
  std::string path;
  std::string output = "-";
  CurveLimits limits;
  TextLength length;
};

void run(const VerifyOptions& options) {
  const std::string text = read_file(options.path);
  const Certificate certificate = at_place(name_of_file(options.path), ":",
                                           [&] { return read_certificate(text, options.limits); });
  const std::vector<Statement> statements = verify(certificate);
  options.length.write(options.output, to_text(statements));
  if (!std::all_of(statements.begin(), statements.end(),
                   [](const Statement& statement) { return statement.is_proved(); }))
    throw AnswerNo{};
}

}  // namespace

void add_verify(Program& program) {
  Command& command = program.add("verify", "check a certificate");
  const auto options = std::make_shared<VerifyOptions>();
  command.add_argument("CERT", options->path, "a certificate (JSON), \"-\" for standard input");
  command.add_output(options->output);
  command.writes("text", {"txt"});
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
