#include "phrame/ph/construct/quintic_spline.hpp"

#include <algorithm>
#include <limits>

#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/exact_end.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/construct/spline_builder.hpp"
#include "phrame/ph/curve/scale.hpp"

// Continuity is linear in the preimage, interpolation quadratic. So the coefficients of A are
// rounded to multiples of δ = 2^−p, those at a joint once for both neighbours, and continuity is
// exact; and each segment aims at its end from where it does start, on the exact curve, so that
// deviations do not add up. With Q_k the coefficient at point k, K = 15(S(A₀, A₀) + S(A₂, A₂)) −
// 10·S(A₀, A₂), c = (120/h)(p_{k+1} − r_k) − K exact, B near a solution of B i B* = c,
// A₁ = round((B − 3A₀ − 3A₂)/4) and B̃ = 3A₀ + 4A₁ + 3A₂:
//   r_{k+1} = r_k + h/120·(S(B̃, B̃) + K),
//   |r_{k+1} − p_{k+1}| = h/120·|S(B̃, B̃) − c| ≤ h/120·(2√|c| + 4δ)·4δ,
//   |S(Q_k, Q_k) − d_k| ≤ (2|Q_k| + δ)·δ,
// whatever k is: p grows until both are within the tolerance, which is tested in fractions.
// The coefficients are integers times δ; r_k is r_0 and multiples of h/(120·4^p).
//
// Where frames are given, by integer quaternions P_k, Q_k is P_k·w_k with a w_k ∈ ℤ[i] times δ:
// Q i Q* = |w|²·P i P* has its direction exactly, and e₂ = Q j Q*/|Q|² is P j P*/|P|² turned by
// −2 arg w, the argument of a number in ℚ(i).

namespace phrame::inline v0 {
namespace {

class Chain {
 public:
  /// With multiples of 2^−p, which need so many bits.
  Chain(const HermiteSpline& data, const std::vector<FreeAngles>& angles, long p, long bits,
        const Deviation& tolerance)
      : data_(data), angles_(angles), p_(p), bits_(bits), meter_(tolerance) {}

  PreimageSpline run();

 private:
  void add(std::size_t k);
  IntegerQuaternion rounded(const FloatQuaternion& a, std::size_t k) const;
  FloatQuaternion preimage_at(std::size_t k) const {
    return preimage(big_floats(data_.derivatives[k], bits_));
  }

