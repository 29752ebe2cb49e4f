#include "phrame/ph/curve/roll.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real_algebraic.hpp"

namespace phrame::inline v0 {
namespace {

/// From a at t = k to b at k + 1.
RationalFunction line(const Rational& a, const Rational& b, long k) {
  const Rational slope = b - a;
  return RationalFunction(Polynomial{a - k * slope, slope});
}

}  // namespace

Roll::Roll(const std::vector<Angle>& at_joints) : is_whole_(false) {
  for (std::size_t k = 0; k + 1 < at_joints.size(); ++k) {
    const Angle& a = at_joints[k];
    const Angle& b = at_joints[k + 1];
    const auto start = static_cast<long>(k);
    pieces_.push_back({line(a.half_turns, b.half_turns, start), line(a.radians, b.radians, start)});
  }
}

bool Roll::is_zero() const {
  return std::ranges::all_of(pieces_, [](const Piece& piece) {
    return piece.half_turns.numerator().is_zero() && piece.radians.numerator().is_zero();
  });
}

void Roll::require_along(std::size_t segments) const {
  if (!is_whole_ && pieces_.size() != segments)
    throw DomainError(fmt::format("the roll has {} values for {} joints, 0 to {}",
                                  pieces_.size() + 1, segments + 1, segments));
  const Interval way = closed_interval(0, static_cast<long>(segments));
  for (const Piece& piece : pieces_)
    for (const RationalFunction* f : {&piece.half_turns, &piece.radians})
      if (const auto poles = real_roots(f->denominator(), way); !poles.empty())
        throw DomainError("the roll is not finite at " + place_text("t", poles.front().at));
}

Angle Roll::at(const PathParameter& at) const {
  const Rational t = parameter(at);
  const Piece& piece = on(at.segment);
  return {piece.half_turns(t), piece.radians(t)};
}

Real Roll::at(const Place& at) const {
  if (at.t.exact()) return to_real(this->at(PathParameter{at.segment, *at.t.exact()}));
  const Real t = parameter(at);
  const Piece& piece = on(at.segment);
  const Real pi_times = value(piece.half_turns, Place(0, t));
  const Real radians = value(piece.radians, Place(0, t));
  if (pi_times.exact() == Rational(0)) return radians;
  return radians + Real([](long bits) { return pi(bits); }) * pi_times;
}

}  // namespace phrame
