#include <fmt/format.h>

#include <algorithm>

#include "phrame/answer/identification.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/io/write/nearness.hpp"

namespace phrame::inline v0::cli {
namespace {

struct IdentifyOptions {
  CurveOptions curve;
  std::string print = "text";
  TextLength length;
};

/// The curve, or the one that stands for it; no value where there is none.
std::optional<NamedCurve> curve_of(const IdentificationAnswer& answer) {
  if (const auto* curve = std::get_if<Curve>(&answer.result))
    return NamedCurve{answer.name, *curve};
  const auto* near = answer.near ? std::get_if<NearCurve>(&answer.near->found) : nullptr;
  if (near == nullptr) return std::nullopt;
  return NamedCurve{answer.name, near->curve, near->nearness};
}

std::string to_curve_file(const IdentificationAnswer& answer) {
  if (const auto curve = curve_of(answer)) return write_curve(*curve);
  if (answer.near)
    throw AnswerNo{to_line(std::get<NotNear>(answer.near->found), answer.near->epsilon)};
  throw AnswerNo{"this is no PH curve: " + reason_of(answer)};
}

std::string to_path_file(const PathIdentification& found) { return write_path(found.path); }

template <class Answer>
using Printer = std::string (*)(const Answer&);

template <class Answer>
Printer<Answer> printer(const std::string& name, Printer<Answer> as_curve) {
  return choose<Printer<Answer>>(
      "--print", name,
      {{"text", to_text}, {"json", to_json}, {"latex", to_latex}, {"curve", as_curve}});
}

/// The spline, or the one that stands for it. Throws AnswerNo where there is none.
PathIdentification spline_of(const std::string& text, const std::optional<Rational>& epsilon,
                             const CurveLimits& limits) {
  if (epsilon) {
    auto found = read_path_near(text, *epsilon, limits);
    if (const auto* none = std::get_if<NotNear>(&found)) throw AnswerNo{to_line(*none, *epsilon)};
    return {std::get<NamedPhPath>(std::move(found))};
  }
  const NamedPath named = read_any_path(text, limits);
  const auto& segments = named.path.segments();
  const auto other = std::find_if_not(segments.begin(), segments.end(), ph_curve);
  if (other != segments.end())
    throw AnswerNo{fmt::format("segment {} is no PH curve", other - segments.begin() + 1)};
  return {with_preimages(named).value()};
}

void run_for_spline(const IdentifyOptions& options, const std::string& text) {
  const auto print = printer<PathIdentification>(options.print, to_path_file);
  const PathIdentification found = at_place(name_of_file(options.curve.path), ":", [&] {
    return spline_of(text, options.curve.epsilon(), options.curve.limits);
  });
  options.length.write(options.curve.output, print(found));
}

/// Of one curve.
IdentificationAnswer identified(const std::string& text, const std::optional<Rational>& epsilon,
                                const CurveLimits& limits) {
  const auto rational = read_rational_curve(text, limits);
  if (!rational) return answer(read_hodograph(text, limits), epsilon);
  IdentificationAnswer found = answer(*rational);
  if (epsilon && std::holds_alternative<NotPythagorean>(found.result))
    throw InputError("/", "the curve is rational; --near is of polynomial ones");
  return found;
}

void run(const IdentifyOptions& options) {
  const auto print = printer<IdentificationAnswer>(options.print, to_curve_file);
  const auto epsilon = options.curve.epsilon();
  const std::string text = read_file(options.curve.path);
  const auto found = at_place(name_of_file(options.curve.path), ":", [&] {
    options.curve.reading.refuse_skipping("one curve by itself");
    options.curve.reading.refuse_picking("one curve by itself");
    return is_spline_file(text) ? std::nullopt
                                : std::optional(identified(text, epsilon, options.curve.limits));
  });
  if (!found) return run_for_spline(options, text);
  options.length.write(options.curve.output, print(*found));
  if (!curve_of(*found)) throw AnswerNo{};
}

}  // namespace

void add_identify(Program& program) {
  Command& command = program.add("identify", "is a curve Pythagorean-hodograph (PH)? its preimage");
  const auto options = std::make_shared<IdentifyOptions>();
  options->curve.add_to(command);
  command.add_format("--print", options->print, {"text", "json", "latex", "curve"},
                     "text (default), json, latex, or curve: a curve file with the preimage");
  options->length.add_to(command);
  command.set_notes(
      "Only r' counts, given by control_points or by any preimage and multiplier; found are the A\n"
      "of least degree and f with r' = f A i A*, of a rational curve X/W with r' = f A i A*/W^2.\n"
      "Exit status 1: the curve is not PH over Q, and "
      "with\n"
      "--near EPS there is none found within EPS, the distance of control points. Where one is, "
      "it\n"
      "is told how near it is, proved, and by how much rotation-minimizing frames may differ. A\n"
      "spline is PH where all of its segments are.\n"
      "Examples:\n"
      "  phrame identify bezier.json\n"
      "  phrame identify doubles.json --near 1e-14\n"
      "  phrame identify bezier.json --print curve -o ph.json");
  command.does(options, run);
}

}  // namespace phrame::cli
