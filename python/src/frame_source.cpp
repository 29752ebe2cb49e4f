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

namespace {

std::optional<RoundedPoint> rounded_point_of(const Segment& segment) {
  const auto of = [](const Vector<Polynomial>& r) {
    return RoundedPoint{RoundedPolynomial(r[0]), RoundedPolynomial(r[1]), RoundedPolynomial(r[2])};
  };
  const Curve* ph = ph_curve(segment);
  if (ph != nullptr && ph->is_polynomial()) return of(position(*ph));
  const RationalCurve* curve = rational_curve(segment);
  if (curve == nullptr || !curve->weight().is_constant()) return std::nullopt;
  return of(Polynomial{1 / curve->weight().coefficient(0)} * curve->numerator());
}

}  // namespace

FrameSource::FrameSource(Parametrization along, FrameKind kind, std::optional<PathAngle> angle,
                         StartAngle start)
    : along_(std::move(along)),
      kind_(kind),
      angle_(std::move(angle)),
      start_(std::move(start)),
      is_of_ph_(path().is_ph() && (!angle_ || angle_->reference() == Reference::euler_rodrigues)) {
  start_.value = cached(start_.value);
  if (kind_ == TabulatedFrame::rmf && has_near_rotations(*angle_))
    rotations_.emplace(*angle_, start_);
}

// A segment is compiled in some milliseconds. A frame by pairs of doubles takes two microseconds,
// by balls ten.
std::size_t FrameSource::least_of_frames() const {
  return rotations_ ? least_of_near_frames : least_of_ball_frames;
}

const std::optional<RoundedPoint>& FrameSource::rounded_point(std::size_t segment) const {
  const Piece& piece = pieces_[segment];
  std::call_once(piece.has_rounded,
                 [&] { piece.rounded = rounded_point_of(path().segments()[segment]); });
  return piece.rounded;
}

bool FrameSource::are_by_preimage() const {
  return is_of_ph_ && (kind_ == TabulatedFrame::rmf || kind_ == TabulatedFrame::euler_rodrigues);
}

Place FrameSource::place(const Parameters& at, std::size_t k) const {
  return at_place("ts[" + std::to_string(k) + "]", [&] { return along_.point(at[k]).at; });
}

std::optional<double> FrameSource::near_parameter(const Parameters& at, std::size_t k) const {
  if (!at.are_doubles() || along_.kind() != ParameterKind::t) return std::nullopt;
  return at.doubles[k];
}

void FrameSource::make() {
  pieces_.clear();
  for (const Segment& segment : path().segments()) {
    Piece& piece = pieces_.emplace_back();
    if (!is_of_ph_) continue;
    piece.preimage = &std::get<PhSegment>(segment).primitive_preimage();
    if (kind_ == TabulatedFrame::frenet) {
      const GaussianPolynomial g = bend_numerator(*piece.preimage);
      piece.normal.emplace(gcd(g.re, g.im));
    }
    if (pieces_.size() == 1) continue;
    const Piece& before = pieces_[pieces_.size() - 2];
    piece.sign = before.sign * joint_sign(*before.preimage, *piece.preimage);
  }
  if (are_by_preimage()) make_zeros();
}

// B is A/|A| as long as θ + start is 0; then (u + vi)·e^{iφ} has a part that is 0 where both are.
void FrameSource::make_zeros() {
  bool is_erf = kind_ == TabulatedFrame::euler_rodrigues || start_.exact == FrameAngle();
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    is_erf =
        is_erf && (kind_ == TabulatedFrame::euler_rodrigues || angle_->closed_form(k)->is_zero());
    const auto& [u, v, p, q] = *pieces_[k].preimage;
    const bool uv = u.is_zero() && v.is_zero();
    const bool pq = p.is_zero() && q.is_zero();
    pieces_[k].zeros = {is_erf ? u.is_zero() : uv, is_erf ? v.is_zero() : uv,
                        is_erf ? p.is_zero() : pq, is_erf ? q.is_zero() : pq};
  }
}

void FrameSource::compile(std::size_t k, double from, double to) {
  Piece& piece = pieces_[k];
  const Curve* curve = ph_curve(path().segments()[k]);
  try {
    if (kind_ == TabulatedFrame::rmf && is_of_ph_ && goes_on(path()))
      compiled_.emplace_back(*curve, *angle_->closed_form(0), from, to, *start_.exact);
    else if (kind_ == TabulatedFrame::rmf)
      compiled_.emplace_back(*angle_, k, start_);
    else
      compiled_.emplace_back(
          *curve,
          kind_ == TabulatedFrame::euler_rodrigues ? Reference::euler_rodrigues : Reference::frenet,
          from, to, static_cast<double>(k));
    piece.compiled = &compiled_.back();
  } catch (const Undecided&) {
    piece.is_undecided = true;  // all frames are computed exactly
  } catch (const DomainError&) {
    piece.is_undecided = true;  // of a straight line, as each frame says
  }
}

