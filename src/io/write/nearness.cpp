#include "phrame/io/write/nearness.hpp"

#include <fmt/format.h>

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

std::string to_line(const Nearness& nearness) {
  return fmt::format("at most {} from it; rotation-minimizing frames differ by {}",
                     upper_bound_text(nearness.distance),
                     nearness.rmf_difference
                         ? "at most " + upper_bound_text(*nearness.rmf_difference)
                         : "an angle without a bound, for the speed is not kept from 0");
}

std::string to_line(const NotNear& none, const Rational& epsilon) {
  return fmt::format("no PH curve was found within {}; ", distance_text(epsilon)) +
         (none.distance
              ? fmt::format("the nearest one is {} away", upper_bound_text(*none.distance, 3))
              : "those near its segments do not join smoothly");
}

std::string distance_text(const Rational& distance) {
  constexpr long most_digits = 12;
  for (long digits = 1; digits <= most_digits; ++digits)
    if (std::string text = upper_bound_text(distance, digits); parse_rational(text) == distance)
      return text;
  return upper_bound_text(distance);
}

}  // namespace phrame
