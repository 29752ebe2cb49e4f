#include "phrame/cli/listing.hpp"

#include "phrame/cli/option_list.hpp"
#include "phrame/io/write/json_text.hpp"

namespace phrame::inline v0::cli {
namespace {

/// null where there is none.
JsonOutput default_of(const ListedOption& option) {
  const auto& value = option.facts.by_default;
  if (!value) return nullptr;
  return option.facts.range ? JsonOutput(std::stol(*value)) : JsonOutput(*value);
}

JsonOutput json_of(const ListedOption& option) {
  const OptionFacts& facts = option.facts;
  JsonOutput json = {{"names", option.names},
                     {"key", option.key()},
                     {"value", option.value},
                     {"kind", option.kind()},
                     {"choices", facts.names},
                     {"words", facts.words},
                     {"default", nullptr},
                     {"list", option.takes_list},
                     {"file", option.takes_file},
                     {"argument", option.is_argument},
                     {"required", option.is_required},
                     {"with", facts.with},
                     {"without", facts.without},
                     {"what", option.what}};
  json["default"] = default_of(option);
  if (facts.range) json["range"] = {facts.range->least, facts.range->most};
  return json;
}

}  // namespace

std::string listing(const std::vector<const Command*>& commands) {
  JsonOutput list = JsonOutput::array();
  for (const Command* command : commands) {
    const JsonOutput options = array_of(listed_options(*command),
                                        [](const ListedOption& option) { return json_of(option); });
    list.push_back({{"command", command->name()},
                    {"what", command->what()},
                    {"question", is_question(*command)},
                    {"options", options}});
  }
  return pretty({{"phrame", "commands/1"}, {"commands", list}});
}

}  // namespace phrame::cli
