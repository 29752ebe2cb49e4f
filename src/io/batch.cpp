#include "phrame/io/batch.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/write/angle_text.hpp"
#include "phrame/io/write/failure.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/number_text.hpp"
#include "phrame/io/write/spline_report.hpp"

namespace phrame {
namespace {

using Kind = JsonNode::Kind;
constexpr long most_digits = 100'000;

/// Is the line no question with a curve in it, but a curve or spline?
bool is_bare(const JsonValue& line) {
  return line.kind == Kind::object && line.find("curve") == nullptr &&
         line.find("phrame") != nullptr;
}

/// As JSON text, "null" where there is none. The id of a bare curve is its name; an answer, which
/// has an id, is no bare curve.
std::string id_of(const JsonValue& line) {
  const JsonValue* id = line.kind == Kind::object ? line.find("id") : nullptr;
  if (id == nullptr && is_bare(line)) id = line.find("name");
  if (id == nullptr) return "null";
  if (id->kind == Kind::string) return JsonOutput(id->text).dump();
  if (id->kind == Kind::number) return id->text;
  return "null";
}

Reference frame_of(const JsonNode& node) {
  const std::string& name = node.string();
  if (name == "erf") return Reference::erf;
  if (name == "frenet") return Reference::frenet;
  node.fail(fmt::format("\"{}\" is not one of erf, frenet", abbreviated(name)));
}

long digits_of(const JsonNode& node) {
  const Rational digits = node.number();
  if (denominator(digits) != 1 || digits < 1 || digits > most_digits)
    node.fail(fmt::format("{} is not a whole number from 1 to {}", abbreviated(to_string(digits)),
                          most_digits));
  return static_cast<long>(numerator(digits));
}

Angle angle_of(const JsonNode& node) {
  if (!node.is(Kind::string)) return node.number();
  try {
    return parse_angle(node.string());
  } catch (const InputError& error) {
    node.fail(error.reason());
  }
}

/// What a line asks.
struct Question {
  std::variant<NamedCurve, NamedSpline> curve;
  Reference reference;
  std::vector<Rational> at;
  long digits;
  Angle start_angle = {};
};

Question question(const JsonNode& line, const BatchDefaults& defaults) {
  line.require(Kind::object, "an object");
  if (!line.find("curve")) {
    if (line.find("spline"))
      line.fail("a spline stands at the key \"curve\", too, not at \"spline\"");
    if (!line.find("phrame"))
      line.fail("the key \"curve\" is missing, and without \"phrame\" it is no bare curve");
    return {read_curve_or_spline(line, defaults.limits), defaults.frame, defaults.at,
            defaults.digits};
  }
  line.require_known_keys({"id", "curve", "frame", "at", "digits", "theta0", "note"});
  if (const auto id = line.find("id"); id && !id->is(Kind::string) && !id->is(Kind::number))
    id->fail("an id is a string or a number");
  const auto frame = line.find("frame");
  const Reference reference = frame ? frame_of(*frame) : defaults.frame;
  const auto places = line.find("at");
  const std::vector<Rational> at = !places                   ? defaults.at
                                   : places->is(Kind::array) ? places->numbers()
                                                             : std::vector{places->number()};
  const auto precision = line.find("digits");
  const long digits = precision ? digits_of(*precision) : defaults.digits;
  const auto theta0 = line.find("theta0");
  const Angle start_angle = theta0 ? angle_of(*theta0) : Angle();

  return {read_curve_or_spline(line.at("curve"), defaults.limits), reference, at, digits,
          start_angle};
}

std::string answer(const JsonNode& line, const BatchDefaults& defaults) {
  const auto [read, reference, at, digits, start_angle] = question(line, defaults);
  if (const auto* curve = std::get_if<NamedCurve>(&read)) {
    const RmfAngle angle(curve->curve, reference);
    AngleReport report{*curve, reference, angle, start_angle, {}, digits};
    report.shows_form = !defaults.values_only;
    for (const Rational& t : at)
      report.values.push_back(rounded_angle(t, angle.value(t, start_angle), digits));
    return to_json_line(report);
  }
  if (reference != Reference::erf)
    line.fail("the Frenet frame is for single curves; this is a spline");
  const auto& spline = std::get<NamedSpline>(read);
  const SplineAngle angle(spline.spline);
  auto report = spline_angle_report(spline.name, angle, start_angle, at, digits);
  report.shows_form = !defaults.values_only;
  return to_json_line(report);
}

/// What a file over several lines is refused for.
JsonValue parse_line(std::string_view line) {
  try {
    return parse_json(line);
  } catch (const InputError& error) {
    const std::string& place = error.place();
    const std::string column = place.starts_with("1:") ? "column " + place.substr(2) : place;
    const std::string hint = trimmed(line).find('\r') == std::string_view::npos
                                 ? "each line is a JSON object by itself"
                                 : "lines end with a line feed, a carriage return alone ends none";
    throw InputError(column, fmt::format("{} ({})", error.reason(), hint));
  }
}

}  // namespace

BatchAnswer batch_answer(std::string_view line, const BatchDefaults& defaults) {
  std::string id = "null";
  try {
    const JsonValue document = parse_line(line);
    id = id_of(document);
    return {fmt::format("{{\"id\":{},{}", id, answer(JsonNode(document), defaults).substr(1)),
            false};
  } catch (...) {
    const auto [status, message] = current_failure();
    const JsonOutput error = {{"status", status}, {"message", message}};
    const auto text = error.dump(-1, ' ', false, JsonOutput::error_handler_t::replace);
    return {fmt::format("{{\"id\":{},\"error\":{}}}", id, text), true, message};
  }
}

std::optional<std::string> batch_id(std::string_view line) {
  try {
    const std::string id = id_of(parse_json(line));
    if (id != "null") return id;
  } catch (const InputError&) {  // no JSON: it is computed, and refused, again
  }
  return std::nullopt;
}

std::optional<std::string> answered_id(std::string_view line) {
  try {
    const JsonValue document = parse_json(line);
    if (document.kind != Kind::object) return std::nullopt;
    const JsonValue* format = document.find("phrame");
    const bool is_angle =
        format != nullptr && (format->text == "angle/1" || format->text == "spline-angle/1");
    if (is_angle || document.find("error") != nullptr) return id_of(document);
  } catch (const InputError&) {
  }
  return std::nullopt;
}

}  // namespace phrame
