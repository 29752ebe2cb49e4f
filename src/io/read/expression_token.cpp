#include "phrame/io/read/expression_token.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "phrame/algebra/rational.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hexadecimal(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

struct Character {
  char32_t code;      ///< 0 where the bytes are not UTF-8
  std::size_t bytes;  ///< ≥ 1
};

/// Without the subtleties: overlong forms and surrogates are no letters or signs of ours anyway.
Character first_character(std::string_view rest) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(rest[k]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t n = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 0;
  if (n == 0 || n > rest.size()) return {0, 1};
  char32_t code = lead & (0x7FU >> n);
  for (std::size_t k = 1; k < n; ++k) {
    if ((byte(k) & 0xC0U) != 0x80U) return {0, 1};
    code = (code << 6U) | (byte(k) & 0x3FU);
  }
  return {code, n};
}

bool is_letter(char32_t c) {
  return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || c == U'_' ||
         (c >= U'À' && c <= U'ɏ' && c != U'×' && c != U'÷') || (c >= U'Ͱ' && c <= U'Ͽ');
}

char sign_of(char32_t c) {
  switch (c) {
    case U'−':
      return '-';
    case U'·':
    case U'⋅':
    case U'×':
      return '*';
    case U'÷':
      return '/';
    default:
      return c < 0x80 && std::string_view("+-*/^()").find(static_cast<char>(c)) !=
                             std::string_view::npos
                 ? static_cast<char>(c)
                 : '\0';
  }
}

/// '0' … '9' or '-'; 0 for what is no superscript.
char plain(char32_t superscript) {
  static constexpr std::u32string_view digits = U"⁰¹²³⁴⁵⁶⁷⁸⁹⁻";
  const auto at = digits.find(superscript);
  return at == std::u32string_view::npos ? '\0' : "0123456789-"[at];
}

/// The bytes of the characters at the beginning that `accept`.
template <class Accept>
std::size_t length_of(std::string_view rest, Accept accept) {
  std::size_t n = 0;
  while (n < rest.size()) {
    const Character c = first_character(rest.substr(n));
    if (!accept(c.code)) break;
    n += c.bytes;
  }
  return n;
}

/// The length of the number at the beginning; 0 where there is none. An e or p belongs to it only
/// with digits behind.
std::size_t number_length(std::string_view rest) {
  const bool hexadecimal = rest.size() > 2 && rest[0] == '0' &&
                           (rest[1] == 'x' || rest[1] == 'X') && is_hexadecimal(rest[2]);
  std::size_t n = hexadecimal ? 2 : 0;
  std::size_t count = 0;
  const auto digits = [&](bool wide) {
    for (; n < rest.size() && (wide ? is_hexadecimal(rest[n]) : is_digit(rest[n])); ++n) ++count;
  };
  digits(hexadecimal);
  if (n < rest.size() && rest[n] == '.') {
    ++n;
    digits(hexadecimal);
  }
  if (count == 0) return 0;
  if (n < rest.size() && (rest[n] | 0x20) == (hexadecimal ? 'p' : 'e')) {
    const std::size_t mantissa = n++;
    if (n < rest.size() && (rest[n] == '+' || rest[n] == '-')) ++n;
    count = 0;
    digits(false);
    if (count == 0) n = mantissa;
  }
  return n;
}

}  // namespace

Token first_token(std::string_view rest) {
  using TokenKind = Token::Kind;
  if (rest.empty()) return {TokenKind::end, rest};
  if (const auto n = number_length(rest); n > 0) return {TokenKind::number, rest.substr(0, n)};
  const Character c = first_character(rest);
  if (is_letter(c.code))
    return {TokenKind::name, rest.substr(0, length_of(rest, [](char32_t code) {
                                           return is_letter(code) || (code >= U'0' && code <= U'9');
                                         }))};
  if (rest.starts_with("**")) return {TokenKind::sign, rest.substr(0, 2), '^'};
  if (const char sign = sign_of(c.code); sign != 0)
    return {TokenKind::sign, rest.substr(0, c.bytes), sign};
  if (plain(c.code) != 0)
    return {TokenKind::exponent,
            rest.substr(0, length_of(rest, [](char32_t code) { return plain(code) != 0; }))};
  return {TokenKind::other, rest.substr(0, c.bytes)};
}

std::string plain_digits(std::string_view superscript) {
  std::string digits;
  while (!superscript.empty()) {
    const Character c = first_character(superscript);
    digits += plain(c.code);
    superscript.remove_prefix(c.bytes);
  }
  return digits;
}

std::string column_of(std::string_view text, std::size_t offset) {
  return fmt::format("column {}", text_width(text.substr(0, offset)) + 1);
}

std::string in_quotes(std::string_view text) {
  for (std::string_view rest = text; !rest.empty();) {
    const Character c = first_character(rest);
    if (c.code == 0)
      return fmt::format("the byte 0x{:02X}", static_cast<unsigned char>(rest.front()));
    rest.remove_prefix(c.bytes);
  }
  return "\"" + abbreviated(text) + "\"";
}

int precedence(char sign) {
  switch (sign) {
    case '+':
    case '-':
      return 1;
    case '*':
    case '/':
      return 2;
    case '~':
      return 3;
    case '^':
      return 4;
    default:
      return 0;
  }
}

}  // namespace phrame
