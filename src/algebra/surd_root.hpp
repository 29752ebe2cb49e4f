#pragma once
#include "phrame/algebra/radical.hpp"
#include "phrame/algebra/surd.hpp"

namespace phrame {

/// a + b√d.
Radical to_radical(const Surd& x);

/// Is √x a sum of square roots of rational numbers, as √(5 + 2√6) = √2 + √3 is? It is where the
/// norm of x > 0 is the square of a rational number (Euclid, Elements X).
bool has_simple_root(const Surd& x);

/// factor·√x for x > 0, in real numbers: a sum of square roots of rational numbers where x has a
/// simple root, else one root of a number a + b√d, with the factor under it.
/// Throws DomainError for x ≤ 0.
Radical times_root(const Surd& factor, const Surd& x);

}  // namespace phrame
