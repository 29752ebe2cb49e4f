#pragma once
#include "phrame/ph/construct/c2_equations.hpp"

namespace phrame::inline v0 {

/// Where the search begins, instead of with the derivatives as they are: with those of chord
/// lengths, each of a speed between those of the chords beside it, the slower one for haste = 0.
/// Where the parameters are far from chord lengths, a cubic spline goes far astray.
std::vector<Vector<double>> calm_derivatives(const C2Data& data, double haste);

/// Preimages of the derivatives, each turned next to the one before; of a closed spline they come
/// back as ± the first, by turning all a little.
std::vector<Quaternion<double>> first_joints(const C2Data& data,
                                             const std::vector<Vector<double>>& derivatives,
                                             double& closing_sign);

}  // namespace phrame
