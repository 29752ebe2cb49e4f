#include "frame_source.hpp"

#include <algorithm>

namespace phrame::inline v0::python {
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

FrameSource::Segment::Segment(const Curve& curve, FrameKind kind)
    : position(phrame::position(curve)),
      rounded{RoundedPolynomial(position[0]), RoundedPolynomial(position[1]),
              RoundedPolynomial(position[2])},
      frames(curve),
      preimage(without_real_content(curve.preimage())),
      normal(Polynomial{1}) {
  if (kind != TabulatedFrame::frenet) return;
  const GaussianPolynomial g = bend_numerator(preimage);
  normal = RoundedPolynomial(gcd(g.re, g.im));
}

FrameSource::FrameSource(PhPath path, FrameKind kind, const FrameAngle& start)
    : path_(std::move(path)), kind_(kind), start_(start) {
  start_.value = cached(start_.value);
}

void FrameSource::make() {
  if (kind_ == TabulatedFrame::rmf) angle_.emplace(path_);
  segments_.clear();
  for (const Curve& curve : path_.segments()) {
    Segment& segment = segments_.emplace_back(curve, kind_);
    if (segments_.size() == 1) continue;
    const Segment& before = segments_[segments_.size() - 2];
    segment.sign = before.sign * joint_sign(before.preimage, segment.preimage);
  }
  if (kind_ == TabulatedFrame::rmf || kind_ == TabulatedFrame::euler_rodrigues) make_zeros();
}

// B is A/|A| as long as θ + start is 0; then (u + vi)·e^{iφ} has a part that is 0 where both are.
void FrameSource::make_zeros() {
  bool is_erf = kind_ == TabulatedFrame::euler_rodrigues || start_.exact == FrameAngle();
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    is_erf = is_erf &&
             (kind_ == TabulatedFrame::euler_rodrigues || angle_->closed_form(k)->rate().is_zero());
    const auto& [u, v, p, q] = segments_[k].preimage;
    const bool uv = u.is_zero() && v.is_zero();
    const bool pq = p.is_zero() && q.is_zero();
    segments_[k].zeros = {is_erf ? u.is_zero() : uv, is_erf ? v.is_zero() : uv,
                          is_erf ? p.is_zero() : pq, is_erf ? q.is_zero() : pq};
  }
}

void FrameSource::compile(std::size_t k, double from, double to) {
  Segment& segment = segments_[k];
  const Curve& curve = path_.segments()[k];
  const auto origin = static_cast<double>(k);
  try {
    if (kind_ == TabulatedFrame::rmf && path_.is_curve())
      compiled_.emplace_back(curve, *angle_->closed_form(0), from, to, *start_.exact);
    else if (kind_ == TabulatedFrame::rmf)
      compiled_.emplace_back(*angle_, k, start_);
    else
      compiled_.emplace_back(
          curve,
          kind_ == TabulatedFrame::euler_rodrigues ? Reference::euler_rodrigues : Reference::frenet,
          from, to, origin);
    segment.compiled = &compiled_.back();
  } catch (const Undecided&) {
    segment.is_undecided = true;  // all frames are computed exactly
  } catch (const DomainError&) {
    segment.is_undecided = true;  // of a straight line, as each frame says
  }
}

/// A curve goes on for all t: it is compiled where it is asked for.
void FrameSource::prepare_curve(const std::vector<double>& ts) {
  Segment& only = segments_.front();
  only.asked += ts.size();
  if (only.asked < least_of_frames) return;
  const auto [from, to] = std::minmax_element(ts.begin(), ts.end());
  const CompiledFrames* known = only.compiled;
  if (known != nullptr && known->from() <= *from && *to <= known->to()) return;
  const bool is_inside = 0 <= *from && *to <= 1;
  if (is_inside && !only.is_undecided) compile(0, 0, 1);
  if ((!is_inside || only.is_undecided) && *from < *to) compile(0, *from, *to);
}

