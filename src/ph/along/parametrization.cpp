// A fraction x of the length S is in the segment k with s(k) ≤ xS < s(k + 1). Lengths of segments
// with equal speeds are equal, whatever their value is, so that xS = s(k) is decided by counting
// them: with m of n segments of each speed before the joint it holds if m = xn for each. So it is
// on circles of equal arcs and on curves that were cut in halves.
#include "phrame/ph/along/parametrization.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// |r′|² = p²|H|²/W⁴.
RationalFunction squared_speed(const RationalCurve& curve) {
  const Polynomial& p = curve.multiplier();
  const Polynomial square = curve.weight() * curve.weight();
  const Vector<Polynomial>& H = curve.direction();
  return {p * p * dot(H, H), square * square};
}

/// Do they have the same length since they have the same speed, in one direction or the other?
bool have_equal_speed(const Segment& a, const Segment& b) {
  const RationalCurve* first = rational_curve(a);
  const RationalCurve* second = rational_curve(b);
  if (first == nullptr || second == nullptr) return a == b;
  const RationalFunction speed = squared_speed(*first);
  const RationalFunction other = squared_speed(*second);
  return speed == other || speed == compose(other, Polynomial{1, -1});
}

/// Is the share x of the length seen to be that of the first `count` segments?
bool is_share_of_segments(const Path& path, const Rational& x, std::size_t count) {
  const auto& segments = path.segments();
  std::vector<bool> is_counted(segments.size(), false);
  for (std::size_t first = 0; first < segments.size(); ++first) {
    if (is_counted[first]) continue;
    long all = 0;
    long before = 0;
    for (std::size_t k = first; k < segments.size(); ++k) {
      if (is_counted[k] || (k > first && !have_equal_speed(segments[first], segments[k]))) continue;
      is_counted[k] = true;
      ++all;
      if (k < count) ++before;
    }
    if (Rational(before) != x * all) return false;
  }
  return true;
}

/// The greatest double of at most the length.
Rational length_below(const Real& length) {
  if (length.exact()) return *length.exact();
  const Rational lower = length.enclose(192).lower();
  const Rational unit = power_of_two(binary_exponent(lower) - 51);
  return Rational(floor(lower / unit)) * unit;
}

void require_share(const Rational& x, const char* what) {
  if (x < 0 || x > 1)
    throw DomainError(fmt::format("{}: {} is outside [0, 1]", what, as_written(x)));
}

}  // namespace

Parametrization::Parametrization(const NamedPath& named, ParameterKind kind)
    : named_(named), kind_(kind), length_(named.path) {
  if (kind == ParameterKind::native && named.parameters.empty())
    throw DomainError("the file of the path has no parameter of its own but t");
}

Real Parametrization::from() const {
  return kind_ == ParameterKind::native ? named_.parameters.front() : Real(Rational(0));
}

Real Parametrization::to() const {
  switch (kind_) {
    case ParameterKind::t:
      return named_.path.end();
    case ParameterKind::native:
      return named_.parameters.back();
    case ParameterKind::arc_length:
      return length_.total();
    case ParameterKind::unit:
    case ParameterKind::fraction:
      break;
  }
  return Rational(1);
}

Place Parametrization::place(const Rational& x) const {
  switch (kind_) {
    case ParameterKind::t:
      return locate(named_.path, x);
    case ParameterKind::native:
      return native_place(named_, x);
    case ParameterKind::unit:
      require_share(x, "unit");
      return locate(named_.path, x * named_.path.end());
    case ParameterKind::arc_length:
      return length_.point(x);
    case ParameterKind::fraction:
      break;
  }
  return place_of_fraction(x);
}

Place Parametrization::place_of_fraction(const Rational& x) const {
  require_share(x, "fraction");
  const Path& path = named_.path;
  if (x == 1) return end_of(path);
  const Real whole = length_.total();
  if (whole.exact()) return length_.point(x * *whole.exact());
  // The sign of xS − s(k).
  const auto compare = [&](std::size_t k) {
    if (k == 0) return x.sign();
    for (long bits = 64; bits <= 8192; bits *= 2) {
      const RealBall target = multiply(RealBall(x, bits), whole.enclose(bits), bits);
      if (const int found = sign(subtract(target, length_.before(k).enclose(bits), bits));
          found != 0)
        return found;
      if (bits == 256 && is_share_of_segments(path, x, k)) return 0;
    }
    throw Undecided(fmt::format("fraction: {} of the arc length is not told from that of a joint",
                                as_written(x)));
  };
  std::size_t low = 0;
  for (std::size_t high = path.segments().size(); high - low > 1;) {
    const std::size_t middle = (low + high) / 2;
    const int found = compare(middle);
    if (found == 0) return {middle, Rational(0)};
    (found > 0 ? low : high) = middle;
  }
  if (x == 0) return {0, Rational(0)};
  const auto share = [length = length_, whole, low](const RealBall& t, long bits) {
    return divide(length.enclose({low, t.midpoint()}, bits), whole.enclose(bits), bits);
  };
  const auto slope = [length = length_, whole, low](const RealBall& t, long bits) {
    return divide(length.rate(low, t, bits), whole.enclose(bits), bits);
  };
  const auto F = std::make_shared<const IncreasingFunction>(IncreasingFunction{share, slope});
  return {low, preimage(F, x, guess_preimage(*F, x))};
}

ParameterPoint Parametrization::point(const Rational& x) const { return {x, place(x)}; }

std::vector<Real> Parametrization::sample_values(long count) const {
  std::vector<Real> values;
  if (count == 0) return values;
  const Real first = from();
  const bool is_length = kind_ == ParameterKind::arc_length;
  const Real way = (is_length ? Real(length_below(to())) : to()) + -first;
  for (long k = 0; k < count; ++k) values.push_back(first + Real(Rational(k, count - 1)) * way);
  return values;
}

std::vector<ParameterPoint> Parametrization::samples(long count) const {
  std::vector<ParameterPoint> found;
  // Of the ends of a parameter that are no fractions there is one segment.
  for (Real& value : sample_values(count)) {
    const Rational share(static_cast<long>(found.size()), count - 1);
    found.push_back(value.exact() ? point(*value.exact())
                                  : ParameterPoint{std::move(value), Place(0, share)});
  }
  return found;
}

std::vector<ParameterPoint> Parametrization::points(const std::vector<Rational>& values,
                                                    long count) const {
  std::vector<ParameterPoint> found;
  for (const Rational& x : values) found.push_back(point(x));
  if (count > 0)
    for (ParameterPoint& sample : samples(count)) found.push_back(std::move(sample));
  return found;
}

}  // namespace phrame
