#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/identification.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/nearness.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame::inline v0 {
namespace {

/// The lengths of rational curves are those of W²r′.
std::string of_speed(std::string text, bool is_rational) {
  if (!is_rational) return text;
  for (const char* r : {"|r′|", "|r'|"})
    for (std::size_t at = 0; (at = text.find(r, at)) != std::string::npos; at += 4)
      text.insert(at + 1, r[2] == '\'' ? "W^2 " : "W²");
  return text;
}

std::string reason_text(const NotPythagorean& reason, Notation notation) {
  const bool is_latex = notation == Notation::latex;
  const std::string radicand = reason.radicand.str();
  if (reason.odd_factor == Polynomial{1})
    return fmt::format(
        "  $|r′|$ is ${}$ times a polynomial: the curve is PH over $ℝ$, but has no preimage with\n"
        "  rational coefficients, whatever the multiplier\n",
        is_latex ? "\\sqrt{" + radicand + "}" : "√" + abbreviated(radicand));
  return fmt::format(
      "  $|r′|$ is no polynomial: $|r′|²$ has these factors to an odd power:\n    {}\n",
      in_words(Factored{reason.odd_factor}, notation));
}

Fields curve_fields(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  Fields fields{json_field("degree", degree(curve)),
                {"multiplier", "$f$", curve.multiplier()},
                preimage_field(a),
                json_field("start", json_of(curve.start())),
                {"speed", "$f|A|²$", Factored{curve.multiplier() * sigma(a)}}};
  if (!curve.is_polynomial()) fields.push_back({"weight", "$W$", curve.weight()});
  return fields;
}

std::string nearness_words(const Nearness& nearness, Notation notation) {
  const std::string frames =
      nearness.rmf_difference
          ? fmt::format("rotation-minimizing frames differ by at most {} (radians)",
                        upper_bound_words(*nearness.rmf_difference, notation))
          : "no bound of what frames differ by: the speed is not kept from 0";
  return fmt::format(
      "  distance  at most {}, of control points and so of the curves; {} before $A$ was rounded\n"
      "            to multiples of {}\n"
      "  frames    {}\n",
      upper_bound_words(nearness.distance, notation),
      upper_bound_words(nearness.unrounded_distance, notation),
      notation == Notation::latex ? fmt::format("$2^{{{}}}$", -nearness.bits)
                                  : fmt::format("2^{}", -nearness.bits),
      frames);
}

JsonOutput json_of(const IdentificationAnswer::Near& near) {
  JsonOutput json = {{"epsilon", to_string(near.epsilon)}};
  if (const auto* none = std::get_if<NotNear>(&near.found)) {
    json["found"] = false;
    json["distance"] = upper_bound_text(none->distance.value());
    return json;
  }
  const auto& [curve, nearness] = std::get<NearCurve>(near.found);
  json["found"] = true;
  json.update(phrame::json_of(nearness));
  json.update(phrame::json_of(curve_fields(curve)));
  return json;
}

std::string curve_words(const Curve& curve, Notation notation) {
  const Fields fields = curve_fields(curve);
  const bool is_latex = notation == Notation::latex;
  const std::string over = curve.is_polynomial() ? "" : is_latex ? "/W^2" : "/W²";
  return is_latex
             ? "$r' = f \\cdot A i A^*" + over + "$ with $A = u + v i + p j + q k$:\n" +
                   to_align(fields)
             : "r′ = f · A i A*" + over + " with A = u + v i + p j + q k\n\n" + to_rows(fields, 5);
}

std::string near_words(const IdentificationAnswer::Near& near, Notation notation) {
  if (const auto* none = std::get_if<NotNear>(&near.found))
    return "\n  " + to_line(*none, near.epsilon) + "\n";
  const auto& found = std::get<NearCurve>(near.found);
  return fmt::format("\nWithin {} there is the {}\n\n{}\n{}", distance_text(near.epsilon),
                     heading("", found.curve),
                     prose(nearness_words(found.nearness, notation), notation),
                     curve_words(found.curve, notation));
}

/// Why there is no curve, and what is near it.
std::string none_words(const IdentificationAnswer& answer, Notation notation) {
  std::string text = prose(
      of_speed(reason_text(std::get<NotPythagorean>(answer.result), notation), answer.is_rational),
      notation);
  if (answer.near) text += near_words(*answer.near, notation);
  if (answer.suggestion)
    text += fmt::format("\n  --near {} takes the PH curve {} from it.\n",
                        distance_text(answer.suggestion->epsilon),
                        upper_bound_text(answer.suggestion->distance));
  return text;
}

std::string nearness_of(const NamedPhPath& path, Notation notation) {
  if (!path.near) return "  Checked: all segments are as they were given, exactly.\n";
  return prose(
      "What was given is near it, but not PH over $ℚ$.\n\n" + nearness_words(*path.near, notation),
      notation);
}

}  // namespace

