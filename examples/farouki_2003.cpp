// The example of section 4 of R. T. Farouki, Exact rotation-minimizing frames for spatial
// Pythagorean-hodograph curves, Graphical Models 64 (2003), in the order of the paper.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "phrame/phrame.hpp"

using namespace phrame;

namespace {

/// "0.012018388019 ± 0.394440354901i": 12 decimals, as in the paper.
std::string conjugate_pair(const ComplexBall& z) {
  const auto re = static_cast<double>(z.re().lower());  // far narrower than 12 decimals
  const auto im = static_cast<double>(z.im().lower());
  std::ostringstream text;
  text << std::fixed << std::setprecision(12) << (std::abs(re) < 5e-13 ? 0.0 : re)
       << (im < 0 ? " ∓ " : " ± ") << std::abs(im) << "i";
  return text.str();
}

/// The roots of d, those above the real axis, and the residues of n/d there.
void print_roots(const Polynomial& n, const Polynomial& d, const char* root, const char* residue) {
  Roots roots = isolate_roots(d, 128);
  std::sort(roots.upper.begin(), roots.upper.end(), [](const ComplexBall& a, const ComplexBall& b) {
    return a.re().upper() < b.re().lower();
  });
  int k = 0;
  for (const ComplexBall& z : roots.upper) {
    ++k;
    const ComplexBall c = divide(evaluate(n, z, 128), evaluate(differentiate(d), z, 128), 128);
    std::cout << "  " << root << k << " = " << conjugate_pair(z) << "   " << residue << k << " = "
              << conjugate_pair(c) << "\n";
  }
}

}  // namespace

int main() {
  const Curve curve({from_bernstein({2, 0, 2}), from_bernstein({1, 1, 0}),
                     from_bernstein({0, -2, 0}), from_bernstein({1, 2, 1})});
  const auto show = [](const char* name, const Polynomial& p) {
    std::cout << "  " << name << " = " << formatted(p, Notation::unicode) << "\n";
  };
  const QuaternionPolynomial& preimage = curve.preimage();
  std::cout << "Farouki 2003, section 4\n";
  show("(r′ × r″)·r‴", triple_product(curve));
  show("σ", sigma(preimage));
  show("ρ", rho(preimage));
  const auto [a, b] = closed_split(preimage);
  show("a", a);
  show("b", b);
  print_roots(a, sigma(preimage), "z", "c");
  print_roots(b, rho(preimage), "w", "d");

  for (const Reference reference : {Reference::euler_rodrigues, Reference::frenet}) {
    RmfAngle theta(curve, reference);
    std::cout << (reference == Reference::euler_rodrigues
                      ? "θ relative to the Euler–Rodrigues frame\n"
                      : "θ relative to the Frenet frame\n");
    for (int k = 0; k <= 10; ++k) {
      const Rational t(k, 10);
      std::cout << "  " << to_string(t) << "\t" << round_to_decimal(theta.value(t), 50).value
                << "\n";
    }
  }
}
