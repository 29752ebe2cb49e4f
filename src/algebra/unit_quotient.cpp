#include "phrame/algebra/unit_quotient.hpp"

#include <algorithm>
#include <cmath>

namespace phrame::inline v0 {
namespace {

/// Rounding errors of sums of products of doubles and of their factors are counted with it.
constexpr double ulp_50 = 0x1p-50;
/// Below 1: what is worse is halved. With it the parts are about as many as cost least.
constexpr double least_bits_per_term = 0.9;

/// m·2ᵉ.
struct Scaled {
  double m;
  slong e;
};

Scaled scaled(const fmpz* x) {
  Scaled s{0, 0};
  if (fmpz_is_zero(x) == 0) s.m = fmpz_get_d_2exp(&s.e, x);
  return s;
}

double quotient(const Scaled& a, const Scaled& b, long shift) {
  const long e = std::clamp<long>(a.e - b.e - shift, -4000, 4000);
  return std::ldexp(a.m / b.m, static_cast<int>(e));
}

std::vector<double> product(const std::vector<double>& p, const std::vector<double>& q) {
  std::vector<double> result(p.size() + q.size() - 1, 0.0);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) result[i + j] += p[i] * q[j];
  return result;
}

double sum_of_absolutes(const std::vector<double>& p) {
  double sum = 0;
  for (const double x : p) sum += std::abs(x);
  return sum;
}

/// w·n·σ(0) = −Σ (n − i/2)·σᵢ·wₙ₋ᵢ, from σ·w′ = −σ′·w/2.
std::vector<double> inverse_root_guess(const std::vector<double>& s, std::size_t length) {
  std::vector<double> w(length, 0.0);
  w[0] = 1;
  for (std::size_t n = 1; n < length; ++n) {
    double sum = 0;
    for (std::size_t i = 1; i < s.size() && i <= n; ++i)
      sum += (static_cast<double>(n) - static_cast<double>(i) / 2) * s[i] * w[n - i];
    w[n] = -sum / static_cast<double>(n);
  }
  return w;
}

std::vector<double> inverse_guess(const std::vector<double>& d, std::size_t length) {
  std::vector<double> q(length, 0.0);
  q[0] = 1;
  for (std::size_t n = 1; n < length; ++n)
    for (std::size_t i = 1; i < d.size() && i <= n; ++i) q[n] -= d[i] * q[n - i];
  return q;
}

/// By how many bits a coefficient is smaller than the one before, about.
double decay(const std::vector<double>& c) {
  double first = 1e-290;
  double second = 1e-290;
  for (std::size_t k = 0; k < c.size(); ++k) {
    double& half = 2 * k < c.size() ? first : second;
    half = std::max(half, std::abs(c[k]));
  }
  return 2 * std::log2(first / second) / static_cast<double>(c.size());
}

/// Is Σ |coefficients of a·b − 1| ≤ 1/2, for all a, b whose coefficients are off by `relative` of
/// sizes that sum to `size` for the whole product?
bool leaves_a_half(const std::vector<double>& a, const std::vector<double>& b, double size) {
  std::vector<double> rest = product(a, b);
  rest[0] -= 1;
  const double errors = static_cast<double>(4 * (a.size() + b.size())) * ulp_50 * size + 1e-280;
  return sum_of_absolutes(rest) * (1 + 1e-9) + errors <= 0.5;
}

double horner(const std::vector<double>& p, double x) {
  double value = 0;
  for (std::size_t k = p.size(); k-- > 0;) value = value * x + p[k];
  return value;
}

IntegerPolynomial on_half(const IntegerPolynomial& p, long side) {
  IntegerPolynomial result = p;
  const slong n = fmpz_poly_degree(p.get());
  for (slong k = 0; k < n; ++k) {
    fmpz* c = fmpz_poly_get_coeff_ptr(result.get(), k);
    fmpz_mul_2exp(c, c, static_cast<ulong>(n - k));
  }
  const Integer by(side);
  if (n > 0) fmpz_poly_taylor_shift(result.get(), result.get(), by.raw());
  return result;
}

Rational two_to(long k) {
  const Integer power = Integer(1) << static_cast<unsigned long>(std::abs(k));
  return k >= 0 ? Rational(power) : Rational(Integer(1), power);
}

/// N/2ᵉ in doubles.
std::vector<double> numerator_ratios(const IntegerPolynomial& numerator) {
  const long e = unit_exponent(numerator);
  std::vector<double> all;
  for (slong k = 0; k < fmpz_poly_length(numerator.get()); ++k)
    all.push_back(quotient(scaled(numerator.get()->coeffs + k), {1, 0}, e));
  return all;
}

}  // namespace

