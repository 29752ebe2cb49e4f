#include "phrame/integrate/taylor_integral.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/on_half.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/series_guess.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/algebra/sturm.hpp"

// [0, 1] is halved into parts [m − h, m + h] until, with t = m + hx, the Taylor series of 1/√S and
// 1/D in x converge well beyond |x| = 1. On a part let ‖p‖ = Σ |pₖ|, so that |p(x)| ≤ ‖p‖.
//
// 1. That a part will do is shown by short polynomials u ≈ 1/√S and q ≈ 1/D of about double
//    precision, of which nothing is known but what is left over:
//      ‖S·u² − 1‖ ≤ 1/2 gives S > 0 and 1/√S ≤ √2·|u| ≤ B := √2·‖u‖,
//      ‖D·q − 1‖ ≤ 1/2 gives D ≠ 0 and 1/|D| ≤ 2·|q| ≤ C := 2·‖q‖      for −1 ≤ x ≤ 1.
// 2. To many bits let w ≈ 1/√S be a polynomial, and r = S·w′ + S′·w/2. Then (w√S)′ = r/√S, so
//      |w√S − 1| ≤ |w(0)·√S(0) − 1| + B·Σ |rₖ|/(k + 1) =: e,  |w − 1/√S| ≤ B·e.
// 3. Let y ≈ N·w/D be a polynomial. N/(D√S) − y = (N·(1/√S − w) + (N·w − D·y))/D, so
//      |N/(D√S) − y| ≤ C·(‖N‖·B·e + ‖N·w − D·y‖) =: E.
// 4. From x₀ to x₁ the integral is h·(Y(x₁) − Y(x₀)) with Y = ∫y, off by h·|x₁ − x₀|·E at most.
//
// w and y come from the recurrences that D and S give, in floating point (series_guess): what is
// left over holds their rounding and truncation errors, whatever these are. All sizes above are
// found in balls. No root of D or S is asked for; the number of terms is guessed from the first
// coefficients, and raised until E is small enough.

namespace phrame {

/// [middle − 2^−(level+1), middle + 2^−(level+1)], with the polynomials in x there.
struct SeriesPart {
  Rational middle{1, 2};
  long level = 0;
  Polynomial N;
  Polynomial D;
  Polynomial S;
  double bits_per_term = 1;  ///< by which the coefficients get smaller
  RealBall root_bound;       ///< B
  RealBall quotient_bound;   ///< C

