#include "phrame/cli/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "phrame/cli/command.hpp"
#include "phrame/cli/progress_line.hpp"
#include "phrame/cli/watchdog.hpp"
#include "phrame/io/read/number.hpp"

namespace phrame::inline v0::cli {
namespace {

/// "a", "a or b", "a, b or c".
std::string alternatives(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t k = 0; k < choices.size(); ++k)
    text += (k == 0 ? "" : k + 1 == choices.size() ? " or " : ", ") + choices[k];
  return text;
}

/// The endings of files that say what is in them.
const std::vector<std::pair<std::string, std::string>>& formats_by_ending() {
  static const std::vector<std::pair<std::string, std::string>> table{
      {"txt", "text"},    {"text", "text"},  {"out", "text"},      {"log", "text"},
      {"json", "json"},   {"csv", "csv"},    {"npy", "npy"},       {"tex", "latex"},
      {"latex", "latex"}, {"py", "sympy"},   {"m", "mathematica"}, {"wl", "mathematica"},
      {"mpl", "maple"},   {"mac", "maxima"}, {"gp", "pari"},       {"obj", "obj"},
      {"stl", "stl"},     {"ply", "ply"},    {"glb", "glb"},       {"gltf", "gltf"},
      {"py", "blender"},  {"nc", "gcode"},   {"ngc", "gcode"},     {"gcode", "gcode"},
      {"tap", "gcode"},   {"step", "step"},  {"stp", "step"},      {"svg", "svg"},
      {"html", "html"},   {"htm", "html"}};
  return table;
}

}  // namespace

std::string ending(const std::string& path) {
  const std::size_t name = path.rfind('/') + 1;  // npos + 1 is 0
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos || dot <= name) return "";
  std::string result = path.substr(dot + 1);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const bool is_number = std::all_of(result.begin(), result.end(),
                                     [](unsigned char c) { return std::isdigit(c) != 0; });
  return is_number ? "" : result;
}

namespace {

/// Endings of files that one command writes, or none: pages and pictures, documents, tables, packed
/// files, meshes and surfaces of others.
bool is_well_known(const std::string& end) {
  static const std::vector<std::string> names{
      "html",  "htm",  "h",   "hpp",  "v",    "jsonl", "pdf",  "ps",    "eps",  "png",
      "jpg",   "jpeg", "gif", "bmp",  "tif",  "tiff",  "webp", "mp4",   "webm", "doc",
      "docx",  "odt",  "rtf", "epub", "md",   "xml",   "yaml", "yml",   "toml", "xls",
      "xlsx",  "ods",  "tsv", "npz",  "mat",  "h5",    "hdf5", "vtk",   "vtp",  "zip",
      "gz",    "xz",   "zst", "tar",  "tgz",  "iges",  "igs",  "brep",  "dxf",  "dwg",
      "off",   "fbx",  "dae", "usd",  "usda", "usdc",  "usdz", "blend", "js",   "css",
      "ipynb", "3mf",  "3ds", "3dm",  "7z",   "x3d",   "amf",  "wrl",   "bz2"};
  return std::find(names.begin(), names.end(), end) != names.end();
}

/// Is it the ending of another format than text?
bool means_a_format(const std::string& end) {
  const auto& known = formats_by_ending();
  return is_well_known(end) || std::any_of(known.begin(), known.end(), [&end](const auto& entry) {
           return entry.first == end && entry.second != "text";
         });
}

CLI::Validator is_in(WholeNumbers range) {
  const auto complaint = [range](std::string& text) -> std::string {
    text = with_plain_minus(std::string(trimmed(text)));
    long value = 0;
    const char* const text_end = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), text_end, value);
    if (error == std::errc() && end == text_end && range.least <= value && value <= range.most)
      return "";
    return fmt::format("\"{}\" is not a whole number from {} to {}", abbreviated(text), range.least,
                       range.most);
  };
  return {complaint, ""};
}

constexpr int most_arguments = 1'000'000;

}  // namespace

std::string Command::name() const { return app_.get_name(); }
std::string Command::what() const { return app_.get_description(); }