std::string reason_of(const IdentificationAnswer& answer) {
  return of_speed(to_string(std::get<NotPythagorean>(answer.result)), answer.is_rational);
}

std::string to_text(const IdentificationAnswer& answer) {
  const auto* curve = std::get_if<Curve>(&answer.result);
  if (curve == nullptr)
    return name_prefix(answer.name) + "not a PH curve over ℚ\n\n" +
           none_words(answer, Notation::unicode);
  return fmt::format("{}\n\n{}\n  Checked: f · A i A* is {}r′, exactly.\n",
                     heading(answer.name, *curve), curve_words(*curve, Notation::unicode),
                     curve->is_polynomial() ? "" : "W²");
}

std::string to_latex(const IdentificationAnswer& answer) {
  if (const auto* curve = std::get_if<Curve>(&answer.result))
    return curve_words(*curve, Notation::latex);
  return "Not a PH curve over $\\mathbb{Q}$:\n" + none_words(answer, Notation::latex);
}

std::string to_json(const IdentificationAnswer& answer) {
  Fields fields{json_field("phrame", "identify/1"), json_field("name", answer.name)};
  const auto append = [&](const Fields& more) {
    fields.insert(fields.end(), more.begin(), more.end());
  };
  if (const auto* curve = std::get_if<Curve>(&answer.result)) {
    append({json_field("ph", true)});
    append(curve_fields(*curve));
    append({json_field("checked", true)});  // nothing unchecked leaves identify()
    return pretty(json_of(fields));
  }
  const auto& reason = std::get<NotPythagorean>(answer.result);
  append({json_field("ph", false), json_field("reason", reason_of(answer)),
          json_field("odd_factor", json_of(reason.odd_factor)),
          json_field("radicand", reason.radicand.str())});
  if (answer.near) append({json_field("near", json_of(*answer.near))});
  if (answer.suggestion)
    append(
        {json_field("suggestion", {{"near", distance_text(answer.suggestion->epsilon)},
                                   {"distance", upper_bound_text(answer.suggestion->distance)}})});
  return pretty(json_of(fields));
}

std::string to_text(const PathIdentification& found) {
  return heading(found.path) + "\n\n" + nearness_of(found.path, Notation::unicode);
}

std::string to_latex(const PathIdentification& found) {
  std::string text = nearness_of(found.path, Notation::latex);
  for (const Curve& curve : found.path.path.segments())
    text += "\n" + curve_words(curve, Notation::latex);
  return text;
}

std::string to_json(const PathIdentification& found) {
  const auto& near = found.path.near;
  JsonOutput json = {{"phrame", "identify/1"}, {"name", found.path.name}, {"ph", !near}};
  if (near) {
    json["near"] = {{"epsilon", to_string(near->epsilon)}, {"found", true}};
    json["near"].update(json_of(*near));
  }
  json["segments"] = array_of(found.path.path.segments(),
                              [](const Curve& curve) { return json_of(curve_fields(curve)); });
  return pretty(json);
}

}  // namespace phrame
