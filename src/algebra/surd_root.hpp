#pragma once
#include <optional>

#include "phrame/algebra/radical.hpp"
#include "phrame/algebra/surd.hpp"

namespace phrame::inline v0 {

/// The roots by descending radicands.
Radical to_radical(const Surd& x);

/// √x as a sum of square roots of rational numbers, for x > 0, where it is one, as
/// √(5 + 2√6) = √2 + √3 and √(2 − √3) = (√6 − √2)/2 are (Euclid, Elements X); no value where it is
/// not. Throws DomainError for x ≤ 0.
std::optional<Surd> simple_root(const Surd& x);

/// factor·√x for x > 0, in real numbers: a sum of square roots of rational numbers where x has a
/// simple root, the greatest first, else one root, with the factor under it.
/// Throws DomainError for x ≤ 0.
Radical times_root(const Surd& factor, const Surd& x);

}  // namespace phrame
