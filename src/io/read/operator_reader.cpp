#include "phrame/io/read/operator_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace phrame::inline v0 {
namespace {

constexpr auto ambiguous_exponent = "one exponent after another: parentheses are needed";

bool is_raised(std::string_view token) { return first_token(token).kind == Token::Kind::exponent; }

}  // namespace

std::size_t OperatorReader::after_blanks(std::size_t at) const {
  return std::min(text_.find_first_not_of(blanks, at), text_.size());
}

void OperatorReader::read() {
  for (;;) {
    at_ = after_blanks(at_);
    Token token = first_token(text_.substr(at_));
    if (operand_is_next_)
      token = read_operand(token);
    else if (token.kind == Token::Kind::end)
      break;
    else
      read_operator(token);
    before_ = token.text;
    at_ += token.text.size();
  }
  while (!operations_.empty()) {
    if (operations_.back().sign == '(') fail(operations_.back().at, "this \"(\" is never closed");
    reduce();
  }
}

/// The last token that belongs to it.
Token OperatorReader::read_operand(const Token& token) {
  using TokenKind = Token::Kind;
  if (token.kind == TokenKind::name) {
    const std::size_t behind = after_blanks(at_ + token.text.size());
    const Token next = first_token(text_.substr(behind));
    if (next.sign == '(' && is_function(token.text)) {
      operations_.push_back({'(', at_, token.text});
      at_ = behind;
      return next;
    }
  }
  if (token.kind == TokenKind::number || token.kind == TokenKind::name) {
    token.kind == TokenKind::number ? push_number(token.text) : push_name(token.text);
    has_operand_ = true;
    operand_is_next_ = false;
    return token;
  }
  if (token.sign == '(' || token.sign == '-') {
    operations_.push_back({token.sign == '-' ? '~' : '(', at_});
    return token;
  }
  if (token.sign == '+') return token;
  if (token.kind != TokenKind::end)
    fail(at_, fmt::format("{} where {} is expected", in_quotes(token.text), operand_names_));
  fail(at_, !has_operand_ && operations_.empty()
                ? "the expression is empty"
                : fmt::format("the expression ends where {} is expected", operand_names_));
}

void OperatorReader::read_operator(const Token& token) {
  if (token.kind == Token::Kind::exponent) return read_raised_digits(token.text);
  if (token.sign == ')') return close_parenthesis();
  if (token.kind == Token::Kind::other)
    fail(at_, fmt::format("{} is not understood", in_quotes(token.text)));
  if (token.sign == 0 || token.sign == '(') fail(at_, missing_operator(before_, token.text));
  const bool groups_right = token.sign == '^';
  if (groups_right && is_raised(before_)) fail(at_, ambiguous_exponent);
  const int rank = precedence(token.sign) + (groups_right ? 1 : 0);
  while (!operations_.empty() && precedence(operations_.back().sign) >= rank) reduce();
  operations_.push_back({token.sign, at_});
  operand_is_next_ = true;
}

/// "x²".
void OperatorReader::read_raised_digits(std::string_view digits) {
  if (is_raised(before_) || (!operations_.empty() && operations_.back().sign == '^'))
    fail(at_, ambiguous_exponent);
  std::optional<Rational> exponent;
  try {
    exponent = parse_rational(plain_digits(digits));
  } catch (const InputError&) {
    fail(at_, fmt::format("{} is not an exponent", in_quotes(digits)));
  }
  raise(*exponent, at_ + digits.size());
}

void OperatorReader::close_parenthesis() {
  while (!operations_.empty() && operations_.back().sign != '(') reduce();
  if (operations_.empty()) fail(at_, "there is no \"(\" for this \")\"");
  const Operation parenthesis = operations_.back();
  operations_.pop_back();
  enclose(parenthesis.at, at_ + 1, parenthesis.function);
}

void OperatorReader::take_variable(std::string_view name, const std::string& of_given,
                                   const std::string& of_second) {
  if (name == variable_) return;
  if (variable_is_given_ && variable_.empty())
    fail(at_, fmt::format("{} where a number is expected", in_quotes(name)));
  if (variable_is_given_)
    fail(at_, fmt::format("{} is not the variable {}{}", in_quotes(name), in_quotes(variable_),
                          of_given));
  if (!variable_.empty())
    fail(at_, fmt::format("a second variable, {} beside {}{}", in_quotes(name),
                          in_quotes(variable_), of_second));
  variable_ = name;
}

/// Carries out the last operation.
void OperatorReader::reduce() {
  const Operation operation = operations_.back();
  operations_.pop_back();
  operation.sign == '~' ? negate(operation.at) : combine(operation.sign);
}

}  // namespace phrame
