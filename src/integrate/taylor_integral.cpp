#include "phrame/integrate/taylor_integral.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/near_integral.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/algebra/unit_series.hpp"
#include "phrame/integrate/lowest_root_quotient.hpp"

// [0, 1] is halved into parts [m − h, m + h] until, with t = m + hx, the Taylor series of 1/√S and
// 1/D in x converge well beyond |x| = 1, which unit_bounds() proves. On a part unit_series() has an
// antiderivative and its error; the parts get as many bits as their shares of the whole need.
// No root of D or S is asked for.

namespace phrame::inline v0 {

/// [middle − 2^−(level+1), middle + 2^−(level+1)].
struct SeriesPart {
  Rational middle{1, 2};
  long level = 0;
  UnitQuotient f;  ///< of x there, times the half of the length
  UnitBounds bounds{};

  Rational start() const { return middle - power_of_two(-level - 1); }
};

/// The parts, and by how many bits more than the whole is known to each of them is to be known.
struct SeriesParts {
  std::vector<SeriesPart> all;
  std::vector<long> more_bits;
};

/// What is known of a part to some number of bits.
struct SeriesExpansion {
  UnitSeries series;
  RealBall factor;  ///< unit_factor()
  RealBall before;  ///< ∫ from 0 to the start of the part
  RealBall whole;   ///< ∫ over the part
  RealBall size;    ///< |N/(D√S)| is no greater
};

/// All of them.
struct SeriesExpansions {
  SeriesParts parts;
  std::vector<SeriesExpansion> of;  ///< as many

