#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/answer/classification.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0 {
namespace {

/// "t = 1/2, 0.732050807569 (twice)".
std::string places(const std::vector<RealRoot>& roots, Notation notation) {
  std::string text;
  for (const auto& [at, order] : roots) {
    text += fmt::format("{}{}{}", text.empty() ? "$t =$ " : ", ", in_words(at, notation),
                        order == 1   ? ""
                        : order == 2 ? " (twice)"
                                     : fmt::format(" ({} times)", order));
  }
  return text;
}

JsonOutput json_of(const std::vector<RealRoot>& roots) {
  return array_of(roots, [](const RealRoot& root) -> JsonOutput {
    return {{"t", phrame::json_of(root.at)}, {"order", root.order}};
  });
}

/// All in JSON, and in words those that are told, if there are any.
Value points(const std::vector<RealRoot>& all, const std::vector<RealRoot>& told) {
  return {Value::Rows([told](Notation notation) {
            return told.empty() ? std::vector<std::string>() : std::vector{places(told, notation)};
          }),
          [all] { return json_of(all); }};
}

/// The same of all, but "none" where there are none.
Value points_or_none(const std::vector<RealRoot>& all) {
  return {Value::Words(
              [all](Notation notation) { return all.empty() ? "none" : places(all, notation); }),
          [all] { return json_of(all); }};
}

/// A part of an answer that its label says.
Field statement(const std::string& key, const std::string& label, const JsonOutput& value) {
  return {key, label, {Value::Words([](Notation) { return ""; }), [value] { return value; }}};
}

Value direction(const char* name, const std::optional<Vector<Rational>>& found) {
  return yes_or_no(found.has_value(), found ? Fields{{name, name, *found}} : Fields());
}

Fields witness(const ConstantAngle& helix) {
  return {{"axis", "axis", helix.axis}, {"cos_squared", "$\\cos²ψ =$", helix.cosine_squared}};
}

Fields witness(const Helix& helix) {
  Fields parts = witness(static_cast<const ConstantAngle&>(helix));
  parts.push_back(
      statement("monotone", helix.is_monotone ? "monotone" : "not monotone", helix.is_monotone));
  parts.push_back(json_field("map_degree", helix.map_degree));
  return parts;
}

Field field(const ControlCone& cone) {
  const auto words = [cone](Notation notation) {
    return fmt::format("$L₀$ and $L₂$ on a cone around $L₁$, $\\cos²ϑ =$ {}{}, $\\cos φ =$ {}",
                       in_words(cone.cosine_squared, notation), cone.is_obtuse ? ", $ϑ > π/2$" : "",
                       in_words(cone.azimuth_cosine, notation));
  };
  const auto json = [cone]() -> JsonOutput {
    return {{"cos_squared", phrame::json_of(cone.cosine_squared)},
            {"obtuse", cone.is_obtuse},
            {"cos_azimuth", phrame::json_of(cone.azimuth_cosine)}};
  };
  return {"control_cone", "control polygon", {Value::Words(words), json}};
}

/// ρ = constant·ω².
Fields witness(const DoublePh& square) {
  const Field omega{"omega", "$ω =$", square.omega};
  const Field constant{"constant", "", square.constant};
  if (square.constant == 0) return {statement("", "$ρ = 0$", {}), in_json(omega), constant};
  const auto multiple = [c = square.constant](Notation notation) {
    const bool is_latex = notation == Notation::latex;
    return formula((is_latex ? formatted(c, notation) : shown(c)) + "·ω²", notation);
  };
  return {{"", "$ρ =$", {Value::Words(multiple), {}}}, omega, constant};
}

Fields witness(const RationalFrame& frame) {
  const long degree = 2 * phrame::degree(frame.preimage);
  return {statement("", fmt::format("of degree {}", degree), {}),
          {"w", "the ERF turned by $2·\\arg w$, $w =$", frame.w},
          preimage_field(frame.preimage),
          json_field("degree", degree)};
}

Fields witness(const NoRationalFrame& none) {
  if (none.reason == NoRationalFrame::Reason::multiple_pole)
    return {json_field("reason", "multiple poles"),
            {"pole_factor", "$2h/σ$ has multiple poles, the zeros of", none.factor}};
  const auto in_x = [factor = none.factor](Notation notation) {
    const std::string text = formatted(factor, notation, "x");
    return formula(notation == Notation::latex ? text : readable(text, factor), notation);
  };
  return {json_field("reason", "residues not in iℤ"),
          {"residue_factor",
           "$2h/σ$ has residues that are not in $iℤ$, the roots of\n   ",
           {Value::Words(in_x), [factor = none.factor] { return phrame::json_of(factor); }}}};
}

template <class T>
Value found(const std::optional<T>& x) {
  return yes_or_no(x.has_value(), x ? witness(*x) : Fields());
}

Fields fields(const Classification& c, const Curve& curve) {
  const bool is_primitive = c.content.is_constant();
  const auto& frame = c.rational_frame;
  const Field extrema{"extrema", "extrema of $ω₁$", points_or_none(c.erf_turning.extrema)};
  const Field inflections{"points", "inflections", points_or_none(c.inflections)};
  Fields all{json_field("degree", degree(curve)),
             {"regular", "regular",
              yes_or_no(c.cusps.empty(), {{"cusps", "$r′ = 0$ at", points(c.cusps, c.cusps)}})},
             out_of_json(inflections),
             {"inflections", "", yes_or_no(!c.inflections.empty(), {inflections})},
             {"line", "straight line", direction("direction", c.line)},
             {"planar", "plane curve", direction("normal", c.normal)},
             {"helical", "helix", found(c.helix)},
             {"double_ph", "double PH", found(c.double_ph)},
             {"primitive", "primitive",
              yes_or_no(is_primitive,
                        {{"content", is_primitive ? "" : "$\\gcd(x′, y′, z′) =$", c.content}})},
             {"erf_is_rmf", "ERF is an RMF", yes_or_no(c.erf_is_rotation_minimizing)},
             {"rrmf", "rational RMF",
              yes_or_no(std::holds_alternative<RationalFrame>(frame),
                        std::visit([](const auto& x) { return witness(x); }, frame))},
             {"erf_monotone", "ERF turns one way",
              yes_or_no(c.erf_turning.is_monotone,
                        {{"zeros_of_h", "back at",
                          points(c.erf_turning.zeros, odd_inside(c.erf_turning.zeros))},
                         in_json(extrema)})},
             out_of_json(extrema)};
  if (c.control_cone)
    all.insert(std::ranges::find(all, "double_ph", &Field::key), field(*c.control_cone));
  return all;
}

/// What is true of the whole of a spline.
Fields spline_fields(const NamedPath& named, const PathClassification& c) {
  const bool is_single = named.path.segments().size() == 1;
  Fields all{json_field("phrame", is_single ? "classify/1" : "spline-classify/1"),
             json_field("name", named.name),
             {"regular", "regular", yes_or_no(c.is_regular)},
             {"line", "straight line", direction("direction", c.line)},
             {"planar", "in one plane", direction("normal", c.normal)}};
  if (!named.path.is_ph()) return all;
  all.push_back({"helical", "helix", found(c.helix)});
  all.push_back({"erf_is_rmf", "ERF is an RMF", yes_or_no(c.erf_is_rotation_minimizing)});
  return all;
}

/// The curve by itself that the path is.
const Curve* only_curve(const Path& path) {
  return path.segments().size() == 1 ? ph_curve(path.segments().front()) : nullptr;
}

std::string written(const Fields& fields, Notation notation) {
  return notation == Notation::latex ? to_align(fields) : to_rows(fields, 20);
}

std::string written(const ClassificationAnswer& answer, Notation notation) {
  const auto& [named, c] = answer;
  if (const Curve* curve = only_curve(named.path))
    return written(fields(*c.segments.front(), *curve), notation);
  std::string text = written(spline_fields(named, c), notation);
  const auto& segments = named.path.segments();
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (const Curve* curve = ph_curve(segments[k]))
      text += fmt::format("\nSegment {}: {}\n\n{}", k + 1, heading("", *curve),
                          written(fields(*c.segments[k], *curve), notation));
    else if (segments.size() > 1)
      text +=
          fmt::format("\nSegment {}: {}, not Pythagorean-hodograph\n", k + 1, kind_of(segments[k]));
  return text;
}

}  // namespace

