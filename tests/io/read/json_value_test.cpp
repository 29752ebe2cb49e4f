#include "phrame/io/read/json_value.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/json_node.hpp"
#include "support/random.hpp"

namespace json_value_test {

using namespace phrame;

namespace {

using Kind = JsonValue::Kind;

/// "place | reason" of the refusal; empty where there is none.
std::string refusal(std::string_view text) {
  try {
    parse_json(text);
  } catch (const InputError& error) {
    return error.place() + " | " + error.reason();
  }
  return "";
}

std::string number_text(const std::string& text) {
  const JsonValue value = parse_json(text);
  CHECK(value.kind == Kind::number);
  return value.text;
}

}  // namespace

TEST_CASE("JSON values: each kind is told from the others") {
  CHECK(parse_json("null").kind == Kind::null);
  CHECK(parse_json("true").kind == Kind::boolean);
  CHECK(parse_json("false").text == "false");
  CHECK(parse_json(" \"a\\u0062\" ").text == "ab");
  CHECK(parse_json("[]").kind == Kind::array);
  CHECK(parse_json("{}").kind == Kind::object);
  CHECK(parse_json("\xEF\xBB\xBF[1]").items.size() == 1);  // a byte order mark is no character
}

TEST_CASE("JSON values: members keep their order, find returns the one or none") {
  const JsonValue value = parse_json(R"({"b": 1, "a": [2, {"c": 3}], "": 4})");
  REQUIRE(value.keys.size() == 3);
  CHECK(value.keys[0] == "b");
  CHECK(value.keys[1] == "a");
  REQUIRE(value.find("a") != nullptr);
  CHECK(value.find("a")->items[1].find("c")->text == "3");
  CHECK(value.find("")->text == "4");
  CHECK(value.find("c") == nullptr);
  CHECK(parse_json("[1]").find("a") == nullptr);
}

TEST_CASE("JSON values: numbers keep the text they were written in") {
  for (const char* text :
       {"0.1", "1e400", "-1.50E+2", "0.30000000000000000000000000000000001", "1e-5000", "-0.0"})
    CHECK(number_text(text) == text);
  CHECK(number_text("18446744073709551615") == "18446744073709551615");
  CHECK(number_text("18446744073709551616") == "18446744073709551616");
  CHECK(number_text("-9223372036854775809") == "-9223372036854775809");
  const std::string long_integer = "9" + std::string(399, '7');
  CHECK(number_text(long_integer) == long_integer);
}

TEST_CASE("JSON values: a bare number may be of any size") {
  for (const std::string& text :
       {std::string("1e9999"), std::string("-1E+999999999999"), std::string(1'000'000, '7'),
        "0." + std::string(10'000, '1') + "e-99999"})
    CHECK(number_text(text) == text);
}

TEST_CASE("JSON values: numbers stay in order, strings that look like numbers stay strings") {
  const JsonValue value = parse_json(R"([1e5000,"2",-3.50,{"4":"\"5\\",  "k":6E1},7,"-8\\"])");
  REQUIRE(value.items.size() == 6);
  CHECK(value.items[0].text == "1e5000");
  CHECK(value.items[1].kind == Kind::string);
  CHECK(value.items[2].text == "-3.50");
  CHECK(value.items[3].find("4")->text == "\"5\\");
  CHECK(value.items[3].find("k")->text == "6E1");
  CHECK(value.items[4].text == "7");
  CHECK(value.items[5].text == "-8\\");
}

// An escape makes nlohmann's parser read it, what is plain needs none.
TEST_CASE("JSON values: law: what is plain is read as nlohmann's parser reads it") {
  test::for_samples(300, [](test::Random& random) {
    const auto blank = [&] { return std::string(random.chance(4) ? " \t\r\n" : ""); };
    const std::function<std::string(long)> any = [&](long depth) -> std::string {
      const auto word = [&] {
        return std::vector{"null", "true", "false"}[static_cast<std::size_t>(random.integer(0, 2))];
      };
      switch (random.integer(0, depth > 0 ? 5 : 3)) {
        case 0:
          return word();
        case 1:
          return std::vector{"0", "-17", "3.25e-7",
                             "1E+9"}[static_cast<std::size_t>(random.integer(0, 3))];
        case 2:
        case 3:
          return std::vector{"\"\"", "\"a b ~ {[1,2]}:\"",
                             "\"x/y'\""}[static_cast<std::size_t>(random.integer(0, 2))];
        case 4: {
          std::string text = "[" + blank();
          for (long k = random.integer(0, 3); k > 0; --k)
            text += any(depth - 1) + blank() + (k > 1 ? "," : "") + blank();
          return text + "]";
        }
        default: {
          std::string text = "{" + blank();
          for (long k = random.integer(0, 3); k > 0; --k)
            text += "\"k" + std::to_string(k) + "\"" + blank() + ":" + blank() + any(depth - 1) +
                    blank() + (k > 1 ? "," : "") + blank();
          return text + "}";
        }
      }
    };
    const std::string inner = any(4);
    const std::string end = ":" + inner + "}" + blank();
    CAPTURE(inner);
    const JsonValue plain = parse_json("{\"a\"" + end);
    const JsonValue escaped = parse_json("{\"\\u0061\"" + end);
    CHECK(json_text(JsonNode(plain)) == json_text(JsonNode(escaped)));
    CHECK(description(plain.items[0]) == description(escaped.items[0]));
  });
}

// The parser sees no number but 0; what it accepts must be what it would accept anyway.
TEST_CASE("JSON values: law: accepted is what nlohmann's parser accepts, of any garbage") {
  using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                    std::uint64_t, long double>;
  constexpr std::string_view alphabet = "[]{}:,,\"\"\\ \n-+.eE0011true";
  long accepted = 0;
  test::for_samples(3000, [&](test::Random& random) {
    std::string text;
    const bool array = random.chance(2);
    for (long k = random.integer(0, 8); k >= 0; --k)
      text += alphabet[static_cast<std::size_t>(
          random.integer(0, static_cast<long>(alphabet.size()) - 1))];
    if (array) text = "[1e1," + text + "]";
    CAPTURE(text);
    const std::string reason = refusal(text);
    if (reason.find("occurs twice") != std::string::npos) return;
    CHECK(reason.empty() == Json::accept(text));
    accepted += reason.empty() ? 1 : 0;
  });
  CHECK(accepted > 20);
}

TEST_CASE("JSON values: what is nearly a number is refused, quoting it") {
  for (const std::string text : {"01", "1.", ".5", "-", "+1", "1e", "1e+", "0x10", "1.2.3", "1-2",
                                 "--1", "1e9999.5", "1_000", "-.5", "NaN", "-Infinity", "nan"}) {
    CAPTURE(text);
    const std::string message = refusal("[1e9999, \n" + text + ", 2]");
    CHECK(message.starts_with("2:"));
    CHECK(message.find("not valid JSON: ") != std::string::npos);
    CHECK(message.find("\"" + text + "\"") != std::string::npos);
  }
  CHECK(refusal(std::string(1'000'000, '7') + ".").size() < 200);
}

TEST_CASE("JSON values: what is not JSON is refused at its line and column") {
  const auto place = [](std::string_view text) {
    const std::string all = refusal(text);
    CHECK(all.find(" | not valid JSON: ") != std::string::npos);
    CHECK(all.find('\n') == std::string::npos);
    return all.substr(0, all.find(' '));
  };
  CHECK(place("") == "1:1");
  CHECK(place("{\"a\": [1,\n2") == "2:1");  // the last byte there is
  CHECK(place("[1,\n") == "2:1");           // there is none on the line
  CHECK(place("[1,\n  x]") == "2:3");
  CHECK(place("[1] x") == "1:5");
  CHECK(place("NaN") == "1:1");
  CHECK(place("[-Infinity]") == "1:3");
  CHECK(place("01") == "1:2");
  CHECK(place("{'a': 1}") == "1:2");
  CHECK(place("[1,]") == "1:4");
  CHECK(place("\"\xC3(\"") == "1:3");  // not UTF-8
  CHECK(place("\"a\tb\"") == "1:3");   // a control character must be escaped
  CHECK(place(std::string_view("\0", 1)) == "1:1");
  // It is not the end of the text.
  CHECK(refusal(std::string_view("{}\n \0garbage", 12)) == "2:2 | not valid JSON: a NUL byte");
  CHECK(refusal(std::string_view("{}\0", 3)) == "1:3 | not valid JSON: a NUL byte");
}

TEST_CASE("JSON values: an empty input is named as such, whatever the parser's release says") {
  CHECK(refusal("") == "1:1 | not valid JSON: the input is empty");
  CHECK(refusal(" \n\t\r\n ") == "3:1 | not valid JSON: the input is empty");
  CHECK(refusal("\xEF\xBB\xBF") == "1:3 | not valid JSON: the input is empty");
}

// The messages are those of nlohmann/json 3.11.2 and 3.11.3, parser.hpp.
TEST_CASE("JSON values: what is wrong is found in the messages of every release of the parser") {
  const std::string at = "[json.exception.parse_error.101] parse error at line 1, column 2: ";
  CHECK(parse_error_reason(at + "syntax error while parsing value - unexpected end of input; "
                                "expected '[', '{', or a literal") == "unexpected end of input");
  CHECK(parse_error_reason(at + "syntax error while parsing object key - invalid literal; "
                                "last read: 'x'") == "invalid literal");
  CHECK(parse_error_reason(at + "attempting to parse an empty input; check that your input string "
                                "or stream contains the expected JSON") ==
        "attempting to parse an empty input");
  CHECK(parse_error_reason("[json.exception.out_of_range.406] number overflow parsing '1e999'") ==
        "invalid number");
  CHECK(parse_error_reason(at + "syntax error while parsing value - invalid number; expected digit "
                                "after '-'; last read: '--'") == "invalid number");
}

TEST_CASE("JSON values: a key that occurs twice is refused with its pointer") {
  CHECK(refusal(R"({"a": 1, "a": 1})") == "/a | the key occurs twice");
  CHECK(refusal(R"({"x": [0, {"u": {}, "u": 2}]})") == "/x/1/u | the key occurs twice");
  CHECK(refusal(R"({"a": {"b": 1}, "c": {"b": 1}})") == "");
}

// Compared one by one, these keys would take minutes.
TEST_CASE("JSON values: an object of many keys is read in no time") {
  std::string text = "{\"0\": 0";
  for (int k = 1; k < 300'000; ++k) text += ", \"" + std::to_string(k) + "\": 0";
  CHECK(refusal(text + "}") == "");
  CHECK(refusal(text + ", \"777\": 0}") == "/777 | the key occurs twice");
}

TEST_CASE("JSON values: control characters in keys are not echoed") {
  CHECK(refusal(R"({"\u001b[1m\n": 1, "\u001b[1m\n": 2})") == "/?[1m? | the key occurs twice");
}

TEST_CASE("JSON values: nesting up to 32 levels is read, deeper is refused, however deep") {
  const auto nested = [](std::size_t n) { return std::string(n, '[') + std::string(n, ']'); };
  CHECK(refusal(nested(32)) == "");
  CHECK(refusal(nested(33)).find("nested deeper than 32 levels") != std::string::npos);
  CHECK(refusal(std::string(1'000'000, '[')).find("nested deeper than 32") != std::string::npos);
  CHECK(refusal("{\"a\": [0, " + nested(31) + "]}").starts_with("/a/1/0/0/0/"));
}

TEST_CASE("JSON values: descriptions say what stands there") {
  CHECK(description(parse_json("null")) == "null");
  CHECK(description(parse_json("true")) == "true");
  CHECK(description(parse_json("-1.5")) == "the number -1.5");
  CHECK(description(parse_json("\"a\\nb\"")) == "the string \"a?b\"");
  CHECK(description(parse_json("[1, 2]")) == "an array of 2");
  CHECK(description(parse_json("{\"a\": 1}")) == "an object of 1");
  CHECK(description(parse_json('"' + std::string(100, 'x') + '"')) ==
        "the string \"" + std::string(40, 'x') + "… (100 characters)\"");
}

}  // namespace json_value_test
