#include "phrame/algebra/integer_fraction.hpp"

namespace phrame::inline v0 {

IntegerFraction integer_fraction(const Polynomial& n, const Polynomial& d) {
  const Polynomial scaled = (1 / content(d)) * n;
  return {integer_numerator(scaled), denominator(scaled), integer_primitive_part(d)};
}

}  // namespace phrame
