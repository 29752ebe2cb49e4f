#include "phrame/io/write/spline_report.hpp"

#include <fmt/format.h>

#include "phrame/answer/totals.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/number_text.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

constexpr auto unicode = Notation::unicode;

std::optional<Decimal> rounded_holonomy(const SplineAngle& angle, long digits) {
  const auto holonomy = angle.holonomy();
  if (!holonomy) return std::nullopt;
  return rounded(*holonomy, "holonomy", digits);
}

std::string closure(const Spline& spline) {
  if (spline.closing_turn()) return "closed";
  return spline.ends_meet() ? "its ends meet, but not their tangents" : "open";
}

std::string heading(const std::string& name, const Spline& spline) {
  return fmt::format("{}PH spline of {}, {}", name_prefix(name),
                     counted(spline.segments().size(), "segment"), closure(spline));
}

JsonOutput json_of(const SplineAngleReport& report) {
  const Spline& spline = report.angle.spline();
  JsonOutput json = {{"phrame", "spline-angle/1"}, {"name", report.name}};
  if (report.shows_form) {
    json["segments"] = JsonOutput::array();
    for (std::size_t k = 0; k < spline.segments().size(); ++k) {
      const RmfAngle& angle = report.angle.segment(k);
      const Antiderivative& F = angle.antiderivative();
      json["segments"].push_back({{"degree", degree(spline.segments()[k])},
                                  {"integrand", phrame::json_of(angle.rate())},
                                  {"antiderivative", phrame::json_of(F, form_name(F))}});
    }
  }
  json["theta0"] = to_string(report.start_angle);
  json["total"] = phrame::json_of(report.total);
  json["closed"] = spline.closing_turn().has_value();
  json["holonomy"] = report.holonomy ? phrame::json_of(*report.holonomy) : JsonOutput();
  json["values"] = phrame::json_of(report.values);
  return json;
}

std::string relation(const Decimal& x) { return x.radius == "0" ? "=" : "≈"; }

}  // namespace

std::string notes_on_signs(const Spline& spline) {
  std::string text;
  for (std::size_t k = 0; k < spline.segments().size(); ++k)
    if (const std::string note = note_on_sign(spline.segments()[k]); !note.empty())
      text += fmt::format("  segment {}: {}\n", k + 1, note);
  return text.empty() ? "" : text + "\n";
}

SplineAngleReport spline_angle_report(const std::string& name, const SplineAngle& angle,
                                      const Angle& start_angle, const std::vector<Rational>& at,
                                      long digits) {
  SplineAngleReport report{name, angle, start_angle, {}, {}, {}, digits};
  for (const Rational& t : at)
    report.values.push_back(rounded_angle(t, angle.value(t, start_angle), digits));
  report.total = rounded(angle.value(angle.spline().end()), "the total angle", digits);
  report.holonomy = rounded_holonomy(angle, digits);
  return report;
}

std::string to_text(const SplineAngleReport& report) {
  const Spline& spline = report.angle.spline();
  std::string text = heading(report.name, spline) + "\n\n" + notes_on_signs(spline);
  text += fmt::format(
      "The rotation-minimizing frame is the Euler–Rodrigues frame, continuous through the joints,\n"
      "turned by θ about the tangent:\n"
      "  f₂ = cos θ e₂ + sin θ e₃,  f₃ = −sin θ e₂ + cos θ e₃,  θ(0) = {}\n\n",
      shown(report.start_angle));
  text +=
      "On each segment t runs from 0 to 1 here; along the spline, segment k is from t = k − 1 to "
      "k.\n\n";
  for (std::size_t k = 0; k < spline.segments().size(); ++k) {
    const RmfAngle& angle = report.angle.segment(k);
    const auto form = formatted_sum(formatted_terms(angle.twist(), unicode), "\n      ", unicode);
    text += fmt::format("Segment {}\n", k + 1);
    text += fmt::format("  θ′ = {}\n", formatted_quotient(angle.rate(), unicode));
    text += fmt::format("  θ  = {}{}\n", form, form == "0" ? "" : "\n      + constant");
  }
  text += "Checked: the derivative of each θ is θ′, exactly.\n\n";
  text += fmt::format("  total angle {} {}\n", relation(report.total), report.total.value);
  if (report.holonomy)
    text += fmt::format("  holonomy {} {}: the frame comes back turned by this about the tangent\n",
                        relation(*report.holonomy), report.holonomy->value);
  if (!report.values.empty()) text += value_table(report.values, report.digits);
  return text;
}

