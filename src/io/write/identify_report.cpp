#include "phrame/io/write/identify_report.hpp"

#include <fmt/format.h>

#include "phrame/io/write/angle_report.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame {
namespace {

std::string reason_text(const NotPythagorean& reason) {
  if (reason.odd_factor == Polynomial{1})
    return fmt::format(
        "  |r′| is √{} times a polynomial: the curve is PH over ℝ, but has no preimage with\n"
        "  rational coefficients, whatever the multiplier\n",
        abbreviated(reason.radicand.str()));
  return fmt::format("  |r′| is no polynomial: |r′|² has these factors to an odd power:\n    {}\n",
                     readable_factors(reason.odd_factor));
}

std::string curve_text(const Curve& curve) {
  const auto plain = [](const Polynomial& p) {
    return readable(formatted(p, Notation::unicode), p);
  };
  const auto& [u, v, p, q] = curve.preimage();
  const Polynomial speed = curve.multiplier() * sigma(curve.preimage());
  return fmt::format(
      "r′ = f · A i A* with A = u + v i + p j + q k\n\n"
      "  f      {}\n  u      {}\n  v      {}\n  p      {}\n  q      {}\n  f|A|²  {}\n\n"
      "  Checked: f · A i A* is r′, exactly.\n",
      plain(curve.multiplier()), plain(u), plain(v), plain(p), plain(q), readable_factors(speed));
}

}  // namespace

std::string to_text(const IdentifyReport& report) {
  if (const auto* curve = std::get_if<Curve>(&report.result))
    return heading({report.name, *curve}) + "\n\n" + curve_text(*curve);
  return name_prefix(report.name) + "not a PH curve over ℚ\n\n" +
         reason_text(std::get<NotPythagorean>(report.result));
}

std::string to_json(const IdentifyReport& report) {
  JsonOutput json = {{"phrame", "identify/1"}, {"name", report.name}};
  if (const auto* curve = std::get_if<Curve>(&report.result)) {
    const auto& [u, v, p, q] = curve->preimage();
    json["ph"] = true;
    json["degree"] = degree(*curve);
    json["multiplier"] = json_of(curve->multiplier());
    json["preimage"] = {{"u", json_of(u)}, {"v", json_of(v)}, {"p", json_of(p)}, {"q", json_of(q)}};
    json["start"] = json_of(curve->start());
    json["speed"] = json_of(curve->multiplier() * sigma(curve->preimage()));
    json["checked"] = true;  // nothing unchecked leaves identify()
  } else {
    const auto& reason = std::get<NotPythagorean>(report.result);
    json["ph"] = false;
    json["reason"] = to_string(reason);
    json["odd_factor"] = json_of(reason.odd_factor);
    json["radicand"] = reason.radicand.str();
  }
  return pretty(json);
}

}  // namespace phrame
