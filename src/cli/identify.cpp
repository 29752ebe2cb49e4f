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
PathIdentification spline_of(const CurveOptions& options) {
  if (const auto epsilon = options.epsilon()) {
    auto found = options.read_path_near();
    if (const auto* none = std::get_if<NotNear>(&found)) throw AnswerNo{to_line(*none, *epsilon)};
    return {std::get<NamedPhPath>(std::move(found))};
  }
  const NamedPath named = options.read_any_path();
  const auto& segments = named.path.segments();
  const auto other = std::find_if_not(segments.begin(), segments.end(), ph_curve);
  if (other != segments.end())
    throw AnswerNo{fmt::format("segment {} is no PH curve", other - segments.begin() + 1)};
  return {with_preimages(named).value()};
}

/// What is asked of one curve; nothing for a path of several. A preimage that is given is none of
/// the least degree.
std::optional<std::variant<NamedHodograph, NamedRationalCurve>> one_curve(CurveOptions options,
                                                                          const std::string& text) {
  const std::string format = options.reading.is_plain() ? curve_file_format(text) : "";
  if (format == "spline/1") return std::nullopt;
  if (format == "curve/1") {
    if (auto rational = read_rational_curve(text, options.limits)) return *std::move(rational);
    return read_hodograph(text, options.limits);
  }
  options.near.reset();
  const NamedPath named = options.read_any_path();
  if (named.path.segments().size() > 1) return std::nullopt;
  const RationalCurve* curve = rational_curve(named.path.segments().front());
  if (curve == nullptr)
    throw InputError("",
                     "the curve is given by formulas; only polynomials and quotients of them "
                     "are identified as PH curves");
  if (curve->weight().is_constant())
    return NamedHodograph{named.name, hodograph(*curve), point(*curve, 0)};
  return NamedRationalCurve{named.name, *curve};
}

IdentificationAnswer identified(const NamedHodograph& curve,
                                const std::optional<Rational>& epsilon) {
  return answer(curve, epsilon);
}

IdentificationAnswer identified(const NamedRationalCurve& curve,
                                const std::optional<Rational>& epsilon) {
  IdentificationAnswer found = answer(curve);
  if (epsilon && std::holds_alternative<NotPythagorean>(found.result))
    throw InputError("/", "the curve is rational; --near is of polynomial ones");
  return found;
}

void run(const IdentifyOptions& options) {
  const auto print = printer<IdentificationAnswer>(options.print, to_curve_file);
  CurveOptions curve = options.curve;
  curve.bytes = read_file(curve.path);
  const std::string file = name_of_file(curve.path);
  const auto one = at_place(file, ":", [&] { return one_curve(curve, *curve.bytes); });
  if (!one) {
    const auto print_path = printer<PathIdentification>(options.print, to_path_file);
    return options.length.write(curve.output, print_path(spline_of(curve)));
  }
  const auto found = at_place(file, ":", [&] {
    return std::visit([&](const auto& given) { return identified(given, curve.epsilon()); }, *one);
  });
  options.length.write(curve.output, print(found));
  if (!curve_of(found)) throw AnswerNo{};
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
