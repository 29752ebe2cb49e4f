#include "phrame/ph/proof/check_weight.hpp"

#include "phrame/algebra/sturm.hpp"

namespace phrame::inline v0 {

std::string objection_to_weight(const Curve& curve) {
  if (count_real_roots(curve.weight(), closed_interval(0, 1)) == 0) return "";
  return "the weight has a zero on [0, 1]";
}

}  // namespace phrame
