#pragma once
#include <string>
#include <variant>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/proof/certificate.hpp"

namespace phrame::inline v0 {

/// What is asked of a path that is closed with a continuous tangent.
struct ClosedQuery {
  bool holonomy = false;  ///< PathAngle::holonomy()
  bool writhe = false;    ///< writhe(), with all crossings that a projection shows
};

/// The certificate of θ(t), correctly rounded to `digits` ≥ 1 significant digits, at each t on the
/// path, and likewise of what is asked of a closed one. The same on every machine. Throws
/// DomainError for a t that is not on it, for a path that is not closed and for the writhe of one
/// with corners; Undecided where the sums are not told with some hundred more digits, and where
/// none of a few projections tells the crossings.
PHRAME_API PathCertificate certify(const PhPath& path, const std::vector<Rational>& at, long digits,
                                   const ClosedQuery& closed = {});

/// Decides every statement: those of the segments, as verify() of a certificate does, that each
/// begins where the one before ends, with its Euler–Rodrigues frame, which the least rotation
/// carries through a corner, and the sums.
PHRAME_API std::vector<Statement> verify(const PathCertificate& certificate);

/// The path of the segments, where its joints are those that verify() wants; else in words why not.
PHRAME_API std::variant<Path, std::string> path_of(const PathCertificate& certificate);

}  // namespace phrame
