#include "phrame/algebra/unit_series.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/unit_recurrence.hpp"

// ‖p‖ = Σ |pₖ|, so that |p(x)| ≤ ‖p‖; 1/√σ ≤ B, 1/|δ| ≤ C, ‖ν‖ ≤ 1, σ₀ = δ₀ = w₀ = 1.
//
// 1. r = σ·w′ + σ′·w/2 has (w√σ)′ = r/√σ, so |w√σ − 1| ≤ B·Σ |rₖ|/(k + 1), |w − 1/√σ| ≤ B²·(same).
//    Its coefficients are rₙ₋₁ = Σ (n − i/2)·σᵢ·wₙ₋ᵢ. For n < length, wₙ makes it 0, but for the
//    rounding of wₙ, times n, and that of the σᵢ, times (n − i/2)·|wₙ₋ᵢ| ≤ n·|wₙ₋ᵢ|. For n ≥ length
//    |rₙ₋₁|/n ≤ Σ |σᵢ|·|wₙ₋ᵢ|, with wₙ₋ᵢ = 0 for n − i ≥ length. The first part is what
//    RootRecurrence counts.
// 2. G − y = (ν·(1/√σ − w) + (ν·w − δ·y))/δ, so
//      |G − y| ≤ C·(B²·Σ |rₖ|/(k + 1) + ‖ν·w − δ·y‖),
//    and ‖ν·w − δ·y‖ has the same two parts; the first is that of QuotientRecurrence.
// 3. The coefficients of ∫y are rounded once more, at both ends.
// All these are counted in units of 2^−Q.

namespace phrame::inline v0 {
namespace {

/// Upwards, for sums and products of up to 10⁶ doubles ≥ 0.
constexpr double round_up = 1 + 1e-9;

/// Σ_{i ≥ k} |pᵢ| for each k.
std::vector<double> sums_from(const std::vector<double>& p) {
  std::vector<double> sums(p.size(), 0.0);
  double sum = 0;
  for (std::size_t k = p.size(); k-- > 0;) sums[k] = sum += std::abs(p[k]);
  return sums;
}

/// Σ |pᵢ|·|cₖ| over all i + k ≥ the number of the cₖ: of those beyond it.
template <class Number>
double left_out(const std::vector<double>& sums_of_p, const std::vector<Number>& c) {
  double total = 0;
  for (std::size_t k = 1; k < sums_of_p.size() && k <= c.size(); ++k)
    total += sums_of_p[k] * std::abs(to_double(c[c.size() - k]));
  return total * round_up;
}

/// What is left over by the ends of the series.
struct EndOfSeries {
  std::vector<double> sigma;
  std::vector<double> delta;
  std::vector<double> nu;

  explicit EndOfSeries(const UnitQuotient& f)
      : sigma(sums_from(unit_ratios(f.radicand))),
        delta(sums_from(unit_ratios(f.denominator))),
        nu(static_cast<std::size_t>(fmpz_poly_length(f.numerator.get())), 1.0) {}

