#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/proof/classify.hpp"

namespace phrame {

/// Of which kinds is a path, and are its segments?
struct ClassificationQuery {};

/// Of which kinds a path and its segments are.
struct ClassificationAnswer {
  NamedPath path;                     ///< as asked
  PathClassification classification;  ///< with witnesses
};

/// Throws as classify().
PHRAME_API ClassificationAnswer answer(const NamedPath& path, const ClassificationQuery& query);

}  // namespace phrame
