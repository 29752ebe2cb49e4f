#include "phrame/ph/proof/certify.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/write/certificate.hpp"
#include "phrame/ph/proof/path_certificate.hpp"

namespace phrame::inline v0::cli {
namespace {

struct CertifyOptions {
  CurveOptions curve;
  Parameters parameters;
  std::string frame = "erf";
  long digits = 17;
  ClosedQuery closed;
};

void run(const CertifyOptions& options) {
  const auto reference = chosen_reference(options.frame);
  auto [named, at] = options.curve.read_path_at(options.parameters);
  const PhPath& path = named.path;
  if (at.empty()) at.push_back(path.end());
  const bool is_about_closed = options.closed.holonomy || options.closed.writhe;
  if (path.is_curve() && !is_about_closed) {
    write_output(options.curve.output,
                 write_certificate(certify(path.segments().front(), reference, at, options.digits),
                                   named.name, named.near));
    return;
  }
  if (reference == Reference::frenet) {
    if (path.is_curve())
      throw InputError("--frame", "\"frenet\" does not go with --holonomy and --writhe");
    fail_for_spline("--frame", options.frame);
  }
  write_output(options.curve.output,
               write_certificate(certify(path, at, options.digits, options.closed), named.name));
}

}  // namespace

void add_certify(Program& program) {
  Command& command = program.add("certify", "angles with a proof that others can check");
  const auto options = std::make_shared<CertifyOptions>();
  options->curve.add_to(command);
  command.writes("a certificate in JSON", {"json"});
  options->parameters.add_to(command);
  add_digits(command, options->digits);
  add_reference(command, options->frame,
                "what the angle is measured from: erf (default) or frenet");
  command.add_flag("--holonomy", options->closed.holonomy,
                   "of a closed path also the angle by which the frame comes back turned");
  command.add_flag("--writhe", options->closed.writhe,
                   "of a closed path also its writhe, and the crossings that a projection shows");
  command.set_notes(
      "Without --at and --samples the angle at the end. phrame verify checks the certificate, and "
      "so\n"
      "does tools/check_certificate.py, which needs Python and nothing else. That of a spline is\n"
      "made of those of its segments; it has no corners.\n"
      "Examples:\n"
      "  phrame certify curve.json --at 1/2,1 --digits 40 -o angle.cert\n"
      "  phrame certify curve.json --frame frenet | phrame verify -");
  command.does(options, run);
}

}  // namespace phrame::cli
