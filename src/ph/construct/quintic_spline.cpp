#include "phrame/ph/construct/quintic_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/exact_end.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/construct/scale.hpp"

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

namespace phrame {
namespace {

struct ExactSegment {
  QuadraticPreimage a;
  Rational h;
  Vector<Rational> start;
};

/// A spline with one rounding.
struct Attempt {
  std::vector<ExactSegment> segments;
  Vector<Rational> end;
  Deviation squared;  ///< the greatest ones
};

class Chain {
 public:
  Chain(const HermiteSpline& data, const std::vector<FreeAngles>& angles, const PreimageGrid& grid,
        const Deviation& tolerance)
      : data_(data), angles_(angles), grid_(grid), tolerance_(tolerance) {}

  Attempt run();

 private:
  void add(std::size_t k);

  const HermiteSpline& data_;
  const std::vector<FreeAngles>& angles_;
  const PreimageGrid& grid_;
  const Deviation& tolerance_;
  Attempt result_;
  Quaternion<BigFloat> a0_;  ///< a preimage of the derivative at the last joint, …
  Phase turn_;               ///< … by which it is turned to be that of the spline …
  IntegerQuaternion q_;      ///< … and rounded
  IntegerQuaternion first_;
};

Attempt Chain::run() {
  a0_ = preimage(grid_.vector(data_.derivatives.front()));
  turn_ = {BigFloat(1.0), BigFloat(0.0)};
  first_ = q_ = grid_.rounded(a0_);
  result_.end = data_.points.front();
  result_.squared.derivatives = squared_above(
      exact(rotated_i(q_), grid_.step2()) - data_.derivatives.front(), tolerance_.derivatives);
  for (std::size_t k = 0; k < data_.segments(); ++k) add(k);
  return std::move(result_);
}

void Chain::add(std::size_t k) {
  const Rational h = data_.step(k);
  const Vector<Rational> r = result_.end;
  // A₂ beside A₀, both of them before they are turned.
  const Quaternion<BigFloat> a2_as_is = preimage(grid_.vector(data_.derivatives[k + 1]));
  const Phase z = turn_to(a0_, a2_as_is) * grid_.phase(angles_[k].delta);
  const Quaternion<BigFloat> a2 = turned(a2_as_is, z);
  const Phase next_turn = z * turn_;
  // The last Q of a closed spline is the first one times a z/n with |z| = n: then all is n times as
  // fine here.
  Integer n = 1;
  IntegerQuaternion q;
  if (data_.is_closed && k + 1 == data_.segments()) {
    const GaussianInteger closing = short_direction(next_turn);
    n = sqrt(norm(closing));
    q = turned(first_, ComplexOf<Integer>{closing.re, closing.im});
  } else {
    q = grid_.rounded(turned(a2, turn_));
  }
  const IntegerQuaternion q0 = n * q_;
  const Rational step = grid_.step() / Rational(n);
  const Rational step2 = step * step;

  const Vector<Integer> known = integral_of_ends(q0, q);
  const Vector<Rational> c = (120 / h) * (data_.points[k + 1] - r) - exact(known, step2);
  const Quaternion<BigFloat> b_as_is = preimage(grid_.vector(c));
  const Phase w = turn_to(a0_ + a2, b_as_is, sqrt(norm(a0_)) + sqrt(norm(a2))) *
                  grid_.phase(angles_[k].phi) * turn_;
  const Quaternion<BigFloat> ends = grid_.quaternion(q0 + q, step);
  const IntegerQuaternion a1 =
      n * grid_.rounded(BigFloat(0.25) * (turned(b_as_is, w) - BigFloat(3.0) * ends));

  const IntegerQuaternion b = Integer(3) * (q0 + q) + Integer(4) * a1;
  result_.segments.push_back({{exact(q0, step), exact(a1, step), exact(q, step)}, h, r});
  result_.end = r + exact(rotated_i(b) + known, h * step2 / 120);
  Deviation& squared = result_.squared;
  squared.points =
      std::max(squared.points, squared_above(result_.end - data_.points[k + 1], tolerance_.points));
  squared.derivatives = std::max(
      squared.derivatives,
      squared_above(exact(rotated_i(q), step2) - data_.derivatives[k + 1], tolerance_.derivatives));
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
  return bits;
}

/// The bits of the numbers that are rounded to multiples of 2^−p, and more.
long working_bits(const HermiteSpline& data, long p) {
  Rational size = size_of_derivatives(data);
  for (std::size_t k = 0; k < data.segments(); ++k)
    size = std::max(size, Rational(largest(data.points[k + 1] - data.points[k]) / data.step(k)));
  return std::max(p + exponent_of_root(size), 0L) + 96;
}

/// The segment in two halves from `start` to `end`, exactly.
std::array<ExactSegment, 2> halves(const ExactSegment& segment, const Vector<Rational>& start,
                                   const Vector<Rational>& end, long bits) {
  const Rational& h = segment.h;
  const auto [first, second] = exact_halves(segment.a, (1 / h) * (end - start), bits);
  const Rational half = h / 2;
  const Vector<Rational> middle =
      start + half / 120 * integral_times_120(first[0], first[1], first[2]);
  return {ExactSegment{first, half, start}, ExactSegment{second, half, middle}};
}

/// With the segments halved that have to end in a point exactly: all, or the last one of a closed
/// spline.
Construction construction_of(const Attempt& attempt, const HermiteSpline& data,
                             const std::vector<FreeAngles>& angles, PointRule rule, long bits,
                             const Deviation& deviation) {
  std::vector<Curve> curves;
  std::vector<Rational> parameters{data.parameters.front()};
  std::vector<FreeAngles> angles_of_curves;
  const auto add = [&](const ExactSegment& segment, std::size_t k) {
    const auto& a = segment.a;
    curves.emplace_back(from_bernstein(std::vector(a.begin(), a.end())), Polynomial{segment.h},
                        segment.start);
    parameters.push_back(parameters.back() + segment.h);
    angles_of_curves.push_back(angles[k]);
  };
  const bool is_exact = rule == PointRule::exact;
  for (std::size_t k = 0; k < attempt.segments.size(); ++k) {
    const ExactSegment& segment = attempt.segments[k];
    const bool is_last = k + 1 == attempt.segments.size();
    if (!is_exact && !(data.is_closed && is_last)) {
      add(segment, k);
      continue;
    }
    const Vector<Rational>& start = is_exact ? data.points[k] : segment.start;
    const auto both =
        of_segment(k, [&] { return halves(segment, start, data.points[k + 1], bits); });
    for (const ExactSegment& half : both) add(half, k);
  }
  return {joined(curves),
          std::move(parameters),
          std::move(angles_of_curves),
          bits,
          {is_exact ? Rational(0) : deviation.points, deviation.derivatives}};
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
    const Attempt found =
        Chain(data, angles, PreimageGrid(p, working_bits(data, p)), tolerance).run();
    const Deviation deviation{square_root_above(found.squared.points),
                              square_root_above(found.squared.derivatives)};
    if (is_within(deviation, tolerance))
      return construction_of(found, data, angles, rule, p, deviation);
  }
}

}  // namespace phrame
