#pragma once
#include "phrame/export.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/proof/certificate.hpp"

namespace phrame {

/// Reads a certificate/1 file (docs/certificate.md), true or not. Throws InputError as read_curve;
/// `limits` are those of its curve.
PHRAME_API Certificate read_certificate(std::string_view text, const CurveLimits& limits = {});

}  // namespace phrame
