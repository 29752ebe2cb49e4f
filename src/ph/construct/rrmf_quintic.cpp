#include "phrame/ph/construct/rrmf_quintic.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/least_squares.hpp"
#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/construct/solution_curve.hpp"

// Five equations for six unknowns. From members of the family of quintics with these ends and
// the speed of the chord, damped Gauss–Newton steps of least change; then along the kernel of
// the derivative as long as energy times length falls.

namespace phrame::inline v0 {
namespace {

using Unknowns = std::array<double, 6>;
using Defect = std::array<double, 5>;
using Rrmf = RrmfQuintic<double>;

Unknowns unknowns(const Rrmf& x) { return {x.b.u, x.b.v, x.b.p, x.b.q, x.tau, x.f}; }

Rrmf quintic_of(const Unknowns& z) { return {{z[0], z[1], z[2], z[3]}, z[4], z[5]}; }

Defect defect(const Unknowns& z, const RrmfEnds<double>& wanted) {
  return rrmf_defect(quintic_of(z), wanted);
}

JacobianRows derivative(const Unknowns& z, const RrmfEnds<double>& wanted) {
  JacobianRows rows(5);
  for (std::size_t k = 0; k < 6; ++k) {
    const double h = 0x1p-17 * std::max(1.0, std::abs(z[k]));
    Unknowns above = z;
    Unknowns below = z;
    above[k] += h;
    below[k] -= h;
    const Defect a = defect(above, wanted);
    const Defect b = defect(below, wanted);
    for (std::size_t y = 0; y < 5; ++y) rows[y].push_back((a[y] - b[y]) / (2 * h));
  }
  return rows;
}

/// The direction in which the solutions go on.
std::vector<double> along_rrmf(const Unknowns& z, const RrmfEnds<double>& wanted) {
  return least_singular_vector(derivative(z, wanted));
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
  return std::ranges::all_of(z, [](double x) { return std::isfinite(x); }) && z[5] > 0 &&
         euclidean_norm(defect(z, wanted)) < 1e-11 &&
         norm(last_coefficient(quintic_of(z))) > least_end * least_end;
}

Unknowns solved(Unknowns z, const RrmfEnds<double>& wanted, int most_steps) {
  constexpr double known = 1e-9;  // the derivative by differences
  damped_newton(
      z, [&](const Unknowns& at) { return defect(at, wanted); },
      [&](const Unknowns& at, const Defect& off) {
        return LeastSquares(derivative(at, wanted), known)(off);
      },
      most_steps, 1e-15, 1e-4);
  return z;
}

/// Downhill along the solutions.
Unknowns slid(Unknowns z, const RrmfEnds<double>& wanted) {
  slide_downhill(
      z, 0.1 * euclidean_norm(z), 1e-3, [&](const Unknowns& at) { return along_rrmf(at, wanted); },
      [&](Unknowns& at) {
        at = solved(at, wanted, 12);
        return is_solution(at, wanted);
      },
      cost);
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
  return derivative(unknowns(x), wanted);
}

std::size_t freest_parameter(const RrmfQuintic<double>& x, const RrmfEnds<double>& wanted) {
  const std::vector<double> along = along_rrmf(unknowns(x), wanted);
  const auto greatest = std::ranges::max_element(along, {}, [](double a) { return std::abs(a); });
  return static_cast<std::size_t>(greatest - along.begin());
}

std::optional<RrmfQuintic<double>> rrmf_quintic(const RrmfEnds<double>& wanted) {
  const double length = std::sqrt(dot(wanted.step, wanted.step));
  const Vector<double> direction = rotated_i(wanted.end);
  constexpr int most_steps = 80;
  std::optional<Unknowns> best;
  double least = 0;
  const QuinticFamily family(
      {wanted.step, {length, 0, 0}, length / std::sqrt(dot(direction, direction)) * direction});
  for (const double delta : {0.0, 0.5, -0.5, 1.2, -1.2, 2.2, -2.2, 3.0})
    for (const double phi : {0.0, 0.7, -0.7}) {
      const Unknowns found = solved(start_from(family.member(delta, phi)), wanted, most_steps);
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
