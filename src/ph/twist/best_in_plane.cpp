#include "phrame/ph/twist/best_in_plane.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/ball_roots.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

/// An e with |x| about 2ᵉ; 0 for 0.
long size_of(const RealBall& x) {
  const long e = exponent_above(x);
  return std::abs(e) == unbounded_exponent ? 0 : e;
}

/// An e such that the greatest root of p is about 2ᵉ.
long size_of_roots(const BallPolynomial& p) {
  const long n = p.degree_bound();
  const long last = exponent_above(p.coefficient(n));
  long most = -unbounded_exponent;
  for (long k = 0; k < n; ++k) {
    const RealBall c = p.coefficient(k);
    if (!c.contains_zero()) most = std::max(most, (exponent_above(c) - last) / (n - k) + 1);
  }
  return most == -unbounded_exponent ? 0 : most;
}

/// ∫₀¹ ρp.
RealBall integral(const BallPolynomial& p, const std::vector<RealBall>& moments, long bits) {
  RealBall sum;
  for (long k = 0; k <= p.degree_bound(); ++k)
    sum = add_product(sum, p.coefficient(k), moments[static_cast<std::size_t>(k)], bits);
  return sum;
}

/// The problem with a, b, s and ρ brought to about 1: then xᵀKx = δ.
class QuadraticProblem {
 public:
  QuadraticProblem(const PlaneBasis& basis, const Polynomial& s,
                   const std::vector<RealBall>& moments, long bits)
      : bits_(bits) {
    const BallPolynomial target(s, bits);
    const BallPolynomial ab = multiply(basis.a, basis.b, bits);
    const std::array<BallPolynomial, 3> f{multiply(basis.a, basis.a, bits), add(ab, ab, bits),
                                          multiply(basis.b, basis.b, bits)};
    const auto product = [&](const BallPolynomial& p, const BallPolynomial& q) {
      return integral(multiply(p, q, bits), moments, bits);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      c_[i] = product(f[i], target);
      for (std::size_t j = 0; j < 3; ++j) q_[i][j] = j < i ? q_[j][i] : product(f[i], f[j]);
    }
    rest_ = product(target, target);
    size_weight_ = size_of(moments.front());
    size_a_ = (size_of(q_[0][0]) - size_weight_) / 4;
    size_b_ = (size_of(q_[2][2]) - size_weight_) / 4;
    size_s_ = (size_of(rest_) - size_weight_) / 2;
    const std::array<long, 3> size{2 * size_a_, size_a_ + size_b_, 2 * size_b_};
    for (std::size_t i = 0; i < 3; ++i) {
      c_[i] = times_power_of_two(c_[i], -size[i] - size_s_ - size_weight_);
      for (std::size_t j = 0; j < 3; ++j)
        q_[i][j] = times_power_of_two(q_[i][j], -size[i] - size[j] - size_weight_);
    }
    rest_ = times_power_of_two(rest_, -2 * size_s_ - size_weight_);
    delta_ = RealBall(power_of_two(2 * (size_a_ + size_b_ - size_s_)), bits);
    describe_critical_points();
  }

  /// xᵀKx·det² − δ·det², whose roots are the λ of all critical points.
  const BallPolynomial& resolvent() const { return resolvent_; }

  /// Is Q − λK proved to be positive definite?
  bool is_convex_at(const RealBall& lambda) const {
    const auto& q = q_;
    const RealBall minor = subtract(multiply(q[0][0], add(q[1][1], lambda, bits_), bits_),
                                    multiply(q[0][1], q[0][1], bits_), bits_);
    return sign(q[0][0]) > 0 && sign(minor) > 0 && sign(evaluate(determinant_, lambda, bits_)) > 0;
  }

