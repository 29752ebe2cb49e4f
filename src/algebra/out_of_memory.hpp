#pragma once
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// From now on GMP, MPFR, FLINT and Arb throw std::bad_alloc instead of ending the process when
/// memory runs out, and std::runtime_error instead of ending it for any other reason. Because this
/// sets functions of these libraries for the whole process, programs call it, never the library
/// itself; once, while no other thread uses them. Memory that they hold when they throw is lost,
/// and what they keep for later use is dropped, since it may be half made. A little memory is held
/// back, so that destructors can run.
PHRAME_API void throw_when_out_of_memory();
/// To be called first in every other thread: makes at once what these libraries, and exceptions,
/// keep for each thread. If the C library found no memory for that later, it would end the process.
PHRAME_API void prepare_thread();

}  // namespace phrame
