#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/decimal_between.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/axis_construction.hpp"
#include "phrame/answer/construction.hpp"
#include "phrame/io/write/boundary_fields.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame::inline v0 {
namespace {

/// "auto"; "angles" where they were given.
std::string choice_name(const QuinticChoice& choice) {
  const auto* selection = std::get_if<QuinticSelection>(&choice);
  return selection == nullptr ? "angles" : name_of(*selection);
}

/// ", auto", ", solution 1 of 4"; nothing where there is no choice.
std::string which_text(const ConstructionAnswer& answer) {
  if (answer.kind.kind == CurveKind::quintic) return ", " + choice_name(answer.choice);
  if (answer.kind.solutions == 1) return "";
  const bool are_all_there = answer.kind.kind == CurveKind::planar;
  return fmt::format(", solution {} of {}{}", answer.solution, are_all_there ? "" : "up to ",
                     answer.kind.solutions);
}

const char* name_of(DerivativeSource source) {
  switch (source) {
    case DerivativeSource::given:
      return "given";
    case DerivativeSource::tangents:
      return "tangents given, speeds of the chords";
    case DerivativeSource::poses:
      return "tangents of the poses, speeds of the chords";
    case DerivativeSource::natural_spline:
      return "natural C2 cubic spline";
    case DerivativeSource::periodic_spline:
      break;
  }
  return "periodic C2 cubic spline";
}

const char* name_of(ParameterSource source) {
  switch (source) {
    case ParameterSource::given:
      return "given";
    case ParameterSource::whole_numbers:
      return "0, 1, 2, ...";
    case ParameterSource::chord_lengths:
      break;
  }
  return "chord lengths";
}

std::string decimal(const Real& x, long digits) { return round_to_decimal(x, digits).value; }

using Energy = std::optional<RealBall>;

std::string energy_words(const Energy& energy, Notation notation) {
  if (!energy) return formula("∞", notation);
  const std::string text = decimal_between(energy->lower(), energy->upper(), 6);
  return notation == Notation::latex ? formula(latex_decimal(text), notation) : text;
}

JsonOutput energy_json(const Energy& energy) {
  return energy ? energy_words(energy, Notation::unicode) : "inf";
}

/// What is no multiple of a power of 2 in the preimages.
const char* preimage_exception(const ConstructionAnswer& answer) {
  if (answer.kind.kind == CurveKind::helical) return "";
  if (answer.points == PointRule::exact) return ", but for those between the points";
  if (!answer.data.is_closed) return "";
  return answer.kind.continuity == Continuity::c2 ? ", but for what closes the spline"
                                                  : ", but for the last two segments";
}

const char* joints_text(Continuity continuity) {
  switch (continuity) {
    case Continuity::g1:
      return "position and tangent are equal, exactly";
    case Continuity::c1:
      return "position and derivative by the parameter are equal fractions";
    case Continuity::c2:
      break;
  }
  return "position and both derivatives by the parameter are equal fractions";
}

Rational length(const ConstructionAnswer& answer) {
  Rational sum;
  for (const ConstructionAnswer::Segment& segment : answer.segments) sum += segment.length;
  return sum;
}

Energy energy(const ConstructionAnswer& answer) {
  RealBall sum;
  for (const ConstructionAnswer::Segment& segment : answer.segments) {
    if (!segment.energy) return std::nullopt;
    sum = add(sum, *segment.energy, 128);
  }
  return sum;
}

/// A row without a key.
Field words_field(const std::string& label, const std::string& words) {
  return {"", label, {Value::Words([words](Notation) { return words; }), Value::Json()}};
}

/// "within 6.9e-17, proved; asked for: 1e-15"
Field bound_field(const std::string& label, const Rational& bound, const Rational& asked) {
  const auto words = [bound, asked](Notation notation) {
    return fmt::format("{}, proved; asked for: {}",
                       bound == 0 ? "exact" : "within " + upper_bound_words(bound, notation),
                       upper_bound_words(asked, notation));
  };
  return {"", label, {Value::Words(words), Value::Json()}};
}

/// Of an open spline through points derivatives are wanted at its ends, of a closed one nowhere.
bool wants_derivatives(const ConstructionAnswer& answer) {
  return !answer.kind.is_through_points || !answer.data.is_closed;
}

Fields choice_fields(const ConstructionAnswer& answer) {
  if (answer.kind.kind == CurveKind::quintic)
    return {json_field("select", choice_name(answer.choice))};
  if (answer.kind.solutions == 1) return {};
  return {json_field("solution", answer.solution), json_field("solutions", answer.kind.solutions)};
}

/// "met exactly; tangent z, turning evenly between"
Field orientations_field(const ConstructionAnswer& answer) {
  const auto words = [&answer](Notation notation) {
    const FrameThrough& frame = *answer.path.frame;
    const Rational& off = answer.poses->off;
    return fmt::format(
        "met exactly{}; tangent: {}; between them: {}",
        off == 0 ? ""
                 : fmt::format(", as rotations within {} of those given, proved",
                               upper_bound_words(off, notation)),
        name_of(frame.axis),
        frame.is_smooth ? "a turn by a cubic spline of the length" : "the least turn, evenly");
  };
  const auto json = [&answer] {
    return JsonOutput{{"off", upper_bound_text(answer.poses->off)},
                      {"tangent_axis", name_of(answer.path.frame->axis)},
                      {"twist", answer.path.frame->is_smooth ? "smooth" : "even"}};
  };
  return {"orientations", "orientations", {Value::Words(words), Value::Json(json)}};
}

/// How near the curve is to its data.
Fields deviation_rows(const ConstructionAnswer& answer) {
  const auto& [deviation, tolerance] = std::pair(answer.deviation, answer.tolerance);
  Fields rows{answer.points == PointRule::exact
                  ? words_field("points met", "exactly, as equal fractions")
                  : bound_field("points met", deviation.points, tolerance.points)};
  if (wants_derivatives(answer))
    rows.push_back(
        bound_field(answer.kind.continuity == Continuity::g1 ? "tangents" : "derivatives",
                    deviation.derivatives, tolerance.derivatives));
  if (!answer.data.accelerations.empty())
    rows.push_back(bound_field("accelerations", deviation.accelerations, tolerance.accelerations));
  if (answer.kind.takes_lengths)
    rows.push_back(bound_field("lengths met", deviation.lengths, tolerance.lengths));
  if (answer.poses) rows.push_back(orientations_field(answer));
  return rows;
}

/// The same in JSON.
JsonOutput deviation_json(const ConstructionAnswer& answer, const Deviation& x) {
  JsonOutput json = {{"points", upper_bound_text(x.points)}};
  if (wants_derivatives(answer)) json["derivatives"] = upper_bound_text(x.derivatives);
  if (!answer.data.accelerations.empty()) json["accelerations"] = upper_bound_text(x.accelerations);
  if (answer.kind.takes_lengths) json["lengths"] = upper_bound_text(x.lengths);
  return json;
}

Value bits_value(const ConstructionAnswer& answer) {
  const auto rows = [&](Notation notation) -> std::vector<std::string> {
    if (answer.kind.continuity == Continuity::g1 || answer.kind.kind == CurveKind::rmf) return {};
    const bool is_latex = notation == Notation::latex;
    return {fmt::format(fmt::runtime(is_latex ? "coefficients are multiples of $2^{{{}}}${}"
                                              : "coefficients are multiples of 2^{}{}"),
                        -answer.bits, preimage_exception(answer))};
  };
  return {Value::Rows(rows), [&] { return answer.bits; }};
}

Value length_value(const ConstructionAnswer& answer) {
  const auto words = [&](Notation notation) {
    constexpr long digits = 12;
    const Decimal rounded = round_to_decimal(length(answer), digits);
    return notation == Notation::latex ? in_words(rounded, notation) : "≈ " + shown(rounded);
  };
  constexpr long digits_of_doubles = 17;
  return {Value::Words(words), [&] { return decimal(length(answer), digits_of_doubles); }};
}

Value energy_value(const ConstructionAnswer& answer) {
  const auto words = [&](Notation notation) {
    const Energy sum = energy(answer);
    return (sum && !sum->is_zero() ? "≈ " : "= ") + energy_words(sum, notation);
  };
  return {Value::Words(words), [&] { return energy_json(energy(answer)); }};
}

Value segments_value(const ConstructionAnswer& answer) {
  return {Value::Rows(), [&] {
            JsonOutput segments = JsonOutput::array();
            for (const auto& [angles, length, energy] : answer.segments) {
              JsonOutput json = JsonOutput::object();
              if (angles) {
                json["delta"] = to_string(angles->delta);
                json["phi"] = to_string(angles->phi);
              }
              json["length"] = decimal(length, 17);
              json["energy"] = energy_json(energy);
              segments.push_back(std::move(json));
            }
            return segments;
          }};
}

Value parameters_value(const ConstructionAnswer& answer) {
  return {Value::Rows(), [&] {
            return array_of(answer.parameters, [](const Rational& t) { return to_string(t); });
          }};
}

Fields fields(const ConstructionAnswer& answer) {
  Fields fields{json_field("phrame", "construct/1"), json_field("name", answer.path.name),
                json_field("kind", answer.kind.name),
                words_field("kind", std::string(answer.kind.name) + which_text(answer))};
  const auto append = [&](const Fields& more) {
    fields.insert(fields.end(), more.begin(), more.end());
  };
  append(choice_fields(answer));
  const std::string law(answer.kind.law);
  if (!law.empty()) append({json_field("law", law)});
  append({json_field("closed", answer.path.path.closing_turn().has_value()),
          words_field("data",
                      fmt::format("{}{}", counted(answer.data.points.size(), "point"),
                                  answer.data.is_closed ? ", the last of them the first" : "")),
          json_field("derivatives_from", name_of(answer.derivatives_from))});
  if (wants_derivatives(answer))
    append({words_field("  derivatives",
                        fmt::format("{}{}", name_of(answer.derivatives_from),
                                    answer.kind.is_through_points ? ", at the ends" : ""))});
  append({json_field("parameters_from", name_of(answer.parameters_from)),
          words_field("  parameters", name_of(answer.parameters_from)),
          {"parameters", "", parameters_value(answer)},
          json_field("tolerance", deviation_json(answer, answer.tolerance)),
          json_field("deviation", deviation_json(answer, answer.deviation))});
  append(deviation_rows(answer));
  if (!answer.path.path.is_curve())
    append({words_field("joints", joints_text(answer.kind.continuity))});
  if (!law.empty()) append({words_field("shape", law + ", checked")});
  append({{"bits", "preimage", bits_value(answer)},
          {"length", "length", length_value(answer)},
          {"energy", "energy $∫ κ²\\, ds$", energy_value(answer)},
          {"segments", "", segments_value(answer)}});
  return fields;
}

/// The segments with their angles, lengths and energies.
std::string segment_table(const ConstructionAnswer& answer) {
  const bool have_angles = answer.segments.front().angles.has_value();
  const auto angle_text = [](const Angle& angle) {
    return shown(round_to_decimal(to_real(angle), 6));
  };
  std::string head = fmt::format("\n  {:>7}", "segment");
  if (have_angles) head += fmt::format("  {:>11}  {:>11}", "Δ", "φ");
  head += fmt::format("  {:>12}  {:>12}\n", "length", "∫ κ² ds");
  std::string list;
  for (std::size_t k = 0; k < answer.segments.size(); ++k) {
    const auto& [angles, length, energy] = answer.segments[k];
    list += fmt::format("  {:>7}", k + 1);
    if (have_angles)
      list += fmt::format("  {:>11}  {:>11}", angle_text(angles->delta), angle_text(angles->phi));
    list += fmt::format("  {:>12}  {:>12}\n", decimal(length, 8),
                        energy_words(energy, Notation::unicode));
  }
  constexpr std::size_t most = 20;
  if (answer.segments.size() <= most) return head + list;
  return head + passage(list, fmt::format("  ⟨{}⟩\n", counted(answer.segments.size(), "segment")));
}

/// The same as a tabular.
std::string latex_table(const ConstructionAnswer& answer) {
  const bool have_angles = answer.segments.front().angles.has_value();
  const auto number = [](const Real& x, long digits) {
    return formula(latex_decimal(decimal(x, digits)), Notation::latex);
  };
  std::string text = fmt::format(
      "\\begin{{tabular}}{{r{}rr}}\nsegment & {}length & {} \\\\\n", have_angles ? "rr" : "",
      have_angles ? "$\\Delta$ & $\\varphi$ & " : "", prose("$∫ κ²\\, ds$", Notation::latex));
  for (std::size_t k = 0; k < answer.segments.size(); ++k) {
    const auto& [angles, length, energy] = answer.segments[k];
    text += std::to_string(k + 1) + " & ";
    if (have_angles)
      text += fmt::format("{} & {} & ", number(to_real(angles->delta), 6),
                          number(to_real(angles->phi), 6));
    text += fmt::format("{} & {} \\\\\n", number(length, 8), energy_words(energy, Notation::latex));
  }
  return text + "\\end{tabular}\n";
}

JsonOutput json_of(const MinkowskiCurve& curve) {
  const auto& [u, v, p, q] = curve.preimage;
  const auto& [x, y, r] = curve.start;
  return {
      {"basis", "power"},
      {"preimage", {{"u", json_of(u)}, {"v", json_of(v)}, {"p", json_of(p)}, {"q", json_of(q)}}},
      {"multiplier", json_of(curve.multiplier)},
      {"start", {to_string(x), to_string(y), to_string(r)}}};
}

JsonOutput segments_json(const AxisConstructionAnswer& answer) {
  return array_of(answer.axis.segments, [](const MinkowskiCurve& curve) { return json_of(curve); });
}

Value spacelike_value(const AxisConstructionAnswer& answer) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (std::size_t k = 0; k < answer.lightlike.size(); ++k)
      for (const RealAlgebraic& t : answer.lightlike[k])
        list.push_back(fmt::format("but in segment {} at {}", k + 1, at_place(t, notation)));
    if (list.empty()) list.emplace_back("everywhere");
    return list;
  };
  const auto places = [](const std::vector<RealAlgebraic>& list) {
    return array_of(list, [](const RealAlgebraic& t) { return json_of(t); });
  };
  return {Value::Rows(rows), [&answer, places] { return array_of(answer.lightlike, places); }};
}

