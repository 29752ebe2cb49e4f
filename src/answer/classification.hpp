#pragma once
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/proof/classify.hpp"

namespace phrame {

/// Of which kinds is a path, and are its segments?
struct ClassificationQuery {};

/// Of which kinds a path and its segments are.
struct ClassificationAnswer {
  NamedPhPath path;                   ///< as asked
  PathClassification classification;  ///< with witnesses
};

/// Throws as classify().
ClassificationAnswer answer(const NamedPhPath& path, const ClassificationQuery& query);

}  // namespace phrame
