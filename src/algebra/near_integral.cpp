#include "phrame/algebra/near_integral.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstring>

#include "phrame/algebra/near_arithmetic.hpp"
#include "phrame/algebra/near_elementary.hpp"
#include "phrame/algebra/near_gauss_rule.hpp"
#include "phrame/algebra/wide.hpp"

// On a part t = m + hx, and g = N/(D√S) is analytic within the ellipse E with the foci ±1 of x and
// the sum ρ of its half-axes, |g| ≤ M there. Its Chebyshev coefficients are aₖ with |aₖ| ≤ 2M·ρ⁻ᵏ
// [Bernstein 1912]. Gauss's rule of n points is exact for Tₖ, k < 2n, and 0 for odd k; of the
// others ∫Tₖ is 2/(1 − k²), and the rule has at most Σ weights = 2 for it. So it leaves out
//   2M·Σ ρ⁻ᵏ·(2 + 2/(k² − 1)), k = 2n, 2n + 2, …,  ≤ 4.02·M·ρ^−2n/(1 − ρ⁻²), n ≥ 8,
// of ∫ over [−1, 1].
//
// M, and that D and S have no zero in E: the border is covered by discs around points zⱼ, in which
// p is within Σ |p⁽ᵏ⁾(zⱼ)|/k!·rᵏ, k ≥ 1, of p(zⱼ), where that is smaller than |p(zⱼ)|. Where from
// each p(zⱼ) to the next it turns by less than π/2, their quadrants tell how often p goes around 0.
// As p is real half of the border is enough.

namespace phrame::inline v0 {
namespace {

constexpr double rho = 1.75;
/// Of the rule, which leaves out some 2^−103 of M.
constexpr std::size_t rule_points = 2 * near_gauss_rule.size();
constexpr double pair_step = 0x1p-101;  ///< a sum after a product, of pairs of doubles
constexpr double least_accuracy = 0x1p-88;
constexpr std::size_t most_parts = 64;
constexpr std::size_t most_taylor = 16;

/// In pairs of doubles: its points and weights are off by less than 2^−104.
struct NearRule {
  std::array<double, rule_points> high;
  std::array<double, rule_points> low;
  std::array<double, rule_points> weight_high;
  std::array<double, rule_points> weight_low;

  NearRule() {
    constexpr std::size_t half = rule_points / 2;
    for (std::size_t k = 0; k < rule_points; ++k) {
      const bool is_right = k >= half;
      const NearGaussPoint& at = near_gauss_rule[is_right ? k - half : half - 1 - k];
      high[k] = is_right ? at.high : -at.high;
      low[k] = is_right ? at.low : -at.low;
      weight_high[k] = at.weight_high;
      weight_low[k] = at.weight_low;
    }
  }
  static const NearRule& known() {
    static const NearRule rule;
    return rule;
  }
};

/// A polynomial whose coefficients have sizes with a sum of at most 1.
struct Pairs {
  std::vector<DoubleDouble> coefficients;
  double error = 0;  ///< of values on [−1, 1], with that of rounding

  /// Of coefficients over 2^exponent.
  Pairs(const IntegerPolynomial& p, long exponent);
};

Pairs::Pairs(const IntegerPolynomial& p, long exponent) {
  double size = 0;
  for (long k = 0; k < fmpz_poly_length(p.get()); ++k) {
    RealBall c;
    arb_set_fmpz(c.raw(), p.get()->coeffs + k);
    coefficients.push_back(near_number(times_power_of_two(c, -exponent)).value);
    size += std::abs(coefficients.back().high);
  }
  error = static_cast<double>(coefficients.size() + 1) * pair_step * size * (1 + 0x1p-40);
}

/// c·N/(D√S) with its polynomials as pairs.
struct PairQuotient {
  long of_numerator;  ///< exponents
  long of_denominator;
  long of_root;
  Pairs numerator;
  Pairs denominator;
  Pairs radicand;
  RealBall factor;  ///< of N/(D√S) with these

