#include "phrame/algebra/modular_lift.hpp"

#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

flint::FmpzPoly polynomial(std::initializer_list<const char*> coefficients) {
  flint::FmpzPoly f;
  flint::Fmpz c;
  slong k = 0;
  for (const char* text : coefficients) {
    fmpz_set_str(c.get(), text, 10);
    fmpz_poly_set_coeff_fmpz(f.get(), k++, c.get());
  }
  return f;
}

ModularPolynomial product(const std::vector<ModularPolynomial>& f) {
  ModularPolynomial result(f[0].prime());
  nmod_poly_mul(result.raw(), f[0].raw(), f[1].raw());
  return result;
}

}  // namespace

TEST_CASE("modular lift: the largest and the least number of the bound come back") {
  for (const ulong bits : {1UL, 59UL, 60UL, 61UL, 62UL, 121UL, 122UL, 600UL, 6100UL}) {
    flint::Fmpz c;
    fmpz_one_2exp(c.get(), bits);
    fmpz_sub_ui(c.get(), c.get(), 1);
    flint::FmpzPoly f;
    fmpz_poly_set_coeff_fmpz(f.get(), 0, c.get());
    fmpz_neg(c.get(), c.get());
    fmpz_poly_set_coeff_fmpz(f.get(), 2, c.get());
    const auto lifted = modular_lift({f}, 5, static_cast<long>(bits),
                                     [](const auto& at) { return std::optional(at[0]); });
    CHECK(fmpz_poly_equal(lifted.get(), f.get()) != 0);
  }
}

TEST_CASE("modular lift: law: a product lifted is the product, also past primes without an image") {
  for_samples(60, [](Random& random) {
    const flint::FmpzPoly f =
        integer_primitive_part(pow(random.polynomial(4), random.integer(1, 4)));
    const flint::FmpzPoly g = integer_primitive_part(random.polynomial(6));
    flint::FmpzPoly expected;
    fmpz_poly_mul(expected.get(), f.get(), g.get());
    const long refused = random.integer(0, 2);
    long asked = 0;
    const auto image =
        [&](const std::vector<ModularPolynomial>& at) -> std::optional<ModularPolynomial> {
      if (asked++ < refused) return std::nullopt;
      return product(at);
    };
    const long bits = std::labs(fmpz_poly_max_bits(expected.get()));
    const auto lifted = modular_lift({f, g}, fmpz_poly_length(expected.get()) + 1, bits, image);
    CHECK(fmpz_poly_equal(lifted.get(), expected.get()) != 0);
  });
}

TEST_CASE("modular lift: a prime without an image is not used") {
  // Of the first prime the image is wrong, and says so.
  const flint::FmpzPoly f = polynomial({"123456789012345678901234567890", "-1"});
  const ulong bad = Primes().next();
  const auto lifted = modular_lift({f}, 2, 100, [&](const auto& at) {
    return at[0].prime() == bad ? std::nullopt : std::optional(at[0]);
  });
  CHECK(fmpz_poly_equal(lifted.get(), f.get()) != 0);
}
