#include "phrame/ph/construct/rmf_plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {
namespace {

/// Is b in the direction of a, so nearly that a vector like it which is not is at most `off` away?
bool is_along(const Vector<Rational>& a, const Vector<Rational>& b, const Rational& off) {
  const Vector<Rational> normal = cross(a, b);
  return dot(a, b) > 0 && dot(normal, normal) <= off * off * dot(a, a);
}

/// The data of a septic, from a precision in which nearly parallel tangents have digits of what
/// they differ by.
SepticData septic_data(const HermiteSpline& data, std::size_t k, long bits) {
  const Quaternion<BigFloat> a0 = preimage(big_floats(data.derivatives[k], bits));
  const Quaternion<BigFloat> a3 = preimage(big_floats(data.derivatives[k + 1], bits));
  const BigFloat inverse = BigFloat(1.0) / norm(a0);
  const Vector<BigFloat> step = turned_back(big_floats(mean_derivative(data, k), bits), a0);
  const Quaternion<BigFloat> c = inverse * (conjugate(a0) * turned(a3, turn_to(a0, a3)));
  const BigFloat factor = inverse * inverse;
  const auto times = [&](const BigFloat& x) { return (factor * x).to_double(); };
  return {each(step, times), {std::max(c.u.to_double(), 0.0), 0, c.p.to_double(), c.q.to_double()}};
}

SegmentPlan septic_plan(const HermiteSpline& data, std::size_t k, long bits) {
  const SepticData seen = septic_data(data, k, bits);
  const auto shape = rmf_septic(seen);
  if (!shape)
    throw Undecided(fmt::format(
        "segment {}: no septic with h = 0 was found that has its points and derivatives", k + 1));
  return {SegmentForm::space, SepticSection(seen, *shape), phase_unit(seen)};
}

}  // namespace

RmfPlan rmf_plan(const HermiteSpline& data, const Deviation& tolerance, long bits) {
  const Rational off = tolerance.derivatives / 8;
  const std::size_t n = data.segments();
  RmfPlan plan;
  plan.base.push_back(largest(data.derivatives[0]) == 0 && n > 1 ? 1 : 0);
  std::optional<std::size_t> last_in_space;
  std::optional<std::size_t> last_in_plane;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector<Rational>& d0 = data.derivatives[plan.base[k]];
    const Vector<Rational>& d1 = data.derivatives[k + 1];
    const bool is_at_end = largest(d0) == 0 || largest(d1) == 0;
    if (!is_at_end && !is_along(d0, d1, off)) {
      plan.base.push_back(k + 1);
      plan.segments.push_back(septic_plan(data, k, bits));
      last_in_space = k;
      continue;
    }
    plan.base.push_back(largest(d0) == 0 ? k + 1 : plan.base[k]);
    const Vector<Rational>& along = largest(d0) == 0 ? d1 : d0;
    const Vector<Rational> step = mean_derivative(data, k);
    const bool is_line =
        largest(cross(along, step)) == 0 && (dot(along, step) > 0 || largest(along) == 0);
    plan.segments.push_back({is_line ? SegmentForm::line : SegmentForm::plane, {}, 1});
    if (!is_line) last_in_plane = k;
  }
  plan.closing = last_in_space.value_or(last_in_plane.value_or(0));
  return plan;
}

Vector<Rational> mean_derivative(const HermiteSpline& data, std::size_t k) {
  return (1 / data.step(k)) * (data.points[k + 1] - data.points[k]);
}

}  // namespace phrame
