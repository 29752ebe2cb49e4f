// A polynomial q of degree d has a root within d·|q(z)/q′(z)| of z, because q′/q = Σ 1/(z − ζ). At
// the root ζ in a disc of radius r around z the residue c = n(ζ)/q′(ζ) satisfies
//   |c − w| ≤ (|n(z) − w·q′(z)| + r·(n̂′(ρ) + |w|·q̂″(ρ))) / (|q′(z)| − r·q̂″(ρ)),  ρ = |z| + r,
// where p̂ has the absolute values of the coefficients of p. Values at points of the grid are exact;
// what follows is rational arithmetic, rounded upwards to a fixed number of bits.
#include "phrame/integrate/root_discs.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

/// x ≥ 0 rounded up to about 64 bits.
Rational rounded_up(const Rational& x) {
  if (x == 0) return 0;
  const long shift = 64 - binary_exponent(x);
  return Rational(floor(x * power_of_two(shift)) + 1) * power_of_two(-shift);
}

/// √x for x ≥ 0, rounded up to about 64 bits.
Rational sqrt_above(const Rational& x) {
  if (x == 0) return 0;
  const long shift = 64 - binary_exponent(x) / 2;
  return Rational(sqrt(floor(x * power_of_two(2 * shift))) + 1) * power_of_two(-shift);
}

/// ⌈√x⌉ for x ≥ 0.
Integer ceil_sqrt(const Rational& x) {
  Integer root = sqrt(floor(x));
  while (Rational(root * root) < x) ++root;
  return root;
}

/// |re + i·im|, rounded up.
Rational size_above(const GaussianRational& z) { return sqrt_above(norm(z)); }

/// p with the absolute values of its coefficients.
Polynomial with_absolute_values(const Polynomial& p) {
  std::vector<Rational> list = p.coefficients();
  for (Rational& c : list) c = abs(c);
  return Polynomial(list);
}

/// The exact value of a polynomial at points of the grid.
class GridValue {
 public:
  GridValue(const Polynomial& p, long bits) : content_(content(p)), bits_(bits) {
    for (const Rational& c : primitive_part(p).coefficients()) falling_.push_back(numerator(c));
    std::reverse(falling_.begin(), falling_.end());
  }

  GaussianRational operator()(const GaussianInteger& z) const {
    GaussianInteger value{0, 0};  // by Horner's rule, each step times 2^bits
    long shift = 0;
    for (const Integer& c : falling_) {
      value = value * z;
      value.re += c << static_cast<unsigned long>(shift);
      shift += bits_;
    }
    const Rational unit = content_ * power_of_two(falling_.empty() ? 0 : bits_ - shift);
    return {value.re * unit, value.im * unit};
  }

 private:
  Rational content_;
  long bits_;
  std::vector<Integer> falling_;  ///< coefficients, the leading one first
};

/// The point of the grid nearest to x, half way between two the lower one: ⌈2^bits·x − 1/2⌉.
Integer nearest(const Rational& x, long bits) {
  return -floor(Rational(1, 2) - x * power_of_two(bits));
}

/// The same for all x of a ball; where they differ nothing or, if need be, the lowest.
std::optional<Integer> nearest(const RealBall& x, long bits, bool is_needed) {
  Integer lowest = nearest(x.lower(), bits);
  if (is_needed || lowest == nearest(x.upper(), bits)) return lowest;
  return std::nullopt;
}

/// log₂|z| where that is positive, about.
long size_exponent(const ComplexBall& z) {
  const Rational size = abs(z.re().upper()) + abs(z.im().upper()) + 1;
  return binary_exponent(size);
}

