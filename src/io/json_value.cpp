#include "phrame/io/json_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational.hpp"

namespace phrame {
namespace {

/// nlohmann's parser converts every number besides handing over its text, and stops where that
/// overflows: with a long double far beyond any bare number that people write.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, long double>;

/// "line:column" of the byte before `offset`.
std::string place_of(std::string_view text, std::size_t offset) {
  const auto read = text.substr(0, offset);
  const auto line = 1 + std::count(read.begin(), read.end(), '\n');
  const auto column = read.size() - (read.rfind('\n') + 1);  // npos + 1 is 0
  return fmt::format("{}:{}", line, column);
}

/// Builds a JsonValue from the events of nlohmann's parser.
class Builder : public nlohmann::json_sax<Json> {
 public:
  explicit Builder(std::string_view text) : text_(text) {}

  JsonValue result() { return std::move(root_); }

  bool null() override { return scalar(JsonValue::Kind::null, "null"); }
  bool boolean(bool value) override {
    return scalar(JsonValue::Kind::boolean, value ? "true" : "false");
  }
  bool number_integer(number_integer_t value) override {
    return scalar(JsonValue::Kind::number, std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar(JsonValue::Kind::number, std::to_string(value));
  }
  bool number_float(number_float_t, const string_t& text) override {
    return scalar(JsonValue::Kind::number, text);
  }
  bool string(string_t& value) override {
    return scalar(JsonValue::Kind::string, std::move(value));
  }
  bool binary(binary_t&) override { return false; }  // not in JSON text

  bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
  bool end_object() override {
    // Not key by key, which would be quadratic.
    const auto& keys = open_.back()->keys;
    std::vector<std::string_view> sorted(keys.begin(), keys.end());
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
      throw InputError(pointer() + "/" + abbreviated(*twice), "the key occurs twice");
    return close();
  }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    open_.back()->keys.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::detail::exception& error) override {
    const std::string place = place_of(text_, position);
    if (dynamic_cast<const nlohmann::detail::out_of_range*>(&error) != nullptr)
      throw InputError(place, fmt::format("the number {} is too large to be written bare: put it "
                                          "in quotes",
                                          abbreviated(last_token)));
    // "[…] parse error at …: syntax error while parsing value - what is wrong; expected …"
    std::string reason = error.what();
    if (const auto at = reason.find(" - "); at != std::string::npos) reason.erase(0, at + 3);
    reason.erase(std::min(reason.find(';'), reason.size()));
    throw InputError(place, "not valid JSON: " + abbreviated(reason, 120));
  }

 private:
  JsonValue& add(JsonValue value) {
    if (open_.empty()) return root_ = std::move(value);
    return open_.back()->items.emplace_back(std::move(value));
  }

  /// Of the innermost open container.
  std::string pointer() const {
    std::string text;
    for (std::size_t k = 0; k + 1 < open_.size(); ++k) {
      const JsonValue& container = *open_[k];
      text += "/";
      text += container.kind == JsonValue::Kind::object
                  ? abbreviated(container.keys.back())
                  : std::to_string(container.items.size() - 1);
    }
    return text;
  }

  bool scalar(JsonValue::Kind kind, std::string text) {
    add({kind, std::move(text), {}, {}});
    return true;
  }

  bool open(JsonValue::Kind kind) {
    constexpr std::size_t deepest = 32;
    if (open_.size() == deepest)
      throw InputError(abbreviated(pointer(), 120),
                       fmt::format("the JSON is nested deeper than {} levels", deepest));
    open_.push_back(&add({kind, {}, {}, {}}));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  JsonValue root_;
  std::vector<JsonValue*> open_;  ///< the containers around this place; an open one is never moved
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  const auto at = std::find(keys.begin(), keys.end(), key);
  return at == keys.end() ? nullptr : &items[static_cast<std::size_t>(at - keys.begin())];
}

JsonValue parse_json(std::string_view text) {
  Builder builder(text);
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.result();
}

std::string description(const JsonValue& value) {
  switch (value.kind) {
    case JsonValue::Kind::null:
      return "null";
    case JsonValue::Kind::boolean:
      return value.text;
    case JsonValue::Kind::number:
      return "the number " + abbreviated(value.text);
    case JsonValue::Kind::string:
      return fmt::format("the string \"{}\"", abbreviated(value.text));
    case JsonValue::Kind::array:
      return fmt::format("an array of {}", value.items.size());
    case JsonValue::Kind::object:
      return fmt::format("an object of {}", value.keys.size());
  }
  return "?";
}

}  // namespace phrame
