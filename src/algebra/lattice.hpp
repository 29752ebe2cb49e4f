#pragma once
#include <vector>

#include "phrame/algebra/integer.hpp"

namespace phrame::inline v0 {

/// Rows of integers, all of one length.
using IntegerRows = std::vector<std::vector<Integer>>;

/// A basis of the same lattice, of short vectors.
struct ReducedBasis {
  IntegerRows rows;
  IntegerRows transform;  ///< rows = transform·(the basis that was given)
};
/// Of linearly independent rows, at least one; the first vector is the shortest or not much longer
/// [Lenstra, Lenstra, Lovász 1982].
ReducedBasis reduced_basis(const IntegerRows& basis);

}  // namespace phrame
