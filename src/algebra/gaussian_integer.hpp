#pragma once
#include <optional>

#include "phrame/algebra/complex_of.hpp"
#include "phrame/algebra/rational.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

using GaussianInteger = ComplexOf<Integer>;    ///< a number of ℤ[i]
using GaussianRational = ComplexOf<Rational>;  ///< a number of ℚ(i)

/// The positive multiple of z ≠ 0 whose parts are coprime integers.
PHRAME_API GaussianInteger primitive_multiple(const GaussianRational& z);
/// The one of a, −a, i·a, −i·a that has re > 0 and im ≥ 0; 0 for 0.
PHRAME_API GaussianInteger first_quadrant(const GaussianInteger& a);
/// a/b where b ≠ 0 divides a; no value where it does not.
PHRAME_API std::optional<GaussianInteger> exact_quotient(const GaussianInteger& a,
                                                         const GaussianInteger& b);
/// The greatest common divisor in the first quadrant; gcd(0, 0) = 0. Fast where the greatest common
/// divisor of the norms is small.
PHRAME_API GaussianInteger gcd(GaussianInteger a, GaussianInteger b);

/// x = |root|²·rest for an integer x ≥ 1.
struct NormFactor {
  GaussianInteger root;  ///< its norm divides x
  Integer rest;          ///< x/|root|² ≥ 1
};

/// The least rest, a product of distinct primes ≡ 3 mod 4, which is 1 where x is a sum of two
/// squares: if at most one prime factor of x is above 10⁴ (and that one below 2⁴⁰⁹⁶), and in
/// practice for x < 2¹²⁸. For other x the rest may be greater, because finding the least is as hard
/// as factoring x. Throws DomainError for x < 1. Cost: up to a second, for two large primes.
PHRAME_API NormFactor split_norm(const Integer& x);

/// A z with |z|² = n ≥ 0 where it is found fast: where n is a product of primes below 10⁴ and of
/// either a square or one more prime. No value where n is of another form or not a sum of two
/// squares. Cost: at most one power modulo n and some divisions, much less than split_norm().
PHRAME_API std::optional<GaussianInteger> easy_norm_root(const Integer& n);

/// @{ Writes "1/2 - 3*i", "2", "-i".
PHRAME_API std::ostream& operator<<(std::ostream& out, const GaussianInteger& z);
PHRAME_API std::ostream& operator<<(std::ostream& out, const GaussianRational& z);
/// @}

}  // namespace phrame
