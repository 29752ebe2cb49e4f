#include "phrame/algebra/flint.hpp"

#include <mpfr.h>

namespace phrame::inline v0 {

void release_caches() {
  flint_cleanup_master();
  mpfr_free_cache();
}

}  // namespace phrame
