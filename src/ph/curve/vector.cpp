#include "phrame/ph/curve/vector.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"

namespace phrame {

std::string abbreviated(const Vector<Rational>& v) {
  const auto text = [](const Rational& x) { return as_written(x); };
  return fmt::format("({}, {}, {})", text(v[0]), text(v[1]), text(v[2]));
}

}  // namespace phrame
