#pragma once
#include <string>
#include <string_view>

namespace phrame::inline v0 {

/// What may stand between the tokens of an expression.
inline constexpr std::string_view blanks = " \t\r\n";

/// A piece of an expression.
struct Token {
  enum class Kind {
    number,    ///< 12, .5, 1e-3, 0x1.8p-3
    name,      ///< x, t_1, θ
    sign,      ///< + - * / ^ ( ), whatever the character for it
    exponent,  ///< a superscript: ⁴, ⁻¹²
    other,     ///< one character of no meaning here
    end,
  };
  Kind kind;
  std::string_view text;  ///< as it was written
  char sign = 0;          ///< of Kind::sign: one of + - * / ^ ( )
};

/// The token at the beginning of `rest`, which does not begin with a blank. Never empty but at the
/// end. Any bytes will do.
Token first_token(std::string_view rest);

/// How tightly an operation binds its operands: + - * / ^, and '~' for the negative of one; 0 for
/// what is none. −x^2 is −(x^2), and x^-2 is possible because a prefix sign waits whatever stands
/// before it.
int precedence(char sign);

/// The value of a Kind::exponent.
std::string plain_digits(std::string_view superscript);

/// Where in `text` the byte `offset` is, for an InputError: "column N".
std::string column_of(std::string_view text, std::size_t offset);

/// The piece of a text that a message quotes: abbreviated, in quotation marks; where it is not
/// UTF-8, its first byte.
std::string in_quotes(std::string_view text);

}  // namespace phrame
