#include "phrame/ph/curve/exact_vector.hpp"

#include "phrame/ph/curve/formula_evaluation.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using FormulaId = FormulaProgram::Id;

/// s at t.
FormulaId parameter_step(const ExpressionCurve& curve, const Rational& t, FormulaProgram& program) {
  const FormulaId a = program.insert(curve.from(), program.number(0));
  const FormulaId b = program.insert(curve.to(), program.number(0));
  if (t == 1) return b;
  return program.add(a, program.multiply(program.number(t), program.subtract(b, a)));
}

Vector<RealBall> values(const FormulaProgram& program, const ExactVector& v, long bits) {
  Vector<RealBall> result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = constant_value(program, v[k], bits);
  return result;
}

/// The vector, where all its components are fractions.
std::optional<Vector<Rational>> rational_vector(const FormulaProgram& program,
                                                const ExactVector& v) {
  Vector<Rational> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational* component = program.rational(v[k]);
    if (component == nullptr) return std::nullopt;
    result[k] = *component;
  }
  return result;
}

/// The vector, where all its components are known exactly.
std::optional<Vector<FormulaConstant>> exact_vector(const FormulaProgram& program,
                                                    const ExactVector& v) {
  Vector<FormulaConstant> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto component = program.constant(v[k]);
    if (!component) return std::nullopt;
    result[k] = *component;
  }
  return result;
}

/// That vector, or 1/π of it, where its components are sums of square roots.
std::optional<Vector<Surd>> surd_direction(const FormulaProgram& program, const ExactVector& v) {
  const auto exact = exact_vector(program, v);
  if (!exact) return std::nullopt;
  const auto& [x, y, z] = *exact;
  if (x.of_pi.is_zero() && y.of_pi.is_zero() && z.of_pi.is_zero())
    return Vector<Surd>{x.plain, y.plain, z.plain};
  if (x.plain.is_zero() && y.plain.is_zero() && z.plain.is_zero())
    return Vector<Surd>{x.of_pi, y.of_pi, z.of_pi};
  return std::nullopt;
}

/// Is a a positive multiple of b?
bool is_positive_multiple(const Vector<Surd>& a, const Vector<Surd>& b) {
  Surd scalar;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    if (!(a[i] * b[j] - a[j] * b[i]).is_zero()) return false;
    scalar = scalar + a[k] * b[k];
  }
  return sign(scalar) > 0;
}

/// a·b, for vectors of balls.
RealBall dot_product(const Vector<RealBall>& a, const Vector<RealBall>& b, long bits) {
  RealBall sum;
  for (std::size_t k = 0; k < 3; ++k) sum = add_product(std::move(sum), a[k], b[k], bits);
  return sum;
}

/// Is a×b seen not to be 0?
bool are_apart(const Vector<RealBall>& a, const Vector<RealBall>& b, long bits) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    const RealBall minor = subtract(multiply(a[i], b[j], bits), multiply(a[j], b[i], bits), bits);
    if (sign(minor) != 0) return true;
  }
  return false;
}

}  // namespace

ExactVector exact_derivative(const ExpressionCurve& curve, std::size_t order, const Rational& t,
                             FormulaProgram& program) {
  const FormulaId s = parameter_step(curve, t, program);
  ExactVector value{};
  for (std::size_t k = 0; k < 3; ++k) value[k] = program.insert(curve.derivative(order)[k], s);
  return value;
}

ExactVector exact_point(const ExpressionCurve& curve, const Rational& t, FormulaProgram& program) {
  return exact_derivative(curve, 0, t, program);
}

ExactVector exact_direction(const ExpressionCurve& curve, const Rational& t,
                            FormulaProgram& program) {
  ExactVector slope = exact_derivative(curve, 1, t, program);
  if (curve.orientation() * direction_of_parameter(curve) < 0)
    for (FormulaId& x : slope) x = program.negative(x);
  return slope;
}

namespace {
constexpr long most_bits = 1024;
}  // namespace

std::optional<bool> are_equal(const FormulaProgram& program, const ExactVector& a,
                              const ExactVector& b) {
  if (a == b) return true;
  const auto p = exact_vector(program, a);
  const auto q = exact_vector(program, b);
  if (p && q) return p == q;
  for (long bits = 128; bits <= most_bits; bits *= 2) {
    const Vector<RealBall> x = values(program, a, bits);
    const Vector<RealBall> y = values(program, b, bits);
    for (std::size_t k = 0; k < 3; ++k)
      if (!x[k].overlaps(y[k])) return false;
  }
  return std::nullopt;
}

std::optional<bool> have_same_direction(const FormulaProgram& program, const ExactVector& a,
                                        const ExactVector& b) {
  if (a == b) return true;
  const auto c = rational_vector(program, a);
  const auto d = rational_vector(program, b);
  if (c && d) return cross(*c, *d) == Vector<Rational>{} && dot(*c, *d) > 0;
  const auto p = surd_direction(program, a);
  const auto q = surd_direction(program, b);
  if (p && q) return is_positive_multiple(*p, *q);
  for (long bits = 128; bits <= most_bits; bits *= 2) {
    const Vector<RealBall> x = values(program, a, bits);
    const Vector<RealBall> y = values(program, b, bits);
    if (are_apart(x, y, bits) || sign(dot_product(x, y, bits)) < 0) return false;
  }
  return std::nullopt;
}

}  // namespace phrame
