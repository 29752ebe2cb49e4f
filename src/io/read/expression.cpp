#include "phrame/io/read/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>
#include <vector>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/unreduced.hpp"
#include "phrame/io/read/operator_reader.hpp"

// Values are computed as soon as an operation is complete. A sum stays open for further summands
// while it is a left operand.

namespace phrame::inline v0 {
namespace {

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

bool is_function_name(std::string_view name) {
  static constexpr std::array names{
      "sin",  "cos",    "tan",    "cot",    "sec", "csc", "sinh", "cosh", "tanh", "asin", "acos",
      "atan", "arcsin", "arccos", "arctan", "exp", "log", "ln",   "sqrt", "cbrt", "root", "abs"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_constant(std::string_view name) {
  static constexpr std::array names{"pi", "π", "e", "i", "inf", "infinity", "oo", "nan"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

class Parser : OperatorReader {
 public:
  Parser(std::string_view text, const std::optional<std::string>& variable,
         const ExpressionLimits& limits)
      : OperatorReader(text, "a number, a variable or \"(\"", variable),
        limits_(limits.size),
        variable_option_(limits.variable_option) {}

  Expression parse();

 private:
  std::string quoted(const Operand& x) const {
    return in_quotes(text().substr(x.begin, x.end - x.begin));
  }
  void push_number(std::string_view number) override;
  void push_name(std::string_view name) override;
  void negate(std::size_t at) override;
  void combine(char sign) override;
  void raise(const Rational& exponent, std::size_t end) override;
  void enclose(std::size_t begin, std::size_t end, std::string_view function) override;
  std::string missing_operator(std::string_view left, std::string_view right) const override;

  bool is_only_name(std::string_view name) const;
  void push(Unreduced value, std::size_t length) {
    operands_.push_back({std::move(value), at(), at() + length});
  }
  void compute(char sign, Operand& left, Operand& right);
  void raise(Operand& base, const Rational& exponent, std::size_t exponent_at);
  template <class Compute>
  void within_limits(std::size_t begin, std::size_t end, Compute compute) const;

  SizeLimits limits_;
  std::string variable_option_;
  std::vector<Operand> operands_;
};

template <class Compute>
void Parser::within_limits(std::size_t begin, std::size_t end, Compute compute) const {
  try {
    compute();
  } catch (const Undecided& error) {
    fail(begin, fmt::format("{}: {}", in_quotes(text().substr(begin, end - begin)), error.what()));
  }
}

void Parser::raise(Operand& base, const Rational& exponent, std::size_t exponent_at) {
  if (denominator(exponent) != 1)
    fail(exponent_at, fmt::format("the exponent {} is not an integer", as_written(exponent)));
  Unreduced& value = base.factor();
  if (value.is_zero() && exponent == 0) fail(base.begin, "0 to the power 0 is undefined");
  if (value.is_zero() && exponent < 0)
    fail(base.begin, fmt::format("division by zero: {} is 0, its exponent negative", quoted(base)));
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
      if (x.is_zero()) fail(right.begin, fmt::format("division by zero: {}", quoted(right)));
      left.factor().divide(x, limits_);
      return;
    default: {
      const auto exponent = x.constant();
      if (!exponent)
        fail(right.begin, fmt::format("the exponent {} is not a number", quoted(right)));
      raise(left, *exponent, right.begin);
    }
  }
}

void Parser::negate(std::size_t at) {
  Operand& x = operands_.back();
  within_limits(x.begin, x.end, [&] { x.factor().negate(); });
  x.begin = at;
}

void Parser::combine(char sign) {
  Operand right = std::move(operands_.back());
  operands_.pop_back();
  Operand& left = operands_.back();
  within_limits(left.begin, right.end, [&] { compute(sign, left, right); });
  left.end = right.end;
}

void Parser::raise(const Rational& exponent, std::size_t end) {
  Operand& base = operands_.back();
  within_limits(base.begin, end, [&] { raise(base, exponent, at()); });
  base.end = end;
}

void Parser::enclose(std::size_t begin, std::size_t end, std::string_view) {
  Operand& inside = operands_.back();
  within_limits(inside.begin, inside.end, [&] { inside.factor(); });
  inside.begin = begin;
  inside.end = end;
}

void Parser::push_number(std::string_view number) {
  std::optional<Rational> value;
  try {
    value = parse_rational(number);
  } catch (const InputError& error) {
    // It is a number, so either it is too long or its exponent is.
    fail(at(), number.size() > max_number_length
                   ? error.reason()
                   : fmt::format("the exponent of {} exceeds {}", abbreviated(number),
                                 max_number_exponent));
  }
  push(Unreduced(*value), number.size());
}

/// What is no variable is refused; with what to do about it, for those who can choose that.
void Parser::push_name(std::string_view name) {
  const bool has_remedy = !variable_option_.empty();
  const std::string number = has_remedy ? ": write a number for it" : "";
  if (name != variable() && is_function_name(name))
    fail(at(), fmt::format("\"{}\": only rational functions are known", name));
  if (name != variable() && is_constant(name)) {
    std::string remedy;
    if (has_remedy && !variable_is_given())
      remedy = is_only_name(name)
                   ? fmt::format("; {} {} makes it the variable", variable_option_, name)
                   : number;
    fail(at(), fmt::format("\"{}\" is not a rational number{}", name, remedy));
  }
  take_variable(name, number,
                !has_remedy
                    ? ""
                    : fmt::format(": write a number for one of them ({} names the variable)",
                                  variable_option_));
  push(Unreduced::monomial(1, 1), name.size());
}

std::string Parser::missing_operator(std::string_view left, std::string_view right) const {
  const std::string shown = abbreviated(left);
  const std::string next = abbreviated(right);
  return fmt::format("no operator between \"{}\" and \"{}\": a product needs its sign, {}*{}",
                     shown, next,
                     shown == ")"                                      ? "(…)"
                     : first_token(left).kind == Token::Kind::exponent ? "…" + shown
                                                                       : shown,
                     next == "(" ? "(…)" : next);
}

/// In the whole text.
bool Parser::is_only_name(std::string_view name) const {
  std::string_view rest = text();
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    const Token token = first_token(rest);
    if (token.kind == Token::Kind::end) return true;
    if (token.kind == Token::Kind::name && token.text != name) return false;
    rest.remove_prefix(token.text.size());
  }
}

Expression Parser::parse() {
  read();
  Operand& all = operands_.front();
  Expression result{{}, variable()};
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
