#include "phrame/io/read/json_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational.hpp"
#include "phrame/io/read/number.hpp"

namespace phrame::inline v0 {
namespace {

using Json = nlohmann::json;

constexpr std::string_view number_characters = "0123456789+-.eE";

/// -?(0|[1-9]d*)(.d+)?([eE][+-]?d+)?, with d for a digit.
bool is_number(std::string_view text) {
  const auto take = [&](std::string_view any_of) {
    const bool taken = !text.empty() && any_of.find(text.front()) != std::string_view::npos;
    if (taken) text.remove_prefix(1);
    return taken;
  };
  const auto digits = [&] {
    const std::size_t length = text.size();
    while (take("0123456789")) {
    }
    return text.size() < length;
  };
  take("-");
  if (!take("0") && !digits()) return false;
  if (take(".") && !digits()) return false;
  if (take("eE")) {
    take("+-");
    if (!digits()) return false;
  }
  return text.empty();
}

bool has_duplicate(const std::vector<std::string>& keys) {
  // Not key by key, which would be quadratic.
  std::vector<std::string_view> sorted(keys.begin(), keys.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

constexpr std::size_t deepest_json = 32;

/// Reads JSON of ASCII without escapes, as most is, in a fifth of the time of nlohmann's parser. At
/// all else it gives up, for that to read it or to say what is wrong.
class PlainReader {
 public:
  explicit PlainReader(std::string_view text) : text_(text) {}

  std::optional<JsonValue> document() {
    JsonValue value;
    if (!read(value, 0)) return std::nullopt;
    skip_blanks();
    if (!text_.empty()) return std::nullopt;
    return value;
  }

 private:
  void skip_blanks() {
    text_.remove_prefix(std::min(text_.find_first_not_of(" \t\r\n"), text_.size()));
  }
  bool take(char c) {
    skip_blanks();
    if (text_.empty() || text_.front() != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  bool take_word(JsonValue& value, JsonValue::Kind kind, std::string_view word) {
    if (!text_.starts_with(word)) return false;
    value = {kind, std::string(word), {}, {}};
    text_.remove_prefix(word.size());
    return true;
  }

  bool read(JsonValue& value, std::size_t depth) {
    skip_blanks();
    if (text_.empty()) return false;
    switch (text_.front()) {
      case '{':
      case '[':
        return depth < deepest_json && read_container(value, depth + 1);
      case '"':
        value.kind = JsonValue::Kind::string;
        return read_string(value.text);
      case 't':
        return take_word(value, JsonValue::Kind::boolean, "true");
      case 'f':
        return take_word(value, JsonValue::Kind::boolean, "false");
      case 'n':
        return take_word(value, JsonValue::Kind::null, "null");
      default:
        return read_number(value);
    }
  }

  bool read_container(JsonValue& value, std::size_t depth) {
    const bool is_object = text_.front() == '{';
    const char end = is_object ? '}' : ']';
    text_.remove_prefix(1);
    value.kind = is_object ? JsonValue::Kind::object : JsonValue::Kind::array;
    if (take(end)) return true;
    do {
      if (is_object) {
        skip_blanks();
        if (!read_string(value.keys.emplace_back()) || !take(':')) return false;
      }
      if (!read(value.items.emplace_back(), depth)) return false;
    } while (take(','));
    return take(end) && !(is_object && has_duplicate(value.keys));
  }

  bool read_string(std::string& string) {
    const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
    if (text_.empty() || text_.front() != '"') return false;
    const auto end = std::find_if_not(text_.begin() + 1, text_.end(), is_plain);
    if (end == text_.end() || *end != '"') return false;
    string.assign(text_.begin() + 1, end);
    text_.remove_prefix(string.size() + 2);
    return true;
  }

  bool read_number(JsonValue& value) {
    const auto size = std::min(text_.find_first_not_of(number_characters), text_.size());
    if (!is_number(text_.substr(0, size))) return false;
    value = {JsonValue::Kind::number, std::string(text_.substr(0, size)), {}, {}};
    text_.remove_prefix(size);
    return true;
  }

  std::string_view text_;
};

/// The numbers of a JSON text, in order. nlohmann's parser would convert them, and stop where that
/// overflows, so it is given a text in which each is a 0 and blanks: every place stays the same.
struct Numbers {
  std::vector<std::string_view> texts;
  std::string without;
};

Numbers take_numbers(std::string_view text) {
  Numbers numbers{{}, std::string(text)};
  for (std::size_t k = 0; k < text.size();) {
    if (text[k] == '"') {  // skip a string
      for (++k; k < text.size() && text[k] != '"'; ++k)
        if (text[k] == '\\') ++k;
      ++k;
    } else if (text[k] == '-' || (text[k] >= '0' && text[k] <= '9')) {
      const std::size_t end = std::min(text.find_first_not_of(number_characters, k), text.size());
      // What is no number stays, for the parser to stop at.
      if (const auto token = text.substr(k, end - k); is_number(token)) {
        numbers.texts.push_back(token);
        numbers.without.replace(k, end - k, "0" + std::string(end - k - 1, ' '));
      }
      k = end;
    } else {
      ++k;
    }
  }
  return numbers;
}

/// The word that ends with, or goes on after, the last byte read before `offset`; may be empty.
std::string_view word_at(std::string_view text, std::size_t offset) {
  const auto is_of_word = [&](std::size_t k) {
    return std::isalnum(static_cast<unsigned char>(text[k])) != 0 ||
           std::string_view("+-._").find(text[k]) != std::string_view::npos;
  };
  std::size_t end = std::min(offset, text.size());
  std::size_t begin = end;
  while (begin > 0 && is_of_word(begin - 1)) --begin;
  while (begin < end && end < text.size() && is_of_word(end)) ++end;
  return text.substr(begin, end - begin);
}

/// Builds a JsonValue from the events of nlohmann's parser.
class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(std::string_view text, const std::vector<std::string_view>& numbers)
      : text_(text), numbers_(numbers) {}

  JsonValue result() { return std::move(root_); }

  bool null() override { return scalar(JsonValue::Kind::null, "null"); }
  bool boolean(bool value) override {
    return scalar(JsonValue::Kind::boolean, value ? "true" : "false");
  }
  bool number_integer(number_integer_t) override { return number(); }
  bool number_unsigned(number_unsigned_t) override { return number(); }
  bool number_float(number_float_t, const string_t&) override { return number(); }
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

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    const std::string reason = parse_error_reason(error.what());
    std::string_view word = word_at(text_, position);
    // A number that is cut short is left one byte later.
    if (word.empty() && reason == "invalid number" && position > 0)
      word = word_at(text_, position - 1);
    std::string message = "not valid JSON: " + abbreviated(reason, 120);
    if (!word.empty() && !reason.starts_with("invalid string") &&
        !reason.starts_with("unexpected end"))
      message += fmt::format(", at \"{}\"", abbreviated(word));
    throw InputError(line_and_column(text_, position), message);
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

  /// The parser meets the numbers in their order. Where it takes the beginning of what is none for
  /// a number there may be no text left, but then it stops at the rest.
  bool number() {
    const bool left = next_number_ < numbers_.size();
    return scalar(JsonValue::Kind::number, left ? std::string(numbers_[next_number_++]) : "");
  }

  bool open(JsonValue::Kind kind) {
    if (open_.size() == deepest_json)
      throw InputError(abbreviated(pointer(), 120),
                       fmt::format("the JSON is nested deeper than {} levels", deepest_json));
    open_.push_back(&add({kind, {}, {}, {}}));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::vector<std::string_view>& numbers_;
  std::size_t next_number_ = 0;
  JsonValue root_;
  std::vector<JsonValue*> open_;  ///< the containers around this place; an open one is never moved
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  const auto at = std::find(keys.begin(), keys.end(), key);
  return at == keys.end() ? nullptr : &items[static_cast<std::size_t>(at - keys.begin())];
}

// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while parsing
// value - what is wrong; expected …", since 3.11.3 also without " - ", and where the beginning of
// what is no number overflows "[json.exception.out_of_range.406] number overflow parsing '…'".
std::string parse_error_reason(std::string_view message) {
  const auto drop_through = [&message](std::string_view mark) {
    const auto at = message.find(mark);
    if (at != std::string_view::npos) message.remove_prefix(at + mark.size());
    return at != std::string_view::npos;
  };
  drop_through("] ");
  if (message.starts_with("number overflow")) return "invalid number";
  if (message.starts_with("parse error at")) drop_through(": ");
  if (message.starts_with("syntax error")) drop_through(" - ");
  return std::string(message.substr(0, message.find(';')));
}

JsonValue parse_json(std::string_view text) {
  if (auto plain = PlainReader(text).document()) return *std::move(plain);
  // nlohmann's parser takes it for the end of the text.
  if (const auto nul = text.find('\0'); nul != std::string_view::npos)
    throw InputError(line_and_column(text, nul + 1), "not valid JSON: a NUL byte");
  // Named here, since the releases of nlohmann's parser differ in what they say of it.
  if (without_mark(text).find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw InputError(line_and_column(text, text.size()), "not valid JSON: the input is empty");
  const Numbers numbers = take_numbers(text);
  Builder builder(text, numbers.texts);
  Json::sax_parse(numbers.without, &builder);
  return builder.result();
}

namespace {

/// Is the first line a document by itself, and does the next one begin another?
bool begins_with_lines(std::string_view text) {
  const auto end = text.find('\n');
  if (end == std::string_view::npos ||
      text.find('{', end) != text.find_first_not_of(" \t\r\n", end))
    return false;
  try {
    parse_json(text.substr(0, end));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

JsonValue parse_json_file(std::string_view text, std::string_view kind) {
  try {
    return parse_json(text);
  } catch (const InputError& error) {
    const auto begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (begin != std::string_view::npos && text[begin] == '{' && begins_with_lines(text))
      throw InputError(error.place(),
                       fmt::format("a {} is one JSON document; these are JSON lines, which phrame "
                                   "batch reads",
                                   kind));
    if (begin == std::string_view::npos || text[begin] == '{' || text[begin] == '[') throw;
    const std::string_view rest = text.substr(begin);
    const std::string what =
        rest.starts_with("\x93NUMPY")
            ? "is an array of NumPy"
            : fmt::format("begins with \"{}\"",
                          abbreviated(rest.substr(0, rest.find_first_of("\r\n"))));
    throw InputError(error.place(), fmt::format("a {} is JSON, this {}", kind, what));
  }
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
