#include "phrame/ph/frame/compiled_frame.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/near_numbers.hpp"
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

/// Those of B i B*, B j B* and B k B*, one after the other.
template <class T>
[[gnu::always_inline]] inline std::array<SumOfTwo<T>, 9> components(
    const Quaternion<SumOfTwo<T>>& b) {
  const auto& [u, v, p, q] = b;
  const SumOfTwo<T> uu = u * u, vv = v * v, pp = p * p, qq = q * q;
  const SumOfTwo<T> uv = u * v, up = u * p, uq = u * q, vp = v * p, vq = v * q, pq = p * q;
  return {uu + vv - pp - qq, twice(uq + vp), twice(vq - up), twice(vp - uq),   uu - vv + pp - qq,
          twice(uv + pq),    twice(up + vq), twice(pq - uv), uu - vv - pp + qq};
}

/// error ← what they are off by, where B is off by that: of a component, at most four products and
/// three sums of them, which are off by about 2^−102.
template <class T>
[[gnu::always_inline]] inline void to_component_error(T& error) {
  to_frame_error(error);
  error += 0x1p-94;
}

/// Number k of them, rounded.
double& component(Frame<double>& frame, std::size_t k) {
  return (k < 3 ? frame.e1 : k < 6 ? frame.e2 : frame.e3)[k % 3];
}

/// The frames of a group; of t it says what near_values() wants.
template <class Numbers>
struct GroupFrames {
  const PieceGroup& group;
  const DoubleShape& shape;
  const Numbers& t;
  const CompiledFrames::Zeros& zeros;
  std::span<Frame<double>> frames;
  std::vector<std::size_t>& untold;

  template <class T>
  [[gnu::always_inline]] void run() const {
    for (std::size_t at = 0; at < group.t.size(); at += lanes<T>) {
      auto [b, errors] = near_values<4, T, 1>(group, shape, t, at);
      to_component_error(errors[0]);
      store(at, components<T>({b[0], b[1], b[2], b[3]}), errors[0], std::make_index_sequence<9>());
    }
  }

  template <class T, std::size_t... k>
  [[gnu::always_inline]] void store(std::size_t at, const std::array<SumOfTwo<T>, 9>& x,
                                    const T& error, std::index_sequence<k...>) const {
    double rounded[9][lanes<T>];
    auto are_told = error == error;
    (round(x[k], error, zeros[k / 3][k % 3], rounded[k], are_told), ...);
    const std::size_t some = std::min(lanes<T>, group.t.size() - at);
    for (std::size_t i = 0; i < some; ++i)
      frames[group.at[at + i]] = {{rounded[0][i], rounded[1][i], rounded[2][i]},
                                  {rounded[3][i], rounded[4][i], rounded[5][i]},
                                  {rounded[6][i], rounded[7][i], rounded[8][i]}};
    if (!is_true(are_told)) note_untold(at, some, are_told);
  }

  template <class T, class Comparison>
  [[gnu::always_inline]] static void round(const SumOfTwo<T>& x, const T& error, bool is_zero,
                                           double* rounded, Comparison& are_told) {
    const RoundedBounds<T> bounds = rounded_bounds(x, error);
    const T value = is_zero ? T{} : bounds.least;
    std::memcpy(rounded, &value, sizeof(T));
    if (!is_zero) are_told &= bounds.least == bounds.most;
  }

  template <class Comparison>
  [[gnu::always_inline]] void note_untold(std::size_t at, std::size_t some,
                                          const Comparison& are_told) const {
    for (std::size_t i = 0; i < some; ++i)
      if (are_told[i] == 0) untold.push_back(group.at[at + i]);
  }
};

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
    const auto x = components(rotation(t).b);
    Frame<double> frame;
    for (std::size_t k = 0; k < x.size(); ++k) component(frame, k) = x[k].high + x[k].low;
    return frame;
  });
}

std::optional<Frame<double>> CompiledFrames::rounded(double t) const {
  return rounding_to_nearest([&] { return rounded_frame(rotation(t), zeros_at(t)); });
}

std::optional<Frame<double>> CompiledFrames::rounded(const NearNumber& t) const {
  return rounding_to_nearest([&]() -> std::optional<Frame<double>> {
    const auto near = near_values<4>(*polynomials_, t);
    if (!near) return std::nullopt;
    const auto& [u, v, p, q] = near->values;
    return rounded_frame({{u, v, p, q}, near->error}, zeros_at(t.value.high));
  });
}

const CompiledFrames::Zeros& CompiledFrames::zeros_at(double t) const {
  return zeros_[zeros_.size() == 1 ? 0 : std::min(static_cast<std::size_t>(t), zeros_.size() - 1)];
}

template <class Numbers>
std::vector<std::size_t> CompiledFrames::found_frames(std::span<const double> at, const Numbers& t,
                                                      std::span<Frame<double>> frames) const {
  polynomials_->require_inside(at, frames.size(), "compiled frames");
  return rounding_to_nearest([&] {
    std::vector<std::size_t> untold;
    for_each_group(*polynomials_, at, [&](const PieceGroup& group) {
      run_wide(widest(), GroupFrames<Numbers>{group, polynomials_->shape(), t, zeros_at(group.t[0]),
                                              frames, untold});
    });
    std::sort(untold.begin(), untold.end());
    return untold;
  });
}

std::vector<std::size_t> CompiledFrames::rounded(std::span<const double> t,
                                                 std::span<Frame<double>> frames) const {
  return found_frames(t, OnlyDoubles(), frames);
}

std::vector<std::size_t> CompiledFrames::rounded(const NearNumbers& t,
                                                 std::span<Frame<double>> frames) const {
  return found_frames(t.high, t, frames);
}

void CompiledFrames::operator()(std::span<const double> t, std::span<Frame<double>> frames) const {
  for (const std::size_t k : rounded(t, frames)) frames[k] = (*this)(t[k]);
}

std::optional<Frame<double>> rounded_frame(const CompiledFrames::Rotation& at,
                                           const CompiledFrames::Zeros& zeros) {
  double error = at.error;
  to_component_error(error);
  const auto x = components(at.b);
  Frame<double> frame{};
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (zeros[k / 3][k % 3]) continue;
    const auto common = common_double(x[k], error);
    if (!common) return std::nullopt;
    component(frame, k) = *common;
  }
  return frame;
}

}  // namespace phrame
