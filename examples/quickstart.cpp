#include <iostream>

#include "phrame/phrame.hpp"

int main() {
  using namespace phrame;
  // r′ = A i A* with A = (2, 1, 0, 1)(1−t)² + (0, 1, −2, 2)·2t(1−t) + (2, 0, 0, 1)t².
  const Curve curve({from_bernstein({2, 0, 2}), from_bernstein({1, 1, 0}),
                     from_bernstein({0, -2, 0}), from_bernstein({1, 2, 1})});
  RmfAngle theta(curve, Reference::euler_rodrigues);
  std::cout << "theta(1) = " << round_to_decimal(theta.value(1), 50).value << "\n";
  const Vector<double> f2 =
      round_to_double(rotation_minimizing_frame(curve, theta, Rational(1, 2)).e2);
  std::cout << "f2(1/2)  = " << f2[0] << " " << f2[1] << " " << f2[2] << "\n";
}
