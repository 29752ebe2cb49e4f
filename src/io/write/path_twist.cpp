#include "phrame/answer/path_twist.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/twist_frame.hpp"
#include "phrame/io/write/value_table.hpp"

namespace phrame::inline v0 {
namespace {

bool is_smooth(const PathTwistAnswer& answer) { return answer.path.frame->is_smooth; }

/// What the frame is, as prose() has it.
std::string definition(const PathTwistAnswer& answer) {
  const auto& joints = answer.path.frame->joints;
  const bool has_turns = std::ranges::any_of(
      joints, [](const FrameThrough::Joint& joint) { return joint.turns != 0; });
  const std::string through = fmt::format(
      "The frame meets {} orientations, exactly. From each to the next it turns about $e₁$ by $T$ "
      "against the\nrotation-minimizing frame{}, ",
      joints.size(), has_turns ? ", with the turns that are asked for" : "");
  if (is_smooth(answer))
    return through +
           "by a cubic spline of the length: its rate $ω$ is continuous, and no such frame\n"
           "that meets them has a lesser $∫ ω′²\\, ds$.\n\n";
  return through +
         "evenly: no frame that meets them has a lesser $∫ ω²\\, ds$,\n"
         "$ω$ being the rate per length.\n\n";
}

JsonOutput json_of(const PathTwistAnswer::Leg& leg) {
  JsonOutput json = {{"from", leg.from},
                     {"to", leg.to},
                     {"length", leg.length.value},
                     {"twist", leg.twist.value},
                     {"rate_at_start", leg.rate_at_start.value},
                     {"rate_at_end", leg.rate_at_end.value}};
  if (!leg.half_turn_within.empty()) json["half_turn_within"] = leg.half_turn_within;
  return json;
}

Fields fields(const PathTwistAnswer& answer) {
  const auto legs = [&answer] {
    return array_of(answer.legs, [](const PathTwistAnswer::Leg& leg) { return json_of(leg); });
  };
  Fields fields{json_field("phrame", "twist-through/1"),
                json_field("name", answer.path.name),
                json_field("twist_kind", is_smooth(answer) ? "smooth" : "even"),
                json_field("tangent_axis", name_of(answer.path.frame->axis)),
                {"length", "length $S$", compared_value(answer.length)},
                {"twist", "$∫ ω\\, ds$", compared_value(answer.twist)},
                {"squared_rate", "$∫ ω²\\, ds$", compared_value(answer.squared_rate)}};
  if (is_smooth(answer))
    fields.push_back({"squared_slope", "$∫ ω′²\\, ds$", compared_value(answer.squared_slope)});
  fields.push_back({"legs", "", {Value::Rows(), legs}});
  return fields;
}

/// Legs, a line each.
std::string leg_table(const PathTwistAnswer& answer) {
  const auto width = static_cast<std::size_t>(answer.digits) + 8;
  const auto cell = [&](const std::string& text) { return fmt::format("  {:<{}}", text, width); };
  const auto row = [&](const std::string& from, const std::string& to, const std::string& rest) {
    std::string line = fmt::format("  {:<6}  {:<6}{}", from, to, rest);
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
  };
  const std::string head =
      "\n" +
      row("from t", "to t",
          cell("length") + cell("T") +
              (is_smooth(answer) ? cell("ω at the start") + cell("ω at the end") : cell("ω")));
  std::string list;
  for (const auto& leg : answer.legs) {
    std::string rest =
        cell(shown(leg.length)) + cell(shown(leg.twist)) + cell(shown(leg.rate_at_start));
    if (is_smooth(answer)) rest += cell(shown(leg.rate_at_end));
    if (!leg.half_turn_within.empty()) rest += "half a turn: π and −π are as short";
    list += row(std::to_string(leg.from), std::to_string(leg.to), rest);
  }
  constexpr std::size_t most = 20;
  if (answer.legs.size() <= most) return head + list;
  return head + passage(list, fmt::format("  ⟨{} legs⟩\n", answer.legs.size()));
}

}  // namespace

std::string to_text(const PathTwistAnswer& answer) {
  std::string text = heading(answer.path) + "\n\n" + prose(definition(answer), Notation::unicode);
  text += to_rows(fields(answer), 14) + leg_table(answer);
  if (!answer.values.empty()) text += value_table(answer.values, answer.digits, answer.by);
  return text;
}

std::string to_latex(const PathTwistAnswer& answer) {
  std::string text = prose(definition(answer), Notation::latex) + to_align(fields(answer));
  if (!answer.values.empty()) text += latex_value_table(answer.values, answer.by);
  return text;
}

std::string to_json(const PathTwistAnswer& answer) {
  JsonOutput output = json_of(fields(answer));
  add_values(output, answer.values, answer.by);
  if (answer.up) output["up"] = phrame::json_of(*answer.up);
  add_nearness(output, answer.path.near);
  return pretty(output);
}

}  // namespace phrame
