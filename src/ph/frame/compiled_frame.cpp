#include "phrame/ph/frame/compiled_frame.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/compiled_frame_rotation.hpp"
#include "phrame/ph/frame/compiled_rotation.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/frame/rational_frame.hpp"
#include "phrame/ph/frame/rotation_piece.hpp"

namespace phrame::inline v0 {
namespace {

// f₂ of a rotation-minimizing frame has a component that is 0 everywhere on plane curves only: of
// f₂·k = 0 the derivative is f₂′·k = 0, where f₂′ is along e₁, so that either e₁·k = 0 or f₂ is
// constant, the normal of a plane. There the frames are rational, of a degree ≤ 2·degree(B), so
// that one that is 0 at so many t and one more is 0.

/// Which components of the rotation-minimizing frames at(t) are 0 for all t: decided exactly.
template <class At>
CompiledFrames::Zeros frame_zeros(const Curve& curve, const At& at) {
  const QuaternionPolynomial a = without_real_content(curve.preimage());
  const Vector<Polynomial> tangent = rotated_i(a);
  CompiledFrames::Zeros zeros{};
  for (std::size_t k = 0; k < 3; ++k) zeros[0][k] = tangent[k].is_zero();
  if (!plane_normal(a)) return zeros;
  const auto rational = rational_frame(a);
  const auto* found = std::get_if<RationalFrame>(&rational);
  if (found == nullptr) return zeros;
  zeros[1].fill(true);
  zeros[2].fill(true);
  const long points = 2 * degree(found->preimage) + 1;
  for (long n = 0; n < points; ++n) {
    const Frame<Real> frame = at(Rational(n, points));
    for (std::size_t k = 0; k < 3; ++k) {
      zeros[1][k] = zeros[1][k] && frame.e2[k].exact() == Rational(0);
      zeros[2][k] = zeros[2][k] && frame.e3[k].exact() == Rational(0);
    }
  }
  return zeros;
}

/// The same of the Euler–Rodrigues frame or of Frenet's.
CompiledFrames::Zeros frame_zeros(const Curve& curve, Reference reference) {
  const QuaternionPolynomial a = without_real_content(curve.preimage());
  const GaussianPolynomial g =
      reference == Reference::frenet ? regular_bend(a) : GaussianPolynomial{{1}, {}};
  const Vector<Polynomial> j = rotated_j(a);
  const Vector<Polynomial> k = rotated_k(a);
  const std::array multiples{rotated_i(a), g.re * j - g.im * k, g.im * j + g.re * k};
  CompiledFrames::Zeros zeros{};
  for (std::size_t n = 0; n < 3; ++n)
    for (std::size_t i = 0; i < 3; ++i) zeros[n][i] = multiples[n][i].is_zero();
  return zeros;
}

CompiledFrames::Zeros all_zeros() {
  CompiledFrames::Zeros zeros;
  for (auto& of_vector : zeros) of_vector.fill(true);
  return zeros;
}

/// Takes out what is not 0 all along of e₁ and, where `is_up`, of the frame of v.
void clear_zeros(CompiledFrames::Zeros& zeros, const std::vector<Vector<Polynomial>>& frame,
                 bool is_up) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      zeros[j][k] = zeros[j][k] && (j == 0 || is_up) && frame[j][k].is_zero();
}

/// Of H: what multiples of the three vectors are.
std::vector<Vector<Polynomial>> frame_of(const Vector<Polynomial>& H, const Vector<Polynomial>& v) {
  const Vector<Polynomial> second = cross(v, H);
  return {H, second, cross(H, second)};
}

/// What is 0 all along a segment: of e₁, and in a plane with its normal for v.
CompiledFrames::Zeros known_zeros(const PathAngle& angle, const Segment& segment,
                                  const StartAngle& start) {
  CompiledFrames::Zeros zeros = all_zeros();
  const bool is_up =
      angle.reference() == Reference::up && angle.is_zero() && start.value.exact() == Rational(0);
  const Vector<Polynomial> up = as_polynomials(is_up ? angle.up() : Vector<Rational>{});
  if (const RationalCurve* curve = rational_curve(segment)) {
    clear_zeros(zeros, frame_of(curve->direction(), up), is_up);
    return zeros;
  }
  for (const Vector<Rational>& direction : direction_span(segment))
    clear_zeros(zeros, frame_of(as_polynomials(direction), up),
                is_up && dot(angle.up(), direction) == 0);
  return zeros;
}

}  // namespace

CompiledFrames::CompiledFrames(const Curve& curve, const RmfAngle& angle, double from, double to,
                               const FrameAngle& start_angle)
    : CompiledFrames(compiled_rotation(curve, angle, start_angle, from, to, compensated_shape(4)),
                     {zeros(curve, angle, start_angle)}) {}

CompiledFrames::CompiledFrames(const PathAngle& angle, const StartAngle& start_angle)
    : CompiledFrames(compiled_rotation(angle, start_angle, compensated_shape(4)),
                     zeros(angle, start_angle)) {}

