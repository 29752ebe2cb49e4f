#pragma once
#include "phrame/ph/offset/gauge.hpp"
#include "support/random.hpp"

namespace phrame::inline v0::test {

/// (x, y)/w in the plane z = 0.
inline Path plane_path(const Polynomial& x, const Polynomial& y, const Polynomial& w) {
  return Path(Segment(RationalCurve({x, y, {}}, w)));
}

/// (cos θ, sin θ)/(1 + a·cos 2kθ), φ = tan ½θ, k = 1 or 2. With r = 1/u its curvature has the sign
/// of u + u″: it is convex where (4k² − 1)|a| < 1.
inline Path oval(const Rational& a, long k = 1) {
  const Polynomial c{1, 0, -1};
  const Polynomial s{0, 2};
  const Polynomial one{1, 0, 1};
  const Polynomial twice = c * c - s * s;  // (1 + φ²)²·cos 2θ
  if (k == 1) return plane_path(c * one, s * one, one * one + a * twice);
  const Polynomial four = Rational(2) * twice * twice - pow(one, 4);
  return plane_path(c * pow(one, 3), s * pow(one, 3), pow(one, 4) + a * four);
}

/// The unit circle under (x, y) ↦ (ax + by, cx + dy).
inline Path ellipse(const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
  const Polynomial x{1, 0, -1};
  const Polynomial y{0, 2};
  return plane_path(a * x + b * y, c * x + d * y, {1, 0, 1});
}
inline Path unit_circle() { return ellipse(1, 0, 0, 1); }

}  // namespace phrame::test
