#include "phrame/answer/rounded.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame {

Decimal rounded(const Real& x, const std::string& name, long digits) {
  try {
    return round_to_decimal(x, digits);
  } catch (const Undecided& error) {
    throw Undecided(name + ": " + error.what());
  }
}

}  // namespace phrame
