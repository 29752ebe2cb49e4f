#include "phrame/ph/frame_check.hpp"

#include <algorithm>
#include <map>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/arc_length.hpp"

namespace phrame {
namespace {

Rational dot(const Vector<Rational>& a, const Vector<Rational>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector<Rational> cross(const Vector<Rational>& a, const Vector<Rational>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

RealBall root(const Rational& x, long bits) { return sqrt(RealBall(x, bits), bits); }

void raise_to(RealBall& x, const RealBall& y, long bits) {
  arb_max(x.raw(), x.raw(), y.raw(), bits);
}

/// |cos| of the angle between a and b; 0 where one of them is 0.
RealBall cosine(const Vector<Rational>& a, const Vector<Rational>& b, long bits) {
  const Rational sizes = dot(a, a) * dot(b, b);
  const Rational c = dot(a, b);
  return sizes == 0 ? RealBall() : root(c * c / sizes, bits);
}

}  // namespace

FrameCheck::FrameCheck(const Spline& spline) : angle_(spline) {
  for (const Curve& curve : spline.segments()) {
    frames_.emplace_back(curve);
    bends_.push_back(bend_numerator(without_real_content(curve.preimage())));
  }
}

/// A single segment may be left.
SplineParameter FrameCheck::place(const Rational& t) const {
  if (frames_.size() == 1) return {0, t};
  return locate(angle_.spline(), t);
}

FrameDeviation FrameCheck::deviation(const GivenFrame& frame, long bits) {
  const SplineParameter at = place(frame.t);
  const Frame<Rational> erf = frames_[at.segment].euler_rodrigues(at.t);
  const Curve& curve = angle_.spline().segments()[at.segment];
  const Rational side = curve.multiplier()(at.t) < 0 ? -1 : 1;
  const Vector<Rational> tangent{side * erf.e1[0], side * erf.e1[1], side * erf.e1[2]};

  FrameDeviation result;
  result.theta = angle_.value(at).enclose(bits);
  const Rational x = dot(frame.f2, erf.e2);
  const Rational y = dot(frame.f2, erf.e3);
  if (x != 0 || y != 0) {
    result.f2 = argument(x, y, bits);
    const Rational re = bends_[at.segment].re(at.t);
    const Rational im = bends_[at.segment].im(at.t);
    // n = (Re g e₂ − Im g e₃)/|g|.
    if (re != 0 || im != 0) result.from_normal = argument(x * re - y * im, x * im + y * re, bits);
  }
  std::vector<Vector<Rational>> normals{frame.f2};
  if (frame.f3) normals.push_back(*frame.f3);
  for (const auto& f : normals) {
    raise_to(result.orthogonality, cosine(f, tangent, bits), bits);
    raise_to(result.length, absolute(subtract(root(dot(f, f), bits), RealBall(1, bits), bits)),
             bits);
  }
  if (frame.f3) {
    raise_to(result.orthogonality, cosine(frame.f2, *frame.f3, bits), bits);
    const Rational determinant = dot(tangent, cross(frame.f2, *frame.f3));
    result.handedness = determinant < 0 ? -1 : determinant > 0 ? 1 : 0;
  }
  result.tangent_cosine = RealBall(1, bits);
  if (frame.tangent) {
    const Vector<Rational>& given = *frame.tangent;
    const Rational squared_size = dot(given, given);
    const RealBall size = root(squared_size, bits);
    raise_to(result.length, absolute(subtract(size, RealBall(1, bits), bits)), bits);
    if (squared_size == 0) {  // no direction at all
      result.tangent_sine = RealBall(1, bits);
      result.tangent_cosine = RealBall();
    } else {
      const Vector<Rational> c = cross(given, tangent);
      result.tangent_sine = divide(root(dot(c, c), bits), size, bits);
      result.tangent_cosine = divide(RealBall(dot(given, tangent), bits), size, bits);
    }
  }
  return result;
}

std::optional<Rational> FrameCheck::length(const Rational& a, const Rational& b) const {
  if (b < a) return length(b, a);
  const SplineParameter from = place(a);
  const SplineParameter to = place(b);
  Rational sum = 0;
  for (std::size_t k = from.segment; k <= to.segment; ++k) {
    const Curve& curve = angle_.spline().segments()[k];
    const Rational start = k == from.segment ? from.t : Rational(0);
    const Rational end = k == to.segment ? to.t : Rational(1);
    for (const RealRoot& zero : real_roots(curve.multiplier(), open(start, end)))
      if (zero.order % 2 == 1) return std::nullopt;
    const Polynomial s = arc_length(curve);
    sum += abs(Rational(s(end) - s(start)));
  }
  return sum;
}

namespace {

using Kind = FrameFinding::Kind;

/// x less the multiple of 2π next to it.
RealBall reduced(const RealBall& x, long bits) {
  const RealBall turn = multiply(RealBall(2, bits), pi(bits), bits);
  const RealBall turns = divide(x, turn, bits);
  const Rational middle = turns.midpoint() + Rational(1, 2);
  Integer whole = numerator(middle) / denominator(middle);  // towards 0
  if (Rational(whole) > middle) --whole;
  return subtract(x, multiply(RealBall(Rational(whole), bits), turn, bits), bits);
}

/// One attempt with balls of so many bits.
class Judgement {
 public:
  Judgement(const FrameCheckOptions& options, long bits) : options_(options), bits_(bits) {}

  FrameVerdict verdict(FrameCheck& check, const std::vector<GivenFrame>& frames);
  bool is_decided() const { return decided_; }

 private:
  using Angles = std::vector<std::optional<RealBall>>;

  /// |x| ≤ tolerance? Remembers where the ball does not tell.
  bool is_small(const RealBall& x) {
    const RealBall size = absolute(x);
    if (size.upper() <= options_.tolerance) return true;
    if (size.lower() <= options_.tolerance) decided_ = false;
    return false;
  }
  void find_errors(FrameVerdict& verdict) const;
  void find_defects(FrameVerdict& verdict);
  void find_flips(FrameVerdict& verdict) const;
  void recognize(FrameVerdict& verdict) const;
  bool is_constant(const Angles& angles, bool up_to_half_turns) const;

  const FrameCheckOptions& options_;
  long bits_;
  bool decided_ = true;
};

void Judgement::find_errors(FrameVerdict& verdict) const {
  std::optional<RealBall> start;
  if (options_.start_angle) start = to_real(*options_.start_angle).enclose(bits_);
  for (const FrameDeviation& at : verdict.deviations) {
    verdict.errors.emplace_back();
    if (!at.f2) continue;
    const RealBall angle = subtract(*at.f2, at.theta, bits_);
    if (!start) start = angle;
    const RealBall error = reduced(subtract(angle, *start, bits_), bits_);
    verdict.errors.back() = error;
    if (absolute(error).upper() > verdict.max_error.upper())
      verdict.worst_sample = verdict.errors.size() - 1;
    raise_to(verdict.max_error, absolute(error), bits_);
  }
}

void Judgement::find_defects(FrameVerdict& verdict) {
  std::map<Kind, std::vector<std::size_t>> found;
  for (std::size_t k = 0; k < verdict.deviations.size(); ++k) {
    const FrameDeviation& at = verdict.deviations[k];
    raise_to(verdict.orthogonality, at.orthogonality, bits_);
    raise_to(verdict.length, at.length, bits_);
    if (!at.f2) found[Kind::undefined].push_back(k);
    if (!is_small(at.tangent_sine))
      found[Kind::wrong_tangent].push_back(k);
    else if (at.tangent_cosine.upper() < 0)
      found[Kind::reversed_tangent].push_back(k);
    if (at.handedness < 0) found[Kind::left_handed].push_back(k);
    if (!is_small(at.orthogonality)) found[Kind::not_orthogonal].push_back(k);
    if (!is_small(at.length)) found[Kind::not_unit].push_back(k);
  }
  for (auto& [kind, samples] : found) verdict.findings.push_back({kind, std::move(samples)});
}

void Judgement::find_flips(FrameVerdict& verdict) const {
  FrameFinding flips{Kind::flip, {}};
  const RealBall* before = nullptr;
  for (std::size_t k = 0; k < verdict.errors.size(); ++k) {
    if (!verdict.errors[k]) continue;
    const RealBall& error = *verdict.errors[k];
    if (before != nullptr && absolute(reduced(subtract(error, *before, bits_), bits_)).lower() > 3)
      flips.samples.push_back(k);
    before = &error;
  }
  if (!flips.samples.empty()) verdict.findings.push_back(std::move(flips));
}

bool Judgement::is_constant(const Angles& angles, bool up_to_half_turns) const {
  const Rational limit = std::max(options_.tolerance, Rational(1, 1'000'000));
  const RealBall factor(up_to_half_turns ? 2 : 1, bits_);
  const RealBall* first = nullptr;
  long count = 0;
  for (const auto& angle : angles) {
    if (!angle) continue;
    if (first == nullptr) first = &*angle;
    const RealBall change = multiply(factor, subtract(*angle, *first, bits_), bits_);
    if (absolute(reduced(change, bits_)).upper() > 2 * limit) return false;
    ++count;
  }
  return count >= 3;
}

/// Which other frame could it be?
void Judgement::recognize(FrameVerdict& verdict) const {
  Angles erf;
  Angles frenet;
  Angles backwards;
  for (const FrameDeviation& at : verdict.deviations) {
    erf.push_back(at.f2);
    frenet.push_back(at.from_normal);
    backwards.emplace_back();
    if (at.f2) backwards.back() = add(*at.f2, at.theta, bits_);
  }
  const auto add = [&](Kind kind) { verdict.findings.push_back({kind, {}}); };
  if (is_constant(verdict.errors, false)) return add(Kind::constant_offset);
  if (is_constant(frenet, true)) return add(Kind::frenet);
  if (is_constant(erf, false)) return add(Kind::euler_rodrigues);
  if (is_constant(backwards, false)) return add(Kind::turned_backwards);
}

FrameVerdict Judgement::verdict(FrameCheck& check, const std::vector<GivenFrame>& frames) {
  FrameVerdict verdict{};
  for (const GivenFrame& frame : frames)
    verdict.deviations.push_back(check.deviation(frame, bits_));
  find_errors(verdict);
  find_defects(verdict);
  find_flips(verdict);
  const bool is_close = is_small(verdict.max_error);
  verdict.passes = is_close && verdict.findings.empty();
  if (!is_close) recognize(verdict);

  const auto first = std::find_if(verdict.errors.begin(), verdict.errors.end(),
                                  [](const auto& error) { return error.has_value(); });
  const auto& last = verdict.errors.back();
  if (first == verdict.errors.end() || !last) return verdict;
  const auto length = check.length(
      frames[static_cast<std::size_t>(first - verdict.errors.begin())].t, frames.back().t);
  if (length && *length != 0)
    verdict.drift =
        divide(reduced(subtract(*last, **first, bits_), bits_), RealBall(*length, bits_), bits_);
  return verdict;
}

}  // namespace

FrameVerdict check_frames(const Spline& spline, const std::vector<GivenFrame>& frames,
                          const FrameCheckOptions& options) {
  FrameCheck check(spline);
  for (long bits = 128; bits <= 4096; bits *= 2) {
    Judgement judgement(options, bits);
    FrameVerdict verdict = judgement.verdict(check, frames);
    if (judgement.is_decided()) return verdict;
  }
  throw Undecided("check_frames: 4096 bits of precision do not tell an error from the tolerance");
}

}  // namespace phrame
