#include "phrame/ph/frame/near_rotation.hpp"

#include <limits>

#include "phrame/algebra/near_elementary.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/rotation_ball.hpp"

namespace phrame::inline v0 {
namespace {

std::vector<NearNumber> near_polynomial(const Polynomial& p, const Rational& scale) {
  std::vector<NearNumber> coefficients;
  for (long k = 0; k <= p.degree(); ++k)
    coefficients.push_back(near_number(Rational(scale * p.coefficient(k))));
  return coefficients;
}

/// The power of two by which the greatest coefficients are about 1: A may be scaled.
Rational scale_of(const QuaternionPolynomial& a) {
  long exponent = std::numeric_limits<long>::min();
  for (const Polynomial* p : {&a.u, &a.v, &a.p, &a.q})
    for (const Rational& c : p->coefficients())
      if (c != 0) exponent = std::max(exponent, binary_exponent(abs(c)));
  return power_of_two(-exponent);
}

NearNumber evaluate(const std::vector<NearNumber>& p, const NearNumber& t) {
  if (p.empty()) return {};
  NearNumber value = p.back();
  for (std::size_t k = p.size() - 1; k-- > 0;) value = value * t + p[k];
  return value;
}

}  // namespace

bool has_near_rotations(const PathAngle& angle) {
  if (!angle.path().is_ph() || angle.reference() != Reference::euler_rodrigues) return false;
  const RmfAngle& theta = *angle.closed_form(angle.path().segments().size() / 2);
  return theta.is_zero() || theta.near_poles() != nullptr;
}

NearRotations::NearRotations(PathAngle angle, StartAngle start)
    : angle_(std::move(angle)), start_(std::move(start)) {}

NearNumber NearRotations::Segment::theta(const NearNumber& t) const {
  return poles != nullptr ? start + change(*poles, t) : start;
}

/// Segment number k, those before being made.
NearRotations::Segment NearRotations::made(std::size_t k) const {
  Segment found;
  const auto& of = std::get<PhSegment>(angle_.path().segments()[k]);
  const QuaternionPolynomial& a = of.primitive_preimage();
  const Rational scale = scale_of(a);
  found.preimage = {near_polynomial(a.u, scale), near_polynomial(a.v, scale),
                    near_polynomial(a.p, scale), near_polynomial(a.q, scale)};
  const RmfAngle& theta = *angle_.closed_form(k);
  if (k > 0 && segments_[k - 1].is_known)
    found.start = segments_[k - 1].theta({{1}});
  else
    found.start = near_number(angle_.enclose({k, Rational(0)}, start_, rotation_bits));
  if (!theta.is_zero()) found.poles = theta.near_poles();
  found.is_known = theta.is_zero() || found.poles != nullptr;
  return found;
}

const NearRotations::Segment& NearRotations::segment(std::size_t k) const {
  const std::lock_guard guard(lock_);
  while (segments_.size() <= k) segments_.push_back(made(segments_.size()));
  return segments_[k];
}

// B = A·e^{iφ}/|A|, φ half of θ.
std::optional<CompiledFrames::Rotation> NearRotations::at(std::size_t segment,
                                                          const NearNumber& t) const {
  return rounding_to_nearest([&]() -> std::optional<CompiledFrames::Rotation> {
    const Segment& here = this->segment(segment);
    if (!here.is_known) return std::nullopt;
    const NearNumber theta = here.theta(t);
    const auto [c, s] =
        cos_sin({{theta.value.high / 2, theta.value.low / 2}, theta.error / 2 + pair_underflow});
    const NearNumber u = evaluate(here.preimage.u, t);
    const NearNumber v = evaluate(here.preimage.v, t);
    const NearNumber p = evaluate(here.preimage.p, t);
    const NearNumber q = evaluate(here.preimage.q, t);
    const NearNumber over = inverse_root(u * u + v * v + p * p + q * q);
    const NearNumber minus_s = -s;
    const std::array<NearNumber, 4> b{over * (u * c + v * minus_s), over * (v * c + u * s),
                                      over * (p * c + q * s), over * (q * c + p * minus_s)};
    double error = 0;
    for (const NearNumber& x : b) error += x.error;
    error = raised(error);
    constexpr double most = 0x1p-60;  // as of compiled frames, and far more than rounding leaves
    if (!(error <= most)) return std::nullopt;
    return CompiledFrames::Rotation{{b[0].value, b[1].value, b[2].value, b[3].value}, error};
  });
}

// Of plane curves components are 0 all along: that is asked only where one is not told.
std::optional<Frame<double>> NearRotations::frame(std::size_t segment, const NearNumber& t) const {
  const auto rotation = at(segment, t);
  if (!rotation) return std::nullopt;
  if (auto found = rounded_frame(*rotation)) return found;
  const CompiledFrames::Zeros& zeros = this->segment(segment).zeros.get(
      [&] { return CompiledFrames::zeros(angle_, segment, start_); });
  return rounded_frame(*rotation, zeros);
}

std::optional<Frame<double>> NearRotations::frame(const NearNumber& t) const {
  const std::size_t segments = angle_.path().segments().size();
  if (segments == 1) return frame(0, t);
  const auto [high, low] = t.value;
  if (!(high >= 0 && high <= static_cast<double>(segments) && t.error < 1)) return std::nullopt;
  // The last segment that begins at t or before; high − k is exact.
  double k = std::min(std::floor(high), static_cast<double>(segments - 1));
  if (k == high && low < 0) --k;
  const DoubleDouble here = two_sum(high - k, low);
  const DoubleDouble left = two_sum(1 - here.high, -here.low);
  if (k < 0 || !(here.high >= 2 * t.error && left.high >= 2 * t.error)) return std::nullopt;
  return frame(static_cast<std::size_t>(k), {here, t.error});
}

std::vector<std::size_t> NearRotations::frames(const NearNumbers& t,
                                               std::span<Frame<double>> found) const {
  std::vector<std::size_t> untold;
  for (std::size_t k = 0; k < t.size(); ++k)
    if (const auto frame = this->frame({{t.high[k], t.low[k]}, t.error[k]}))
      found[k] = *frame;
    else
      untold.push_back(k);
  return untold;
}

std::optional<Frame<double>> NearRotations::by_balls(const Place& at) const {
  if (!at.t.exact()) return std::nullopt;
  const auto& a = std::get<PhSegment>(angle_.path().segments()[at.segment]).primitive_preimage();
  for (const long bits : {few_rotation_bits, rotation_bits})
    if (auto frame =
            rounded_frame(rotation_ball(a, *at.t.exact(), angle_.enclose(at, start_, bits))))
      return frame;
  return std::nullopt;
}

}  // namespace phrame
