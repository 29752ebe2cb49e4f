#include "phrame/ph/construct/hermite_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/construct/scale.hpp"

namespace phrame {
namespace {

constexpr long chord_bits = 12;
constexpr long slope_bits = 40;

/// |v| > 0, to 12 bits.
Rational rounded_size(const Vector<Rational>& v) {
  const Rational scale = scale_for_doubles(largest(v));
  const Vector<double> w = scaled_to_doubles(scale, v);
  return rounded_to_bits(exact_rational(std::sqrt(dot(w, w))), chord_bits) / scale;
}

void require_apart(const std::vector<Vector<Rational>>& points) {
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    if (points[k] == points[k + 1])
      throw DomainError(fmt::format(
          "the points {} and {} of {} are equal: only with derivatives and parameters is it known "
          "how a curve goes from one to the other",
          k + 1, k + 2, points.size()));
}

std::vector<Rational> chord_lengths(const std::vector<Vector<Rational>>& points) {
  std::vector<Rational> parameters{0};
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    parameters.push_back(parameters.back() + rounded_size(points[k + 1] - points[k]));
  return parameters;
}

/// SlopeRow k of the system of the spline's slopes: low·x_{k−1} + middle·x_k + high·x_{k+1} =
/// right.
struct SlopeRow {
  double low;
  double middle;
  double high;
  Vector<double> right;
};

/// By elimination; no pivots, for the middle exceeds both others together.
std::vector<Vector<double>> solve(std::vector<SlopeRow> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 1; k < n; ++k) {
    const double factor = rows[k].low / rows[k - 1].middle;
    rows[k].middle -= factor * rows[k - 1].high;
    rows[k].right = rows[k].right - factor * rows[k - 1].right;
  }
  std::vector<Vector<double>> x(n);
  for (std::size_t k = n; k-- > 0;) {
    const Vector<double> rest = k + 1 < n ? rows[k].right - rows[k].high * x[k + 1] : rows[k].right;
    x[k] = (1 / rows[k].middle) * rest;
  }
  return x;
}

/// The periodic system, whose first row reaches back to the last unknown and whose last one to the
/// first, by two systems without these corners [Sherman and Morrison].
std::vector<Vector<double>> solve_periodic(std::vector<SlopeRow> rows) {
  const std::size_t n = rows.size();
  const double corner_high = rows.front().low;
  const double corner_low = rows.back().high;
  const double gamma = -rows.front().middle;
  rows.front().middle -= gamma;
  rows.back().middle -= corner_high * corner_low / gamma;
  std::vector<SlopeRow> unit = rows;
  for (SlopeRow& row : unit) row.right = {};
  unit.front().right[0] = gamma;
  unit.back().right[0] += corner_low;
  std::vector<Vector<double>> x = solve(std::move(rows));
  const std::vector<Vector<double>> z = solve(std::move(unit));
  const double weight = corner_high / gamma;
  const double denominator = 1 + z[0][0] + weight * z[n - 1][0];
  const Vector<double> factor = (1 / denominator) * (x[0] + weight * x[n - 1]);
  for (std::size_t k = 0; k < n; ++k) x[k] = x[k] - z[k][0] * factor;
  return x;
}

/// The derivatives of the C² cubic spline through the points: with δ_k the slope of the chord from
/// point k to k + 1 and h_k the parameter's step there,
///   h_k x_{k−1} + 2(h_{k−1} + h_k) x_k + h_{k−1} x_{k+1} = 3(h_k δ_{k−1} + h_{k−1} δ_k).
std::vector<Vector<double>> cubic_spline_slopes(const std::vector<double>& h,
                                                const std::vector<Vector<double>>& slopes,
                                                bool is_periodic) {
  const std::size_t n = h.size();
  std::vector<SlopeRow> rows;
  const auto inner = [&](std::size_t before, std::size_t k) {
    return SlopeRow{h[k], 2 * (h[before] + h[k]), h[before],
                    3.0 * (h[k] * slopes[before] + h[before] * slopes[k])};
  };
  if (is_periodic && n == 1) return {slopes[0], slopes[0]};
  if (is_periodic && n == 2) {  // both neighbours of a point are the other one
    const SlopeRow row = inner(1, 0);
    const Vector<double> slope = (1 / (row.middle + row.low + row.high)) * row.right;
    return {slope, slope, slope};
  }
  if (is_periodic) {
    rows.push_back(inner(n - 1, 0));
    for (std::size_t k = 1; k < n; ++k) rows.push_back(inner(k - 1, k));
    std::vector<Vector<double>> x = solve_periodic(std::move(rows));
    x.push_back(x.front());
    return x;
  }
  rows.push_back({0, 2, 1, 3.0 * slopes.front()});
  for (std::size_t k = 1; k < n; ++k) rows.push_back(inner(k - 1, k));
  rows.push_back({1, 2, 0, 3.0 * slopes.back()});
  return solve(std::move(rows));
}

std::vector<Vector<Rational>> spline_derivatives(const std::vector<Vector<Rational>>& points,
                                                 const std::vector<Rational>& parameters,
                                                 bool is_periodic) {
  std::vector<Rational> steps;
  std::vector<Vector<Rational>> chords;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    steps.push_back(parameters[k + 1] - parameters[k]);
    chords.push_back((1 / steps.back()) * (points[k + 1] - points[k]));
  }
  const Rational scale = scale_for_doubles(largest(chords));
  const Rational scale_of_steps = scale_for_doubles(*std::max_element(steps.begin(), steps.end()));
  std::vector<double> h;
  std::vector<Vector<double>> slopes;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    h.push_back(static_cast<double>(scale_of_steps * steps[k]));
    slopes.push_back(scaled_to_doubles(scale, chords[k]));
  }
  std::vector<Vector<Rational>> result;
  for (const Vector<double>& slope : cubic_spline_slopes(h, slopes, is_periodic)) {
    Vector<Rational> d;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::isfinite(slope[k]))
        throw Undecided(
            "the cubic spline through the points, in doubles: the parameters' steps "
            "are too different");
      d[k] = rounded_to_places(exact_rational(slope[k]), slope_bits) / scale;
    }
    result.push_back(d);
  }
  return result;
}

