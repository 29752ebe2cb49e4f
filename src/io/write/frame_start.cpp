#include "phrame/io/write/frame_start.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"

namespace phrame::inline v0 {

std::string to_sentence(const LeastRotation& start, bool is_plain) {
  std::string text =
      fmt::format("the least rotation that takes the x axis to {} takes the y axis to {}(0)",
                  is_plain ? "e1" : "e₁", is_plain ? "f2" : "f₂");
  if (!(start.turn == Angle()))
    text += fmt::format(", which is then turned about {} by {}", is_plain ? "e1" : "e₁",
                        abbreviated(to_string(start.turn)));
  return text;
}

std::string start_comment(const FrameStart& start, const std::optional<Vector<Rational>>& up) {
  const auto in_brackets = [](const Vector<Rational>& v) {
    return fmt::format("[{}, {}, {}]", as_written(v[0]), as_written(v[1]), as_written(v[2]));
  };
  if (const auto* least = std::get_if<LeastRotation>(&start)) {
    std::string text = "at the start " + to_sentence(*least, true);
    return text.erase(text.find("(0)"), 3);  // comments of G-code have no parentheses
  }
  if (const auto* normal = std::get_if<StartNormal>(&start))
    return "f2 at the start is along " + in_brackets(normal->vector) +
           ", projected to the normal plane";
  return fmt::format("f2 at the start is at the angle {} to e2 of the {}",
                     abbreviated(to_string(std::get<Angle>(start))),
                     up ? "frame of v = " + in_brackets(*up) : "Euler-Rodrigues frame");
}

void add_start(JsonOutput& json, const FrameStart& start) {
  if (const auto* least = std::get_if<LeastRotation>(&start)) {
    json["start"] = "least rotation";
    json["start_turn"] = to_string(least->turn);
  } else if (const auto* normal = std::get_if<StartNormal>(&start)) {
    json["start_normal"] = json_of(normal->vector);
  }
}

}  // namespace phrame
