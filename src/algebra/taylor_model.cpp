// Each function of a polynomial P is a polynomial whose coefficients follow from a recurrence with
// rounded integers. How far off it is follows from what it leaves of the equation that the function
// obeys, as an exact polynomial, not from the recurrence.
#include "phrame/algebra/taylor_model.hpp"

#include <algorithm>

#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/polynomial.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

using Terms = std::vector<Integer>;

Terms without_zeros(Terms p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

/// No less than |p(z)|.
Integer sum_of_sizes(const Terms& p, std::size_t from = 0) {
  Integer sum = 0;
  for (std::size_t k = from; k < p.size(); ++k) sum += abs(p[k]);
  return sum;
}

IntegerPolynomial packed(const Terms& p) {
  IntegerPolynomial f;
  for (std::size_t k = p.size(); k-- > 0;)
    fmpz_poly_set_coeff_fmpz(f.get(), static_cast<long>(k), p[k].raw());
  return f;
}

Terms product(const Terms& p, const Terms& q) {
  if (p.empty() || q.empty()) return {};
  IntegerPolynomial f;
  fmpz_poly_mul(f.get(), packed(p).get(), packed(q).get());
  Terms out;
  for (long k = 0; k < fmpz_poly_length(f.get()); ++k) out.emplace_back(f.get()->coeffs + k);
  return out;
}

/// p + factor·q.
Terms sum(Terms p, const Terms& q, const Integer& factor = 1) {
  p.resize(std::max(p.size(), q.size()));
  for (std::size_t k = 0; k < q.size(); ++k) p[k] += factor * q[k];
  return without_zeros(std::move(p));
}

Terms derivative(const Terms& p) {
  Terms out;
  for (std::size_t k = 1; k < p.size(); ++k) out.push_back(Integer(k) * p[k]);
  return out;
}

/// Σ p[j]·q[k − j] for j from `first` to `last`, as far as there are such.
Integer convolution(const Terms& p, const Terms& q, std::size_t k, std::size_t first,
                    std::size_t last) {
  Integer total = 0;
  for (std::size_t j = first; j <= last && j < p.size(); ++j)
    if (k - j < q.size()) fmpz_addmul(total.raw(), p[j].raw(), q[k - j].raw());
  return total;
}

Integer power_of_2(long k) { return Integer(1) << static_cast<unsigned long>(k); }
Integer shifted_down(Integer x, long k) { return std::move(x) >> static_cast<unsigned long>(k); }
Integer shifted_up(Integer x, long k) { return std::move(x) << static_cast<unsigned long>(k); }

constexpr long most_exponent = 1000;  // 2 to this is the greatest value

template <class Function>
RealBall applied(const Rational& x, const Function& f, long bits) {
  RealBall y;
  f(y.raw(), RealBall(x, bits).raw(), bits);
  return y;
}

}  // namespace

TaylorModel TaylorModels::checked(Terms terms, Integer radius) const {
  if (sum_of_sizes(terms) + radius > power_of_2(bits_ + most_exponent))
    throw Undecided("a value is greater than 2^1000");
  return {without_zeros(std::move(terms)), std::move(radius)};
}

TaylorModel TaylorModels::number(const Rational& x) const {
  const Rational scaled = x * power_of_two(bits_);
  const Integer n = floor(scaled);
  return checked({n}, Rational(n) == scaled ? 0 : 1);
}

/// ⌊f(x)·2ᴮ⌋, where that is no integer.
template <class Function>
Integer TaylorModels::floor_of(const Rational& x, const Function& f) const {
  for (long bits = bits_ + 64;; bits *= 2) {
    const RealBall y = times_power_of_two(applied(x, f, bits), bits_);
    if (!y.is_finite()) continue;
    const Integer n = floor(y.lower());
    if (n == floor(y.upper())) return n;
  }
}

TaylorModel TaylorModels::pi() const {
  const auto f = [](arb_t y, const arb_t, long bits) { arb_const_pi(y, bits); };
  return {{floor_of(0, f)}, 1};
}

TaylorModel TaylorModels::variable() const { return {{0, power_of_2(bits_)}, 0}; }

TaylorModel TaylorModels::add(const TaylorModel& a, const TaylorModel& b) const {
  return {sum(a.terms, b.terms), a.radius + b.radius};
}

TaylorModel TaylorModels::subtract(const TaylorModel& a, const TaylorModel& b) const {
  return add(a, multiply(-1, b));
}

