#include "phrame/algebra/surd.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame {

SquareFactor split_square(const Integer& x) {
  if (x < 1) throw DomainError("split_square: the number is not positive");
  constexpr unsigned largest_divisor = 10'000;
  Integer rest = x;
  SquareFactor result{1, 1};
  for (unsigned p = 2; p <= largest_divisor && Integer(p) * p <= rest; ++p) {
    for (; rest % (p * p) == 0; rest /= p * p) result.root *= p;
    if (rest % p != 0) continue;
    result.rest *= p;
    rest /= p;
  }
  const Integer root = sqrt(rest);
  if (root * root == rest)
    result.root *= root;
  else
    result.rest *= rest;
  return result;
}

}  // namespace phrame
