#include "phrame/io/write/check.hpp"
#include "phrame/io/write/frame_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "phrame/answer/rounded.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

using FindingKind = FrameFinding::Kind;

std::string upper(const RealBall& x, long digits = 6) {
  return upper_bound_text(x.upper(), digits);
}

std::string lower(const RealBall& x, long digits = 6) {
  return lower_bound_text(std::max(Rational(0), x.lower()), digits);
}

/// A number or angle, a passage where it is longer than messages quote.
template <class T>
std::string brief(const T& x) {
  constexpr std::size_t limit = 40;
  return readable_exact(with_minus_sign(to_string(x)), limit);
}

/// t as a fraction; of a long one that was found, and is in no table, the first digits.
std::string brief_parameter(const Rational& t, const TableReading& reading) {
  constexpr std::size_t limit = 64;
  if (reading.parameters.empty() || to_string(t).size() <= limit) return brief(t);
  return with_minus_sign(round_to_decimal(t, 12).value) + "…";
}

std::string shown(const RealBall& x) {
  const bool is_tiny = x.contains_zero() || x.upper() - x.lower() > abs(x.upper()) / 1000;
  return is_tiny
             ? "0 ± " +
                   upper_bound_text(std::max(Rational(abs(x.lower())), Rational(abs(x.upper()))))
             : shown(rounded_as_known(x));
}

/// The name of a kind in JSON.
constexpr std::array kind_names{
    "undefined",        "wrong-tangent", "reversed-tangent", "left-handed", "not-orthogonal",
    "not-unit",         "flip",          "constant-offset",  "frenet",      "euler-rodrigues",
    "turned-backwards", "fixed-up",      "other-start",      "drift",       "irregular"};
static_assert(kind_names.size() == static_cast<std::size_t>(FindingKind::irregular) + 1);

