#pragma once
#include <vector>

#include "phrame/ph/along/speed_limit.hpp"

namespace phrame::inline v0 {

/// A part of a segment on which one limit is the least, or of the path on which w is linear.
struct SpeedSpan {
  std::optional<SpeedLimit> limit;
  std::size_t segment = 0;
  Real t0 = Rational(0);
  Real t1 = Rational(0);
  Real s0 = Rational(0);
  Real s1 = Rational(0);
  SquaredSpeed w0 = {Rational(0)};  ///< w at s0 and at s1
  SquaredSpeed w1 = {Rational(0)};
  int rise = -1;       ///< the sign of w′ − 2A inside
  int fall = 1;        ///< that of w′ + 2A
  bool jumps = false;  ///< may w jump at s0?
  bool stops = false;  ///< has the motion to stop there?
};
using SpeedSpans = std::vector<SpeedSpan>;

/// The least limit all along, in parts on each of which one limit is it and, where there is a
/// tangential one, B′ ± 2A have no zero. Throws as SpeedProfile. Precondition: V is in pieces.
SpeedSpans least_limits(const Path& path, const PathLength& length, const Feedrate& feedrate,
                        const SpeedLimits& limits);

/// The greatest w below that with |w′| ≤ 2A, A the tangential limit, and the speeds that are given
/// at the ends. Throws likewise.
SpeedSpans with_bounded_slope(const SpeedSpans& spans, const SpeedLimits& limits,
                              const PathLength& length, const Feedrate::Limits& of);

}  // namespace phrame
