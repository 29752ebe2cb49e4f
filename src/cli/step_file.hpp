#pragma once
#include <string>

#include "phrame/answer/rational_sweep.hpp"

namespace phrame::inline v0::cli {

/// The solid as a STEP file, by the library phrame_step, which is looked for when it is called for
/// the first time. Throws InputError where it is not there, or what it needs, and DomainError where
/// it makes no solid.
std::string to_step(const RationalSweepAnswer& answer);

}  // namespace phrame::cli