void FrameSource::prepare(const Parameters& at) {
  const std::lock_guard guard(lock_);
  if (!is_made_) make();
  is_made_ = true;
  if (!at.are_doubles() || !kind_) return;
  if (path_.is_curve()) {
    prepare_curve(at.doubles);
    return;
  }
  for (const double t : at.doubles) {
    const std::size_t k = place_at(t, segments_.size()).first;
    Segment& segment = segments_[k];
    if (++segment.asked < least_of_frames || segment.compiled || segment.is_undecided) continue;
    compile(k, static_cast<double>(k), static_cast<double>(k + 1));
  }
}

const CompiledFrames* FrameSource::compiled_at(double t, const Segment& segment) const {
  const CompiledFrames* compiled = segment.compiled;
  return compiled != nullptr && compiled->from() <= t && t <= compiled->to() ? compiled : nullptr;
}

bool FrameSource::is_prepared(const Parameters& at) const {
  if (!is_made_ || !at.are_doubles()) return false;
  constexpr std::size_t few = 4;
  const bool are_few = at.size() <= few && kind_ != TabulatedFrame::frenet;
  const auto is_ready = [&](double t) {
    const Segment& segment = segments_[place_at(t, segments_.size()).first];
    if (!kind_ || compiled_at(t, segment) != nullptr) return true;
    return are_few && (segment.is_undecided || ++segment.asked < least_of_frames);
  };
  return std::all_of(at.doubles.begin(), at.doubles.end(), is_ready);
}

// Frenet's n is on the side of the real factor of g; where that is 0, at inflections, the frame
// asked for exactly says so.
std::optional<Frame<double>> FrameSource::approximated_frame(double t) const {
  const auto [number, here] = place_at(t, segments_.size());
  const Segment& segment = segments_[number];
  const CompiledFrames* compiled = compiled_at(t, segment);
  if (compiled == nullptr) return std::nullopt;
  const double side = kind_ == TabulatedFrame::frenet ? segment.normal(here) : 1;
  auto frame = side == 0 ? std::nullopt : compiled->rounded(t);
  if (frame && side < 0)
    for (Vector<double>* v : {&frame->e2, &frame->e3})
      for (double& x : *v) x = x == 0 ? 0 : -x;
  return frame;
}

Frame<double> FrameSource::frame(const Parameters& at, std::size_t k) const {
  if (at.are_doubles())
    if (const auto found = approximated_frame(at.doubles[k])) return *found;
  const PathParameter here = locate(path_, at[k]);
  if (kind_ != TabulatedFrame::frenet)
    if (const auto found = rounded_frame(ball_at(here))) return *found;
  const Frames& frames = segments_[here.segment].frames;
  const Frame<Real> exact = [&] {
    if (kind_ == TabulatedFrame::frenet) return frames.frenet(here.t);
    const Frame<Rational> erf = frames.euler_rodrigues(here.t);
    if (kind_ == TabulatedFrame::euler_rodrigues) return as_real(erf);
    return turned(
        erf, angle_->direction(here),
        [&](const FrameAngle& start) { return angle_->value(here, start); }, *start_.exact);
  }();
  return {round_to_double(exact.e1), round_to_double(exact.e2), round_to_double(exact.e3)};
}

Quaternion<RealBall> FrameSource::ball_at(const PathParameter& at) const {
  const RealBall theta =
      kind_ == TabulatedFrame::rmf ? angle_->enclose(Place{at}, start_, rotation_bits) : RealBall();
  const Segment& segment = segments_[at.segment];
  return rotation_ball(segment.preimage, at.t, theta, segment.sign);
}

