#include "phrame/io/read/part21.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/number.hpp"

namespace phrame::inline v0 {
namespace {

constexpr std::string_view step_blanks = " \t\r\n\f\v";

bool is_name_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

/// The first byte behind blanks and comments.
std::size_t skip_blanks(std::string_view text, std::size_t at) {
  for (;;) {
    at = std::min(text.find_first_not_of(step_blanks, at), text.size());
    if (!text.substr(at).starts_with("/*")) return at;
    const auto end = text.find("*/", at + 2);
    at = end == std::string_view::npos ? text.size() : end + 2;
  }
}

/// Behind a text in quotes, which begins there; two quotes in it are one.
std::size_t behind_text(std::string_view text, std::size_t at) {
  for (;;) {
    const auto end = text.find('\'', at + 1);
    if (end == std::string_view::npos) return text.size();
    if (end + 1 == text.size() || text[end + 1] != '\'') return end + 1;
    at = end + 1;
  }
}

/// Where the ";" of the statement is that begins there; the size of the text where there is none.
std::size_t end_of_statement(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    at = std::min(text.find_first_of(";'/", at), text.size());
    if (at == text.size() || text[at] == ';') return at;
    if (text[at] == '\'')
      at = behind_text(text, at);
    else
      at = text.substr(at).starts_with("/*") ? skip_blanks(text, at) : at + 1;
  }
  return at;
}

/// Reads what is behind the "=" of an instance.
class Part21Reader {
 public:
  Part21Reader(std::string_view text, long instance, long line)
      : text_(text), instance_(instance), line_(line) {
    skip();
  }

  std::vector<Part21Entity> entities() {
    std::vector<Part21Entity> found;
    if (take('(')) {
      while (!take(')')) found.push_back(entity());
      if (found.empty()) fail("an entity is expected");
    } else {
      found.push_back(entity());
    }
    if (at_ != text_.size()) fail("the end of the instance is expected");
    return found;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(line_place(line_),
                     fmt::format("#{}: {}, not \"{}\"", instance_, reason,
                                 abbreviated(std::string(text_.substr(at_)), 40)));
  }
  void skip() { at_ = skip_blanks(text_, at_); }
  bool take(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    skip();
    return true;
  }
  template <class Is>
  std::string_view take_while(const Is& is) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is(text_[at_])) ++at_;
    const std::string_view taken = text_.substr(begin, at_ - begin);
    skip();
    return taken;
  }
  Part21Entity entity() {
    const std::string_view name = take_while(is_name_letter);
    if (name.empty()) fail("the name of an entity is expected");
    if (!take('(')) fail("\"(\" is expected");
    return {name, values(), instance_, line_};
  }
  /// Behind a "(", up to its ")".
  std::vector<Part21Value> values() {
    constexpr int most_nested = 32;
    if (++depth_ > most_nested) fail("lists are at most 32 deep");
    std::vector<Part21Value> found;
    while (!take(')')) {
      if (!found.empty() && !take(',')) fail("\",\" or \")\" is expected");
      found.push_back(value());
    }
    --depth_;
    return found;
  }
  Part21Value value() {
    using ValueKind = Part21Value::Kind;
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (c == '#') {
      ++at_;
      return {ValueKind::reference, take_while([](char d) { return d >= '0' && d <= '9'; })};
    }
    if (take('$') || take('*')) return {ValueKind::none, {}};
    if (take('(')) return {ValueKind::list, {}, values()};
    if (c == '.') {
      ++at_;
      const std::string_view word = take_while(is_name_letter);
      if (!take('.')) fail("\".\" is expected");
      return {ValueKind::word, word};
    }
    if (c == '\'' || c == '"') {
      const std::size_t begin = at_ + 1;
      at_ = c == '\'' ? behind_text(text_, at_)
                      : std::min(text_.find('"', begin), text_.size() - 1) + 1;
      const std::string_view text = text_.substr(begin, std::max(at_ - 1, begin) - begin);
      skip();
      return {ValueKind::text, text};
    }
    if (c == '+' || c == '-' || (c >= '0' && c <= '9'))
      return {ValueKind::number, take_while([](char d) {
                return (d >= '0' && d <= '9') || d == '+' || d == '-' || d == '.' || d == 'E' ||
                       d == 'e';
              })};
    const std::string_view name = take_while(is_name_letter);
    if (name.empty() || !take('(')) fail("a value is expected");
    return {ValueKind::typed, name, values()};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  long instance_;
  long line_;
  int depth_ = 0;
};

long number_of(std::string_view digits) {
  long number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc() && end == digits.data() + digits.size() && !digits.empty() ? number
                                                                                         : -1;
}

}  // namespace

