#pragma once
#include <string>

#include "phrame/ph/proof/certificate.hpp"

namespace phrame {

/// A certificate/1 file (docs/certificate.md). `name` is that of the curve and may be empty.
std::string write_certificate(const Certificate& certificate, const std::string& name);

}  // namespace phrame
