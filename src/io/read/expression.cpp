#include "phrame/io/read/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>
#include <vector>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/expression_token.hpp"

// Operator precedence with two stacks (Dijkstra's shunting yard): nothing recurses, so that no
// depth of parentheses, signs or exponents is too much. Values are computed as soon as an operation
// is complete. A sum stays open for further summands while it is a left operand.

namespace phrame {
namespace {

struct Operation {
  char sign;  ///< + - * / ^, '~' for the negative of one operand, '(' for a parenthesis
  std::size_t at;
};

struct Operand {
  std::variant<Unreduced, UnreducedSum> value;
  std::size_t begin;  ///< the piece of the text that it is the value of
  std::size_t end;

  Unreduced& factor() {
    if (const auto* sum = std::get_if<UnreducedSum>(&value)) value = sum->total();
    return std::get<Unreduced>(value);
  }
  UnreducedSum& sum(const SizeLimits& limits) {
    if (const auto* first = std::get_if<Unreduced>(&value)) value = UnreducedSum(*first, limits);
    return std::get<UnreducedSum>(value);
  }
};

bool is_function(std::string_view name) {
  static constexpr std::array names{
      "sin",  "cos",    "tan",    "cot",    "sec", "csc", "sinh", "cosh", "tanh", "asin", "acos",
      "atan", "arcsin", "arccos", "arctan", "exp", "log", "ln",   "sqrt", "cbrt", "root", "abs"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_constant(std::string_view name) {
  static constexpr std::array names{"pi", "π", "e", "i", "inf", "infinity", "oo", "nan"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

class Parser {
 public:
  Parser(std::string_view text, const std::optional<std::string>& variable,
         const ExpressionLimits& limits)
      : text_(text),
        variable_(variable.value_or("")),
        variable_is_given_(variable.has_value()),
        limits_(limits.size),
        variable_option_(limits.variable_option) {}

  Expression parse();

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& reason) const {
    throw InputError(column_of(text_, at), reason);
  }
  std::string_view text_of(const Operand& x) const {
    return text_.substr(x.begin, x.end - x.begin);
  }

  void skip_blanks();
  bool is_only_name(std::string_view name) const;
  void read_operand(const Token& token);
  void read_operator(const Token& token);
  void refuse_in_place_of_operator(const Token& token) const;
  void read_number(std::string_view number);
  void read_name(std::string_view name);
  [[noreturn]] void refuse_name(std::string_view name) const;
  void read_raised_digits(std::string_view digits);
  void close_parenthesis();

  void push(Unreduced value, std::size_t length) {
    operands_.push_back({std::move(value), at_, at_ + length});
    operand_is_next_ = false;
  }
  /// Carries out the last operation.
  void reduce();
  void compute(char sign, Operand& left, Operand& right);
  void raise(Operand& base, const Rational& exponent, std::size_t exponent_at);
  template <class Compute>
  void within_limits(std::size_t begin, std::size_t end, Compute compute) const;

  std::string_view text_;
  std::size_t at_ = 0;
  std::string_view before_;  ///< the last token
  bool operand_is_next_ = true;
  std::string variable_;
  bool variable_is_given_;
  SizeLimits limits_;
  std::string variable_option_;
  std::vector<Operand> operands_;
  std::vector<Operation> operations_;
};

template <class Compute>
void Parser::within_limits(std::size_t begin, std::size_t end, Compute compute) const {
  try {
    compute();
  } catch (const Undecided& error) {
    fail(begin, fmt::format("{}: {}", in_quotes(text_.substr(begin, end - begin)), error.what()));
  }
}

void Parser::raise(Operand& base, const Rational& exponent, std::size_t exponent_at) {
  if (denominator(exponent) != 1)
    fail(exponent_at, fmt::format("the exponent {} is not an integer", as_written(exponent)));
  Unreduced& value = base.factor();
  if (value.is_zero() && exponent == 0) fail(base.begin, "0 to the power 0 is undefined");
  if (value.is_zero() && exponent < 0)
    fail(base.begin,
         fmt::format("division by zero: {} is 0, its exponent negative", in_quotes(text_of(base))));
  value.raise(numerator(exponent), limits_);
}

void Parser::compute(char sign, Operand& left, Operand& right) {
  Unreduced& x = right.factor();
  switch (sign) {
    case '-':
      x.negate();
      [[fallthrough]];
    case '+':
      left.sum(limits_).add(x);
      return;
    case '*':
      left.factor().multiply(x, limits_);
      return;
    case '/':
      if (x.is_zero())
        fail(right.begin, fmt::format("division by zero: {}", in_quotes(text_of(right))));
      left.factor().divide(x, limits_);
      return;
    default: {
      const auto exponent = x.constant();
      if (!exponent)
        fail(right.begin,
             fmt::format("the exponent {} is not a number", in_quotes(text_of(right))));
      raise(left, *exponent, right.begin);
    }
  }
}

void Parser::reduce() {
  const Operation operation = operations_.back();
  operations_.pop_back();
  if (operation.sign == '~') {
    Operand& x = operands_.back();
    within_limits(x.begin, x.end, [&] { x.factor().negate(); });
    x.begin = operation.at;
    return;
  }
  Operand right = std::move(operands_.back());
  operands_.pop_back();
  Operand& left = operands_.back();
  within_limits(left.begin, right.end, [&] { compute(operation.sign, left, right); });
  left.end = right.end;
}

void Parser::read_number(std::string_view number) {
  std::optional<Rational> value;
  try {
    value = parse_rational(number);
  } catch (const InputError& error) {
    // It is a number, so either it is too long or its exponent is.
    fail(at_, number.size() > max_number_length
                  ? error.reason()
                  : fmt::format("the exponent of {} exceeds {}", abbreviated(number),
                                max_number_exponent));
  }
  push(Unreduced(*value), number.size());
}

void Parser::read_name(std::string_view name) {
  if (name != variable_) {
    const bool is_free = variable_.empty() && !variable_is_given_;
    if (!is_free || is_function(name) || is_constant(name)) refuse_name(name);
    variable_ = name;
  }
  push(Unreduced::monomial(1, 1), name.size());
}

/// Says why the name is not the variable and, to those who can choose that, what to do about it.
void Parser::refuse_name(std::string_view name) const {
  const bool has_remedy = !variable_option_.empty();
  const std::string number = has_remedy ? ": write a number for it" : "";
  if (is_function(name)) fail(at_, fmt::format("\"{}\": only rational functions are known", name));
  if (is_constant(name)) {
    std::string remedy;
    if (has_remedy && !variable_is_given_)
      remedy = is_only_name(name)
                   ? fmt::format("; {} {} makes it the variable", variable_option_, name)
                   : number;
    fail(at_, fmt::format("\"{}\" is not a rational number{}", name, remedy));
  }
  if (!variable_is_given_)
    fail(at_,
         fmt::format("a second variable, {} beside {}{}", in_quotes(name), in_quotes(variable_),
                     !has_remedy ? ""
                                 : fmt::format(": write a number for one of them ({} names the "
                                               "variable)",
                                               variable_option_)));
  if (variable_.empty()) fail(at_, fmt::format("{} where a number is expected", in_quotes(name)));
  fail(at_,
       fmt::format("{} is not the variable {}{}", in_quotes(name), in_quotes(variable_), number));
}

void Parser::read_operand(const Token& token) {
  if (token.kind == Token::Kind::number) return read_number(token.text);
  if (token.kind == Token::Kind::name) return read_name(token.text);
  switch (token.sign) {
    case '(':
      operations_.push_back({'(', at_});
      return;
    case '-':
      operations_.push_back({'~', at_});
      return;
    case '+':
      return;
    default:
      break;
  }
  constexpr auto expected = "a number, a variable or \"(\" is expected";
  if (token.kind != Token::Kind::end)
    fail(at_, fmt::format("{} where {}", in_quotes(token.text), expected));
  fail(at_, operands_.empty() && operations_.empty()
                ? "the expression is empty"
                : fmt::format("the expression ends where {}", expected));
}

void Parser::close_parenthesis() {
  while (!operations_.empty() && operations_.back().sign != '(') reduce();
  if (operations_.empty()) fail(at_, "there is no \"(\" for this \")\"");
  Operand& inside = operands_.back();
  within_limits(inside.begin, inside.end, [&] { inside.factor(); });
  inside.begin = operations_.back().at;
  inside.end = at_ + 1;
  operations_.pop_back();
}

void Parser::refuse_in_place_of_operator(const Token& token) const {
  if (token.kind == Token::Kind::other)
    fail(at_, fmt::format("{} is not understood", in_quotes(token.text)));
  const std::string left = abbreviated(before_);
  const std::string right = abbreviated(token.text);
  fail(at_, fmt::format("no operator between \"{}\" and \"{}\": a product needs its sign, {}*{}",
                        left, right,
                        left == ")"                                          ? "(…)"
                        : first_token(before_).kind == Token::Kind::exponent ? "…" + left
                                                                             : left,
                        right == "(" ? "(…)" : right));
}

constexpr auto ambiguous_exponent = "one exponent after another: parentheses are needed";

/// "x²".
void Parser::read_raised_digits(std::string_view digits) {
  if (!operations_.empty() && operations_.back().sign == '^') fail(at_, ambiguous_exponent);
  std::optional<Rational> exponent;
  try {
    exponent = parse_rational(plain_digits(digits));
  } catch (const InputError&) {
    fail(at_, fmt::format("{} is not an exponent", in_quotes(digits)));
  }
  Operand& base = operands_.back();
  const std::size_t end = at_ + digits.size();
  within_limits(base.begin, end, [&] { raise(base, *exponent, at_); });
  base.end = end;
}

void Parser::read_operator(const Token& token) {
  if (token.kind == Token::Kind::exponent) return read_raised_digits(token.text);
  if (token.sign == ')') return close_parenthesis();
  if (token.sign == 0 || token.sign == '(') refuse_in_place_of_operator(token);
  const int rank = precedence(token.sign);
  const bool groups_right = token.sign == '^';
  if (groups_right && first_token(before_).kind == Token::Kind::exponent)
    fail(at_, ambiguous_exponent);
  while (!operations_.empty() &&
         precedence(operations_.back().sign) >= (groups_right ? rank + 1 : rank))
    reduce();
  operations_.push_back({token.sign, at_});
  operand_is_next_ = true;
}

void Parser::skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }

/// In the whole text.
bool Parser::is_only_name(std::string_view name) const {
  std::string_view rest = text_;
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    const Token token = first_token(rest);
    if (token.kind == Token::Kind::end) return true;
    if (token.kind == Token::Kind::name && token.text != name) return false;
    rest.remove_prefix(token.text.size());
  }
}

Expression Parser::parse() {
  for (;;) {
    skip_blanks();
    const Token token = first_token(text_.substr(at_));
    if (operand_is_next_)
      read_operand(token);
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
  Operand& all = operands_.front();
  Expression result{{}, variable_};
  within_limits(all.begin, all.end, [&] { result.value = all.factor().reduced(limits_); });
  return result;
}

}  // namespace

bool is_variable_name(std::string_view text) {
  const Token name = first_token(text);
  return name.kind == Token::Kind::name && name.text == text;
}

Expression parse_expression(std::string_view text, const std::optional<std::string>& variable,
                            const ExpressionLimits& limits) {
  if (text.size() > limits.max_length)
    throw InputError("column 1", fmt::format("the expression has {} bytes, the limit is {}",
                                             text.size(), limits.max_length));
  if (variable && !variable->empty() && !is_variable_name(*variable))
    throw InputError(fmt::format("{} is not the name of a variable", in_quotes(*variable)));
  return Parser(text, variable, limits).parse();
}

}  // namespace phrame
