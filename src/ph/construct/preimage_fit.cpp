// r′ = f·A i A* with A = α + kβ has the direction A i A*/σ, which is the point (α : β) of the
// complex projective line, the Riemann sphere. So w = (α : β) is a rational curve of degree m in
// it, known at as many t as one likes, and α°(t)·β(t) − β°(t)·α(t) = 0 are linear equations for its
// coefficients. Their best solution is the right singular vector of the least singular value. In
// the Bernstein basis and at Chebyshev's points this is well conditioned.
//
// Next to a zero of f of odd order the direction jumps to its opposite, (α : β) to (−β̄ : ᾱ), and
// that is on no rational curve with it. Straight through, it is smooth again: straighten().
//
// Which degree m has A, and which n − 2m has f? As great an m as can be comes first, with f = 1
// where n is even; a curve that is given by the points of a random A of that degree is then found
// at once. Where A = L·z with z ∈ ℂ[t], or r′ = f·A i A* with another f, the linear problem has
// many solutions for this m and one for a lower m. So lower ones are tried until the distance is
// what rounding the data to doubles makes, and the best is taken. A straight line, m = 0, has least
// and comes before all. A curve of high degree may be so near to one with a lower m and a quadratic
// f that the linear problem has two small singular values for its own m, too; it is found from
// there, with f = |z|² drawn into A.
#include "phrame/ph/construct/preimage_fit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "phrame/ph/construct/preimage.hpp"

namespace phrame::inline v0 {
namespace {

using DoubleQuaternion = Quaternion<double>;
using DoubleVector = Vector<double>;

/// C(n, k) for k = 0, …, n.
std::vector<double> binomials(std::size_t n) {
  std::vector<double> row{1};
  for (std::size_t k = 0; k < n; ++k)
    row.push_back(row.back() * static_cast<double>(n - k) / static_cast<double>(k + 1));
  return row;
}

/// Σ a_k C(n, k) tᵏ (1 − t)ⁿ⁻ᵏ has these a_k·C(n, k), which multiply as those of a power basis do.
template <class T>
std::vector<T> scaled(std::vector<T> bernstein) {
  const auto row = binomials(bernstein.size() - 1);
  for (std::size_t k = 0; k < bernstein.size(); ++k) bernstein[k] = row[k] * bernstein[k];
  return bernstein;
}

std::vector<DoubleVector> product(const std::vector<double>& f,
                                  const std::vector<DoubleVector>& v) {
  std::vector<DoubleVector> result(f.size() + v.size() - 1, DoubleVector{});
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) result[i + j] = result[i + j] + f[i] * v[j];
  return result;
}

/// A i A*, all with scaled coefficients.
std::vector<DoubleVector> scaled_square(const std::vector<DoubleQuaternion>& a) {
  std::vector<DoubleVector> result(2 * a.size() - 1, DoubleVector{});
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      result[i + j] = result[i + j] + symmetric_product(a[i], a[j]);
  return result;
}

/// The control points after the first of the curve with the hodograph of these scaled
/// coefficients: r_{k+1} − r_k = r′_k/(degree of r′ + 1).
std::vector<DoubleVector> integrated(const std::vector<DoubleVector>& scaled_hodograph) {
  const std::size_t n = scaled_hodograph.size() - 1;
  const auto row = binomials(n);
  std::vector<DoubleVector> points;
  DoubleVector at{};
  for (std::size_t k = 0; k <= n; ++k) {
    at = at + (1 / (row[k] * static_cast<double>(n + 1))) * scaled_hodograph[k];
    points.push_back(at);
  }
  return points;
}

std::vector<double> stacked(const std::vector<DoubleVector>& v) {
  std::vector<double> result;
  for (const DoubleVector& x : v) result.insert(result.end(), x.begin(), x.end());
  return result;
}

/// By de Casteljau's algorithm.
DoubleVector value(std::vector<DoubleVector> b, double t) {
  for (std::size_t n = b.size() - 1; n > 0; --n)
    for (std::size_t k = 0; k < n; ++k) b[k] = (1 - t) * b[k] + t * b[k + 1];
  return b[0];
}

/// A t of Chebyshev's, and r′ there.
struct HodographSample {
  double t;
  DoubleVector derivative;
};

std::vector<HodographSample> samples(const std::vector<DoubleVector>& hodograph) {
  constexpr std::size_t least = 24;
  const std::size_t count = std::max(4 * hodograph.size(), least);
  std::vector<HodographSample> result;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle =
        std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    const double t = (1 - std::cos(angle)) / 2;
    result.push_back({t, value(hodograph, t)});
  }
  return result;
}