CompiledFrames::CompiledFrames(const PathAngle& angle, std::size_t segment,
                               const StartAngle& start_angle)
    : CompiledFrames(compiled_rotation(angle, segment, start_angle, compensated_shape(4)),
                     {zeros(angle, segment, start_angle)}) {}

CompiledFrames::CompiledFrames(const Curve& curve, Reference reference, double from, double to,
                               double origin)
    : CompiledFrames(compiled_rotation(curve, reference, from, to, origin, compensated_shape(4)),
                     {frame_zeros(curve, reference)}) {}

CompiledFrames::CompiledFrames(PiecewisePolynomial polynomials, std::vector<Zeros> zeros)
    : polynomials_(shared(std::move(polynomials))), zeros_(std::move(zeros)) {
  // Far more than the operations on pairs of doubles are off by, and than rounding leaves.
  for (const PolynomialPiece& piece : polynomials_->pieces())
    if (!(frame_error(piece.error) <= 0x1p-60))
      throw Undecided("compiled frames: the polynomials are not exact enough");
}

CompiledFrames::Zeros CompiledFrames::zeros(const Curve& curve, const RmfAngle& angle,
                                            const FrameAngle& start_angle) {
  return frame_zeros(curve, [&, frames = Frames(curve)](const Rational& t) {
    return frames.rotation_minimizing(angle, t, start_angle);
  });
}

CompiledFrames::Zeros CompiledFrames::zeros(const PathAngle& angle, std::size_t segment,
                                            const StartAngle& start) {
  const Segment& of = angle.path().segments()[segment];
  Zeros zeros = angle.reference() != Reference::euler_rodrigues || !start.exact
                    ? known_zeros(angle, of, start)
                    : frame_zeros(*ph_curve(of), [&](const Rational& t) {
                        return rotation_minimizing_frame(angle, {segment, t}, start);
                      });
  // Along a line that is parallel to an axis the others are across it.
  for (std::size_t k = 0; k < 3; ++k)
    if (zeros[0][(k + 1) % 3] && zeros[0][(k + 2) % 3]) zeros[1][k] = zeros[2][k] = true;
  return zeros;
}

std::vector<CompiledFrames::Zeros> CompiledFrames::zeros(const PathAngle& angle,
                                                         const StartAngle& start) {
  std::vector<Zeros> all;
  const std::size_t segments = angle.path().segments().size();
  Stage stage("segments", segments);
  for (std::size_t k = 0; k < segments; ++k, stage.advance()) all.push_back(zeros(angle, k, start));
  return all;
}

double CompiledFrames::from() const { return polynomials_->from(); }

double CompiledFrames::to() const { return polynomials_->to(); }

CompiledFrames::Rotation CompiledFrames::rotation(double t) const {
  polynomials_->require_inside(t, "compiled frames");
  return rounding_to_nearest([&] {
    const PolynomialPiece& piece = polynomials_->at(t);
    const auto [u, v, p, q] =
        evaluate_compensated<4>(piece.coefficients.data(), polynomials_->shape(), piece.y(t));
    return Rotation{{u, v, p, q}, piece.error};
  });
}

Frame<double> CompiledFrames::operator()(double t) const {
  return rounding_to_nearest([&]() -> Frame<double> {
    const auto b = rotation(t).b;
    const auto rounded = [](const Vector<DoubleDouble>& x) {
      return Vector<double>{x[0].high + x[0].low, x[1].high + x[1].low, x[2].high + x[2].low};
    };
    return {rounded(rotated_i(b)), rounded(rotated_j(b)), rounded(rotated_k(b))};
  });
}

std::optional<Frame<double>> CompiledFrames::rounded(double t) const {
  return rounding_to_nearest([&] { return near_frame(t, rotation(t)); });
}

std::optional<Frame<double>> CompiledFrames::rounded(const NearNumber& t) const {
  return rounding_to_nearest([&]() -> std::optional<Frame<double>> {
    const auto near = near_values<4>(*polynomials_, t);
    if (!near) return std::nullopt;
    const auto& [u, v, p, q] = near->values;
    return near_frame(t.value.high, {{u, v, p, q}, near->error});
  });
}

std::optional<Frame<double>> CompiledFrames::near_frame(double t, const Rotation& at) const {
  const auto& [b, off] = at;
  const Zeros& zeros = zeros_.size() == 1
                           ? zeros_[0]
                           : zeros_[std::min(static_cast<std::size_t>(t), zeros_.size() - 1)];
  // Of a component, at most four products and three sums of them, which are off by about 2^−102.
  const double error = frame_error(off) + 0x1p-94;
  bool is_certain = true;
  const auto rounded = [&](const Vector<DoubleDouble>& x, const std::array<bool, 3>& is_zero) {
    Vector<double> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_zero[k]) continue;
      const auto common = common_double(x[k], error);
      is_certain = is_certain && common;
      v[k] = common.value_or(0);
    }
    return v;
  };
  const Frame<double> frame{rounded(rotated_i(b), zeros[0]), rounded(rotated_j(b), zeros[1]),
                            rounded(rotated_k(b), zeros[2])};
  if (!is_certain) return std::nullopt;
  return frame;
}

}  // namespace phrame
