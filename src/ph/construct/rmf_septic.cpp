#include "phrame/ph/construct/rmf_septic.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/quintic_family.hpp"

// For A = A₀·(1, b, b′, c), c = x + yi + zj + wk and n = (y, −w, z) in the basis (1, j, k),
//   h ≡ 0 ⟺ b, b′ have no i, n·b = n·b′ = 0 and b × b′ = n/3,
// for y = 0 as the limit of that; then there are others, plane ones. With κ ≈ |(z₀, w₀)|/|c₀| and
// c = c₀·e^{iπκt} the equations
//   displacement, n̂·b = n̂·b′ = 0, n̂·(b × b′) = |n|/3, n̂ = n/|n|,
// six in the seven unknowns (t, b, b′), are regular where the data are nearly plane, y ≈ 0, and
// where the tangents are nearly parallel, n ≈ 0: n/|(z₀, w₀)| has no cancellation. What remains is
// a curve of solutions.

namespace phrame {
namespace {

using ShapeVector = Eigen::Matrix<double, 7, 1>;  // t, b, b′
using Lack = Eigen::Matrix<double, 6, 1>;
using SepticJacobian = Eigen::Matrix<double, 6, 7>;
using Vector3 = Eigen::Vector3d;

/// ∫ S(A, A) = Σ w_ij S(A_i, A_j): w_ij = C(3, i)C(3, j)/(7·C(6, i + j)).
constexpr std::array<std::array<double, 4>, 4> double_weights{
    {{1. / 7, 1. / 14, 1. / 35, 1. / 140},
     {1. / 14, 3. / 35, 9. / 140, 1. / 35},
     {1. / 35, 9. / 140, 3. / 35, 1. / 14},
     {1. / 140, 1. / 35, 1. / 14, 1. / 7}}};

/// Shapes are rounded to so many bits, so that nobody's libm decides the result and planes are met.
constexpr int shape_bits = 24;

Vector3 eigen(const Vector<double>& v) { return {v[0], v[1], v[2]}; }

Quaternion<double> without_i(const Vector3& b) { return {b[0], 0, b[1], b[2]}; }

ShapeVector vector_of(const SepticShape& shape) {
  ShapeVector s;
  s << shape.turn, eigen(shape.b), eigen(shape.b_prime);
  return s;
}

SepticShape shape_of(const ShapeVector& s) {
  return {s[0], {s[1], s[2], s[3]}, {s[4], s[5], s[6]}};
}

/// e^{iπx}, exact for multiples of 1/2.
ComplexOf<double> unit_of_half_turns(double x) {
  const double quarters = std::nearbyint(2 * x);
  const double rest = std::numbers::pi * (x - quarters / 2);
  ComplexOf<double> z{std::cos(rest), std::sin(rest)};
  for (auto k = std::lround(quarters) & 3; k > 0; --k) z = {-z.im, z.re};
  return z;
}

class SepticEquations {
 public:
  explicit SepticEquations(const SepticData& data)
      : data_(data),
        across_(std::hypot(data.c0.p, data.c0.q)),
        rate_(std::numbers::pi * phase_unit(data)) {}

  /// What the equations lack, and its derivative where that is wanted.
  Lack lack(const ShapeVector& s, SepticJacobian* jacobian = nullptr) const;

 private:
  const SepticData& data_;
  double across_;  ///< |(z₀, w₀)|
  double rate_;    ///< of the phase by t
};

Lack SepticEquations::lack(const ShapeVector& s, SepticJacobian* jacobian) const {
  const CubicPreimage<double> a = septic_preimage(data_, shape_of(s));
  CubicPreimage<double> weighted{};
  Vector3 displacement = Vector3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) weighted[i] = weighted[i] + double_weights[i][j] * a[j];
    displacement += eigen(symmetric_product(a[i], weighted[i]));
  }
  // n over |(z, w)|, its derivative by t, and the same of |n| and n̂ = m.
  const Quaternion<double>& c = a[3];
  const Vector3 n{c.v / across_, -c.q / across_, c.p / across_};
  const Vector3 dn = rate_ * Vector3{c.u / across_, c.p / across_, c.q / across_};
  const double size = n.norm();
  const Vector3 m = n / size;
  const double dsize = m.dot(dn);
  const Vector3 dm = (dn - dsize * m) / size;
  const Vector3 b = s.segment<3>(1);
  const Vector3 e = s.segment<3>(4);
  const Vector3 cross = b.cross(e);
  Lack result;
  result << displacement - eigen(data_.step), m.dot(b), m.dot(e), m.dot(cross) - size * across_ / 3;
  if (jacobian == nullptr) return result;
  const auto column = [&](const Quaternion<double>& direction, std::size_t i) {
    return Vector3(2 * eigen(symmetric_product(direction, weighted[i])));
  };
  SepticJacobian& j = *jacobian;
  j.setZero();
  j.col(0) << rate_ * column(turned(c, ComplexOf<double>{0, 1}), 3), dm.dot(b), dm.dot(e),
      dm.dot(cross) - dsize * across_ / 3;
  for (int k = 0; k < 3; ++k) {
    const Quaternion<double> unit = without_i(Vector3::Unit(k));
    j.block<3, 1>(0, 1 + k) = column(unit, 1);
    j.block<3, 1>(0, 4 + k) = column(unit, 2);
  }
  j.block<1, 3>(3, 1) = m.transpose();
  j.block<1, 3>(4, 4) = m.transpose();
  j.block<1, 3>(5, 1) = e.cross(m).transpose();
  j.block<1, 3>(5, 4) = m.cross(b).transpose();
  return result;
}

