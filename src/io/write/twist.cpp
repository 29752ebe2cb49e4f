#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include "phrame/answer/angle.hpp"
#include "phrame/answer/minimal_twist.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/twist_frame.hpp"
#include "phrame/io/write/value_table.hpp"

namespace phrame::inline v0 {

namespace {

/// What the frame is, as prose() has it.
std::string definition(const MinimalTwistAnswer& answer, Notation notation) {
  std::string frame = "Euler–Rodrigues frame";
  if (answer.up) {
    const std::string v = in_words(*answer.up, notation);
    frame = "frame of " + (notation == Notation::latex ? "$v = " + v.substr(1) : "v = " + v);
  }
  return fmt::format(
      "The minimal twist frame is the {} turned by $θ$ about $e₁$:\n"
      "  $f₂ = \\cos θ\\, e₂ + \\sin θ\\, e₃$,  $f₃ = −\\sin θ\\, e₂ + \\cos θ\\, e₃$\n"
      "  $θ(t) = θ_i + T s(t)/S − {}$\n\n",
      frame, answer.up ? "∫₀ᵗ e₂′·e₃" : "2∫₀ᵗ h/σ");
}

JsonOutput exact_json(const MinimalTwistAnswer& answer) {
  JsonOutput json = JsonOutput::object();
  add_values(json, answer.values, answer.by);
  return json;
}

Fields fields(const MinimalTwistAnswer& answer) {
  const auto length = [&answer](Notation notation) {
    const auto exact = answer.length.exact();
    if (notation == Notation::unicode)
      return exact ? "= " + shown(*exact) : "≈ " + shown(answer.rounded_length);
    return exact ? in_words(*exact, notation) : in_words(answer.rounded_length, notation);
  };
  const Field length_field{"length", "length $S$", {Value::Words(length), [&answer] {
                                                      return json_of(answer.length,
                                                                     answer.rounded_length);
                                                    }}};
  const bool is_up = answer.up.has_value();
  return {
      json_field("phrame", "mtf/1"),
      json_field("name", answer.path.name),
      {"from", "$θ_i$, at the start", compared_value(answer.from)},
      {"to", "$θ_f$, at the end", compared_value(answer.to)},
      in_json(length_field),
      object_field(
          "twist",
          {{is_up ? "up" : "erf", is_up ? "twist of the frame of $v$" : "twist of the ERF",
            compared_value(answer.own_twist)},
           {"total",
            is_up ? "nominal twist $T_v + θ_f − θ_i$" : "nominal twist $T_\\text{ERF} + θ_f − θ_i$",
            compared_value(answer.nominal_twist)},
           {"minimal", "twist $T$", compared_value(answer.twist)}}),
      out_of_json(length_field),
      {"mean_rate", "rate $T/S$ about $e₁$", compared_value(answer.rate)},
      json_field("exact", exact_json(answer))};
}

std::string first_line(const MinimalTwistAnswer& answer) { return heading(answer.path); }

/// What there is to say of the signs of a PH path.
std::string notes(const MinimalTwistAnswer& answer, Notation notation) {
  const auto ph = answer.up ? std::nullopt : answer.path.path.ph();
  return ph ? notes_on_signs(*ph, notation) : "";
}

bool is_least(const FrameStart& end) { return std::holds_alternative<LeastRotation>(end); }

/// Where nothing else was asked for, how f₂ is found at the ends, as prose() has it.
std::string on_ends(const MinimalTwistAnswer& answer) {
  const bool at_start = is_least(answer.start);
  const bool at_end = answer.end && is_least(*answer.end);
  if (!at_start && !at_end) return "";
  return fmt::format(
      "At {} the least rotation that takes the x axis to $e₁$ takes the y axis to $f₂$.\n\n",
      at_start && at_end ? "both ends"
      : at_start         ? "the start"
                         : "the end");
}

/// What there is to say of half a turn, which is as long both ways.
std::string on_half_turn(const MinimalTwistAnswer& answer) {
  if (answer.half_turn_within.empty()) return "";
  if (answer.half_turn_within == "0")
    return "\nThe least turn is half a turn: $π$ and $−π$ are as short, and $π$ was taken.\n";
  return fmt::format(
      "\nThe least turn is half a turn, or within {} of it: both ways round are as short, and the "
      "one next to $π$ was taken.\n",
      answer.half_turn_within);
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
  std::string text =
      first_line(answer) + "\n\n" + prose(definition(answer, Notation::unicode), Notation::unicode);
  text += prose(on_ends(answer), Notation::unicode) + notes(answer, Notation::unicode);
  text += to_rows(fields(answer), 31);
  if (!answer.values.empty()) text += value_table(answer.values, answer.digits, answer.by);
  text += prose(on_half_turn(answer), Notation::unicode);
  if (answer.rational) text += to_text(*answer.rational);
  return text + prose(reason(answer), Notation::unicode);
}

std::string to_latex(const MinimalTwistAnswer& answer) {
  constexpr auto latex = Notation::latex;
  std::string text = prose(definition(answer, latex) + on_ends(answer), latex);
  text += notes(answer, latex);
  text += to_align(fields(answer));
  if (!answer.values.empty()) text += latex_value_table(answer.values, answer.by);
  text += prose(on_half_turn(answer), latex);
  if (answer.rational) text += to_latex(*answer.rational);
  return text + prose(reason(answer), latex);
}

std::string to_json(const MinimalTwistAnswer& answer) {
  JsonOutput output = json_of(fields(answer));
  if (is_least(answer.start)) output["start"] = "least rotation";
  if (answer.end && is_least(*answer.end)) output["end"] = "least rotation";
  if (!answer.half_turn_within.empty()) output["half_turn_within"] = answer.half_turn_within;
  if (answer.rational) output.update(json_of(fields(*answer.rational)));
  if (!answer.why_not_rational.empty()) output["no_rational"] = answer.why_not_rational;
  if (!answer.why_undecided.empty()) output["rational_undecided"] = answer.why_undecided;
  if (answer.up) output["up"] = json_of(*answer.up);
  add_nearness(output, answer.path.near);
  return pretty(output);
}

}  // namespace phrame
