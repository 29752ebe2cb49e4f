#include "phrame/algebra/unit_series.hpp"

#include <algorithm>
#include <cmath>

// ‖p‖ = Σ |pₖ|, so that |p(x)| ≤ ‖p‖; 1/√σ ≤ B, 1/|δ| ≤ C, ‖ν‖ ≤ 1, σ₀ = δ₀ = w₀ = 1.
//
// 1. r = σ·w′ + σ′·w/2 has (w√σ)′ = r/√σ, so |w√σ − 1| ≤ B·Σ |rₖ|/(k + 1), |w − 1/√σ| ≤ B²·(same).
//    Its coefficients are rₙ₋₁ = Σ (n − i/2)·σᵢ·wₙ₋ᵢ. For n < length, wₙ makes it 0, but for the
//    rounding of wₙ, times n, and that of the σᵢ, times (n − i/2)·|wₙ₋ᵢ| ≤ n·|wₙ₋ᵢ|. For n ≥ length
//    |rₙ₋₁|/n ≤ Σ |σᵢ|·|wₙ₋ᵢ|, with wₙ₋ᵢ = 0 for n − i ≥ length.
// 2. G − y = (ν·(1/√σ − w) + (ν·w − δ·y))/δ, so
//      |G − y| ≤ C·(B²·Σ |rₖ|/(k + 1) + ‖ν·w − δ·y‖),
//    and ‖ν·w − δ·y‖ has the same two parts.
// 3. The coefficients of ∫y are rounded once more, at both ends.
// All these are counted in units of 2^−Q.

namespace phrame {
namespace {

/// Upwards, for sums and products of up to 10⁶ doubles ≥ 0.
constexpr double round_up = 1 + 1e-9;

/// pₖ/divisor with so many bits behind the point, rounded down.
class FixedCoefficients {
 public:
  FixedCoefficients(const IntegerPolynomial& p, const Integer& divisor, long most_bits)
      : full_(static_cast<std::size_t>(fmpz_poly_length(p.get()))),
        now_(full_.size()),
        full_bits_(most_bits) {
    for (std::size_t k = 0; k < full_.size(); ++k) {
      fmpz* c = full_[k].raw();
      fmpz_mul_2exp(c, p.get()->coeffs + k, static_cast<ulong>(full_bits_));
      fmpz_fdiv_q(c, c, divisor.raw());
    }
  }
  void round_to(long bits) {
    for (std::size_t k = 0; k < full_.size(); ++k)
      fmpz_fdiv_q_2exp(now_[k].raw(), full_[k].raw(), static_cast<ulong>(full_bits_ - bits));
  }
  std::size_t size() const { return full_.size(); }
  const fmpz* operator[](std::size_t k) const { return now_[k].raw(); }

 private:
  std::vector<Integer> full_;
  std::vector<Integer> now_;
  long full_bits_;
};

/// How many bits behind the point are used now, of so many.
struct BitsInUse {
  long full;
  long now = 0;

  /// At least `needed`, if there are; true where they are others now.
  bool choose(long needed) {
    if (now != 0 && needed <= now && (needed > now - 48 || now <= 32)) return false;
    const long before = now;
    now = std::min(full, std::max(needed, 16L) + 16);
    return now != before;
  }
};

/// The coefficients of a series, in units of 2^−Q.
struct FixedSeries {
  std::vector<Integer> c{};
  std::size_t window;    ///< so many of the last ones are looked at
  long most = 0;         ///< none of these has more bits
  double left_over = 0;  ///< by the steps, in ‖…‖