std::string to_json(const SplineAngleReport& report) { return pretty(json_of(report)); }

std::string to_json_line(const SplineAngleReport& report) { return json_of(report).dump(); }

SplineInfo spline_info(const NamedSpline& named, long digits) {
  const SplineAngle angle(named.spline);
  SplineInfo info{named, {Rational(0), {}}, {}, {}, {}, {}};
  std::optional<Real> energy = Rational(0);
  for (const Curve& curve : named.spline.segments()) {
    const Real length = total_length(curve).value;
    const std::string name = fmt::format("the length of segment {}", info.lengths.size() + 1);
    info.lengths.push_back({length, rounded(length, name, digits)});
    info.length.exact = info.length.exact + length;
    const auto part = bending_energy(curve);
    if (!energy || std::holds_alternative<Infinite>(part))
      energy.reset();
    else
      energy = *energy + std::get<Total>(part).value;
  }
  info.length.rounded = rounded(info.length.exact, "the length", digits);
  info.twist_erf = rounded(-angle.value(named.spline.end()), "the twist", digits);
  if (energy) info.bending_energy = rounded(*energy, "the bending energy", digits);
  info.holonomy = rounded_holonomy(angle, digits);
  return info;
}

std::string to_text(const SplineInfo& info) {
  const Spline& spline = info.spline.spline;
  std::string text = heading(info.spline.name, spline) + "\n\n" + notes_on_signs(spline);
  const auto row = [&](std::string_view name, const std::string& value) {
    text += phrame::row(name, value, 18);
  };
  row("length ∫ |f|σ", shown(info.length.exact, info.length.rounded));
  row("twist ∫ 2h/σ", info.twist_erf.value);
  row("energy ∫ κ² ds", info.bending_energy ? info.bending_energy->value : "∞");
  if (info.holonomy) row("holonomy", info.holonomy->value);
  text += "\n  segment  degree  length\n";
  for (std::size_t k = 0; k < spline.segments().size(); ++k)
    text += fmt::format("  {:>7}  {:>6}  {}\n", k + 1, degree(spline.segments()[k]),
                        shown(info.lengths[k].exact, info.lengths[k].rounded));
  return text;
}

std::string to_json(const SplineInfo& info) {
  const Spline& spline = info.spline.spline;
  JsonOutput segments = JsonOutput::array();
  for (std::size_t k = 0; k < spline.segments().size(); ++k) {
    const Curve& curve = spline.segments()[k];
    segments.push_back({{"degree", degree(curve)},
                        {"start", json_of(curve.start())},
                        {"end", json_of(evaluate(position(curve), 1))},
                        {"arc_length", json_of(info.lengths[k].exact, info.lengths[k].rounded)}});
  }
  JsonOutput json = {
      {"phrame", "spline-info/1"},
      {"name", info.spline.name},
      {"segments", segments},
      {"closed", spline.closing_turn().has_value()},
      {"ends_meet", spline.ends_meet()},
      {"arc_length", json_of(info.length.exact, info.length.rounded)},
      {"twist_erf", json_of(info.twist_erf)},
      {"bending_energy", info.bending_energy ? json_of(*info.bending_energy) : JsonOutput()},
      {"holonomy", info.holonomy ? json_of(*info.holonomy) : JsonOutput()}};
  if (!info.bending_energy) json["bending_energy_reason"] = "∞";
  return pretty(json);
}

}  // namespace phrame
