#include "phrame/ph/frame/compiled_angle.hpp"

#include <cmath>

#include "phrame/algebra/rounded_values.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/angle_polynomials.hpp"

namespace phrame::inline v0 {

CompiledAngle::CompiledAngle(const RmfAngle& angle, double from, double to,
                             const FrameAngle& start_angle)
    : angle_([angle, start_angle](const Rational& t) { return angle.value(t, start_angle); }),
      polynomials_(shared(compiled_angle(angle, start_angle, from, to, compensated_shape(1)))) {}

CompiledAngle::CompiledAngle(const PathAngle& angle, const StartAngle& start_angle)
    : angle_([angle, start_angle](const Rational& t) { return angle.value(t, start_angle); }),
      polynomials_(shared(compiled_angle(angle, start_angle, compensated_shape(1)))) {}

CompiledAngle::CompiledAngle(const PathAngle& angle, std::size_t segment,
                             const StartAngle& start_angle)
    : angle_([angle, start_angle](const Rational& t) { return angle.value(t, start_angle); }),
      polynomials_(shared(compiled_angle(angle, segment, start_angle, compensated_shape(1)))) {}

std::optional<double> CompiledAngle::rounded(double t) const {
  polynomials_->require_inside(t, "compiled angle");
  return rounding_to_nearest([&] {
    const PolynomialPiece& piece = polynomials_->at(t);
    const double y = piece.y(t);
    const auto [value] =
        evaluate_compensated<1>(piece.coefficients.data(), polynomials_->shape(), y);
    return common_double(value, piece.error + piece.error_per_y * std::abs(y));
  });
}

double CompiledAngle::operator()(double t) {
  if (const auto found = rounded(t)) return *found;
  ++exact_values_;
  return round_to_double(angle_(exact_rational(t)));
}

std::vector<std::size_t> CompiledAngle::rounded(std::span<const double> t,
                                                std::span<double> values) const {
  polynomials_->require_inside(t, values.size(), "compiled angle");
  return rounding_to_nearest([&] { return rounded_values(*polynomials_, t, values); });
}

void CompiledAngle::operator()(std::span<const double> t, std::span<double> values) {
  for (const std::size_t k : rounded(t, values)) {
    ++exact_values_;
    values[k] = round_to_double(angle_(exact_rational(t[k])));
  }
}

}  // namespace phrame
