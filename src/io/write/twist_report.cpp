#include "phrame/io/write/twist_report.hpp"

#include <fmt/format.h>

#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/spline_report.hpp"
#include "phrame/io/write/text.hpp"

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

JsonOutput json_of(const TwistPieceReport& piece, const std::string& suffix) {
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

void add_rational(JsonOutput& output, const TwistFrameReport& report) {
  const std::string suffix = report.is_relative ? "_relative" : "_times_length";
  JsonOutput pieces = JsonOutput::array();
  for (const TwistPieceReport& piece : report.pieces) pieces.push_back(json_of(piece, suffix));
  output["rational"] = pieces;
  output["rms" + suffix] = json_of(report.root_mean_square);
  output["monotone"] = json_of(report.monotone);
}

}  // namespace

TwistReport twist_report(const std::string& name, const FrameAngle& from, const FrameAngle& to,
                         const MinimalTwist& mtf, const std::vector<Rational>& at, long digits) {
  const auto decimal = [digits](const Real& x, const std::string& what) {
    return rounded(x, what, digits);
  };
  TwistReport report{name,
                     mtf.spline(),
                     decimal(to_real(from), "the angle at the start"),
                     decimal(to_real(to), "the angle at the end"),
                     mtf.length(),
                     decimal(mtf.erf_twist(), "the twist of the Euler-Rodrigues frame"),
                     decimal(mtf.nominal_twist(), "the nominal twist"),
                     decimal(mtf.twist(), "the twist"),
                     decimal(mtf.rate(), "the rate"),
                     {},
                     digits};
  for (const Rational& t : at) report.values.push_back(rounded_angle(t, mtf.value(t), digits));
  return report;
}

std::string to_text(const TwistReport& report) {
  const std::size_t count = report.spline.segments().size();
  std::string text =
      count == 1 ? heading({report.name, report.spline.segments().front()})
                 : fmt::format("{}PH spline of {} segments", name_prefix(report.name), count);
  text +=
      "\n\nThe minimal twist frame is the Euler–Rodrigues frame turned by θ about e₁:\n"
      "  f₂ = cos θ e₂ + sin θ e₃,  f₃ = −sin θ e₂ + cos θ e₃\n"
      "  θ(t) = θ_i + T s(t)/S − 2∫₀ᵗ h/σ\n\n";
  text += notes_on_signs(report.spline);
  const auto line = [&](std::string_view label, const Decimal& x) {
    text += row(label, (x.radius == "0" ? "= " : "≈ ") + x.value, 31);
  };
  line("θ_i, at the start", report.from);
  line("θ_f, at the end", report.to);
  line("twist of the ERF", report.erf_twist);
  line("nominal twist T_ERF + θ_f − θ_i", report.nominal_twist);
  line("twist T", report.twist);
  text += row("length S", "= " + shown(report.length), 31);
  line("rate T/S about e₁", report.rate);
  if (!report.values.empty()) text += value_table(report.values, report.digits);
  if (report.rational) text += to_text(*report.rational);
  if (!report.why_not_rational.empty())
    text += "\nNo rational frame: " + report.why_not_rational + "\n";
  if (!report.why_undecided.empty())
    text += "\nThe rational frame is undecided: " + report.why_undecided + "\n";
  return text;
}

std::string to_json(const TwistReport& report) {
  JsonOutput output{{"phrame", "mtf/1"},
                    {"name", report.name},
                    {"from", json_of(report.from)},
                    {"to", json_of(report.to)},
                    {"length", to_string(report.length)},
                    {"twist",
                     {{"erf", json_of(report.erf_twist)},
                      {"total", json_of(report.nominal_twist)},
                      {"minimal", json_of(report.twist)}}},
                    {"mean_rate", json_of(report.rate)},
                    {"exact", {{"values", json_of(report.values)}}}};
  if (report.rational) add_rational(output, *report.rational);
  if (!report.why_not_rational.empty()) output["no_rational"] = report.why_not_rational;
  if (!report.why_undecided.empty()) output["rational_undecided"] = report.why_undecided;
  return pretty(output);
}

}  // namespace phrame
