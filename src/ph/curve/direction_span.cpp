#include "phrame/ph/curve/direction_span.hpp"

#include <algorithm>
#include <map>

#include "phrame/ph/curve/formula_program.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

bool is_zero_vector(const Vector<Rational>& v) { return v == Vector<Rational>{}; }

/// The first of them × another, where that is not 0.
std::optional<Vector<Rational>> first_normal(const std::vector<Vector<Rational>>& directions) {
  for (const Vector<Rational>& other : directions)
    if (const Vector<Rational> n = cross(directions.front(), other); !is_zero_vector(n)) return n;
  return std::nullopt;
}

Vector<Rational> primitive(const Vector<Rational>& v) {
  const Rational size = common_content({Polynomial{v[0]}, Polynomial{v[1]}, Polynomial{v[2]}});
  return Rational(1 / size) * v;
}

/// What a component is the sum of: functions, as steps of a program, each with its factors in the
/// three components.
using Summands = std::map<FormulaProgram::Id, Vector<Rational>>;

/// What f is the sum of, as this component.
void add_summands(Summands& sum, FormulaProgram& program, FormulaProgram::Id f,
                  std::size_t component) {
  using Operation = Formula::Operation;
  std::vector<std::pair<Rational, FormulaProgram::Id>> open{
      {1, f}};  // c·g, still to be taken apart
  while (!open.empty()) {
    const auto [c, g] = open.back();
    open.pop_back();
    const Formula::Step step = program.steps()[g];
    const bool is_product = step.operation == Operation::multiply;
    const Rational* factor = is_product ? program.rational(step.left) : nullptr;
    if (step.operation == Operation::add) {
      open.emplace_back(c, step.left);
      open.emplace_back(c, step.right);
    } else if (factor != nullptr) {
      open.emplace_back(c * *factor, step.right);
    } else if (step.operation == Operation::number) {
      if (step.number != 0) sum[program.number(1)][component] += c * step.number;
      if (step.pi_multiple != 0) sum[program.number(0, 1)][component] += c * step.pi_multiple;
    } else {
      sum[g][component] += c;
    }
  }
}

/// The coefficients.
std::vector<Vector<Rational>> span_of(const Vector<Polynomial>& H) {
  const long degree = std::max({H[0].degree(), H[1].degree(), H[2].degree()});
  std::vector<Vector<Rational>> all;
  for (long k = 0; k <= degree; ++k) {
    const Vector<Rational> v{H[0].coefficient(k), H[1].coefficient(k), H[2].coefficient(k)};
    if (!is_zero_vector(v)) all.push_back(v);
  }
  return all;
}

}  // namespace

std::vector<Vector<Rational>> direction_span(const RationalCurve& curve) {
  return span_of(curve.direction());
}

std::vector<Vector<Rational>> direction_span(const ExpressionCurve& curve) {
  FormulaProgram program;
  Summands sum;
  for (std::size_t k = 0; k < 3; ++k)
    add_summands(sum, program, program.insert(curve.derivative(1)[k], program.variable()), k);
  std::vector<Vector<Rational>> all;
  for (const auto& [f, v] : sum)
    if (!is_zero_vector(v)) all.push_back(v);
  return all;
}

std::vector<Vector<Rational>> direction_span(const Segment& segment) {
  if (const auto* ph = std::get_if<PhSegment>(&segment))
    return span_of(rotated_i(ph->primitive_preimage()));
  return visit_curve([](const auto& curve) { return direction_span(curve); }, segment);
}

std::vector<Vector<Rational>> direction_span(const Path& path) {
  std::vector<Vector<Rational>> all;
  Vector<Rational> normal;  // of the first two
  for (const Segment& segment : path.segments())
    for (Vector<Rational>& v : direction_span(segment)) {
      const Vector<Rational> across = all.size() == 1 ? cross(all.front(), v) : normal;
      if (all.size() == 1 && is_zero_vector(across)) continue;
      if (all.size() == 2 && dot(normal, v) == 0) continue;
      normal = across;
      all.push_back(std::move(v));
      if (all.size() == 3) return all;
    }
  return all;
}

bool are_on_a_line(const std::vector<Vector<Rational>>& directions) {
  return !first_normal(directions);
}

std::optional<Vector<Rational>> common_normal(const std::vector<Vector<Rational>>& directions) {
  const auto normal = first_normal(directions);
  if (!normal) return std::nullopt;
  for (const Vector<Rational>& direction : directions)
    if (dot(*normal, direction) != 0) return std::nullopt;
  return primitive(*normal);
}

}  // namespace phrame
