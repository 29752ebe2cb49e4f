#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace phrame::inline v0 {

// Several doubles at once, by vector instructions of the processor that is found when the program
// runs. Nothing here may be rounded otherwise than by one double after the other.

/// n doubles, 2, 4 or 8, with the operations of doubles on each.
template <std::size_t n>
using Wide [[gnu::vector_size(n * sizeof(double))]] = double;

/// How many doubles a T is.
template <class T>
inline constexpr std::size_t lanes = sizeof(T) / sizeof(double);

/// Of a comparison of Wide<n>: is it true for all?
template <class Comparison>
[[gnu::always_inline]] inline bool is_true(const Comparison& which) {
  std::int64_t each[lanes<Comparison>];
  std::memcpy(each, &which, sizeof(which));
  std::int64_t all = -1;
  for (const std::int64_t one : each) all &= one;
  return all != 0;
}

#if defined(__x86_64__)
/// The greatest n that this processor computes with at once; where it is more than two, also with
/// fused multiplication and addition.
inline std::size_t widest() {
  const bool fuses = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool takes_eight = __builtin_cpu_supports("avx512f") &&
                           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return !fuses ? 2 : takes_eight ? 8 : 4;
}

template <class Work>
[[gnu::target("avx2,fma")]] void run_with_four(const Work& work) {
  work.template run<Wide<4>>();
}

template <class Work>
[[gnu::target("avx2,fma,avx512f,avx512dq,avx512vl")]] void run_with_eight(const Work& work) {
  work.template run<Wide<8>>();
}

/// work.run<Wide<n>>(), compiled for processors that compute with n at once, n ≤ widest(). What it
/// calls must be inlined to be compiled so, too.
template <class Work>
void run_wide(std::size_t n, const Work& work) {
  if (n == 8) return run_with_eight(work);
  if (n == 4) return run_with_four(work);
  work.template run<Wide<2>>();
}
#else
inline std::size_t widest() { return 2; }

template <class Work>
void run_wide(std::size_t, const Work& work) {
  work.template run<Wide<2>>();
}
#endif

}  // namespace phrame