/// Reverses the derivatives such that none is opposed to the one before. Is there any to reverse?
bool straighten(std::vector<HodographSample>& samples) {
  bool changed = false;
  for (std::size_t k = 1; k < samples.size(); ++k)
    if (dot(samples[k - 1].derivative, samples[k].derivative) < 0) {
      samples[k].derivative = -1.0 * samples[k].derivative;
      changed = true;
    }
  return changed;
}

/// Each complex unknown is two real ones, its real and its imaginary part, so is each equation.
std::vector<DoubleQuaternion> first_preimage(const std::vector<HodographSample>& at, long m) {
  double largest = 0;
  for (const HodographSample& s : at) largest = std::max(largest, dot(s.derivative, s.derivative));
  const auto row = binomials(static_cast<std::size_t>(m));
  const auto count = static_cast<std::size_t>(m + 1);
  DoubleRows equations(2 * at.size(), std::vector<double>(4 * count, 0.0));
  const auto set = [&](std::size_t k, std::size_t unknown, const std::complex<double>& c) {
    const std::size_t x = 2 * unknown;
    auto& real = equations[2 * k];
    auto& imaginary = equations[2 * k + 1];
    real[x] = imaginary[x + 1] = c.real();
    real[x + 1] = -c.imag();
    imaginary[x] = c.imag();
  };
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double speed = std::sqrt(dot(at[k].derivative, at[k].derivative));
    if (speed == 0) continue;
    const DoubleQuaternion w = preimage((1 / speed) * at[k].derivative);
    const double weight = speed / std::sqrt(largest);
    for (std::size_t j = 0; j < count; ++j) {
      const double b = weight * row[j] * std::pow(at[k].t, static_cast<double>(j)) *
                       std::pow(1 - at[k].t, static_cast<double>(count - 1 - j));
      set(k, j, b * std::complex(w.q, w.p));
      set(k, count + j, -b * std::complex(w.u, w.v));
    }
  }
  const std::vector<double> x = least_singular_vector(equations);
  std::vector<DoubleQuaternion> result;
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t alpha = 2 * j;
    const std::size_t beta = 2 * (count + j);
    result.push_back({x[alpha], x[alpha + 1], x[beta + 1], x[beta]});
  }
  return result;
}

/// The f with f·A i A* next to r′, by linear least squares.
std::vector<double> best_multiplier(const std::vector<DoubleQuaternion>& a,
                                    const std::vector<DoubleVector>& hodograph) {
  const auto square = scaled_square(scaled(a));
  const std::size_t unknowns = hodograph.size() - square.size() + 1;
  const auto row = binomials(hodograph.size() - 1);
  const auto f_row = binomials(unknowns - 1);
  DoubleRows matrix(3 * hodograph.size(), std::vector<double>(unknowns, 0.0));
  for (std::size_t j = 0; j < unknowns; ++j)
    for (std::size_t i = 0; i < square.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        matrix[3 * (i + j) + c][j] = f_row[j] * square[i][c] / row[i + j];
  constexpr double rounding = 0x1p-48;
  return LeastSquares(matrix, rounding)(stacked(hodograph));
}

/// f is to be 1 where it is a constant.
PreimageFit with_unit_constant(PreimageFit fit) {
  if (fit.multiplier.size() > 1) return fit;
  double f = fit.multiplier[0];
  for (DoubleQuaternion& a : fit.preimage) {
    if (f < 0) a = a * DoubleQuaternion{0, 0, 1, 0};  // which turns A i A* around
    a = std::sqrt(std::abs(f)) * a;
  }
  return {std::move(fit.preimage), {1}};
}

/// a + factor·b.
PreimageFit moved(PreimageFit a, double factor, const PreimageFit& b) {
  for (std::size_t k = 0; k < a.preimage.size(); ++k)
    a.preimage[k] = a.preimage[k] + factor * b.preimage[k];
  for (std::size_t k = 0; k < a.multiplier.size(); ++k) a.multiplier[k] += factor * b.multiplier[k];
  return a;
}

std::vector<DoubleVector> points_after_first(const PreimageFit& fit) {
  return integrated(product(scaled(fit.multiplier), scaled_square(scaled(fit.preimage))));
}

/// Where to begin: A of degree m with A i A* along the samples, f of degree n − 2m where r′ has
/// degree n.
PreimageFit first_fit(const std::vector<DoubleVector>& hodograph,
                      const std::vector<HodographSample>& at, long m) {
  PreimageFit result{first_preimage(at, m), {}};
  result.multiplier = best_multiplier(result.preimage, hodograph);
  return with_unit_constant(std::move(result));
}

/// The points less those of the fit, and the sum of their squares.
struct Remainder {
  std::vector<DoubleVector> of_points;
  double sum_of_squares = 0;
  double greatest_square = 0;
};

Remainder remainder(const PreimageFit& fit, const std::vector<DoubleVector>& points) {
  const auto reached = points_after_first(fit);
  Remainder result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    result.of_points.push_back(points[k] - reached[k]);
    const double square = dot(result.of_points.back(), result.of_points.back());
    result.sum_of_squares += square;
    result.greatest_square = std::max(result.greatest_square, square);
  }
  return result;
}

