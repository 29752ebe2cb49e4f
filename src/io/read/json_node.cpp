#include "phrame/io/read/json_node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/suggestion.hpp"

namespace phrame::inline v0 {

namespace {

/// No value where it holds none that can be read.
std::optional<Rational> number_in(const JsonValue& value) {
  if (value.kind != JsonValue::Kind::number && value.kind != JsonValue::Kind::string)
    return std::nullopt;
  try {
    return parse_rational(value.text);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

void JsonNode::fail(const std::string& reason) const { throw InputError(place(), reason); }

void JsonNode::require(Kind kind, const std::string& wanted) const {
  if (value_->kind != kind) fail(fmt::format("{} is wanted, not {}", wanted, description(*value_)));
}

void JsonNode::require_known_keys(const std::vector<std::string_view>& known) const {
  require(Kind::object, "an object");
  for (const std::string& key : keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const auto meant = suggestion(key, {known.begin(), known.end()});
    fail(fmt::format("unknown key \"{}\"; {}", abbreviated(key),
                     meant ? fmt::format("the nearest known key is \"{}\"", *meant)
                           : fmt::format("the keys are {}", fmt::join(known, ", "))));
  }
}

std::optional<JsonNode> JsonNode::find(const std::string& key) const {
  const JsonValue* member = value_->find(key);
  if (member == nullptr) return std::nullopt;
  return JsonNode(*member, pointer_ + "/" + key);
}

JsonNode JsonNode::at(const std::string& key) const {
  auto member = find(key);
  if (!member) fail(fmt::format("the key \"{}\" is missing", key));
  return *std::move(member);
}

JsonNode JsonNode::item(std::size_t k) const {
  return {value_->items[k], fmt::format("{}/{}", pointer_, k)};
}

std::vector<Rational> JsonNode::numbers() const {
  std::vector<Rational> result;
  result.reserve(size());
  for (std::size_t k = 0; k < size(); ++k) {
    // With its place only where something is wrong with it.
    const JsonValue& value = value_->items[k];
    auto number = number_in(value);
    result.push_back(number ? *std::move(number) : item(k).number());
  }
  return result;
}

std::vector<Rational> JsonNode::numbers(std::size_t count) const {
  require(Kind::array, fmt::format("an array of {} numbers", count));
  if (size() != count) fail(fmt::format("{} numbers are wanted, not {}", count, size()));
  return numbers();
}

const std::string& JsonNode::string() const {
  require(Kind::string, "a string");
  return value_->text;
}

bool JsonNode::boolean() const {
  require(Kind::boolean, "true or false");
  return value_->text == "true";
}

Rational JsonNode::number() const {
  if (value_->kind != Kind::number && value_->kind != Kind::string)
    fail(fmt::format("a number is wanted, not {}", description(*value_)));
  try {
    return parse_rational(value_->text);
  } catch (const InputError& error) {
    fail(error.reason());
  }
}

std::string json_text(const JsonNode& node) {
  const JsonValue& value = node.value();
  std::string text;
  switch (value.kind) {
    case JsonNode::Kind::object:
      for (const std::string& key : value.keys)
        text += fmt::format("{}{}:{}", text.empty() ? "" : ",", nlohmann::json(key).dump(),
                            json_text(node.at(key)));
      return "{" + text + "}";
    case JsonNode::Kind::array:
      for (std::size_t k = 0; k < node.size(); ++k)
        text += (k == 0 ? "" : ",") + json_text(node.item(k));
      return "[" + text + "]";
    case JsonNode::Kind::string:
      return nlohmann::json(value.text).dump();
    case JsonNode::Kind::null:
      return "null";
    default:
      return value.text;
  }
}

namespace {

/// By the texts in it.
bool may_have_many_bits(const JsonValue& value) {
  constexpr std::size_t short_text = 1000;  // without an exponent
  constexpr std::string_view of_numbers = "0123456789+-.eExXaAbBcCdDfFpP/";
  const auto has = [&text = value.text](std::string_view any_of) {
    return text.find_first_of(any_of) != std::string::npos;
  };
  const auto is_like_number = [&] {
    return has("eE") && has("0123456789") &&
           value.text.find_first_not_of(of_numbers) == std::string::npos;
  };
  return value.text.size() > short_text || is_like_number() ||
         std::ranges::any_of(value.items, may_have_many_bits);
}

}  // namespace

void refuse_long_numbers(const JsonNode& node) {
  const JsonValue& value = node.value();
  if (!may_have_many_bits(value)) return;
  for (const std::string& key : value.keys) refuse_long_numbers(node.at(key));
  if (node.is(JsonNode::Kind::array))
    for (std::size_t k = 0; k < node.size(); ++k) refuse_long_numbers(node.item(k));
  if (!node.is(JsonNode::Kind::number) && !node.is(JsonNode::Kind::string)) return;
  Rational number;
  try {
    number = parse_rational(value.text);
  } catch (const InputError&) {
    return;  // a name, perhaps; else it is complained of where it is read
  }
  try {
    refuse_long_number(number, value.text);
  } catch (const InputError& error) {
    node.fail(error.reason());
  }
}

}  // namespace phrame