std::string to_text(const ClassificationAnswer& answer) {
  const Path& path = answer.path.path;
  std::string text =
      fmt::format("{}\n\n{}", heading(answer.path), written(answer, Notation::unicode));
  const auto& segments = path.segments();
  if (std::none_of(segments.begin(), segments.end(), ph_curve))
    return text + "\nWhat else is decided is of Pythagorean-hodograph curves.\n";
  return text +
         fmt::format("\nPoints are those on [0, 1]{}. The witnesses were checked, exactly.\n",
                     segments.size() == 1 ? "" : " of the segment");
}

std::string to_latex(const ClassificationAnswer& answer) {
  return written(answer, Notation::latex);
}

std::string to_json(const ClassificationAnswer& answer) {
  const auto& [named, c] = answer;
  JsonOutput json;
  if (const Curve* curve = only_curve(named.path)) {
    json = {{"phrame", "classify/1"}, {"name", named.name}};
    json.update(json_of(fields(*c.segments.front(), *curve)));
  } else {
    json = json_of(spline_fields(named, c));
    const auto& segments = named.path.segments();
    if (segments.size() == 1) json["ph"] = false;
    for (std::size_t k = 0; segments.size() > 1 && k < segments.size(); ++k)
      if (const Curve* of_ph = ph_curve(segments[k]))
        json["segments"].push_back(json_of(fields(*c.segments[k], *of_ph)));
      else
        json["segments"].push_back({{"ph", false}});
  }
  add_nearness(json, named.near);
  return pretty(json);
}

}  // namespace phrame
