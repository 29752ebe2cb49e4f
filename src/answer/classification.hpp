#pragma once
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/proof/classify.hpp"

namespace phrame {

/// Of which kinds is a path, and are its segments?
struct ClassificationQuery {};

struct ClassificationAnswer {
  NamedPath path;
  PathClassification classification;
};

ClassificationAnswer answer(const NamedPath& path, const ClassificationQuery& query);

}  // namespace phrame