// What is beyond the order, and what each radius makes of the other factor, goes to the radius, and
// less than 1 for the rounding of each term.
TaylorModel TaylorModels::multiply(const TaylorModel& a, const TaylorModel& b) const {
  if (a.is_zero() || b.is_zero()) return {};
  Terms all = product(a.terms, b.terms);
  const auto count = std::min(all.size(), static_cast<std::size_t>(order_));
  const Integer off = sum_of_sizes(all, count) + sum_of_sizes(a.terms) * b.radius +
                      a.radius * (sum_of_sizes(b.terms) + b.radius);
  all.resize(count);
  for (Integer& x : all) x >>= static_cast<unsigned long>(bits_);
  return checked(std::move(all), Integer(count + 1) + shifted_down(off, bits_));
}

TaylorModel TaylorModels::multiply(const Rational& x, const TaylorModel& a) const {
  Terms terms;
  for (const Integer& c : a.terms)
    terms.push_back(floor_quotient(c * Integer(numerator(x)), denominator(x)));
  Integer radius = -floor_quotient(-a.radius * Integer(numerator(abs(x))), denominator(x));
  if (denominator(x) != 1) radius += Integer(terms.size());
  return checked(std::move(terms), std::move(radius));
}

Integer TaylorModels::least(const TaylorModel& a, const char* what) const {
  const Integer m = 2 * a.constant() - sum_of_sizes(a.terms) - a.radius;
  if (m.sign() <= 0) throw Undecided(what);
  return m;
}

/// first, next(1, so far), …, as many as there may be; of a constant the first alone.
template <class Next>
Terms TaylorModels::series(bool is_constant, Integer first, const Next& next) const {
  Terms out{std::move(first)};
  for (std::size_t k = 1; !is_constant && k < static_cast<std::size_t>(order_); ++k)
    out.push_back(next(k, out));
  return out;
}

// |I − 1/f| = |If − 1|/|f|, If − 1 = (IP − 1) + I(f − P).
TaylorModel TaylorModels::inverse(const TaylorModel& a) const {
  const auto& [p, r] = a;
  if (!p.empty() && p.front().sign() < 0) return multiply(-1, inverse(multiply(-1, a)));
  const Integer m = least(a, "a divisor may be 0");
  const Integer one = power_of_2(2 * bits_);
  const Terms I = series(p.size() == 1, floor_quotient(one, p.front()),
                         [&, &p = p](std::size_t k, const Terms& so_far) {
                           return floor_quotient(-convolution(p, so_far, k, 1, k), p.front());
                         });
  const Integer off = sum_of_sizes(sum(product(I, p), {one}, -1)) + sum_of_sizes(I) * r;
  return checked(I, floor_quotient(off, m) + 1);
}

// |R − √f| = |R² − f|/(R + √f). R² > 0 all along and R(0) > 0, so R > 0.
TaylorModel TaylorModels::sqrt(const TaylorModel& a) const {
  const auto& [p, r] = a;
  const Integer m = least(a, "the square root of a number that may be negative or 0");
  const Integer first = phrame::sqrt(shifted_up(p.front(), bits_));
  const auto next = [&, &p = p](std::size_t k, const Terms& so_far) {
    const Integer at = k < p.size() ? shifted_up(p[k], bits_) : Integer(0);
    return floor_quotient(at - convolution(so_far, so_far, k, 1, k - 1), 2 * first);
  };
  const Terms R = series(p.size() == 1, first, next);
  const Integer off =
      sum_of_sizes(sum(product(R, R), p, -power_of_2(bits_))) + shifted_up(r, bits_);
  if (off >= shifted_up(m, bits_)) throw Undecided("a square root is too inaccurate");
  return checked(R, floor_quotient(off, phrame::sqrt(shifted_up(m, bits_))) + 1);
}

// With P = c + Q and (E·e^−Q)′ = (E′ − Q′E)·e^−Q the E of the series is E(0)·e^Q but for
// ‖E′ − Q′E‖·g², g ≥ e^‖Q‖.
TaylorModel TaylorModels::exp(const TaylorModel& a) const {
  const auto& [p, r] = a;
  const Rational c = p.empty() ? Rational(0) : Rational(p.front()) * power_of_two(-bits_);
  const Terms slope = derivative(p);
  constexpr long greatest_constant = 700;
  constexpr long greatest_size = 64;
  const Integer size = -shifted_down(-sum_of_sizes(p, 1), bits_);
  if (abs(c) > greatest_constant || size > greatest_size || r > power_of_2(bits_))
    throw Undecided("an exponent is too great, or not known");
  const Integer first =
      c == 0 ? power_of_2(bits_)
             : floor_of(c, [](arb_t y, const arb_t x, long bits) { arb_exp(y, x, bits); });
  const Terms E = series(slope.empty(), first, [&](std::size_t k, const Terms& so_far) {
    return floor_quotient(convolution(slope, so_far, k - 1, 0, k - 1),
                          shifted_up(Integer(k), bits_));
  });
  const Integer g = pow(3, static_cast<unsigned long>(static_cast<long>(size)));
  const Integer rest = sum_of_sizes(sum(product(slope, E), derivative(E), -power_of_2(bits_)));
  const Integer off = shifted_down(rest * g * g, bits_) + 1 + g;
  return checked(E, off + shifted_down(2 * r * (sum_of_sizes(E) + off), bits_) + 1);
}

