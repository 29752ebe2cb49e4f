#pragma once
// Polynomials of FLINT in several unknowns. By itself, as these headers are long and one file needs
// them.
#include "phrame/algebra/flint.hpp"

#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_mpoly_factor.h>
