#include "phrame/io/read/formula.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/io/read/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/io/read/expression_token.hpp"

// Operator precedence with two stacks, as io/read/expression: nothing recurses. A function is an
// operation that waits below its parenthesis.

namespace phrame {
namespace {

using FormulaOp = Formula::Operation;

/// A value that is complete.
struct FormulaOperand {
  std::size_t step = 0;
  std::size_t begin = 0;                ///< in the text
  std::optional<Rational> number = {};  ///< where it is one
  bool is_e = false;                    ///< exp 1
};

/// An operation that waits for its right operand.
struct WaitingOperation {
  char sign;  ///< + - * / ^, '~' for a negative, '(' for a parenthesis
  std::size_t at;
  std::string_view function = {};  ///< of a parenthesis
};

constexpr std::array function_names{"sin",  "cos",    "tan",  "cot",  "sec",  "csc",
                                    "exp",  "log",    "ln",   "sqrt", "asin", "acos",
                                    "atan", "arctan", "sinh", "cosh", "tanh"};

bool is_known_function(std::string_view name) {
  return std::find(function_names.begin(), function_names.end(), name) != function_names.end();
}

/// The steps of the value, as they come.
class StepList {
 public:
  std::size_t number(const Rational& x, const Rational& pi_multiple = 0) {
    return push({FormulaOp::number, 0, 0, x, pi_multiple});
  }
  std::size_t variable() { return push({FormulaOp::variable, 0, 0, 0, 0}); }
  std::size_t make(FormulaOp operation, std::size_t left, std::size_t right = 0) {
    return push({operation, left, right, 0, 0});
  }
  std::size_t power(std::size_t left, const Rational& exponent) {
    return push({FormulaOp::power, left, 0, exponent, 0});
  }
  std::size_t negative(std::size_t x) { return make(FormulaOp::multiply, number(-1), x); }
  std::size_t inverse(std::size_t x) { return make(FormulaOp::divide, number(1), x); }
  std::size_t apply(std::string_view function, std::size_t x);

  std::vector<Formula::Step>& steps() { return steps_; }

 private:
  std::size_t push(Formula::Step step) {
    steps_.push_back(std::move(step));
    return steps_.size() - 1;
  }
  std::size_t quotient(FormulaOp above, FormulaOp below, std::size_t x) {
    const std::size_t numerator = make(above, x);
    return make(FormulaOp::divide, numerator, make(below, x));
  }
  std::size_t hyperbolic(std::string_view function, std::size_t x);
  std::size_t arc(std::string_view function, std::size_t x);

  std::vector<Formula::Step> steps_;
};

/// sinh = (eˣ − e⁻ˣ)/2, cosh = (eˣ + e⁻ˣ)/2, tanh = (eˣ − e⁻ˣ)/(eˣ + e⁻ˣ).
std::size_t StepList::hyperbolic(std::string_view function, std::size_t x) {
  const std::size_t up = make(FormulaOp::exp, x);
  const std::size_t down = make(FormulaOp::exp, negative(x));
  const std::size_t sum = make(FormulaOp::add, up, down);
  const std::size_t difference = make(FormulaOp::add, up, negative(down));
  if (function == "tanh") return make(FormulaOp::divide, difference, sum);
  return make(FormulaOp::divide, function == "sinh" ? difference : sum, number(2));
}

/// asin x = atan(x/√(1 − x²)), acos x = π/2 − asin x, for |x| < 1.
std::size_t StepList::arc(std::string_view function, std::size_t x) {
  const std::size_t rest = make(FormulaOp::add, number(1), negative(power(x, 2)));
  const std::size_t sine = make(FormulaOp::divide, x, make(FormulaOp::sqrt, rest));
  const std::size_t angle = make(FormulaOp::atan, sine);
  if (function == "asin") return angle;
  return make(FormulaOp::add, number(0, Rational(1, 2)), negative(angle));
}

std::size_t StepList::apply(std::string_view function, std::size_t x) {
  if (function == "sin") return make(FormulaOp::sin, x);
  if (function == "cos") return make(FormulaOp::cos, x);
  if (function == "tan") return quotient(FormulaOp::sin, FormulaOp::cos, x);
  if (function == "cot") return quotient(FormulaOp::cos, FormulaOp::sin, x);
  if (function == "sec") return inverse(make(FormulaOp::cos, x));
  if (function == "csc") return inverse(make(FormulaOp::sin, x));
  if (function == "exp") return make(FormulaOp::exp, x);
  if (function == "log" || function == "ln") return make(FormulaOp::log, x);
  if (function == "sqrt") return make(FormulaOp::sqrt, x);
  if (function == "atan" || function == "arctan") return make(FormulaOp::atan, x);
  return function.ends_with('h') ? hyperbolic(function, x) : arc(function, x);
}

class FormulaParser {
 public:
  FormulaParser(std::string_view text, const std::optional<std::string>& variable)
      : text_(text), variable_(variable.value_or("")), variable_is_given_(variable.has_value()) {}

