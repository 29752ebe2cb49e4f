// Newton's steps s are those of a problem with constraints,
//   [W Gᵀ][s]   [−g]
//   [G 0 ][λ] = [−r],   G the Jacobian of the equations, r their residuals.
// W belongs to Q(Z) = ZᵀWZ = Σ |J_{k−1} − 2Z_k + J_k|²·h̄/h_k, J_k the values of A at the joints,
// which is a measure of A″: it is 0 where A is linear in the parameter, as that of a PH cubic is.
// With g = WZ the step goes to small Q, with g = 0 it changes A″ the least. A few steps are of the
// former sort, and more of them as long as Q falls to less than a half, as it does to 0 where there
// is a PH cubic; then those of the latter sort converge quadratically. To go on to the least Q
// makes the curves no better, and does not always converge. The equation of a segment, or of an
// end, is next to a Z of its own, so that all is banded, with corners where the spline is closed:
// the cost is O(N).
#include "phrame/ph/construct/c2_equations.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>

#include "phrame/ph/construct/c2_start.hpp"
#include "phrame/ph/construct/preimage.hpp"

namespace phrame::inline v0 {
namespace {

using Guess = Quaternion<double>;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
using Part = double Guess::*;

/// A at a joint: a mean of two coefficients.
struct JointMean {
  std::size_t before;
  std::size_t after;
  double weight_before;
  double weight_after;
};

class C2Equations {
 public:
  C2Equations(const C2Data& data, double closing_sign);

  /// Of the system, whose blocks have the parts of one Z and the multipliers of one equation: −r
  /// and, where it is to descend from Z, −WZ.
  Eigen::VectorXd right_side(const Eigen::VectorXd& residuals,
                             const std::vector<Guess>* descends_from) const;
  /// The parts of Z in it.
  std::vector<double> change(const Eigen::VectorXd& solution) const;

  Eigen::VectorXd residuals(const std::vector<Guess>& z) const;
  /// Of the chords.
  double scale() const { return scale_; }
  double objective(const std::vector<Guess>& z) const;
  SparseMatrix matrix(const std::vector<Guess>& z) const;
  std::vector<Guess> moved(std::vector<Guess> z, double factor,
                           const Eigen::VectorXd& solution) const;
  /// The middle ones as means of the values at the joints.
  std::vector<Guess> from_joints(const std::vector<Guess>& q) const;
  /// Moved by about the size of A, at random.
  std::vector<Guess> scattered(std::vector<Guess> z, std::mt19937_64& engine) const;

 private:
  std::size_t block() const { return parts_.size() + dimension_; }
  std::size_t unknown(std::size_t k, std::size_t p) const { return block() * k + p; }
  Eigen::Index index(std::size_t k, std::size_t p) const {
    return static_cast<Eigen::Index>(unknown(k, p));
  }
  std::size_t middle(std::size_t k) const { return data_.is_closed ? k : k + 1; }
  Guess joint(const std::vector<Guess>& z, std::size_t k) const {
    const JointMean& j = joints_[k];
    return j.weight_before * z[j.before] + j.weight_after * z[j.after];
  }
  /// @{ J_{k−1} − 2Z_k + J_k, and as a combination of Z.
  Guess second_difference(const std::vector<Guess>& z, std::size_t k) const;
  std::array<std::pair<std::size_t, double>, 5> second_difference(std::size_t k) const;
  /// @}
  double weight(std::size_t k) const { return mean_step_ / data_.steps[k]; }

