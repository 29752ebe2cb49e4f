// The sum over the poles is one over the residues: with w(α) the sum of the ω(z) over the poles
// with the residue α it is A = Σ i·w(α)·α over the roots of the irreducible polynomial q of the
// residues, real since w(ᾱ) = −w(α). A conjugate of A is ±i·Σ w(α)·σ(α) with a permutation σ of the
// roots, so that there are no more than ways to give the weights w to the roots; the minus sign
// gives nothing new, as the weights come in pairs w, −w.
//
// When is a power of s = t − z rational? All conjugates of s then have one size, and their ratios
// are roots of unity; so is u = sⁿ/Norm(s) ∈ ℚ(s), n the degree. Conversely uᵒ = 1 makes
// s^(n·o) = Norm(s)ᵒ rational. The traces of powers of a root of unity are integers ≤ n, which for
// most s denies it at once. All conjugates of s lie in ℚ(s, ζ), ζ a root of unity of the order
// N = n·o, in a field of at most n·φ(N) dimensions, and n if s is a rational number times a root of
// unity.
#include "phrame/integrate/turned_logs.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/bounded_algebraic.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/algebra/roots.hpp"

namespace phrame::inline v0 {
namespace {

/// Of a denominator; sums over more poles are not recognised.
constexpr long largest_degree = 40;
/// Of the multiple of π that is looked for.
constexpr long largest_multiple = 8;
constexpr long largest_cyclotomic_multiple = 16;

/// N with (t − z)ᴺ ∈ ℚ for every root z of the irreducible d.
std::optional<long> rational_power(const Polynomial& d, const Rational& t) {
  const Polynomial p = compose(d, Polynomial{t, -1});
  const long n = p.degree();
  const QuotientRing ring(p);
  Polynomial power{1};
  for (long k = 0; k < n; ++k) power = ring.multiply(power, Polynomial{0, 1});
  const Rational norm = (n % 2 == 0 ? 1 : -1) * p.coefficient(0) / p.leading_coefficient();
  const Polynomial u = Rational(1 / norm) * power;
  power = u;
  // φ(o) ≤ n allows no o > 6n for n ≤ largest_degree.
  for (long o = 1; o <= 6 * n; ++o) {
    if (power == Polynomial{1}) return n * o;
    const Rational trace = ring.trace(power);
    if (denominator(trace) != 1 || abs(trace) > n) return std::nullopt;
    power = ring.multiply(power, u);
  }
  return std::nullopt;
}

/// The angles of t − z over π at one end, for the poles of d above the real axis.
struct View {
  Rational at_all = 0;           ///< where they are equal
  std::optional<Rational> from;  ///< else from this t
  long unit = 1;                 ///< multiples of 1/unit

  Rational angle(const ComplexBall& z, long bits, bool& is_known) const {
    if (!from) return at_all;
    const ComplexBall s = subtract(ComplexBall(RealBall(*from, bits), RealBall()), z, bits);
    const RealBall over_pi = divide(argument(s, bits), pi(bits), bits);
    const auto whole = unique_integer(multiply(over_pi, RealBall(unit, bits), bits));
    is_known = is_known && whole;
    return Rational(whole.value_or(0)) / unit;
  }
};

std::optional<View> view(const Polynomial& d, const Endpoint& end, bool is_center) {
  if (const auto* infinity = std::get_if<Infinity>(&end))
    return View{*infinity == Infinity::negative ? -1 : 0, std::nullopt, 1};
  const auto* t = std::get_if<Rational>(&end);
  if (t == nullptr) return std::nullopt;
  if (is_center) return View{Rational(-1, 2), std::nullopt, 1};
  const auto unit = rational_power(d, *t);
  return unit ? std::optional(View{0, *t, *unit}) : std::nullopt;
}

/// D with algebraic integers D·α for all roots α of q: the leading coefficient c_n, or less. The
/// monic polynomial of D·α has the coefficients D^(n−k)·c_k/c_n.
Integer denominator_of_roots(const Polynomial& q) {
  const Rational lead = q.leading_coefficient();
  const auto suffices = [&](const Integer& d) {
    Rational power = 1;
    for (long k = q.degree() - 1; k >= 0; --k) {
      power *= Rational(d);
      if (denominator(Rational(power * q.coefficient(k) / lead)) != 1) return false;
    }
    return true;
  };
  Integer d = numerator(lead);
  for (long m = 2; m <= 1000; ++m)
    while (d % m == 0 && suffices(d / m)) d = d / m;
  return d;
}

/// A sum over the roots of an irreducible polynomial: Σ i·w(α)·α, with opposite weights at
/// conjugates, which therefore is −2·Σ w(α)·Im α over the roots above the real axis.
class WeightedRoots {
 public:
  WeightedRoots(Polynomial q, std::vector<Rational> weights)
      : q_(std::move(q)), weights_(std::move(weights)) {}

