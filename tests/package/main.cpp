#include "phrame/fwd.hpp"

bool is_right(const phrame::Curve& curve);  // a header of the program's needs the names only

#include "phrame/phrame.hpp"

// θ = −2t/(1 + t²) for A = (t + i)(t + j): at t = 1/2 exactly −4/5.
int main() {
  using namespace phrame;
  const Curve curve({Polynomial{0, 0, 1}, Polynomial{0, 1}, Polynomial{0, 1}, Polynomial{1}});
  return is_right(curve) && !version.empty() ? 0 : 1;
}

bool is_right(const phrame::Curve& curve) {
  using namespace phrame;
  const RmfAngle theta(curve, Reference::euler_rodrigues);
  return round_to_decimal(theta.value(Rational(1, 2)), 3).value == "-0.800";
}