std::vector<std::string> Command::restrictions() const {
  std::map<std::vector<std::string>, std::vector<std::string>> options_by_choices;
  for (const auto& [option, facts] : facts_)
    if (!facts.without.empty()) options_by_choices[facts.without].push_back(option);
  std::vector<std::string> sentences;
  for (const auto& [choices, options] : options_by_choices)
    sentences.push_back(
        fmt::format("Not with {}: {}.", alternatives(choices), fmt::join(options, ", ")));
  return sentences;
}

void Command::add_argument(const std::string& argument, std::string& value,
                           const std::string& what) {
  add_optional_argument(argument, value, what);
  require(argument);
}

// CLI11 compares with the names of all options, which takes long where it is asked often.
CLI::Option& Command::named(const std::string& name) const {
  CLI::Option*& known = options_[name];
  if (known == nullptr) known = app_.get_option(name);
  return *known;
}

OptionFacts& Command::facts_of(const CLI::Option& option) { return facts_[option.get_name()]; }

void Command::add_optional_argument(const std::string& argument, std::string& value,
                                    const std::string& what) {
  add_option(argument, "", value, what);
}

void Command::add_optional_arguments(const std::string& argument, std::vector<std::string>& values,
                                     const std::string& what) {
  app_.add_option(argument, values, what)->type_name("")->expected(0, most_arguments);
}

void Command::add_option(const std::string& option, const std::string& value_name,
                         std::string& value, const std::string& what) {
  const CLI::Option* added = app_.add_option(option, value, what)->type_name(value_name);
  if (!value.empty()) facts_of(*added).by_default = value;
}

void Command::add_option(const std::string& option, const std::string& value_name,
                         std::optional<std::string>& value, const std::string& what) {
  app_.add_option(option, value, what)->type_name(value_name);
}

void Command::add_list(const std::string& option, const std::string& value_name,
                       std::vector<std::string>& values, const std::string& what) {
  const CLI::Option* added =
      app_.add_option(option, values, what)->type_name(value_name)->expected(1)->take_all();
  if (!values.empty()) facts_of(*added).by_default = fmt::format("{}", fmt::join(values, ","));
}

void Command::add_number(const std::string& option, long& value, WholeNumbers range,
                         const std::string& what, const std::string& value_name) {
  const CLI::Option* added =
      app_.add_option(option, value, what)->type_name(value_name)->transform(is_in(range));
  OptionFacts& facts = facts_of(*added);
  facts.range = range;
  if (range.least <= value && value <= range.most) facts.by_default = std::to_string(value);
}

void Command::add_flag(const std::string& option, bool& value, const std::string& what) {
  app_.add_flag(option, value, what);
}

void Command::add_hidden_flag(const std::string& option) { app_.add_flag(option)->group(""); }

void Command::add_choice(const std::string& option, std::string& value,
                         std::vector<std::string> names, const std::string& what) {
  add_option(option, option.starts_with('-') ? "NAME" : "", value, what);
  facts_[option].names = std::move(names);
  values_[option] = [&value] { return std::vector{value}; };
}

void Command::add_choices(const std::string& option, std::vector<std::string>& values,
                          std::vector<std::string> names, const std::string& what) {
  add_list(option, "NAME,...", values, what);
  facts_[option].names = std::move(names);
  values_[option] = [&values] { return split(values); };
}

void Command::add_words(const std::string& option, std::vector<std::string> words) {
  named(option);  // throws where there is none
  facts_[option].words = std::move(words);
}

void Command::add_format(const std::string& option, std::string& value,
                         std::vector<std::string> names, const std::string& what) {
  add_choice(option, value, std::move(names), what);
  OptionFacts& facts = facts_[option];
  if (std::ranges::find(facts.names, "json") != facts.names.end()) facts.in_lines = "json";
  format_option_ = option;
  format_ = &value;
  describe_output();
}

void Command::json_only_with(const std::string& choice) {
  json_needs_ = choice;
  facts_[format_option_].in_lines.reset();
}

void Command::add_output(std::string& path) {
  add_option("-o,--output", "FILE", path, "write to this file instead of standard output");
  output_ = &path;
  describe_output();
}

void Command::writes(std::string what, std::vector<std::string> endings) {
  what_it_writes_ = std::move(what);
  own_endings_ = std::move(endings);
}

