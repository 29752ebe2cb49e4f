#pragma once
#include <vector>

#include "phrame/algebra/gaussian_integer.hpp"

namespace phrame::inline v0 {

/// A power with a rational exponent, of which only products are asked for.
struct Power {
  GaussianRational base;  ///< not 0
  Rational exponent;      ///< of any sign
};

/// A number N > 0 such that N·exponent is whole for all of them.
Integer common_denominator(const std::vector<Power>& powers);

// Whether products of powers are trivial, decided without computing a power: the bases are written
// as products over a coprime base of ℤ[i] (Bernstein, Factoring into coprimes in essentially linear
// time, 2005), whose elements are multiplicatively independent up to units. Both throw DomainError
// for a base 0.

/// Is ∏ |re|^exponent = 1? Precondition: the bases are real.
bool sizes_cancel(const std::vector<Power>& powers);

/// Is Σ exponent·arg base a rational multiple of π? If so, a multiple of π/(4N).
bool turns_are_rational(const std::vector<Power>& powers);

}  // namespace phrame