/// Tangents with the mean speed of the chords at both sides.
std::vector<Vector<Rational>> scaled_tangents(const std::vector<Vector<Rational>>& tangents,
                                              const std::vector<Vector<Rational>>& points,
                                              const std::vector<Rational>& parameters,
                                              bool is_closed) {
  std::vector<Rational> speeds;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    speeds.push_back(rounded_size(points[k + 1] - points[k]) / (parameters[k + 1] - parameters[k]));
  std::vector<Vector<Rational>> result;
  const std::size_t n = speeds.size();
  for (std::size_t k = 0; k <= n; ++k) {
    const std::size_t before = k > 0 ? k - 1 : is_closed ? n - 1 : 0;
    const std::size_t after = k < n ? k : is_closed ? 0 : n - 1;
    const Rational speed = (speeds[before] + speeds[after]) / 2;
    result.push_back(rounded_to_bits(speed / rounded_size(tangents[k]), chord_bits) * tangents[k]);
  }
  return result;
}

/// The list of a closed spline, with the first entry at the end.
template <class T>
void close(std::vector<T>& list) {
  if (!list.empty()) list.push_back(list.front());
}

}  // namespace

DerivativeSource derivative_source(const GivenPoints& given, bool is_closed) {
  if (!given.derivatives.empty()) return DerivativeSource::given;
  if (!given.tangents.empty()) return DerivativeSource::tangents;
  return is_closed ? DerivativeSource::periodic_spline : DerivativeSource::natural_spline;
}

ParameterSource parameter_source(const GivenPoints& given) {
  if (!given.parameters.empty()) return ParameterSource::given;
  return given.derivatives.empty() ? ParameterSource::chord_lengths
                                   : ParameterSource::whole_numbers;
}

