#include "phrame/ph/curve/expression_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "phrame/ph/curve/known_integrals.hpp"

namespace phrame::inline v0 {
namespace {

/// With which the ends of the parameter are told apart.
constexpr long end_bits = 1024;

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
  const FormulaProgram::Id from = program.insert(curve.from(), program.number(0));
  const FormulaProgram::Id to = program.insert(curve.to(), program.number(0));
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

Vector<ComplexSeries> unknown_vector(long length) {
  const ComplexSeries unknown(
      std::vector<ComplexBall>(static_cast<std::size_t>(length), ComplexBall::unknown()));
  return {unknown, unknown, unknown};
}

}  // namespace

struct ExpressionCurve::State {
  Vector<Formula> position;
  Formula from;
  Formula to;
  std::string variable;
  FormulaProgram program{};
  Vector<std::size_t> components{};
  std::array<Lazy<Vector<Formula>>, 3> derivatives{};  ///< r′, r″, r‴ by s
  KnownIntegrals known_integrals{};
};

ExpressionCurve::ExpressionCurve(Vector<Formula> position, Formula from, Formula to,
                                 std::string variable)
    : state_(new State{std::move(position), std::move(from), std::move(to), std::move(variable)}) {
  check_ends(*this);
  FormulaProgram& program = state_->program;
  for (std::size_t k = 0; k < 3; ++k)
    state_->components[k] = program.insert(state_->position[k], program.variable());
  require_sizes(*this);
  if (const auto& fault = known_integrals().parts(*this, length_rate())->fault)
    refuse_part(*this, *fault);
}

const Vector<Formula>& ExpressionCurve::position() const { return state_->position; }
const Formula& ExpressionCurve::from() const { return state_->from; }
const Formula& ExpressionCurve::to() const { return state_->to; }
const std::string& ExpressionCurve::variable() const { return state_->variable; }
const FormulaProgram& ExpressionCurve::program() const { return state_->program; }
const Vector<std::size_t>& ExpressionCurve::components() const { return state_->components; }
KnownIntegrals& ExpressionCurve::known_integrals() const { return state_->known_integrals; }

ExpressionCurve ExpressionCurve::turned_over() const {
  ExpressionCurve other = *this;
  other.orientation_ = -orientation_;
  return other;
}

const Vector<Formula>& ExpressionCurve::derivative(std::size_t order) const {
  if (order == 0) return position();
  return state_->derivatives[order - 1].get([&] {
    const Vector<Formula>& f = derivative(order - 1);
    return Vector<Formula>{phrame::derivative(f[0]), phrame::derivative(f[1]),
                           phrame::derivative(f[2])};
  });
}

bool operator==(const ExpressionCurve& a, const ExpressionCurve& b) {
  return a.position() == b.position() && a.from() == b.from() && a.to() == b.to() &&
         a.orientation_ == b.orientation_;
}

RealBall ExpressionCurve::parameter(const RealBall& t, long bits) const {
  const RealBall a = constant_value(from(), bits);
  return add_product(a, subtract(constant_value(to(), bits), a, bits), t, bits);
}

Vector<BallPolynomial> ExpressionCurve::series(const RealBall& t, const Rational& scale,
                                               long length, long bits) const {
  const RealBall a = constant_value(from(), bits);
  const RealBall span = subtract(constant_value(to(), bits), a, bits);
  const BallPolynomial s(std::vector<RealBall>{add_product(a, span, t, bits),
                                               multiply(span, RealBall(scale, bits), bits)});
  const auto all = evaluate_steps(program().steps(), s, length, bits);
  return {all[components()[0]], all[components()[1]], all[components()[2]]};
}

Vector<ComplexSeries> ExpressionCurve::series(const ComplexBall& t, const Rational& scale,
                                              long length, long bits) const {
  const RealBall a = constant_value(from(), bits);
  const RealBall span = subtract(constant_value(to(), bits), a, bits);
  const ComplexSeries s({add(multiply(span, t, bits), ComplexBall(a, {}), bits),
                         ComplexBall(multiply(span, RealBall(scale, bits), bits), {})});
  const auto all = evaluate_steps(program().steps(), s, length, bits);
  const bool is_analytic = std::all_of(all.begin(), all.end(), [](const ComplexSeries& step) {
    return step.coefficient(0).re().is_finite() && step.coefficient(0).im().is_finite();
  });
  if (!is_analytic) return unknown_vector(length);
  return {all[components()[0]], all[components()[1]], all[components()[2]]};
}

int direction_of_parameter(const ExpressionCurve& curve) {
  const RealBall a = constant_value(curve.from(), end_bits);
  return is_less(a, constant_value(curve.to(), end_bits)) ? 1 : -1;
}

}  // namespace phrame
