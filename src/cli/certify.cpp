#include "phrame/ph/proof/certify.hpp"

#include <tuple>

#include "phrame/cli/certified.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/read/certificate_file.hpp"
#include "phrame/io/write/certificate.hpp"
#include "phrame/ph/proof/certify_integral.hpp"
#include "phrame/ph/proof/path_certificate.hpp"

namespace phrame::inline v0::cli {
namespace {

struct CertifyOptions {
  CurveOptions curve;
  Parameters parameters;
  std::string frame;
  UpOption up;
  bool of_length = false;
  long digits = 17;
  ClosedQuery closed;
};

/// Of a path of PH curves, to the Euler–Rodrigues frame or, of one curve, to the Frenet frame.
std::string certified(const NamedPhPath& named, Reference reference,
                      const std::vector<Rational>& at, const CertifyOptions& options) {
  const auto& [path, name] = std::tie(named.path, named.name);
  if (path.is_curve() && !options.closed.holonomy && !options.closed.writhe)
    return write_certificate(certify(path.segments().front(), reference, at, options.digits), name,
                             named.near);
  return write_certificate(certify(path, at, options.digits, options.closed), name);
}

std::string certified(const IntegralCertificate& c, const NamedPath& named) {
  return write_certificate(with_canonical_formulas(c), named.name);
}

/// Of the angle to the frame asked for, or of v.
std::string certified(const NamedPath& named, const std::vector<Rational>& at,
                      const std::optional<Reference>& asked,
                      const std::optional<Vector<Rational>>& v, const CertifyOptions& options) {
  const Path& path = named.path;
  const auto ph = with_preimages(named);
  // Of rational PH curves, too, which other angles are not measured from by themselves.
  const Reference reference =
      ph && !v && !asked ? Reference::euler_rodrigues : reference_of(path, v, asked);
  const bool is_about_closed = options.closed.holonomy || options.closed.writhe;
  if (is_about_closed && reference != Reference::euler_rodrigues)
    throw InputError(options.closed.holonomy ? "--holonomy" : "--writhe",
                     "this is of paths of PH curves, by the angle to the Euler-Rodrigues frame");
  if (reference == Reference::euler_rodrigues ||
      (reference == Reference::frenet && ph && ph->path.is_curve()))
    return certified(ph.value(), reference, at, options);
  return certified(certify(angle_to(v, path, asked), at, options.digits), named);
}

void run(const CertifyOptions& options) {
  std::optional<Reference> asked;
  if (!options.frame.empty()) asked = chosen_reference(options.frame);
  CurveOptions curve = options.curve;
  curve.is_for_frames = !options.of_length;
  const NamedPath named = curve.read_any_path();
  const Path& path = named.path;
  require_reference(asked, options.up, path);
  std::vector<Rational> at = options.parameters.fractions_on(named);
  if (at.empty()) at.push_back(path.end());
  const auto write = [&](const std::string& text) { write_output(options.curve.output, text); };
  if (options.of_length) return write(certified(certify_length(path, at, options.digits), named));
  write(certified(named, at, asked, options.up.chosen(path), options));
}

}  // namespace

std::string angle_certificate(const NamedPath& named, const std::vector<Rational>& at,
                              long digits) {
  CertifyOptions options;
  options.digits = digits;
  return certified(named, at, std::nullopt, std::nullopt, options);
}

void add_certify(Program& program) {
  Command& command = program.add("certify", "angles with a proof that others can check");
  const auto options = std::make_shared<CertifyOptions>();
  options->curve.add_to(command);
  command.writes("a certificate in JSON", {"json"});
  options->parameters.add_to(command);
  add_digits(command, options->digits);
  command.add_choice(
      "--frame", options->frame, {"erf", "frenet", "up"},
      "what the angle is measured from: erf (default of PH curves, which alone have\n"
      "it), up (default of others) or frenet");
  options->up.add_to(command,
                     "frame e2 = v x e1/|v x e1| (default: one that is nowhere along the tangent)");
  command.add_flag("--length", options->of_length, "the length from 0 to t instead of the angle");
  command.not_with({"--frame", "--up"}, {"--length"});
  command.add_flag("--holonomy", options->closed.holonomy,
                   "of a closed path also the angle by which the frame comes back turned");
  command.add_flag("--writhe", options->closed.writhe,
                   "of a closed path also its writhe, and the crossings that a projection shows");
  command.not_with({"--holonomy", "--writhe"}, {"--length"});
  command.set_notes(
      "Without --at and --samples that at the end. phrame verify checks the certificate, and so\n"
      "does tools/check_certificate.py, which needs Python and nothing else. Of angles to the\n"
      "Euler-Rodrigues frame that of a spline is made of those of its segments.\n"
      "Examples:\n"
      "  phrame certify curve.json --at 1/2,1 --digits 40 -o angle.cert\n"
      "  phrame certify curve.json --frame frenet | phrame verify -\n"
      "  phrame certify bezier.svg --length --digits 30");
  command.does(options, run);
}

}  // namespace phrame::cli
