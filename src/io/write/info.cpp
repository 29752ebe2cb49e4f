#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/boundary_fields.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "phrame/answer/info.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

Value length_value(const InfoAnswer::Length& length) {
  return {Value::Words([&](Notation notation) {
            const auto& [exact, rounded] = length;
            if (notation == Notation::unicode)
              return exact ? shown(Real(*exact), rounded) : shown(rounded);
            return exact ? in_words(*exact, notation) : in_words(rounded, notation);
          }),
          [&] { return length.exact ? json_of(*length.exact) : json_of(length.rounded); }};
}

/// A row and a text in JSON for each.
Value places(const std::vector<Decimal>& parameters) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (const Decimal& t : parameters)
      list.push_back(notation == Notation::unicode ? "at $t = $" + shown(t)
                                                   : "at $t \\approx " + t.value + "$");
    return list;
  };
  const auto json = [&] { return array_of(parameters, [](const Decimal& t) { return t.value; }); };
  return {Value::Rows(rows), json};
}

/// A row for each, and in JSON its interval.
Value cusps_value(const std::vector<RealRoot>& cusps) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (const RealRoot& cusp : cusps) {
      const auto exact = cusp.at.rational();
      list.push_back(formula(notation == Notation::latex && exact
                                 ? "t = " + formatted(*exact, notation)
                                 : place_text("t", cusp.at),
                             notation));
    }
    return list;
  };
  const auto interval = [](const RealRoot& cusp) -> JsonOutput {
    const auto exact = cusp.at.rational();
    const RealBall t = enclose(cusp.at, 53);
    return {to_string(exact ? *exact : t.lower()), to_string(exact ? *exact : t.upper())};
  };
  return {Value::Rows(rows), [&cusps, interval] { return array_of(cusps, interval); }};
}

/// Where there is none, these rows, and null in JSON.
Value optional_value(const std::optional<Decimal>& value,
                     const std::vector<std::string>& otherwise) {
  if (value) return *value;
  return {Value::Rows([otherwise](Notation) { return otherwise; }), [] { return JsonOutput(); }};
}

Value energy(const std::optional<Decimal>& value) { return optional_value(value, {"$∞$"}); }

Value control_points_value(const Curve& curve) {
  return {Value::Rows(), [&] { return array_of(control_points(curve)); }};
}

Value sign_value(const Curve& curve) {
  return {Value::Rows([&](Notation) {
            const std::string note = note_on_sign(curve);
            return note.empty() ? std::vector<std::string>() : std::vector{note};
          }),
          Value::Json()};
}

/// A row for each extremum and inflection of a plane curve.
Field bends_field(const std::vector<InfoAnswer::Bend>& bends) {
  using Kind = CurvaturePlace::Kind;
  const auto name = [](Kind kind) {
    return kind == Kind::inflection ? "inflection" : kind == Kind::greatest ? "greatest" : "least";
  };
  const auto rows = [&bends, name](Notation notation) {
    std::vector<std::string> list;
    for (const auto& [t, kind, curvature] : bends) {
      const std::string at = formula("t =", notation) + " " + in_words(t, notation);
      list.push_back(kind == Kind::inflection ? "0 at " + at + ", an inflection"
                                              : Value(curvature).rows(notation).front() + " at " +
                                                    at + ", " + name(kind) + " there");
    }
    return list;
  };
  const auto json = [name](const InfoAnswer::Bend& bend) -> JsonOutput {
    return {
        {"t", json_of(bend.t)}, {"kind", name(bend.kind)}, {"curvature", json_of(bend.curvature)}};
  };
  return {"curvature_places", "curvature $κ$", {Value::Rows(rows), [&bends, json] {
                                                  return array_of(bends, json);
                                                }}};
}

Field offset_field(const OffsetKind& offset) {
  const auto words = [&offset](Notation notation) {
    return in_words(offset, "$x′² + y′²$", notation);
  };
  return {"offset", "offset", {Value::Words(words), [&offset] { return json_of(offset); }}};
}

Field complex_field(const ComplexForm& form, const Polynomial& f) {
  return object_field(
      "complex", {{"multiplier", form.multiplier == f ? "" : "$f$ of $r′ = f·w²$", form.multiplier},
                  {"root", "$w$ of $r′ = f·w²$", form.root}});
}