/// The roots above the real axis, each at the nearest point of the grid. A root that no precision
/// puts on one side is half way between two points: then the lower one.
std::vector<GaussianInteger> roots_on_grid(const Polynomial& q, long bits) {
  for (long precision = bits + 64;; precision *= 2) {
    const Roots roots = isolate_roots(q, precision);
    if (!roots.real.empty()) throw DomainError("root_discs: the polynomial has a real root");
    std::vector<GaussianInteger> found;
    for (const ComplexBall& z : roots.upper) {
      // The precision is relative to the size of z.
      const bool is_last = precision > 4 * (bits + size_exponent(z)) + 4096;
      const auto re = nearest(z.re(), bits, is_last);
      const auto im = nearest(z.im(), bits, is_last);
      if (!re || !im) break;
      found.push_back({*re, *im});
    }
    if (found.size() != roots.upper.size()) continue;
    std::sort(found.begin(), found.end(), [](const GaussianInteger& a, const GaussianInteger& b) {
      return a.re != b.re ? a.re < b.re : a.im < b.im;
    });
    return found;
  }
}

/// Above the real axis and apart from each other.
bool are_disjoint(const std::vector<RootDisc>& discs) {
  for (auto a = discs.begin(); a != discs.end(); ++a) {
    if (a->center.im <= a->radius) return false;
    for (auto b = discs.begin(); b != a; ++b)
      if (!are_apart(*a, *b)) return false;
  }
  return true;
}

Integer shifted(const Integer& n, long bits) { return n << static_cast<unsigned long>(bits); }

/// √n to 128 bits, rounded up, or else down.
Integer root_128(const Integer& n, bool is_up) {
  const long shift = std::max(0L, bit_length(n) - 256) / 2;
  Integer root = sqrt(n >> static_cast<unsigned long>(2 * shift));
  if (is_up && shifted(root * root, 2 * shift) < n) ++root;
  return shifted(root, shift);
}

/// |z| to 128 bits.
Integer sqrt_of_size(const GaussianInteger& z, bool is_up) { return root_128(norm(z), is_up); }

/// 2^(bits·degree)·p(z/2^bits) for a p of integers, whose degree is no greater.
GaussianInteger on_grid(const Polynomial& p, long degree, const GaussianInteger& z, long bits) {
  GaussianInteger value{0, 0};
  for (long k = degree; k >= 0; --k) {
    value = value * z;
    value.re += shifted(numerator(p.coefficient(k)), bits * (degree - k));
  }
  return value;
}

/// What integers prove of discs.
struct DiscLaw {
  DiscLaw(const Polynomial& q, const Polynomial& n, long precision)
      : degree(q.degree()),
        bits(precision),
        unit(power_of_two(-bits)),
        q_at(q, bits),
        slope_at(differentiate(q), bits),
        n_at(n, bits),
        n_variation(with_absolute_values(differentiate(n))),
        slope_variation(with_absolute_values(differentiate(differentiate(q)))) {}

  /// d²·|q/q′|² at a point of the grid; no value where q′ is 0.
  std::optional<Rational> squared_distance(const GaussianInteger& z) const {
    const Rational slope = norm(slope_at(z));
    if (slope == 0) return std::nullopt;
    return norm(q_at(z)) / slope * (degree * degree);
  }

  /// n/q′ at a point where q′ is not 0.
  GaussianRational quotient(const GaussianInteger& z) const {
    const GaussianRational slope = slope_at(z);
    return 1 / norm(slope) * (n_at(z) * conjugate(slope));
  }

  /// |c − w| ≤ miss/keep where keep > 0, in the letters at the top.
  struct Bound {
    Rational miss;
    Rational keep;
  };
  Bound residue_bound(const RootDisc& disc) const {
    const GaussianRational z{disc.center.re * unit, disc.center.im * unit};
    const GaussianRational w{disc.residue.re * unit, disc.residue.im * unit};
    const Rational r = disc.radius * unit;
    const Rational rho = rounded_up(size_above(z) + r);
    const Rational flatness = sqrt_above(1 / norm(slope_at(disc.center)));  // 1/|q′|
    const Rational curving = slope_variation(rho);
    return {size_above(quotient(disc.center) - w) +
                r * flatness * (n_variation(rho) + size_above(w) * curving),
            1 - r * curving * flatness};
  }

  long degree;
  long bits;
  Rational unit;
  GridValue q_at;
  GridValue slope_at;
  GridValue n_at;
  Polynomial n_variation;
  Polynomial slope_variation;
};

}  // namespace

