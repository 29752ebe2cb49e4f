#include "phrame/ph/curve/formula.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

using FormulaOperation = Formula::Operation;
using FormulaSteps = std::vector<Formula::Step>;

/// The steps of `more` at the end of `steps`.
void append_steps(FormulaSteps& steps, const FormulaSteps& more) {
  const std::size_t offset = steps.size();
  steps.reserve(offset + more.size() + 1);
  for (Formula::Step step : more) {
    if (step.operation != FormulaOperation::number &&
        step.operation != FormulaOperation::variable) {
      step.left += offset;
      step.right += offset;
    }
    steps.push_back(std::move(step));
  }
}

/// A text and how tightly its outermost operation binds: 1 a sum, 2 a product, 4 a whole.
struct FormulaText {
  std::string text;
  int rank;
};

std::string in_parentheses(const FormulaText& f, int least_rank) {
  return f.rank < least_rank ? "(" + f.text + ")" : f.text;
}

FormulaText text_of_constant(const Rational& number, const Rational& pi_multiple) {
  const auto of_number = [](const Rational& x) {
    return FormulaText{to_string(x), x.sign() < 0 ? 1 : denominator(x) == 1 ? 4 : 2};
  };
  if (pi_multiple == 0) return of_number(number);
  const FormulaText turns = pi_multiple == 1 ? FormulaText{"pi", 4}
                                             : FormulaText{to_string(pi_multiple) + "*pi",
                                                           pi_multiple.sign() < 0 ? 1 : 2};
  if (number == 0) return turns;
  return {to_string(number) + " + " + turns.text, 1};
}

std::string name_of(FormulaOperation operation) {
  switch (operation) {
    case FormulaOperation::sin:
      return "sin";
    case FormulaOperation::cos:
      return "cos";
    case FormulaOperation::exp:
      return "exp";
    case FormulaOperation::log:
      return "log";
    case FormulaOperation::sqrt:
      return "sqrt";
    default:
      return "atan";
  }
}

FormulaText text_of_step(const Formula::Step& step, const std::vector<FormulaText>& of,
                         const std::string& variable) {
  switch (step.operation) {
    case FormulaOperation::number:
      return text_of_constant(step.number, step.pi_multiple);
    case FormulaOperation::variable:
      return {variable, 4};
    case FormulaOperation::add: {
      const std::string& right = of[step.right].text;
      return {of[step.left].text + (right[0] == '-' ? " - " + right.substr(1) : " + " + right), 1};
    }
    case FormulaOperation::multiply:
      if (of[step.left].text == "-1") return {"-" + in_parentheses(of[step.right], 3), 1};
      return {in_parentheses(of[step.left], 2) + "*" + in_parentheses(of[step.right], 3), 2};
    case FormulaOperation::divide:
      return {in_parentheses(of[step.left], 2) + "/" + in_parentheses(of[step.right], 3), 2};
    case FormulaOperation::power:
      return {fmt::format("{}^{}", in_parentheses(of[step.left], 4),
                          in_parentheses(text_of_constant(step.number, 0), 4)),
              3};
    default:
      return {fmt::format("{}({})", name_of(step.operation), of[step.left].text), 4};
  }
}

/// The two ends of a text that is too long.
std::string shortened(std::string text) {
  constexpr std::size_t most = 60;
  if (text.size() <= most) return text;
  const auto is_inside = [&](std::size_t k) {
    return (static_cast<unsigned char>(text[k]) & 0xC0U) == 0x80U;
  };
  std::size_t head = most / 2;
  std::size_t tail = text.size() - most / 3;
  while (is_inside(head)) --head;
  while (is_inside(tail)) ++tail;
  return text.substr(0, head) + " … " + text.substr(tail);
}

}  // namespace

Formula::Formula(Rational number, Rational pi_multiple)
    : steps_{{Operation::number, 0, 0, std::move(number), std::move(pi_multiple)}} {}

Formula::Formula(Operation operation, const Formula& left, const Rational& number)
    : steps_(left.steps_) {
  steps_.push_back({operation, steps_.size() - 1, 0, number, 0});
}

Formula::Formula(Operation operation, Formula left, const Formula& right)
    : steps_(std::move(left.steps_)) {
  const std::size_t first = steps_.size() - 1;
  append_steps(steps_, right.steps_);
  steps_.push_back({operation, first, steps_.size() - 1, 0, 0});
}

Formula Formula::variable() {
  Formula s;
  s.steps_.front().operation = Operation::variable;
  return s;
}

Formula operator+(const Formula& f, const Formula& g) { return {FormulaOperation::add, f, g}; }
Formula operator-(const Formula& f, const Formula& g) { return f + -g; }
Formula operator*(const Formula& f, const Formula& g) { return {FormulaOperation::multiply, f, g}; }
Formula operator/(const Formula& f, const Formula& g) { return {FormulaOperation::divide, f, g}; }
Formula operator-(const Formula& f) { return Formula(-1) * f; }
Formula power(const Formula& f, const Rational& exponent) {
  if (numerator(abs(exponent)) > max_exponent || denominator(exponent) > max_exponent)
    throw DomainError(
        fmt::format("the exponent {} is too large: numerator and denominator are at most {}",
                    as_written(exponent), max_exponent));
  return {FormulaOperation::power, f, exponent};
}
Formula sin(const Formula& f) { return {FormulaOperation::sin, f}; }
Formula cos(const Formula& f) { return {FormulaOperation::cos, f}; }
Formula tan(const Formula& f) { return sin(f) / cos(f); }
Formula exp(const Formula& f) { return {FormulaOperation::exp, f}; }
Formula log(const Formula& f) { return {FormulaOperation::log, f}; }
Formula sqrt(const Formula& f) { return {FormulaOperation::sqrt, f}; }
Formula atan(const Formula& f) { return {FormulaOperation::atan, f}; }

bool is_constant(const Formula& f) {
  return std::none_of(f.steps().begin(), f.steps().end(), [](const Formula::Step& step) {
    return step.operation == FormulaOperation::variable;
  });
}

std::vector<std::string> step_texts(const FormulaSteps& steps, const std::string& variable) {
  std::vector<FormulaText> texts;
  for (const Formula::Step& step : steps) {
    texts.push_back(text_of_step(step, texts, variable));
    texts.back().text = shortened(std::move(texts.back().text));
  }
  std::vector<std::string> result;
  for (FormulaText& text : texts) result.push_back(std::move(text.text));
  return result;
}

std::string full_text(const Formula& f, const std::string& variable) {
  std::vector<FormulaText> texts;
  for (const Formula::Step& step : f.steps()) texts.push_back(text_of_step(step, texts, variable));
  return std::move(texts.back().text);
}

std::string to_string(const Formula& f, const std::string& variable) {
  return step_texts(f.steps(), variable).back();
}

}  // namespace phrame
