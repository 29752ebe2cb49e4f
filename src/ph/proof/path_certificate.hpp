#pragma once
#include <string>
#include <variant>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/proof/certificate.hpp"

namespace phrame::inline v0 {

/// The certificate of θ(t), correctly rounded to `digits` ≥ 1 significant digits, at each t on the
/// path. The same on every machine. Throws DomainError for a path with corners and for a t that is
/// not on it, Undecided where the sums are not told with some hundred more digits.
PHRAME_API PathCertificate certify(const PhPath& path, const std::vector<Rational>& at,
                                   long digits);

/// Decides every statement: those of the segments, as verify() of a certificate does, that each
/// begins where the one before ends, with its Euler–Rodrigues frame, and the sums.
PHRAME_API std::vector<Statement> verify(const PathCertificate& certificate);

/// The path of the segments, where its joints are those that verify() wants; else in words why not.
PHRAME_API std::variant<Path, std::string> path_of(const PathCertificate& certificate);

}  // namespace phrame
