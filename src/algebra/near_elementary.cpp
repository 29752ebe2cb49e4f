#include "phrame/algebra/near_elementary.hpp"

#include <array>
#include <complex>
#include <limits>

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr long table_bits = 128;

NearNumber quotient_of(long n, long d) { return near_number(Rational(n, d)); }

/// cos and sin of kπ/32, and the coefficients of their Taylor polynomials, by the square of the
/// angle.
struct TurnTable {
  static constexpr long steps = 64;  // of a whole turn
  static constexpr std::size_t terms = 8;
  NearNumber step;  ///< π/32
  std::array<NearCosSin, steps> at;
  std::array<NearNumber, terms> cos;  ///< (−1)ᵏ/(2k)!
  std::array<NearNumber, terms> sin;  ///< (−1)ᵏ/(2k + 1)!

  TurnTable() : step(near_number(times_power_of_two(pi(table_bits), -5))) {
    const RealBall angle = times_power_of_two(pi(table_bits), -5);
    for (long k = 0; k < steps; ++k) {
      const CosSin turn =
          phrame::cos_sin(multiply(angle, RealBall(k, table_bits), table_bits), table_bits);
      at[static_cast<std::size_t>(k)] = {near_number(turn.cos), near_number(turn.sin)};
    }
    long factorial = 1;
    for (std::size_t k = 0; k < terms; ++k) {
      const auto twice = static_cast<long>(2 * k);
      if (k > 0) factorial *= -twice * (twice - 1);
      cos[k] = quotient_of(1, factorial);
      sin[k] = quotient_of(1, factorial * (twice + 1));
    }
  }
  static const TurnTable& known() {
    static const TurnTable turns;
    return turns;
  }
};

/// 2^{k/32}, and the coefficients 1/k! of the exponential function.
struct Powers {
  static constexpr long steps = 32;
  static constexpr std::size_t terms = 12;
  NearNumber step;  ///< log(2)/32
  std::array<NearNumber, steps> at;
  std::array<NearNumber, terms> exp;

  Powers() {
    flint::Arb x;
    arb_const_log2(x.get(), table_bits);
    arb_mul_2exp_si(x.get(), x.get(), -5);
    const auto as_near = [](const flint::Arb& of) {
      RealBall ball;
      arb_set(ball.raw(), of.get());
      return near_number(ball);
    };
    step = as_near(x);
    for (long k = 0; k < steps; ++k) {
      flint::Arb power;
      arb_mul_si(power.get(), x.get(), k, table_bits);
      arb_exp(power.get(), power.get(), table_bits);
      at[static_cast<std::size_t>(k)] = as_near(power);
    }
    long factorial = 1;
    for (std::size_t k = 0; k < terms; ++k) {
      if (k > 0) factorial *= static_cast<long>(k);
      exp[k] = quotient_of(1, factorial);
    }
  }
  static const Powers& known() {
    static const Powers powers;
    return powers;
  }
};

/// Σ cₖxᵏ; terms from number `rough` on are sums of doubles, which that many are small enough for.
template <std::size_t n>
NearNumber taylor(const std::array<NearNumber, n>& c, const NearNumber& x, std::size_t rough) {
  double tail = c[n - 1].value.high;
  for (std::size_t k = n - 1; k-- > rough;) tail = tail * x.value.high + c[k].value.high;
  // The terms fall faster than 2^−5: all that rounds is 2^−50 of the first.
  NearNumber sum{{tail}, std::abs(c[rough].value.high) * (0x1p-50 + x.error)};
  for (std::size_t k = rough; k-- > 0;) sum = sum * x + c[k];
  return sum;
}

/// The number of the step next to x, and the rest. Precondition: |x| < 2^30 steps.
std::pair<long, NearNumber> by_steps(const NearNumber& x, const NearNumber& step) {
  const double count = std::nearbyint(x.value.high / step.value.high);
  return {static_cast<long>(count), x - NearNumber{{count}} * step};
}