  /// What is left over by the rounding alone, when all that is left of the series is that: some
  /// units of w, and of y as many times as 1/δ makes of them.
  double of_rounding(const UnitBounds& bounds, double weight_of_root) const {
    const auto tail = [](const std::vector<double>& sums) {
      double total = 0;
      for (std::size_t k = 1; k < sums.size(); ++k) total += sums[k];
      return total;
    };
    return 2 * bounds.root * (weight_of_root * tail(sigma) + static_cast<double>(nu.size())) +
           2 * bounds.quotient * tail(delta);
  }
  template <class Number>
  double of_root(const FixedSeries<Number>& w) const {
    return left_out(sigma, w.c);
  }
  template <class Number>
  double of_quotient(const FixedSeries<Number>& w, const FixedSeries<Number>& y) const {
    return left_out(nu, w.c) + left_out(delta, y.c);
  }
  /// The greatest of all ratios, about.
  double greatest() const { return std::max({sigma.front(), delta.front(), 1.0}); }
};

/// x·2^−Q, exactly.
RealBall in_units(const Integer& x, long Q) {
  RealBall value;
  arb_set_fmpz(value.raw(), x.raw());
  arb_mul_2exp_si(value.raw(), value.raw(), -Q);
  return value;
}
RealBall in_units(double x, long Q) {
  RealBall value;
  arb_set_d(value.raw(), x * round_up);
  arb_mul_2exp_si(value.raw(), value.raw(), -Q);
  return value;
}

/// ∫y, with what is known of it but for its error.
template <class Number>
UnitSeries integrated(const std::vector<Number>& y, long Q) {
  std::vector<Number> coefficients;
  coefficients.reserve(y.size());
  Number even{};
  Number odd{};
  Number size{};
  for (std::size_t n = 0; n < y.size(); ++n) {
    const Number& c = coefficients.emplace_back(floor_quotient(y[n], n + 1));
    (n % 2 == 0 ? odd : even) += c;
    if (sign(y[n]) < 0)
      size -= y[n];
    else
      size += y[n];
  }
  UnitSeries result;
  result.coefficients = std::move(coefficients);
  result.Q = Q;
  result.start = in_units(to_integer(Number(even - odd)), Q);
  result.whole = in_units(to_integer(odd) << 1U, Q);
  result.size = in_units(to_integer(size), Q);  // ‖y‖
  return result;
}

/// What is aimed at.
struct Aim {
  double of_root;   ///< B², as in 1.
  double of_all;    ///< 2C
  double terms;     ///< about so many
  long Q;           ///< all is in units of 2^−Q
  double left_out;  ///< so much may be left out at the ends, in these units
  long most_bits;   ///< so many have the coefficients behind the point, of any series
};

/// No value where its numbers do not fit, or get smaller far more slowly than is expected.
template <class Number>
std::optional<UnitSeries> series_by(const UnitQuotient& f, const EndOfSeries& end, const Aim& aim) {
  const auto fits = [](const FixedSeries<Number>& series) {
    return std::same_as<Number, Integer> ||
           series.most + static_cast<long>(std::bit_width(2 * series.c.size())) <= most_factor_bits;
  };
  RootRecurrence<Number> root(f, aim.Q, aim.most_bits);
  QuotientRecurrence<Number> quotient(f, aim.most_bits);
  quotient.step(root.w());
  double left_out = INFINITY;
  while (!(left_out <= aim.left_out)) {
    if (static_cast<double>(root.w().c.size()) > 4 * aim.terms + 1000) return std::nullopt;
    for (int k = 0; k < 4; ++k) {
      root.step();
      quotient.step(root.w());
      if (!fits(root.w()) || !fits(quotient.y())) return std::nullopt;
    }
    if (std::max(root.w().most, quotient.y().most) < 900)
      left_out = aim.of_all *
                 (aim.of_root * end.of_root(root.w()) + end.of_quotient(root.w(), quotient.y()));
  }
  UnitSeries result = integrated(quotient.y().c, aim.Q);
  const double rounded = aim.of_all * (aim.of_root * root.w().left_over + quotient.y().left_over) +
                         2 * static_cast<double>(quotient.y().c.size());
  result.error = in_units(left_out + rounded, aim.Q);
  result.size = add(result.size, result.error, 64);
  return result;
}

/// The same by numbers of two words, where these do; there the coefficients may have fewer bits
/// than is aimed at, and what comes of that is seen by the error.
std::optional<UnitSeries> short_series(const UnitQuotient& f, const EndOfSeries& end, Aim aim,
                                       std::size_t count, long bits) {
  if (count > most_products || !(end.greatest() < 0x1p40)) return std::nullopt;
  aim.most_bits = most_factor_bits - 1 - static_cast<long>(std::ceil(std::log2(end.greatest())));
  if (aim.Q + 3 > aim.most_bits) return std::nullopt;
  auto series = series_by<TwoWords>(f, end, aim);
  if (series && series->error.upper() > power_of_two(-bits)) return std::nullopt;
  return series;
}

}  // namespace

const BallPolynomial& UnitSeries::integral() const {
  return integral_.get([this] {
    std::vector<RealBall> ascending(1);
    std::visit(
        [&](const auto& all) {
          for (const auto& c : all) ascending.push_back(in_units(to_integer(c), Q));
        },
        coefficients);
    return BallPolynomial(ascending);
  });
}

std::optional<UnitSeries> unit_series(const UnitQuotient& f, const UnitBounds& bounds, long bits) {
  Aim aim{};
  aim.of_root = bounds.root * bounds.root * round_up;
  aim.of_all = 2 * bounds.quotient * round_up;
  const std::size_t count = static_cast<std::size_t>(fmpz_poly_length(f.numerator.get()) +
                                                     fmpz_poly_length(f.denominator.get()) +
                                                     fmpz_poly_length(f.radicand.get()));
  // About so many terms, and so many units for their rounding.
  aim.terms =
      (static_cast<double>(bits) + std::log2(aim.of_root * aim.of_all) + 8) / bounds.bits_per_term +
      static_cast<double>(count);
  const EndOfSeries end(f);
  const double roundings = aim.of_all * std::max((aim.of_root + 1) * 2 * aim.terms,
                                                 end.of_rounding(bounds, aim.of_root)) +
                           2 * aim.terms;
  aim.Q = bits + 1 + static_cast<long>(std::ceil(std::log2(roundings)));
  aim.left_out = 0.5 * std::ldexp(1.0, static_cast<int>(std::min(aim.Q - bits, 1000L)));
  aim.most_bits = aim.Q + 2 + bit_length(Integer(static_cast<long>(count))) +
                  static_cast<long>(std::log2(bounds.root * bounds.quotient));
  if (auto series = short_series(f, end, aim, count, bits)) return series;
  return series_by<Integer>(f, end, aim);
}

}  // namespace phrame