void Command::add_time_limit() {
  add_option("--time-limit", "SECONDS", time_limit_,
             what_is_limited_.empty() ? "after so many seconds without an answer end with status 4"
                                      : what_is_limited_);
}

std::optional<double> Command::time_limit() const {
  if (!time_limit_) return std::nullopt;
  constexpr double most = 1e9;
  const double seconds = static_cast<double>(parse_positive_option("--time-limit", *time_limit_));
  return std::clamp(seconds, 1e-3, most);
}

void Command::describe_output() {
  if (format_ != nullptr && output_ != nullptr)
    named("--output")
        .description("write to this file instead of standard output; without " + format_option_ +
                     "\nits ending chooses the format");
}

void Command::require(const std::string& option) { named(option).required(); }

void Command::require_but_with(const std::string& choice, const std::string& option) {
  app_.get_option(option);  // throws where there is none
  facts_[option].required_but_with = choice;
}

void Command::only_with(const std::vector<std::string>& options,
                        const std::vector<std::string>& choices) {
  for (const std::string& option : options) {
    named(option).group("Only with " + alternatives(choices));
    facts_[option].with = choices;
  }
}

void Command::not_with(const std::vector<std::string>& options,
                       const std::vector<std::string>& choices) {
  for (const std::string& option : options) {
    named(option);  // throws where there is none
    auto& without = facts_[option].without;
    without.insert(without.end(), choices.begin(), choices.end());
  }
}

const OptionFacts& Command::facts(const std::string& option) const {
  static const OptionFacts none;
  const auto found = facts_.find(option);
  return found == facts_.end() ? none : found->second;
}

bool Command::is_given(const std::string& option) const { return named(option).count() > 0; }

void Command::refuse(const std::vector<std::string>& options, const std::string& why) const {
  for (const std::string& option : options)
    if (is_given(option)) throw InputError(option, why);
}

bool Command::is_chosen(const std::string& choice) const {
  constexpr std::string_view conjunction = " and ";
  if (const std::size_t at = choice.find(conjunction); at != std::string::npos)
    return is_chosen(choice.substr(0, at)) && is_chosen(choice.substr(at + conjunction.size()));
  const std::size_t blank = choice.find(' ');
  const std::string option = choice.substr(0, blank);
  if (blank == std::string::npos) return is_given(option);
  const std::vector<std::string> values = values_.at(option)();
  return std::find(values.begin(), values.end(), choice.substr(blank + 1)) != values.end();
}

bool Command::applies(const std::string& option) const {
  const auto chosen = [this](const std::string& choice) { return is_chosen(choice); };
  const OptionFacts& own = facts(option);
  if (!own.with.empty() && std::ranges::none_of(own.with, chosen)) return false;
  if (std::ranges::any_of(own.without, chosen)) return false;
  return std::ranges::none_of(facts_, [&](const auto& other) {
    const auto& without = other.second.without;
    return is_given(other.first) &&
           std::find(without.begin(), without.end(), option) != without.end();
  });
}

void Command::give(const std::string& option, const std::string& value) {
  CLI::Option& taker = named(option);
  try {
    taker.add_result(value);
    taker.run_callback();
  } catch (const CLI::ParseError& error) {
    const std::string message = error.what();
    const std::string place = taker.get_name() + ": ";
    throw InputError(option, message.starts_with(place) ? message.substr(place.size()) : message);
  }
}

std::vector<std::pair<std::string, std::string>> Command::given() const {
  std::vector<std::pair<std::string, std::string>> list;
  for (const CLI::Option* option : app_.get_options())
    if (option->count() > 0)
      list.emplace_back(option->get_name(), fmt::format("{}", fmt::join(option->results(), ",")));
  return list;
}

void Command::prefer_json() {
  if (format_ == nullptr || is_given(format_option_)) return;
  const auto& names = facts_.at(format_option_).names;
  const bool has_json = std::find(names.begin(), names.end(), "json") != names.end();
  if (has_json && (json_needs_.empty() || is_chosen(json_needs_))) *format_ = "json";
}

void Command::answer() {
  require_applicable();
  action_();
}

