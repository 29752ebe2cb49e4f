#include "phrame/io/write/nearness.hpp"

#include <fmt/format.h>

#include "phrame/algebra/rounding.hpp"

namespace phrame {

std::string to_line(const Nearness& nearness) {
  return fmt::format("at most {} from it; rotation-minimizing frames differ by {}",
                     upper_bound_text(nearness.distance),
                     nearness.rmf_difference
                         ? "at most " + upper_bound_text(*nearness.rmf_difference)
                         : "an angle without a bound, for the speed is not kept from 0");
}

}  // namespace phrame