Field tschirnhausen_field(const TschirnhausenCubic& cubic, const InfoAnswer::Length& scale) {
  const Vector<Rational> to_focus = cubic.focus - cubic.vertex;
  const Rational unit = content(Polynomial{to_focus[0], to_focus[1], to_focus[2]});
  return object_field("tschirnhausen", {{"scale", "Tschirnhausen $a$", length_value(scale)},
                                        {"vertex", "  vertex", cubic.vertex},
                                        {"t", "  there $t$", cubic.vertex_at},
                                        {"focus", "  focus", cubic.focus},
                                        {"axis", "  axis", Rational(1 / abs(unit)) * to_focus}});
}

/// Of a PH curve by itself.
Fields ph_fields(const InfoAnswer& info, const Curve& curve, const Field& length) {
  const QuaternionPolynomial& a = curve.preimage();
  const Polynomial& f = curve.multiplier();
  const AngleSplit split = closed_split(a);
  Fields fields{
      json_field("degree", degree(curve)),
      json_field("preimage_degree", preimage_degree(curve)),
      preimage_field(a),
      {"multiplier", f == Polynomial{1} ? "" : "multiplier $f$", f},
      {"sigma", "$σ = |A|²$", Factored{sigma(a)}},
      {"h", "$h$", Factored{twist_numerator(a)}},
      {"g", "$g$", bend_numerator(a)},
      {"rho", "$ρ = 4|g|²$", Factored{rho(a)}},
      {"triple_product", "$(r′ × r″)·r‴$", Factored{triple_product(curve)}},
      object_field("split", {{"a", "  split $a$", split.a}, {"b", "  split $b$", split.b}}),
      in_json(length),
      {"control_points", "", control_points_value(curve)},
      {"", "$r(0)$", curve.start()},
      {"end_point", "$r(1)$", evaluate(position(curve), 1)},
      {"cusps", "cusp, $r′ = 0$", cusps_value(info.cusps)},
      {"", "sign of $f$", sign_value(curve)},
      out_of_json(length),
      {"twist_erf", "twist $∫₀¹ 2h/σ$", info.twist},
      {"erf_inflections", "ERF turns back", places(info.erf_inflections)},
      {"erf_extrema", "extremum of $ω₁$", places(info.erf_extrema)}};
  if (info.complex) fields.push_back(complex_field(*info.complex, f));
  if (info.tschirnhausen)
    fields.push_back(tschirnhausen_field(*info.tschirnhausen, info.tschirnhausen_scale));
  if (info.bends) fields.push_back(bends_field(*info.bends));
  if (info.offset) fields.push_back(in_json(offset_field(*info.offset)));
  return fields;
}

/// "3", or "2/2" where it is X/W; "–" of a curve by formulas.
std::string degree_text(const Segment& segment) {
  const RationalCurve* curve = rational_curve(segment);
  if (curve == nullptr) return "–";
  long above = 0;
  for (const Polynomial& x : curve->numerator()) above = std::max(above, x.degree());
  const long below = curve->weight().degree();
  return below > 0 ? fmt::format("{}/{}", above, below) : std::to_string(above);
}

/// The segments with their degrees and lengths; empty of a curve by itself.
std::string segment_table(const InfoAnswer& info, Notation notation) {
  if (info.lengths.size() == 1) return "";
  const bool is_latex = notation == Notation::latex;
  std::string text = is_latex ? "\\begin{tabular}{rrl}\nsegment & degree & length \\\\\n"
                              : "\n  segment  degree  length\n";
  for (std::size_t k = 0; k < info.lengths.size(); ++k)
    text += fmt::format(fmt::runtime(is_latex ? "{} & {} & {} \\\\\n" : "  {:>7}  {:>6}  {}\n"),
                        k + 1, degree_text(info.path.path.segments()[k]),
                        length_value(info.lengths[k]).rows(notation).front());
  return text + (is_latex ? "\\end{tabular}\n" : "");
}

JsonOutput coordinates_json(const Vector<Polynomial>& v) {
  return {json_of(v[0]), json_of(v[1]), json_of(v[2])};
}