/// e^x for |x| < 300.
NearNumber exp(double x) {
  const Powers& powers = Powers::known();
  const auto [k, r] = by_steps({{x}}, powers.step);
  constexpr std::size_t rough = 7;  // |r| < 0.011: r⁷/7! < 2^−57
  NearNumber power = taylor(powers.exp, r, rough);
  power.error += 0x1p-106;  // r¹²/12! and what follows
  const long whole = k >= 0 ? k / Powers::steps : -((Powers::steps - 1 - k) / Powers::steps);
  power = power * powers.at[static_cast<std::size_t>(k - whole * Powers::steps)];
  const double scale = std::ldexp(1.0, static_cast<int>(whole));
  return {{power.value.high * scale, power.value.low * scale}, power.error * scale};
}

}  // namespace

NearNumber near_number(const RealBall& x) {
  if (!x.is_finite()) return {{}, infinite};
  const double high = arf_get_d(arb_midref(x.raw()), ARF_RND_NEAR);
  flint::Arb rest;
  arf_set_d(arb_midref(rest.get()), high);
  arf_sub(arb_midref(rest.get()), arb_midref(x.raw()), arb_midref(rest.get()), 64, ARF_RND_DOWN);
  const double low = arf_get_d(arb_midref(rest.get()), ARF_RND_NEAR);
  if (!std::isfinite(high)) return {{}, infinite};
  return {{high, low},
          raised(std::abs(low) * 0x1p-51 + mag_get_d(arb_radref(x.raw())) * pairs::up)};
}

RealBall ball_of(const NearNumber& x) {
  return widened(exact_sum(x.value.high, x.value.low), x.error);
}

// With the nearest multiple kπ/32, |r| < 0.05: what the polynomials leave out is less than r¹⁶/16!
// < 2^−113, and terms from r⁸/8! < 2^−49 on are sums of doubles.
NearCosSin cos_sin(const NearNumber& angle) {
  if (!(std::abs(angle.value.high) <= 0x1p20)) return {{{}, infinite}, {{}, infinite}};
  const TurnTable& turns = TurnTable::known();
  const auto [k, r] = by_steps(angle, turns.step);
  const NearCosSin& at = turns.at[static_cast<std::size_t>(k & (TurnTable::steps - 1))];
  const NearNumber square = r * r;
  constexpr std::size_t rough = 4;
  NearNumber cos = taylor(turns.cos, square, rough);
  NearNumber sin = r * taylor(turns.sin, square, rough);
  cos.error = cos.error + 0x1p-110;
  sin.error = sin.error + 0x1p-110;
  return {at.cos * cos - at.sin * sin, at.sin * cos + at.cos * sin};
}

// With a logarithm L in doubles, z = e^L·(1 + δ): log z = L + δ, off by less than |δ|².
NearComplex log(const NearComplex& z) {
  const double size = std::hypot(z.re.high, z.im.high);
  NearComplex result{{}, {}, infinite};
  if (!(size > 0x1p-400 && size < 0x1p400)) return result;
  if (z.re.high <= 0 && !(std::abs(z.im.high) * 0.5 > z.error)) return result;
  const double re = std::log(size);
  const double im = std::atan2(z.im.high, z.re.high);
  const NearNumber over = exp(-re);
  const auto [c, s] = cos_sin({{im}});
  const NearNumber x = over * c;
  const NearNumber y = -(over * s);
  const NearComplex unit{x.value, y.value, raised(x.error + y.error)};
  const NearComplex delta = z * unit - NearComplex{{1}, {}};
  const double off = pairs::size_above(delta) + delta.error;
  if (!(off < 0x1p-30)) return result;
  result = NearComplex{{re}, {im}} + delta;
  result.error = (result.error + off * off) * pairs::up;
  return result;
}

// With q near 1/√x and xq² = 1 − e: 1/√x = q·(1 + e/2), off by less than q·e².
NearNumber inverse_root(const NearNumber& x) {
  const double q = 1 / std::sqrt(x.value.high);
  if (!(q > 0x1p-200 && q < 0x1p200)) return {{}, infinite};
  const NearNumber near{{q}};
  const NearNumber e = NearNumber{{1}} - x * (near * near);
  const double most = size_of(e) + e.error;
  if (!(most < 0x1p-30)) return {{}, infinite};
  NearNumber root = near + near * NearNumber{{e.value.high / 2, e.value.low / 2}, e.error / 2};
  root.error = raised(root.error + q * most * most);
  return root;
}

}  // namespace phrame