  explicit PairQuotient(const UnitQuotient& f)
      : of_numerator(unit_exponent(f.numerator)),
        of_denominator(unit_exponent(f.denominator)),
        of_root((unit_exponent(f.radicand) + 1) / 2),
        numerator(f.numerator, of_numerator),
        denominator(f.denominator, of_denominator),
        radicand(f.radicand, 2 * of_root),
        factor(
            times_power_of_two(RealBall(f.factor, 128), of_numerator - of_denominator - of_root)) {}
};

/// [middle − half, middle + half].
struct Part {
  double middle;
  double half;
};

/// Pairs, as many as T has, from number k on.
template <class T>
[[gnu::always_inline]] inline SumOfTwo<T> load(const std::array<double, rule_points>& high,
                                               const std::array<double, rule_points>& low,
                                               std::size_t k) {
  SumOfTwo<T> loaded;
  std::memcpy(&loaded.high, high.data() + k, sizeof loaded.high);
  std::memcpy(&loaded.low, low.data() + k, sizeof loaded.low);
  return loaded;
}

/// Σ cₖtᵏ, each step normalized.
template <class T>
[[gnu::always_inline]] inline SumOfTwo<T> horner(const std::vector<DoubleDouble>& c,
                                                 const SumOfTwo<T>& t) {
  SumOfTwo<T> sum{T{} + c.back().high, T{} + c.back().low};
  for (std::size_t k = c.size() - 1; k-- > 0;)
    sum = normalized(sum * t + SumOfTwo<T>{T{} + c[k].high, T{} + c[k].low});
  return sum;
}

/// Where a polynomial is in a disc: p(z), and how far from that at most.
struct Spread {
  std::complex<double> center;
  double radius;

  double least() const { return std::abs(center) * (1 - 0x1p-50) - radius; }
  double most() const { return std::abs(center) * (1 + 0x1p-50) + radius; }
};

/// Of c, with a degree up to 16: what is rounded is below 2^−44 of Σ |cₖ|·(|z| + r)ᵏ.
Spread spread(const std::vector<DoubleDouble>& c, const std::complex<double>& z, double r) {
  std::array<std::complex<double>, most_taylor + 1> taylor;
  const std::size_t n = c.size();
  const double x = z.real();
  const double y = z.imag();
  double size = 0;
  const double most = std::abs(x) + std::abs(y) + r;
  for (std::size_t k = n; k-- > 0;) {
    taylor[k] = c[k].high;
    size = size * most + std::abs(c[k].high);
  }
  for (std::size_t first = 0; first + 1 < n; ++first)
    for (std::size_t k = n - 1; k-- > first;) {
      const auto& next = taylor[k + 1];
      taylor[k] += std::complex<double>(next.real() * x - next.imag() * y,
                                        next.real() * y + next.imag() * x);
    }
  double radius = 0;
  for (std::size_t k = n; k-- > 1;)
    radius = (radius + std::abs(taylor[k].real()) + std::abs(taylor[k].imag())) * r;
  return {taylor[0], radius + 0x1p-44 * size};
}

/// Follows the values of a polynomial along half of the border.
class Turns {
 public:
  /// False where 0 is not excluded, or it may turn by more than a right angle.
  bool add(const Spread& next) {
    if (!(next.least() > 0)) return false;
    const int quadrant = quadrant_of(next.center);
    if (last_) {
      const auto& [a, b] = std::pair(*last_, next.center);
      if (!(a.real() * b.real() + a.imag() * b.imag() > 0)) return false;
      const int step = (quadrant - quadrant_ + 4) % 4;
      turns_ += step == 3 ? -1 : step;
    }
    last_ = next.center;
    quadrant_ = quadrant;
    return true;
  }
  /// After the last, as real as the first: is there no zero inside?
  bool is_free() const { return turns_ == 0; }

