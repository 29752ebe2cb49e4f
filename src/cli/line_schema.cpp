#include <fmt/format.h>

#include <algorithm>

#include "phrame/cli/listing.hpp"
#include "phrame/cli/option_list.hpp"
#include "phrame/io/write/json_text.hpp"

namespace phrame::inline v0::cli {
namespace {

using OptionList = std::vector<ListedOption>;

const JsonOutput atom = JsonOutput::array({"string", "number"});

/// What value_at() of a line takes: a list or a vector as an array, too, and numbers as texts.
JsonOutput schema_of(const ListedOption& option) {
  const std::string kind = option.kind();
  if (kind == "flag") return {{"type", "boolean"}};
  if (kind == "file") return {{"type", {"object", "array", "string"}}};
  if (kind == "number")
    return {{"type", {"integer", "string"}},
            {"minimum", option.facts.range->least},
            {"maximum", option.facts.range->most}};
  const JsonOutput names = {{"enum", option.facts.names}};
  if (kind == "name" && !option.takes_list) return names;
  if (kind == "name")
    return {{"anyOf", {{{"type", "string"}}, {{"type", "array"}, {"items", names}}}}};
  JsonOutput schema = {{"type", {"string", "number", "array"}}};
  if (option.value.find(',') == std::string::npos) {  // a table has an array for each row
    schema["items"] = {{"type", "array"}, {"items", {{"type", atom}}}};
    return schema;
  }
  schema["items"] = {{"type", atom}};
  if (!option.takes_list)  // "X,Y,Z"
    schema["minItems"] = schema["maxItems"] =
        1 + std::count(option.value.begin(), option.value.end(), ',');
  return schema;
}

const ListedOption& option_named(const OptionList& options, std::string_view name) {
  return *std::ranges::find(options, name, &ListedOption::name);
}

/// What an option is in a line without it.
const std::optional<std::string>& default_in_line(const ListedOption& option) {
  return option.facts.in_lines ? option.facts.in_lines : option.facts.by_default;
}

/// Is "--at" given, or has "--kind cubic" this value, by default, too?
JsonOutput chosen(const OptionList& options, const std::string& choice) {
  const std::size_t blank = choice.find(' ');
  const ListedOption& option = option_named(options, std::string_view(choice).substr(0, blank));
  const JsonOutput given = {{"required", {option.key()}}};
  if (blank == std::string::npos) return given;
  const std::string name = choice.substr(blank + 1);
  JsonOutput value = {{"const", name}};
  if (option.takes_list)
    value = {{"anyOf",
              {{{"type", "string"}, {"pattern", name}}, {{"type", "array"}, {"contains", value}}}}};
  JsonOutput schema = {{"properties", {{option.key(), value}}}};
  if (default_in_line(option) != name) schema.update(given);
  return schema;
}

/// "--from and --to".
JsonOutput all_chosen(const OptionList& options, const std::string& choices) {
  constexpr std::string_view conjunction = " and ";
  const std::size_t at = choices.find(conjunction);
  if (at == std::string::npos) return chosen(options, choices);
  return {{"allOf",
           {chosen(options, choices.substr(0, at)),
            all_chosen(options, choices.substr(at + conjunction.size()))}}};
}

JsonOutput any_chosen(const OptionList& options, const std::vector<std::string>& choices) {
  return {{"anyOf", array_of(choices, [&](const std::string& choice) {
             return all_chosen(options, choice);
           })}};
}

/// A condition of an option, where it is given; a flag is given where it is true.
void add_condition(JsonOutput& conditions, const ListedOption& option, const JsonOutput& then) {
  JsonOutput given = {{"required", {option.key()}}};
  if (option.is_flag()) given["properties"] = {{option.key(), {{"const", true}}}};
  conditions.push_back({{"if", given}, {"then", then}});
}

/// A line that asks this.
JsonOutput question_schema(const Command& command) {
  const OptionList options = listed_options(command);
  JsonOutput properties = {{"id", {{"type", atom}}},
                           {"question", {{"const", command.name()}}},
                           {"note", JsonOutput::object()}};
  JsonOutput required = JsonOutput::array();
  JsonOutput conditions = JsonOutput::array();
  for (const ListedOption& option : options) {
    const std::string key = option.key();
    if (key.empty()) continue;
    JsonOutput schema = schema_of(option);
    schema["description"] = option.what;
    if (const auto& value = default_in_line(option)) {
      schema["default"] = *value;
      if (option.facts.range) schema["default"] = std::stol(*value);
    }
    properties[key] = schema;
    if (option.is_required) required.push_back(key);
    if (const auto& with = option.facts.with; !with.empty())
      add_condition(conditions, option, any_chosen(options, with));
    if (const auto& without = option.facts.without; !without.empty())
      add_condition(conditions, option, {{"not", any_chosen(options, without)}});
  }
  JsonOutput schema = {{"type", "object"},
                       {"description", command.what()},
                       {"properties", properties},
                       {"required", required},
                       {"additionalProperties", false}};
  if (!conditions.empty()) schema["allOf"] = conditions;
  return schema;
}

}  // namespace

std::string line_schema(const std::vector<const Command*>& commands) {
  JsonOutput definitions = JsonOutput::object();
  JsonOutput names = JsonOutput::array();
  JsonOutput cases = JsonOutput::array();
  const JsonOutput bare = {{"required", {"phrame"}}, {"not", {{"required", {"curve"}}}}};
  for (const Command* command : commands) {
    if (!is_question(*command)) continue;
    const std::string name = command->name();
    names.push_back(name);
    definitions[name] = question_schema(*command);
    JsonOutput asked = {{"properties", {{"question", {{"const", name}}}}}, {"not", bare}};
    if (name != default_question) asked["required"] = {"question"};
    cases.push_back({{"if", asked}, {"then", {{"$ref", "#/$defs/" + name}}}});
  }
  return pretty({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "A line of phrame batch"},
                 {"type", "object"},
                 {"properties", {{"question", {{"enum", names}, {"default", default_question}}}}},
                 {"allOf", cases},
                 {"$defs", definitions}});
}

}  // namespace phrame::cli