  explicit FixedSeries(std::size_t last) : window(last) {}
  void push(Integer x) {
    c.push_back(std::move(x));
    most = std::max(most, bit_length(c.back()));
    if (c.size() % 8 != 0) return;
    most = 0;
    for (std::size_t k = c.size() - std::min(window, c.size()); k < c.size(); ++k)
      most = std::max(most, bit_length(c[k]));
  }
  /// A step that rounded down, and that took `count` coefficients with an error of 2^−bits each
  /// times numbers of so many bits.
  void count_errors(std::size_t count, long bits_of_numbers, long bits) {
    const long e = std::clamp(bits_of_numbers - bits, -1000L, 1000L);
    left_over += 1 + std::ldexp(static_cast<double>(count), static_cast<int>(e));
  }
};

long bits_of_count(std::size_t n) {
  return static_cast<long>(FLINT_BIT_COUNT(static_cast<ulong>(n)));
}

/// w by n·wₙ = −Σ (n − i/2)·σᵢ·wₙ₋ᵢ.
class RootRecurrence {
 public:
  RootRecurrence(const UnitQuotient& f, long Q, long most_bits)
      : sigma_(f.radicand, Integer(f.radicand.get()->coeffs), most_bits),
        bits_{most_bits},
        weighted_(sigma_.size()),
        twice_(sigma_.size()),
        w_(std::max(sigma_.size(), static_cast<std::size_t>(fmpz_poly_length(f.numerator.get())))) {
    w_.push(Integer(1) << static_cast<unsigned long>(Q));
  }

  const FixedSeries& w() const { return w_; }

  void step() {
    const std::size_t n = w_.c.size();
    const std::size_t degree = sigma_.size() - 1;
    weigh(n);
    fmpz* sum = sum_.raw();
    fmpz_zero(sum);
    for (std::size_t i = 1; i <= std::min(n, degree); ++i)
      fmpz_addmul(sum, weighted_[i].raw(), w_.c[n - i].raw());
    fmpz_fdiv_q_2exp(sum, sum, static_cast<ulong>(bits_.now + 1));
    fmpz_fdiv_q_ui(sum, sum, n);
    w_.count_errors(degree, w_.most, bits_.now);
    w_.push(-sum_);
  }

 private:
  /// (2n − i)·σᵢ from the ones for n − 1.
  void weigh(std::size_t n) {
    const std::size_t degree = sigma_.size() - 1;
    const bool is_new = bits_.choose(w_.most + bits_of_count(degree));
    if (is_new) sigma_.round_to(bits_.now);
    for (std::size_t i = 1; i <= degree; ++i) {
      if (is_new) {
        fmpz_mul_2exp(twice_[i].raw(), sigma_[i], 1);
        fmpz_mul_si(weighted_[i].raw(), sigma_[i],
                    static_cast<slong>(2 * n) - static_cast<slong>(i));
      } else {
        fmpz_add(weighted_[i].raw(), weighted_[i].raw(), twice_[i].raw());
      }
    }
  }

  FixedCoefficients sigma_;
  BitsInUse bits_;
  std::vector<Integer> weighted_;
  std::vector<Integer> twice_;
  FixedSeries w_;
  Integer sum_;
};

/// y by yₙ = Σ νⱼ·wₙ₋ⱼ − Σ δᵢ·yₙ₋ᵢ, i ≥ 1.
class QuotientRecurrence {
 public:
  QuotientRecurrence(const UnitQuotient& f, long most_bits)
      : nu_(f.numerator, Integer(1) << static_cast<unsigned long>(unit_exponent(f.numerator)),
            most_bits),
        delta_(f.denominator, Integer(f.denominator.get()->coeffs), most_bits),
        bits_{most_bits},
        y_(delta_.size()) {}

  const FixedSeries& y() const { return y_; }

  /// w has one coefficient more than y.
  void step(const FixedSeries& w) {
    const std::size_t n = y_.c.size();
    const std::size_t count = nu_.size() + delta_.size() - 1;
    const long most = std::max(w.most, y_.most);
    if (bits_.choose(most + bits_of_count(count))) {
      nu_.round_to(bits_.now);
      delta_.round_to(bits_.now);
    }
    fmpz* sum = sum_.raw();
    fmpz_zero(sum);
    for (std::size_t j = 0; j < nu_.size() && j <= n; ++j)
      fmpz_addmul(sum, nu_[j], w.c[n - j].raw());
    for (std::size_t i = 1; i < delta_.size() && i <= n; ++i)
      fmpz_submul(sum, delta_[i], y_.c[n - i].raw());
    fmpz_fdiv_q_2exp(sum, sum, static_cast<ulong>(bits_.now));
    y_.count_errors(count, most, bits_.now);
    y_.push(sum_);
  }

