#include "phrame/cli/batch_line.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/time_limit.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/failure.hpp"
#include "phrame/io/write/json_text.hpp"

namespace phrame::inline v0::cli {
namespace {

using Kind = JsonNode::Kind;

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
    return {fmt::format("{{\"id\":{},{}", id,
                        answer_question(JsonNode(document), defaults.question).substr(1)),
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

}  // namespace phrame::cli
