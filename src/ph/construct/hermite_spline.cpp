#include "phrame/ph/construct/hermite_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/curve/gap.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/spline_slopes.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long chord_bits = 12;
constexpr long slope_bits = 40;

/// |v| > 0, to 12 bits.
Rational rounded_size(const Vector<Rational>& v) { return rounded_length(v, chord_bits); }

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
  for (const Vector<double>& slope :
       cubic_spline_slopes(h, slopes, is_periodic ? SplineEnds::periodic : SplineEnds::natural)) {
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

/// Where all points are on a line, D with p_k = p_0 + s_k·D, and s; no value where they are not.
struct PointsOnLine {
  Vector<Rational> direction;
  std::vector<Vector<Rational>> numbers;  ///< (s_k, 0, 0)
};
std::optional<PointsOnLine> on_line(const std::vector<Vector<Rational>>& points) {
  PointsOnLine result{points[1] - points[0], {}};
  const Vector<Rational>& d = result.direction;
  std::size_t axis = 0;
  while (axis < 3 && d[axis] == 0) ++axis;
  if (axis == 3) return std::nullopt;
  for (const Vector<Rational>& p : points) {
    const Rational s = (p[axis] - points[0][axis]) / d[axis];
    if (p != points[0] + s * d) return std::nullopt;
    result.numbers.push_back({s, 0, 0});
  }
  return result;
}

/// Those of points on a line are along it, exactly, though they are rounded.
std::vector<Vector<Rational>> straight_or_spline_derivatives(
    const std::vector<Vector<Rational>>& points, const std::vector<Rational>& parameters,
    bool is_periodic) {
  const auto line = on_line(points);
  if (!line) return spline_derivatives(points, parameters, is_periodic);
  std::vector<Vector<Rational>> result;
  for (const Vector<Rational>& d : spline_derivatives(line->numbers, parameters, is_periodic))
    result.push_back(d[0] * line->direction);
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

/// Along e₁ of the frame, of length 1.
Vector<Rational> tangent_of(const Quaternion<Integer>& frame) {
  const Rational size = norm(frame);
  return each(rotated_i(frame), [&](const Integer& x) { return Rational(x / size); });
}

/// The list of a closed spline, with the first entry at the end.
template <class T>
void close(std::vector<T>& list) {
  if (!list.empty()) list.push_back(list.front());
}

/// The last is the first, as a rotation, to within some units of doubles; then it is made that.
void require_same_orientation(std::vector<Quaternion<Integer>>& frames) {
  if (frames.empty()) return;
  const Quaternion<Integer> turn = conjugate(frames.front()) * frames.back();
  const Integer square = turn.v * turn.v + turn.p * turn.p + turn.q * turn.q;
  if (square > power_of_two(-96) * norm(turn))
    throw DomainError(
        "the closed curve ends with another orientation than it starts with, at the same point");
  frames.back() = frames.front();
}

}  // namespace

DerivativeSource derivative_source(const GivenPoints& given, bool is_closed) {
  if (!given.derivatives.empty()) return DerivativeSource::given;
  if (!given.tangents.empty()) return DerivativeSource::tangents;
  if (given.poses) return DerivativeSource::poses;
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
  if (given.poses)
    for (const Orientation& body : given.poses->bodies)
      data.frames.push_back(frame_rotation(body.rotation, given.poses->tangent));
  if (is_closed && close_to_rounding(data.points))
    for (auto* list : {&data.derivatives, &data.accelerations, &tangents}) close_to_rounding(*list);
  if (is_closed && data.points.front() != data.points.back()) {
    close(data.points);
    close(data.derivatives);
    close(data.accelerations);
    close(tangents);
    close(data.frames);
  } else if (is_closed) {
    const auto require_same = [](const auto& list, std::string_view name) {
      if (!list.empty() && list.front() != list.back())
        throw DomainError(fmt::format(
            "the closed curve ends with another {} than it starts with, at the same point", name));
    };
    require_same(data.derivatives, "derivative");
    require_same(data.accelerations, "acceleration");
    require_same(tangents, "tangent");
    require_same_orientation(data.frames);
  }
  for (const Quaternion<Integer>& frame : data.frames) tangents.push_back(tangent_of(frame));
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
                           ? straight_or_spline_derivatives(data.points, data.parameters, is_closed)
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

void require_directions(const HermiteSpline& data, std::string_view what) {
  for (std::size_t k = 0; k < data.derivatives.size(); ++k)
    if (largest(data.derivatives[k]) == 0)
      throw DomainError(fmt::format("the derivative at point {} is 0: {}", k + 1, what));
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

ScaledSpline scaled(const HermiteSpline& data) {
  Rational longest_chord;
  Rational longest_step;
  for (std::size_t k = 0; k < data.segments(); ++k) {
    longest_chord = std::max(longest_chord, largest(data.points[k + 1] - data.points[k]));
    longest_step = std::max(longest_step, data.step(k));
  }
  if (longest_chord == 0) longest_chord = size_of_derivatives(data) * longest_step;
  const Rational scale = scale_for_doubles(longest_chord);
  const Rational step_scale = scale_for_doubles(longest_step);
  ScaledSpline result{data,
                      step_scale,
                      {scale, scale / step_scale, scale / (step_scale * step_scale)},
                      *square_root(step_scale / scale)};
  for (auto& p : result.data.points) p = result.scales[0] * p;
  for (auto& d : result.data.derivatives) d = result.scales[1] * d;
  for (auto& a : result.data.accelerations) a = result.scales[2] * a;
  for (Rational& t : result.data.parameters) t *= step_scale;
  return result;
}

}  // namespace phrame
