#include "phrame/ph/curve/complex_form.hpp"

#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

namespace complex_form_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// Is x′ + iy′ = f·w²?
bool is_hodograph(const ComplexForm& form, const Vector<Polynomial>& rate) {
  const GaussianPolynomial square = form.root * form.root;
  return rate[0] == form.multiplier * square.re && rate[1] == form.multiplier * square.im &&
         rate[2].is_zero();
}

Rational nonzero(Random& random) {
  const Rational x = random.rational();
  return x == 0 ? Rational(1) : x;
}

}  // namespace

TEST_CASE("complex form: law: r′ = f·w², as it is given or with complex factors in A") {
  for_samples(40, [](Random& random) {
    const GaussianPolynomial w = random.gaussian_polynomial(random.integer(0, 3));
    if (is_zero(w)) return;
    const Polynomial f{nonzero(random), random.rational()};
    const Curve plain(from_complex_root(w), f);
    const auto form = complex_form(plain);
    REQUIRE(form);
    CHECK(*form == ComplexForm{f, w});
    CHECK(is_hodograph(*form, hodograph(plain)));
    const GaussianPolynomial c = random.gaussian_polynomial(random.integer(0, 2));
    if (is_zero(c)) return;
    const auto [alpha, beta] = hopf_form(plain.preimage());
    const Curve turned(from_hopf_form({alpha * c, beta * c}), f);
    const auto found = complex_form(turned);
    REQUIRE(found);
    CHECK(is_hodograph(*found, hodograph(turned)));
    const bool is_given = turned.preimage().v.is_zero() && turned.preimage().p.is_zero();
    CHECK((is_given || gcd(found->root.re, found->root.im).is_constant()));
  });
  CHECK_FALSE(complex_form(test::quintic));
}

// About the focus, with X towards the vertex, a·sec³(φ/3) is 27aY² = (a − X)(X + 8a)².
TEST_CASE("Tschirnhausen: law: PH cubics in any plane are on the cubic of their focus and vertex") {
  for_samples(40, [](Random& random) {
    const GaussianPolynomial w = random.gaussian_polynomial(1);
    if (is_zero(w)) return;
    const Curve level(from_complex_root(w), Polynomial{nonzero(random)},
                      {random.rational(), random.rational(), random.rational()});
    const RationalQuaternion q{random.rational(), random.rational(), nonzero(random),
                               random.rational()};
    const Curve curve = rotated(level, q);
    const auto cubic = tschirnhausen_cubic(curve);
    CHECK(cubic.has_value() == (degree(curve) == 3 && !line_direction(curve.preimage())));
    if (!cubic) return;
    const Rational s = cubic->squared_scale;  // a²
    const Vector<Polynomial> r = position(curve) - as_polynomials(cubic->focus);
    const Polynomial x = dot(cubic->vertex - cubic->focus, r);  // aX
    const Polynomial y = s * dot(r, r) - x * x;                 // a²Y²
    CHECK(Rational(27) * s * y == (Polynomial{s} - x) * pow(x + Polynomial{8 * s}, 2));
    CHECK(evaluate(position(curve), cubic->vertex_at) == cubic->vertex);
    CHECK(dot(cubic->vertex - cubic->focus, cubic->vertex - cubic->focus) == s);
  });
  CHECK_FALSE(tschirnhausen_cubic(test::quintic));
  CHECK_FALSE(tschirnhausen_cubic(Curve({{1, 1}, {0, 1}, {2}, {1}})));     // a spatial cubic
  CHECK_FALSE(tschirnhausen_cubic(Curve({{1, 1}, {}, {}, {2, 2}})));       // a line
  CHECK_FALSE(tschirnhausen_cubic(Curve({{1}, {}, {}, {0, 1}}, {0, 1})));  // of degree 4
}

}  // namespace complex_form_test
