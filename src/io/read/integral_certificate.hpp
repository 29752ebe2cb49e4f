#pragma once
#include "phrame/io/read/certificate_file.hpp"
#include "phrame/io/read/certificate_node.hpp"

namespace phrame::inline v0 {

/// An integral-certificate/1.
NamedIntegralCertificate read_integral_certificate(const JsonNode& node, const CurveLimits& limits,
                                                   WorkLimit& limit);

}  // namespace phrame