  /// The critical point of a λ, a root of the resolvent, where det ≠ 0; no value where x₁ < 0.
  /// Its balls may not be finite.
  std::optional<CriticalPair> pair_at(const RealBall& lambda) const {
    CriticalPair pair;
    const RealBall below = evaluate(determinant_, lambda, bits_);
    RealBall linear;  // cᵀx
    std::array<RealBall, 3> x;
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = divide(evaluate(solution_[i], lambda, bits_), below, bits_);
      linear = add_product(linear, c_[i], x[i], bits_);
    }
    // xᵀQx = cᵀx + λδ.
    const RealBall value =
        add(subtract(rest_, linear, bits_), multiply(lambda, delta_, bits_), bits_);
    if (sign(x[0]) < 0) return std::nullopt;
    pair.form = {times_power_of_two(x[0], size_s_ - 2 * size_a_),
                 times_power_of_two(x[1], size_s_ - size_a_ - size_b_),
                 times_power_of_two(x[2], size_s_ - 2 * size_b_)};
    const long size = 2 * size_s_ + size_weight_;
    pair.value = times_power_of_two(value, size);
    // J = … + λ·(xᵀKx), and xᵀKx = 1 was δ.
    pair.multiplier = times_power_of_two(multiply(lambda, delta_, bits_), size);
    return pair;
  }

 private:
  /// x = solution/determinant solves (Q − λK)x = c.
  void describe_critical_points() {
    // Q − λK has λ in the middle, and −λ/2 in the corners off the diagonal.
    std::array<std::array<BallPolynomial, 3>, 3> m;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const RealBall slope = i == 1 && j == 1
                                   ? RealBall(1, bits_)
                                   : (i + j == 2 ? RealBall(Rational(-1, 2), bits_) : RealBall());
        m[i][j] = BallPolynomial({q_[i][j], slope});
      }
    }
    const auto cofactor = [&](std::size_t i, std::size_t j) {
      const auto& up = m[(i + 1) % 3];
      const auto& down = m[(i + 2) % 3];
      return subtract(multiply(up[(j + 1) % 3], down[(j + 2) % 3], bits_),
                      multiply(up[(j + 2) % 3], down[(j + 1) % 3], bits_), bits_);
    };
    for (std::size_t j = 0; j < 3; ++j) {
      determinant_ = add(determinant_, multiply(m[0][j], cofactor(0, j), bits_), bits_);
      for (std::size_t i = 0; i < 3; ++i)
        solution_[i] = add(solution_[i], multiply(c_[j], cofactor(i, j), bits_), bits_);
    }
    const BallPolynomial norm = subtract(multiply(solution_[0], solution_[2], bits_),
                                         multiply(solution_[1], solution_[1], bits_), bits_);
    resolvent_ =
        subtract(norm, multiply(delta_, multiply(determinant_, determinant_, bits_), bits_), bits_);
  }

  long bits_;
  long size_a_ = 0;
  long size_b_ = 0;
  long size_s_ = 0;
  long size_weight_ = 0;
  std::array<std::array<RealBall, 3>, 3> q_;
  std::array<RealBall, 3> c_;
  RealBall rest_;  ///< J₀
  RealBall delta_;
  BallPolynomial determinant_;
  std::array<BallPolynomial, 3> solution_;
  BallPolynomial resolvent_;
};

/// A ball with the λ of the best pair, next to a guess; numbers of about `size` are its scale.
std::optional<RealBall> proved(const QuadraticProblem& problem, const Rational& guess,
                               const Rational& size, long bits) {
  for (long k = bits - 8; k > bits / 4; k -= std::max(bits / 16, 1L)) {
    const Rational radius = size * power_of_two(-k);
    const RealBall below(guess - radius, bits);
    const RealBall above(guess + radius, bits);
    // xᵀKx increases where Q − λK is positive definite, in between, too.
    if (!problem.is_convex_at(below) || !problem.is_convex_at(above)) return std::nullopt;
    if (sign(evaluate(problem.resolvent(), below, bits)) < 0 &&
        sign(evaluate(problem.resolvent(), above, bits)) > 0)
      return hull(Rational(guess - radius), Rational(guess + radius), bits);
  }
  return std::nullopt;
}

}  // namespace

std::optional<PlanePairs> best_in_plane(const PlaneBasis& basis, const Polynomial& s,
                                        const std::vector<RealBall>& moments, long bits) {
  const QuadraticProblem problem(basis, s, moments, bits);
  if (problem.resolvent().degree_bound() != 6 || problem.resolvent().coefficient(6).contains_zero())
    return std::nullopt;
  const long size = size_of_roots(problem.resolvent());
  const BallRoots roots = ball_roots(stretched(problem.resolvent(), size), bits);
  const auto multiplier = [&](const ComplexBall& root) {
    return times_power_of_two(root.re(), size);
  };
  std::optional<CriticalPair> best;
  for (const ComplexBall& root : roots.all) {
    if (best || !root.re().is_finite()) continue;
    const Rational guess = multiplier(root).midpoint();
    auto lambda = proved(problem, guess, abs(guess), bits);
    if (!lambda) lambda = proved(problem, guess, power_of_two(size), bits);  // as for λ = 0
    if (lambda) best = problem.pair_at(*lambda);
  }
  if (!best || !best->value.is_finite() || sign(best->form[0]) <= 0) return std::nullopt;
  PlanePairs pairs{*best, {}};
  if (!roots.are_isolated) return pairs;
  std::vector<CriticalPair> all;
  for (const ComplexBall& root : roots.all) {
    if (!root.im().is_zero()) continue;
    const auto pair = problem.pair_at(multiplier(root));
    if (!pair) continue;
    if (!pair->value.is_finite() || sign(pair->form[0]) <= 0) return pairs;
    all.push_back(*pair);
  }
  std::sort(all.begin(), all.end(), [](const CriticalPair& a, const CriticalPair& b) {
    return a.multiplier.midpoint() < b.multiplier.midpoint();
  });
  pairs.all = std::move(all);
  return pairs;
}

}  // namespace phrame
