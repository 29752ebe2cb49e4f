#include "phrame/ph/construct/spline_builder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/of_segment.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {
namespace {

/// An upper bound of the square, and 0 of 0.
Rational squared_above(const Vector<Rational>& off, const Rational& tolerance) {
  if (off == Vector<Rational>{}) return 0;
  const long places = tolerance == 0 ? 0 : 21 - binary_exponent(tolerance);
  Integer sum;
  for (const Rational& x : off)
    if (x != 0) {
      const Integer n = floor(abs(x) * power_of_two(places)) + 1;
      sum += n * n;
    }
  return sum * power_of_two(-2 * places);
}

void raise(Deviation& squared, const std::optional<Deviation>& rounding, Rational Deviation::*part,
           const Vector<Rational>& off) {
  squared.*part =
      std::max(squared.*part, rounding ? squared_above(off, *rounding.*part) : dot(off, off));
}

}  // namespace

void DeviationMeter::point(const Vector<Rational>& off) {
  raise(squared_, rounding_, &Deviation::points, off);
}

void DeviationMeter::derivative(const Vector<Rational>& off) {
  raise(squared_, rounding_, &Deviation::derivatives, off);
}

void DeviationMeter::acceleration(const Vector<Rational>& off) {
  raise(squared_, rounding_, &Deviation::accelerations, off);
}

void DeviationMeter::direction(const Vector<Rational>& found, const Vector<Rational>& wanted) {
  squared_.derivatives = std::max(squared_.derivatives, squared_sine(found, wanted));
  are_angles_ = true;
}

/// An acute angle is less than twice its sine.
Deviation DeviationMeter::deviation() const {
  return {square_root_above(squared_.points),
          (are_angles_ ? 2 : 1) * square_root_above(squared_.derivatives),
          square_root_above(squared_.accelerations)};
}

bool SplineBuilder::add(const BernsteinPreimage& a, std::vector<Rational> f,
                        MultiplierFreedom freedom) {
  const QuaternionPolynomial preimage = from_bernstein(a);
  if (rule_ == PointRule::exact) {
    auto slight = slight_multiplier(preimage, f, wanted(), freedom);
    is_unmet_ = !slight;
    if (is_unmet_) return false;
    f = *std::move(slight);
  }
  const Vector<Rational>& point = data_.points[next() + 1];
  curves_.emplace_back(preimage, from_bernstein(f), end_);
  end_ = end_point(curves_.back());
  meter_.point(end_ - point);
  return true;
}

void SplineBuilder::restart() {
  curves_.clear();
  end_ = data_.points.front();
  meter_ = {};
}

Undecided unmet_segment(std::size_t k) {
  return Undecided(fmt::format("segment {}: {}", k + 1, no_slight_multiplier));
}

std::vector<Rational> whole_parameters(const HermiteSpline& data) {
  std::vector<Rational> parameters;
  for (std::size_t k = 0; k <= data.segments(); ++k) parameters.emplace_back(k);
  return parameters;
}

Construction construction_of(const PreimageSpline& spline, const PointDivision& division,
                             const HermiteSpline& data, PointRule rule) {
  const Rational& root = spline.root;
  std::vector<Curve> curves;
  std::vector<Rational> parameters{data.parameters.front()};
  const auto add = [&](const BernsteinPreimage& a, const Rational& h,
                       const Vector<Rational>& start) {
    BernsteinPreimage scaled;
    for (const RationalQuaternion& x : a) scaled.push_back(root * x);
    curves.emplace_back(from_bernstein(scaled), Polynomial{h}, start);
    parameters.push_back(parameters.back() + h);
  };
  const bool is_exact = rule == PointRule::exact;
  for (std::size_t k = 0; k < spline.segments.size(); ++k) {
    const PreimageSpline::Segment& segment = spline.segments[k];
    const Rational& h = segment.h;
    if (!is_exact && !(data.is_closed && k == division.closing)) {
      add(segment.a, h, segment.start);
      continue;
    }
    Vector<Rational> start = is_exact ? data.points[k] : segment.start;
    const Vector<Rational>& end =
        is_exact || k + 1 == data.segments() ? data.points[k + 1] : spline.segments[k + 1].start;
    const auto parts = of_segment(
        k, [&] { return division.parts(segment.a, 1 / (h * root * root) * (end - start)); });
    for (const BernsteinPreimage& part : parts) {
      add(part, h / parts.size(), start);
      start = end_point(curves.back());
    }
  }
  Construction result{joined(curves), std::move(parameters), {}, spline.bits, spline.deviation};
  if (is_exact) result.deviation.points = 0;
  return result;
}

std::optional<Construction> first_within(
    const Deviation& tolerance, long bits, int most_passes,
    const std::function<std::optional<Construction>(long bits)>& attempt) {
  for (int pass = 0; pass < most_passes; ++pass, bits += 8)
    if (auto found = attempt(bits); found && is_within(found->deviation, tolerance)) return found;
  return std::nullopt;
}

Construction first_built(
    const HermiteSpline& data, PointRule rule, const Deviation& tolerance, long bits,
    int most_passes, const std::function<std::optional<Construction>(SplineBuilder&, long)>& fill,
    const char* reason) {
  std::optional<std::size_t> unmet;
  auto found = first_within(tolerance, bits, most_passes, [&](long now) {
    SplineBuilder builder(data, rule);
    auto spline = fill(builder, now);
    unmet = builder.is_unmet() ? std::optional(builder.next()) : std::nullopt;
    return spline;
  });
  if (found) return *std::move(found);
  throw unmet ? unmet_segment(*unmet) : Undecided(reason);
}

}  // namespace phrame
