#pragma once
#include <string>

#include "phrame/export.hpp"
#include "phrame/ph/curve/nearness.hpp"
#include "phrame/ph/proof/certificate.hpp"
#include "phrame/ph/proof/integral_certificate.hpp"

namespace phrame::inline v0 {

/// A certificate/1 file (docs/certificate.md). `name` is that of the curve and may be empty; `near`
/// is told in a note where the curve stands for another.
PHRAME_API std::string write_certificate(const Certificate& certificate, const std::string& name,
                                         const std::optional<Nearness>& near = {});
/// @{ A path-certificate/1 and an integral-certificate/1 file.
PHRAME_API std::string write_certificate(const PathCertificate& certificate,
                                         const std::string& name);
PHRAME_API std::string write_certificate(const IntegralCertificate& certificate,
                                         const std::string& name);
/// @}

}  // namespace phrame
