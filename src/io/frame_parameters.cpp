#include "phrame/io/frame_parameters.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// Increasing numbers that are not those of the rows.
bool are_times(const std::vector<GivenPosition>& positions) {
  bool is_numbered = true;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (k > 0 && positions[k].t <= positions[k - 1].t) return false;
    is_numbered = is_numbered && positions[k].t == static_cast<long>(k);
  }
  return !is_numbered;
}

std::vector<FrameParameters> candidates(const Path& path,
                                        const std::vector<GivenPosition>& positions) {
  std::vector<FrameParameters> all;
  const std::size_t count = positions.size();
  const auto steps = static_cast<long>(count) - 1;
  const auto add = [&](const std::string& what, auto parameter) {
    FrameParameters found{{}, what};
    for (std::size_t k = 0; k < count; ++k) found.t.push_back(parameter(k));
    all.push_back(std::move(found));
  };
  if (path.segments().size() + 1 == count)
    add("the joints of the curve, one after the other",
        [](std::size_t k) { return Rational(static_cast<long>(k)); });
  const Rational& first = positions.front().t;
  const Rational duration = positions.back().t - first;
  if (are_times(positions))
    add("the times, from the start of the curve to its end",
        [&](std::size_t k) { return Rational(path.end() * (positions[k].t - first) / duration); });
  add("equal steps from the start of the curve to its end",
      [&](std::size_t k) { return Rational(path.end() * Rational(static_cast<long>(k), steps)); });
  return all;
}

}  // namespace

FrameParameters frame_parameters(const Path& path, const std::vector<GivenPosition>& positions) {
  if (positions.size() < 2)
    throw InputError(
        "frames without a column t are placed on the curve by their positions, of "
        "which two at least are wanted");
  const std::vector<FrameParameters> all = candidates(path, positions);
  std::vector<std::optional<Rational>> deviations;  // of the candidates, as they are asked for
  for (const long digits : {12, 9, 6, 3})
    for (std::size_t n = 0; n < all.size(); ++n) {
      if (n == deviations.size()) {
        std::vector<GivenPosition> moved = positions;
        for (std::size_t k = 0; k < moved.size(); ++k) moved[k].t = all[n].t[k];
        deviations.push_back(squared_deviation(path, moved));
      }
      if (deviations[n] && *deviations[n] <= power_of_ten(-2 * digits)) return all[n];
    }
  throw InputError(
      "the positions of the frames are the curve's neither at its joints, nor by their "
      "times, nor at equal steps: a column t is wanted");
}

namespace {

constexpr long parameter_bits = 160;

Rational rational_parameter(const Place& at) {
  const Real t = parameter(at);
  return t.exact() ? *t.exact() : t.enclose(parameter_bits + 16).midpoint();
}

std::string what_of(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::t:
      return "t";
    case ParameterKind::native:
      return "the parameter of the file of the curve";
    case ParameterKind::unit:
      return "t over the number of segments, from 0 to 1";
    case ParameterKind::arc_length:
      return "the arc length";
    case ParameterKind::fraction:
      break;
  }
  return "the share of the arc length, from 0 to 1";
}

Vector<double> unit(const Vector<double>& v) {
  const double size = std::hypot(v[0], v[1], v[2]);
  return 1 / size * v;
}

Vector<double> approximated(const Vector<Real>& v) {
  return {approximate(v[0].enclose(64)), approximate(v[1].enclose(64)),
          approximate(v[2].enclose(64))};
}

/// e₁ of a frame, where it says that.
std::optional<Vector<double>> tangent_of(const GivenFrame& frame) {
  if (frame.tangent) return unit(round_to_double(*frame.tangent));
  if (frame.f3) return unit(round_to_double(cross(frame.f2, *frame.f3)));
  return std::nullopt;
}

/// The sine of the angle between e₁ and T; without e₁, how far f₂ is along T.
double off_tangent(const GivenFrame& frame, const Vector<double>& T) {
  if (const auto e1 = tangent_of(frame)) {
    const Vector<double> c = cross(*e1, T);
    return std::hypot(c[0], c[1], c[2]);
  }
  return std::abs(dot(unit(round_to_double(frame.f2)), T));
}

/// Of all frames at these t, the worst; at a corner by the better side.
double greatest_off(const Path& path, const std::vector<GivenFrame>& frames,
                    const std::vector<Rational>& t) {
  double worst = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const PathParameter at = locate(path, t[k]);
    double off = off_tangent(frames[k], unit(approximated(direction(path, at))));
    if (at.t == 0 && at.segment > 0)
      off = std::min(
          off, off_tangent(frames[k],
                           unit(approximated(direction(path, {at.segment - 1, Rational(1)})))));
    worst = off <= worst ? worst : off;  // NaN is the worst
  }
  return worst;
}

