#include "phrame/io/read/formula.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/io/read/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/io/read/operator_reader.hpp"

namespace phrame::inline v0 {
namespace {

using FormulaOp = Formula::Operation;

/// A value that is complete.
struct FormulaOperand {
  std::size_t step = 0;
  std::size_t begin = 0;                ///< in the text
  std::optional<Rational> number = {};  ///< where it is one
  bool is_e = false;                    ///< exp 1
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

class FormulaParser : OperatorReader {
 public:
  FormulaParser(std::string_view text, const std::optional<std::string>& variable)
      : OperatorReader(text, "a number, a variable, a function or \"(\"", variable) {}

  GivenFormula parse();

 private:
  void push_number(std::string_view number) override;
  void push_name(std::string_view name) override;
  bool is_function(std::string_view name) const override;
  void negate(std::size_t at) override;
  void combine(char sign) override;
  void raise(const Rational& exponent, std::size_t end) override;
  void enclose(std::size_t begin, std::size_t end, std::string_view function) override;
  std::string missing_operator(std::string_view left, std::string_view right) const override {
    return fmt::format("no operator between {} and {}: a product needs its sign, *",
                       in_quotes(left), in_quotes(right));
  }
  void compute(char sign, FormulaOperand& left, const FormulaOperand& right);
  void raise(FormulaOperand& base, const FormulaOperand& exponent);

  StepList list_;
  std::vector<FormulaOperand> operands_;
};

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

void FormulaParser::negate(std::size_t at) {
  FormulaOperand& x = operands_.back();
  x = {list_.negative(x.step), at, x.number ? std::optional(-*x.number) : std::nullopt};
}

void FormulaParser::combine(char sign) {
  const FormulaOperand right = operands_.back();
  operands_.pop_back();
  compute(sign, operands_.back(), right);
  operands_.back().is_e = false;
}

void FormulaParser::raise(const Rational& exponent, std::size_t) {
  raise(operands_.back(), {0, at(), exponent});
}

void FormulaParser::enclose(std::size_t begin, std::size_t, std::string_view function) {
  FormulaOperand& inside = operands_.back();
  inside.begin = begin;
  if (!function.empty()) inside = {list_.apply(function, inside.step), begin};
}

void FormulaParser::push_number(std::string_view number) {
  std::optional<Rational> value;
  try {
    value = parse_rational(number);
    refuse_long_number(*value, number);
  } catch (const InputError& error) {
    fail(at(), error.reason());
  }
  operands_.push_back({list_.number(*value), at(), value});
}

void FormulaParser::push_name(std::string_view name) {
  if (is_known_function(name))  // a variable may be called what it likes, but for this
    fail(at(), fmt::format("the function {} needs its argument in parentheses: {}(…)", name, name));
  if (name == "pi" || name == "π") return operands_.push_back({list_.number(0, 1), at()});
  if (name == "e" && variable() != "e")
    return operands_.push_back({list_.make(FormulaOp::exp, list_.number(1)), at(), {}, true});
  take_variable(name);
  operands_.push_back({list_.variable(), at()});
}

bool FormulaParser::is_function(std::string_view name) const {
  if (is_known_function(name)) return true;
  if (name == variable()) return false;
  fail(at(), fmt::format("{} is not a function that is known: {}", in_quotes(name),
                         fmt::join(function_names, ", ")));
}

GivenFormula FormulaParser::parse() {
  read();
  auto& steps = list_.steps();
  steps.resize(operands_.front().step + 1);
  return {Formula(std::move(steps)), variable()};
}

}  // namespace

Formula canonical(const Formula& f) {
  constexpr int most_times = 6;
  std::string text = full_text(f, "s");
  for (int k = 0; k < most_times; ++k) {
    Formula next = parse_formula(text, "s").value;
    std::string again = full_text(next, "s");
    if (again == text) return next;
    text = std::move(again);
  }
  throw DomainError(fmt::format("the formula {} has no one form", to_string(f, "s")));
}

GivenFormula parse_formula(std::string_view text, const std::optional<std::string>& variable) {
  if (text.size() > max_formula_length)
    throw InputError("column 1", fmt::format("the expression has {} bytes, the limit is {}",
                                             text.size(), max_formula_length));
  return FormulaParser(text, variable).parse();
}

}  // namespace phrame
