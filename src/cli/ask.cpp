#include "phrame/cli/ask.hpp"

#include "phrame/cli/listing.hpp"
#include "phrame/cli/option_list.hpp"
#include "phrame/io/read/json_value.hpp"
#include "phrame/io/write/failure.hpp"
#include "phrame/io/write/json_text.hpp"

namespace phrame::inline v0::cli {

std::string question_table(const CommandTable& table) {
  Program program("phrame", "", "");
  for (const auto& [name, add] : table) {
    add(program);
    program.find(name)->add_time_limit();
  }
  return listing(program.commands());
}

std::string ask(const std::string& line, const std::optional<NamedPath>& path,
                const CommandTable& table) {
  const JsonValue document = parse_json(line);
  try {
    return answer_question(JsonNode(document), {default_question, {}, path}, table);
  } catch (const Failure& failure) {
    return JsonOutput{{"status", failure.status}, {"output", failure.message}}.dump();
  }
}

}  // namespace phrame::cli