 private:
  static int quadrant_of(const std::complex<double>& p) {
    if (p.imag() >= 0 && p.real() > 0) return 0;
    if (p.imag() > 0) return 1;
    return p.real() < 0 ? 2 : 3;
  }
  std::optional<std::complex<double>> last_;
  int quadrant_ = 0;
  int turns_ = 0;
};

/// M, or more, around a part; no value where E is not proved to be free of zeros.
std::optional<double> greatest_around(const PairQuotient& f, const Part& part) {
  constexpr std::size_t arcs = 16;
  static const auto directions = [] {
    std::array<std::complex<double>, arcs + 1> found;
    for (std::size_t k = 0; k <= arcs; ++k) {
      const double phi = M_PI * static_cast<double>(k) / arcs;
      found[k] = {std::cos(phi), k == 0 || k == arcs ? 0 : std::sin(phi)};
    }
    return found;
  }();
  const double a = part.half * (rho + 1 / rho) / 2;
  const double b = part.half * (rho - 1 / rho) / 2;
  // Half of an arc is no longer, and what the points are off is less.
  const double r = a * (M_PI / (2 * arcs)) * (1 + 1e-9);
  Turns of_d;
  Turns of_s;
  double greatest = 0;
  for (const auto& direction : directions) {
    const std::complex<double> z(part.middle + a * direction.real(), b * direction.imag());
    const Spread s = spread(f.radicand.coefficients, z, r);
    if (!of_s.add(s)) return std::nullopt;
    const Spread d = spread(f.denominator.coefficients, z, r);
    if (!of_d.add(d)) return std::nullopt;
    const Spread n = spread(f.numerator.coefficients, z, r);
    greatest = std::max(greatest, n.most() / (d.least() * std::sqrt(s.least())));
  }
  if (!of_d.is_free() || !of_s.is_free() || !(greatest < HUGE_VAL)) return std::nullopt;
  return greatest * (1 + 1e-9);
}

/// Of weights times values at points.
struct Sums {
  NearNumber integral{};
  double size = 0;  ///< of the absolute values
};

/// For run_wide().
struct SumUp {
  const PairQuotient& f;
  const Part& part;
  Sums& sums;