/// A curve goes on for all t: it is compiled where it is asked for.
void FrameSource::prepare_curve(const std::vector<double>& ts) {
  Piece& only = pieces_.front();
  only.asked += ts.size();
  if (only.asked < least_of_frames()) return;
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
  if (!at.are_doubles() || along_.kind() != ParameterKind::t || !kind_ ||
      (!is_of_ph_ && kind_ != TabulatedFrame::rmf))
    return;
  if (is_of_ph_ && goes_on(path())) {
    prepare_curve(at.doubles);
    return;
  }
  const std::size_t least = is_of_ph_ ? least_of_frames() : least_compiled;
  for (const double t : at.doubles) {
    const std::size_t k = place_at(t, pieces_.size()).first;
    Piece& piece = pieces_[k];
    if (++piece.asked < least || piece.compiled || piece.is_undecided) continue;
    compile(k, static_cast<double>(k), static_cast<double>(k + 1));
  }
}

const CompiledFrames* FrameSource::compiled_at(double t, const Piece& piece) const {
  const CompiledFrames* compiled = piece.compiled;
  return compiled != nullptr && compiled->from() <= t && t <= compiled->to() ? compiled : nullptr;
}

/// Where that is soon done, and nobody else is at it.
void FrameSource::make_few() {
  constexpr long low_degree = 10;
  const std::unique_lock guard(lock_, std::try_to_lock);
  if (!guard || is_made_ || path().segments().size() > 1 ||
      preimage_degree(*ph_curve(path().segments().front())) > low_degree)
    return;
  make();
  is_made_ = true;
}

bool FrameSource::is_prepared(const Parameters& at) {
  if (!at.are_doubles() || along_.kind() != ParameterKind::t) return false;
  const std::size_t few = rotations_ ? 256 : 16;
  const bool are_few = at.size() <= few && are_by_preimage();
  if (are_few && !is_made_) make_few();
  if (!is_made_) return false;
  const auto is_ready = [&](double t) {
    const std::size_t segment = place_at(t, pieces_.size()).first;
    if (!kind_) return rounded_point(segment).has_value();
    const Piece& piece = pieces_[segment];
    if (compiled_at(t, piece) != nullptr) return true;
    return are_few && (piece.is_undecided || ++piece.asked < least_of_frames());
  };
  return std::all_of(at.doubles.begin(), at.doubles.end(), is_ready);
}

// Frenet's n is on the side of the real factor of g; where that is 0, at inflections, the frame
// asked for exactly says so.
std::optional<Frame<double>> FrameSource::approximated_frame(double t) const {
  const auto [number, here] = place_at(t, pieces_.size());
  const Piece& piece = pieces_[number];
  const CompiledFrames* compiled = compiled_at(t, piece);
  if (compiled == nullptr) return rotations_ ? rotations_->frame(number, {{here}}) : std::nullopt;
  const double side = piece.normal ? (*piece.normal)(here) : 1;
  auto frame = side == 0 ? std::nullopt : compiled->rounded(t);
  if (frame && side < 0)
    for (Vector<double>* v : {&frame->e2, &frame->e3})
      for (double& x : *v) x = x == 0 ? 0 : -x;
  return frame;
}

Frame<double> FrameSource::frame(const Parameters& at, std::size_t k) const {
  const auto t = near_parameter(at, k);
  if (t)
    if (const auto found = approximated_frame(*t)) return *found;
  const auto found_anew = [&]() -> Frame<double> {
    const Place here = place(at, k);
    for (const long bits : {few_rotation_bits, rotation_bits})
      if (const auto b = ball_at(here, bits))
        if (const auto found = rounded_frame(*b)) return *found;
    const Frame<Real> exact = exact_frame(here);
    return {round_to_double(exact.e1), round_to_double(exact.e2), round_to_double(exact.e3)};
  };
  return t ? last_frames_.of(*t, found_anew) : found_anew();
}

void FrameSource::frames(const Parameters& at, std::size_t begin,
                         std::span<Frame<double>> found) const {
  const std::size_t end = begin + found.size();
  // Frenet's normal has a side of its own at each t.
  const bool are_compiled =
      at.are_doubles() && along_.kind() == ParameterKind::t && kind_ != TabulatedFrame::frenet;
  const auto compiled = [&](std::size_t k) {
    const double t = at.doubles[k];
    return compiled_at(t, pieces_[place_at(t, pieces_.size()).first]);
  };
  for (std::size_t from = begin, to = begin; from < end; from = to) {
    const CompiledFrames* of_run = are_compiled ? compiled(from) : nullptr;
    do ++to;
    while (to < end && of_run != nullptr && compiled(to) == of_run);
    if (of_run == nullptr) {
      found[from - begin] = frame(at, from);
      continue;
    }
    const std::span run = found.subspan(from - begin, to - from);
    for (const std::size_t k : of_run->rounded({at.doubles.data() + from, run.size()}, run))
      run[k] = frame(at, from + k);
  }
}

