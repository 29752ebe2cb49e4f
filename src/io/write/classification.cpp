#include "phrame/io/write/classification.hpp"

#include <fmt/format.h>

#include "phrame/io/write/heading.hpp"
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

std::string witness(const ConstantAngle& helix) {
  return fmt::format("axis {}, cos²ψ = {}", shown(helix.axis), shown(helix.cosine_squared));
}

std::string witness(const Helix& helix) {
  return fmt::format("{}, {}", witness(static_cast<const ConstantAngle&>(helix)),
                     helix.is_monotone ? "monotone" : "not monotone");
}

template <class AnyHelix>
std::string helix_text(const std::optional<AnyHelix>& helix) {
  return helix ? yes_or_no(true, witness(*helix)) : yes_or_no(false);
}

std::string answer_text(const DoublePh& square) {
  if (square.constant == 0) return yes_or_no(true, "ρ = 0");
  return yes_or_no(true,
                   fmt::format("ρ = {}·ω², ω = {}", shown(square.constant), shown(square.omega)));
}

std::string answer_text(const std::variant<RationalFrame, NoRationalFrame>& frame) {
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

std::string answer_text(const ErfTurning& turning) {
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

void add_row(std::string& text, std::string_view question, const std::string& found) {
  text += row(question, found, 20);
}

std::string line_text(const std::optional<Vector<Rational>>& line) {
  return line ? yes_or_no(true, "direction " + shown(*line)) : yes_or_no(false);
}

std::string plane_text(const std::optional<Vector<Rational>>& normal) {
  return normal ? yes_or_no(true, "normal " + shown(*normal)) : yes_or_no(false);
}

std::string to_text(const Classification& c) {
  std::string text;
  const auto row = [&](std::string_view question, const std::string& found) {
    add_row(text, question, found);
  };
  row("regular", yes_or_no(c.cusps.empty(), c.cusps.empty() ? "" : "r′ = 0 at " + places(c.cusps)));
  row("inflections", c.inflections.empty() ? "none" : places(c.inflections));
  row("straight line", line_text(c.line));
  row("plane curve", plane_text(c.normal));
  row("helix", helix_text(c.helix));
  row("double PH", c.double_ph ? answer_text(*c.double_ph) : yes_or_no(false));
  row("primitive", c.content.is_constant()
                       ? yes_or_no(true)
                       : yes_or_no(false, "gcd(x′, y′, z′) = " + shown(c.content)));
  row("ERF is an RMF", yes_or_no(c.erf_is_rotation_minimizing));
  row("rational RMF", answer_text(c.rational_frame));
  row("ERF turns one way", answer_text(c.erf_turning));
  row("extrema of ω₁", c.erf_turning.extrema.empty() ? "none" : places(c.erf_turning.extrema));
  return text;
}

/// What is true of the whole of a spline, and of its segments.
std::string spline_text(const Path& path, const PathClassification& c) {
  std::string text;
  add_row(text, "regular", yes_or_no(c.is_regular));
  add_row(text, "straight line", line_text(c.line));
  add_row(text, "in one plane", plane_text(c.normal));
  add_row(text, "helix", helix_text(c.helix));
  add_row(text, "ERF is an RMF", yes_or_no(c.erf_is_rotation_minimizing));
  for (std::size_t k = 0; k < c.segments.size(); ++k)
    text += fmt::format("\nSegment {}: {}\n\n{}", k + 1, heading("", path.segments()[k]),
                        to_text(c.segments[k]));
  return text;
}

void add_direction(JsonOutput& json, const char* key, const char* witness,
                   const std::optional<Vector<Rational>>& found) {
  json[key] = {{"answer", found.has_value()}};
  if (found) json[key][witness] = phrame::json_of(*found);
}

JsonOutput helical(const std::optional<ConstantAngle>& helix) {
  JsonOutput json = {{"answer", helix.has_value()}};
  if (!helix) return json;
  json["axis"] = phrame::json_of(helix->axis);
  json["cos_squared"] = to_string(helix->cosine_squared);
  return json;
}

/// Without the format and the name.
JsonOutput json_of(const Classification& c, const Curve& curve) {
  JsonOutput json = {
      {"degree", degree(curve)},
      {"regular", {{"answer", c.cusps.empty()}, {"cusps", json_of(c.cusps)}}},
      {"inflections", {{"answer", !c.inflections.empty()}, {"points", json_of(c.inflections)}}}};
  add_direction(json, "line", "direction", c.line);
  add_direction(json, "planar", "normal", c.normal);
  json["helical"] = helical(c.helix);
  if (c.helix) {
    json["helical"]["monotone"] = c.helix->is_monotone;
    json["helical"]["map_degree"] = c.helix->map_degree;
  }
  json["double_ph"] = {{"answer", c.double_ph.has_value()}};
  if (c.double_ph) {
    json["double_ph"]["omega"] = phrame::json_of(c.double_ph->omega);
    json["double_ph"]["constant"] = to_string(c.double_ph->constant);
  }
  json["primitive"] = {{"answer", c.content.is_constant()},
                       {"content", phrame::json_of(c.content)}};
  json["erf_is_rmf"] = {{"answer", c.erf_is_rotation_minimizing}};
  json["rrmf"] = json_of(c.rational_frame);
  json["erf_monotone"] = {{"answer", c.erf_turning.is_monotone},
                          {"zeros_of_h", json_of(c.erf_turning.zeros)},
                          {"extrema", json_of(c.erf_turning.extrema)}};
  return json;
}

JsonOutput spline_json(const NamedPath& named, const PathClassification& c) {
  JsonOutput json = {{"phrame", "spline-classify/1"},
                     {"name", named.name},
                     {"regular", {{"answer", c.is_regular}}}};
  add_direction(json, "line", "direction", c.line);
  add_direction(json, "planar", "normal", c.normal);
  json["helical"] = helical(c.helix);
  json["erf_is_rmf"] = {{"answer", c.erf_is_rotation_minimizing}};
  JsonOutput segments = JsonOutput::array();
  for (std::size_t k = 0; k < c.segments.size(); ++k)
    segments.push_back(json_of(c.segments[k], named.path.segments()[k]));
  json["segments"] = segments;
  return json;
}

}  // namespace

std::string to_text(const ClassificationAnswer& answer) {
  const Path& path = answer.path.path;
  const PathClassification& c = answer.classification;
  return fmt::format(
      "{}\n\n{}\nPoints are those on [0, 1]{}. The witnesses were checked, exactly.\n",
      heading(answer.path), path.is_curve() ? to_text(c.segments.front()) : spline_text(path, c),
      path.is_curve() ? "" : " of the segment");
}

std::string to_json(const ClassificationAnswer& answer) {
  const Path& path = answer.path.path;
  const PathClassification& c = answer.classification;
  if (!path.is_curve()) return pretty(spline_json(answer.path, c));
  JsonOutput json = {{"phrame", "classify/1"}, {"name", answer.path.name}};
  json.update(json_of(c.segments.front(), path.segments().front()));
  return pretty(json);
}

}  // namespace phrame