void Command::forget() {
  app_.clear();
  time_limit_.reset();
  for (const auto& to_default : to_defaults_) to_default();
}

void Command::refuse_format(const std::string& why) const {
  throw InputError(format_option_, fmt::format("\"{}\" {}", *format_, why));
}

void Command::require_known_names(const std::string& option,
                                  const std::vector<std::string>& names) const {
  const auto values = values_.find(option);
  if (values == values_.end()) return;
  for (const std::string& value : values->second())
    if (std::ranges::find(names, value) == names.end())
      throw InputError(option, fmt::format("\"{}\" is not one of {}", abbreviated(value),
                                           fmt::join(names, ", ")));
}

void Command::require_applicable() const {
  const auto chosen = [this](const std::string& choice) { return is_chosen(choice); };
  std::vector<std::string> given;
  for (const CLI::Option* option : app_.get_options())
    if (option->count() > 0) given.push_back(option->get_name());
  for (const auto& [option, facts] : facts_) {
    if (std::ranges::find(given, option) == given.end()) {
      if (!facts.required_but_with.empty() && !is_chosen(facts.required_but_with))
        throw InputError(option, "is required (phrame " + name() + " --help)");
      continue;
    }
    const bool lacks = !facts.with.empty() && std::ranges::none_of(facts.with, chosen);
    if (lacks) require_known_names(option, facts.names);
    if (lacks) throw InputError(option, "needs " + alternatives(facts.with));
    const auto against = std::find_if(facts.without.begin(), facts.without.end(), chosen);
    if (against != facts.without.end()) throw InputError(option, "does not apply with " + *against);
  }
}

void Command::choose_format() const {
  if (format_ == nullptr || output_ == nullptr || is_given(format_option_)) return;
  const std::string end = ending(*output_);
  if (end.empty()) return;
  const auto& names = facts_.at(format_option_).names;
  for (const auto& [known, format] : formats_by_ending())
    if (known == end && std::find(names.begin(), names.end(), format) != names.end()) {
      *format_ = format;
      return;
    }
  throw InputError("--output",
                   fmt::format("\"{}\": \".{}\" is no format of {}; {} {} writes {} there",
                               abbreviated(*output_), end, name(), format_option_, names.front(),
                               names.front()));
}

void Command::check_ending() const {
  if (what_it_writes_.empty() || !is_given("--output")) return;
  const auto path = named("--output").as<std::string>();
  const std::string end = ending(path);
  if (std::find(own_endings_.begin(), own_endings_.end(), end) != own_endings_.end()) return;
  if (means_a_format(end))
    throw InputError("--output", fmt::format("\"{}\": \".{}\" is no format of {}, which writes {}",
                                             abbreviated(path), end, name(), what_it_writes_));
}

void Command::run() {
  check_ending();
  choose_format();
  require_applicable();
  const ProgressLine progress(name());
  const Watchdog watchdog(what_is_limited_.empty() ? time_limit() : std::nullopt);
  try {
    action_();
  } catch (const AnswerNo&) {
    print_notes_at_end();
    throw;
  }
  print_notes_at_end();
}

Program::Program(const std::string& name, const std::string& what, const std::string& notes)
    : app_(std::make_unique<CLI::App>(what, name)), notes_(notes) {
  app_->set_help_flag("-h,--help", "show this help");
  app_->option_defaults()->disable_flag_override();
}

Program::~Program() = default;

std::string Program::what() const { return app_->get_description(); }

Command& Program::add(const std::string& name, const std::string& what) {
  CLI::App* app = app_->add_subcommand(name, what);
  app->group("Commands");
  commands_.push_back(std::unique_ptr<Command>(new Command(*app)));
  return *commands_.back();
}

Command& Program::add_hidden(const std::string& name, const std::string& what) {
  Command& command = add(name, what);
  command.app_.group("");
  return command;
}

std::vector<const Command*> Program::commands() const {
  std::vector<const Command*> visible;
  for (const auto& command : commands_)
    if (!command->app().get_group().empty()) visible.push_back(command.get());
  return visible;
}

Command* Program::find(const std::string& name) const {
  for (const auto& command : commands_)
    if (command->name() == name) return command.get();
  return nullptr;
}

}  // namespace phrame::cli
