#pragma once
#include "phrame/algebra/radical.hpp"
#include "phrame/export.hpp"
#include "phrame/integrate/antiderivative.hpp"

namespace phrame::inline v0 {

/// Σ c(x) · log v(x, t) over the roots x of q, which are written in radicals.
struct RadicalSum {
  LogSum sum;                     ///< q irreducible, of degree ≤ 4
  std::vector<Radical> roots;     ///< x₁, x₂, … in the order of isolate_roots(q, …)
  std::vector<Radical> residues;  ///< c(x₁), c(x₂), …
  std::size_t real_roots = 0;     ///< so many of them come first
  friend bool operator==(const RadicalSum&, const RadicalSum&) = default;
};

/// An antiderivative whose logarithms are written out [Farouki 2003, §4 and Appendix A]:
///   polynomial + rational + Σ c(x) · log v(x, t).
/// Where v = t − x, which is so wherever the denominator allows it, the logarithm of a pole off the
/// real axis is the principal one: t − x stays in a half plane while t is real, so that it is
/// continuous on the whole real line. For real x, log|v| is the real antiderivative. Elsewhere, for
/// complex x and v of a degree > 1, the logarithm is to be continued along the path.
struct RadicalForm {
  Polynomial polynomial;         ///< the polynomial part
  RationalFunction rational;     ///< proper
  std::vector<RadicalSum> logs;  ///< written out
  friend bool operator==(const RadicalForm&, const RadicalForm&) = default;
};

/// The same up to a constant, with the roots as roots of polynomials.
PHRAME_API Antiderivative antiderivative(const RadicalForm& F);

/// F in radicals; F may be in any form. An irreducible factor d of the denominator of F′ gives
///   c·log d(t), where its residue c is rational,
///   Σ c(z)·log(t − z) over its roots z, where deg d ≤ 4,
///   a sum over its residues, where these have a degree ≤ 4,
/// in this order of preference. Throws DomainError for any other, which the message names.
/// Checked before it is returned: the derivative is F′, exactly, and the radicals are the roots.
PHRAME_API RadicalForm radical_form(const Antiderivative& F);

}  // namespace phrame
