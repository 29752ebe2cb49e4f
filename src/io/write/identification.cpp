#include "phrame/io/write/identification.hpp"

#include <fmt/format.h>

#include "phrame/algebra/rounding.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/nearness.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame {
namespace {

std::string reason_text(const NotPythagorean& reason) {
  if (reason.odd_factor == Polynomial{1})
    return fmt::format(
        "  |r′| is √{} times a polynomial: the curve is PH over ℝ, but has no preimage with\n"
        "  rational coefficients, whatever the multiplier\n",
        abbreviated(reason.radicand.str()));
  return fmt::format("  |r′| is no polynomial: |r′|² has these factors to an odd power:\n    {}\n",
                     readable_factors(reason.odd_factor));
}

std::string curve_text(const Curve& curve) {
  const auto plain = [](const Polynomial& p) {
    return readable(formatted(p, Notation::unicode), p);
  };
  const auto& [u, v, p, q] = curve.preimage();
  const Polynomial speed = curve.multiplier() * sigma(curve.preimage());
  return fmt::format(
      "r′ = f · A i A* with A = u + v i + p j + q k\n\n"
      "  f      {}\n  u      {}\n  v      {}\n  p      {}\n  q      {}\n  f|A|²  {}\n",
      plain(curve.multiplier()), plain(u), plain(v), plain(p), plain(q), readable_factors(speed));
}

std::string nearness_text(const Nearness& nearness) {
  const std::string frames =
      nearness.rmf_difference
          ? fmt::format("rotation-minimizing frames differ by at most {} (radians)",
                        upper_bound_text(*nearness.rmf_difference))
          : "no bound of what frames differ by: the speed is not kept from 0";
  return fmt::format(
      "  distance  at most {}, of control points and so of the curves; {} before A was rounded\n"
      "            to multiples of 2^{}\n"
      "  frames    {}\n",
      upper_bound_text(nearness.distance), upper_bound_text(nearness.unrounded_distance),
      -nearness.bits, frames);
}

std::string near_text(const IdentificationAnswer::Near& near) {
  if (const auto* none = std::get_if<NotNear>(&near.found)) {
    return "\n  " + to_line(*none, near.epsilon) + "\n";
  }
  const auto& found = std::get<NearCurve>(near.found);
  return fmt::format("\nWithin {} there is the {}\n\n{}\n{}", distance_text(near.epsilon),
                     heading("", found.curve), nearness_text(found.nearness),
                     curve_text(found.curve));
}

std::string suggestion_text(const NearSuggestion& suggestion) {
  return fmt::format("\n  --near {} takes the PH curve {} from it.\n",
                     distance_text(suggestion.epsilon), upper_bound_text(suggestion.distance));
}

void add_curve(JsonOutput& json, const Curve& curve) {
  const auto& [u, v, p, q] = curve.preimage();
  json["degree"] = degree(curve);
  json["multiplier"] = json_of(curve.multiplier());
  json["preimage"] = {{"u", json_of(u)}, {"v", json_of(v)}, {"p", json_of(p)}, {"q", json_of(q)}};
  json["start"] = json_of(curve.start());
  json["speed"] = json_of(curve.multiplier() * sigma(curve.preimage()));
}

void add_nearness(JsonOutput& json, const Nearness& nearness) {
  json["distance"] = upper_bound_text(nearness.distance);
  json["unrounded_distance"] = upper_bound_text(nearness.unrounded_distance);
  json["bits"] = nearness.bits;
  json["rmf_difference"] = nullptr;
  if (nearness.rmf_difference) json["rmf_difference"] = upper_bound_text(*nearness.rmf_difference);
}

JsonOutput json_of(const IdentificationAnswer::Near& near) {
  JsonOutput json = {{"epsilon", to_string(near.epsilon)}};
  if (const auto* none = std::get_if<NotNear>(&near.found)) {
    json["found"] = false;
    json["distance"] = upper_bound_text(none->distance);
    return json;
  }
  const auto& [curve, nearness] = std::get<NearCurve>(near.found);
  json["found"] = true;
  add_nearness(json, nearness);
  add_curve(json, curve);
  return json;
}

}  // namespace

std::string to_text(const IdentificationAnswer& answer) {
  if (const auto* curve = std::get_if<Curve>(&answer.result))
    return heading(answer.name, *curve) + "\n\n" + curve_text(*curve) +
           "\n  Checked: f · A i A* is r′, exactly.\n";
  std::string text = name_prefix(answer.name) + "not a PH curve over ℚ\n\n" +
                     reason_text(std::get<NotPythagorean>(answer.result));
  if (answer.near) text += near_text(*answer.near);
  if (answer.suggestion) text += suggestion_text(*answer.suggestion);
  return text;
}

std::string to_json(const IdentificationAnswer& answer) {
  JsonOutput json = {{"phrame", "identify/1"}, {"name", answer.name}};
  if (const auto* curve = std::get_if<Curve>(&answer.result)) {
    json["ph"] = true;
    add_curve(json, *curve);
    json["checked"] = true;  // nothing unchecked leaves identify()
  } else {
    const auto& reason = std::get<NotPythagorean>(answer.result);
    json["ph"] = false;
    json["reason"] = to_string(reason);
    json["odd_factor"] = json_of(reason.odd_factor);
    json["radicand"] = reason.radicand.str();
    if (answer.near) json["near"] = json_of(*answer.near);
    if (answer.suggestion)
      json["suggestion"] = {{"near", distance_text(answer.suggestion->epsilon)},
                            {"distance", upper_bound_text(answer.suggestion->distance)}};
  }
  return pretty(json);
}

std::string to_text(const PathIdentification& found) {
  return heading(found.named) + "\n\n" +
         (found.nearness
              ? "What was given is near it, but not PH over ℚ.\n\n" + nearness_text(*found.nearness)
              : "  Checked: all segments are as they were given, exactly.\n");
}

std::string to_json(const PathIdentification& found) {
  JsonOutput json = {{"phrame", "identify/1"}, {"name", found.named.name}};
  json["ph"] = !found.nearness;
  if (found.nearness) {
    json["near"] = {{"found", true}};
    add_nearness(json["near"], *found.nearness);
  }
  JsonOutput segments = JsonOutput::array();
  for (const Curve& curve : found.named.path.segments()) {
    JsonOutput segment;
    add_curve(segment, curve);
    segments.push_back(std::move(segment));
  }
  json["segments"] = std::move(segments);
  return pretty(json);
}

}  // namespace phrame
