#pragma once
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// What `phrame identify` says of a curve.
struct IdentifyReport {
  std::string name;
  std::variant<Curve, NotPythagorean> result;
};

std::string to_text(const IdentifyReport& report);
std::string to_json(const IdentifyReport& report);  ///< identify/1

}  // namespace phrame
