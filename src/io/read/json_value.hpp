#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace phrame::inline v0 {

/// A JSON value that keeps numbers as the text they were written in, because they are read exactly.
struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  std::string text;               ///< of a number, a string; "true" or "false"
  std::vector<std::string> keys;  ///< of an object, in order
  std::vector<JsonValue> items;   ///< of an array, or the values of the keys

  /// The member of that name, or nullptr.
  const JsonValue* find(std::string_view key) const;
};

/// Parses one JSON document. Throws InputError for invalid JSON (place "line:column"), for a key
/// that occurs twice in an object and for nesting deeper than 32 (place: a JSON pointer).
JsonValue parse_json(std::string_view text);
/// The same of a file; what does not even begin as JSON does is said to be no `kind`, "curve file".
JsonValue parse_json_file(std::string_view text, std::string_view kind);

/// What is wrong, out of a message of nlohmann's parser: without the number of the error, the place
/// and what was expected. Here to be tested, because releases of the parser word it differently.
std::string parse_error_reason(std::string_view message);

/// "a string", "an array of 3", …: what stands there, for messages.
std::string description(const JsonValue& value);

}  // namespace phrame