  const C2Data& data_;
  std::vector<Part> parts_;
  std::size_t dimension_;  ///< of the space
  std::vector<JointMean> joints_;
  std::size_t coefficients_;
  std::size_t equations_;
  double mean_step_;
  double scale_;
};

C2Equations::C2Equations(const C2Data& data, double closing_sign)
    : data_(data),
      dimension_(data.is_plane ? 2 : 3),
      coefficients_(data.is_closed ? data.steps.size() : data.steps.size() + 2),
      equations_(dimension_ * coefficients_) {
  parts_ = data.is_plane ? std::vector<Part>{&Guess::u, &Guess::q}
                         : std::vector<Part>{&Guess::u, &Guess::v, &Guess::p, &Guess::q};
  const std::size_t n = data.steps.size();
  for (std::size_t k = 0; k <= n; ++k) {
    const double before = data.steps[k > 0 ? k - 1 : data.is_closed ? n - 1 : 0];
    const double after = data.steps[k < n ? k : data.is_closed ? 0 : n - 1];
    JointMean joint{k, k + 1, after / (before + after), before / (before + after)};
    if (data.is_closed) {
      joint.before = k > 0 ? k - 1 : n - 1;
      joint.after = k < n ? k : 0;
      if (k == 0) joint.weight_before *= closing_sign;
      if (k == n) joint.weight_after *= closing_sign;
    }
    joints_.push_back(joint);
  }
  mean_step_ = std::accumulate(data.steps.begin(), data.steps.end(), 0.0) / static_cast<double>(n);
  double sum = 0;
  for (const Vector<double>& chord : data.chords) sum += dot(chord, chord);
  if (sum == 0)  // a loop
    for (const auto& d : {data.derivatives.front(), data.derivatives.back()})
      sum += mean_step_ * mean_step_ * dot(d, d);
  scale_ = std::sqrt(sum);
}

Eigen::VectorXd C2Equations::residuals(const std::vector<Guess>& z) const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(equations_));
  Eigen::Index next = 0;
  const auto put = [&](const Vector<double>& v) {
    for (std::size_t c = 0; c < dimension_; ++c) result[next++] = v[c];
  };
  const std::size_t n = data_.steps.size();
  const auto put_end = [&](double step, const Guess& a, const Vector<double>& wanted) {
    if (!data_.is_closed) put(step * (rotated_i(a) - wanted));
  };
  put_end(data_.steps.front(), joint(z, 0), data_.derivatives.front());
  for (std::size_t k = 0; k < n; ++k) {
    const Guess a = joint(z, k);
    const Guess c = joint(z, k + 1);
    put(data_.steps[k] / 120 * integral_times_120(a, z[middle(k)], c) - data_.chords[k]);
  }
  put_end(data_.steps.back(), joint(z, n), data_.derivatives.back());
  return result;
}

std::array<std::pair<std::size_t, double>, 5> C2Equations::second_difference(std::size_t k) const {
  const JointMean& a = joints_[k];
  const JointMean& c = joints_[k + 1];
  return {{{a.before, a.weight_before},
           {a.after, a.weight_after},
           {middle(k), -2},
           {c.before, c.weight_before},
           {c.after, c.weight_after}}};
}

Guess C2Equations::second_difference(const std::vector<Guess>& z, std::size_t k) const {
  return joint(z, k) - 2.0 * z[middle(k)] + joint(z, k + 1);
}

double C2Equations::objective(const std::vector<Guess>& z) const {
  double sum = 0;
  for (std::size_t k = 0; k < data_.steps.size(); ++k)
    sum += weight(k) * norm(second_difference(z, k));
  return sum;
}