Field vector_field(const std::string& key, const std::string& name, const Vector<Polynomial>& v) {
  Fields parts;
  constexpr const char* axes[] = {"₁", "₂", "₃"};
  for (std::size_t k = 0; k < 3; ++k) parts.push_back({"", "$" + name + axes[k] + "$", v[k]});
  return {key, "", {Value::Rows(), [v] { return coordinates_json(v); }}, parts};
}

/// Of a rational curve by itself that is not PH.
Fields polynomial_fields(const InfoAnswer& info, const RationalCurve& curve) {
  const Polynomial& w = curve.weight();
  const Polynomial& p = curve.multiplier();
  Fields fields{vector_field("numerator", "X", curve.numerator()),
                {"weight", w == Polynomial{1} ? "" : "$W$", w},
                vector_field("direction", "H", curve.direction()),
                {"multiplier", p.is_constant() ? "" : "$p$", p},
                {"", "$r(0)$", point(curve, 0)},
                {"", "$r(1)$", point(curve, 1)},
                {"cusps", "cusp, $r′ = 0$", cusps_value(info.cusps)}};
  if (info.bends) fields.push_back(bends_field(*info.bends));
  if (info.offset) fields.push_back(offset_field(*info.offset));
  return fields;
}

/// What a rational PH curve has beside.
void add_preimage_fields(Fields& fields, const InfoAnswer& info, const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  fields.push_back(preimage_field(a));
  fields.push_back({"ph_multiplier", "$f$ of $W²r′$", curve.multiplier()});
  fields.push_back({"sigma", "$σ = |A|²$", Factored{sigma(a)}});
  fields.push_back({"h", "$h$", Factored{twist_numerator(a)}});
  fields.push_back({"g", "$g$", bend_numerator(a)});
  fields.push_back({"rho", "$ρ = 4|g|²$", Factored{rho(a)}});
  if (!info.tangents) return;
  const Vector<Polynomial>& lines = *info.tangents;
  fields.push_back(object_field(
      "tangents",
      {{"K", "tangent $K$", lines[0]}, {"L", "  $L$", lines[1]}, {"M", "  $M$", lines[2]}}));
}

/// Of the plane that the path is in, if it is in one.
Field plane_field(const InfoAnswer& info) {
  if (info.is_straight)
    return {"straight",
            "straight line",
            {Value::Words(
                 [](Notation) { return std::string("any frame that does not turn is right"); }),
             [] { return JsonOutput(true); }}};
  if (!info.normal) return json_field("plane_normal", nullptr);
  return {"plane_normal", "normal to its plane", *info.normal};
}

Value segments_value(const InfoAnswer& info) {
  return {Value::Rows(), [&] {
            JsonOutput segments = JsonOutput::array();
            for (std::size_t k = 0; k < info.lengths.size(); ++k) {
              JsonOutput json = JsonOutput::object();
              if (const RationalCurve* curve = rational_curve(info.path.path.segments()[k]))
                json = {{"degree", degree(*curve)},
                        {"start", json_of(point(*curve, 0))},
                        {"end", json_of(point(*curve, 1))}};
              json["arc_length"] = length_value(info.lengths[k]).json();
              segments.push_back(std::move(json));
            }
            return segments;
          }};
}

/// The first of them in rows, all of them in JSON.
Value corners_value(const std::vector<InfoAnswer::Corner>& corners) {
  constexpr std::size_t most_rows = 12;
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (const auto& [segment, angle] : corners) {
      if (list.size() == most_rows) {
        list.push_back(fmt::format("and {} more", corners.size() - most_rows));
        break;
      }
      const std::string at = formula(fmt::format("t = {}", segment), notation);
      list.push_back(at + ": " + Value(angle).rows(notation).front());
    }
    return list;
  };
  const auto json = [](const InfoAnswer::Corner& x) -> JsonOutput {
    return {{"t", std::to_string(x.segment)}, {"angle", json_of(x.angle)}};
  };
  return {Value::Rows(rows), [&corners, json] { return array_of(corners, json); }};
}

/// Of a spline, or of a curve by itself that is not PH.
Fields path_fields(const InfoAnswer& info, const Field& length) {
  const Closure closed = closure(info.path.path);
  Fields fields{{"segments", "", segments_value(info)},
                json_field("closed", json_if_known(closed.is_closed)),
                json_field("ends_meet", json_if_known(closed.ends_meet)),
                {"corners", "corner at", corners_value(info.corners)},
                length};
  if (!info.up) {
    fields.push_back({"twist_erf", "twist $∫ 2h/σ$", info.twist});
    return fields;
  }
  fields.push_back(plane_field(info));
  fields.push_back({"up", "$v$", *info.up});
  fields.push_back({"twist_up", "twist $∫ e₂′·e₃$", info.twist});
  return fields;
}