HermiteSpline hermite_spline(const GivenPoints& given, bool is_closed) {
  HermiteSpline data{given.points, given.derivatives, given.parameters, is_closed,
                     given.accelerations};
  std::vector<Vector<Rational>> tangents = given.tangents;
  if (is_closed && data.points.front() != data.points.back()) {
    close(data.points);
    close(data.derivatives);
    close(data.accelerations);
    close(tangents);
  } else if (is_closed) {
    const auto require_same = [](const auto& list, std::string_view name) {
      if (!list.empty() && list.front() != list.back())
        throw DomainError(fmt::format(
            "the closed curve ends with another {} than it starts with, at the same point", name));
    };
    require_same(data.derivatives, "derivative");
    require_same(data.accelerations, "acceleration");
    require_same(tangents, "tangent");
  }
  const std::size_t count = data.points.size();
  if (!data.parameters.empty() && data.parameters.size() != count)
    throw DomainError(fmt::format(
        "{} parameters for {} points{}", data.parameters.size(), count,
        is_closed ? ", of which the last is the first: the last parameter is that of the end"
                  : ""));
  if (data.derivatives.empty()) require_apart(data.points);
  if (data.parameters.empty()) {
    if (parameter_source(given) == ParameterSource::chord_lengths)
      data.parameters = chord_lengths(data.points);
    else
      for (std::size_t k = 0; k < count; ++k) data.parameters.emplace_back(k);
  }
  if (data.derivatives.empty())
    data.derivatives = tangents.empty()
                           ? spline_derivatives(data.points, data.parameters, is_closed)
                           : scaled_tangents(tangents, data.points, data.parameters, is_closed);
  return data;
}

void require_regular(const HermiteSpline& data) {
  const std::size_t n = data.segments();
  const auto is_zero = [&](std::size_t k) { return largest(data.derivatives[k]) == 0; };
  for (std::size_t k = data.is_closed ? 0 : 1; k < n; ++k)
    if (is_zero(k))
      throw DomainError(
          fmt::format("the derivative at point {} is 0: the tangent would break there", k + 1));
  for (std::size_t k = 0; k < n; ++k)
    if (data.points[k] == data.points[k + 1] && is_zero(k) && is_zero(k + 1))
      throw DomainError(fmt::format(
          "segment {} is a point: its points are equal and its derivatives are 0", k + 1));
}

void require_directions(const HermiteSpline& data) {
  for (std::size_t k = 0; k < data.derivatives.size(); ++k)
    if (largest(data.derivatives[k]) == 0)
      throw DomainError(fmt::format("the derivative at point {} is 0: it has no direction", k + 1));
}

ParameterSteps parameter_steps(const HermiteSpline& data) {
  std::vector<Rational> steps;
  Integer denominators = 1;
  for (std::size_t k = 0; k < data.segments(); ++k) {
    steps.push_back(data.step(k));
    denominators = lcm(denominators, denominator(steps.back()));
  }
  ParameterSteps result;
  Integer divisor;
  for (const Rational& step : steps) {
    result.counts.push_back(numerator(Rational(step * denominators)));
    divisor = gcd(divisor, result.counts.back());
  }
  for (Integer& count : result.counts) count /= divisor;
  result.unit = Rational(divisor, denominators);
  return result;
}

Rational size_of_points(const HermiteSpline& data) {
  Rational size;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] =
        std::minmax_element(data.points.begin(), data.points.end(),
                            [k](const auto& a, const auto& b) { return a[k] < b[k]; });
    size = std::max(size, Rational((*high)[k] - (*low)[k]));
  }
  if (size != 0) return size;
  return size_of_derivatives(data) * (data.parameters.back() - data.parameters.front());
}

Rational size_of_derivatives(const HermiteSpline& data) { return largest(data.derivatives); }

Rational size_of_accelerations(const HermiteSpline& data) { return largest(data.accelerations); }

}  // namespace phrame
