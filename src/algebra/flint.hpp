#pragma once
// The only place that includes FLINT and Arb, and the only one that knows which version it is:
// up to 2.9 Arb is a library of its own, from 3.0 on it is part of FLINT.
#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz.h>
#include <flint/fmpz_factor.h>
#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
#include <flint/fmpz_vec.h>
#include <flint/nmod_mat.h>
#include <flint/nmod_poly.h>
#include <flint/nmod_vec.h>
#include <flint/ulong_extras.h>

#if __FLINT_VERSION >= 3
#include <flint/acb.h>
#include <flint/acb_calc.h>
#include <flint/acb_poly.h>
#include <flint/arb.h>
#include <flint/arb_fmpz_poly.h>
#include <flint/arb_hypgeom.h>
#include <flint/arb_mat.h>
#include <flint/arb_poly.h>
#include <flint/arf.h>
#include <flint/mag.h>
#include <flint/nmod.h>
#include <flint/nmod_poly_factor.h>
#else
#include <acb.h>
#include <acb_calc.h>
#include <acb_poly.h>
#include <arb.h>
#include <arb_fmpz_poly.h>
#include <arb_hypgeom.h>
#include <arb_mat.h>
#include <arb_poly.h>
#include <arf.h>
#include <mag.h>
#endif

#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// Frees what FLINT, Arb and MPFR keep for later use in this thread, such as digits of π, so that a
/// leak checker finds nothing. Call it when no number of phrame exists any more.
PHRAME_API void release_caches();

}  // namespace phrame
