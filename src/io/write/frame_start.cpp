#include "phrame/io/write/frame_start.hpp"

#include <fmt/format.h>

namespace phrame {

std::string to_sentence(const LeastRotation& start, bool is_plain) {
  std::string text =
      fmt::format("the least rotation that takes the x axis to {} takes the y axis to {}(0)",
                  is_plain ? "e1" : "e₁", is_plain ? "f2" : "f₂");
  if (!(start.turn == Angle()))
    text += fmt::format(", which is then turned about {} by {}", is_plain ? "e1" : "e₁",
                        abbreviated(to_string(start.turn)));
  return text;
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