struct FitCandidate {
  PreimageFit fit;
  double distance;  ///< the greatest of a point
};

/// From there by Gauss's and Newton's iteration, as far as it helps, with steps that are halved
/// down to this factor where they do not.
FitCandidate candidate(PreimageFit fit, const std::vector<DoubleVector>& points,
                       double least_factor) {
  constexpr int most_steps = 20;
  Remainder now = remainder(fit, points);
  double last = HUGE_VAL;
  for (int k = 0; k < most_steps && (k < 4 || now.sum_of_squares < 0.9 * last); ++k) {
    const PreimageFit step = FitStep(fit, FreePart::all)(now.of_points);
    PreimageFit next;
    Remainder after;
    // Where it is no number this is false, too.
    for (double factor = 1; factor >= least_factor; factor /= 2) {
      next = moved(fit, factor, step);
      after = remainder(next, points);
      if (after.sum_of_squares < now.sum_of_squares) break;
    }
    if (!(after.sum_of_squares < now.sum_of_squares)) break;
    last = now.sum_of_squares;
    now = std::move(after);
    fit = std::move(next);
  }
  const bool is_number = std::isfinite(now.sum_of_squares);
  return {std::move(fit), is_number ? std::sqrt(now.greatest_square) : HUGE_VAL};
}

/// f·A i A* = (A·z) i (A·z)* for a quadratic f > 0: f = |z|² with a linear z ∈ ℂ[t], whose
/// Bernstein coefficients are √f₀ and (f₁ ± i·√(f₀f₂ − f₁²))/√f₀. Nothing for other f.
std::vector<PreimageFit> without_quadratic(const PreimageFit& fit) {
  if (fit.multiplier.size() != 3) return {};
  const double f0 = fit.multiplier[0];
  const double f1 = fit.multiplier[1];
  const double rest = f0 * fit.multiplier[2] - f1 * f1;
  if (!(f0 > 0 && rest >= 0)) return {};
  const double z0 = std::sqrt(f0);
  const std::size_t m = fit.preimage.size() - 1;
  const auto row = binomials(m + 1);
  const auto a = scaled(fit.preimage);
  std::vector<PreimageFit> result;
  for (const double imaginary : {std::sqrt(rest), -std::sqrt(rest)}) {
    std::vector<DoubleQuaternion> product(m + 2);
    for (std::size_t k = 0; k <= m; ++k) {
      product[k] = product[k] + z0 * a[k];
      product[k + 1] = (1 / z0) * turned(a[k], ComplexOf<double>{f1, imaginary});
    }
    for (std::size_t k = 0; k <= m + 1; ++k) product[k] = (1 / row[k]) * product[k];
    result.push_back({std::move(product), {1}});
  }
  return result;
}

PreimageFit normalized(PreimageFit fit) {
  double multiplier = 0;
  for (const double f : fit.multiplier) multiplier = std::max(multiplier, std::abs(f));
  const bool is_negative = fit.multiplier.front() < 0;
  // Powers of 4, so that nothing is rounded.
  const int exponent = multiplier > 0 ? std::ilogb(multiplier) >> 1 : 0;
  for (double& f : fit.multiplier) f = std::ldexp(is_negative ? -f : f, -2 * exponent);
  std::complex<double> largest = 1;
  double size = 0;
  for (DoubleQuaternion& a : fit.preimage) {
    a = std::ldexp(1.0, exponent) * a;
    if (is_negative) a = a * DoubleQuaternion{0, 0, 1, 0};
    for (const auto& part : {std::complex(a.u, a.v), std::complex(a.q, a.p)})
      if (std::abs(part) > 1.001 * size) {  // of nearly equal ones the first
        largest = part;
        size = std::abs(part);
      }
  }
  const std::complex<double> turn = std::conj(largest) / std::abs(largest);
  for (DoubleQuaternion& a : fit.preimage)
    a = turned(a, ComplexOf<double>{turn.real(), turn.imag()});
  return fit;
}

}  // namespace

