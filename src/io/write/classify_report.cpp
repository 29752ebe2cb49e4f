#include "phrame/io/write/classify_report.hpp"

#include <fmt/format.h>

#include "phrame/io/write/angle_report.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

/// "t = 1/2, 0.732050807569 (twice)".
std::string places(const std::vector<RealRoot>& roots) {
  std::string text;
  for (const auto& [at, order] : roots) {
    text += fmt::format("{}{}{}", text.empty() ? "t = " : ", ", shown(at),
                        order == 1   ? ""
                        : order == 2 ? " (twice)"
                                     : fmt::format(" ({} times)", order));
  }
  return text;
}

std::string yes_or_no(bool answer, const std::string& because = "") {
  return (answer ? "yes" : "no") + (because.empty() ? "" : ": " + because);
}

std::string answer(const Helix& helix) {
  return yes_or_no(
      true, fmt::format("axis {}, cos²ψ = {}, {}", shown(helix.axis), shown(helix.cosine_squared),
                        helix.is_monotone ? "monotone" : "not monotone"));
}

std::string answer(const DoublePh& square) {
  if (square.constant == 0) return yes_or_no(true, "ρ = 0");
  return yes_or_no(true,
                   fmt::format("ρ = {}·ω², ω = {}", shown(square.constant), shown(square.omega)));
}

std::string answer(const std::variant<RationalFrame, NoRationalFrame>& frame) {
  if (const auto* found = std::get_if<RationalFrame>(&frame))
    return yes_or_no(true, fmt::format("of degree {}, the ERF turned by 2·arg w, w = {}",
                                       2 * degree(found->preimage), readable(found->w)));
  const auto& none = std::get<NoRationalFrame>(frame);
  if (none.reason == NoRationalFrame::Reason::multiple_pole)
    return yes_or_no(false,
                     fmt::format("2h/σ has multiple poles, the zeros of {}", shown(none.factor)));
  return yes_or_no(
      false, fmt::format("2h/σ has residues that are not in iℤ, the roots of\n    {}",
                         readable(formatted(none.factor, Notation::unicode, "x"), none.factor)));
}

std::string answer(const ErfTurning& turning) {
  if (turning.is_monotone) return yes_or_no(true);
  return yes_or_no(false, "back at " + places(odd_inside(turning.zeros)));
}

JsonOutput json_of(const std::vector<RealRoot>& roots) {
  JsonOutput list = JsonOutput::array();
  for (const auto& [at, order] : roots)
    list.push_back({{"t", phrame::json_of(at)}, {"order", order}});
  return list;
}

JsonOutput json_of(const std::variant<RationalFrame, NoRationalFrame>& frame) {
  if (const auto* found = std::get_if<RationalFrame>(&frame)) {
    const QuaternionPolynomial& b = found->preimage;
    return {{"answer", true},
            {"w", phrame::json_of(found->w)},
            {"preimage",
             {{"u", phrame::json_of(b.u)},
              {"v", phrame::json_of(b.v)},
              {"p", phrame::json_of(b.p)},
              {"q", phrame::json_of(b.q)}}},
            {"degree", 2 * degree(b)}};
  }
  const auto& none = std::get<NoRationalFrame>(frame);
  const bool is_residue = none.reason == NoRationalFrame::Reason::residue;
  return {{"answer", false},
          {"reason", is_residue ? "residues not in iℤ" : "multiple poles"},
          {is_residue ? "residue_factor" : "pole_factor", phrame::json_of(none.factor)}};
}

}  // namespace

ClassifyReport classify_report(const NamedCurve& curve) { return {curve, classify(curve.curve)}; }

std::string to_text(const ClassifyReport& report) {
  const Classification& c = report.classification;
  std::string text = heading(report.curve) + "\n\n";
  const auto row = [&](std::string_view question, const std::string& answer) {
    text += phrame::row(question, answer, 20);
  };
  row("regular", yes_or_no(c.cusps.empty(), c.cusps.empty() ? "" : "r′ = 0 at " + places(c.cusps)));
  row("inflections", c.inflections.empty() ? "none" : places(c.inflections));
  row("straight line", c.line ? yes_or_no(true, "direction " + shown(*c.line)) : yes_or_no(false));
  row("plane curve", c.normal ? yes_or_no(true, "normal " + shown(*c.normal)) : yes_or_no(false));
  row("helix", c.helix ? answer(*c.helix) : yes_or_no(false));
  row("double PH", c.double_ph ? answer(*c.double_ph) : yes_or_no(false));
  row("primitive", c.content.is_constant()
                       ? yes_or_no(true)
                       : yes_or_no(false, "gcd(x′, y′, z′) = " + shown(c.content)));
  row("ERF is an RMF", yes_or_no(c.erf_is_rotation_minimizing));
  row("rational RMF", answer(c.rational_frame));
  row("ERF turns one way", answer(c.erf_turning));
  row("extrema of ω₁", c.erf_turning.extrema.empty() ? "none" : places(c.erf_turning.extrema));
  return text + "\nPoints are those on [0, 1]. The witnesses were checked, exactly.\n";
}

std::string to_json(const ClassifyReport& report) {
  const Classification& c = report.classification;
  JsonOutput json = {
      {"phrame", "classify/1"},
      {"name", report.curve.name},
      {"degree", degree(report.curve.curve)},
      {"regular", {{"answer", c.cusps.empty()}, {"cusps", json_of(c.cusps)}}},
      {"inflections", {{"answer", !c.inflections.empty()}, {"points", json_of(c.inflections)}}},
      {"line", {{"answer", c.line.has_value()}}},
      {"planar", {{"answer", c.normal.has_value()}}},
      {"helical", {{"answer", c.helix.has_value()}}},
      {"double_ph", {{"answer", c.double_ph.has_value()}}},
      {"primitive", {{"answer", c.content.is_constant()}, {"content", json_of(c.content)}}},
      {"erf_is_rmf", {{"answer", c.erf_is_rotation_minimizing}}},
      {"rrmf", json_of(c.rational_frame)},
      {"erf_monotone",
       {{"answer", c.erf_turning.is_monotone},
        {"zeros_of_h", json_of(c.erf_turning.zeros)},
        {"extrema", json_of(c.erf_turning.extrema)}}}};
  if (c.line) json["line"]["direction"] = phrame::json_of(*c.line);
  if (c.normal) json["planar"]["normal"] = phrame::json_of(*c.normal);
  if (c.helix) {
    json["helical"]["axis"] = phrame::json_of(c.helix->axis);
    json["helical"]["cos_squared"] = to_string(c.helix->cosine_squared);
    json["helical"]["monotone"] = c.helix->is_monotone;
    json["helical"]["map_degree"] = c.helix->map_degree;
  }
  if (c.double_ph) {
    json["double_ph"]["omega"] = phrame::json_of(c.double_ph->omega);
    json["double_ph"]["constant"] = to_string(c.double_ph->constant);
  }
  return pretty(json);
}

}  // namespace phrame
