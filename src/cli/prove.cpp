#include "phrame/algebra/as_written.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/write/coq_proof.hpp"

namespace phrame::inline v0::cli {
namespace {

struct ProveOptions {
  CurveOptions curve;
  std::string at = "1";
  std::string by = "t";
  std::string frame = "erf";
  StartOptions start;
  long digits = 20;
};

void run(const ProveOptions& options) {
  const auto reference =
      choose<Reference>("--frame", options.frame,
                        {{"erf", Reference::euler_rodrigues}, {"frenet", Reference::frenet}});
  const FrameStart start = options.start.start();
  const Rational x = parse_option("--at", options.at);
  if (options.by == "t" && x <= 0) throw InputError("--at", as_written(x) + " is not positive");
  const auto [named, at] = options.curve.read_curve_at({{options.at}, 0, options.by});
  if (at.front() <= 0) throw InputError("--at", as_written(x) + " is the start of the curve");
  options.start.check(PhPath(named.curve), reference);
  write_output(
      options.curve.output,
      coq_proof(answer(named.curve, CoqQuery{at.front(), options.digits, reference, start})));
}

}  // namespace

void add_prove(Program& program) {
  Command& command = program.add("prove", "a Coq file that proves frame and angle");
  const auto options = std::make_shared<ProveOptions>();
  options->curve.add_to(command);
  command.writes("a file for Coq", {"v"});
  command.add_option("--at", "T", options->at, "t > 0 (default 1)");
  add_by(command, options->by, "what --at is a value of: t (default)");
  command.only_with({"--by"}, {"--at"});
  add_digits(command, options->digits);
  add_reference(command, options->frame,
                "what the angle is measured from: erf (default) or frenet");
  options->start.add_to(command, StartOptions::Rule::reference);
  command.set_notes(
      "coqc accepts the file in seconds to minutes. It needs Coquelicot, CoqInterval (./dev prove\n"
      "installs them) and proofs/rotation_minimizing.v of phrame, compiled in the same folder.\n"
      "Examples:\n"
      "  phrame prove curve.json --at 1 --digits 30 -o angle.v && coqc angle.v");
  command.does(options, run);
}

}  // namespace phrame::cli
