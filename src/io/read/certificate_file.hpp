#pragma once
#include <variant>

#include "phrame/export.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/proof/certificate.hpp"
#include "phrame/ph/proof/integral_certificate.hpp"

namespace phrame::inline v0 {

/// What is refused because it would take too long.
struct CertificateLimits {
  CurveLimits curve = {};  ///< of its curve
  bool is_limited = true;  ///< are those refused that may take more work than the page says?
};

/// A certificate, and what it calls its curve.
struct NamedCertificate {
  std::string name;         ///< of the curve; may be empty
  Certificate certificate;  ///< true or not
};

/// That of a path.
struct NamedPathCertificate {
  std::string name;             ///< of the path; may be empty
  PathCertificate certificate;  ///< true or not
};

/// That of an angle or a length along curves of other kinds.
struct NamedIntegralCertificate {
  std::string name;                 ///< of the path; may be empty
  IntegralCertificate certificate;  ///< true or not
};

/// That of any of these.
using NamedAnyCertificate =
    std::variant<NamedCertificate, NamedPathCertificate, NamedIntegralCertificate>;

/// The same certificate, of a curve by formulas with these in the form in which a certificate has
/// them. Throws DomainError where there is none.
PHRAME_API IntegralCertificate with_canonical_formulas(IntegralCertificate certificate);

/// Reads a certificate/1, path-certificate/1 or integral-certificate/1 file (docs/certificate.md),
/// true or not. Throws InputError as read_curve.
PHRAME_API NamedAnyCertificate read_any_certificate(std::string_view text,
                                                    const CertificateLimits& limits = {});
/// The same of a curve, a certificate/1.
PHRAME_API NamedCertificate read_certificate(std::string_view text,
                                             const CertificateLimits& limits = {});

}  // namespace phrame
