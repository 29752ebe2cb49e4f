#include "frame_source.hpp"

#include <algorithm>

namespace phrame::python {
namespace {

/// Of A: which of its components at a joint are those of what comes next, up to a positive factor.
int joint_sign(const QuaternionPolynomial& before, const QuaternionPolynomial& after) {
  const RationalQuaternion a = evaluate(before, 1);
  const RationalQuaternion b = evaluate(after, 0);
  return (a.u * b.u + a.v * b.v + a.p * b.p + a.q * b.q).sign() < 0 ? -1 : 1;
}

}  // namespace

std::pair<std::size_t, double> place_at(double t, std::size_t segments) {
  if (segments == 1) return {0, t};
  const auto k = std::min(segments - 1, static_cast<std::size_t>(t));
  return {k, t - static_cast<double>(k)};  // without rounding: t/2 <= k <= t, or k = 0 [Sterbenz]
}

void FrameSource::prepare(const Parameters& at) {
  for (const Curve& curve : path_.segments()) {
    positions_.push_back(position(curve));
    const auto& [x, y, z] = positions_.back();
    rounded_.push_back({RoundedPolynomial(x), RoundedPolynomial(y), RoundedPolynomial(z)});
    frames_.emplace_back(curve);
    preimages_.push_back(without_real_content(curve.preimage()));
    const std::size_t k = preimages_.size() - 1;
    signs_.push_back(k == 0 ? 1 : signs_[k - 1] * joint_sign(preimages_[k - 1], preimages_[k]));
  }
  if (kind_ == FrameKind::frenet) return;
  if (kind_ == FrameKind::rmf) angle_.emplace(path_);
  zeros_ = zeros();
  if (kind_ == FrameKind::erf) return;
  if (!at.are_doubles() || at.size() < least_compiled) return;
  try {
    if (!path_.is_curve()) {
      compiled_.emplace(*angle_, start_);
      return;
    }
    const auto [from, to] = std::minmax_element(at.doubles.begin(), at.doubles.end());
    if (*from < *to)
      compiled_.emplace(path_.segments().front(), angle_->segment(0), *from, *to, start_);
  } catch (const Undecided&) {
    // Poles of θ′ are too near: all frames are computed exactly.
  }
}

std::array<bool, 4> FrameSource::zeros() const {
  std::array<bool, 4> zero;
  zero.fill(true);
  for (std::size_t k = 0; k < preimages_.size(); ++k) {
    const auto& [u, v, p, q] = preimages_[k];
    const bool is_erf =
        kind_ == FrameKind::erf || (angle_->segment(k).rate().is_zero() && start_ == FrameAngle());
    const bool uv = u.is_zero() && v.is_zero();
    const bool pq = p.is_zero() && q.is_zero();
    const std::array<bool, 4> of_segment{is_erf ? u.is_zero() : uv, is_erf ? v.is_zero() : uv,
                                         is_erf ? p.is_zero() : pq, is_erf ? q.is_zero() : pq};
    for (std::size_t i = 0; i < 4; ++i) zero[i] = zero[i] && of_segment[i];
  }
  return zero;
}

Frame<double> FrameSource::frame(const Parameters& at, std::size_t k) const {
  if (compiled_)
    if (const auto found = compiled_->rounded(at.doubles[k])) return *found;
  const PathParameter here = locate(path_, at[k]);
  const Frames& frames = frames_[here.segment];
  const Frame<Real> exact = [&] {
    if (kind_ == FrameKind::frenet) return frames.frenet(here.t);
    const Frame<Rational> erf = frames.euler_rodrigues(here.t);
    if (kind_ == FrameKind::erf) return as_real(erf);
    return turned(
        erf, angle_->direction(here),
        [&](const FrameAngle& start) { return angle_->value(here, start); }, start_);
  }();
  return {round_to_double(exact.e1), round_to_double(exact.e2), round_to_double(exact.e3)};
}

std::array<Real, 4> FrameSource::rotation(const PathParameter& at) const {
  RationalQuaternion a = evaluate(preimages_[at.segment], at.t);
  if (signs_[at.segment] < 0) a = {-a.u, -a.v, -a.p, -a.q};
  const Real theta = kind_ == FrameKind::erf ? Rational(0) : angle_->value(at, start_);
  if (theta.exact() == Rational(0)) {
    const Real over_size = square_root_of(1 / norm(a));
    return {over_size * a.u, over_size * a.v, over_size * a.p, over_size * a.q};
  }
  // (x + yi)·e^{±iφ}/|A|
  const auto turned = [&](const Rational& x, const Rational& y, int sign, bool imaginary) {
    return Real([=](long bits) {
      const CosSin unit = cos_sin(times_power_of_two(theta.enclose(bits), -1), bits);
      const RealBall sine = sign < 0 ? subtract(RealBall(), unit.sin, bits) : unit.sin;
      const RealBall first = multiply(RealBall(imaginary ? y : x, bits), unit.cos, bits);
      const RealBall second = multiply(RealBall(imaginary ? x : y, bits), sine, bits);
      const RealBall sum = imaginary ? add(first, second, bits) : subtract(first, second, bits);
      return divide(sum, sqrt(RealBall(norm(a), bits), bits), bits);
    });
  };
  return {turned(a.u, a.v, 1, false), turned(a.u, a.v, 1, true), turned(a.p, a.q, -1, false),
          turned(a.p, a.q, -1, true)};
}

std::array<double, 4> FrameSource::quaternion(const Parameters& at, std::size_t k) const {
  std::array<double, 4> b{};
  std::optional<std::array<Real, 4>> exact;
  const PathParameter here = locate(path_, at[k]);
  if (kind_ == FrameKind::frenet) {
    const Quaternion<Real> found = quaternion_of(frames_[here.segment].frenet(here.t));
    return {round_to_double(found.v), round_to_double(found.p), round_to_double(found.q),
            round_to_double(found.u)};
  }
  std::optional<CompiledFrames::Rotation> near;
  if (compiled_) near = compiled_->rotation(at.doubles[k]);
  for (std::size_t i = 0; i < 4; ++i) {
    if (zeros_[i]) continue;
    std::optional<double> common;
    if (near) {
      const auto& [u, v, p, q] = near->b;
      const DoubleDouble x = std::array{u, v, p, q}[i];
      common = common_double(x, near->error + 0x1p-94);
      if (common && signs_[here.segment] < 0) common = -*common;
    }
    if (!common && !exact) exact = rotation(here);
    b[i] = common ? *common : round_to_double((*exact)[i]);
  }
  return {b[1], b[2], b[3], b[0]};
}

Vector<double> FrameSource::point(const Parameters& at, std::size_t k) const {
  if (at.are_doubles()) {
    const auto [segment, t] = place_at(at.doubles[k], rounded_.size());
    const auto& [x, y, z] = rounded_[segment];
    return finite(Vector<double>{x(t), y(t), z(t)});
  }
  const PathParameter here = locate(path_, at[k]);
  return finite(round_to_double(evaluate(positions_[here.segment], here.t)));
}

}  // namespace phrame::python
