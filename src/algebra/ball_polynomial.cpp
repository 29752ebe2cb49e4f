#include "phrame/algebra/ball_polynomial.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "phrame/algebra/result_of.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

/// A part [start, start + width] of [0, 1], and the Bernstein coefficients there.
struct Part {
  Rational start;
  Rational width;
  std::vector<RealBall> coefficients;
};

/// The common sign of all of them, or 0.
int common_sign(const std::vector<RealBall>& coefficients) {
  const int first = sign(coefficients.front());
  const bool agree = std::all_of(coefficients.begin(), coefficients.end(),
                                 [first](const RealBall& c) { return sign(c) == first; });
  return agree ? first : 0;
}

/// Does the polynomial increase, or decrease, on the whole part?
bool is_monotone(const std::vector<RealBall>& coefficients, long bits) {
  std::vector<RealBall> differences;
  for (std::size_t k = 0; k + 1 < coefficients.size(); ++k)
    differences.push_back(subtract(coefficients[k + 1], coefficients[k], bits));
  return !differences.empty() && common_sign(differences) != 0;
}

/// The zero in [a, a + width], at whose ends p has different signs and on which it is monotone,
/// halved down to 2^−bits as far as the signs of p are certain.
RealBall narrowed(const BallPolynomial& p, Rational a, Rational width, int at_a, long bits,
                  long precision) {
  const Rational goal = power_of_two(-bits);
  const auto sign_after = [&](const Rational& step) {
    return sign(evaluate(p, RealBall(Rational(a + step), precision), precision));
  };
  while (width > goal) {
    Rational step = width / 2;
    int there = sign_after(step);
    if (there == 0) {  // perhaps it is the zero
      step = width * Rational(7, 16);
      there = sign_after(step);
    }
    if (there == 0) break;
    if (there == at_a) {
      a += step;
      width -= step;
    } else {
      width = step;
    }
  }
  return hull(a, Rational(a + width), precision);
}

/// Bernstein coefficients up to one positive factor, as whole numbers that are off by `error` at
/// most: quick to halve, and enough to decide most parts.
struct FixedPart {
  Rational start;
  Rational width;
  std::vector<std::int64_t> coefficients;
  std::int64_t error;
};

/// No value where the coefficients are not known to a fraction of the greatest one.
std::optional<FixedPart> fixed_part(const std::vector<RealBall>& coefficients) {
  constexpr long most_bits = 60;
  flint::Mag greatest;
  flint::Mag size;
  for (const RealBall& c : coefficients) {
    if (!c.is_finite()) return std::nullopt;
    arb_get_mag(size.get(), c.raw());
    mag_max(greatest.get(), greatest.get(), size.get());
  }
  if (mag_is_special(greatest.get()) != 0) return std::nullopt;
  if (COEFF_IS_MPZ(MAG_EXP(greatest.get()))) return std::nullopt;
  const slong shift = most_bits - MAG_EXP(greatest.get());  // greatest < 2^exponent
  FixedPart part{0, 1, {}, 0};
  flint::Fmpz whole;
  for (const RealBall& c : coefficients) {
    RealBall scaled;
    arb_mul_2exp_si(scaled.raw(), c.raw(), shift);
    const double radius = mag_get_d(arb_radref(scaled.raw()));
    if (!(radius < 0x1p40)) return std::nullopt;
    part.error = std::max(part.error, static_cast<std::int64_t>(radius) + 2);
    arf_get_fmpz(whole.get(), arb_midref(scaled.raw()), ARF_RND_NEAR);
    part.coefficients.push_back(fmpz_get_si(whole.get()));
  }
  return part;
}

/// The common sign of all of them, or 0.
int common_sign(const FixedPart& part) {
  const auto [least, greatest] =
      std::minmax_element(part.coefficients.begin(), part.coefficients.end());
  return *least > part.error ? 1 : *greatest < -part.error ? -1 : 0;
}

int sign(std::int64_t c, std::int64_t error) { return c > error ? 1 : c < -error ? -1 : 0; }

bool is_monotone(const FixedPart& part) {
  const auto& c = part.coefficients;
  if (c.size() < 2) return false;
  const int first = sign(c[1] - c[0], 2 * part.error);
  for (std::size_t k = 0; first != 0 && k + 1 < c.size(); ++k)
    if (sign(c[k + 1] - c[k], 2 * part.error) != first) return false;
  return first != 0;
}

