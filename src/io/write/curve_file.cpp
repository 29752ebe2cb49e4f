#include "phrame/io/write/curve_file.hpp"

#include "phrame/io/write/json_text.hpp"

namespace phrame {

std::string write_curve(const NamedCurve& named) { return pretty(json_of(named)); }

}  // namespace phrame