Frame<Real> FrameSource::exact_frame(const Place& at) const {
  if (kind_ == TabulatedFrame::rmf) return rotation_minimizing_frame(*angle_, at, start_);
  if (kind_ == TabulatedFrame::frenet) return frenet_frame(path(), at);
  if (kind_ == TabulatedFrame::euler_rodrigues) return euler_rodrigues_frame(path(), at);
  return up_frame(path(), angle_->up(), at);
}

std::optional<Quaternion<RealBall>> FrameSource::ball_at(const Place& at, long bits) const {
  if (!are_by_preimage() || !at.t.exact()) return std::nullopt;
  const RealBall theta =
      kind_ == TabulatedFrame::rmf ? angle_->enclose(at, start_, bits) : RealBall();
  const Piece& piece = pieces_[at.segment];
  return rotation_ball(*piece.preimage, *at.t.exact(), theta, piece.sign);
}

std::array<Real, 4> FrameSource::rotation(const Place& at) const {
  if (!are_by_preimage() || !at.t.exact()) {
    const Quaternion<Real> found = quaternion_of(exact_frame(at));
    return {found.u, found.v, found.p, found.q};
  }
  const Piece& piece = pieces_[at.segment];
  const Rational& t = *at.t.exact();
  const Real theta =
      kind_ == TabulatedFrame::euler_rodrigues ? Rational(0) : angle_->value(at, start_);
  if (theta.exact() == Rational(0)) {
    RationalQuaternion a = evaluate(*piece.preimage, t);
    if (piece.sign < 0) a = {-a.u, -a.v, -a.p, -a.q};
    const Real over_size = square_root_of(1 / norm(a));
    return {over_size * a.u, over_size * a.v, over_size * a.p, over_size * a.q};
  }
  const auto component = [&](RealBall Quaternion<RealBall>::*part) {
    return Real([=, &piece = piece](long bits) {
      return rotation_ball(*piece.preimage, t, theta.enclose(bits), piece.sign, bits).*part;
    });
  };
  using Ball = Quaternion<RealBall>;
  return {component(&Ball::u), component(&Ball::v), component(&Ball::p), component(&Ball::q)};
}

/// Of Frenet's frame up to its sign.
std::optional<CompiledFrames::Rotation> FrameSource::approximated_rotation(double t) const {
  const auto [number, here] = place_at(t, pieces_.size());
  const Piece& piece = pieces_[number];
  const CompiledFrames* compiled = compiled_at(t, piece);
  auto near = compiled != nullptr ? std::optional(compiled->rotation(t))
              : rotations_        ? rotations_->at(number, {{here}})
                                  : std::nullopt;
  if (!near) return std::nullopt;
  CompiledFrames::Rotation& found = *near;
  const auto [u, v, p, q] = found.b;
  const double side = piece.normal ? (*piece.normal)(here) : piece.sign;
  if (side == 0) return std::nullopt;
  const auto minus = [](const DoubleDouble& x) { return DoubleDouble{-x.high, -x.low}; };
  if (side < 0 && kind_ == TabulatedFrame::frenet)
    found.b = {minus(v), u, q, minus(p)};  // B·i, a half turn about e₁
  else if (side < 0)
    found.b = {minus(u), minus(v), minus(p), minus(q)};
  return found;
}

std::array<double, 4> FrameSource::quaternion(const Parameters& at, std::size_t k) const {
  const auto t = near_parameter(at, k);
  const auto found = t ? approximated_rotation(*t) : std::nullopt;
  std::optional<Place> here;
  if (!found) here = place(at, k);
  std::array<std::optional<double>, 4> near;
  if (found) {
    const auto& [u, v, p, q] = found->b;
    for (std::size_t i = 0; i < 4; ++i)
      near[i] = common_double(std::array{u, v, p, q}[i], found->error + 0x1p-94);
  } else if (const auto ball = ball_at(*here)) {
    const auto& [u, v, p, q] = *ball;
    for (std::size_t i = 0; i < 4; ++i) near[i] = common_double(std::array{u, v, p, q}[i]);
  }
  const std::size_t segment = here ? here->segment : place_at(*t, pieces_.size()).first;
  for (std::size_t i = 0; i < 4; ++i)
    if (pieces_[segment].zeros[i]) near[i] = 0;
  const auto is_known = [](const std::optional<double>& x) { return x.has_value(); };
  if (!std::all_of(near.begin(), near.end(), is_known)) {
    const std::array<Real, 4> exact = rotation(here ? *here : place(at, k));
    for (std::size_t i = 0; i < 4; ++i)
      if (!near[i] || !are_by_preimage()) near[i] = round_to_double(exact[i]);
  }
  return {*near[1], *near[2], *near[3], *near[0]};
}

Vector<double> FrameSource::point(const Parameters& at, std::size_t k) const {
  if (const auto near = near_parameter(at, k)) {
    const auto [segment, t] = place_at(*near, pieces_.size());
    if (const auto& rounded = rounded_point(segment)) {
      const auto& [x, y, z] = *rounded;
      return finite(Vector<double>{x(t), y(t), z(t)});
    }
  }
  return finite(round_to_double(position(path(), place(at, k))));
}

}  // namespace phrame::python
