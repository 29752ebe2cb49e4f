// For x = a + b√d > 0 with a² − d·b² = w², w ≥ 0 rational, and b ≠ 0: then a > 0, and
//   √x = √m ± √n,  m = (a + w)/2,  n = (a − w)/2,
// with the sign of b, since m + n = a and 4mn = a² − w² = d·b². Both are > 0 where d > 0.
#include "phrame/algebra/surd_root.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame {

Radical to_radical(const Surd& x) { return Radical(x.a) + x.b * sqrt(Radical(Rational(x.d))); }

bool has_simple_root(const Surd& x) { return x.b == 0 || square_root(norm(x)).has_value(); }

Radical times_root(const Surd& factor, const Surd& x) {
  if (sign(x) <= 0) throw DomainError("times_root: the radicand is not positive");
  if (!has_simple_root(x)) {
    const Radical root = sqrt(to_radical(factor * factor * x));
    return sign(factor) < 0 ? -root : root;
  }
  const Rational w = x.b == 0 ? x.a : *square_root(norm(x));
  Radical sum;
  // (factor.a + factor.b·√d)·√m.
  const auto add = [&](const Rational& m, const Rational& sign) {
    sum = sum + sign * factor.a * sqrt(Radical(m));
    if (factor.b != 0) sum = sum + sign * factor.b * sqrt(Radical(Rational(factor.d) * m));
  };
  add((x.a + w) / 2, 1);
  if (x.b != 0) add((x.a - w) / 2, x.b < 0 ? -1 : 1);
  return sum;
}

}  // namespace phrame