/// Next to t where the tangent of the path is e₁, by Newton's method for T·e₁ greatest; in doubles,
/// since it is a guess.
Rational moved_to_tangent(const Path& path, const Rational& t, const Vector<double>& e1) {
  double at = round_to_double(t);
  const double end = round_to_double(path.end());
  constexpr int most_steps = 30;
  for (int step = 0; step < most_steps; ++step) {
    const PathParameter place = locate(path, exact_rational(at));
    const Vector<double> H = approximated(direction(path, place));
    const Vector<double> slope = approximated(direction_slope(path, place));
    const double size = std::hypot(H[0], H[1], H[2]);
    const Vector<double> T = 1 / size * H;
    const Vector<double> rate = 1 / size * (slope - dot(slope, T) * T);
    const double squared_rate = dot(rate, rate);
    if (!(squared_rate > 0)) break;
    const double way = dot(e1, rate) / squared_rate;
    const double next = std::clamp(at + std::clamp(way, -0.25, 0.25), 0.0, end);
    if (std::abs(next - at) <= 0x1p-52 * (1 + at)) break;
    at = next;
  }
  return exact_rational(at);
}

/// At most 65 of them, with the last one: whether all are where they say is seen of these.
std::vector<GivenFrame> some_of(const std::vector<GivenFrame>& frames) {
  std::vector<GivenFrame> some;
  const std::size_t stride = 1 + frames.size() / 64;
  for (std::size_t k = 0; k < frames.size(); k += stride) some.push_back(frames[k]);
  if ((frames.size() - 1) % stride != 0) some.push_back(frames.back());
  return some;
}

/// No value where some frame is outside of the path.
std::optional<FrameParameters> try_parameters(ParameterKind kind, const NamedPath& named,
                                              const std::vector<GivenFrame>& frames) {
  try {
    return parameters_by(kind, named, frames);
  } catch (const DomainError&) {
    return std::nullopt;
  } catch (const Undecided&) {
    return std::nullopt;
  }
}

constexpr double is_tangent = 1e-6;
constexpr double is_near_tangent = 0.2;

/// The same with t moved to where the tangents are those of the frames; no value where that is not
/// in the order of t.
std::optional<FrameParameters> moved_to_tangents(const Path& path,
                                                 const std::vector<GivenFrame>& frames,
                                                 const FrameParameters& near) {
  FrameParameters moved{{}, near.what + ", moved to where the tangents are those of the table"};
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto e1 = tangent_of(frames[k]);
    if (!e1) return std::nullopt;
    const Vector<double> T = unit(approximated(direction(path, locate(path, near.t[k]))));
    moved.t.push_back(off_tangent(frames[k], T) <= is_tangent
                          ? near.t[k]
                          : moved_to_tangent(path, near.t[k], *e1));
    if (k > 0 && (moved.t[k] < moved.t[k - 1]) != (near.t[k] < near.t[k - 1])) return std::nullopt;
  }
  return moved;
}

}  // namespace

FrameParameters parameters_by(ParameterKind kind, const NamedPath& named,
                              const std::vector<GivenFrame>& frames) {
  const Parametrization by(named, kind);
  FrameParameters found{{}, what_of(kind)};
  found.t.reserve(frames.size());
  for (const GivenFrame& frame : frames)
    found.t.push_back(rational_parameter(by.point(frame.t).at));
  return found;
}

std::optional<FrameParameters> better_parameters(const NamedPath& named,
                                                 const std::vector<GivenFrame>& frames) {
  if (frames.size() > most_guessed_frames) return std::nullopt;
  const Path& path = named.path;
  const std::vector<GivenFrame> few = some_of(frames);
  const auto as_they_are = try_parameters(ParameterKind::t, named, few);
  const double off_now = as_they_are ? greatest_off(path, few, as_they_are->t) : HUGE_VAL;
  if (off_now <= is_tangent) return std::nullopt;
  std::vector<FrameParameters> near;
  for (const ParameterKind kind : {ParameterKind::native, ParameterKind::unit,
                                   ParameterKind::fraction, ParameterKind::arc_length}) {
    if (kind == ParameterKind::unit && path.segments().size() == 1) continue;  // t itself
    auto found = try_parameters(kind, named, frames);
    if (!found) continue;
    const double off = greatest_off(path, frames, found->t);
    if (off <= is_tangent) return found;
    const bool is_by_length = kind == ParameterKind::fraction || kind == ParameterKind::arc_length;
    if (is_by_length && off <= is_near_tangent) near.push_back(*std::move(found));
  }
  if (off_now <= is_near_tangent) return std::nullopt;  // tangents a little off are a fault
  for (const FrameParameters& other : near)
    if (auto moved = moved_to_tangents(path, frames, other);
        moved && greatest_off(path, frames, moved->t) <= is_tangent)
      return moved;
  return std::nullopt;
}

}  // namespace phrame
