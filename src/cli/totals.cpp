#include "phrame/answer/totals.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/ph/along/up_vector.hpp"

namespace phrame::inline v0::cli {
namespace {

struct TotalsOptions {
  CurveOptions curve;
  std::string print = "text";
  TextLength length;
  long digits = 17;
  std::optional<std::string> other;
  std::optional<std::string> helicity;
};

void run(const TotalsOptions& options) {
  const auto print = choose<std::string (*)(const TotalsAnswer&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"latex", to_latex}});
  TotalsQuery query{options.digits};
  if (options.other) {
    CurveOptions other = options.curve;
    other.path = *options.other;
    query.other = other.read_any_path();
  }
  const NamedPath path = options.curve.read_any_path();
  if (options.helicity) {
    const Vector<Rational> v = parse_vector_option("--helicity", *options.helicity);
    at_option("--helicity", [&] { require_up_vector(path.path, v); });
    query.helicity_about = v;
  }
  options.length.write(options.curve.output, print(answer(path, query)));
}

}  // namespace

void add_totals(Program& program) {
  Command& command =
      program.add("totals", "length, twist, torsion, curvature and energies, in closed form");
  const auto options = std::make_shared<TotalsOptions>();
  options->curve.add_to(command);
  add_digits(command, options->digits);
  command.add_option("--linked-with", "FILE", options->other,
                     "another closed curve: how often the two are linked");
  command.add_option("--helicity", "X,Y,Z", options->helicity,
                     "of a closed curve, how often the normal, continued through inflections,\n"
                     "turns about the tangent against v x e1 of this vector v");
  command.add_format("--print", options->print, {"text", "json", "latex"},
                     "text (default), json or latex");
  options->length.add_to(command);
  command.set_notes(
      "Integrals from t = 0 to 1, each with its integrand, its antiderivative and its value.\n"
      "A total that is infinite is said to be so, with the pole; one that is not defined says "
      "why.\n"
      "These are answers, too: the exit status is 0. What is not elementary has no formula.\n"
      "Of a spline they are the sums over its segments, without the formulas. Curves that are not\n"
      "Pythagorean-hodograph have no formulas. Of closed ones there are the holonomy, the writhe\n"
      "and the self-linking number, too, and with --linked-with the linking number of two.\n"
      "Examples:\n"
      "  phrame totals curve.json --digits 30\n"
      "  phrame totals ring.json --linked-with other-ring.json\n"
      "  phrame totals curve.json --print json -o totals.json");
  command.does(options, run);
}

}  // namespace phrame::cli
