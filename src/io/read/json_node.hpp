#pragma once
#include <optional>

#include "phrame/algebra/rational.hpp"
#include "phrame/io/read/json_value.hpp"

namespace phrame::inline v0 {

/// A value of a JSON document with its JSON pointer: every complaint names the place. Refers to the
/// document.
class JsonNode {
 public:
  using Kind = JsonValue::Kind;

  explicit JsonNode(const JsonValue& document) : value_(&document) {}

  /// The JSON pointer; "/" of the whole document.
  std::string place() const { return pointer_.empty() ? "/" : pointer_; }
  bool is(Kind kind) const { return value_->kind == kind; }
  [[noreturn]] void fail(const std::string& reason) const;
  /// Throws InputError unless it is of that kind: "`wanted` is wanted, not a number".
  void require(Kind kind, const std::string& wanted) const;
  /// An object without other keys.
  void require_known_keys(const std::vector<std::string_view>& known) const;

  // Of an object.
  std::optional<JsonNode> find(const std::string& key) const;
  JsonNode at(const std::string& key) const;  ///< throws InputError where the key is missing
  const std::vector<std::string>& keys() const { return value_->keys; }

  // Of an array.
  std::size_t size() const { return value_->items.size(); }
  JsonNode item(std::size_t k) const;
  std::vector<Rational> numbers() const;
  std::vector<Rational> numbers(std::size_t count) const;  ///< exactly so many

  const std::string& string() const;
  const std::string& text() const { return value_->text; }  ///< as it is written; of an atom
  bool boolean() const;
  /// Of a number, or of a string that holds one; exact.
  Rational number() const;
  /// Its value, without the place.
  const JsonValue& value() const { return *value_; }

 private:
  JsonNode(const JsonValue& value, std::string pointer)
      : value_(&value), pointer_(std::move(pointer)) {}

  const JsonValue* value_;
  std::string pointer_;
};

/// It on one line without blanks, numbers as they are written.
std::string json_text(const JsonNode& node);

/// Throws InputError at the first number in it that refuse_long_number() refuses.
void refuse_long_numbers(const JsonNode& node);

}  // namespace phrame
