#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/rmf_angle.hpp"

// The same angle as main.cpp's, by two headers.
int main() {
  using namespace phrame;
  const RmfAngle theta(
      Curve({Polynomial{0, 0, 1}, Polynomial{0, 1}, Polynomial{0, 1}, Polynomial{1}}),
      Reference::euler_rodrigues);
  return round_to_decimal(theta.value(Rational(1, 2)), 3).value == "-0.800" ? 0 : 1;
}
