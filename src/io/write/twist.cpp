#include "phrame/io/write/twist.hpp"

#include <fmt/format.h>

#include "phrame/io/write/angle.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/io/write/twist_frame.hpp"

namespace phrame {

namespace {

JsonOutput json_of(const ErrorSize& x) {
  if (x.is_bound) return {{"at_most", x.value.value}};
  return phrame::json_of(x.value);
}

JsonOutput json_of(Monotone monotone) {
  if (monotone == Monotone::undecided) return "undecided";
  return monotone == Monotone::yes;
}

JsonOutput json_of(const TwistPieceAnswer& piece, const std::string& suffix) {
  JsonOutput w = JsonOutput::array();
  for (const auto& [re, im] : piece.coefficients)
    w.push_back({{"re", phrame::json_of(re)}, {"im", phrame::json_of(im)}});
  JsonOutput inflections = JsonOutput::array();
  for (const Decimal& t : piece.inflections) inflections.push_back(t.value);
  JsonOutput output{{"from", to_string(piece.from)},
                    {"to", to_string(piece.to)},
                    {"degree", piece.frame_degree},
                    {"rotation_degree", piece.rotation_degree},
                    {"gamma", phrame::json_of(piece.gamma)},
                    {"w", w},
                    {"rms" + suffix, json_of(piece.root_mean_square)},
                    {"greatest" + suffix, json_of(piece.greatest)},
                    {"monotone", json_of(piece.monotone)},
                    {"inflections", inflections},
                    {"extra_turns", piece.extra_turns.str()}};
  if (piece.proved)
    output["optimum"] = {{"proved", true},
                         {"radius", piece.proved->radius},
                         {"gamma_radius", piece.proved->gamma},
                         {"of_one_sign", piece.proved->is_of_one_sign}};
  else
    output["optimum"] = {{"proved", false}, {"reason", piece.doubt}};
  if (piece.other)
    output["other_branch"] = {{"gamma", phrame::json_of(piece.other->first)},
                              {"rms" + suffix, json_of(piece.other->second)}};
  return output;
}

void add_rational(JsonOutput& output, const TwistFrameAnswer& answer) {
  const std::string suffix = answer.is_relative ? "_relative" : "_times_length";
  JsonOutput pieces = JsonOutput::array();
  for (const TwistPieceAnswer& piece : answer.pieces) pieces.push_back(json_of(piece, suffix));
  output["rational"] = pieces;
  output["rms" + suffix] = json_of(answer.root_mean_square);
  output["monotone"] = json_of(answer.monotone);
}

}  // namespace

std::string to_text(const MinimalTwistAnswer& answer) {
  std::string text = heading(answer.path);
  text +=
      "\n\nThe minimal twist frame is the Euler–Rodrigues frame turned by θ about e₁:\n"
      "  f₂ = cos θ e₂ + sin θ e₃,  f₃ = −sin θ e₂ + cos θ e₃\n"
      "  θ(t) = θ_i + T s(t)/S − 2∫₀ᵗ h/σ\n\n";
  text += notes_on_signs(answer.path.path);
  const auto line = [&](std::string_view label, const Decimal& x) {
    text += row(label, (x.radius == "0" ? "= " : "≈ ") + x.value, 31);
  };
  line("θ_i, at the start", answer.from);
  line("θ_f, at the end", answer.to);
  line("twist of the ERF", answer.erf_twist);
  line("nominal twist T_ERF + θ_f − θ_i", answer.nominal_twist);
  line("twist T", answer.twist);
  text += row("length S", "= " + shown(answer.length), 31);
  line("rate T/S about e₁", answer.rate);
  if (!answer.values.empty()) text += value_table(answer.values, answer.digits);
  if (answer.rational) text += to_text(*answer.rational);
  if (!answer.why_not_rational.empty())
    text += "\nNo rational frame: " + answer.why_not_rational + "\n";
  if (!answer.why_undecided.empty())
    text += "\nThe rational frame is undecided: " + answer.why_undecided + "\n";
  return text;
}

std::string to_json(const MinimalTwistAnswer& answer) {
  JsonOutput output{{"phrame", "mtf/1"},
                    {"name", answer.path.name},
                    {"from", json_of(answer.from)},
                    {"to", json_of(answer.to)},
                    {"length", to_string(answer.length)},
                    {"twist",
                     {{"erf", json_of(answer.erf_twist)},
                      {"total", json_of(answer.nominal_twist)},
                      {"minimal", json_of(answer.twist)}}},
                    {"mean_rate", json_of(answer.rate)},
                    {"exact", {{"values", json_of(answer.values)}}}};
  if (answer.rational) add_rational(output, *answer.rational);
  if (!answer.why_not_rational.empty()) output["no_rational"] = answer.why_not_rational;
  if (!answer.why_undecided.empty()) output["rational_undecided"] = answer.why_undecided;
  return pretty(output);
}

}  // namespace phrame
