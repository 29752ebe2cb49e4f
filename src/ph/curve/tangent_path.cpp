// e₁ = H/|H| with H primitive is rational iff |H| is a polynomial. Then H itself is the hodograph
// of a PH curve, with f = 1 up to a constant: identify() finds its preimage.
#include "phrame/ph/curve/tangent_path.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"

namespace phrame::inline v0 {
namespace {

[[noreturn]] void fail_of_tangent(const Path& path, std::size_t k, const std::string& reason) {
  throw DomainError(fmt::format("{}: its unit tangent is {}",
                                path.segments().size() == 1
                                    ? "the curve is not PH"
                                    : fmt::format("segment {} is not PH", k + 1),
                                reason));
}

std::string why_irrational(const NotPythagorean& found) {
  if (found.odd_factor != Polynomial{1})
    return "no rational function, as |r'|^2 has the factor " +
           abbreviated(to_string(found.odd_factor), 120) + " to an odd power";
  return fmt::format("a rational function times sqrt({}), which no fractions are",
                     abbreviated(found.radicand.str()));
}

/// From `start`.
Curve curve_with_tangents(const Path& path, std::size_t k, const Vector<Rational>& start) {
  const Segment& segment = path.segments()[k];
  if (const auto* ph = std::get_if<PhSegment>(&segment))
    return {ph->primitive_preimage(), {1}, start};
  const RationalCurve* curve = rational_curve(segment);
  if (curve == nullptr) fail_of_tangent(path, k, "that of formulas, not known to be rational");
  auto found = identify(curve->direction(), start);
  if (const auto* none = std::get_if<NotPythagorean>(&found))
    fail_of_tangent(path, k, why_irrational(*none));
  return std::get<Curve>(std::move(found));
}

}  // namespace

PhPath path_with_tangents(const Path& path) {
  PhPath result(curve_with_tangents(path, 0, {}));
  for (std::size_t k = 1; k < path.segments().size(); ++k)
    result.append(curve_with_tangents(path, k, end_point(result.segments().back())));
  return result;
}

}  // namespace phrame