  RealBall enclose(long bits) {
    prepare(bits + 16);
    RealBall sum;
    for (std::size_t k = 0; k < weights_.size(); ++k)
      sum = add(sum,
                multiply(RealBall(-2 * weights_[k], precision_), roots_.upper[k].im(), precision_),
                precision_);
    return sum;
  }

  /// Of the sum and its conjugates: the largest weight times the sum of all |α|.
  Rational size() {
    prepare(64);
    Rational sum = 0;
    for (const RealBall& alpha : roots_.real) sum += absolute(alpha).upper();
    for (const ComplexBall& alpha : roots_.upper)
      sum += 2 * (absolute(alpha.re()).upper() + absolute(alpha.im()).upper());
    Rational largest = 0;
    for (const Rational& w : weights_) largest = std::max(largest, Rational(abs(w)));
    return largest * sum;
  }

  /// A multiple of the sum by this is an algebraic integer.
  Integer to_integer() const {
    Integer common = 1;
    for (const Rational& w : weights_) common = lcm(common, denominator(w));
    return common * denominator_of_roots(q_);
  }

  /// In how many ways the weights can be given to the roots: a multinomial coefficient.
  long arrangements() const {
    std::vector<Rational> all(static_cast<std::size_t>(q_.degree()) - 2 * weights_.size());
    for (const Rational& w : weights_) {
      all.push_back(w);
      all.push_back(-w);
    }
    std::sort(all.begin(), all.end());
    Integer count = 1;
    long equal = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      equal = k > 0 && all[k] == all[k - 1] ? equal + 1 : 1;
      count = count * static_cast<long>(k + 1) / equal;
    }
    return count < many_conjugates ? static_cast<long>(count) : many_conjugates;
  }

 private:
  void prepare(long bits) {
    if (bits <= precision_) return;
    if (precision_ == 0)
      roots_ = isolate_roots(q_, bits);
    else
      refine(q_, roots_, bits);
    precision_ = bits;
  }