SparseMatrix C2Equations::matrix(const std::vector<Guess>& z) const {
  constexpr double regular = 1e-9;  // for W is singular
  const std::size_t n = data_.steps.size();
  Triplets entries;
  const auto put = [&](std::size_t row, std::size_t column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (std::size_t k = 0; k < coefficients_; ++k)
    for (std::size_t p = 0; p < parts_.size(); ++p) put(unknown(k, p), unknown(k, p), regular);
  for (std::size_t k = 0; k < n; ++k) {
    const auto difference = second_difference(k);
    for (const auto& [i, x] : difference)
      for (const auto& [j, y] : difference)
        for (std::size_t p = 0; p < parts_.size(); ++p)
          put(unknown(i, p), unknown(j, p), weight(k) * x * y);
  }
  /// ∂/∂Z_j of S(2a, Z_j·factor), from the given equation on.
  const auto put_product = [&](std::size_t equation, const Guess& a, std::size_t j, double factor) {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      Guess unit{};
      unit.*parts_[p] = factor;
      const Vector<double> v = symmetric_product(a, unit);
      for (std::size_t c = 0; c < dimension_; ++c) {
        const std::size_t row = unknown(equation, parts_.size() + c);
        put(row, unknown(j, p), v[c]);
        put(unknown(j, p), row, v[c]);
      }
    }
  };
  const auto put_joint = [&](std::size_t equation, const Guess& a, std::size_t k) {
    put_product(equation, a, joints_[k].before, joints_[k].weight_before);
    put_product(equation, a, joints_[k].after, joints_[k].weight_after);
  };
  for (std::size_t k = 0; k < n; ++k) {
    const Guess a = joint(z, k);
    const Guess b = z[middle(k)];
    const Guess c = joint(z, k + 1);
    const double h = data_.steps[k] / 15;
    const std::size_t equation = middle(k);
    put_joint(equation, h * (6.0 * a + 3.0 * b + c), k);
    put_product(equation, h * (3.0 * a + 4.0 * b + 3.0 * c), middle(k), 1);
    put_joint(equation, h * (a + 3.0 * b + 6.0 * c), k + 1);
  }
  if (!data_.is_closed) {
    put_joint(0, 2 * data_.steps.front() * joint(z, 0), 0);
    put_joint(n + 1, 2 * data_.steps.back() * joint(z, n), n);
  }
  const auto all = static_cast<Eigen::Index>(coefficients_ * block());
  SparseMatrix result(all, all);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::VectorXd C2Equations::right_side(const Eigen::VectorXd& residuals,
                                        const std::vector<Guess>* descends_from) const {
  Eigen::VectorXd result =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(coefficients_ * block()));
  for (std::size_t k = 0; k < coefficients_; ++k)
    for (std::size_t c = 0; c < dimension_; ++c)
      result[index(k, parts_.size() + c)] =
          -residuals[static_cast<Eigen::Index>(dimension_ * k + c)];
  if (descends_from == nullptr) return result;
  for (std::size_t k = 0; k < data_.steps.size(); ++k) {
    const Guess difference = weight(k) * second_difference(*descends_from, k);
    for (const auto& [at, factor] : second_difference(k))
      for (std::size_t p = 0; p < parts_.size(); ++p)
        result[index(at, p)] -= factor * difference.*parts_[p];
  }
  return result;
}

std::vector<double> C2Equations::change(const Eigen::VectorXd& solution) const {
  std::vector<double> result;
  for (std::size_t k = 0; k < coefficients_; ++k)
    for (std::size_t p = 0; p < parts_.size(); ++p) result.push_back(solution[index(k, p)]);
  return result;
}

std::vector<Guess> C2Equations::moved(std::vector<Guess> z, double factor,
                                      const Eigen::VectorXd& solution) const {
  for (std::size_t k = 0; k < z.size(); ++k)
    for (std::size_t p = 0; p < parts_.size(); ++p)
      z[k].*parts_[p] += factor * solution[index(k, p)];
  return z;
}

std::vector<Guess> C2Equations::from_joints(const std::vector<Guess>& q) const {
  std::vector<Guess> z(coefficients_);
  const std::size_t n = data_.steps.size();
  for (std::size_t k = 0; k < n; ++k) z[middle(k)] = 0.5 * (q[k] + q[k + 1]);
  if (!data_.is_closed) {
    z.front() = 2.0 * q.front() - z[1];
    z.back() = 2.0 * q.back() - z[n];
  }
  return z;
}

std::vector<Guess> C2Equations::scattered(std::vector<Guess> z, std::mt19937_64& engine) const {
  const double mean_chord = scale_ / std::sqrt(static_cast<double>(data_.steps.size()));
  const double size = std::sqrt(mean_chord / mean_step_);
  // As many on all machines, unlike std::uniform_real_distribution.
  const auto number = [&] { return std::ldexp(static_cast<double>(engine() >> 12), -51) - 1; };
  for (Guess& a : z)
    for (const Part part : parts_) a.*part += size * number();
  return z;
}

using Decomposition = Eigen::SparseLU<SparseMatrix, Eigen::NaturalOrdering<int>>;

/// Z and its residuals.
struct C2Point {
  std::vector<Guess> z;
  Eigen::VectorXd residuals;
};

/// The first of Z + change, Z + change/2, … whose residuals are within the bound; else the last.
C2Point within_bound(const C2Equations& equations, const std::vector<Guess>& z,
                     const Eigen::VectorXd& change, double bound) {
  constexpr double least_factor = 1e-3;
  for (double factor = 1;; factor /= 2) {
    C2Point next{equations.moved(z, factor, change), {}};
    next.residuals = equations.residuals(next.z);
    if (!(factor > least_factor) || next.residuals.norm() <= bound) return next;
  }
}

