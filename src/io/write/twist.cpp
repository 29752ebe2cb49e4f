#include "phrame/io/write/twist.hpp"

#include "phrame/io/write/angle.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/twist_frame.hpp"

namespace phrame {

namespace {

constexpr auto definition =
    "The minimal twist frame is the Euler–Rodrigues frame turned by $θ$ about $e₁$:\n"
    "  $f₂ = \\cos θ\\, e₂ + \\sin θ\\, e₃$,  $f₃ = −\\sin θ\\, e₂ + \\cos θ\\, e₃$\n"
    "  $θ(t) = θ_i + T s(t)/S − 2∫₀ᵗ h/σ$\n\n";

Fields fields(const MinimalTwistAnswer& answer) {
  const auto length = [S = answer.length](Notation notation) {
    return notation == Notation::unicode ? "= " + shown(S) : in_words(S, notation);
  };
  const Field length_field{
      "length", "length $S$", {Value::Words(length), [S = answer.length] { return json_of(S); }}};
  return {json_field("phrame", "mtf/1"),
          json_field("name", answer.path.name),
          {"from", "$θ_i$, at the start", compared_value(answer.from)},
          {"to", "$θ_f$, at the end", compared_value(answer.to)},
          in_json(length_field),
          object_field("twist", {{"erf", "twist of the ERF", compared_value(answer.erf_twist)},
                                 {"total", "nominal twist $T_\\text{ERF} + θ_f − θ_i$",
                                  compared_value(answer.nominal_twist)},
                                 {"minimal", "twist $T$", compared_value(answer.twist)}}),
          out_of_json(length_field),
          {"mean_rate", "rate $T/S$ about $e₁$", compared_value(answer.rate)},
          json_field("exact", {{"values", json_of(answer.values)}})};
}

/// Why there is no rational frame, as prose() has it: a sentence, or nothing.
std::string reason(const MinimalTwistAnswer& answer) {
  if (!answer.why_not_rational.empty())
    return "\nNo rational frame: " + answer.why_not_rational + "\n";
  if (!answer.why_undecided.empty())
    return "\nThe rational frame is undecided: " + answer.why_undecided + "\n";
  return "";
}

}  // namespace

std::string to_text(const MinimalTwistAnswer& answer) {
  std::string text = heading(answer.path) + "\n\n" + prose(definition, Notation::unicode);
  text += notes_on_signs(answer.path.path) + to_rows(fields(answer), 31);
  if (!answer.values.empty()) text += value_table(answer.values, answer.digits);
  if (answer.rational) text += to_text(*answer.rational);
  return text + prose(reason(answer), Notation::unicode);
}

std::string to_latex(const MinimalTwistAnswer& answer) {
  constexpr auto latex = Notation::latex;
  std::string text = prose(definition, latex) + notes_on_signs(answer.path.path, latex);
  text += to_align(fields(answer));
  if (!answer.values.empty()) text += latex_value_table(answer.values);
  if (answer.rational) text += to_latex(*answer.rational);
  return text + prose(reason(answer), latex);
}

std::string to_json(const MinimalTwistAnswer& answer) {
  JsonOutput output = json_of(fields(answer));
  if (answer.rational) output.update(json_of(fields(*answer.rational)));
  if (!answer.why_not_rational.empty()) output["no_rational"] = answer.why_not_rational;
  if (!answer.why_undecided.empty()) output["rational_undecided"] = answer.why_undecided;
  add_nearness(output, answer.path.near);
  return pretty(output);
}

}  // namespace phrame
