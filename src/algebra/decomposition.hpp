#pragma once
#include <optional>

#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// n/d·dt = outer_n(h)/outer_d(h)·dh: a fraction that is one of h(t), times h′. Then it has at t
/// the residue of outer_n/outer_d at h(t).
struct Decomposition {
  Polynomial outer_n;
  Polynomial outer_d;
  Polynomial inner;  ///< h, monic, h(0) = 0
};

/// With deg h = k ≥ 2, which divides deg d, where there is one: d = outer_d∘h determines h [Kozen,
/// Landau 1989].
std::optional<Decomposition> decomposition(const Polynomial& n, const Polynomial& d, long k);

/// The one of the greatest k ≤ most, if there is one.
std::optional<Decomposition> widest_decomposition(const Polynomial& n, const Polynomial& d,
                                                  long most);

/// Is there one with h(a) = h(b)? Then ∫ n/d from a to b is 0, if there is no pole between them, as
/// where the fraction changes its sign under t → a + b − t. Requires d squarefree, deg n
/// < deg d ≥ 1. Cost: mostly that of one prime, which denies repeated residues.
bool closes(const Polynomial& n, const Polynomial& d, const Rational& a, const Rational& b);

}  // namespace phrame
