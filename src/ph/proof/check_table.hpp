#pragma once
#include <string>
#include <vector>

#include "phrame/ph/proof/certificate.hpp"
#include "phrame/ph/proof/integral_certificate.hpp"

namespace phrame::inline v0 {

/// t, x, y, z, e1x, …, f3z: the columns of a table of frames, as a certificate can prove them.
const std::vector<std::string>& certified_columns();

/// Are the rows r, e₁, f₂, f₃ at the t of the claims, each number the double next to the exact one?
/// Else why that is not proved. The frame starts by the least rotation of the x axis to e₁. As
/// docs/certificate.md wants it, the numbers are to follow from the angles and radii of the claims;
/// here they are computed anew, and allowed 3 times the radius. Each row has a number a column.
std::string objection_to_table(const Certificate& c,
                               const std::vector<std::vector<Rational>>& rows);
/// @{ The same of a path, and of any curves by angles to the frame of a vector that is nowhere
/// along their tangents.
std::string objection_to_table(const PathCertificate& c,
                               const std::vector<std::vector<Rational>>& rows);
std::string objection_to_table(const IntegralCertificate& c,
                               const std::vector<std::vector<Rational>>& rows);
/// @}

}  // namespace phrame
