// GMP allows that its memory functions do not return ("Custom Allocation": what is allocated at
// that time is lost). A C++ exception passes through functions in C where these have tables for
// unwinding, which compilers make for x86-64 and 64-bit ARM unless told otherwise.
//
// Who frees may allocate: FLINT keeps freed numbers in an array that grows. A destructor must not
// throw, so that there is a reserve, which small requests and the growth of arrays are granted when
// there is nothing else; it is taken back before anything else is granted.
#include "phrame/algebra/out_of_memory.hpp"

#include <mpfr.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include "phrame/algebra/flint.hpp"
#include "phrame/algebra/time_limit.hpp"

namespace phrame::inline v0 {
namespace {

constexpr std::size_t reserve_size = std::size_t{1} << 21;
constexpr std::size_t small_size = std::size_t{1} << 12;

std::atomic<void*> reserve = nullptr;

/// Is there memory now that was none before?
bool gives_reserve() noexcept {
  void* const kept = reserve.exchange(nullptr);
  std::free(kept);
  return kept != nullptr;
}

bool takes_reserve() noexcept {
  void* const taken = std::malloc(reserve_size);
  void* none = nullptr;
  if (taken != nullptr && !reserve.compare_exchange_strong(none, taken)) std::free(taken);
  return taken != nullptr;
}

/// π, log 2, free numbers, which the function that is left may have been about to change, are
/// computed again.
[[noreturn]] void fail() {
  gives_reserve();
  flint_cleanup();
  throw std::bad_alloc();
}

/// Looks for the time, too; but not for a few bytes, which constructors that may not throw ask for.
void require_time_for(std::size_t size) {
  constexpr std::size_t few = 16;
  try {
    if (size > few) require_time();
  } catch (const Stopped&) {
    flint_cleanup();
    throw;
  }
}

void require_reserve() {
  if (reserve.load(std::memory_order_relaxed) != nullptr || std::uncaught_exceptions() > 0) return;
  if (!takes_reserve()) fail();
}

void* granted(std::size_t size) {
  require_reserve();
  if (void* const p = std::malloc(size)) return p;
  if (gives_reserve() && size <= small_size)
    if (void* const p = std::malloc(size)) return p;
  fail();
}

void* allocated(std::size_t size) {
  require_time_for(size);
  return granted(size);
}

void* cleared(std::size_t count, std::size_t size) {
  require_time_for(count * size);
  require_reserve();
  if (void* const p = std::calloc(count, size)) return p;
  fail();
}

/// Of destructors, too: not refused while there is the reserve.
void* reallocated(void* old, std::size_t size) {
  do
    if (void* const p = std::realloc(old, size)) return p;
  while (gives_reserve());
  fail();
}

void* gmp_reallocated(void* old, std::size_t, std::size_t size) { return reallocated(old, size); }

/// What GMP has freed last, in this thread. mpz_mul() and others free the digits of a number, note
/// that it has more, and ask for these. Where there are none, the old ones are still the number's,
/// and freed with it. That it has more is false by then, so that a time that is over, unlike want
/// of memory, is no reason to leave GMP: FLINT and Arb ask for memory often enough.
struct LastFreed {
  void* block = nullptr;
  LastFreed() = default;
  LastFreed(const LastFreed&) = delete;
  LastFreed& operator=(const LastFreed&) = delete;
  ~LastFreed() { std::free(block); }
};
thread_local LastFreed last_freed;

void gmp_free(void* p, std::size_t) { std::free(std::exchange(last_freed.block, p)); }

void* gmp_allocated(std::size_t size) {
  void* const freed = std::exchange(last_freed.block, nullptr);
  void* const p = granted(size);  // may throw; what was freed is lost, unless it has an owner
  std::free(freed);
  return p;
}

// For clang not to return is part of the type of a function by this attribute only.
__attribute__((noreturn)) void abandon() {
  throw std::runtime_error("FLINT was asked for what it does not compute");
}

void give_to_new() {
  if (!gives_reserve()) throw std::bad_alloc();
}

}  // namespace

// What fail() needs.
void prepare_thread() {
  [[maybe_unused]] const int pending = std::uncaught_exceptions();
  flint_cleanup();
}

void throw_when_out_of_memory() {
  takes_reserve();
  prepare_thread();
  mpfr_free_cache();
  mp_set_memory_functions(gmp_allocated, gmp_reallocated, gmp_free);
  __flint_set_memory_functions(allocated, cleared, reallocated, std::free);
  flint_set_abort(abandon);
  std::set_new_handler(give_to_new);
}

}  // namespace phrame