UnitQuotient unit_quotient(const Polynomial& numerator, const Polynomial& denominator_of,
                           const Polynomial& radicand) {
  // S·d² is over ℤ where S·d is, and has the root d·√S.
  const Integer d = denominator(radicand);
  UnitQuotient f{integer_numerator(numerator), integer_numerator(denominator_of),
                 integer_numerator(Rational(d) * (Rational(d) * radicand)), Rational(1)};
  f.factor = Rational(d) * Rational(denominator(denominator_of)) / Rational(denominator(numerator));
  return f;
}

// p((z + side)/2) is over ℤ when it is multiplied by 2^deg p; of S an even power is taken out.
UnitQuotient half_of(const UnitQuotient& f, long side) {
  UnitQuotient half{on_half(f.numerator, side), on_half(f.denominator, side),
                    on_half(f.radicand, side), f.factor};
  const slong of_root = fmpz_poly_degree(f.radicand.get());
  if (of_root % 2 != 0) fmpz_poly_scalar_mul_2exp(half.radicand.get(), half.radicand.get(), 1);
  const slong of_numerator = std::max<slong>(0, fmpz_poly_degree(f.numerator.get()));
  half.factor *= two_to(fmpz_poly_degree(f.denominator.get()) + (of_root + 1) / 2 - of_numerator);
  return half;
}

long unit_exponent(const IntegerPolynomial& numerator) {
  const auto bits = std::abs(fmpz_poly_max_bits(numerator.get()));
  return bits +
         static_cast<long>(FLINT_BIT_COUNT(static_cast<ulong>(fmpz_poly_length(numerator.get()))));
}

RealBall unit_factor(const UnitQuotient& f, long bits) {
  const long more = bits + 8;
  RealBall root;
  arb_set_fmpz(root.raw(), f.radicand.get()->coeffs);
  arb_sqrt(root.raw(), root.raw(), more);
  arb_mul_fmpz(root.raw(), root.raw(), f.denominator.get()->coeffs, more);
  RealBall result(f.factor, more);
  arb_mul_2exp_si(result.raw(), result.raw(), unit_exponent(f.numerator));
  return divide(result, root, more);
}

std::vector<double> unit_ratios(const IntegerPolynomial& p) {
  std::vector<double> all{1};
  const Scaled first = scaled(p.get()->coeffs);
  for (slong k = 1; k < fmpz_poly_length(p.get()); ++k)
    all.push_back(quotient(scaled(p.get()->coeffs + k), first, 0));
  return all;
}

// All that is compared is false for what is not a number.
std::optional<UnitBounds> unit_bounds(const UnitQuotient& f) {
  const std::vector<double> s = unit_ratios(f.radicand);
  const std::vector<double> d = unit_ratios(f.denominator);
  const std::size_t length = 15 + std::max(s.size(), d.size());
  const std::vector<double> u = inverse_root_guess(s, length);
  const std::vector<double> q = inverse_guess(d, length);
  const double bits_per_term = std::min({decay(u), decay(q), 8.0});
  if (!(bits_per_term >= least_bits_per_term)) return std::nullopt;
  const double size_of_u = sum_of_absolutes(u);
  const double size_of_q = sum_of_absolutes(q);
  if (!leaves_a_half(d, q, sum_of_absolutes(d) * size_of_q)) return std::nullopt;
  if (!leaves_a_half(s, product(u, u), sum_of_absolutes(s) * size_of_u * size_of_u))
    return std::nullopt;
  const std::vector<double> n = numerator_ratios(f.numerator);
  double mean = 0;
  for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0})
    mean += std::abs(horner(n, x) * horner(u, x) * horner(q, x)) / 5;
  return UnitBounds{1.5 * size_of_u, 2.1 * size_of_q, bits_per_term, mean};
}

}  // namespace phrame
