#include "phrame/io/write/json_text.hpp"

#include <algorithm>
#include <map>

#include "phrame/algebra/error.hpp"
#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/json_object.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/nearness.hpp"
#include "phrame/io/write/radical_text.hpp"

namespace phrame::inline v0 {
namespace {

bool fits_a_line(const JsonOutput& json) {
  if (json.is_object()) return false;
  return !json.is_array() || std::all_of(json.begin(), json.end(), fits_a_line);
}

/// Nothing to escape.
bool is_plain(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

/// As nlohmann's own dump, which takes long over the digits of long numbers.
void append_string(std::string& text, const std::string& string) {
  if (is_plain(string)) {
    text += '"';
    text += string;
    text += '"';
  } else {
    text += JsonOutput(string).dump();
  }
}

void append_line(std::string& text, const JsonOutput& json) {
  if (const auto* string = json.get_ptr<const std::string*>()) {
    append_string(text, *string);
  } else if (json.is_array()) {
    text += '[';
    for (auto at = json.begin(); at != json.end(); ++at) {
      if (at != json.begin()) text += ',';
      append_line(text, *at);
    }
    text += ']';
  } else {
    text += json.dump();
  }
}

/// nlohmann's own dump puts either everything on one line or every number on a line of its own.
void append(std::string& text, const JsonOutput& json, std::size_t depth) {
  const bool object = json.is_object();
  if (!json.is_structured() || json.empty() || (!object && fits_a_line(json))) {
    append_line(text, json);
    return;
  }
  const std::string indent(2 * depth + 2, ' ');
  text += object ? "{\n" : "[\n";
  std::size_t left = json.size();
  for (const auto& [key, value] : json.items()) {
    text += indent;
    if (object) {
      append_string(text, key);
      text += ": ";
    }
    append(text, value, depth + 1);
    text += --left > 0 ? ",\n" : "\n";
  }
  text += std::string(2 * depth, ' ') + (object ? "}" : "]");
}

}  // namespace

std::string pretty(const JsonOutput& json) {
  std::string text;
  append(text, json, 0);
  return text + "\n";
}

JsonOutput json_of(const Polynomial& p) {
  JsonOutput list = JsonOutput::array();
  std::map<Integer, std::string> denominators;  // few, and long where p is
  for (const Rational& c : p.coefficients()) {
    std::string text = numerator(c).str();
    if (const Integer d = denominator(c); d != 1) {
      std::string& below = denominators[d];
      if (below.empty()) below = "/" + d.str();
      text += below;
    }
    list.push_back(std::move(text));
  }
  return list;
}

JsonOutput json_of(const GaussianPolynomial& p) {
  return {{"re", json_of(p.re)}, {"im", json_of(p.im)}};
}

JsonOutput json_of(const RationalFunction& f) {
  JsonOutput json = object_with_room(2);
  json["numerator"] = json_of(f.numerator());
  json["denominator"] = json_of(f.denominator());
  return json;
}

namespace {

template <class C, class Write>
JsonOutput json_of_sum(const SurdSum<C>& x, Write write) {
  JsonOutput roots = JsonOutput::array();
  for (const auto& [d, c] : x.terms())
    if (d != 1) roots.push_back({{"b", write(c)}, {"d", d.str()}});
  if (roots.size() > 1) return {{"a", write(x.rational_part())}, {"roots", roots}};
  if (roots.empty()) roots.push_back({{"b", write(C{})}, {"d", "1"}});
  return {{"a", write(x.rational_part())}, {"b", roots.front()["b"]}, {"d", roots.front()["d"]}};
}

}  // namespace

JsonOutput json_of(const Surd& x) {
  return json_of_sum(x, [](const Rational& c) { return to_string(c); });
}

JsonOutput json_of(const SurdPolynomial& p) {
  return json_of_sum(p, [](const Polynomial& c) { return json_of(c); });
}

JsonOutput json_of(const LogSum& sum) {
  JsonOutput json = object_with_room(3);
  json["index"] = json_of(sum.index);
  json["residue"] = json_of(sum.residue);
  json["argument"] = array_of(sum.argument.coefficients());
  return json;
}

JsonOutput json_of(const Antiderivative& F) {
  JsonOutput json = object_with_room(5);
  json["polynomial"] = json_of(F.polynomial);
  json["rational"] = json_of(F.rational);
  json["logs"] = array_of(F.logs);
  json["form"] = form_name(F);
  json["checked"] = true;  // nothing unchecked leaves integrate()
  return json;
}

JsonOutput json_of(const RealForm& F) {
  const auto logarithm = [](const auto& x) -> JsonOutput {
    return {{"factor", json_of(x.factor)}, {"of", json_of(x.of)}, {"positive", x.positive}};
  };
  JsonOutput arctangents = JsonOutput::array();
  for (const auto& [factor, of, radicand] : F.arctangents) {
    arctangents.push_back({{"factor", json_of(factor)}, {"of", json_of(of)}});
    if (!(radicand == Surd(1))) arctangents.back()["radicand"] = json_of(radicand);
  }
  const auto quotient = [](const auto& x) -> JsonOutput {
    return {
        {"factor", json_of(x.factor)}, {"of", json_of(x.of)}, {"radicand", json_of(x.radicand)}};
  };
  return {{"polynomial", json_of(F.polynomial)},
          {"rational", json_of(F.rational)},
          {"logarithms", array_of(F.logarithms, logarithm)},
          {"arctangents", arctangents},
          {"log_quotients", array_of(F.quotients, quotient)},
          {"others", array_of(F.others)},
          {"checked", true}};  // nothing unchecked leaves real_form()
}

void add_other_form(JsonOutput& json, const OtherForm& form) {
  if (const auto* real = std::get_if<RealForm>(&form)) json["real"] = json_of(*real);
  if (const auto* radicals = std::get_if<RadicalForm>(&form)) json["radicals"] = json_of(*radicals);
}

JsonOutput json_of(const PathEnd& end) {
  if (const auto* r = std::get_if<Rational>(&end)) return to_string(*r);
  if (const auto* infinite = std::get_if<Infinity>(&end))
    return *infinite == Infinity::negative ? "-inf" : "inf";
  if (const auto* p = std::get_if<PiValue>(&end))
    return {{"expression", cas_formula(p->of_pi, Language::plain, "pi")},
            {"value", round_to_decimal(to_real(*p), 17).value}};
  const auto& a = std::get<RealAlgebraic>(end);
  const Interval& interval = a.interval();
  return {{"polynomial", json_of(a.polynomial())},
          {"interval", {to_string(*interval.lower), to_string(*interval.upper)}},
          {"value", round_to_decimal(to_real(a), 17).value}};
}

JsonOutput json_if_known(const std::optional<bool>& x) { return x ? JsonOutput(*x) : JsonOutput(); }

JsonOutput json_of_bounds(const RealBall& x) {
  return {{"lower", lower_bound_text(std::max(Rational(0), x.lower()), 6)},
          {"upper", upper_bound_text(x.upper(), 6)}};
}

JsonOutput json_of(const Decimal& x) { return {{"value", x.value}, {"radius", x.radius}}; }

void add_values(JsonOutput& json, const std::vector<AngleValue>& values, ParameterKind by) {
  const auto json_of_number = [](const std::variant<Rational, Decimal>& x) {
    if (const auto* exact = std::get_if<Rational>(&x)) return JsonOutput(to_string(*exact));
    return json_of(std::get<Decimal>(x));
  };
  JsonOutput list = JsonOutput::array();
  for (const AngleValue& value : values) {
    JsonOutput row = object_with_room(4);
    if (value.asked) row[column_of(by)] = json_of_number(*value.asked);
    row["t"] = json_of_number(value.t);
    row["theta"] = value.theta.value;
    row["radius"] = value.theta.radius;
    list.push_back(std::move(row));
  }
  if (by != ParameterKind::t) json["by"] = name_of(by);
  json["values"] = std::move(list);
}

JsonOutput json_of(const Real& x, const Decimal& rounded) {
  return x.exact() ? JsonOutput(to_string(*x.exact())) : json_of(rounded);
}

JsonOutput json_of(const RealAlgebraic& x) {
  const auto exact = x.rational();
  return json_of(exact ? PathEnd(*exact) : PathEnd(x));
}

JsonOutput json_of(const Vector<Rational>& point) {
  return {to_string(point[0]), to_string(point[1]), to_string(point[2])};
}

JsonOutput json_of(const RadicalForm& F) {
  const auto text = [](const Radical& x) { return formatted(x, radical_notation::maple); };
  JsonOutput logs = JsonOutput::array();
  for (const RadicalSum& sum : F.logs) {
    JsonOutput log = json_of(sum.sum);
    log["roots"] = array_of(sum.roots, text);
    log["residues"] = array_of(sum.residues, text);
    log["real_roots"] = sum.real_roots;
    logs.push_back(std::move(log));
  }
  return {{"logs", logs}};
}

void add_note(JsonOutput& json, const std::optional<Nearness>& near) {
  if (near) json["note"] = "in the place of what is no PH curve, " + to_line(*near);
}

JsonOutput json_of(const NamedCurve& named) {
  const auto list = [](const Polynomial& p) {
    return p.is_zero() ? JsonOutput::array({"0"}) : json_of(p);
  };
  const QuaternionPolynomial& a = named.curve.preimage();
  JsonOutput json = {{"phrame", "curve/1"}};
  if (!named.name.empty()) json["name"] = named.name;
  add_note(json, named.near);
  json["basis"] = "power";
  json["start"] = json_of(named.curve.start());
  json["preimage"] = {{"u", list(a.u)}, {"v", list(a.v)}, {"p", list(a.p)}, {"q", list(a.q)}};
  if (!named.curve.is_polynomial()) {
    const RationalFunction f(named.curve.multiplier(), pow(named.curve.weight(), 2));
    json["multiplier"] = {{"numerator", list(f.numerator())},
                          {"denominator", list(f.denominator())}};
  } else if (!(named.curve.multiplier() == Polynomial{1})) {
    json["multiplier"] = list(named.curve.multiplier());
  }
  return json;
}

JsonOutput json_of(const RationalCurve& curve) {
  JsonOutput json = {{"phrame", "curve/1"}};
  const long n = degree(curve);
  const std::vector<Rational> weights = to_bernstein(curve.weight(), n);
  if (std::any_of(weights.begin(), weights.end(), [](const Rational& w) { return w <= 0; })) {
    json["basis"] = "power";
    const auto list = [](const Polynomial& p) {
      return p.is_zero() ? JsonOutput::array({"0"}) : json_of(p);
    };
    const auto& [x, y, z] = curve.numerator();
    json["position"] = {
        {"x", list(x)}, {"y", list(y)}, {"z", list(z)}, {"w", list(curve.weight())}};
    return json;
  }
  JsonOutput points = JsonOutput::array();
  Vector<std::vector<Rational>> numerator;
  for (std::size_t k = 0; k < 3; ++k) numerator[k] = to_bernstein(curve.numerator()[k], n);
  for (std::size_t k = 0; k < weights.size(); ++k)
    points.push_back(json_of(Vector<Rational>{
        numerator[0][k] / weights[k], numerator[1][k] / weights[k], numerator[2][k] / weights[k]}));
  json["control_points"] = std::move(points);
  if (curve.weight().is_constant()) return json;
  json["weights"] = JsonOutput::array();
  for (const Rational& w : weights) json["weights"].push_back(to_string(w));
  return json;
}

namespace {

JsonOutput json_of(const ExpressionCurve& curve) {
  const std::string& s = curve.variable();
  const auto& [x, y, z] = curve.position();
  return {{"phrame", "curve/1"},
          {"expressions", {{"x", full_text(x, s)}, {"y", full_text(y, s)}, {"z", full_text(z, s)}}},
          {"variable", s},
          {"from", full_text(curve.from(), s)},
          {"to", full_text(curve.to(), s)}};
}

/// Is it rational, with a preimage of the least degree, as its points tell it up to a constant?
bool is_known_by_points(const Curve& curve) {
  const auto [alpha, beta] = hopf_form(curve.preimage());
  return !curve.is_polynomial() && degree(gcd(alpha, beta)) == 0;
}

JsonOutput segment_json(const Segment& segment) {
  const Curve* ph = ph_curve(segment);
  if (ph != nullptr && !is_known_by_points(*ph)) return json_of(NamedCurve{"", *ph});
  return visit_curve([](const auto& curve) { return json_of(curve); }, segment);
}

}  // namespace

JsonOutput json_of(const FrameThrough& frame) {
  JsonOutput through = JsonOutput::array();
  for (const auto& [joint, f2, turns] : frame.joints) {
    through.push_back({{"t", joint}, {"f2", json_of(f2)}});
    if (turns != 0) through.back()["turns"] = turns;
  }
  JsonOutput json = {{"through", std::move(through)},
                     {"twist", frame.is_smooth ? "smooth" : "even"}};
  if (frame.axis != TangentAxis()) json["tangent_axis"] = name_of(frame.axis);
  return json;
}

JsonOutput json_of(const NamedPath& named) {
  const auto& list = named.path.segments();
  const bool is_single = list.size() == 1 && !named.frame;
  JsonOutput json = {{"phrame", is_single ? "curve/1" : "spline/1"}};
  if (!named.name.empty()) json["name"] = named.name;
  add_note(json, named.near);
  if (is_single) {
    json.update(segment_json(list.front()));
    return json;
  }
  JsonOutput segments = JsonOutput::array();
  for (std::size_t k = 0; k < list.size(); ++k) {
    JsonOutput part = segment_json(list[k]);
    part.erase("phrame");
    // Where a segment by formulas ends is not read as fractions.
    if (k > 0 && !std::holds_alternative<ExpressionCurve>(list[k - 1])) part.erase("start");
    segments.push_back(std::move(part));
  }
  json["segments"] = std::move(segments);
  if (named.frame) json["frame"] = json_of(*named.frame);
  return json;
}

JsonOutput json_of(const Nearness& nearness) {
  const auto& frames = nearness.rmf_difference;
  return {{"epsilon", to_string(nearness.epsilon)},
          {"distance", upper_bound_text(nearness.distance)},
          {"unrounded_distance", upper_bound_text(nearness.unrounded_distance)},
          {"bits", nearness.bits},
          {"rmf_difference", frames ? JsonOutput(upper_bound_text(*frames)) : JsonOutput()}};
}

void add_nearness(JsonOutput& json, const std::optional<Nearness>& near) {
  if (near) json["near"] = json_of(*near);
}

}  // namespace phrame
