#include "phrame/io/batch.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/answer/angle.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/time_limit.hpp"
#include "phrame/io/read/angle.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/failure.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/nearness.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = JsonNode::Kind;
constexpr long most_digits = 100'000;

/// Of a line that asks for an angle.
const std::vector<std::string_view> angle_keys{
    "id", "curve", "frame", "up", "at", "digits", "theta0", "start_normal", "note", "question"};

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
  for (const auto& [known, reference] : reference_names())
    if (name == known) return reference;
  node.fail(fmt::format("\"{}\" is not one of erf, frenet, up", abbreviated(name)));
}

long digits_of(const JsonNode& node) {
  const Rational digits = node.number();
  if (denominator(digits) != 1 || digits < 1 || digits > most_digits)
    node.fail(
        fmt::format("{} is not a whole number from 1 to {}", as_written(digits), most_digits));
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

Vector<Rational> vector_of(const JsonNode& node) {
  const auto v = node.numbers(3);
  return {v[0], v[1], v[2]};
}

/// Where a frame starts, for a line with "theta0" or "start_normal".
std::optional<FrameStart> start_of(const JsonNode& line) {
  const auto theta0 = line.find("theta0");
  const auto normal = line.find("start_normal");
  if (theta0 && normal) line.fail("\"theta0\" and \"start_normal\" exclude each other");
  if (theta0) return angle_of(*theta0);
  if (!normal) return std::nullopt;
  return StartNormal(vector_of(*normal));
}

/// With `near` a PH path that stands for what is none.
NamedPath path_of(const JsonNode& curve, const BatchDefaults& defaults) {
  if (!defaults.near) return read_any_path(curve, defaults.limits);
  auto read = read_path_near(curve, *defaults.near, defaults.limits);
  if (const auto* none = std::get_if<NotNear>(&read)) curve.fail(to_line(*none, *defaults.near));
  return std::get<NamedPhPath>(std::move(read));
}

/// What a line asks beside the path.
AngleQuery query_of(const JsonNode& line, const BatchDefaults& defaults) {
  AngleQuery query;
  query.reference = defaults.frame;
  query.at = defaults.at;
  query.digits = defaults.digits;
  query.start = defaults.start;
  query.wants_formula = !defaults.values_only;
  if (!line.find("curve")) return query;
  if (const auto frame = line.find("frame")) query.reference = frame_of(*frame);
  if (const auto at = line.find("at"))
    query.at = at->is(Kind::array) ? at->numbers() : std::vector{at->number()};
  if (const auto digits = line.find("digits")) query.digits = digits_of(*digits);
  if (const auto up = line.find("up")) query.up = vector_of(*up);
  if (auto start = start_of(line)) query.start = *std::move(start);
  return query;
}

/// Does it ask for more than an angle, or have keys that only the command angle has?
bool asks_otherwise(const JsonNode& line, const BatchDefaults& defaults) {
  if (!line.is(Kind::object)) return false;
  const auto question = line.find("question");
  if (question && !defaults.otherwise && question->string() != "angle")
    question->fail("only the program answers other questions than \"angle\"");
  if (!defaults.otherwise) return false;
  if ((question ? question->string() : defaults.question) != "angle") return true;
  const auto is_other = [](const std::string& key) {
    return std::ranges::find(angle_keys, key) == angle_keys.end();
  };
  return line.find("curve") && std::ranges::any_of(line.keys(), is_other);
}

void require_id(const JsonNode& line) {
  if (const auto id = line.find("id"); id && !id->is(Kind::string) && !id->is(Kind::number))
    id->fail("an id is a string or a number");
}

/// A line with "curve", or a bare curve: what is the path there.
JsonNode curve_of(const JsonNode& line) {
  line.require(Kind::object, "an object");
  if (!line.find("curve")) {
    if (line.find("spline"))
      line.fail("a spline stands at the key \"curve\", too, not at \"spline\"");
    if (!line.find("phrame"))
      line.fail("the key \"curve\" is missing, and without \"phrame\" it is no bare curve");
    return line;
  }
  line.require_known_keys(angle_keys);
  require_id(line);
  return line.at("curve");
}

/// A vector that gives no start is an error at the line's key, else in the option for all lines.
void require_start(const JsonNode& line, const FrameStart& start, const Path& path) {
  if (!std::holds_alternative<StartNormal>(start)) return;
  try {
    require_start_normal(std::get<StartNormal>(start), path);
  } catch (const DomainError& error) {
    if (const auto normal = line.find("start_normal")) normal->fail(error.what());
    throw InputError(std::string("--start-normal: ") + error.what());
  }
}

/// What does not go with this path.
void require_frame(const JsonNode& line, const NamedPath& named, const AngleQuery& query) {
  if (!line.find("curve")) return;
  const auto frame = line.find("frame");
  if (frame && query.reference == Reference::euler_rodrigues && !named.path.is_ph())
    frame->fail("\"erf\" needs a Pythagorean-hodograph curve, and this is none");
  const auto up = line.find("up");
  if (!up) return;
  if (frame && query.reference != Reference::up)
    up->fail("it is of the frame \"up\", and \"frame\" is another");
  try {
    require_up_vector(named.path, *query.up);
  } catch (const DomainError& error) {
    up->fail(error.what());
  }
}

std::string answer_text(const JsonNode& line, const BatchDefaults& defaults) {
  if (asks_otherwise(line, defaults)) {
    require_id(line);
    return defaults.otherwise(line);
  }
  const JsonNode curve = curve_of(line);
  AngleQuery query = query_of(line, defaults);
  const NamedPath named = path_of(curve, defaults);
  require_frame(line, named, query);
  require_start(line, query.start, named.path);
  // The Euler–Rodrigues frame that is meant for all lines is that of PH curves.
  const bool is_given = line.find("curve") && line.find("frame");
  if (!is_given && !named.path.is_ph() && query.reference == Reference::euler_rodrigues)
    query.reference.reset();
  return to_json_line(answer(named, query));
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
  std::optional<TimeLimit> limit;
  const auto failed = [&](const Failure& failure) -> BatchAnswer {
    limit.reset();
    const JsonOutput error = {{"status", failure.status}, {"message", failure.message}};
    const auto text = error.dump(-1, ' ', false, JsonOutput::error_handler_t::replace);
    return {fmt::format("{{\"id\":{},\"error\":{}}}", id, text), true, failure.message};
  };
  try {
    if (defaults.seconds) limit.emplace(*defaults.seconds);
    const JsonValue document = parse_line(line);
    id = id_of(document);
    if (defaults.is_done && id != "null" && defaults.is_done(id)) return {"", false};
    return {fmt::format("{{\"id\":{},{}", id, answer_text(JsonNode(document), defaults).substr(1)),
            false};
  } catch (const Failure& failure) {
    return failed(failure);
  } catch (...) {
    return failed(current_failure());
  }
}

std::optional<std::string> answered_id(std::string_view line) {
  try {
    const JsonValue document = parse_json(line);
    if (document.kind != Kind::object) return std::nullopt;
    // A question has an id and neither of these; a bare curve has a format and no id.
    const bool is_answer = document.find("id") != nullptr && (document.find("phrame") != nullptr ||
                                                              document.find("output") != nullptr);
    const JsonValue* format = document.find("phrame");
    const bool is_angle =
        format != nullptr && (format->text == "angle/1" || format->text == "spline-angle/1");
    if (is_answer || is_angle || document.find("error") != nullptr) return id_of(document);
  } catch (const InputError&) {
  }
  return std::nullopt;
}

}  // namespace phrame