/// Newton's iteration, damped, each step by `solve` of the Jacobian and of what lacks. Is it a
/// solution, as nearly as doubles are?
template <class Solve>
bool newton(const SepticData& data, ShapeVector& s, int most_steps, const Solve& solve) {
  const SepticEquations equations(data);
  const double size = std::max({1.0, norm(data.c0), eigen(data.step).norm()});
  const double enough = 1e-12 * size;
  const double rounding = 4e-16 * size;
  constexpr double least_part = 1e-3;
  SepticJacobian jacobian;
  Lack lack = equations.lack(s, &jacobian);
  double now = lack.norm();
  for (int k = 0; k < most_steps && now > rounding; ++k) {
    const ShapeVector step = solve(jacobian, lack);
    double part = 1;
    ShapeVector next = s - step;
    double then = equations.lack(next).norm();
    while (!(then < now) && part > least_part) {
      part /= 2;
      next = s - part * step;
      then = equations.lack(next).norm();
    }
    if (!(then < now)) break;
    s = next;
    lack = equations.lack(s, &jacobian);
    now = then;
  }
  return now <= enough;
}

/// To the nearest solution.
bool least_newton(const SepticData& data, ShapeVector& s, int most_steps) {
  return newton(data, s, most_steps, [](const SepticJacobian& jacobian, const Lack& lack) {
    return ShapeVector(
        Eigen::CompleteOrthogonalDecomposition<SepticJacobian>(jacobian).solve(lack));
  });
}

/// The direction in which the solutions go on.
ShapeVector along_solutions(const SepticData& data, const ShapeVector& s) {
  SepticJacobian jacobian;
  SepticEquations(data).lack(s, &jacobian);
  const Eigen::HouseholderQR<Eigen::Matrix<double, 7, 6>> qr(jacobian.transpose());
  return qr.householderQ() * ShapeVector::Unit(6);
}

/// The change in the section across this row that adds so much to what lacks. Elimination keeps
/// what is plane in its plane, but where data have more freedom, such as that to be turned about a
/// line, the least change has to be taken.
ShapeVector change_across(const SepticJacobian& jacobian, const std::array<double, 7>& row,
                          const Lack& lack) {
  constexpr double singular = 1e-10;
  constexpr double accurate = 1e-6;
  Eigen::Matrix<double, 7, 7> matrix;
  matrix << jacobian, Eigen::Map<const Eigen::Matrix<double, 1, 7>>(row.data());
  ShapeVector right;
  right << lack, 0;
  const ShapeVector change = matrix.partialPivLu().solve(right);
  if ((matrix * change - right).norm() <= accurate * right.norm() &&
      change.norm() * singular <= right.norm())
    return change;
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 7, 7>> inverse;
  inverse.setThreshold(singular);
  return inverse.compute(matrix).solve(right);
}

struct FoundSeptic {
  double energy;
  ShapeVector shape;
};

double energy_of(const SepticData& data, const ShapeVector& s) {
  return approximate_energy(septic_preimage(data, shape_of(s)));
}

/// Downhill along the curve of solutions.
FoundSeptic downhill(const SepticData& data, FoundSeptic best) {
  constexpr int most_moves = 200;
  const double size = best.shape.norm();
  double step = size / 10;
  for (int k = 0; k < most_moves && step > size / 1000; ++k) {
    const ShapeVector direction = along_solutions(data, best.shape);
    const double before = best.energy;
    for (const double d : {step, -step}) {
      ShapeVector next = best.shape + d * direction;
      if (!least_newton(data, next, 12)) continue;
      const double energy = energy_of(data, next);
      if (!(energy < before * (1 - 1e-9))) continue;
      best = {energy, next};
      break;
    }
    if (best.energy == before) step /= 2;
  }
  return best;
}

