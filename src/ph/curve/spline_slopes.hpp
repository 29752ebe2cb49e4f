#pragma once
#include <utility>
#include <vector>

#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

// The derivatives x_k of the C² cubic spline through points, over any numbers T: doubles, BigFloat,
// fractions. With δ_k the slope of the chord from point k to k + 1 and h_k the parameter's step
// there, they solve
//   h_k x_{k−1} + 2(h_{k−1} + h_k) x_k + h_{k−1} x_{k+1} = 3(h_k δ_{k−1} + h_{k−1} δ_k).

/// What is said of a C² spline at its ends: the second derivatives are 0; the first ones are given;
/// the end is the start, also for the first two derivatives.
enum class SplineEnds { natural, clamped, periodic };

/// low·x_{k−1} + middle·x_k + high·x_{k+1} = right.
template <class T>
struct SlopeRow {
  T low;            ///< of the derivative before
  T middle;         ///< of the derivative there
  T high;           ///< of the next derivative
  Vector<T> right;  ///< the right-hand side
};

/// The rows of the system; of a periodic one the first reaches back to the last unknown, and the
/// last to the first, and the end is no unknown. n ≥ 1 steps, of a periodic one n ≥ 3. The
/// derivatives at the ends are for SplineEnds::clamped.
template <class T>
std::vector<SlopeRow<T>> slope_rows(const std::vector<T>& h, const std::vector<Vector<T>>& slopes,
                                    SplineEnds ends, const std::pair<Vector<T>, Vector<T>>& given) {
  const std::size_t n = h.size();
  std::vector<SlopeRow<T>> rows;
  const auto inner = [&](std::size_t before, std::size_t k) {
    return SlopeRow<T>{h[k], T(T(2) * (h[before] + h[k])), h[before],
                       T(3) * (h[k] * slopes[before] + h[before] * slopes[k])};
  };
  if (ends == SplineEnds::natural) rows.push_back({T(0), T(2), T(1), T(3) * slopes.front()});
  if (ends == SplineEnds::clamped) rows.push_back({T(0), T(1), T(0), given.first});
  if (ends == SplineEnds::periodic) rows.push_back(inner(n - 1, 0));
  for (std::size_t k = 1; k < n; ++k) rows.push_back(inner(k - 1, k));
  if (ends == SplineEnds::natural) rows.push_back({T(1), T(2), T(0), T(3) * slopes.back()});
  if (ends == SplineEnds::clamped) rows.push_back({T(0), T(1), T(0), given.second});
  return rows;
}

/// By elimination; no pivots, for the middle exceeds both others together.
template <class T>
std::vector<Vector<T>> solve_slopes(std::vector<SlopeRow<T>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 1; k < n; ++k) {
    const T factor = rows[k].low / rows[k - 1].middle;
    rows[k].middle = rows[k].middle - factor * rows[k - 1].high;
    rows[k].right = rows[k].right - factor * rows[k - 1].right;
  }
  std::vector<Vector<T>> x(n);
  for (std::size_t k = n; k-- > 0;) {
    const Vector<T> rest = k + 1 < n ? rows[k].right - rows[k].high * x[k + 1] : rows[k].right;
    x[k] = T(T(1) / rows[k].middle) * rest;
  }
  return x;
}

/// The periodic system by two systems without its corners [Sherman and Morrison].
template <class T>
std::vector<Vector<T>> solve_periodic_slopes(std::vector<SlopeRow<T>> rows) {
  const std::size_t n = rows.size();
  const T corner_high = rows.front().low;
  const T corner_low = rows.back().high;
  const T gamma = -rows.front().middle;
  rows.front().middle = rows.front().middle - gamma;
  rows.back().middle = rows.back().middle - corner_high * corner_low / gamma;
  std::vector<SlopeRow<T>> unit = rows;
  for (SlopeRow<T>& row : unit) row.right = {T(0), T(0), T(0)};
  unit.front().right[0] = gamma;
  unit.back().right[0] = unit.back().right[0] + corner_low;
  std::vector<Vector<T>> x = solve_slopes(std::move(rows));
  const std::vector<Vector<T>> z = solve_slopes(std::move(unit));
  const T weight = corner_high / gamma;
  const T denominator = T(1) + z[0][0] + weight * z[n - 1][0];
  const Vector<T> factor = T(T(1) / denominator) * (x[0] + weight * x[n - 1]);
  for (std::size_t k = 0; k < n; ++k) x[k] = x[k] - z[k][0] * factor;
  return x;
}

/// The derivatives at all points, of n ≥ 1 steps n + 1: of a periodic spline the last is the first.
template <class T>
std::vector<Vector<T>> cubic_spline_slopes(const std::vector<T>& h,
                                           const std::vector<Vector<T>>& slopes, SplineEnds ends,
                                           const std::pair<Vector<T>, Vector<T>>& given = {}) {
  const std::size_t n = h.size();
  if (ends != SplineEnds::periodic) return solve_slopes(slope_rows(h, slopes, ends, given));
  if (n == 1) return {slopes[0], slopes[0]};
  if (n == 2) {  // both neighbours of a point are the other one
    const T third = T(1) / T(T(T(2) * (h[1] + h[0])) + h[0] + h[1]);
    const Vector<T> slope = third * (T(3) * (h[0] * slopes[1] + h[1] * slopes[0]));
    return {slope, slope, slope};
  }
  std::vector<Vector<T>> x = solve_periodic_slopes(slope_rows(h, slopes, ends, given));
  x.push_back(x.front());
  return x;
}

}  // namespace phrame
