#include "phrame/io/twist_report.hpp"

#include <fmt/format.h>

#include "phrame/io/json_text.hpp"
#include "phrame/io/spline_report.hpp"
#include "phrame/io/text.hpp"

namespace phrame {

TwistReport twist_report(const std::string& name, const Spline& spline, const FrameAngle& from,
                         const FrameAngle& to, const MinimalTwist& mtf,
                         const std::vector<Rational>& at, long digits) {
  const auto decimal = [digits](const Real& x, const std::string& what) {
    return rounded(x, what, digits);
  };
  TwistReport report{name,
                     spline,
                     decimal(to_real(from), "the angle at the start"),
                     decimal(to_real(to), "the angle at the end"),
                     mtf.length(),
                     decimal(mtf.erf_twist(), "the twist of the Euler-Rodrigues frame"),
                     decimal(mtf.nominal_twist(), "the nominal twist"),
                     decimal(mtf.twist(), "the twist"),
                     decimal(mtf.rate(), "the rate"),
                     {},
                     digits};
  for (const Rational& t : at)
    report.values.push_back(
        {t, decimal(mtf.value(t), "theta at t = " + abbreviated(to_string(t)))});
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
  return text;
}

std::string to_json(const TwistReport& report) {
  JsonOutput values = JsonOutput::array();
  for (const AngleValue& value : report.values)
    values.push_back(
        {{"t", to_string(value.t)}, {"theta", value.theta.value}, {"radius", value.theta.radius}});
  return pretty({{"phrame", "mtf/1"},
                 {"name", report.name},
                 {"from", json_of(report.from)},
                 {"to", json_of(report.to)},
                 {"length", to_string(report.length)},
                 {"twist",
                  {{"erf", json_of(report.erf_twist)},
                   {"total", json_of(report.nominal_twist)},
                   {"minimal", json_of(report.twist)}}},
                 {"mean_rate", json_of(report.rate)},
                 {"exact", {{"values", values}}}});
}

}  // namespace phrame