// Of P = c + Q: E = C + iS has (E·e^−iQ)′ = (E′ − iQ′E)·e^−iQ, and |e^−iQ| = 1.
CosSinModels TaylorModels::cos_sin(const TaylorModel& a) const {
  const auto& [p, r] = a;
  const Rational c = p.empty() ? Rational(0) : Rational(p.front()) * power_of_two(-bits_);
  const Terms slope = derivative(p);
  constexpr long greatest_angle = 64;  // 2 to this
  if (abs(c) > Rational(power_of_2(greatest_angle))) throw Undecided("an angle is too great");
  Terms C{power_of_2(bits_)};
  Terms S{0};
  if (c != 0) {
    C = {floor_of(c, [](arb_t y, const arb_t x, long bits) { arb_cos(y, x, bits); })};
    S = {floor_of(c, [](arb_t y, const arb_t x, long bits) { arb_sin(y, x, bits); })};
  }
  for (std::size_t k = 1; !slope.empty() && k < static_cast<std::size_t>(order_); ++k) {
    const Integer by = shifted_up(Integer(k), bits_);
    Integer next = floor_quotient(-convolution(slope, S, k - 1, 0, k - 1), by);
    S.push_back(floor_quotient(convolution(slope, C, k - 1, 0, k - 1), by));
    C.push_back(std::move(next));
  }
  const Integer one = power_of_2(bits_);
  const Integer off = sum_of_sizes(sum(product(slope, S), derivative(C), one)) +
                      sum_of_sizes(sum(product(slope, C), derivative(S), -one));
  const Integer radius = shifted_down(off, bits_) + 3 + r;
  return {checked(std::move(C), radius), checked(std::move(S), radius)};
}

/// L with L′w = P′ but for the rest, w on the grid of 2^−shift.
TaylorModels::BySlope TaylorModels::by_slope(const Terms& p, const Terms& w, long shift,
                                             Integer first) const {
  const auto next = [&](std::size_t k, const Terms& so_far) {
    Integer at = k < p.size() ? Integer(k) * shifted_up(p[k], shift) : Integer(0);
    for (std::size_t j = 1; j < k; ++j)
      if (k - j < w.size()) at -= Integer(j) * so_far[j] * w[k - j];
    return floor_quotient(at, Integer(k) * w.front());
  };
  Terms L = series(p.size() <= 1, std::move(first), next);
  Integer rest = sum_of_sizes(sum(product(derivative(L), w), derivative(p), -power_of_2(shift)));
  return {std::move(L), std::move(rest)};
}

// |L − log P| ≤ ‖L′P − P′‖/m and the rounding of L(0), and |log f − log P| ≤ r/m.
TaylorModel TaylorModels::log(const TaylorModel& a) const {
  const auto& [p, r] = a;
  const Integer m = least(a, "the logarithm of a number that may be negative or 0");
  const Rational c = Rational(p.front()) * power_of_two(-bits_);
  Integer first = 0;
  if (c != 1) first = floor_of(c, [](arb_t y, const arb_t x, long bits) { arb_log(y, x, bits); });
  auto [L, rest] = by_slope(p, p, bits_, std::move(first));
  return checked(std::move(L), floor_quotient(rest + shifted_up(r, bits_), m) + 2);
}

// W = 1 + P² ≥ 1.
TaylorModel TaylorModels::atan(const TaylorModel& a) const {
  const auto& [p, r] = a;
  const Rational c = p.empty() ? Rational(0) : Rational(p.front()) * power_of_two(-bits_);
  Integer first = 0;
  if (c != 0) first = floor_of(c, [](arb_t y, const arb_t x, long bits) { arb_atan(y, x, bits); });
  const Terms W = sum(product(p, p), {power_of_2(2 * bits_)});
  auto [A, rest] = by_slope(p, W, 2 * bits_, std::move(first));
  return checked(std::move(A), shifted_down(rest, 2 * bits_) + 2 + r);
}

}  // namespace phrame