/// By de Casteljau's algorithm; each mean is rounded down, which adds at most one to the error.
std::pair<FixedPart, FixedPart> halves(const FixedPart& part) {
  const Rational width = part.width / 2;
  const std::size_t n = part.coefficients.size();
  const std::int64_t error = part.error + static_cast<std::int64_t>(n);
  FixedPart left{part.start, width, {}, error};
  FixedPart right{part.start + width, width, std::vector<std::int64_t>(n), error};
  std::vector<std::int64_t> row = part.coefficients;
  for (std::size_t length = n; length > 0; --length) {
    left.coefficients.push_back(row.front());
    right.coefficients[length - 1] = row[length - 1];
    for (std::size_t k = 0; k + 1 < length; ++k) row[k] = (row[k] + row[k + 1]) >> 1;
  }
  return {std::move(left), std::move(right)};
}

}  // namespace

BallPolynomial::BallPolynomial(const Polynomial& p, long bits) {
  arb_poly_set_fmpq_poly(raw(), p.raw(), bits);
}

BallPolynomial::BallPolynomial(const std::vector<RealBall>& ascending) {
  for (std::size_t k = 0; k < ascending.size(); ++k)
    arb_poly_set_coeff_arb(raw(), static_cast<slong>(k), ascending[k].raw());
}

RealBall BallPolynomial::coefficient(long k) const {
  return result_of<RealBall>(arb_poly_get_coeff_arb, raw(), k);
}

BallPolynomial with_constant(BallPolynomial p, const RealBall& c) {
  arb_poly_set_coeff_arb(p.raw(), 0, c.raw());
  return p;
}

BallPolynomial operator-(BallPolynomial p) {
  arb_poly_neg(p.raw(), p.raw());
  return p;
}

BallPolynomial add(const BallPolynomial& p, const BallPolynomial& q, long bits) {
  return result_of<BallPolynomial>(arb_poly_add, p.raw(), q.raw(), bits);
}

BallPolynomial subtract(const BallPolynomial& p, const BallPolynomial& q, long bits) {
  return result_of<BallPolynomial>(arb_poly_sub, p.raw(), q.raw(), bits);
}

BallPolynomial multiply(const BallPolynomial& p, const BallPolynomial& q, long bits) {
  return result_of<BallPolynomial>(arb_poly_mul, p.raw(), q.raw(), bits);
}

BallPolynomial multiply(const RealBall& c, const BallPolynomial& p, long bits) {
  return result_of<BallPolynomial>(arb_poly_scalar_mul, p.raw(), c.raw(), bits);
}

BallPolynomial differentiate(const BallPolynomial& p, long bits) {
  return result_of<BallPolynomial>(arb_poly_derivative, p.raw(), bits);
}

BallPolynomial antiderivative(BallPolynomial p, long bits) {
  arb_poly_integral(p.raw(), p.raw(), bits);
  return p;
}

BallPolynomial shifted(BallPolynomial p, const RealBall& by, long bits) {
  arb_poly_taylor_shift(p.raw(), p.raw(), by.raw(), bits);
  return p;
}

BallPolynomial stretched(BallPolynomial p, long e) {
  for (long k = 0; k <= p.degree_bound(); ++k) {
    arb_struct* c = arb_poly_get_coeff_ptr(p.raw(), k);
    arb_mul_2exp_si(c, c, k * e);
  }
  return p;
}

RealBall evaluate(const BallPolynomial& p, const RealBall& x, long bits) {
  return result_of<RealBall>(arb_poly_evaluate, p.raw(), x.raw(), bits);
}

std::vector<RealBall> to_bernstein(const BallPolynomial& p, long n, long bits) {
  // b_r = Σ_k C(r, k) p_k/C(n, k): sums of p_k/C(n, k), n times over.
  std::vector<RealBall> b;
  Integer binomial = 1;
  for (long k = 0; k <= n; ++k) {
    b.push_back(divide(p.coefficient(k), RealBall(Rational(binomial), bits), bits));
    binomial = binomial * (n - k) / (k + 1);
  }
  for (std::size_t i = 1; i < b.size(); ++i)
    for (std::size_t k = b.size() - 1; k >= i; --k) b[k] = add(b[k], b[k - 1], bits);
  return b;
}

std::pair<std::vector<RealBall>, std::vector<RealBall>> split(
    const std::vector<RealBall>& coefficients, const Rational& share, long bits) {
  const RealBall right_weight(share, bits);
  std::vector<RealBall> row = coefficients;
  std::vector<RealBall> left;
  std::vector<RealBall> right(row.size());
  for (std::size_t length = row.size(); length > 0; --length) {
    left.push_back(row.front());
    right[length - 1] = row[length - 1];
    for (std::size_t k = 0; k + 1 < length; ++k) {
      const RealBall step = subtract(row[k + 1], row[k], bits);
      arb_addmul(row[k].raw(), right_weight.raw(), step.raw(), bits);
    }
  }
  return {std::move(left), std::move(right)};
}

