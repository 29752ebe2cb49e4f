#include "phrame/ph/construct/rmf_septic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/construct/solution_curve.hpp"

// For A = A₀·(1, b, b′, c), c = x + yi + zj + wk and n = (y, −w, z) in the basis (1, j, k),
//   h ≡ 0 ⟺ b, b′ have no i, n·b = n·b′ = 0 and b × b′ = n/3,
// for y = 0 as the limit of that; then there are others, plane ones. With κ ≈ |(z₀, w₀)|/|c₀| and
// c = c₀·e^{iπκt} the equations
//   displacement, n̂·b = n̂·b′ = 0, n̂·(b × b′) = |n|/3, n̂ = n/|n|,
// six in the seven unknowns (t, b, b′), are regular where the data are nearly plane, y ≈ 0, and
// where the tangents are nearly parallel, n ≈ 0: n/|(z₀, w₀)| has no cancellation. What remains is
// a curve of solutions.

namespace phrame::inline v0 {
namespace {

using ShapeVector = std::array<double, 7>;  // t, b, b′
using Lack = std::array<double, 6>;
using Vector3 = Vector<double>;

/// ∫ S(A, A) = Σ w_ij S(A_i, A_j): w_ij = C(3, i)C(3, j)/(7·C(6, i + j)).
constexpr std::array<std::array<double, 4>, 4> double_weights{
    {{1. / 7, 1. / 14, 1. / 35, 1. / 140},
     {1. / 14, 3. / 35, 9. / 140, 1. / 35},
     {1. / 35, 9. / 140, 3. / 35, 1. / 14},
     {1. / 140, 1. / 35, 1. / 14, 1. / 7}}};

/// Shapes are rounded to so many bits, so that nobody's libm decides the result and planes are met.
constexpr int shape_bits = 24;

Quaternion<double> without_i(const Vector3& b) { return {b[0], 0, b[1], b[2]}; }

ShapeVector vector_of(const SepticShape& shape) {
  const auto& [turn, b, e] = shape;
  return {turn, b[0], b[1], b[2], e[0], e[1], e[2]};
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
  Lack lack(const ShapeVector& s, DoubleRows* jacobian = nullptr) const;

 private:
  const SepticData& data_;
  double across_;  ///< |(z₀, w₀)|
  double rate_;    ///< of the phase by t
};

Lack SepticEquations::lack(const ShapeVector& s, DoubleRows* jacobian) const {
  const CubicPreimage<double> a = septic_preimage(data_, shape_of(s));
  CubicPreimage<double> weighted{};
  Vector3 displacement{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) weighted[i] = weighted[i] + double_weights[i][j] * a[j];
    displacement = displacement + symmetric_product(a[i], weighted[i]);
  }
  // n over |(z, w)|, its derivative by t, and the same of |n| and n̂ = m.
  const Quaternion<double>& c = a[3];
  const Vector3 n{c.v / across_, -c.q / across_, c.p / across_};
  const Vector3 dn = rate_ * Vector3{c.u / across_, c.p / across_, c.q / across_};
  const double size = euclidean_norm(n);
  const Vector3 m = (1 / size) * n;
  const double dsize = dot(m, dn);
  const Vector3 dm = (1 / size) * (dn - dsize * m);
  const auto& [turn, b, e] = shape_of(s);
  const Vector3 product = cross(b, e);
  const Vector3 off = displacement - data_.step;
  const Lack result{off[0],    off[1],    off[2],
                    dot(m, b), dot(m, e), dot(m, product) - size * across_ / 3};
  if (jacobian == nullptr) return result;
  DoubleRows& j = *jacobian;
  j.assign(6, std::vector<double>(7, 0.0));
  const auto put_column = [&](std::size_t x, const Quaternion<double>& direction, std::size_t i) {
    const Vector3 change = 2.0 * symmetric_product(direction, weighted[i]);
    for (std::size_t y = 0; y < 3; ++y) j[y][x] = change[y];
  };
  const auto put_row = [&](std::size_t y, std::size_t first, const Vector3& row) {
    std::ranges::copy(row, j[y].begin() + static_cast<std::ptrdiff_t>(first));
  };
  put_column(0, rate_ * turned(c, ComplexOf<double>{0, 1}), 3);
  j[3][0] = dot(dm, b);
  j[4][0] = dot(dm, e);
  j[5][0] = dot(dm, product) - dsize * across_ / 3;
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3 unit{};
    unit[k] = 1;
    put_column(1 + k, without_i(unit), 1);
    put_column(4 + k, without_i(unit), 2);
  }
  put_row(3, 1, m);
  put_row(4, 4, m);
  put_row(5, 1, cross(e, m));
  put_row(5, 4, cross(m, b));
  return result;
}