  Rational start() const { return middle - power_of_two(-level - 1); }
};

/// What is known of a part to some number of bits.
struct SeriesExpansion {
  BallPolynomial integral;  ///< h·Y in x, Y(−1) = 0
  RealBall error;           ///< 2h·E
  RealBall before;          ///< ∫ from 0 to the start of the part
  RealBall whole;           ///< ∫ over the part
  RealBall size;            ///< |N/(D√S)| is no greater
};

namespace {

constexpr long greatest_level = 8192;

/// By how many bits a coefficient of c is smaller than the one before, about.
double decay(const BallPolynomial& c, long length) {
  double first = -INFINITY;
  double second = -INFINITY;
  for (long k = 0; k < length; ++k) {
    const long e = exponent_above(c.coefficient(k));
    const double size = e == -unbounded_exponent ? -1e6 : static_cast<double>(e);
    double& half = 2 * k < length ? first : second;
    half = std::max(half, size);
  }
  return 2 * (first - second) / static_cast<double>(length);
}

SeriesPart half_of(const SeriesPart& part, long side) {
  SeriesPart half;
  half.level = part.level + 1;
  half.middle = part.middle + Rational(side) * power_of_two(-half.level - 1);
  half.N = on_half(part.N, side);
  half.D = on_half(part.D, side);
  half.S = on_half(part.S, side);
  return half;
}

/// Step 1: is the part short enough? Then its bounds are known.
bool has_bounds(SeriesPart& part) {
  const long degree = std::max(part.D.degree(), part.S.degree());
  const long bits = 64 + 2 * degree;
  const long length = 16 + degree;
  const BallPolynomial S(part.S, bits);
  const BallPolynomial D(part.D, bits);
  const BallPolynomial one{Polynomial{1}, bits};
  const BallPolynomial u = guess_inverse_sqrt(S, length, bits);
  const BallPolynomial q = guess_quotient(one, D, length, bits);
  const RealBall half(Rational(1, 2), bits);
  const BallPolynomial square = multiply(u, u, bits);
  if (!is_at_most(sum_of_sizes(subtract(multiply(S, square, bits), one, bits)), half)) return false;
  if (!is_at_most(sum_of_sizes(subtract(multiply(D, q, bits), one, bits)), half)) return false;
  part.bits_per_term = std::min({decay(u, length), decay(q, length), 8.0});
  if (part.bits_per_term < 0.9) return false;
  part.root_bound = multiply(RealBall(Rational(3, 2), bits), sum_of_sizes(u), bits);
  part.quotient_bound = multiply(RealBall(2, bits), sum_of_sizes(q), bits);
  return true;
}

std::vector<SeriesPart> series_parts(const RootQuotient& f) {
  std::vector<SeriesPart> parts;
  std::vector<SeriesPart> open(1);
  open.back().N = on_half(f.numerator, 1);
  open.back().D = on_half(f.denominator, 1);
  open.back().S = on_half(f.radicand, 1);
  while (!open.empty()) {
    SeriesPart part = std::move(open.back());
    open.pop_back();
    if (has_bounds(part)) {
      parts.push_back(std::move(part));
    } else {
      if (part.level == greatest_level)
        throw Undecided(
            fmt::format("the integrand has a singularity closer than 2^-{} to t = {:.9g}",
                        greatest_level, static_cast<double>(part.middle)));
      open.push_back(half_of(part, 1));
      open.push_back(half_of(part, -1));
    }
  }
  return parts;
}

/// e of step 2.
RealBall root_error(const SeriesPart& part, const BallPolynomial& S, const BallPolynomial& w,
                    long bits) {
  const RealBall half(Rational(1, 2), bits);
  const BallPolynomial left_over =
      add(multiply(S, differentiate(w, bits), bits),
          multiply(half, multiply(differentiate(S, bits), w, bits), bits), bits);
  const RealBall at_0 = subtract(multiply(w.coefficient(0), sqrt(S.coefficient(0), bits), bits),
                                 RealBall(1, bits), bits);
  const RealBall spread =
      multiply(part.root_bound, sum_of_sizes(antiderivative(left_over, bits)), bits);
  return add(absolute(at_0), spread, bits);
}

/// y, and E of step 3.
struct Approximation {
  BallPolynomial y;
  RealBall error;
};

Approximation approximation(const SeriesPart& part, long length, long bits) {
  const BallPolynomial N(part.N, bits);
  const BallPolynomial D(part.D, bits);
  const BallPolynomial S(part.S, bits);
  const BallPolynomial w = guess_inverse_sqrt(S, length, bits);
  const BallPolynomial product = multiply(N, w, bits);
  BallPolynomial y = guess_quotient(product, D, length, bits);
  const RealBall of_root = multiply(part.root_bound, root_error(part, S, w, bits), bits);
  const RealBall left_over = sum_of_sizes(subtract(product, multiply(D, y, bits), bits));
  const RealBall sum = add(multiply(sum_of_sizes(N), of_root, bits), left_over, bits);
  return {std::move(y), multiply(part.quotient_bound, sum, bits)};
}

/// E ≤ 2^−bits·‖y‖.
SeriesExpansion expansion(const SeriesPart& part, long bits) {
  const long degree = std::max(part.N.degree(), 0L) + part.D.degree() + part.S.degree();
  long precision = bits + 24 + degree / 2;
  for (int attempt = 0; attempt < 16; ++attempt) {
    const double terms = static_cast<double>(precision) / part.bits_per_term;
    const long length = static_cast<long>(terms * (1.08 + 0.2 * attempt)) + degree / 2 + 8;
    const Approximation found = approximation(part, length, precision);
    const RealBall size = sum_of_sizes(found.y);
    if (is_at_most(found.error, times_power_of_two(size, -bits))) {
      SeriesExpansion result;
      BallPolynomial Y = antiderivative(found.y, precision);
      Y = with_constant(Y,
                        subtract({}, evaluate(Y, RealBall(-1, precision), precision), precision));
      result.integral =
          multiply(times_power_of_two(RealBall(1, precision), -part.level - 1), Y, precision);
      result.error = times_power_of_two(found.error, -part.level);
      result.size = add(size, found.error, precision);
      result.whole =
          widened(evaluate(result.integral, RealBall(1, precision), precision), result.error);
      return result;
    }
    precision += 24 + bits / 8;
  }
  throw Undecided(
      fmt::format("the Taylor series of the integrand at t = {:.9g} did not give {} bits",
                  static_cast<double>(part.middle), bits));
}

std::vector<SeriesExpansion> expansions(const std::vector<SeriesPart>& parts, long bits) {
  std::vector<SeriesExpansion> all;
  RealBall sum;
  for (const SeriesPart& part : parts) {
    all.push_back(expansion(part, bits));
    all.back().before = sum;
    sum = add(sum, all.back().whole, bits + 32);
  }
  return all;
}

void require_no_zero(const Polynomial& p, const char* name) {
  if (p.is_constant()) return;
  const std::vector<Interval> zeros = isolate_real_roots(p, closed(0, 1));
  if (zeros.empty()) return;
  const Rational near = (*zeros.front().lower + *zeros.front().upper) / 2;
  throw DomainError(
      fmt::format("the {} of the integrand is 0 near t = {:.9g}", name, static_cast<double>(near)));
}

/// S = c·g²·S₁: N/(D·|g|·√(c·S₁)) in lowest terms, D > 0.
RootQuotient in_lowest_terms(const RootQuotient& f) {
  if (f.denominator.is_zero() || f.radicand.is_zero())
    throw DomainError("the integrand is divided by 0");
  require_no_zero(f.radicand, "radicand");
  if (f.radicand(0) < 0) throw DomainError("the radicand of the integrand is negative");
  if (f.numerator.is_zero()) return {};
  Polynomial g{1};
  Polynomial rest{1};
  const Factorization factors = squarefree_factorization(f.radicand);
  for (const Factor& factor : factors.factors) {
    g *= pow(factor.base, factor.exponent / 2);
    if (factor.exponent % 2 != 0) rest *= factor.base;
  }
  const Polynomial all = Rational(g(0).sign()) * f.denominator * g;
  const Polynomial common = gcd(f.numerator, all);
  RootQuotient lowest{exact_quotient(f.numerator, common), exact_quotient(all, common),
                      factors.unit * rest};
  require_no_zero(lowest.denominator, "denominator");
  const Rational sign = lowest.denominator(0).sign();
  lowest.numerator *= sign;
  lowest.denominator *= sign;
  return lowest;
}

/// F, where it is a polynomial over ℚ.
std::optional<Polynomial> polynomial_integral(const RootQuotient& f) {
  if (!f.denominator.is_constant() || !f.radicand.is_constant()) return std::nullopt;
  const auto root = square_root(f.radicand.coefficient(0));
  if (!root) return std::nullopt;
  return Rational(1 / (f.denominator.coefficient(0) * *root)) * antiderivative(f.numerator);
}

void require_inside(const Rational& t) {
  if (t < 0 || t > 1)
    throw DomainError(fmt::format("integral: t = {} is outside [0, 1]", abbreviated(to_string(t))));
}

}  // namespace

struct TaylorIntegral::State {
  RootQuotient f;
  std::optional<Polynomial> exact;  ///< F, where that is a polynomial over ℚ
  Lazy<std::vector<SeriesPart>> parts;
  Refined<std::vector<SeriesExpansion>> known;