/// From there or, with an engine, from coefficients scattered about it.
std::optional<C2Coefficients> coefficients_from(const C2Data& data,
                                                const std::vector<Vector<double>>& derivatives,
                                                std::mt19937_64* engine = nullptr) {
  constexpr int most_steps = 60;
  constexpr int least_descents = 2;
  constexpr int most_descents = 12;
  constexpr double rounding = 1e-14;
  constexpr double enough = 1e-10;  // exact refinement goes on from there
  C2Coefficients found;
  const std::vector<Guess> joints = first_joints(data, derivatives, found.closing_sign);
  const C2Equations equations(data, found.closing_sign);
  std::vector<Guess>& z = found.z;
  z = equations.from_joints(joints);
  if (engine != nullptr) z = equations.scattered(std::move(z), *engine);
  const double scale = equations.scale();
  double objective = equations.objective(z);
  Eigen::VectorXd residuals = equations.residuals(z);
  Decomposition decomposition;
  bool descends = true;
  for (int step = 0; step < most_steps; ++step) {
    const double size = residuals.norm();
    if (!std::isfinite(size)) return std::nullopt;
    if (!descends && size <= rounding * scale) break;
    const SparseMatrix matrix = equations.matrix(z);
    if (step == 0) decomposition.analyzePattern(matrix);
    decomposition.factorize(matrix);
    if (decomposition.info() != Eigen::Success) return std::nullopt;
    const Eigen::VectorXd change =
        decomposition.solve(equations.right_side(residuals, descends ? &z : nullptr));
    if (!change.allFinite()) return std::nullopt;
    const double bound = (descends ? std::max(1.5 * size, scale) : size) + rounding * scale;
    C2Point next = within_bound(equations, z, change, bound);
    const bool has_converged =
        !descends && !(next.residuals.norm() < size / 2) && size <= enough * scale;
    if (has_converged) break;
    z = std::move(next.z);
    residuals = std::move(next.residuals);
    const double next_objective = equations.objective(z);
    if (descends && ((step + 1 >= least_descents && next_objective > objective / 2) ||
                     step + 1 >= most_descents))
      descends = false;
    objective = next_objective;
  }
  if (!(residuals.norm() <= enough * scale)) return std::nullopt;
  return found;
}

}  // namespace

std::optional<C2Coefficients> c2_coefficients(const C2Data& data) {
  if (auto found = coefficients_from(data, data.derivatives)) return found;
  for (const double haste : {0.0, 0.5, 0.25, 0.75, 1.0})
    if (auto found = coefficients_from(data, calm_derivatives(data, haste))) return found;
  // Where all is on one line, with a way back, all that can be reached from there is on it, too.
  constexpr int most_scattered = 12;
  std::mt19937_64 engine;
  std::optional<C2Coefficients> best;
  double least = 0;
  for (int k = 0; k < most_scattered; ++k)
    if (auto found = coefficients_from(data, data.derivatives, &engine)) {
      const double objective = C2Equations(data, found->closing_sign).objective(found->z);
      if (best && !(objective < least)) continue;
      best = std::move(found);
      least = objective;
    }
  return best;
}

ParameterStep c2_step(const C2Data& data, const C2Coefficients& at) {
  struct Solver {
    Solver(C2Data of, double closing_sign) : data(std::move(of)), equations(data, closing_sign) {}
    C2Data data;
    C2Equations equations;
    Decomposition decomposition;
  };
  const auto solver = std::make_shared<Solver>(data, at.closing_sign);
  solver->decomposition.compute(solver->equations.matrix(at.z));
  return [solver](const std::vector<double>& wanted) {
    const C2Equations& equations = solver->equations;
    const Eigen::VectorXd lacking =
        -Eigen::Map<const Eigen::VectorXd>(wanted.data(), static_cast<Eigen::Index>(wanted.size()));
    return equations.change(solver->decomposition.solve(equations.right_side(lacking, nullptr)));
  };
}

}  // namespace phrame
