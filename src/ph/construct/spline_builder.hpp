#pragma once
#include <array>
#include <functional>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"
#include "phrame/ph/construct/multiplier.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

// What all kinds of splines have in common: they are tried with more and more bits, measured
// against their data, and put together; each kind says what its segments are.

/// The greatest distances of a spline from its data, so far.
class DeviationMeter {
 public:
  DeviationMeter() = default;
  /// With short numbers: a coordinate counts for more than it is, by less than a 2^−20th of this
  /// tolerance. The default is exact.
  explicit DeviationMeter(const Deviation& tolerance) : rounding_(tolerance) {}

  /// @{ The spline less its data, somewhere.
  void point(const Vector<Rational>& off);
  void derivative(const Vector<Rational>& off);
  void acceleration(const Vector<Rational>& off);
  /// @}
  /// Instead of derivatives: the angle between these is a deviation.
  void direction(const Vector<Rational>& found, const Vector<Rational>& wanted);

  Deviation deviation() const;

 private:
  std::optional<Deviation> rounding_;
  Deviation squared_;
  bool are_angles_ = false;  ///< then it is sines that are squared
};

/// Bernstein coefficients of A on [0, 1].
using BernsteinPreimage = std::vector<RationalQuaternion>;

/// A spline as it grows, one curve from point to point, each from where the one before ends.
class SplineBuilder {
 public:
  SplineBuilder(const HermiteSpline& data, PointRule rule)
      : data_(data), rule_(rule), end_(data.points.front()) {}

  std::size_t next() const { return curves_.size(); }   ///< the number of the next curve
  const Vector<Rational>& end() const { return end_; }  ///< of the curves so far
  /// From there to the point of the next curve.
  Vector<Rational> wanted() const { return data_.points[next() + 1] - end_; }

  /// A curve with these Bernstein coefficients of A and f; where points are met exactly, with the
  /// slight change of f that does so. False where there is none: then nothing is added.
  bool add(const BernsteinPreimage& a, std::vector<Rational> f, MultiplierFreedom freedom);
  bool is_unmet() const { return is_unmet_; }  ///< did the last call find none?
  /// From the first curve on again, measured anew.
  void restart();

  DeviationMeter& meter() { return meter_; }  ///< points are measured as curves are added
  Construction finished(std::vector<Rational> parameters, long bits) const {
    return {joined(curves_), std::move(parameters), {}, bits, meter_.deviation()};
  }

 private:
  const HermiteSpline& data_;
  PointRule rule_;
  std::vector<Curve> curves_;
  Vector<Rational> end_;
  DeviationMeter meter_;
  bool is_unmet_ = false;
};

/// The exception for a segment that has no such change of f.
Undecided unmet_segment(std::size_t k);

/// 0, 1, 2, …: the parameters where derivatives by them say nothing.
std::vector<Rational> whole_parameters(const HermiteSpline& data);

/// Segments r′ = h·A i A*.
struct PreimageSpline {
  struct Segment {
    BernsteinPreimage a;  ///< A over `root`
    Rational h;
    Vector<Rational> start;
  };
  std::vector<Segment> segments;
  Rational root = 1;
  long bits = 0;        ///< A is a multiple of 2^−bits
  Deviation deviation;  ///< from the data
};

/// How a segment is made to end in a point exactly.
struct PointDivision {
  /// Parts of A, each on its [0, 1], such that the mean of their ∫ A i A* is this.
  std::function<std::vector<BernsteinPreimage>(const BernsteinPreimage& a,
                                               const Vector<Rational>& integral)>
      parts;
  std::size_t closing;  ///< the segment of a closed spline that is divided always
};
/// Arrays of coefficients as lists.
template <std::size_t parts, std::size_t n>
std::vector<BernsteinPreimage> listed(
    const std::array<std::array<RationalQuaternion, n>, parts>& preimages) {
  std::vector<BernsteinPreimage> result;
  for (const auto& a : preimages) result.emplace_back(a.begin(), a.end());
  return result;
}

/// All segments in order; those are divided that have to end in a point exactly, all of them for
/// PointRule::exact, else that which closes the spline. Throws Undecided where that does, with the
/// segment.
Construction construction_of(const PreimageSpline& spline, const PointDivision& division,
                             const HermiteSpline& data, PointRule rule);

/// The first that is within the tolerance of those that are tried with so many bits, 8 more each
/// time; no value where there is none.
std::optional<Construction> first_within(
    const Deviation& tolerance, long bits, int most_passes,
    const std::function<std::optional<Construction>(long bits)>& attempt);

/// The same with a new builder for each attempt. Throws Undecided where there is none: it names the
/// segment that the last attempt could not make meet its point, else it gives this reason.
Construction first_built(
    const HermiteSpline& data, PointRule rule, const Deviation& tolerance, long bits,
    int most_passes, const std::function<std::optional<Construction>(SplineBuilder&, long)>& fill,
    const char* reason);

}  // namespace phrame
