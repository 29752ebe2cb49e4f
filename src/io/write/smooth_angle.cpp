#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/frame_start.hpp"

#include <fmt/format.h>

#include "phrame/answer/angle.hpp"
#include "phrame/answer/smooth_angle.hpp"
#include "phrame/io/write/formula.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/io/write/value_table.hpp"

namespace phrame {
namespace {

std::string no_closed_form(const Path& path) {
  return path.is_ph()
             ? "no closed form: there are those to the Euler–Rodrigues and to the Frenet frame"
             : "no closed form: the curve is not Pythagorean-hodograph";
}

bool is_up(const SmoothAngleAnswer& answer) { return answer.reference == Reference::up; }

std::string equals(const Decimal& x) { return x.radius == "0" ? "=" : "≈"; }

/// "π/4", "0.7854".
std::string start_text(const SmoothAngleAnswer& answer) {
  const auto* angle = std::get_if<Angle>(&answer.start);
  return angle != nullptr ? shown(FrameAngle(*angle)) : shown(answer.start_angle);
}

std::string frame_text(const SmoothAngleAnswer& answer) {
  std::string text =
      is_up(answer)
          ? fmt::format(
                "The rotation-minimizing frame is the frame of the up vector v = {}, e₂ = v × "
                "e₁/|v × e₁|,\ne₃ = e₁ × e₂, turned by θ about the tangent:\n",
                shown(answer.up))
          : "The rotation-minimizing frame is the Frenet frame turned by θ about the tangent:\n";
  const auto [second, third] = is_up(answer) ? std::pair{"e₂", "e₃"} : std::pair{"n", "b"};
  text += fmt::format("  f₂ = cos θ {0} + sin θ {1},  f₃ = −sin θ {0} + cos θ {1},  θ(0) = {2}\n",
                      second, third, start_text(answer));
  if (const auto* least = std::get_if<LeastRotation>(&answer.start))
    text += fmt::format("  At the start {}\n", to_sentence(*least));
  return text;
}

/// What θ is the integral of.
std::string rate_text(const SmoothAngleAnswer& answer) {
  if (answer.is_straight)
    return "  θ is constant: the curve is a straight line, where any frame that does not turn is "
           "rotation-minimizing\n";
  if (answer.is_zero) return "  θ is constant: this frame is rotation-minimizing already\n";
  return fmt::format(
      "  θ′ = {}, H along r′\n  {}\n",
      is_up(answer) ? "−(v·H) det(v, H, H′)/(|H| |v × H|²)" : "−|H| det(H, H′, H″)/|H × H′|²",
      no_closed_form(answer.path.path));
}

JsonOutput json_of(const SmoothAngleAnswer& answer) {
  const bool is_single = answer.path.path.segments().size() == 1;
  JsonOutput json = {{"phrame", is_single ? "angle/1" : "spline-angle/1"}};
  if (is_single)
    json["curve"] = {{"name", answer.path.name}};
  else
    json["name"] = answer.path.name;
  json["frame"] = is_up(answer) ? "up" : "frenet";
  if (is_up(answer)) json["up"] = phrame::json_of(answer.up);
  json["closed_form"] = nullptr;
  json["closed_form_reason"] = no_closed_form(answer.path.path);
  const auto* start = std::get_if<Angle>(&answer.start);
  json["theta0"] =
      start != nullptr ? JsonOutput(to_string(*start)) : phrame::json_of(answer.start_angle);
  add_start(json, answer.start);
  add_nearness(json, answer.path.near);
  json["total"] = phrame::json_of(answer.total);
  json["closed"] = json_if_known(closure(answer.path.path).is_closed);
  json["holonomy"] = answer.holonomy ? phrame::json_of(*answer.holonomy) : JsonOutput();
  if (!answer.no_holonomy.empty()) json["holonomy_reason"] = "undecided: " + answer.no_holonomy;
  json["values"] = phrame::json_of(answer.values);
  return json;
}

}  // namespace

std::string to_text(const SmoothAngleAnswer& answer) {
  std::string text = heading(answer.path) + "\n\n" + frame_text(answer) + "\n" + rate_text(answer);
  text += fmt::format("\n  total angle {} {}\n", equals(answer.total), shown(answer.total));
  if (answer.holonomy)
    text += fmt::format("  holonomy {} {}: the frame comes back turned by this about the tangent\n",
                        equals(*answer.holonomy), shown(*answer.holonomy));
  if (!answer.no_holonomy.empty())
    text += fmt::format("  holonomy undecided: {}\n", answer.no_holonomy);
  return answer.values.empty() ? text : text + value_table(answer.values, answer.digits);
}

std::string to_latex(const SmoothAngleAnswer& answer) {
  std::string text = "\\begin{align*}\n\\theta'(t) &= ";
  text += answer.is_zero  ? "0"
          : is_up(answer) ? "-\\frac{(v \\cdot H) \\det(v, H, H')}{|H|\\, |v \\times H|^2}"
                          : "-\\frac{|H| \\det(H, H', H'')}{|H \\times H'|^2}";
  if (is_up(answer) && !answer.is_zero) {
    text += ",\\quad v = (";
    for (std::size_t k = 0; k < 3; ++k)
      text += (k == 0 ? "" : ", ") + formatted(answer.up[k], Notation::latex);
    text += ")";
  }
  const auto* start = std::get_if<Angle>(&answer.start);
  text += fmt::format(" \\\\\n\\theta(0) &= {}\n\\end{{align*}}\n",
                      start != nullptr ? formatted(*start, Notation::latex)
                                       : latex_decimal(answer.start_angle.value));
  return answer.values.empty() ? text : text + latex_value_table(answer.values);
}

std::string to_json(const SmoothAngleAnswer& answer) { return pretty(json_of(answer)); }

std::string to_json_line(const SmoothAngleAnswer& answer) { return json_of(answer).dump(); }

}  // namespace phrame
