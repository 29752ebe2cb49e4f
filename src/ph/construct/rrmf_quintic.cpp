#include "phrame/ph/construct/rrmf_quintic.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/quintic_family.hpp"

// Five equations for six unknowns. From members of the family of quintics with these ends and
// the speed of the chord, damped Gauss–Newton steps of least change; then along the kernel of
// the derivative as long as energy times length falls.

namespace phrame {
namespace {

using Unknowns = Eigen::Matrix<double, 6, 1>;
using Defect = Eigen::Matrix<double, 5, 1>;
using Derivative = Eigen::Matrix<double, 5, 6>;
using Rrmf = RrmfQuintic<double>;

Unknowns unknowns(const Rrmf& x) {
  Unknowns z;
  z << x.b.u, x.b.v, x.b.p, x.b.q, x.tau, x.f;
  return z;
}

Rrmf quintic_of(const Unknowns& z) { return {{z[0], z[1], z[2], z[3]}, z[4], z[5]}; }

Defect defect(const Unknowns& z, const RrmfEnds<double>& wanted) {
  const std::array<double, 5> x = rrmf_defect(quintic_of(z), wanted);
  return Eigen::Map<const Defect>(x.data());
}

Derivative derivative(const Unknowns& z, const RrmfEnds<double>& wanted) {
  Derivative result;
  for (Eigen::Index k = 0; k < 6; ++k) {
    const double h = 0x1p-17 * std::max(1.0, std::abs(z[k]));
    const Unknowns e = h * Unknowns::Unit(k);
    result.col(k) = (defect(z + e, wanted) - defect(z - e, wanted)) / (2 * h);
  }
  return result;
}

/// Of the least singular value.
Unknowns kernel(const Derivative& j) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(j, Eigen::ComputeFullV).matrixV().col(5);
}

/// ∫κ² ds times the length: it is the same for every size, so that nothing is gained by a great
/// loop.
double cost(const Unknowns& z) {
  const Rrmf x = quintic_of(z);
  const std::array<Quaternion<double>, 3> a{{{1, 0, 0, 0}, x.b, last_coefficient(x)}};
  const double size_of_middle = norm(3.0 * (a[0] + a[2]) + 4.0 * a[1]);
  const double length =
      (size_of_middle + 15 * (1 + norm(a[2])) - 10 * hermitian_product(a[0], a[2]).re) / 120;
  return length * approximate_energy(a);
}

/// Does the curve end as wanted? q is not 0, and does not point the other way: a direction has its
/// preimages, all of one complex line, so it cannot.
bool is_solution(const Unknowns& z, const RrmfEnds<double>& wanted) {
  constexpr double least_end = 1e-3;
  return z.allFinite() && z[5] > 0 && defect(z, wanted).norm() < 1e-11 &&
         norm(last_coefficient(quintic_of(z))) > least_end * least_end;
}

Unknowns solved(Unknowns z, const RrmfEnds<double>& wanted, int most_steps) {
  Defect off = defect(z, wanted);
  for (int k = 0; k < most_steps && off.norm() > 1e-15; ++k) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(derivative(z, wanted),
                                                Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Unknowns change = svd.solve(off);
    double part = 1;
    Unknowns next = z - change;
    Defect next_off = defect(next, wanted);
    while (!(next_off.norm() < off.norm()) && part > 1e-4) {
      part /= 2;
      next = z - part * change;
      next_off = defect(next, wanted);
    }
    if (!(next_off.norm() < off.norm())) break;
    z = next;
    off = next_off;
  }
  return z;
}

/// Downhill along the solutions.
Unknowns slid(Unknowns z, const RrmfEnds<double>& wanted) {
  double here = cost(z);
  int passes = 200;
  for (double step = 0.1 * z.norm(); step > 1e-3 && passes > 0; --passes) {
    const Unknowns along = kernel(derivative(z, wanted));
    bool has_moved = false;
    for (const double s : {step, -step}) {
      const Unknowns next = solved(z + s * along, wanted, 12);
      if (!is_solution(next, wanted)) continue;
      const double there = cost(next);
      if (!(there < here * (1 - 1e-9))) continue;
      z = next;
      here = there;
      has_moved = true;
      break;
    }
    if (!has_moved) step /= 2;
  }
  return z;
}

/// A₀, A₁, A₂ and the multiplier f, brought to A₀ = 1.
Unknowns start_from(const QuinticFamily::Member& a) {
  const double n = norm(a[0]);
  const Quaternion<double> b = (1 / n) * (conjugate(a[0]) * a[1]);
  return unknowns({b, hermitian_product(a[0], a[2]).im / n, n});
}

}  // namespace

JacobianRows rrmf_jacobian(const RrmfQuintic<double>& x, const RrmfEnds<double>& wanted) {
  const Derivative j = derivative(unknowns(x), wanted);
  JacobianRows rows;
  for (const auto& row : j.rowwise()) rows.emplace_back(row.begin(), row.end());
  return rows;
}

std::size_t freest_parameter(const RrmfQuintic<double>& x, const RrmfEnds<double>& wanted) {
  Eigen::Index index = 0;
  kernel(derivative(unknowns(x), wanted)).cwiseAbs().maxCoeff(&index);
  return static_cast<std::size_t>(index);
}

std::optional<RrmfQuintic<double>> rrmf_quintic(const RrmfEnds<double>& wanted) {
  const double length = std::sqrt(dot(wanted.step, wanted.step));
  const Vector<double> direction = rotated_i(wanted.end);
  std::optional<Unknowns> best;
  double least = 0;
  const QuinticFamily family(
      {wanted.step, {length, 0, 0}, length / std::sqrt(dot(direction, direction)) * direction});
  for (const double delta : {0.0, 0.5, -0.5, 1.2, -1.2, 2.2, -2.2, 3.0})
    for (const double phi : {0.0, 0.7, -0.7}) {
      const Unknowns found = solved(start_from(family.member(delta, phi)), wanted, 40);
      if (!is_solution(found, wanted)) continue;
      const double there = cost(found);
      if (best && !(there < least)) continue;
      best = found;
      least = there;
    }
  if (!best) return std::nullopt;
  return quintic_of(slid(*best, wanted));
}

}  // namespace phrame