FitStep::FitStep(const PreimageFit& fit, FreePart part)
    : preimage_size_(fit.preimage.size()), multiplier_size_(fit.multiplier.size()) {
  const std::size_t size = preimage_size_;
  if (part == FreePart::all) {
    count_ = size;
  } else if (size > 2) {
    first_ = 1;
    count_ = size - 2;
  }
  const auto a = scaled(fit.preimage);
  const auto f = scaled(fit.multiplier);
  const auto row = binomials(size - 1);
  std::vector<std::vector<double>> columns;
  constexpr std::array<DoubleQuaternion, 4> units{
      {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  for (std::size_t k = first_; k < first_ + count_; ++k)
    for (const DoubleQuaternion& unit : units) {
      std::vector<DoubleVector> change(2 * size - 1, DoubleVector{});
      for (std::size_t j = 0; j < size; ++j)
        change[k + j] = (2 * row[k]) * symmetric_product(unit, a[j]);
      columns.push_back(stacked(integrated(product(f, change))));
    }
  if (multiplier_size_ > 1) {
    const auto square = scaled_square(a);
    for (std::size_t k = 0; k < f.size(); ++k) {
      std::vector<double> unit(f.size(), 0.0);
      unit[k] = 1;
      columns.push_back(stacked(integrated(product(scaled(unit), square))));
    }
  }
  if (columns.empty()) return;
  DoubleRows matrix(columns[0].size());
  for (const auto& column : columns)
    for (std::size_t y = 0; y < column.size(); ++y) matrix[y].push_back(column[y]);
  // What turns A about i, and other changes that leave the curve alone, is singular.
  constexpr double singular = 1e-12;
  inverse_.emplace(matrix, singular);
}

PreimageFit FitStep::operator()(const std::vector<DoubleVector>& wanted) const {
  PreimageFit result{std::vector<DoubleQuaternion>(preimage_size_),
                     std::vector<double>(multiplier_size_, 0.0)};
  if (!inverse_) return result;
  const std::vector<double> x = (*inverse_)(stacked(wanted));
  for (std::size_t k = 0; k < count_; ++k)
    result.preimage[first_ + k] = {x[4 * k], x[4 * k + 1], x[4 * k + 2], x[4 * k + 3]};
  if (multiplier_size_ > 1)
    std::copy(x.begin() + static_cast<std::ptrdiff_t>(4 * count_), x.end(),
              result.multiplier.begin());
  return result;
}

PreimageFit best_fit(const std::vector<DoubleVector>& hodograph,
                     const std::vector<DoubleVector>& points) {
  // Below this, the doubles that the points are tell nothing more.
  constexpr double noise = 0x1p-46;
  // The first fit of a degree that is too high is bad, and is to be given up for a lower one.
  constexpr double whole_steps = 1;
  constexpr double short_steps = 0x1p-6;
  const long n = static_cast<long>(hodograph.size()) - 1;
  auto at = samples(hodograph);
  FitCandidate best = candidate(first_fit(hodograph, at, 0), points, whole_steps);
  const auto take_better = [&](FitCandidate other) {
    if (other.distance < best.distance) best = std::move(other);
  };
  const auto improve = [&] {
    std::vector<PreimageFit> starts;
    for (long m = n / 2; m >= 0 && !(best.distance <= noise); --m) {
      FitCandidate next = candidate(first_fit(hodograph, at, m), points, whole_steps);
      if (starts.empty()) starts = without_quadratic(next.fit);
      take_better(std::move(next));
    }
    for (PreimageFit& start : starts)
      if (!(best.distance <= noise)) take_better(candidate(std::move(start), points, short_steps));
  };
  improve();  // with A i A* along r′: f > 0
  // Then as if the curve went on straight where it turns back at a cusp: f changes its sign.
  if (straighten(at)) improve();
  return normalized(std::move(best.fit));
}

}  // namespace phrame
