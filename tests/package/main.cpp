#include "phrame/phrame.hpp"

// θ = −2t/(1 + t²) for A = (t + i)(t + j): at t = 1/2 exactly −4/5.
int main() {
  using namespace phrame;
  const Curve curve({Polynomial{0, 0, 1}, Polynomial{0, 1}, Polynomial{0, 1}, Polynomial{1}});
  RmfAngle theta(curve, Reference::euler_rodrigues);
  const bool right = round_to_decimal(theta.value(Rational(1, 2)), 3).value == "-0.800";
  return right && !version.empty() ? 0 : 1;
}
