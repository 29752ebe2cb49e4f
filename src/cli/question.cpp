// The keys of a line are the arguments and options of a command, as the command lists them itself,
// so that what a command can be asked, a line can ask.
#include "phrame/cli/question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "phrame/algebra/time_limit.hpp"
#include "phrame/cli/exchange.hpp"
#include "phrame/cli/option_list.hpp"
#include "phrame/io/write/failure.hpp"
#include "phrame/io/write/json_text.hpp"

namespace phrame::inline v0::cli {
namespace {

using Kind = JsonNode::Kind;

/// An option as a key of a line.
struct Key {
  std::string name;  ///< "start_normal", "curve"
  ListedOption option;
  const std::string& option_name() const { return option.name(); }
};

/// All but those that are the batch's own business.
std::vector<Key> keys_of(const Command& command) {
  std::vector<Key> keys;
  for (ListedOption& option : listed_options(command))
    if (std::string name = option.key(); !name.empty())
      keys.push_back({std::move(name), std::move(option)});
  return keys;
}

bool is_atom(const JsonNode& node) { return node.is(Kind::string) || node.is(Kind::number); }

/// The items of an array of strings and numbers, with commas between them; no value for another.
std::optional<std::string> inline_row(const JsonNode& array) {
  if (!array.is(Kind::array)) return std::nullopt;
  std::string row;
  for (std::size_t k = 0; k < array.size(); ++k) {
    if (!is_atom(array.item(k))) return std::nullopt;
    if (array.item(k).text().find(',') != std::string::npos)
      array.item(k).fail("an item of a list has no comma in it");
    row += (k == 0 ? "" : ",") + array.item(k).text();
  }
  return row;
}

/// A row a line; no value for what is no array of rows.
std::optional<std::string> inline_table(const JsonNode& array) {
  if (!array.is(Kind::array) || array.size() == 0) return std::nullopt;
  std::string table;
  for (std::size_t k = 0; k < array.size(); ++k) {
    const auto row = inline_row(array.item(k));
    if (!row) return std::nullopt;
    table += *row + "\n";
  }
  return table;
}

/// What is in the file that the value of a key stands for.
Exchange::Content contents_at(const Key& key, const JsonNode& node) {
  if (node.is(Kind::string)) return node.string();
  if (auto table = inline_table(node)) return *std::move(table);
  if (!node.is(Kind::array)) node.require(Kind::object, "an object, or a file as text,");
  if (key.name == "curve" && node.is(Kind::object)) return node;
  return json_text(node);
}

/// What would stand on the command line; no value where nothing would.
std::optional<std::string> value_at(const Key& key, const JsonNode& node) {
  if (key.option.is_flag()) {
    if (node.boolean()) return "true";
    return std::nullopt;
  }
  if (node.is(Kind::array)) {
    if (auto table = inline_table(node)) return table;
    const bool is_list = key.option.value.find(',') != std::string::npos;  // "T,...", "X,Y,Z"
    const auto row = is_list ? inline_row(node) : std::nullopt;
    if (row && node.size() == 0) return std::nullopt;
    if (row) return row;
  }
  if (!is_atom(node)) node.require(Kind::string, "a string or a number");
  if (node.text() == "-") node.fail("\"-\" is standard input, from which the lines may come");
  return node.text();
}

/// Gives the command what the line says. What stands for a file is in the exchange, with the JSON
/// pointer for its name.
void give_line(Command& command, const std::vector<Key>& keys, const JsonNode& line,
               Exchange& exchange) {
  std::vector<std::string_view> known{"id", "question", "note"};
  for (const Key& key : keys) known.push_back(key.name);
  if (line.find("spline"))
    line.fail("a spline stands at the key \"curve\", too, not at \"spline\"");
  line.require_known_keys(known);
  for (const Key& key : keys) {
    const auto node = line.find(key.name);
    if (!node && key.option.is_required && !command.is_given(key.option_name()))
      line.at(key.name);  // throws
    if (!node) continue;
    if (key.option.takes_file) {
      exchange.files.emplace(node->place(), contents_at(key, *node));
      command.give(key.option_name(), node->place());
    } else if (const auto value = value_at(key, *node)) {
      command.give(key.option_name(), *value);
    }
  }
}

/// The curve of a line without one.
void give_curve(Command& command, const std::vector<Key>& keys, const JsonNode& line,
                const std::optional<NamedPath>& curve, Exchange& exchange) {
  if (!curve || line.find("curve")) return;
  if (keys.front().name != "curve")
    throw InputError("/" + keys.front().name, "a path is not what is wanted");
  exchange.files.emplace("/curve", *curve);
  command.give(keys.front().option_name(), "/curve");
}

/// A curve by itself, whose keys are not those of a question.
bool is_bare(const std::vector<Key>& keys, const JsonNode& line) {
  return !line.find("curve") && line.find("phrame") &&
         std::ranges::any_of(keys, [](const Key& key) { return key.name == "curve"; });
}

/// What an option is to all lines, where the line says nothing else.
void give_defaults(Command& command, const std::vector<Key>& keys, const JsonNode& line,
                   const QuestionDefaults& defaults) {
  for (const auto& [option, value] : defaults.options)
    for (const Key& key : keys)
      if (key.option_name() == option && !command.is_given(option) && !line.find(key.name) &&
          command.applies(option))
        command.give(option, value);
}

/// A place among the options as one in the line: "/at" for "--at", "/curve/name" for
/// "/curve:/name". What is given for all lines stays an option.
std::string place_in_line(const std::string& place, const Command& command,
                          const std::vector<Key>& keys, const JsonNode& line,
                          const Exchange& exchange) {
  if (place == command.name()) return "/";
  for (const Key& key : keys) {
    const std::string& option = key.option_name();
    const char next = place.size() > option.size() ? place[option.size()] : ' ';
    if (!place.starts_with(option) || std::string_view(" ,:").find(next) == std::string::npos)
      continue;
    const bool is_of_all = command.is_given(option) && !line.find(key.name);
    return (is_of_all ? option : "/" + key.name) + place.substr(option.size());
  }
  for (const auto& [file, content] : exchange.files)
    if (place.starts_with(file + ":/")) {
      const std::string within = place.substr(file.size() + 1);
      return file == "/" ? within : within == "/" ? file : file + within;
    }
  return place;
}

/// The same JSON without blanks and line feeds between its words.
std::string compact_json(std::string_view json) {
  std::string line;
  line.reserve(json.size());
  constexpr auto ends_run = [] {
    std::array<bool, 256> ends{};
    for (const char c : {' ', '\n', '\t', '\r', '"'}) ends[static_cast<unsigned char>(c)] = true;
    return ends;
  }();
  const auto is_end = [&](char c) { return ends_run[static_cast<unsigned char>(c)]; };
  for (std::size_t k = 0; k < json.size();) {
    const std::size_t begin = k;
    if (json[k] == '"') {
      for (++k; json[k] != '"'; ++k)
        if (json[k] == '\\') ++k;
      ++k;
    } else {
      while (k < json.size() && !is_end(json[k])) ++k;
    }
    line.append(json, begin, k - begin);
    while (k < json.size() && json[k] != '"' && is_end(json[k])) ++k;
  }
  return line;
}

std::string in_json(const Command& command, const Exchange& exchange, bool is_no) {
  const std::string& output = exchange.output;
  const auto dump = [](const JsonOutput& json) {
    return json.dump(-1, ' ', false, JsonOutput::error_handler_t::replace);
  };
  std::string object;
  if (output.starts_with('{') && (command.writes_json() || JsonOutput::accept(output))) {
    object = compact_json(output);
  } else {
    if (output.find('\0') != std::string::npos)
      command.refuse_format("is binary, which has no place in a line of JSON");
    JsonOutput json = JsonOutput::object();
    if (is_no) json["status"] = 1;
    json["output"] = output;
    object = dump(json);
  }
  if (exchange.notes.empty()) return object;
  return fmt::format("{{\"notes\":{},{}", dump(exchange.notes), object.substr(1));
}

/// What a command writes that has all its options.
std::string written_answer(Command& command, const Exchange& exchange) {
  bool is_no = false;
  try {
    command.answer();
  } catch (const AnswerNo& no) {
    if (!no.complaint.empty()) throw Failure{1, no.complaint};
    is_no = true;
  }
  return in_json(command, exchange, is_no);
}

/// A command with its options, as keys.
struct Question {
  Program program{"phrame", "", ""};
  Command& command;
  std::vector<Key> keys;