BallPolynomial from_bernstein(std::vector<RealBall> c, long bits) {
  const std::size_t n = c.size() - 1;
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t k = n; k >= i; --k) c[k] = subtract(c[k], c[k - 1], bits);
  Integer binomial = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    c[k] = multiply(c[k], RealBall(Rational(binomial), bits), bits);
    binomial = binomial * (n - k) / (k + 1);
  }
  return BallPolynomial(c);
}

namespace {

/// Sign changes of one polynomial, found from left to right.
class SignSearch {
 public:
  SignSearch(const BallPolynomial& p, long bits)
      : p_(p),
        bits_(bits),
        precision_(bits + 64 + 2 * p.degree_bound()),
        whole_(to_bernstein(p, p.degree_bound(), precision_)) {}

  SignChanges run() {
    if (auto part = fixed_part(whole_))
      look_quickly(std::move(*part));
    else
      look_at({0, 1, whole_});
    return std::move(found_);
  }

 private:
  /// What whole numbers do not decide is left to look_at().
  void look_quickly(FixedPart whole) {
    const Rational narrow = power_of_two(-std::min(bits_, 40L));
    std::vector<FixedPart> parts{std::move(whole)};
    for (long looked_at = 0; !parts.empty(); ++looked_at) {
      const FixedPart part = std::move(parts.back());
      parts.pop_back();
      if (common_sign(part) != 0) continue;
      const int before = sign(part.coefficients.front(), part.error);
      const int after = sign(part.coefficients.back(), part.error);
      if (before * after != 0 && is_monotone(part)) {
        if (before != after) add_zero(part.start, part.width, before);
        continue;
      }
      auto [left, right] = halves(part);
      const bool is_split = sign(right.coefficients.front(), right.error) != 0;
      if (!is_split || part.width < narrow || looked_at > 20 * bits_) {
        look_at(part_of_whole(part.start, part.width));
        continue;
      }
      parts.push_back(std::move(right));
      parts.push_back(std::move(left));
    }
  }

  Part part_of_whole(const Rational& start, const Rational& width) const {
    Part part{start, width, whole_};
    const Rational end = start + width;
    if (end != 1) part.coefficients = split(part.coefficients, end, precision_).first;
    if (start != 0) part.coefficients = split(part.coefficients, start / end, precision_).second;
    return part;
  }

  void look_at(Part whole) {
    const Rational narrow = power_of_two(-bits_);
    std::vector<Part> parts{std::move(whole)};
    for (; !parts.empty(); ++looked_at_) {
      const Part part = std::move(parts.back());
      parts.pop_back();
      if (common_sign(part.coefficients) != 0) continue;
      const int before = phrame::sign(part.coefficients.front());
      const int after = phrame::sign(part.coefficients.back());
      if (before * after != 0 && is_monotone(part.coefficients, precision_)) {
        if (before != after) add_zero(part.start, part.width, before);
        continue;
      }
      // A polynomial that is nearly 0, or known badly, has undecided parts everywhere.
      if (part.width < narrow || looked_at_ > 20 * bits_) {
        found_.undecided.push_back(hull(part.start, Rational(part.start + part.width), precision_));
        continue;
      }
      Rational share(1, 2);
      auto halves = split(part.coefficients, share, precision_);
      if (phrame::sign(halves.second.front()) == 0) {  // a zero there would belong to neither half
        share = Rational(7, 16);
        halves = split(part.coefficients, share, precision_);
      }
      const Rational width = share * part.width;
      parts.push_back({part.start + width, part.width - width, std::move(halves.second)});
      parts.push_back({part.start, width, std::move(halves.first)});
    }
  }

  void add_zero(const Rational& start, const Rational& width, int sign_at_start) {
    found_.at.push_back(narrowed(p_, start, width, sign_at_start, bits_, precision_));
  }

  const BallPolynomial& p_;
  long bits_;
  long precision_;
  std::vector<RealBall> whole_;  ///< the Bernstein coefficients on [0, 1]
  long looked_at_ = 0;
  SignChanges found_;
};

}  // namespace

SignChanges sign_changes(const BallPolynomial& p, long bits) {
  if (p.degree_bound() < 0) return {};
  return SignSearch(p, bits).run();
}

}  // namespace phrame
