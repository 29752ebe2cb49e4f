#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/along/path_angle.hpp"

namespace phrame::inline v0 {

class PiecewisePolynomial;

/// θ for millions of parameters: a few compensated operations each, a proof of the rounding after
/// each [Ziv 1991], and the exact angle for the few that the proof fails for.
/// Not for concurrent use: it counts the latter.
class PHRAME_API CompiledAngle {
 public:
  /// θ with θ(0) = start_angle. Throws Undecided where a pole of θ′ is nearer to
  /// [from, to] than doubles are to each other there.
  CompiledAngle(const RmfAngle& angle, double from, double to, const FrameAngle& start_angle = {});
  /// The same along a path, on [0, end].
  explicit CompiledAngle(const PathAngle& angle, const StartAngle& start_angle = {});
  /// The same of one segment k, on [k, k + 1].
  CompiledAngle(const PathAngle& angle, std::size_t segment, const StartAngle& start_angle);

  /// θ(t), correctly rounded: to nearest, ties to even. Throws DomainError for a t outside [from,
  /// to] and NaN, and what the exact angle throws.
  double operator()(double t);

  /// The same where the polynomials are enough for that. Any thread may ask.
  std::optional<double> rounded(double t) const;

  /// The same of many t, whatever their order, several at once by what the processor has for that.
  /// The values may be t itself. Throws as for one of them, before anything is written, and
  /// DomainError where there are not as many values as t.
  void operator()(std::span<const double> t, std::span<double> values);
  /// The same where the polynomials are enough for that. The numbers of the others, ascending;
  /// their values are left as they are.
  std::vector<std::size_t> rounded(std::span<const double> t, std::span<double> values) const;

  /// How many values took the exact angle so far.
  long exact_values() const { return exact_values_; }

 private:
  std::function<Real(const Rational&)> angle_;  ///< start_angle included
  std::shared_ptr<const PiecewisePolynomial> polynomials_;
  long exact_values_ = 0;
};

}  // namespace phrame
