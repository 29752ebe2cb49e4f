#pragma once
#include <vector>

#include "phrame/algebra/integer.hpp"

namespace phrame::inline v0 {

/// Rows of integers, all of one length.
using IntegerRows = std::vector<std::vector<Integer>>;

/// @{ A basis of the same lattice, of short vectors, of which the first one is the shortest or not
/// much longer [Lenstra, Lenstra, Lovász 1982]; and how it is made of the rows given, which takes
/// longer. These are linearly independent, at least one.
IntegerRows reduced_basis(const IntegerRows& basis);
struct ReducedBasis {
  IntegerRows rows;
  IntegerRows transform;  ///< rows = transform·(the basis that was given)
};
ReducedBasis reduced_basis_with_transform(const IntegerRows& basis);
/// @}

}  // namespace phrame
