#pragma once
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/proof/classify.hpp"

namespace phrame {

/// Of which kinds is a curve?
struct ClassificationQuery {};

struct ClassificationAnswer {
  NamedCurve curve;
  Classification classification;
};

ClassificationAnswer answer(const NamedCurve& curve, const ClassificationQuery& query);

}  // namespace phrame
