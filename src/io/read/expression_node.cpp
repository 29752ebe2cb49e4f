#include "phrame/io/read/expression_node.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/ph/curve/rational_form.hpp"

namespace phrame::inline v0 {
namespace {

/// A number, or a formula of the variable, which is learnt from the first that has one.
Formula read_formula(const JsonNode& node, std::string& variable, bool is_constant = false) {
  if (node.is(JsonNode::Kind::number)) return Formula(node.number());
  try {
    const auto wanted = is_constant        ? std::optional<std::string>("")
                        : variable.empty() ? std::nullopt
                                           : std::optional(variable);
    GivenFormula given = parse_formula(node.string(), wanted);
    if (!is_constant && variable.empty()) variable = given.variable;
    return std::move(given.value);
  } catch (const InputError& error) {
    if (error.place() == node.place()) throw;
    node.fail(error.place() + ": " + error.reason());
  }
}

/// What stands at the key beside the formulas, or among them, where there is such a key.
std::optional<JsonNode> beside(const JsonNode& node, const JsonNode& expressions, const char* key) {
  auto among = expressions.find(key);
  if (!among) return node.find(key);
  if (node.find(key)) among->fail("it stands beside \"expressions\", too");
  return among;
}

std::string read_variable(const std::optional<JsonNode>& given) {
  if (!given) return "";
  if (given->string().empty()) given->fail("the name of the variable is empty");
  return given->string();
}

}  // namespace

GivenSegment read_expression_segment(const JsonNode& node, const JsonNode& expressions) {
  for (const char* other : {"preimage", "quaternions", "hopf", "complex", "control_points",
                            "weights", "position", "multiplier", "start", "basis"})
    if (node.find(other))
      node.fail("\"expressions\" and \"" + std::string(other) + "\" exclude each other");
  expressions.require(JsonNode::Kind::object, "an object with \"x\", \"y\" and perhaps \"z\"");
  expressions.require_known_keys({"x", "y", "z", "variable", "from", "to"});
  std::string variable = read_variable(beside(node, expressions, "variable"));
  const auto z = expressions.find("z");
  const Formula x = read_formula(expressions.at("x"), variable);
  const Formula y = read_formula(expressions.at("y"), variable);
  const Vector<Formula> r{x, y, z ? read_formula(*z, variable) : Formula(0)};
  const auto end = [&](const char* key) {
    const auto given = beside(node, expressions, key);
    return read_formula(given ? *given : node.at(key), variable, true);
  };
  const Formula from = end("from");
  const Formula to = end("to");
  if (variable.empty()) variable = "s";
  try {
    if (auto curve = rational_form(r, from, to, variable)) return {*std::move(curve), node.place()};
    return {ExpressionCurve(r, from, to, variable), node.place()};
  } catch (const DomainError& error) {
    expressions.fail(error.what());
  }
}

}  // namespace phrame