  explicit State(const RootQuotient& given)
      : f(in_lowest_terms(given)), exact(polynomial_integral(f)) {}

  const std::vector<SeriesPart>& all_parts() const {
    return parts.get([this] { return series_parts(f); });
  }
  std::size_t part_at(const Rational& t) const;
  std::shared_ptr<const std::vector<SeriesExpansion>> to_bits(long bits) const;
};

/// The last part that begins at t or before.
std::size_t TaylorIntegral::State::part_at(const Rational& t) const {
  const std::vector<SeriesPart>& all = all_parts();
  const auto next = std::upper_bound(
      all.begin() + 1, all.end(), t,
      [](const Rational& at, const SeriesPart& part) { return at < part.start(); });
  return static_cast<std::size_t>(next - all.begin()) - 1;
}

TaylorIntegral::TaylorIntegral(const RootQuotient& f) : state_(std::make_shared<State>(f)) {}

const RootQuotient& TaylorIntegral::integrand() const { return state_->f; }

/// What is known to at least so many bits.
std::shared_ptr<const std::vector<SeriesExpansion>> TaylorIntegral::State::to_bits(
    long bits) const {
  const long enough = (std::max(bits, 32L) + 31) / 32 * 32;
  return known.get(enough, [&](const auto*) { return expansions(all_parts(), enough); });
}

RealBall TaylorIntegral::enclose(const Rational& t, long bits) const {
  require_inside(t);
  if (state_->exact) return RealBall((*state_->exact)(t), bits);
  const auto known = state_->to_bits(bits);
  const std::size_t k = state_->part_at(t);
  const SeriesPart& part = state_->all_parts()[k];
  const SeriesExpansion& here = (*known)[k];
  const long precision = bits + 32;
  const RealBall x =
      times_power_of_two(RealBall(Rational(t - part.middle), precision), part.level + 1);
  return add(here.before, widened(evaluate(here.integral, x, precision), here.error), precision);
}

RealBall TaylorIntegral::enclose(const RealBall& t, long bits) const {
  const Rational lower = std::max(Rational(0), t.lower());
  const Rational upper = std::min(Rational(1), t.upper());
  const Rational middle = (lower + upper) / 2;
  const RealBall there = enclose(middle, bits);
  if (lower == upper) return there;
  if (state_->exact) return evaluate(*state_->exact, t, bits);
  const auto known = state_->to_bits(bits);
  RealBall size;
  for (std::size_t k = state_->part_at(lower); k <= state_->part_at(upper); ++k)
    size = max(size, (*known)[k].size, bits);
  return widened(there, multiply(size, RealBall(Rational(upper - middle), bits), bits));
}

Real TaylorIntegral::value(const Rational& t) const {
  require_inside(t);
  if (t == 0) return Rational(0);
  if (state_->exact) return (*state_->exact)(t);
  return Real([*this, t](long bits) { return enclose(t, bits); }, {false, bits_of(t)});
}

RealBall TaylorIntegral::rate(const RealBall& t, long bits) const {
  const auto& [N, D, S] = state_->f;
  const RealBall below = multiply(evaluate(D, t, bits), sqrt(evaluate(S, t, bits), bits), bits);
  return divide(evaluate(N, t, bits), below, bits);
}

}  // namespace phrame
