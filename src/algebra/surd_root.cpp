// Let √x be a sum of square roots of rational numbers, x > 0 in a field K. Let k be a field over
// which K has degree 2, x̄ the conjugate of x over k, and x = u + v, x̄ = u − v. Since √x generates
// an extension whose group has the exponent 2, x = r·y² with r ∈ ℚ and y ∈ K (Kummer). Then x·x̄ =
// w² for w = ±r·y·ȳ ∈ k, of either sign, and
//   √x = √m ± √n,  m = (u + w)/2,  n = (u − w)/2,
// since m + n = u and 4mn = u² − w² = v²; the sign is that of v. As x̄ = r·ȳ² > 0, for w > 0 both
// are > 0, and √m = (√x + √x̄)/2 and √n are sums like √x, of numbers of k. Conversely, they make √x
// one.
#include "phrame/algebra/surd_root.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {

Radical to_radical(const Surd& x) {
  Radical sum;
  for (auto term = x.terms().rbegin(); term != x.terms().rend(); ++term)
    sum = sum + term->second * sqrt(Radical(Rational(term->first)));
  return sum;
}

std::optional<Surd> simple_root(const Surd& x) {
  if (sign(x) <= 0) throw DomainError("simple_root: the radicand is not positive");
  if (x.is_rational()) {
    const Rational r = x.rational_part();
    const auto [root, rest] = split_square(numerator(r) * denominator(r));
    return Surd(0, Rational(root, denominator(r)), rest);
  }
  const RootField half = half_field(x);
  const Surd other = conjugate(x, half);
  if (sign(other) < 0) return std::nullopt;
  const auto w = simple_root(x * other);
  if (!w || !(conjugate(*w, half) == *w)) return std::nullopt;
  const Surd u = Rational(1, 2) * (x + other);
  const auto m = simple_root(Rational(1, 2) * (u + *w));
  const auto n = m ? simple_root(Rational(1, 2) * (u - *w)) : std::nullopt;
  if (!n) return std::nullopt;
  return sign(x - other) > 0 ? *m + *n : *m - *n;
}

Radical times_root(const Surd& factor, const Surd& x) {
  if (const auto root = simple_root(x)) {
    std::vector<std::pair<Integer, Rational>> terms(root->terms().begin(), root->terms().end());
    const auto square = [](const auto& term) {
      return term.second * term.second * Rational(term.first);
    };
    std::sort(terms.begin(), terms.end(),
              [&](const auto& s, const auto& t) { return square(s) > square(t); });
    Radical sum;
    for (const auto& [d, c] : terms)
      for (const auto& [e, b] : factor.terms()) sum = sum + b * c * sqrt(Radical(Rational(d * e)));
    return sum;
  }
  const Radical root = sqrt(to_radical(factor * factor * x));
  return sign(factor) < 0 ? -root : root;
}

}  // namespace phrame
