#pragma once
#include <optional>

#include "phrame/algebra/bivariate.hpp"

namespace phrame::inline v0 {

/// v(α, t) up to a constant for each root α of q: v over its leading coefficient, modulo q, where
/// deg q ≤ 2 or that is found to be about as short as v; else primitive_part(v). Not proved to be
/// right, but likely. Precondition: deg v ≥ 1, its leading coefficient is coprime to q.
Bivariate short_argument(const Bivariate& v, const Polynomial& q);

/// v(x, h(t)), primitive unless it is monic, as v is then. Precondition: h is monic.
Bivariate composed(const Bivariate& v, const Polynomial& h);

/// v(x, t) = w(x, h(t)) where w is of degree 1 in h.
struct ComposedArgument {
  Bivariate outer;   ///< w
  Polynomial inner;  ///< h, monic, h(0) = 0
};

/// No value where v is not of this kind, or is itself of degree 1.
std::optional<ComposedArgument> as_composed(const Bivariate& v);

}  // namespace phrame