  template <class T>
  [[gnu::always_inline]] inline void run() const;
};

// u = D²S, and 1/√u = y + y·(e/2 + 3e²/8 + …), without 3e²/8 < 2^−100, with y = 1/√u in doubles, e
// = 1 − u·y², |e| < 2^−50.
template <class T>
inline void SumUp::run() const {
  const NearRule& rule = NearRule::known();
  SumOfTwo<T> sum{};
  T size{};
  T error{};
  for (std::size_t k = 0; k < rule_points; k += lanes<T>) {
    const SumOfTwo<T> x = load<T>(rule.high, rule.low, k);
    SumOfTwo<T> t = two_sum(T{} + part.middle, x.high * part.half);
    t = normalized(SumOfTwo<T>{t.high, t.low + x.low * part.half});
    const SumOfTwo<T> n = horner(f.numerator.coefficients, t);
    const SumOfTwo<T> d = horner(f.denominator.coefficients, t);
    const SumOfTwo<T> s = horner(f.radicand.coefficients, t);
    const SumOfTwo<T> u = normalized(normalized(d * d) * s);
    T y;
    for (std::size_t i = 0; i < lanes<T>; ++i) y[i] = 1 / std::sqrt(u.high[i]);
    const SplitFactor<T> of_y = split_factor(y);
    const SumOfTwo<T> product = u * two_product(of_y, of_y);
    const T e = (1.0 - product.high) - product.low;
    const SumOfTwo<T> root{y, y * (e * 0.5)};
    const SumOfTwo<T> weight = load<T>(rule.weight_high, rule.weight_low, k);
    const SumOfTwo<T> g = normalized(normalized(n * root) * weight);
    sum = normalized(sum + g);
    const T of_g = g.high < 0.0 ? -g.high : g.high;
    const T of_d = d.high < 0.0 ? -d.high : d.high;
    size += of_g;
    error += of_g * (f.denominator.error / of_d + f.radicand.error / s.high) +
             weight.high * y * f.numerator.error;
  }
  for (std::size_t i = 0; i < lanes<T>; ++i) {
    sums.integral = sums.integral + NearNumber{{sum.high[i], sum.low[i]}, error[i] * (1 + 0x1p-30)};
    sums.size += size[i];
  }
}

/// ∫ over a part, but for the factor.
Sums integral_on(const PairQuotient& f, const Part& part, double greatest) {
  Sums sums;
  run_wide(widest(), SumUp{f, part, sums});
  constexpr double left_out = 4.02 / (1 - 1 / (rho * rho));
  // Less than 60 roundings are in what is summed.
  sums.integral.error +=
      60 * pair_step * sums.size + left_out * greatest * std::pow(rho, -2.0 * rule_points);
  const DoubleDouble& sum = sums.integral.value;
  const double by = f.denominator.coefficients.front().high < 0 ? -part.half : part.half;
  return {{{sum.high * by, sum.low * by}, sums.integral.error * part.half}, sums.size * part.half};
}

/// Of f on [−1, 1] where it is on a part, with the exact polynomials there.
UnitQuotient on_part(UnitQuotient f, const Part& part) {
  f = half_of(f, 1);
  double middle = 0.5;
  for (double half = 0.5; half > part.half; half /= 2) {
    const long side = part.middle > middle ? 1 : -1;
    f = half_of(f, side);
    middle += static_cast<double>(side) * half / 2;
  }
  return f;
}

/// ∫ over a part; no value where it is to be halved. Where the powers of t cancel the exact
/// polynomials of x do better.
std::optional<RealBall> near_integral(const UnitQuotient& given, const PairQuotient& f,
                                      const Part& part) {
  const auto ball_of = [](const Sums& sums, const RealBall& factor) {
    const auto& [high, low] = sums.integral.value;
    return multiply(widened(exact_sum(high, low), raised(sums.integral.error)), factor, 128);
  };
  const auto is_accurate = [](const Sums& sums) {
    return raised(sums.integral.error) < least_accuracy * sums.size;
  };
  const auto greatest = greatest_around(f, part);
  if (!greatest) return std::nullopt;
  const Sums sums = integral_on(f, part, *greatest);
  if (is_accurate(sums)) return ball_of(sums, f.factor);
  const PairQuotient of_x(on_part(given, part));
  const auto greatest_of_x = greatest_around(of_x, {0, 1});
  if (!greatest_of_x) return std::nullopt;
  const Sums sums_of_x = integral_on(of_x, {0, 1}, *greatest_of_x);
  if (!is_accurate(sums_of_x)) return std::nullopt;
  return times_power_of_two(ball_of(sums_of_x, of_x.factor), std::ilogb(part.half));
}

}  // namespace

std::optional<RealBall> near_integral(const UnitQuotient& f) {
  for (const IntegerPolynomial* p : {&f.numerator, &f.denominator, &f.radicand})
    if (fmpz_poly_length(p->get()) > static_cast<long>(most_taylor) + 1 ||
        fmpz_poly_is_zero(p->get()) != 0)
      return std::nullopt;
  return rounding_to_nearest([&]() -> std::optional<RealBall> {
    const PairQuotient of_t(f);
    RealBall sum;
    std::size_t parts = 0;
    std::vector<Part> open{{0.5, 0.5}};
    while (!open.empty()) {
      const Part part = open.back();
      open.pop_back();
      if (const auto found = near_integral(f, of_t, part)) {
        sum = add(sum, *found, 128);
        ++parts;
        continue;
      }
      if (parts + open.size() + 2 > most_parts) return std::nullopt;
      const double half = part.half / 2;
      open.push_back({part.middle + half, half});
      open.push_back({part.middle - half, half});
    }
    return sum;
  });
}

}  // namespace phrame