std::array<Real, 4> FrameSource::rotation(const PathParameter& at) const {
  if (kind_ == TabulatedFrame::frenet) {
    const Quaternion<Real> found = quaternion_of(segments_[at.segment].frames.frenet(at.t));
    return {found.u, found.v, found.p, found.q};
  }
  const Segment& segment = segments_[at.segment];
  const Rational& t = at.t;
  const Real theta =
      kind_ == TabulatedFrame::euler_rodrigues ? Rational(0) : angle_->value(at, start_);
  if (theta.exact() == Rational(0)) {
    RationalQuaternion a = evaluate(segment.preimage, t);
    if (segment.sign < 0) a = {-a.u, -a.v, -a.p, -a.q};
    const Real over_size = square_root_of(1 / norm(a));
    return {over_size * a.u, over_size * a.v, over_size * a.p, over_size * a.q};
  }
  const auto component = [&](RealBall Quaternion<RealBall>::*part) {
    return Real([=, &segment = segment](long bits) {
      return rotation_ball(segment.preimage, t, theta.enclose(bits), segment.sign, bits).*part;
    });
  };
  using Ball = Quaternion<RealBall>;
  return {component(&Ball::u), component(&Ball::v), component(&Ball::p), component(&Ball::q)};
}

/// Of Frenet's frame up to its sign.
std::optional<CompiledFrames::Rotation> FrameSource::approximated_rotation(double t) const {
  const auto [number, here] = place_at(t, segments_.size());
  const Segment& segment = segments_[number];
  const CompiledFrames* compiled = compiled_at(t, segment);
  if (compiled == nullptr) return std::nullopt;
  auto found = compiled->rotation(t);
  const auto [u, v, p, q] = found.b;
  const double side = kind_ == TabulatedFrame::frenet ? segment.normal(here) : segment.sign;
  if (side == 0) return std::nullopt;
  const auto minus = [](const DoubleDouble& x) { return DoubleDouble{-x.high, -x.low}; };
  if (side < 0 && kind_ == TabulatedFrame::frenet)
    found.b = {minus(v), u, q, minus(p)};  // B·i, a half turn about e₁
  else if (side < 0)
    found.b = {minus(u), minus(v), minus(p), minus(q)};
  return found;
}

std::array<double, 4> FrameSource::quaternion(const Parameters& at, std::size_t k) const {
  const PathParameter here = locate(path_, at[k]);
  std::array<std::optional<double>, 4> near;
  const auto found = at.are_doubles() ? approximated_rotation(at.doubles[k]) : std::nullopt;
  if (found) {
    const auto& [u, v, p, q] = found->b;
    for (std::size_t i = 0; i < 4; ++i)
      near[i] = common_double(std::array{u, v, p, q}[i], found->error + 0x1p-94);
  } else if (kind_ != TabulatedFrame::frenet) {
    const auto& [u, v, p, q] = ball_at(here);
    for (std::size_t i = 0; i < 4; ++i) near[i] = common_double(std::array{u, v, p, q}[i]);
  }
  const std::array<bool, 4>& zeros = segments_[here.segment].zeros;
  for (std::size_t i = 0; i < 4; ++i)
    if (zeros[i]) near[i] = 0;
  const auto is_known = [](const std::optional<double>& x) { return x.has_value(); };
  if (!std::all_of(near.begin(), near.end(), is_known)) {
    const std::array<Real, 4> exact = rotation(here);
    for (std::size_t i = 0; i < 4; ++i)
      if (!near[i] || kind_ == TabulatedFrame::frenet) near[i] = round_to_double(exact[i]);
  }
  return {*near[1], *near[2], *near[3], *near[0]};
}

Vector<double> FrameSource::point(const Parameters& at, std::size_t k) const {
  if (at.are_doubles()) {
    const auto [segment, t] = place_at(at.doubles[k], segments_.size());
    const auto& [x, y, z] = segments_[segment].rounded;
    return finite(Vector<double>{x(t), y(t), z(t)});
  }
  const PathParameter here = locate(path_, at[k]);
  return finite(round_to_double(evaluate(segments_[here.segment].position, here.t)));
}

}  // namespace phrame::python
