#include "phrame/ph/along/smooth_angle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/recent.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/ph/along/plane_turns.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/smooth_shape.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {
namespace {

void require_on_segment(const Real& t) {
  if (t.exact() && (*t.exact() < 0 || *t.exact() > 1))
    throw DomainError(fmt::format("t = {} is outside [0, 1]", as_written(*t.exact())));
}

}  // namespace

struct SmoothAngle::State {
  Path path;
  Vector<Rational> up;
  SmoothReference reference;
  bool is_zero = true;
  Recent<SegmentIntegral> integrals{most_kept_integrals};  ///< of the segments
  Lazy<PlaneTurns> plane_turns{};

  std::mutex sums_lock;
  std::map<long, std::vector<RealBall>> sums{};  ///< θ(0), θ(1), … by precision

  State(Path along, Vector<Rational> v, SmoothReference to)
      : path(std::move(along)), up(std::move(v)), reference(to) {
    for (std::size_t k = 0; is_zero && k < path.segments().size(); ++k)
      is_zero = integral(k)->is_zero();
  }

  std::shared_ptr<const SegmentIntegral> integral(std::size_t k) {
    return integrals.get(k, [&] {
      const Segment& segment = path.segments()[k];
      return reference == SmoothReference::up ? up_frame_angle(segment, up) : frenet_angle(segment);
    });
  }

  RealBall enclose_on(std::size_t k, const Real& t, long bits) {
    return integral(k)->enclose(t, bits);
  }

  RealBall sum_before(std::size_t segment, long bits);

  std::optional<AngleForm> algebraic_form(const Place& at) const {
    if (reference != SmoothReference::up) return std::nullopt;
    return plane_turns.get([&] { return PlaneTurns(path, up); }).at(at);
  }
};

/// θ at the start of the segment.
RealBall SmoothAngle::State::sum_before(std::size_t segment, long bits) {
  const long enough = (bits + 63) / 64 * 64;  // few precisions are kept
  const std::lock_guard lock(sums_lock);
  std::vector<RealBall>& known = sums[enough];
  if (known.empty()) known.emplace_back();
  while (known.size() <= segment)
    known.push_back(add(known.back(), enclose_on(known.size() - 1, Rational(1), enough), enough));
  return known[segment];
}

SmoothAngle::SmoothAngle(const Path& path)
    : state_(std::make_shared<State>(path, up_vector(path), SmoothReference::up)) {}

SmoothAngle::SmoothAngle(const Path& path, const Vector<Rational>& up) {
  require_up_vector(path, up);
  state_ = std::make_shared<State>(path, up, SmoothReference::up);
}

SmoothAngle::SmoothAngle(const Path& path, SmoothReference reference) {
  if (reference == SmoothReference::frenet) require_frenet_joints(path);
  state_ = std::make_shared<State>(path, up_vector(path), reference);
}

const Path& SmoothAngle::path() const { return state_->path; }
const Vector<Rational>& SmoothAngle::up() const { return state_->up; }
SmoothReference SmoothAngle::reference() const { return state_->reference; }
bool SmoothAngle::is_zero() const { return state_->is_zero; }

Real SmoothAngle::value(const Place& at) const {
  require_on_segment(at.t);
  if (is_zero() || (at.segment == 0 && at.t.exact() == Rational(0))) return Rational(0);
  const auto enclosure = [*this, at](long bits) { return enclose(at, bits); };
  if (auto form = state_->algebraic_form(at))
    return real_angle(enclosure, *std::move(form), at.t.origin().bits);
  return Real(enclosure, {false, at.t.origin().bits});
}

RealBall SmoothAngle::enclose(const Place& at, long bits) const {
  require_on_segment(at.t);
  if (is_zero()) return {};
  constexpr long most = 1L << 20;
  for (long more = bits + 8;; more += 24 + more / 4) {
    const RealBall sum =
        add(state_->sum_before(at.segment, more), state_->enclose_on(at.segment, at.t, more), more);
    if (sum.is_accurate(bits)) return sum;
    if (more > most) throw Undecided("the angle was not found to so many bits");
  }
}

RealBall SmoothAngle::rate(const Place& at, long bits) const {
  require_on_segment(at.t);
  return state_->integral(at.segment)->rate(at.t.enclose(bits + 8), bits);
}

// At both ends e₁ is the same, the tangent, and so is the frame of v.
std::optional<Real> holonomy(const SmoothAngle& angle) {
  if (angle.reference() != SmoothReference::up)
    throw DomainError("holonomy: it is found from the angle to the frame of an up vector");
  const Path& path = angle.path();
  if (!path.is_closed()) return std::nullopt;
  if (angle.is_zero()) return Rational(0);
  return reduced(angle.value({path.segments().size() - 1, Rational(1)})).angle;
}

}  // namespace phrame
