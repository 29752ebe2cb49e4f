#include "phrame/ph/curve/expression_curve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/known_integrals.hpp"

namespace phrame {
namespace {

using FormulaId = FormulaProgram::Id;

/// With which the ends of the parameter are told apart.
constexpr long end_bits = 1024;

/// s at t.
FormulaId parameter_step(const ExpressionCurve& curve, const Rational& t, FormulaProgram& program) {
  const FormulaId a = program.insert(curve.from(), program.number(0));
  const FormulaId b = program.insert(curve.to(), program.number(0));
  if (t == 1) return b;
  return program.add(a, program.multiply(program.number(t), program.subtract(b, a)));
}

RealBall end_value(const Formula& end, const std::string& variable) {
  if (!is_constant(end))
    throw DomainError(
        fmt::format("the end {} of the parameter is no constant", to_string(end, variable)));
  const RealBall value = constant_value(end, 64);
  if (!value.is_finite())
    throw DomainError(
        fmt::format("the end {} of the parameter is undefined", to_string(end, variable)));
  return value;
}

void check_ends(const ExpressionCurve& curve) {
  const RealBall a = end_value(curve.from(), curve.variable());
  const RealBall b = end_value(curve.to(), curve.variable());
  if (!a.overlaps(b)) return;
  FormulaProgram program;
  const FormulaId from = parameter_step(curve, 0, program);
  const FormulaId to = parameter_step(curve, 1, program);
  const std::string ends = fmt::format("from {} to {}", to_string(curve.from(), curve.variable()),
                                       to_string(curve.to(), curve.variable()));
  if (from == to)
    throw DomainError(fmt::format("{} goes {}: that is a point", curve.variable(), ends));
  if (constant_value(program, from, end_bits).overlaps(constant_value(program, to, end_bits)))
    throw Undecided(fmt::format("{} goes {}: within 2^-{} these ends are not told apart",
                                curve.variable(), ends, end_bits));
}

/// 2 to these is more than a number on the way may be, and more than coordinates and their
/// derivatives by t; if all of the latter are less than 2 to the negative, that is too small.
constexpr long most_step_exponent = 20'000;
constexpr long most_curve_exponent = 1024;

[[noreturn]] void refuse_size(const Rational& t, const std::string& what,
                              const std::string& limit) {
  throw DomainError(
      fmt::format("{} at t = {}: what is computed with is {}", what, to_string(t), limit));
}

/// Of what is far larger or smaller the digits would take minutes and gigabytes. Looked for at both
/// ends and in the middle.
void require_sizes(const ExpressionCurve& curve) {
  const auto& steps = curve.program().steps();
  bool is_tiny = true;
  bool is_zero = true;  // of a cusp, which is told by others
  for (const Rational& t : {Rational(0), Rational(1, 2), Rational(1)}) {
    const RealBall a = constant_value(curve.from(), 64);
    const RealBall span = subtract(constant_value(curve.to(), 64), a, 64);
    const BallPolynomial s(std::vector<RealBall>{add_product(a, span, RealBall(t, 64), 64), span});
    const auto values = evaluate_steps(steps, s, 2, 64);
    const auto require = [&](std::size_t k, const RealBall& x, long most, const char* of) {
      if (exponent_below(x) > most)
        refuse_size(t,
                    fmt::format("{}{} is at least 2^{}", of, step_texts(steps, curve.variable())[k],
                                exponent_below(x)),
                    fmt::format("less than 2^{}", most));
    };
    for (std::size_t k = 0; k < steps.size(); ++k)
      require(k, values[k].coefficient(0), most_step_exponent, "");
    for (const std::size_t k : curve.components()) {
      require(k, values[k].coefficient(0), most_curve_exponent, "");
      require(k, values[k].coefficient(1), most_curve_exponent, "the change of ");
      is_tiny = is_tiny && exponent_above(values[k].coefficient(1)) < -most_curve_exponent;
      is_zero = is_zero && values[k].coefficient(1).contains_zero();
    }
  }
  if (is_tiny && !is_zero)
    refuse_size(0, "the speed is less than 2^-1024 at the ends and in the middle,",
                "at least that");
}

Vector<RealBall> values(const FormulaProgram& program, const ExactVector& v, long bits) {
  Vector<RealBall> result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = constant_value(program, v[k], bits);
  return result;
}

Vector<ComplexSeries> unknown_vector(long length) {
  const ComplexSeries unknown(
      std::vector<ComplexBall>(static_cast<std::size_t>(length), ComplexBall::unknown()));
  return {unknown, unknown, unknown};
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

ExpressionCurve::ExpressionCurve(Vector<Formula> position, Formula from, Formula to,
                                 std::string variable)
    : position_(std::move(position)),
      from_(std::move(from)),
      to_(std::move(to)),
      variable_(std::move(variable)),
      known_integrals_(std::make_shared<KnownIntegrals>()) {
  check_ends(*this);
  for (std::size_t k = 0; k < 3; ++k)
    components_[k] = program_.insert(position_[k], program_.variable());
  require_sizes(*this);
  if (const auto& fault = known_integrals_->parts(*this, length_rate())->fault)
    refuse_part(*this, *fault);
}

ExpressionCurve ExpressionCurve::turned_over() const {
  ExpressionCurve other = *this;
  other.orientation_ = -orientation_;
  return other;
}

const Vector<Formula>& ExpressionCurve::derivative(std::size_t order) const {
  if (order == 0) return position_;
  return derivatives_[order - 1].get([&] {
    const Vector<Formula>& f = derivative(order - 1);
    return Vector<Formula>{phrame::derivative(f[0]), phrame::derivative(f[1]),
                           phrame::derivative(f[2])};
  });
}

bool operator==(const ExpressionCurve& a, const ExpressionCurve& b) {
  return a.position_ == b.position_ && a.from_ == b.from_ && a.to_ == b.to_ &&
         a.orientation_ == b.orientation_;
}

RealBall ExpressionCurve::parameter(const RealBall& t, long bits) const {
  const RealBall a = constant_value(from_, bits);
  return add_product(a, subtract(constant_value(to_, bits), a, bits), t, bits);
}

Vector<BallPolynomial> ExpressionCurve::series(const RealBall& t, const Rational& scale,
                                               long length, long bits) const {
  const RealBall a = constant_value(from_, bits);
  const RealBall span = subtract(constant_value(to_, bits), a, bits);
  const BallPolynomial s(std::vector<RealBall>{add_product(a, span, t, bits),
                                               multiply(span, RealBall(scale, bits), bits)});
  const auto all = evaluate_steps(program_.steps(), s, length, bits);
  return {all[components_[0]], all[components_[1]], all[components_[2]]};
}

Vector<ComplexSeries> ExpressionCurve::series(const ComplexBall& t, const Rational& scale,
                                              long length, long bits) const {
  const RealBall a = constant_value(from_, bits);
  const RealBall span = subtract(constant_value(to_, bits), a, bits);
  const ComplexSeries s({add(multiply(span, t, bits), ComplexBall(a, {}), bits),
                         ComplexBall(multiply(span, RealBall(scale, bits), bits), {})});
  const auto all = evaluate_steps(program_.steps(), s, length, bits);
  const bool is_analytic = std::all_of(all.begin(), all.end(), [](const ComplexSeries& step) {
    return step.coefficient(0).re().is_finite() && step.coefficient(0).im().is_finite();
  });
  if (!is_analytic) return unknown_vector(length);
  return {all[components_[0]], all[components_[1]], all[components_[2]]};
}

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

int direction_of_parameter(const ExpressionCurve& curve) {
  const RealBall a = constant_value(curve.from(), end_bits);
  return is_less(a, constant_value(curve.to(), end_bits)) ? 1 : -1;
}

std::optional<bool> are_equal(const FormulaProgram& program, const ExactVector& a,
                              const ExactVector& b, long most_bits) {
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
                                        const ExactVector& b, long most_bits) {
  if (a == b) return true;
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