  Polynomial q_;
  std::vector<Rational> weights_;  ///< of the roots above the real axis
  Roots roots_;
  long precision_ = 0;
};

/// The weight of each root of q above the real axis, where q has the residues of f as roots.
std::vector<Rational> weights(const SimpleFraction& f, const Polynomial& q, const View& from,
                              const View& to) {
  const Polynomial slope = differentiate(f.denominator);
  for (long bits = 128;; bits *= 2) {
    const Roots alphas = isolate_roots(q, bits);
    std::vector<Rational> list(alphas.upper.size());
    bool is_known = true;
    for (const ComplexBall& z : isolate_roots(f.denominator, bits).upper) {
      const ComplexBall c = divide(evaluate(f.numerator, z, bits), evaluate(slope, z, bits), bits);
      const Rational turn = to.angle(z, bits, is_known) - from.angle(z, bits, is_known);
      long matches = 0;
      for (const RealBall& alpha : alphas.real) matches += c.overlaps({alpha, {}}) ? 1 : 0;
      for (std::size_t k = 0; k < list.size(); ++k) {
        if (c.overlaps(alphas.upper[k])) {
          list[k] += turn;
          ++matches;
        }
        // The pole z̄, which turns the other way.
        if (c.overlaps(conjugate(alphas.upper[k]))) {
          list[k] -= turn;
          ++matches;
        }
      }
      is_known = is_known && matches == 1;
    }
    if (is_known) return list;
  }
}

/// A bound of the degree of a normal field that holds the roots of d and i, where one is known.
std::optional<long> cyclotomic_bound(const Polynomial& d) {
  const long n = d.degree();
  const Rational mean = -d.coefficient(n - 1) / (n * d.leading_coefficient());
  for (const Rational& center : {Rational(0), mean}) {
    const Rational norm = abs(d(center) / d.leading_coefficient());
    const auto power = norm == 0 ? std::nullopt : rational_power(d, center);
    if (!power) continue;
    // A rational number times a root of unity generates a normal field.
    const Polynomial sizes = Polynomial::monomial(1, n) - Polynomial{norm};
    if (real_root(sizes, {Rational(0), std::nullopt}).is_rational()) return 2 * n;
    return n * static_cast<long>(euler_phi(static_cast<unsigned long>(std::lcm(*power, 4L))));
  }
  return std::nullopt;
}

/// Is Σ f(2t − s) = Σ f(s)?
bool is_even_about(const Endpoint& end, const std::vector<SimpleFraction>& fractions) {
  const auto* t = std::get_if<Rational>(&end);
  if (t == nullptr) return false;
  const Polynomial reflected{2 * *t, -1};
  RationalFunction sum;
  for (const auto& [n, d] : fractions)
    sum = sum + RationalFunction(n, d) - compose(RationalFunction(n, d), reflected);
  return sum.is_zero();
}

/// A sum of algebraic numbers that is being recognised.
class Multiple {
 public:
  void add(const BoundedAlgebraic& x, long largest) {
    largest_ = std::max(largest_, largest);
    const auto known = recognized(x, largest);
    if (known && known->is_rational()) {
      rational_ += *known->rational();
      return;
    }
    single_ = rest_ ? std::nullopt : known;
    const BoundedAlgebraic part = known ? bounded(*known) : x;
    rest_ = rest_ ? *rest_ + part : part;
  }
  std::optional<RealAlgebraic> value() const {
    if (!rest_) return RealAlgebraic(rational_);
    const auto known = single_ ? single_ : recognized(*rest_, largest_);
    return known ? std::optional(affine(*known, 1, rational_)) : std::nullopt;
  }

 private:
  Rational rational_;
  std::optional<BoundedAlgebraic> rest_;  ///< the sum of the irrational ones
  std::optional<RealAlgebraic> single_;   ///< the same, where it is one and known
  long largest_ = 1;
};

}  // namespace

std::optional<TurnedLogs> turned_logs(const std::vector<SimpleFraction>& fractions,
                                      const Endpoint& a, const Endpoint& b) {
  const auto is_large = [](const SimpleFraction& f) {
    return f.denominator.degree() > largest_degree;
  };
  if (std::any_of(fractions.begin(), fractions.end(), is_large)) return std::nullopt;
  const bool a_is_center = is_even_about(a, fractions);
  const bool b_is_center = is_even_about(b, fractions);
  struct Seen {
    View from;
    View to;
  };
  std::vector<Seen> seen;
  for (const SimpleFraction& f : fractions) {
    const auto from = view(f.denominator, a, a_is_center);
    const auto to = from ? view(f.denominator, b, b_is_center) : std::nullopt;
    if (!to) return std::nullopt;
    seen.push_back({*from, *to});
  }

  TurnedLogs result;
  Multiple multiple;
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    const Polynomial& n = fractions[k].numerator;
    const Polynomial& d = fractions[k].denominator;
    // Σ c(z)·log|t − z|: all |t − z| are |d(t)/lead|^(1/deg d).
    const Rational lead = d.leading_coefficient();
    const Rational residues = n.coefficient(d.degree() - 1) / lead;
    const auto add_size = [&](const View& at, int sign) {
      if (at.from && residues != 0)
        result.sizes.push_back({{abs(d(*at.from) / lead), 0}, sign * residues / d.degree()});
    };
    add_size(seen[k].from, -1);
    add_size(seen[k].to, 1);

    const Polynomial q = squarefree_part(residue_polynomial(n, d));
    const auto sum =
        std::make_shared<WeightedRoots>(q, weights(fractions[k], q, seen[k].from, seen[k].to));
    const auto cyclotomic = cyclotomic_bound(d);
    const long conjugates = std::min(sum->arrangements(), cyclotomic.value_or(many_conjugates));
    multiple.add({[sum](long bits) { return sum->enclose(bits); }, sum->to_integer(), sum->size(),
                  conjugates},
                 cyclotomic ? largest_cyclotomic_multiple : largest_multiple);
  }
  const auto known = multiple.value();
  if (!known) return std::nullopt;
  result.multiple = *known;
  return result;
}

}  // namespace phrame