 private:
  FixedCoefficients nu_;
  FixedCoefficients delta_;
  BitsInUse bits_;
  FixedSeries y_;
  Integer sum_;
};

/// Σ_{i ≥ k} |pᵢ| for each k.
std::vector<double> sums_from(const std::vector<double>& p) {
  std::vector<double> sums(p.size(), 0.0);
  double sum = 0;
  for (std::size_t k = p.size(); k-- > 0;) sums[k] = sum += std::abs(p[k]);
  return sums;
}

/// Σ |pᵢ|·|cₖ| over all i + k ≥ the number of the cₖ: of those beyond it.
double left_out(const std::vector<double>& sums_of_p, const std::vector<Integer>& c) {
  double total = 0;
  for (std::size_t k = 1; k < sums_of_p.size() && k <= c.size(); ++k)
    total += sums_of_p[k] * std::abs(fmpz_get_d(c[c.size() - k].raw()));
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
  double of_root(const FixedSeries& w) const { return left_out(sigma, w.c); }
  double of_quotient(const FixedSeries& w, const FixedSeries& y) const {
    return left_out(nu, w.c) + left_out(delta, y.c);
  }
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
UnitSeries integrated(const std::vector<Integer>& y, long Q) {
  std::vector<RealBall> coefficients(y.size() + 1);
  Integer even;
  Integer odd;
  Integer size;
  Integer c;
  for (std::size_t n = 0; n < y.size(); ++n) {
    fmpz_fdiv_q_ui(c.raw(), y[n].raw(), n + 1);
    (n % 2 == 0 ? odd : even) += c;
    if (y[n].sign() < 0)
      size -= y[n];
    else
      size += y[n];
    coefficients[n + 1] = in_units(c, Q);
  }
  UnitSeries result;
  result.integral = BallPolynomial(coefficients);
  result.start = in_units(Integer(even - odd), Q);
  result.whole = in_units(Integer(odd << 1U), Q);
  result.size = in_units(size, Q);  // ‖y‖
  return result;
}

}  // namespace

std::optional<UnitSeries> unit_series(const UnitQuotient& f, const UnitBounds& bounds, long bits) {
  const double of_root = bounds.root * bounds.root * round_up;
  const double of_all = 2 * bounds.quotient * round_up;
  const std::size_t count = static_cast<std::size_t>(fmpz_poly_length(f.numerator.get()) +
                                                     fmpz_poly_length(f.denominator.get()) +
                                                     fmpz_poly_length(f.radicand.get()));
  // About so many terms, and so many units for their rounding.
  const double terms =
      (static_cast<double>(bits) + std::log2(of_root * of_all) + 8) / bounds.bits_per_term +
      static_cast<double>(count);
  const EndOfSeries end(f);
  const double roundings =
      of_all * std::max((of_root + 1) * 2 * terms, end.of_rounding(bounds, of_root)) + 2 * terms;
  const long Q = bits + 1 + static_cast<long>(std::ceil(std::log2(roundings)));
  const double enough = 0.5 * std::ldexp(1.0, static_cast<int>(std::min(Q - bits, 1000L)));

  const long most_bits =
      Q + 2 + bits_of_count(count) + static_cast<long>(std::log2(bounds.root * bounds.quotient));
  RootRecurrence root(f, Q, most_bits);
  QuotientRecurrence quotient(f, most_bits);
  quotient.step(root.w());
  double left_out = INFINITY;
  while (!(left_out <= enough)) {
    const auto length = static_cast<double>(root.w().c.size());
    if (length > 4 * terms + 1000) return std::nullopt;
    for (int k = 0; k < 4; ++k) {
      root.step();
      quotient.step(root.w());
    }
    if (std::max(root.w().most, quotient.y().most) < 900)
      left_out =
          of_all * (of_root * end.of_root(root.w()) + end.of_quotient(root.w(), quotient.y()));
  }
  UnitSeries result = integrated(quotient.y().c, Q);
  const double rounded = of_all * (of_root * root.w().left_over + quotient.y().left_over) +
                         2 * static_cast<double>(quotient.y().c.size());
  result.error = in_units(left_out + rounded, Q);
  result.size = add(result.size, result.error, 64);
  return result;
}

}  // namespace phrame