/// The quintic as a cubic preimage; its phase is limited, for nearly parallel ends.
ShapeVector near_quintic(const SepticData& data, const QuinticFamily::Member& a, double delta) {
  const auto parts = [](const Quaternion<double>& q) { return Vector3{q.u, q.p, q.q}; };
  ShapeVector s;
  s << std::clamp(delta / (std::numbers::pi * phase_unit(data)), -1.0, 1.0),
      parts((1.0 / 3) * (a[0] + 2.0 * a[1])), parts((1.0 / 3) * (2.0 * a[1] + a[2]));
  return s;
}

/// The best of the solutions next to quintics with these Δ, and downhill from there.
std::optional<FoundSeptic> best_near(const SepticData& data, const QuinticFamily& family,
                                     std::initializer_list<double> deltas) {
  std::optional<FoundSeptic> best;
  for (const double delta : deltas)
    for (const double phi : {0.0, 0.4, -0.4}) {
      ShapeVector s = near_quintic(data, family.member(delta, phi), delta);
      if (!least_newton(data, s, 40)) continue;
      const double energy = energy_of(data, s);
      if (!best || energy < best->energy) best = FoundSeptic{energy, s};
    }
  if (best) best = downhill(data, *best);
  return best;
}

double rounded_double(double x, int bits) {
  return std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits);
}

}  // namespace

double phase_unit(const SepticData& data) {
  const double across = std::hypot(data.c0.p, data.c0.q);
  return std::ldexp(1.0, std::ilogb(across / std::hypot(data.c0.u, across)));
}

std::optional<SepticShape> rmf_septic(const SepticData& data) {
  // Beyond this, beside the quintic, it is worth while to look elsewhere.
  constexpr double poor = 1.25;
  const QuinticFamily family({data.step, {1, 0, 0}, rotated_i(data.c0)});
  const double automatic =
      std::numbers::pi *
      static_cast<double>(family.choose(QuinticSelection::automatic).delta.half_turns);
  auto best = best_near(data, family, {0, automatic});
  if (!best || !(best->energy < poor * approximate_energy(family.member(automatic, 0)))) {
    const auto other =
        best_near(data, family, {0.4, -0.4, 0.8, -0.8, 1.5, -1.5, 2.5, -2.5, std::numbers::pi});
    if (other && !(best && best->energy <= other->energy)) best = other;
  }
  if (!best) return std::nullopt;
  ShapeVector& s = best->shape;
  const int bits = shape_bits - std::ilogb(std::max(s.tail<6>().cwiseAbs().maxCoeff(), 0x1p-100));
  s[0] = rounded_double(s[0], shape_bits);
  for (int k = 1; k < 7; ++k) s[k] = rounded_double(s[k], bits);
  return shape_of(s);
}

CubicPreimage<double> septic_preimage(const SepticData& data, const SepticShape& shape) {
  return {{{1, 0, 0, 0},
           {shape.b[0], 0, shape.b[1], shape.b[2]},
           {shape.b_prime[0], 0, shape.b_prime[1], shape.b_prime[2]},
           turned(data.c0, unit_of_half_turns(phase_unit(data) * shape.turn))}};
}

SepticSection::SepticSection(const SepticData& data, const SepticShape& shape)
    : data_(data), across_{1, 0, 0, 0, 0, 0, 0}, solution_(shape) {
  constexpr double small_angle = 0x1p-4;
  constexpr int short_bits = 8;
  ShapeVector s = vector_of(shape);
  const ShapeVector direction = along_solutions(data_, s);
  keeps_phase_ = std::abs(direction[0]) >= small_angle;
  if (!keeps_phase_)
    for (std::size_t k = 0; k < 7; ++k)
      across_[k] = rounded_double(direction[static_cast<Eigen::Index>(k)], short_bits);
  const bool found = newton(data_, s, 12, [&](const SepticJacobian& jacobian, const Lack& lack) {
    ShapeVector step = change_across(jacobian, across_, lack);
    if (keeps_phase_) step[0] = 0;
    return step;
  });
  if (found) solution_ = shape_of(s);
}

std::vector<double> SepticSection::change(const std::vector<double>& of_step) const {
  SepticJacobian jacobian;
  SepticEquations(data_).lack(vector_of(solution_), &jacobian);
  Lack lack = Lack::Zero();
  lack.head<3>() = Vector3{of_step[0], of_step[1], of_step[2]};
  ShapeVector result = change_across(jacobian, across_, lack);
  if (keeps_phase_) result[0] = 0;
  return {result.begin(), result.end()};
}

}  // namespace phrame