  Question(const std::string& name, AddCommand add)
      : command(added(program, name, add)), keys(keys_of(command)) {}

 private:
  static Command& added(Program& program, const std::string& name, AddCommand add) {
    add(program);
    program.find(name)->add_time_limit();
    return *program.find(name);
  }
};

/// That of this thread, which serves all lines: to make one takes longer than most answers.
Question& question_of(const std::string& name, AddCommand add) {
  thread_local std::map<AddCommand, Question> questions;
  return questions.try_emplace(add, name, add).first->second;
}

std::string answer_to(const JsonNode& line, const QuestionDefaults& defaults, Question& question) {
  Command& command = question.command;
  const std::vector<Key>& keys = question.keys;
  Exchange exchange;
  try {
    if (is_bare(keys, line)) {
      exchange.files.emplace("/", line);
      command.give("CURVE", "/");
    } else {
      give_curve(command, keys, line, defaults.curve, exchange);
      give_line(command, keys, line, exchange);
    }
    command.prefer_json();
    give_defaults(command, keys, line, defaults);
    std::optional<TimeLimit> limit;
    if (const auto seconds = command.time_limit()) limit.emplace(*seconds);
    return written_answer(command, exchange);
  } catch (const InputError& error) {
    if (error.place().empty()) throw;
    throw InputError(place_in_line(error.place(), command, keys, line, exchange), error.reason());
  }
}

}  // namespace

std::string answer_question(const JsonNode& line, const QuestionDefaults& defaults,
                            const CommandTable& table) {
  line.require(Kind::object, "an object");
  if (const auto id = line.find("id"); id && !is_atom(*id))
    id->fail("an id is a string or a number");
  const auto asked = line.find("question");
  const std::string& name = asked ? asked->string() : defaults.question;
  Question& question = question_of(name, choose("/question", name, table));
  question.command.forget();  // what the line before gave
  return answer_to(line, defaults, question);
}

}  // namespace phrame::cli