  /// The last part that begins at t or before.
  std::size_t part_at(const Rational& t) const;
};

namespace {

constexpr long greatest_level = 4096;
constexpr long most_near_bits = 88;  ///< that pairs of doubles are asked for

SeriesPart half_of(const SeriesPart& part, long side) {
  SeriesPart half;
  half.level = part.level + 1;
  half.middle = part.middle + Rational(side) * power_of_two(-half.level - 1);
  half.f = half_of(part.f, side);
  half.f.factor /= 2;
  return half;
}

/// The parts that these are to be halved into.
std::vector<SeriesPart> short_parts(std::vector<SeriesPart> open) {
  std::vector<SeriesPart> parts;
  while (!open.empty()) {
    SeriesPart part = std::move(open.back());
    open.pop_back();
    if (const auto bounds = unit_bounds(part.f)) {
      part.bounds = *bounds;
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

std::vector<SeriesPart> short_parts(const RootQuotient& f) {
  std::vector<SeriesPart> whole(1);
  // t = (x + 1)/2.
  whole.back().f = half_of(unit_quotient(f.numerator, f.denominator, f.radicand), 1);
  whole.back().f.factor /= 2;
  return short_parts(std::move(whole));
}

/// An error of 2^−(bits + more) of each is one of 2^−bits·∫|f|/4 of the sum, about.
SeriesParts series_parts(std::vector<SeriesPart> all) {
  SeriesParts parts{std::move(all), {}};
  long greatest = -unbounded_exponent;
  for (const SeriesPart& part : parts.all)
    parts.more_bits.push_back(exponent_above(unit_factor(part.f, 32)));
  for (std::size_t k = 0; k < parts.all.size(); ++k)
    if (parts.all[k].bounds.mean_size > 0) greatest = std::max(greatest, parts.more_bits[k]);
  if (greatest == -unbounded_exponent)
    greatest = *std::max_element(parts.more_bits.begin(), parts.more_bits.end());
  double whole = 0;
  for (std::size_t k = 0; k < parts.all.size(); ++k)
    whole += std::ldexp(parts.all[k].bounds.mean_size,
                        static_cast<int>(std::max(parts.more_bits[k] - greatest, -2000L)));
  if (!(whole > 1e-12)) whole = 1e-12;
  const double share = std::log2(static_cast<double>(parts.all.size()) / whole);
  for (long& more : parts.more_bits) more += 2 - greatest + static_cast<long>(std::ceil(share));
  return parts;
}

/// No value where its Taylor series ends far later than its bounds let expect.
std::optional<SeriesExpansion> expansion(const SeriesPart& part, long more, long bits) {
  auto series = unit_series(part.f, part.bounds, std::max(8L, bits + more));
  if (!series) return std::nullopt;
  SeriesExpansion result{std::move(*series), unit_factor(part.f, bits + 32), {}, {}, {}};
  result.whole =
      multiply(result.factor, widened(result.series.whole, result.series.error), bits + 32);
  result.size =
      times_power_of_two(multiply(absolute(result.factor), result.series.size, 64), part.level + 1);
  return result;
}

/// All parts with part k in two, which are shorter beside the distance to the singularities.
SeriesParts with_halves(const SeriesParts& parts, std::size_t k) {
  const auto at = parts.all.begin() + static_cast<long>(k);
  std::vector<SeriesPart> all(parts.all.begin(), at);
  if (at->level == greatest_level)
    throw Undecided(fmt::format("the Taylor series of the integrand at t = {:.9g} do not end",
                                static_cast<double>(at->middle)));
  for (SeriesPart& half : short_parts({half_of(*at, 1), half_of(*at, -1)}))
    all.push_back(std::move(half));
  all.insert(all.end(), at + 1, parts.all.end());
  return series_parts(std::move(all));
}

SeriesExpansions expansions(SeriesParts parts, long bits) {
  std::vector<SeriesExpansion> all;
  RealBall sum;
  while (all.size() < parts.all.size()) {
    const std::size_t k = all.size();
    auto next = expansion(parts.all[k], parts.more_bits[k], bits);
    if (!next) {
      parts = with_halves(parts, k);
      continue;
    }
    all.push_back(*std::move(next));
    all.back().before = sum;
    sum = add(sum, all.back().whole, bits + 32);
  }
  return {std::move(parts), std::move(all)};
}

void require_no_zero(const Polynomial& p, const char* name) {
  if (p.is_constant()) return;
  const std::vector<Interval> zeros = isolate_real_roots(p, closed_interval(0, 1));
  if (zeros.empty()) return;
  const Rational near = (*zeros.front().lower + *zeros.front().upper) / 2;
  throw DomainError(
      fmt::format("the {} of the integrand is 0 near t = {:.9g}", name, static_cast<double>(near)));
}

/// S = g²·rest, where the rest has no multiple root.
struct SplitSquare {
  Polynomial g{1};
  Polynomial rest;
};

SplitSquare split_square(const Polynomial& S) {
  if (is_squarefree(S)) return {{1}, S};
  const Factorization factors = squarefree_factorization(S);
  SplitSquare split{{1}, Polynomial{factors.unit}};
  for (const Factor& factor : factors.factors) {
    split.g *= pow(factor.base, factor.exponent / 2);
    if (factor.exponent % 2 != 0) split.rest *= factor.base;
  }
  return split;
}

}  // namespace

// S = g²·S₁: N/(D·|g|·√S₁).
RootQuotient in_lowest_terms(const RootQuotient& f) {
  if (f.denominator.is_zero() || f.radicand.is_zero())
    throw DomainError("the integrand is divided by 0");
  require_no_zero(f.radicand, "radicand");
  if (f.radicand(0) < 0) throw DomainError("the radicand of the integrand is negative");
  if (f.numerator.is_zero()) return {};
  const auto [g, rest] = split_square(f.radicand);
  const bool is_plain = g == Polynomial{1};
  const Polynomial all = is_plain ? f.denominator : Rational(g(0).sign()) * f.denominator * g;
  const Polynomial common = gcd(f.numerator, all);
  RootQuotient lowest = common == Polynomial{1} ? RootQuotient{f.numerator, all, rest}
                                                : RootQuotient{exact_quotient(f.numerator, common),
                                                               exact_quotient(all, common), rest};
  require_no_zero(lowest.denominator, "denominator");
  if (lowest.denominator(0) < 0) {
    lowest.numerator = -lowest.numerator;
    lowest.denominator = -lowest.denominator;
  }
  return lowest;
}

namespace {

/// F, where it is a polynomial over ℚ.
std::optional<Polynomial> polynomial_integral(const RootQuotient& f) {
  if (!f.denominator.is_constant() || !f.radicand.is_constant()) return std::nullopt;
  const auto root = square_root(f.radicand.coefficient(0));
  if (!root) return std::nullopt;
  return Rational(1 / (f.denominator.coefficient(0) * *root)) * antiderivative(f.numerator);
}

void require_inside(const Rational& t) {
  if (t < 0 || t > 1)
    throw DomainError(fmt::format("integral: t = {} is outside [0, 1]", as_written(t)));
}

/// F(1) to about `most_near_bits`, where S has no root that is a polynomial, so that F is none.
std::optional<RealBall> near_value(const RootQuotient& f) {
  if (f.radicand.is_constant() || f.denominator.is_zero() || !is_squarefree(f.radicand))
    return std::nullopt;
  return near_integral(unit_quotient(f.numerator, f.denominator, f.radicand));
}

}  // namespace

struct TaylorIntegral::State {
  RootQuotient f;  ///< in lowest terms, where `near` does not tell that S > 0, D ≠ 0
  std::optional<RealBall> near{};
  std::optional<Polynomial> exact{};  ///< F, where that is a polynomial over ℚ
  Lazy<RootQuotient> lowest{};
  Refined<SeriesExpansions> known{};

  explicit State(const RootQuotient& given) : f(given), near(near_value(given)) {
    if (near) return;
    f = in_lowest_terms(given);
    exact = polynomial_integral(f);
  }

  const RootQuotient& in_lowest() const {
    return near ? lowest.get([this] { return in_lowest_terms(f); }) : f;
  }
  std::shared_ptr<const SeriesExpansions> to_bits(long bits) const;
};

std::size_t SeriesExpansions::part_at(const Rational& t) const {
  const auto next = std::upper_bound(
      parts.all.begin() + 1, parts.all.end(), t,
      [](const Rational& at, const SeriesPart& part) { return at < part.start(); });
  return static_cast<std::size_t>(next - parts.all.begin()) - 1;
}

TaylorIntegral::TaylorIntegral(const RootQuotient& f) : state_(std::make_shared<State>(f)) {}

const RootQuotient& TaylorIntegral::integrand() const { return state_->in_lowest(); }

/// What is known to at least so many bits.
std::shared_ptr<const SeriesExpansions> TaylorIntegral::State::to_bits(long bits) const {
  const long enough = (std::max(bits, 32L) + 7) / 8 * 8;
  return known.get(enough, [&](const SeriesExpansions* before) {
    return expansions(before != nullptr ? before->parts : series_parts(short_parts(in_lowest())),
                      enough);
  });
}

RealBall TaylorIntegral::enclose(const Rational& t, long bits) const {
  require_inside(t);
  if (state_->exact) return RealBall((*state_->exact)(t), bits);
  if (t == 1 && state_->near && bits <= most_near_bits) return *state_->near;
  const auto known = state_->to_bits(bits);
  if (t == 1) return add(known->of.back().before, known->of.back().whole, bits + 32);
  const std::size_t k = known->part_at(t);
  const SeriesPart& part = known->parts.all[k];
  const SeriesExpansion& here = known->of[k];
  const long precision = bits + 32;
  const RealBall x =
      times_power_of_two(RealBall(Rational(t - part.middle), precision), part.level + 1);
  const RealBall from_start =
      subtract(evaluate(here.series.integral(), x, precision), here.series.start, precision);
  return add(here.before, multiply(here.factor, widened(from_start, here.series.error), precision),
             precision);
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
  for (std::size_t k = known->part_at(lower); k <= known->part_at(upper); ++k)
    size = max(size, known->of[k].size, bits);
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
