#include "phrame/io/read/expression_token.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace phrame;

namespace {

/// Each token with a mark of its kind: 12# x_ +' ⁴^ ?!
std::vector<std::string> tokens(std::string_view text) {
  std::vector<std::string> found;
  for (;;) {
    const Token token = first_token(text);
    if (token.kind == Token::Kind::end) return found;
    CHECK((token.kind == Token::Kind::sign) == (token.sign != 0));
    found.push_back(std::string(token.text) + "#_'^!"[static_cast<int>(token.kind)]);
    text.remove_prefix(token.text.size());
  }
}

using Tokens = std::vector<std::string>;

}  // namespace

TEST_CASE("expression tokens: an exponent belongs to a number only with its digits") {
  CHECK(tokens("1.5e-3") == Tokens{"1.5e-3#"});
  CHECK(tokens("2E5") == Tokens{"2E5#"});
  CHECK(tokens("2e") == Tokens{"2#", "e_"});
  CHECK(tokens("2e+x") == Tokens{"2#", "e_", "+'", "x_"});
  CHECK(tokens(".5") == Tokens{".5#"});
  CHECK(tokens("5.") == Tokens{"5.#"});
  CHECK(tokens(".") == Tokens{".!"});
  CHECK(tokens("1.2.3") == Tokens{"1.2#", ".3#"});
}

TEST_CASE("expression tokens: hexadecimal numbers") {
  CHECK(tokens("0x1.8p-3") == Tokens{"0x1.8p-3#"});
  CHECK(tokens("0xFe") == Tokens{"0xFe#"});
  CHECK(tokens("0x") == Tokens{"0#", "x_"});
  CHECK(tokens("0x1p") == Tokens{"0x1#", "p_"});
  CHECK(tokens("1x2") == Tokens{"1#", "x2_"});
}

TEST_CASE("expression tokens: names are of Latin and Greek letters, digits and _") {
  CHECK(tokens("x1+t_2") == Tokens{"x1_", "+'", "t_2_"});
  CHECK(tokens("θ·é") == Tokens{"θ_", "·'", "é_"});
  CHECK(tokens("λ∞") == Tokens{"λ_", "∞!"});
  CHECK(tokens("_") == Tokens{"__"});
}

TEST_CASE("expression tokens: every character for an operation is its sign") {
  for (const auto& [text, sign] :
       {std::pair("**", '^'), std::pair("^", '^'), std::pair("−", '-'), std::pair("-", '-'),
        std::pair("·", '*'), std::pair("⋅", '*'), std::pair("×", '*'), std::pair("÷", '/')}) {
    const Token token = first_token(text);
    CAPTURE(token.text);
    CHECK(token.kind == Token::Kind::sign);
    CHECK(token.sign == sign);
    CHECK(token.text == text);
  }
  CHECK(tokens("***") == Tokens{"**'", "*'"});
}

TEST_CASE("expression tokens: superscripts are one exponent") {
  CHECK(tokens("t⁻¹²") == Tokens{"t_", "⁻¹²^"});
  CHECK(plain_digits("⁻¹²") == "-12");
  CHECK(plain_digits("⁰³⁴⁵⁶⁷⁸⁹") == "03456789");
}

TEST_CASE("expression tokens: bytes that are not UTF-8 stand alone") {
  CHECK(tokens("\xC3") == Tokens{"\xC3!"});
  CHECK(tokens("\xE2\x88x") == Tokens{"\xE2!", "\x88!", "x_"});
  CHECK(tokens("\xFF\x80") == Tokens{"\xFF!", "\x80!"});
  CHECK(tokens(std::string_view("\0", 1)) == Tokens{std::string("\0!", 2)});
  CHECK(in_quotes("\xC3") == "the byte 0xC3");
  CHECK(in_quotes("é\n") == "\"é?\"");
}

TEST_CASE("expression tokens: columns count characters from 1") {
  CHECK(column_of("θ²+x", 0) == "column 1");
  CHECK(column_of("θ²+x", 4) == "column 3");
  CHECK(column_of("θ²+x", 6) == "column 5");
}
