#pragma once
#include "phrame/integrate/hermite.hpp"

namespace phrame::inline v0 {

/// The same decomposition as hermite_reduce by the linear system of Horowitz and Ostrogradsky
/// [Farouki 2003, §3, (19)–(22)]: p = q₂p₁′ − s·p₁ + q₁p₂. A dense system of
/// size deg q: kept as an independent check. Throws DomainError where f is not proper.
RationalPart horowitz_reduce(const RationalFunction& f);

}  // namespace phrame