const char* name_of(FindingKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

/// "(1, 0, 0)".
std::string brief_vector(const Vector<Rational>& v) {
  return fmt::format("({}, {}, {})", brief(v[0]), brief(v[1]), brief(v[2]));
}

/// "at the angle pi/4", "at the angle pi/4 to v × T, v = (0, 0, 1)", "with f2 along (1, 0, 0)".
std::string place_of(const FrameStart& start, const std::optional<Vector<Rational>>& up) {
  if (const auto* angle = std::get_if<Angle>(&start))
    return "at the angle " + brief(*angle) + (up ? " to v × T, v = " + brief_vector(*up) : "");
  if (const auto* least = std::get_if<LeastRotation>(&start))
    return least->turn == Angle() ? "at the least rotation"
                                  : "at the least rotation, turned by " + brief(least->turn);
  return "with f2 along " + brief_vector(std::get<StartNormal>(start).vector);
}

std::string sentence(const FrameFinding& finding) {
  const auto amount = [&] { return shown(*finding.amount) + " radians"; };
  const auto within = [&] { return "to within " + upper(*finding.residual, 2) + " radians"; };
  switch (finding.kind) {
    case FindingKind::undefined:
      return "f2 is 0 or along the tangent, so that it has no angle";
    case FindingKind::wrong_tangent:
      return "e1 is not the tangent of the curve";
    case FindingKind::reversed_tangent:
      return "e1 is the tangent reversed";
    case FindingKind::left_handed:
      return "the frame is left-handed: det(tangent, f2, f3) < 0";
    case FindingKind::not_orthogonal:
      return "the vectors are not orthogonal";
    case FindingKind::not_unit:
      return "the vectors are not of length 1";
    case FindingKind::flip:
      return "f2 flips against the sample before";
    case FindingKind::constant_offset:
      return fmt::format(
          "the frame is rotation-minimizing, {}, but starts at another angle: {} off", within(),
          amount());
    case FindingKind::frenet:
      return fmt::format("these are Frenet frames, {}: f2 keeps its angle to the principal normal",
                         within());
    case FindingKind::euler_rodrigues:
      return fmt::format("these are Euler–Rodrigues frames, {}: f2 keeps its angle to A j A*",
                         within());
    case FindingKind::turned_backwards:
      return fmt::format(
          "the {} is turned by −θ instead of θ, {}: the sign of the angle is wrong",
          finding.up ? "frame of v = " + brief_vector(*finding.up) : "Euler–Rodrigues frame",
          within());
    case FindingKind::fixed_up:
      return fmt::format(
          "these are frames of the fixed vector v = {}, {}: f2 keeps its angle to v × T",
          brief_vector(*finding.up), within());
    case FindingKind::other_start:
      return fmt::format("the frame does not start where it is to start: it is {} off", amount());
    case FindingKind::drift:
      return fmt::format(
          "f2 drifts: from the first sample to the last it turns by {} against the "
          "rotation-minimizing frame",
          amount());
    case FindingKind::irregular:
      return fmt::format("f2 turns irregularly against the rotation-minimizing frame, within {}",
                         amount());
  }
  return "";
}

/// So many the table has.
std::size_t count_of(const std::vector<GivenFrame>& frames, const TableReading& reading) {
  return reading.part ? reading.part->rows : frames.size();
}

/// The number of one of the frames in the table.
std::size_t number_of(std::size_t frame, const TableReading& reading) {
  return reading.part ? reading.part->numbers.at(frame) : frame;
}

/// t is that of the first: " at sample 3, t = 1/2", " at all samples", " at samples 3, 5, the first
/// at t = 1/2"; of many, abridged, " at 12 samples, the first is 3, t = 1/2 …".
std::string places(const std::vector<std::size_t>& samples, std::size_t count, const Rational& t) {
  if (samples.empty()) return "";
  if (samples.size() == count) return " at all samples";
  if (samples.size() == 1) return fmt::format(" at sample {}, t = {}", samples[0], brief(t));
  const auto all = [&](const std::string& first) {
    return fmt::format(" at samples {}, the first at t = {}", fmt::join(samples, ", "), first);
  };
  constexpr std::size_t few = 8;
  if (samples.size() <= few) return all(brief(t));
  return passage(all(with_minus_sign(to_string(t))),
                 fmt::format(" at {} samples, the first is {}, t = {} …", samples.size(),
                             samples[0], abridged(brief(t))));
}

}  // namespace

std::string summary(const CheckAnswer& answer) {
  const FrameVerdict& v = answer.verdict;
  const auto& start = answer.options.start;
  const std::string reference =
      start ? "that starts " + place_of(*start, answer.up) : "that agrees with the first sample";
  const bool is_close = v.max_error.upper() <= answer.options.tolerance;
  return fmt::format("{}: f2 is {} {} radians from the rotation-minimizing frame {}{}",
                     v.passes ? "pass" : "fail", is_close ? "at most" : "up to",
                     is_close ? upper(v.max_error, 2) : shown(v.max_error), reference,
                     is_close && !v.passes ? ", but " + sentence(v.findings.front()) : "");
}