  const HermiteSpline& data_;
  const std::vector<FreeAngles>& angles_;
  long p_;
  long bits_;
  Rational step_ = power_of_two(-p_);
  DeviationMeter meter_;
  std::vector<PreimageSpline::Segment> segments_;
  Vector<Rational> end_;
  FloatQuaternion a0_;   ///< a preimage of the derivative at the last joint, …
  Phase turn_;           ///< … by which it is turned to be that of the spline …
  IntegerQuaternion q_;  ///< … and rounded
  IntegerQuaternion first_;
};

/// 2ᵖ·a, the coefficient at point k, to integers.
IntegerQuaternion Chain::rounded(const FloatQuaternion& a, std::size_t k) const {
  if (data_.frames.empty()) return rounded_multiple(a, p_);
  const IntegerQuaternion& frame = data_.frames[k];
  const FloatQuaternion back =
      big_floats(exact(conjugate(frame), Rational(1) / norm(frame)), bits_) * a;
  return frame * IntegerQuaternion{back.u.scaled(p_), back.v.scaled(p_), 0, 0};
}

PreimageSpline Chain::run() {
  a0_ = preimage_at(0);
  turn_ = {BigFloat(1.0), BigFloat(0.0)};
  first_ = q_ = rounded(a0_, 0);
  end_ = data_.points.front();
  meter_.derivative(exact(rotated_i(q_), step_ * step_) - data_.derivatives.front());
  for (std::size_t k = 0; k < data_.segments(); ++k) add(k);
  return {std::move(segments_), 1, p_, meter_.deviation()};
}

void Chain::add(std::size_t k) {
  const Rational h = data_.step(k);
  // A₂ beside A₀, both of them before they are turned.
  const FloatQuaternion a2_as_is = preimage_at(k + 1);
  const Phase z = turn_to(a0_, a2_as_is) * phase_of(angles_[k].delta, bits_);
  const FloatQuaternion a2 = turned(a2_as_is, z);
  const Phase next_turn = z * turn_;
  // The last Q of a closed spline is the first one times a z/n with |z| = n: then all is n times as
  // fine here.
  Integer n = 1;
  IntegerQuaternion q;
  if (data_.is_closed && k + 1 == data_.segments()) {
    const GaussianInteger closing = short_direction(next_turn);
    n = sqrt(norm(closing));
    q = turned(first_, closing);
  } else {
    q = rounded(turned(a2, turn_), k + 1);
  }
  const IntegerQuaternion q0 = n * q_;
  const Rational step = step_ / Rational(n);
  const Rational step2 = step * step;

  const Vector<Integer> known = integral_of_ends(q0, q);
  const Vector<Rational> c = (120 / h) * (data_.points[k + 1] - end_) - exact(known, step2);
  const FloatQuaternion b_as_is = preimage(big_floats(c, bits_));
  const Phase w = turn_to(a0_ + a2, b_as_is, sqrt(norm(a0_)) + sqrt(norm(a2))) *
                  phase_of(angles_[k].phi, bits_) * turn_;
  const FloatQuaternion ends = big_floats(exact(q0 + q, step), bits_);
  const IntegerQuaternion a1 =
      n * rounded_multiple(BigFloat(0.25) * (turned(b_as_is, w) - BigFloat(3.0) * ends), p_);

  segments_.push_back({{exact(q0, step), exact(a1, step), exact(q, step)}, h, end_});
  end_ = end_ + exact(integral_times_120(q0, a1, q), h * step2 / 120);
  meter_.point(end_ - data_.points[k + 1]);
  meter_.derivative(exact(rotated_i(q), step2) - data_.derivatives[k + 1]);
  a0_ = a2_as_is;
  turn_ = next_turn;
  q_ = q;
}

/// 2^e above √x.
long exponent_of_root(const Rational& x) { return binary_exponent(x) / 2 + 1; }

/// A first p, about that which the bounds above ask for; and such that the preimages of small
/// derivatives, too, have some bits, for they say where the curve goes.
long first_bits(const HermiteSpline& data, const Deviation& tolerance) {
  long bits = std::numeric_limits<long>::min();
  const auto want = [&](long e) { bits = std::max(bits, e); };
  if (const Rational size = size_of_derivatives(data); size != 0)
    want(exponent_of_root(size) + 2 - binary_exponent(tolerance.derivatives));
  constexpr long least_bits = 20;
  for (const Vector<Rational>& d : data.derivatives)
    if (const Rational size = largest(d); size != 0) want(least_bits - exponent_of_root(size));
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const Rational h = data.step(k);
    const Rational c = std::max({120 / h * largest(data.points[k + 1] - data.points[k]),
                                 Rational(20 * largest(data.derivatives[k])),
                                 Rational(20 * largest(data.derivatives[k + 1]))});
    want(exponent_of_root(c) + binary_exponent(h) - 3 - binary_exponent(tolerance.points));
  }
  // What is rounded where frames are given is smaller by their size.
  Integer size = 1;
  for (const IntegerQuaternion& frame : data.frames) size = std::max(size, norm(frame));
  return bits + exponent_of_root(size) - 1;
}

/// The bits of the numbers that are rounded to multiples of 2^−p, and more.
long working_bits(const HermiteSpline& data, long p) {
  Rational size = size_of_derivatives(data);
  for (std::size_t k = 0; k < data.segments(); ++k)
    size = std::max(size, Rational(largest(data.points[k + 1] - data.points[k]) / data.step(k)));
  return std::max(p + exponent_of_root(size), 0L) + 96;
}

/// In halves those segments that have to end in a point exactly: all, or the last one of a closed
/// spline.
Construction construction_of(const PreimageSpline& found, const HermiteSpline& data,
                             const std::vector<FreeAngles>& angles, PointRule rule) {
  const auto parts = [&](const BernsteinPreimage& a, const Vector<Rational>& integral) {
    return listed(exact_halves(QuadraticPreimage{a[0], a[1], a[2]}, integral, found.bits));
  };
  const std::size_t last = data.segments() - 1;
  Construction result = construction_of(found, {parts, last}, data, rule);
  for (std::size_t k = 0; k <= last; ++k) {
    const bool is_divided = rule == PointRule::exact || (data.is_closed && k == last);
    result.angles.insert(result.angles.end(), is_divided ? 2 : 1, angles[k]);
  }
  return result;
}

}  // namespace

Construction quintic_spline(const HermiteSpline& data, const QuinticChoice& choice,
                            const Deviation& tolerance, PointRule rule) {
  const auto chosen = [&](std::size_t k) {
    if (const auto* angles = std::get_if<FreeAngles>(&choice)) return *angles;
    const QuinticFamily family = quintic_family(data, k);
    if (const auto* given = std::get_if<SolutionAngles>(&choice)) return family.angles(*given);
    return family.choose(std::get<QuinticSelection>(choice));
  };
  std::vector<FreeAngles> angles;
  Stage stage("segments", data.segments());
  for (std::size_t k = 0; k < data.segments(); ++k, stage.advance()) angles.push_back(chosen(k));
  return quintic_spline(data, angles, tolerance, rule);
}

Construction quintic_spline(const HermiteSpline& data, const std::vector<FreeAngles>& angles,
                            const Deviation& tolerance, PointRule rule) {
  require_regular(data);
  for (long p = first_bits(data, tolerance);; p += 8) {
    const PreimageSpline found = Chain(data, angles, p, working_bits(data, p), tolerance).run();
    if (is_within(found.deviation, tolerance)) return construction_of(found, data, angles, rule);
  }
}

}  // namespace phrame
