#include "phrame/ph/construct/quintic_family.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/curve/scale.hpp"

// With m(Δ) = S(A₀, A₂) = a cos Δ + b sin Δ: 120·length = |c| + 15(s₀ + s₁) − 10g cos Δ, for
// A₀·A₂ = g cos Δ and |B|² = |c|. By |H(P, B)|² = ½(|P|²|B|² + S(P, P)·c) the least
// |5P − B|², P = A₀ + A₂, over φ is 25|P|² + |c| − 10|H(P, B)|: it is that of 4|A₀ − 2A₁ + A₂|²,
// and taken for H(P, B) ≥ 0, that is φ = 0.

namespace phrame::inline v0 {
namespace {

constexpr double straight_angle = std::numbers::pi;

double size(const Vector<double>& v) { return std::sqrt(dot(v, v)); }

ComplexOf<double> unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

// So that nobody's libm decides the result, and 0, ±π/2 and π, which keep planes, are met.
Angle rounded_angle(double x) {
  constexpr long angle_bits = 20;
  const double half_turns = std::remainder(x / straight_angle, 2.0);
  if (!std::isfinite(half_turns)) return Angle();
  const double steps = std::nearbyint(std::ldexp(half_turns, angle_bits));
  return Angle(exact_rational(std::ldexp(steps, -angle_bits)), 0);
}

// Found among equal steps, then by halving where f falls and rises.
double minimising_angle(const std::function<double(double)>& f) {
  constexpr int steps = 64;
  constexpr double step = 2 * straight_angle / steps;
  const auto at = [&](double x) {
    const double value = f(x);
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  std::array<double, steps> value;
  for (int k = 0; k < steps; ++k)
    value[static_cast<std::size_t>(k)] = at(step * k - straight_angle);
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < steps; ++k) {
    const auto v = [&](int j) { return value[static_cast<std::size_t>((j + steps) % steps)]; };
    if (v(k) > v(k - 1) || v(k) > v(k + 1)) continue;
    // Golden section; what is left is below the rounding to 20 bits.
    constexpr double ratio = 0.6180339887498949;
    double low = step * (k - 1) - straight_angle;
    double high = step * (k + 1) - straight_angle;
    double x = high - ratio * (high - low);
    double y = low + ratio * (high - low);
    double at_x = at(x);
    double at_y = at(y);
    while (high - low > 1e-7) {
      if (at_x <= at_y) {
        high = y;
        y = x;
        at_y = at_x;
        at_x = at(x = high - ratio * (high - low));
      } else {
        low = x;
        x = y;
        at_x = at_y;
        at_y = at(y = low + ratio * (high - low));
      }
    }
    const double middle = (low + high) / 2;
    const double found = std::min(at(middle), v(k));
    if (found < least) {
      least = found;
      best = v(k) <= found ? step * k - straight_angle : middle;
    }
  }
  return best;
}

QuinticFamily::QuinticFamily(const HermiteData<double>& data)
    : data_(data),
      a0_(preimage(data.d0)),
      a2_(preimage(data.d1)),
      s0_(size(data.d0)),
      s1_(size(data.d1)) {
  const double least = antiparallel * std::sqrt(s0_ * s1_);
  a2_ = turned(a2_, conjugate(direction_of(hermitian_product(a0_, a2_), least)));
  g_ = hermitian_product(a0_, a2_).re;
  a_ = symmetric_product(a0_, a2_);
  b_ = symmetric_product(a0_, turned(a2_, ComplexOf<double>{0, 1}));
}

Vector<double> QuinticFamily::c(double delta) const {
  const Vector<double> m = std::cos(delta) * a_ + std::sin(delta) * b_;
  return 120.0 * data_.step - 15.0 * (data_.d0 + data_.d1) + 10.0 * m;
}

double QuinticFamily::length(double delta) const {
  return (size(c(delta)) + 15 * (s0_ + s1_) - 10 * g_ * std::cos(delta)) / 120;
}

double QuinticFamily::distance_from_cubic(double delta) const {
  const Vector<double> target = c(delta);
  const Vector<double> m = std::cos(delta) * a_ + std::sin(delta) * b_;
  const double p = s0_ + s1_ + 2 * g_ * std::cos(delta);
  const double b = size(target);
  const double h = (p * b + dot(data_.d0 + data_.d1 + 2.0 * m, target)) / 2;
  return 25 * p + b - 10 * std::sqrt(std::max(h, 0.0));
}

// 3·step − d₀ − d₁ is the middle leg of the cubic's hodograph, three times; of a PH cubic it is
// S(A₀, A₂) itself. a ⊥ b.
double QuinticFamily::cc_angle() const {
  const Vector<double> middle = 3.0 * data_.step - data_.d0 - data_.d1;
  const double aa = dot(a_, a_);
  const double bb = dot(b_, b_);
  return std::atan2(bb > 0 ? dot(middle, b_) / bb : 0.0, aa > 0 ? dot(middle, a_) / aa : 0.0);
}

QuinticFamily::Member QuinticFamily::member(double delta, double phi) const {
  const Quaternion<double> a2 = turned(a2_, unit(delta));
  const Quaternion<double> sum = a0_ + a2;
  Quaternion<double> b = preimage(c(delta));
  // The two terms of the sum may cancel: where Δ is a half turn and d₀ = d₁.
  const double least = antiparallel * (std::sqrt(s0_) + std::sqrt(s1_)) * std::sqrt(norm(b));
  b = turned(turned(b, conjugate(direction_of(hermitian_product(sum, b), least))), unit(phi));
  return {a0_, 0.25 * (b - 3.0 * sum), a2};
}

// Newton's method with differences for the derivatives, the Hessian made positive definite by a
// multiple of the identity where it is not; steps halved until E falls.
double QuinticFamily::of_least_energy(double delta, double& phi) const {
  constexpr double h = 1e-3;
  const auto energy = [&](double x, double y) { return approximate_energy(member(x, y)); };
  double here = energy(delta, phi);
  for (int pass = 0; pass < 40 && std::isfinite(here); ++pass) {
    const double right = energy(delta + h, phi);
    const double left = energy(delta - h, phi);
    const double up = energy(delta, phi + h);
    const double down = energy(delta, phi - h);
    const double corner = energy(delta + h, phi + h) + energy(delta - h, phi - h);
    const double x = (right - left) / (2 * h);
    const double y = (up - down) / (2 * h);
    const double xx = (right - 2 * here + left) / (h * h);
    const double yy = (up - 2 * here + down) / (h * h);
    const double xy = (corner + 2 * here - right - left - up - down) / (2 * h * h);
    const double middle = (xx + yy) / 2;
    const double half = std::hypot((xx - yy) / 2, xy);  // the eigenvalues are middle ± half
    const double least = middle - half;
    const double floor = 0.01 * (std::abs(middle) + half);
    const double shift = std::max(0.0, floor - least);
    const double determinant = (xx + shift) * (yy + shift) - xy * xy;
    double dx = -((yy + shift) * x - xy * y) / determinant;
    double dy = -((xx + shift) * y - xy * x) / determinant;
    if (const double far = std::hypot(dx, dy); far > 0.5) dx *= 0.5 / far, dy *= 0.5 / far;
    double next = energy(delta + dx, phi + dy);
    for (int k = 0; k < 24 && !(next < here); ++k)
      next = energy(delta + (dx /= 2), phi + (dy /= 2));
    if (!(next < here)) break;
    const bool is_done = here - next < 1e-11 * here;
    delta += dx;
    phi += dy;
    here = next;
    if (is_done) break;
  }
  return delta;
}

FreeAngles QuinticFamily::choose(QuinticSelection selection) const {
  const auto at = [](double delta, double phi = 0) {
    return FreeAngles{rounded_angle(delta), rounded_angle(phi)};
  };
  if (s0_ == 0 || s1_ == 0) return at(0);  // then Δ changes nothing
  switch (selection) {
    case QuinticSelection::minimal:
      return at(0);
    case QuinticSelection::bv:
      return at(minimising_angle([&](double x) { return distance_from_cubic(x); }));
    case QuinticSelection::cc:
      return at(cc_angle());
    case QuinticSelection::shortest:
      return at(minimising_angle([&](double x) { return length(x); }));
    case QuinticSelection::longest:
      return at(minimising_angle([&](double x) { return -length(x); }));
    case QuinticSelection::automatic:
    case QuinticSelection::energy:
      break;
  }
  double best = 0;
  double least = approximate_energy(member(0, 0));
  for (const double delta :
       {minimising_angle([&](double x) { return distance_from_cubic(x); }), cc_angle()})
    if (const double energy = approximate_energy(member(delta, 0)); energy < least) {
      best = delta;
      least = energy;
    }
  if (selection == QuinticSelection::automatic) return at(best);
  double phi = 0;
  const double delta = of_least_energy(best, phi);
  return at(delta, phi);
}

// The solution with α > 0 is preimage(d) over the direction of its α; the i that all three have
// too much is no change.
FreeAngles QuinticFamily::angles(const SolutionAngles& given) const {
  const auto solution = [](const Vector<double>& d, double phi, const char* name) {
    const Quaternion<double> a = preimage(d);
    const double alpha = std::hypot(a.u, a.v);
    if (alpha <= 0x1p-50 * std::sqrt(norm(a)))
      throw DomainError(std::string("the angles phi0, phi1, phi2: ") + name +
                        " has the direction (-1, 0, 0), where they mean nothing");
    return turned(turned(a, ComplexOf<double>{a.u / alpha, -a.v / alpha}), unit(phi));
  };
  const auto argument = [](const ComplexOf<double>& z) { return std::atan2(z.im, z.re); };
  const Quaternion<double> a0 = solution(data_.d0, given.phi0, "the derivative at the start");
  const Quaternion<double> a2 = solution(data_.d1, given.phi2, "the derivative at the end");
  const Vector<double> target =
      120.0 * data_.step - 15.0 * (data_.d0 + data_.d1) + 10.0 * symmetric_product(a0, a2);
  const Quaternion<double> b = solution(target, given.phi1, "the middle");
  return {Angle(exact_rational(argument(hermitian_product(a0, a2)))),
          Angle(exact_rational(argument(hermitian_product(a0 + a2, b))))};
}

QuinticFamily quintic_family(const HermiteSpline& data, std::size_t k) {
  const Rational h = data.step(k);
  const Vector<Rational> step = (1 / h) * (data.points[k + 1] - data.points[k]);
  const Vector<Rational>& d0 = data.derivatives[k];
  const Vector<Rational>& d1 = data.derivatives[k + 1];
  const Rational scale = scale_for_doubles(std::max({largest(step), largest(d0), largest(d1)}));
  return QuinticFamily(
      {scaled_to_doubles(scale, step), scaled_to_doubles(scale, d0), scaled_to_doubles(scale, d1)});
}

}  // namespace phrame