  GivenFormula parse();

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& reason) const {
    throw InputError(column_of(text_, at), reason);
  }
  Token next_token();
  void read_operand(const Token& token);
  void read_operator(const Token& token);
  void read_number(std::string_view number);
  void read_name(std::string_view name);
  void read_raised_digits(std::string_view digits);
  void open_function(std::string_view name);
  void close_parenthesis();
  [[noreturn]] void refuse_operator(const Token& token) const;

  void push(const FormulaOperand& operand) {
    operands_.push_back(operand);
    operand_is_next_ = false;
  }
  /// Carries out the last operation.
  void reduce();
  void compute(char sign, FormulaOperand& left, const FormulaOperand& right);
  void raise(FormulaOperand& base, const FormulaOperand& exponent);

  std::string_view text_;
  std::size_t at_ = 0;
  std::string_view before_;
  bool operand_is_next_ = true;
  std::string variable_;
  bool variable_is_given_;
  StepList list_;
  std::vector<FormulaOperand> operands_;
  std::vector<WaitingOperation> operations_;
};

Token FormulaParser::next_token() {
  at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
  return first_token(text_.substr(at_));
}

constexpr long most_bits_of_exponent = 4096;  // of what is one, perhaps

/// What is a number again, so that 2^(10^9) has an exponent that is too large.
std::optional<Rational> short_power(const std::optional<Rational>& base, const Rational& k) {
  if (!base || denominator(k) != 1 || k < 0 || k * bits_of(*base) > most_bits_of_exponent)
    return std::nullopt;
  const auto n = static_cast<unsigned long>(static_cast<long>(numerator(k)));
  return Rational(pow(numerator(*base), n), pow(denominator(*base), n));
}

void FormulaParser::raise(FormulaOperand& base, const FormulaOperand& exponent) {
  std::optional<Rational> value;
  if (exponent.number) {
    const Rational& k = *exponent.number;
    if (numerator(abs(k)) > max_exponent || denominator(k) > max_exponent)
      fail(exponent.begin, fmt::format("the exponent {} is too large: its numerator and "
                                       "denominator are at most {}",
                                       as_written(k), max_exponent));
    base.step = list_.power(base.step, k);
    value = short_power(base.number, k);
  } else {
    const std::size_t log = base.is_e ? list_.number(1) : list_.make(FormulaOp::log, base.step);
    base.step = list_.make(FormulaOp::exp, list_.make(FormulaOp::multiply, exponent.step, log));
  }
  base.number = std::move(value);
}

void FormulaParser::compute(char sign, FormulaOperand& left, const FormulaOperand& right) {
  if (sign == '^') return raise(left, right);
  const bool are_numbers = left.number && right.number &&
                           bits_of(*left.number) + bits_of(*right.number) <= most_bits_of_exponent;
  if (sign == '/') {
    if (right.number && *right.number == 0) fail(right.begin, "division by zero");
    left.step = list_.make(FormulaOp::divide, left.step, right.step);
    left.number = are_numbers ? std::optional(*left.number / *right.number) : std::nullopt;
  } else if (sign == '*') {
    left.step = list_.make(FormulaOp::multiply, left.step, right.step);
    left.number = are_numbers ? std::optional(*left.number * *right.number) : std::nullopt;
  } else {
    const bool is_sum = sign == '+';
    left.step =
        list_.make(FormulaOp::add, left.step, is_sum ? right.step : list_.negative(right.step));
    left.number = !are_numbers ? std::nullopt
                  : is_sum     ? std::optional(*left.number + *right.number)
                               : std::optional(*left.number - *right.number);
  }
}

void FormulaParser::reduce() {
  const WaitingOperation operation = operations_.back();
  operations_.pop_back();
  if (operation.sign == '~') {
    FormulaOperand& x = operands_.back();
    x = {list_.negative(x.step), operation.at, x.number ? std::optional(-*x.number) : std::nullopt};
    return;
  }
  const FormulaOperand right = operands_.back();
  operands_.pop_back();
  compute(operation.sign, operands_.back(), right);
  operands_.back().is_e = false;
}

void FormulaParser::read_number(std::string_view number) {
  std::optional<Rational> value;
  try {
    value = parse_rational(number);
    refuse_long_number(*value, number);
  } catch (const InputError& error) {
    fail(at_, error.reason());
  }
  push({list_.number(*value), at_, value});
}

void FormulaParser::read_name(std::string_view name) {
  if (is_known_function(name)) {
    // A variable may be called what it likes, but for this.
    fail(at_, fmt::format("the function {} needs its argument in parentheses: {}(…)", name, name));
  }
  if (name == "pi" || name == "π") return push({list_.number(0, 1), at_});
  if (name == "e" && variable_ != "e")
    return push({list_.make(FormulaOp::exp, list_.number(1)), at_, {}, true});
  if (name != variable_) {
    if (variable_is_given_ && variable_.empty())
      fail(at_, fmt::format("{} where a number is expected", in_quotes(name)));
    if (variable_is_given_)
      fail(at_, fmt::format("{} is not the variable {}", in_quotes(name), in_quotes(variable_)));
    if (!variable_.empty())
      fail(at_,
           fmt::format("a second variable, {} beside {}", in_quotes(name), in_quotes(variable_)));
    variable_ = name;
  }
  push({list_.variable(), at_});
}

/// Is a "(" behind the name, so that it is a function?
void FormulaParser::open_function(std::string_view name) {
  const std::size_t begin = at_;
  if (!is_known_function(name) && name != variable_)
    fail(at_, fmt::format("{} is not a function that is known: {}", in_quotes(name),
                          fmt::join(function_names, ", ")));
  at_ += name.size();
  const Token parenthesis = next_token();
  if (name == variable_ && !is_known_function(name)) {
    before_ = name;
    refuse_operator(parenthesis);
  }
  operations_.push_back({'(', begin, name});
}

void FormulaParser::read_operand(const Token& token) {
  if (token.kind == Token::Kind::number) return read_number(token.text);
  if (token.kind == Token::Kind::name) return read_name(token.text);
  if (token.sign == '(') return operations_.push_back({'(', at_});
  if (token.sign == '-') return operations_.push_back({'~', at_});
  if (token.sign == '+') return;
  constexpr auto expected = "a number, a variable, a function or \"(\" is expected";
  if (token.kind != Token::Kind::end)
    fail(at_, fmt::format("{} where {}", in_quotes(token.text), expected));
  fail(at_, operands_.empty() && operations_.empty()
                ? "the expression is empty"
                : fmt::format("the expression ends where {}", expected));
}

void FormulaParser::close_parenthesis() {
  while (!operations_.empty() && operations_.back().sign != '(') reduce();
  if (operations_.empty()) fail(at_, "there is no \"(\" for this \")\"");
  FormulaOperand& inside = operands_.back();
  const WaitingOperation parenthesis = operations_.back();
  operations_.pop_back();
  inside.begin = parenthesis.at;
  if (parenthesis.function.empty()) return;
  inside = {list_.apply(parenthesis.function, inside.step), parenthesis.at};
}

void FormulaParser::refuse_operator(const Token& token) const {
  if (token.kind == Token::Kind::other)
    fail(at_, fmt::format("{} is not understood", in_quotes(token.text)));
  fail(at_, fmt::format("no operator between {} and {}: a product needs its sign, *",
                        in_quotes(before_), in_quotes(token.text)));
}

constexpr auto ambiguous_power = "one exponent after another: parentheses are needed";

void FormulaParser::read_raised_digits(std::string_view digits) {
  if (!operations_.empty() && operations_.back().sign == '^') fail(at_, ambiguous_power);
  if (first_token(before_).kind == Token::Kind::exponent) fail(at_, ambiguous_power);
  std::optional<Rational> exponent;
  try {
    exponent = parse_rational(plain_digits(digits));
  } catch (const InputError&) {
    fail(at_, fmt::format("{} is not an exponent", in_quotes(digits)));
  }
  raise(operands_.back(), {0, at_, exponent});
}

void FormulaParser::read_operator(const Token& token) {
  if (token.kind == Token::Kind::exponent) return read_raised_digits(token.text);
  if (token.sign == ')') return close_parenthesis();
  if (token.sign == 0 || token.sign == '(') refuse_operator(token);
  const bool groups_right = token.sign == '^';
  if (groups_right && first_token(before_).kind == Token::Kind::exponent)
    fail(at_, ambiguous_power);
  const int rank = precedence(token.sign) + (groups_right ? 1 : 0);
  while (!operations_.empty() && precedence(operations_.back().sign) >= rank) reduce();
  operations_.push_back({token.sign, at_});
  operand_is_next_ = true;
}

GivenFormula FormulaParser::parse() {
  for (;;) {
    const Token token = next_token();
    if (!operand_is_next_ && token.kind == Token::Kind::end) break;
    Token last = token;
    if (operand_is_next_ && token.kind == Token::Kind::name) {
      const std::size_t behind =
          std::min(text_.find_first_not_of(blanks, at_ + token.text.size()), text_.size());
      if (first_token(text_.substr(behind)).sign == '(') {
        open_function(token.text);
        last = next_token();  // the parenthesis
      } else {
        read_operand(token);
      }
    } else if (operand_is_next_) {
      read_operand(token);
    } else {
      read_operator(token);
    }
    before_ = last.text;
    at_ += last.text.size();
  }
  while (!operations_.empty()) {
    if (operations_.back().sign == '(') fail(operations_.back().at, "this \"(\" is never closed");
    reduce();
  }
  auto& steps = list_.steps();
  steps.resize(operands_.front().step + 1);
  return {Formula(std::move(steps)), variable_};
}

}  // namespace

GivenFormula parse_formula(std::string_view text, const std::optional<std::string>& variable) {
  if (text.size() > max_formula_length)
    throw InputError("column 1", fmt::format("the expression has {} bytes, the limit is {}",
                                             text.size(), max_formula_length));
  return FormulaParser(text, variable).parse();
}

}  // namespace phrame
