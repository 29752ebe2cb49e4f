#pragma once
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/proof/classify.hpp"

namespace phrame {

/// What `phrame classify` shows.
struct ClassifyReport {
  NamedCurve curve;
  Classification classification;
};
ClassifyReport classify_report(const NamedCurve& curve);

std::string to_text(const ClassifyReport& report);  ///< for reading, Unicode
std::string to_json(const ClassifyReport& report);  ///< classify/1

}  // namespace phrame