std::string to_text(const CheckAnswer& answer, const TableReading& reading) {
  const FrameVerdict& v = answer.verdict;
  const auto [first, last] =
      std::minmax_element(answer.frames.begin(), answer.frames.end(),
                          [](const GivenFrame& a, const GivenFrame& b) { return a.t < b.t; });
  std::string text = name_prefix(answer.path.name);
  const std::string from = brief_parameter(first->t, reading);
  const std::size_t count = count_of(answer.frames, reading);
  text += first->t == last->t ? fmt::format("{}, t = {}\n\n", counted(count, "frame"), from)
                              : fmt::format("{} frames, t from {} to {}\n\n", count, from,
                                            brief_parameter(last->t, reading));
  text += summary(answer) + "\n\n";
  const auto row = [&](std::string_view label, const std::string& value) {
    text += phrame::row(label, value, 15);
  };
  const auto& worst = answer.frames[v.worst_sample];
  row("largest error",
      fmt::format("between {} and {} radians, at sample {}, t = {}", lower(v.max_error),
                  upper(v.max_error), number_of(v.worst_sample, reading),
                  brief_parameter(worst.t, reading)));
  if (v.drift)
    row("drift", shown(*v.drift) + " radians per unit of arc length, from first to last");
  row("orthogonality", "cosines up to " + upper(v.orthogonality, 2));
  row("lengths", "off 1 by up to " + upper(v.length, 2));
  row("tolerance", brief(answer.options.tolerance));
  if (!reading.columns.empty())
    row("columns",
        fmt::format("{} (by their number{})", fmt::join(reading.columns, ", "),
                    reading.skipped > 0 ? fmt::format(", {} more {} skipped", reading.skipped,
                                                      reading.skipped == 1 ? "is" : "are")
                                        : ""));
  if (!reading.parameters.empty()) text += fmt::format("\n  {}\n", reading.parameters);
  if (!v.findings.empty()) text += "\nFindings\n";
  for (std::size_t k = 0; k < v.findings.size(); ++k) {
    const auto& samples = reading.part ? reading.part->samples.at(k) : v.findings[k].samples;
    const Rational t = samples.empty() ? 0 : answer.frames[v.findings[k].samples[0]].t;
    text += fmt::format("  - {}{}\n", sentence(v.findings[k]), places(samples, count, t));
  }
  if (reading.better)
    text += fmt::format("\n{}: {}.\n",
                        reading.better->passes ? "It passes by another reading of the table"
                                               : "The tangents are right by another reading",
                        reading.better->options);
  return text + "\nBounds are proved, at these samples. Samples count from 0.\n";
}

std::string to_json(const CheckAnswer& answer, const TableReading& reading) {
  const FrameVerdict& v = answer.verdict;
  JsonOutput samples = JsonOutput::array();
  for (std::size_t k = 0; k < answer.frames.size(); ++k) {
    const FrameDeviation& at = v.deviations[k];
    const auto& error = v.errors[k];
    samples.push_back({{"t", to_string(answer.frames[k].t)},
                       {"error", error ? json_of(rounded_as_known(*error)) : JsonOutput()},
                       {"orthogonality", upper(at.orthogonality, 2)},
                       {"length", upper(at.length, 2)},
                       {"handedness", at.handedness}});
  }
  JsonOutput findings = JsonOutput::array();
  for (const FrameFinding& finding : v.findings) {
    findings.push_back({{"kind", name_of(finding.kind)},
                        {"text", sentence(finding)},
                        {"samples", finding.samples}});
    if (finding.up) findings.back()["up"] = phrame::json_of(*finding.up);
  }
  JsonOutput max_error = json_of_bounds(v.max_error);
  max_error["sample"] = v.worst_sample;
  JsonOutput json = {
      {"phrame", "check/1"},
      {"name", answer.path.name},
      {"verdict", v.passes ? "pass" : "fail"},
      {"tolerance", to_string(answer.options.tolerance)},
      {"max_error", max_error},
      {"drift", v.drift ? json_of(rounded_as_known(*v.drift)) : JsonOutput()},
      {"orthogonality", upper(v.orthogonality, 2)},
      {"length", upper(v.length, 2)},
      {"findings", findings},
      {"parameters", reading.parameters.empty() ? JsonOutput() : JsonOutput(reading.parameters)},
      {"better_reading", reading.better ? JsonOutput{{"options", reading.better->options},
                                                     {"passes", reading.better->passes}}
                                        : JsonOutput()},
      {"samples", samples}};
  if (const auto& start = answer.options.start) {
    if (const auto* angle = std::get_if<Angle>(&*start)) json["theta0"] = to_string(*angle);
    add_start(json, *start);
  }
  if (answer.up) json["up"] = phrame::json_of(*answer.up);
  add_nearness(json, answer.path.near);
  return pretty(json);
}

}  // namespace phrame