Fields fields(const AxisConstructionAnswer& answer) {
  const auto bounds = [](const Deviation& x) -> JsonOutput {
    return {{"points", upper_bound_text(x.points)},
            {"derivatives", upper_bound_text(x.derivatives)}};
  };
  const Deviation& found = answer.deviation;
  const Deviation& asked = answer.tolerance;
  const std::size_t count = answer.axis.segments.size();
  Fields fields{json_field("phrame", "construct-axis/1"),
                json_field("name", answer.axis.name),
                json_field("kind", "minkowski"),
                words_field("kind", "minkowski"),
                words_field("data", counted(answer.data.points.size(), "point") + " x, y, r"),
                json_field("derivatives_from", name_of(answer.derivatives_from)),
                words_field("  derivatives", name_of(answer.derivatives_from)),
                json_field("parameters_from", name_of(answer.parameters_from)),
                words_field("  parameters", name_of(answer.parameters_from)),
                {"parameters",
                 "",
                 {Value::Rows(),
                  [&] {
                    return array_of(answer.data.parameters,
                                    [](const Rational& t) { return to_string(t); });
                  }}},
                json_field("tolerance", bounds(asked)),
                json_field("deviation", bounds(found)),
                bound_field("points met", found.points, asked.points),
                bound_field("derivatives", found.derivatives, asked.derivatives)};
  if (count > 1) fields.push_back(words_field("joints", joints_text(Continuity::c1)));
  fields.push_back({"lightlike", "spacelike", spacelike_value(answer)});
  fields.push_back({"segments", "", {Value::Rows(), [&] { return segments_json(answer); }}});
  return fields;
}

}  // namespace

std::string to_text(const AxisConstructionAnswer& answer) {
  const std::string& name = answer.axis.name;
  return fmt::format("{}{} with radii, Minkowski PH quintics\n\n{}",
                     name.empty() ? "" : name + ": ", counted(answer.axis.segments.size(), "curve"),
                     to_rows(fields(answer), 14));
}

std::string to_json(const AxisConstructionAnswer& answer) {
  return pretty(json_of(fields(answer)));
}

std::string to_latex(const AxisConstructionAnswer& answer) { return to_align(fields(answer)); }

std::string write_axis(const AxisConstructionAnswer& answer) {
  JsonOutput json = {{"phrame", "mph/1"}};
  if (!answer.axis.name.empty()) json["name"] = answer.axis.name;
  json["segments"] = segments_json(answer);
  return pretty(json);
}

std::string to_text(const ConstructionAnswer& answer) {
  return heading(answer.path) + "\n\n" + to_rows(fields(answer), 14) + segment_table(answer);
}

std::string to_json(const ConstructionAnswer& answer) { return pretty(json_of(fields(answer))); }

std::string to_latex(const ConstructionAnswer& answer) {
  return to_align(fields(answer)) + latex_table(answer);
}

}  // namespace phrame
