#pragma once
#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/proof/certificate.hpp"

namespace phrame {

/// A certificate/1 file (docs/certificate.md). `name` is that of the curve and may be empty.
std::string write_certificate(const Certificate& certificate, const std::string& name);

/// Reads what write_certificate writes, true or not. Throws InputError as read_curve; `limits` are
/// those of its curve.
Certificate read_certificate(std::string_view text, const CurveLimits& limits = {});

}  // namespace phrame
