#pragma once
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// From now on GMP, MPFR, FLINT and Arb throw std::bad_alloc where they would end the process for
/// want of memory, and std::runtime_error for what else they would end it for. The functions of
/// these libraries are set for the whole process, so that it is the program that calls this, not
/// the library; once, while no other thread uses them. What they held at that moment is lost; what
/// they keep for later use is dropped, since it may be half made. A little memory is kept back, for
/// destructors to have some.
PHRAME_API void throw_when_out_of_memory();
/// Of another thread, as it begins: it has then what these libraries and exceptions keep for each
/// thread. Where the C library finds no memory for that later, it ends the process.
PHRAME_API void prepare_thread();

}  // namespace phrame
