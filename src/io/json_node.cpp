#include "phrame/io/json_node.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

/// Levenshtein's distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

void JsonNode::fail(const std::string& reason) const {
  throw InputError(pointer_.empty() ? "/" : pointer_, reason);
}

void JsonNode::require(Kind kind, const std::string& wanted) const {
  if (value_->kind != kind) fail(fmt::format("{} is wanted, not {}", wanted, description(*value_)));
}

void JsonNode::require_known_keys(const std::vector<std::string_view>& known) const {
  require(Kind::object, "an object");
  for (const std::string& key : keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string shown = abbreviated(key);
    const auto nearest = *std::min_element(known.begin(), known.end(), [&](auto a, auto b) {
      return edit_distance(shown, a) < edit_distance(shown, b);
    });
    fail(fmt::format("unknown key \"{}\"; the nearest known key is \"{}\"", shown, nearest));
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
  for (std::size_t k = 0; k < size(); ++k) result.push_back(item(k).number());
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

}  // namespace phrame
