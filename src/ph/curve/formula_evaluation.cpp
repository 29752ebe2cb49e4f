#include "phrame/ph/curve/formula_evaluation.hpp"

#include <optional>

namespace phrame::inline v0 {
namespace {

BallPolynomial constant_series(const RealBall& c, const BallPolynomial& /*like*/) {
  return BallPolynomial(std::vector<RealBall>{c});
}

ComplexSeries constant_series(const RealBall& c, const ComplexSeries& /*like*/) {
  return ComplexSeries({ComplexBall(c, {})});
}

bool is_exactly_zero(const BallPolynomial& p) { return p.degree_bound() < 0; }
bool is_exactly_zero(const ComplexSeries& p) { return p.is_zero(); }

/// Of 0, too, not finite where q may be 0.
template <class Series>
Series quotient_of_series(const Series& p, const Series& q, long length, long bits) {
  if (!is_exactly_zero(p)) return divide_series(p, q, length, bits);
  const Series inverse = divide_series(constant_series(RealBall(1, bits), p), q, length, bits);
  return add(inverse, multiply(RealBall(-1, bits), inverse, bits), bits);
}

template <class Series>
Series power_of_series(const Series& f, const Rational& exponent, long length, long bits) {
  if (denominator(exponent) != 1)
    return exp_series(multiply(RealBall(exponent, bits), log_series(f, length, bits), bits), length,
                      bits);
  const Rational size = abs(exponent);
  const auto k = static_cast<unsigned long>(static_cast<long>(numerator(size)));
  const Series product = pow_series(f, k, length, bits);
  return exponent.sign() >= 0
             ? product
             : divide_series(constant_series(RealBall(1, bits), f), product, length, bits);
}

/// The sine and the cosine of one angle are found together.
template <class Series>
class StepEvaluation {
 public:
  StepEvaluation(const std::vector<Formula::Step>& steps, const Series& s, long length, long bits)
      : steps_(steps),
        s_(s),
        length_(length),
        bits_(bits),
        sines_(steps.size()),
        cosines_(steps.size()) {}

  std::vector<Series> run() {
    for (const Formula::Step& step : steps_) values_.push_back(value(step));
    return std::move(values_);
  }

 private:
  Series value(const Formula::Step& step);
  const Series& turned(std::vector<std::optional<Series>>& of, std::size_t angle) {
    if (!of[angle]) {
      auto both = cos_sin_series(values_[angle], length_, bits_);
      cosines_[angle] = std::move(both.cos);
      sines_[angle] = std::move(both.sin);
    }
    return *of[angle];
  }

  const std::vector<Formula::Step>& steps_;
  const Series& s_;
  long length_;
  long bits_;
  std::vector<Series> values_;
  std::vector<std::optional<Series>> sines_;
  std::vector<std::optional<Series>> cosines_;
};

template <class Series>
Series StepEvaluation<Series>::value(const Formula::Step& step) {
  using Operation = Formula::Operation;
  const auto left = [&]() -> const Series& { return values_[step.left]; };
  const auto right = [&]() -> const Series& { return values_[step.right]; };
  switch (step.operation) {
    case Operation::number: {
      RealBall c(step.number, bits_);
      if (step.pi_multiple != 0)
        c = add_product(c, RealBall(step.pi_multiple, bits_), pi(bits_), bits_);
      return constant_series(c, s_);
    }
    case Operation::variable:
      return s_;
    case Operation::add:
      return add(left(), right(), bits_);
    case Operation::multiply:
      return multiply_series(left(), right(), length_, bits_);
    case Operation::divide:
      return quotient_of_series(left(), right(), length_, bits_);
    case Operation::power:
      return power_of_series(left(), step.number, length_, bits_);
    case Operation::sin:
      return turned(sines_, step.left);
    case Operation::cos:
      return turned(cosines_, step.left);
    case Operation::exp:
      return exp_series(left(), length_, bits_);
    case Operation::log:
      return log_series(left(), length_, bits_);
    case Operation::sqrt:
      return sqrt_series(left(), length_, bits_);
    case Operation::atan:
      return atan_series(left(), length_, bits_);
  }
  return s_;
}

}  // namespace

template <class Series>
std::vector<Series> evaluate_steps(const std::vector<Formula::Step>& steps, const Series& s,
                                   long length, long bits) {
  return StepEvaluation<Series>(steps, s, length, bits).run();
}

template std::vector<BallPolynomial> evaluate_steps(const std::vector<Formula::Step>&,
                                                    const BallPolynomial&, long, long);
template std::vector<ComplexSeries> evaluate_steps(const std::vector<Formula::Step>&,
                                                   const ComplexSeries&, long, long);

RealBall constant_value(const FormulaProgram& program, FormulaProgram::Id a, long bits) {
  // Operands come before, and a program of one constant has few others.
  const std::vector<Formula::Step> steps(program.steps().begin(),
                                         program.steps().begin() + static_cast<long>(a) + 1);
  return evaluate_steps(steps, BallPolynomial(), 1, bits).back().coefficient(0);
}

RealBall constant_value(const Formula& f, long bits) {
  return evaluate_steps(f.steps(), BallPolynomial(), 1, bits).back().coefficient(0);
}

}  // namespace phrame