void Part21Entity::fail(const std::string& reason) const {
  throw InputError(line_place(line), fmt::format("#{}={}: {}", instance, name, reason));
}

const Part21Value& Part21Entity::at(std::size_t k, Part21Value::Kind kind, const char* what) const {
  if (k >= values.size() || values[k].kind != kind)
    fail(fmt::format("{} is expected as parameter {}", what, k + 1));
  return values[k];
}

Rational Part21Entity::number(const Part21Value& value) const {
  // LENGTH_MEASURE(2.) is a number with its type.
  if (value.kind == Part21Value::Kind::typed && value.items.size() == 1)
    return number(value.items.front());
  if (value.kind != Part21Value::Kind::number) fail("a number is expected");
  try {
    return parse_short_number(value.text);
  } catch (const InputError& error) {
    fail(error.reason());
  }
}

Rational Part21Entity::number(std::size_t k, const char* what) const {
  if (k >= values.size()) fail(fmt::format("{} is expected as parameter {}", what, k + 1));
  return number(values[k]);
}

long Part21Entity::whole_number(std::size_t k, long most, const char* what) const {
  number(k, what);  // which has to be there
  return whole_number(values[k], most);
}

std::vector<Rational> Part21Entity::numbers(std::size_t k, const char* what) const {
  std::vector<Rational> found;
  for (const Part21Value& item : at(k, Part21Value::Kind::list, what).items)
    found.push_back(number(item));
  return found;
}

long Part21Entity::whole_number(const Part21Value& value, long most) const {
  const Rational x = number(value);
  if (denominator(x) != 1 || x < 0 || x > most)
    fail(fmt::format("{} is no whole number up to {}", abbreviated(std::string(value.text)), most));
  return static_cast<long>(numerator(x));
}

long Part21Entity::reference(std::size_t k, const char* what) const {
  return number_of(at(k, Part21Value::Kind::reference, what).text);
}

std::vector<long> Part21Entity::references(std::size_t k, const char* what) const {
  std::vector<long> found;
  for (const Part21Value& item : at(k, Part21Value::Kind::list, what).items) {
    if (item.kind != Part21Value::Kind::reference) fail(fmt::format("{} is expected", what));
    found.push_back(number_of(item.text));
  }
  return found;
}

bool Part21Entity::flag(std::size_t k, const char* what) const {
  const std::string_view word = at(k, Part21Value::Kind::word, what).text;
  if (word != "T" && word != "F") fail(fmt::format("{} is .T. or .F.", what));
  return word == "T";
}

bool is_part21(std::string_view text) { return text.starts_with("ISO-10303-21"); }

Part21File::Part21File(std::string_view text) {
  long line = 1;
  std::size_t counted = 0;
  for (std::size_t at = skip_blanks(text, 0); at < text.size();) {
    line += std::count(text.begin() + static_cast<long>(counted),
                       text.begin() + static_cast<long>(at), '\n');
    counted = at;
    const std::size_t end = end_of_statement(text, at);
    if (end == text.size())
      throw InputError(line_place(line), "the statement that begins here has no \";\"");
    if (text[at] == '#') {
      const std::string_view statement = text.substr(at + 1, end - at - 1);
      const auto equals = std::min(statement.find('='), statement.size());
      const long number = number_of(trimmed(statement.substr(0, equals)));
      if (number < 0 || equals == statement.size())
        throw InputError(line_place(line), "an instance \"#12=...\" is expected");
      const std::string_view body = statement.substr(equals + 1);
      const std::size_t name = skip_blanks(body, 0);
      std::size_t name_end = name;
      while (name_end < body.size() && is_name_letter(body[name_end])) ++name_end;
      if (!entries_.insert({number, {body.substr(name, name_end - name), body, line}}).second)
        throw InputError(line_place(line), fmt::format("#{} is there twice", number));
    }
    at = skip_blanks(text, end + 1);
  }
}

std::vector<Part21Entity> Part21File::instance(long number) const {
  const Entry& entry = entries_.at(number);
  return Part21Reader(entry.body, number, entry.line).entities();
}

std::vector<Part21Entity> Part21File::instance(long number, const Part21Entity& from) const {
  if (!entries_.contains(number)) from.fail(fmt::format("there is no #{}", number));
  return instance(number);
}

const Part21Entity* find_entity(const std::vector<Part21Entity>& entities, std::string_view name) {
  const auto found = std::ranges::find(entities, name, &Part21Entity::name);
  return found == entities.end() ? nullptr : &*found;
}

}  // namespace phrame