/// Newton's iteration, each step by `solve` of the Jacobian and of what lacks. Is it a solution, as
/// nearly as doubles are?
template <class Solve>
bool newton(const SepticData& data, ShapeVector& s, int most_steps, const Solve& solve) {
  const SepticEquations equations(data);
  const double size = std::max({1.0, norm(data.c0), euclidean_norm(data.step)});
  const auto step = [&](const ShapeVector& at, const Lack& lack) {
    DoubleRows jacobian;
    equations.lack(at, &jacobian);
    return solve(jacobian, lack);
  };
  return damped_newton(
             s, [&](const ShapeVector& at) { return equations.lack(at); }, step, most_steps,
             4e-16 * size, 1e-3) <= 1e-12 * size;
}

/// To the nearest solution.
bool least_newton(const SepticData& data, ShapeVector& s, int most_steps) {
  constexpr double rounding = 0x1p-50;
  return newton(data, s, most_steps, [](const DoubleRows& jacobian, const Lack& lack) {
    return LeastSquares(jacobian, rounding)(lack);
  });
}

/// The direction in which the solutions go on.
std::vector<double> along_solutions(const SepticData& data, const ShapeVector& s) {
  DoubleRows jacobian;
  SepticEquations(data).lack(s, &jacobian);
  return least_singular_vector(jacobian);
}

/// The change in the section across this row that adds so much to what lacks. Elimination keeps
/// what is plane in its plane, but where data have more freedom, such as that to be turned about a
/// line, the least change has to be taken.
std::vector<double> change_across(DoubleRows jacobian, const ShapeVector& row, const Lack& lack) {
  constexpr double singular = 1e-10;
  constexpr double accurate = 1e-6;
  jacobian.emplace_back(row.begin(), row.end());
  std::vector<double> right(lack.begin(), lack.end());
  right.push_back(0);
  std::vector<double> change = eliminated(jacobian, right);
  std::vector<double> off = right;
  for (std::size_t y = 0; y < off.size(); ++y)
    off[y] -= std::inner_product(change.begin(), change.end(), jacobian[y].begin(), 0.0);
  const double size = euclidean_norm(right);
  if (euclidean_norm(off) <= accurate * size && euclidean_norm(change) * singular <= size)
    return change;
  return LeastSquares(jacobian, singular)(right);
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
  const double size = euclidean_norm(best.shape);
  best.energy = slide_downhill(
      best.shape, size / 10, size / 1000,
      [&](const ShapeVector& s) { return along_solutions(data, s); },
      [&](ShapeVector& s) { return least_newton(data, s, 12); },
      [&](const ShapeVector& s) { return energy_of(data, s); });
  return best;
}

/// The quintic as a cubic preimage; its phase is limited, for nearly parallel ends.
ShapeVector near_quintic(const SepticData& data, const QuinticFamily::Member& a, double delta) {
  const auto parts = [](const Quaternion<double>& q) { return Vector3{q.u, q.p, q.q}; };
  return vector_of({std::clamp(delta / (std::numbers::pi * phase_unit(data)), -1.0, 1.0),
                    parts((1.0 / 3) * (a[0] + 2.0 * a[1])),
                    parts((1.0 / 3) * (2.0 * a[1] + a[2]))});
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
  double greatest = 0x1p-100;
  for (std::size_t k = 1; k < 7; ++k) greatest = std::max(greatest, std::abs(s[k]));
  const int bits = shape_bits - std::ilogb(greatest);
  s[0] = rounded_double(s[0], shape_bits);
  for (std::size_t k = 1; k < 7; ++k) s[k] = rounded_double(s[k], bits);
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
  const std::vector<double> direction = along_solutions(data_, s);
  keeps_phase_ = std::abs(direction[0]) >= small_angle;
  if (!keeps_phase_)
    for (std::size_t k = 0; k < 7; ++k) across_[k] = rounded_double(direction[k], short_bits);
  const bool found = newton(data_, s, 12, [&](const DoubleRows& jacobian, const Lack& lack) {
    std::vector<double> step = change_across(jacobian, across_, lack);
    if (keeps_phase_) step[0] = 0;
    return step;
  });
  if (found) solution_ = shape_of(s);
}

std::vector<double> SepticSection::change(const std::vector<double>& of_step) const {
  DoubleRows jacobian;
  SepticEquations(data_).lack(vector_of(solution_), &jacobian);
  std::vector<double> result =
      change_across(std::move(jacobian), across_, {of_step[0], of_step[1], of_step[2], 0, 0, 0});
  if (keeps_phase_) result[0] = 0;
  return result;
}

}  // namespace phrame