bool are_apart(const RootDisc& a, const RootDisc& b) {
  const Integer sum = a.radius + b.radius;
  return norm(GaussianInteger{a.center.re - b.center.re, a.center.im - b.center.im}) > sum * sum;
}

std::optional<Integer> radius_of_root(const Polynomial& q, const GaussianInteger& center,
                                      long bits) {
  const auto distance = DiscLaw(q, {}, bits).squared_distance(center);
  if (!distance) return std::nullopt;
  return ceil_sqrt(*distance * power_of_two(2 * bits));
}

bool holds_residue(const Polynomial& q, const Polynomial& n, const RootDisc& disc, long bits) {
  constexpr long fine = 64;  // ρ has so many bits more than the grid
  const long last = q.degree() - 1;
  const Rational common = Integer(denominator(content(q)) * denominator(content(n)));
  const Polynomial slope = common * differentiate(q);
  const Polynomial above = common * n;
  const GaussianInteger slope_at = on_grid(slope, last, disc.center, bits);
  const GaussianInteger n_at = on_grid(above, last, disc.center, bits);
  const GaussianInteger off = slope_at * disc.residue;
  const Integer miss =
      sqrt_of_size({shifted(n_at.re, bits) - off.re, shifted(n_at.im, bits) - off.im}, true);
  const Integer rho =
      root_128(shifted(norm(disc.center), 2 * fine), true) + shifted(disc.radius, fine);
  const auto variation = [&](const Polynomial& p) {
    return on_grid(with_absolute_values(differentiate(p)), last - 1, {rho, 0}, bits + fine).re;
  };
  const Integer curving = variation(slope);
  const long shift = fine * std::max(0L, last - 1);
  return shifted(miss, shift) + disc.radius * (shifted(variation(above), bits) +
                                               sqrt_of_size(disc.residue, true) * curving) <=
         disc.residue_radius *
             (shifted(sqrt_of_size(slope_at, false), shift) - disc.radius * curving);
}

std::optional<std::vector<RootDisc>> root_discs(const Polynomial& q, const Polynomial& n,
                                                long bits) {
  const DiscLaw law(q, n, bits);
  std::vector<RootDisc> discs;
  for (const GaussianInteger& center : roots_on_grid(q, bits)) {
    const auto distance = law.squared_distance(center);
    if (!distance) return std::nullopt;
    const GaussianRational c = law.quotient(center);
    RootDisc disc{center,
                  ceil_sqrt(*distance * power_of_two(2 * bits)),
                  {nearest(c.re, bits), nearest(c.im, bits)},
                  0};
    const auto [miss, keep] = law.residue_bound(disc);
    if (keep <= 0) return std::nullopt;
    // One more, for a checker that rounds more coarsely.
    if (miss != 0) disc.residue_radius = floor(miss / keep / law.unit) + 2;
    discs.push_back(disc);
  }
  if (!are_disjoint(discs)) return std::nullopt;
  return discs;
}

// |∂/∂z log((t − z)/(−z))| ≤ 2/y and |log((t − z)/(−z))| ≤ |t|/y for y = Im z. The factor 1 + (|t|
// + |z|)/y is for those who compute arctan((t − x)/y) from intervals around x and y.
Rational log_error(const std::vector<RootDisc>& discs, long bits, const Rational& reach) {
  const Rational unit = power_of_two(-bits);
  const auto size = [&](const GaussianInteger& z) { return (abs(z.re) + abs(z.im)) * unit; };
  Rational sum = 0;
  for (const auto& [center, radius, residue, residue_radius] : discs) {
    const Rational r = radius * unit;
    const Rational s = residue_radius * unit;
    const Rational per_y = rounded_up(1 / (center.im * unit - r));
    const Rational off = (size(residue) + s) * r * 2 * per_y * (1 + (reach + size(center)) * per_y);
    sum += 2 * rounded_up(off + s * reach * per_y);
  }
  return sum;
}

}  // namespace phrame
