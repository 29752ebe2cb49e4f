#include "phrame/ph/construct/cubic_interpolation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/big_float.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/scale.hpp"

// For the spline's law, spline_slopes.hpp. In ℚ the elimination makes numbers with as many digits
// as all points before have together, so that n points cost n³; big floats cost n. What they find
// is rounded; the residual, in ℚ with short numbers, says how good it is. What is
// nearly plane or nearly straight would have any torsion, so that this holds exactly: r″ = 0 at a
// natural end, and that a spline stays in the line or the plane of its points.

namespace phrame::inline v0 {
namespace {

using Vectors = std::vector<Vector<Rational>>;

/// Steps of the parameter, and slopes of the chords.
struct Chords {
  std::vector<Rational> steps;
  Vectors slopes;
};

Chords chords_of(const CubicInterpolation& data) {
  Chords chords;
  for (std::size_t k = 0; k + 1 < data.points.size(); ++k) {
    chords.steps.push_back(data.parameters[k + 1] - data.parameters[k]);
    chords.slopes.push_back((1 / chords.steps.back()) * (data.points[k + 1] - data.points[k]));
  }
  return chords;
}

void require_interpolation(const CubicInterpolation& data) {
  const std::size_t count = data.points.size();
  const bool is_periodic = data.ends == SplineEnds::periodic;
  const std::size_t least = is_periodic ? 3 : 2;
  if (count < least)
    throw DomainError(fmt::format("a {}cubic spline has {} points at least, not {}",
                                  is_periodic ? "periodic " : "", least, count));
  if (data.parameters.size() != count)
    throw DomainError(fmt::format("{} parameters for {} points", data.parameters.size(), count));
  for (std::size_t k = 1; k < count; ++k)
    if (data.parameters[k] <= data.parameters[k - 1])
      throw DomainError(fmt::format("the parameters do not increase: {} after {}",
                                    as_written(data.parameters[k]),
                                    as_written(data.parameters[k - 1])));
  if (is_periodic && data.points.front() != data.points.back())
    throw DomainError(fmt::format("a periodic spline ends at its first point, {}, not {}",
                                  abbreviated(data.points.front()),
                                  abbreviated(data.points.back())));
}

std::size_t place_of_largest(const Vector<Rational>& v) {
  const auto less = [](const Rational& a, const Rational& b) { return abs(a) < abs(b); };
  return static_cast<std::size_t>(std::max_element(v.begin(), v.end(), less) - v.begin());
}

/// Of points in a line or a plane the rounded slopes x are moved into it, by one coordinate or two.
void put_into_span(Vectors& x, const Chords& chords, const CubicInterpolation& data) {
  Vectors directions = chords.slopes;
  directions.push_back(data.start_derivative);
  directions.push_back(data.end_derivative);
  Vector<Rational> v;  // the first that is not 0
  Vector<Rational> n;  // normal to it and to the first that is not parallel
  for (const Vector<Rational>& d : directions) {
    if (largest(v) == 0) v = d;
    if (largest(n) == 0) n = cross(v, d);
    if (dot(n, d) != 0) return;
  }
  const std::size_t i = place_of_largest(largest(n) == 0 ? v : n);
  for (Vector<Rational>& slope : x)
    if (largest(n) == 0)
      slope = Rational(slope[i] / v[i]) * v;
    else
      slope[i] -= dot(n, slope) / n[i];
}

Vectors rounded_slopes(const Chords& chords, const CubicInterpolation& data, long places) {
  constexpr long bits = 192;
  const auto in_floats = [&](const Vector<Rational>& v) {
    return Vector<BigFloat>{BigFloat(v[0], bits), BigFloat(v[1], bits), BigFloat(v[2], bits)};
  };
  std::vector<BigFloat> h;
  std::vector<Vector<BigFloat>> slopes;
  for (const Rational& step : chords.steps) h.emplace_back(step, bits);
  for (const Vector<Rational>& slope : chords.slopes) slopes.push_back(in_floats(slope));
  Vectors result;
  const Rational unit = power_of_two(-places);
  for (const Vector<BigFloat>& x :
       cubic_spline_slopes(h, slopes, data.ends,
                           {in_floats(data.start_derivative), in_floats(data.end_derivative)}))
    result.push_back({unit * Rational(x[0].scaled(places)), unit * Rational(x[1].scaled(places)),
                      unit * Rational(x[2].scaled(places))});
  put_into_span(result, chords, data);
  if (data.ends == SplineEnds::clamped) {
    result.front() = data.start_derivative;
    result.back() = data.end_derivative;
  }
  if (data.ends == SplineEnds::natural) {
    const std::size_t n = result.size();
    result.front() = Rational(1, 2) * (Rational(3) * chords.slopes.front() - result[1]);
    result.back() = Rational(1, 2) * (Rational(3) * chords.slopes.back() - result[n - 2]);
  }
  return result;
}

}  // namespace

// The greatest residual of a row, divided by its off-diagonal numbers' sum.
Rational error_of_derivatives(const CubicInterpolation& data, const Vectors& derivatives) {
  const Vectors& x = derivatives;
  const Chords chords = chords_of(data);
  const auto rows = slope_rows(chords.steps, chords.slopes, data.ends,
                               {data.start_derivative, data.end_derivative});
  const std::size_t n = rows.size();
  Rational greatest;
  for (std::size_t k = 0; k < n; ++k) {
    const auto& [low, middle, high, right] = rows[k];
    const Vector<Rational> left = low * x[(k + n - 1) % n] + middle * x[k] + high * x[(k + 1) % n];
    const Rational size = largest(left - right);
    if (size != 0) greatest = std::max(greatest, Rational(size / (middle - low - high)));
  }
  return greatest;
}

std::vector<Rational> parameters_of(const std::vector<Vector<Rational>>& points,
                                    ParameterChoice choice) {
  constexpr long bits = 12;
  std::vector<Rational> parameters{0};
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    Rational step = 1;
    if (choice != ParameterChoice::uniform) {
      const Vector<Rational> chord = points[k + 1] - points[k];
      if (largest(chord) == 0)
        throw DomainError(fmt::format(
            "the points {} and {} of {} are equal: only with uniform or given parameters is it "
            "known how a curve goes from one to the other",
            k + 1, k + 2, points.size()));
      step = choice == ParameterChoice::chord_lengths ? rounded_length(chord, bits)
                                                      : rounded_root_of_length(chord, bits);
    }
    parameters.push_back(parameters.back() + step);
  }
  return parameters;
}

Vectors cubic_derivatives(const CubicInterpolation& data) {
  require_interpolation(data);
  const Chords chords = chords_of(data);
  const std::size_t repeated = data.ends == SplineEnds::periodic ? 1 : 0;
  if (data.points.size() - repeated <= exact_cubic_points)
    return cubic_spline_slopes(chords.steps, chords.slopes, data.ends,
                               {data.start_derivative, data.end_derivative});
  constexpr long bits = 128;
  const Rational size = std::max(
      {largest(chords.slopes), largest(data.start_derivative), largest(data.end_derivative)});
  if (size == 0) throw DomainError("the points are all equal, so the curve is a single point");
  return rounded_slopes(chords, data, bits - binary_exponent(size));
}

BezierPoints cubic_piece(const CubicInterpolation& data,
                         const std::vector<Vector<Rational>>& derivatives, std::size_t k) {
  const Rational third = (data.parameters[k + 1] - data.parameters[k]) / 3;
  const Vector<Rational>& a = data.points[k];
  const Vector<Rational>& b = data.points[k + 1];
  return {a, a + third * derivatives[k], b - third * derivatives[k + 1], b};
}

}  // namespace phrame