/// "0 to 5" and ["0", "5"], each as an enclosure.
Value range_value(const std::array<Decimal, 2>& range) {
  return {Value::Words([range](Notation notation) {
            return fmt::format("{} to {}", in_words(range[0], notation),
                               in_words(range[1], notation));
          }),
          [range] {
            return JsonOutput{json_of(range[0]), json_of(range[1])};
          }};
}

Fields extreme_fields(const InfoAnswer& info) {
  Fields fields;
  if (info.box)
    fields.push_back(object_field("box", {{"x", "$x$ from", range_value((*info.box)[0])},
                                          {"y", "$y$ from", range_value((*info.box)[1])},
                                          {"z", "$z$ from", range_value((*info.box)[2])}}));
  if (!info.nearest) return fields;
  const auto& [to, t, point, distance] = *info.nearest;
  fields.push_back(object_field(
      "nearest", {json_field("to", json_of(to)),
                  {"t", "nearest point at $t$", t},
                  json_field("point", {json_of(point[0]), json_of(point[1]), json_of(point[2])}),
                  {"distance", "its distance", distance}}));
  return fields;
}

Fields fields(const InfoAnswer& info) {
  const Path& path = info.path.path;
  const bool is_single = path.segments().size() == 1;
  const Curve* any_ph = is_single ? ph_curve(path.segments().front()) : nullptr;
  const Curve* ph = any_ph != nullptr && any_ph->is_polynomial() ? any_ph : nullptr;
  const Field length{"arc_length",
                     fmt::format("length $∫{}$", ph != nullptr ? "₀¹ |f|σ"
                                                 : info.up     ? " |r′|"
                                                               : " |f|σ"),
                     length_value(info.length)};
  Fields fields{json_field("phrame", is_single ? "info/1" : "spline-info/1"),
                json_field("name", info.path.name)};
  const auto add = [&](const Fields& more) {
    fields.insert(fields.end(), more.begin(), more.end());
  };
  if (ph != nullptr) {
    add(ph_fields(info, *ph, length));
  } else {
    const RationalCurve* curve = is_single ? rational_curve(path.segments().front()) : nullptr;
    if (curve != nullptr) add(polynomial_fields(info, *curve));
    if (any_ph != nullptr) add_preimage_fields(fields, info, *any_ph);
    add(path_fields(info, length));
  }
  fields.push_back({"bending_energy",
                    fmt::format("energy $∫{} κ²\\, ds$", ph != nullptr ? "₀¹" : ""),
                    energy(info.bending_energy)});
  if (ph == nullptr) fields.push_back({"holonomy", "holonomy", optional_value(info.holonomy, {})});
  add(extreme_fields(info));
  if (!info.bending_energy) fields.push_back(json_field("bending_energy_reason", "∞"));
  if (!info.no_holonomy.empty())
    fields.push_back({"holonomy_reason",
                      "holonomy",
                      {Value::Words([&](Notation) { return "undecided: " + info.no_holonomy; }),
                       [&] { return JsonOutput("undecided: " + info.no_holonomy); }}});
  return fields;
}

/// Of the segments of a PH spline.
std::string notes(const InfoAnswer& info, Notation notation) {
  const auto ph = info.path.path.ph();
  return ph && !ph->is_curve() ? notes_on_signs(*ph, notation) : "";
}

}  // namespace

std::string to_text(const InfoAnswer& info) {
  const std::size_t width = info.up ? 21 : 18;
  return heading(info.path) + "\n\n" + notes(info, Notation::unicode) +
         to_rows(fields(info), width) + segment_table(info, Notation::unicode);
}

std::string to_json(const InfoAnswer& info) {
  JsonOutput json = json_of(fields(info));
  add_nearness(json, info.path.near);
  return pretty(json);
}

std::string to_latex(const InfoAnswer& info) {
  return notes(info, Notation::latex) + to_align(fields(info)) +
         segment_table(info, Notation::latex);
}

}  // namespace phrame
