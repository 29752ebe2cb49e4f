#include "phrame/algebra/zero_bound.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace phrame::inline v0 {
namespace {

constexpr long most_bits = 1L << 16;

/// Nothing, where deciding by it would take too long.
ZeroBound within_limits(std::vector<Generator> generators, long height) {
  long degree = 1;
  for (const Generator& generator : generators)
    if ((degree *= generator.degree()) > most_bits) return {};
  if (height > most_bits || degree * height > most_bits) return {};
  return {degree, height, std::move(generators)};
}

ZeroBound combined(const ZeroBound& x, const ZeroBound& y, long more) {
  if (!x.is_known() || !y.is_known()) return {};
  std::vector<Generator> generators = x.generators;
  for (const Generator& generator : y.generators)
    if (std::find(generators.begin(), generators.end(), generator) == generators.end())
      generators.push_back(generator);
  return within_limits(std::move(generators), x.height + y.height + more);
}

/// Where to give up; never for a number that is known to be no rational one.
long limit_of(const Real& x) {
  constexpr long most = 1L << 18;
  return x.origin().is_irrational ? std::numeric_limits<long>::max() / 4
                                  : 8192 + std::min(4 * x.origin().bits, most);
}

long height_of(const Rational& x) {
  return std::max(bit_length(numerator(x)), bit_length(denominator(x)));
}

/// A ball with a radius ≤ 2^−bits, where x is known: enclosures tend to it.
std::optional<RealBall> ball_of_radius(const Real& x, long bits) {
  const Rational wanted = power_of_two(-bits);
  for (long more = bits + 32; more <= 16 * bits + most_bits; more *= 2)
    if (RealBall ball = x.enclose(more); ball.is_finite() && ball.radius() <= wanted) return ball;
  return std::nullopt;
}

}  // namespace

ZeroBound zero_bound(const Rational& x) { return within_limits({}, height_of(x)); }

/// With the primitive polynomial p of degree n, H(x)ⁿ is its Mahler measure, which is ≤ ‖p‖₂.
ZeroBound zero_bound(const RealAlgebraic& x) {
  const Polynomial& p = x.polynomial();
  long bits = 0;
  for (const Rational& c : p.coefficients()) bits = std::max(bits, height_of(c));
  const long n = p.degree();
  const auto terms = static_cast<long>(std::bit_width(static_cast<std::uint64_t>(n) + 1));
  const long height = (bits + terms) / n + 1;
  return n == 1 ? within_limits({}, height) : within_limits({Generator(x)}, height);
}

ZeroBound of_sum(const ZeroBound& x, const ZeroBound& y) { return combined(x, y, 1); }
ZeroBound of_product(const ZeroBound& x, const ZeroBound& y) { return combined(x, y, 0); }
ZeroBound of_square_root(const ZeroBound& x) {
  if (!x.is_known()) return {};
  std::vector<Generator> generators = x.generators;
  generators.emplace_back();
  return within_limits(std::move(generators), x.height / 2 + 1);
}
ZeroBound of_power(const ZeroBound& x, long k) {
  const long size = k < 0 ? -k : k;
  if (!x.is_known() || size > most_bits) return {};
  return within_limits(x.generators, std::max(1L, x.height * size));
}

/// A rational number of height ≤ 2ʰ is the simplest one in any ball narrower than 2^(−2h), and x
/// less that number has a bound of its own.
Real settled(const Real& x, const ZeroBound& bound) {
  if (x.exact() || x.origin().is_irrational || !bound.is_known()) return x;
  const auto near = ball_of_radius(x, 2 * bound.height + 2);
  if (!near) return x;
  const Rational candidate = simplest_between(near->lower(), near->upper());
  if (height_of(candidate) > bound.height + 1) return known_irrational(x);
  const ZeroBound off = of_sum(bound, zero_bound(candidate));
  if (!off.is_known()) return x;
  const auto ball = ball_of_radius(x, off.bits() + 2);
  if (!ball) return x;
  return ball->contains(candidate) ? Real(candidate) : known_irrational(x);
}

std::optional<int> decided_sign(const Real& x, const ZeroBound& bound) {
  if (x.exact()) return x.exact()->sign();
  const long most = bound.is_known() ? std::max(bound.bits(), limit_of(x)) : limit_of(x);
  for (long bits = 64; bits <= most; bits *= 2)
    if (const int found = sign(x.enclose(bits)); found != 0) return found;
  if (!bound.is_known()) return std::nullopt;
  const auto ball = ball_of_radius(x, bound.bits() + 2);
  if (!ball) return std::nullopt;
  return ball->contains_zero() ? 0 : sign(*ball);
}

std::optional<Integer> decided_floor(const Real& x) {
  if (x.exact()) return floor(*x.exact());
  for (long bits = 64; bits <= limit_of(x); bits *= 2) {
    const RealBall ball = x.enclose(bits);
    if (!ball.is_finite()) continue;
    const Integer below = floor(ball.lower());
    if (floor(ball.upper()) == below) return below;
  }
  return std::nullopt;
}

}  // namespace phrame
