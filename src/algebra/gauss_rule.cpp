#include "phrame/algebra/gauss_rule.hpp"

namespace phrame::inline v0 {

GaussRule gauss_rule(long n, long bits) {
  GaussRule rule;
  for (long k = n; k-- > 0;) {
    arb_hypgeom_legendre_p_ui_root(rule.points.emplace_back().raw(),
                                   rule.weights.emplace_back().raw(), static_cast<unsigned long>(n),
                                   static_cast<unsigned long>(k), bits);
  }
  return rule;
}

}  // namespace phrame
