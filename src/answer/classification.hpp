#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/proof/classify.hpp"

namespace phrame::inline v0 {

/// Asks which kinds of PH curves a path and its segments are.
struct ClassificationQuery {};

/// The kinds that a path and its segments are of.
struct ClassificationAnswer {
  NamedPath path;                     ///< as asked
  PathClassification classification;  ///< with witnesses
};

/// Throws as classify().
PHRAME_API ClassificationAnswer answer(const NamedPath& path, const ClassificationQuery& query);

}  // namespace phrame
