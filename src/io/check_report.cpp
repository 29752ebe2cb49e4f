#include "phrame/io/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/json_text.hpp"
#include "phrame/io/text.hpp"

namespace phrame {
namespace {

using Kind = FrameFinding::Kind;

std::string upper(const RealBall& x, long digits = 6) {
  return upper_bound_text(x.upper(), digits);
}

std::string lower(const RealBall& x, long digits = 6) {
  return lower_bound_text(std::max(Rational(0), x.lower()), digits);
}

/// "0.2858565" for a ball, and a bound of what it is off.
Decimal rounded(const RealBall& x) {
  const Rational middle = x.midpoint();
  Decimal text = round_to_decimal(middle, 10);
  const Rational off = abs(Rational(middle - parse_rational(text.value))) + x.radius();
  text.radius = upper_bound_text(off);
  return text;
}

std::string shown(const RealBall& x) {
  const bool is_tiny = x.contains_zero() || x.upper() - x.lower() > abs(x.upper()) / 1000;
  return is_tiny
             ? "0 ± " +
                   upper_bound_text(std::max(Rational(abs(x.lower())), Rational(abs(x.upper()))))
             : rounded(x).value;
}

struct Description {
  const char* name;  ///< in JSON
  const char* sentence;
};

Description describe(Kind kind) {
  switch (kind) {
    case Kind::undefined:
      return {"undefined", "f2 is 0 or along the tangent, so that it has no angle"};
    case Kind::wrong_tangent:
      return {"wrong-tangent", "e1 is not the tangent of the curve"};
    case Kind::reversed_tangent:
      return {"reversed-tangent", "e1 is the tangent reversed"};
    case Kind::left_handed:
      return {"left-handed", "the frame is left-handed: det(e1, f2, f3) = −1"};
    case Kind::not_orthogonal:
      return {"not-orthogonal", "the vectors are not orthogonal"};
    case Kind::not_unit:
      return {"not-unit", "the vectors are not of length 1"};
    case Kind::flip:
      return {"flip", "f2 flips against the sample before"};
    case Kind::constant_offset:
      return {"constant-offset", "the frame is rotation-minimizing, but starts at another angle"};
    case Kind::frenet:
      return {"frenet", "these are Frenet frames: f2 keeps its angle to the principal normal"};
    case Kind::euler_rodrigues:
      return {"euler-rodrigues", "these are Euler–Rodrigues frames: f2 keeps its angle to A j A*"};
    case Kind::turned_backwards:
      return {"turned-backwards",
              "the Euler–Rodrigues frame is turned by −θ instead of θ: the sign of the angle is "
              "wrong"};
  }
  return {"", ""};
}

/// " at sample 3, t = 1/2", " at all samples", " at 12 samples, first at 3, t = 1/2".
std::string places(const FrameFinding& finding, const std::vector<GivenFrame>& frames) {
  const auto& samples = finding.samples;
  if (samples.empty()) return "";
  if (samples.size() == frames.size()) return " at all samples";
  const auto place = [&](std::size_t k) {
    return fmt::format("{}, t = {}", k, abbreviated(to_string(frames[k].t)));
  };
  if (samples.size() == 1) return " at sample " + place(samples[0]);
  return passage(
      fmt::format(" at samples {}", fmt::join(samples, ", ")),
      fmt::format(" at {} samples, the first is {} …", samples.size(), place(samples[0])));
}

}  // namespace

std::string summary(const CheckReport& report) {
  const FrameVerdict& v = report.verdict;
  const auto& start = report.options.start_angle;
  const std::string reference = start ? "that starts at the angle " + abbreviated(to_string(*start))
                                      : "that agrees with the first sample";
  const bool is_close = v.max_error.upper() <= report.options.tolerance;
  return fmt::format("{}: f2 is {} {} radians from the rotation-minimizing frame {}{}",
                     v.passes ? "pass" : "fail", is_close ? "at most" : "up to",
                     is_close ? upper(v.max_error, 2) : shown(v.max_error), reference,
                     is_close && !v.passes
                         ? std::string(", but ") + describe(v.findings.front().kind).sentence
                         : "");
}

std::string to_text(const CheckReport& report) {
  const FrameVerdict& v = report.verdict;
  const auto [first, last] =
      std::minmax_element(report.frames.begin(), report.frames.end(),
                          [](const GivenFrame& a, const GivenFrame& b) { return a.t < b.t; });
  std::string text = fmt::format("{}{} frames, t from {} to {}\n\n", name_prefix(report.curve),
                                 report.frames.size(), abbreviated(to_string(first->t)),
                                 abbreviated(to_string(last->t)));
  text += summary(report) + "\n\n";
  const auto row = [&](std::string_view label, const std::string& value) {
    text += phrame::row(label, value, 15);
  };
  const auto& worst = report.frames[v.worst_sample];
  row("largest error",
      fmt::format("between {} and {} radians, at sample {}, t = {}", lower(v.max_error),
                  upper(v.max_error), v.worst_sample, abbreviated(to_string(worst.t))));
  if (v.drift)
    row("drift", shown(*v.drift) + " radians per unit of arc length, from first to last");
  row("orthogonality", "cosines up to " + upper(v.orthogonality, 2));
  row("lengths", "off 1 by up to " + upper(v.length, 2));
  row("tolerance", abbreviated(to_string(report.options.tolerance)));
  if (!v.findings.empty()) text += "\nFindings\n";
  for (const FrameFinding& finding : v.findings)
    text +=
        fmt::format("  - {}{}\n", describe(finding.kind).sentence, places(finding, report.frames));
  return text + "\nBounds are proved. Samples count from 0.\n";
}

std::string to_json(const CheckReport& report) {
  const FrameVerdict& v = report.verdict;
  JsonOutput samples = JsonOutput::array();
  for (std::size_t k = 0; k < report.frames.size(); ++k) {
    const FrameDeviation& at = v.deviations[k];
    const auto& error = v.errors[k];
    samples.push_back({{"t", to_string(report.frames[k].t)},
                       {"error", error ? json_of(rounded(*error)) : JsonOutput()},
                       {"orthogonality", upper(at.orthogonality, 2)},
                       {"length", upper(at.length, 2)},
                       {"handedness", at.handedness}});
  }
  JsonOutput findings = JsonOutput::array();
  for (const FrameFinding& finding : v.findings)
    findings.push_back({{"kind", describe(finding.kind).name},
                        {"text", describe(finding.kind).sentence},
                        {"samples", finding.samples}});
  return pretty(
      {{"phrame", "check/1"},
       {"name", report.curve},
       {"verdict", v.passes ? "pass" : "fail"},
       {"tolerance", to_string(report.options.tolerance)},
       {"max_error",
        {{"lower", lower(v.max_error)}, {"upper", upper(v.max_error)}, {"sample", v.worst_sample}}},
       {"drift", v.drift ? json_of(rounded(*v.drift)) : JsonOutput()},
       {"orthogonality", upper(v.orthogonality, 2)},
       {"length", upper(v.length, 2)},
       {"findings", findings},
       {"samples", samples}});
}

}  // namespace phrame
