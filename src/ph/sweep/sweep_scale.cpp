#include "phrame/ph/sweep/sweep_scale.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/sturm.hpp"

namespace phrame::inline v0 {
namespace {

bool is_number(const RationalFunction& f) {
  return f.numerator().degree() <= 0 && f.denominator().degree() <= 0;
}

}  // namespace

SweepScale::SweepScale(const std::vector<Rational>& at_joints) : is_whole_(false) {
  for (std::size_t k = 0; k + 1 < at_joints.size(); ++k) {
    const Rational slope = at_joints[k + 1] - at_joints[k];
    const Rational start(static_cast<long>(k));
    pieces_.emplace_back(Polynomial{at_joints[k] - start * slope, slope});
  }
}

bool SweepScale::is_constant() const {
  return std::all_of(pieces_.begin(), pieces_.end(), [&](const RationalFunction& piece) {
    return is_number(piece) && piece == pieces_.front();
  });
}

void SweepScale::require_along(std::size_t segments) const {
  if (!is_whole_ && pieces_.size() != segments)
    throw DomainError(fmt::format("the scale has {} values for {} joints, 0 to {}",
                                  pieces_.size() + 1, segments + 1, segments));
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const RationalFunction& f = pieces_[k];
    const Interval part = is_whole_
                              ? closed_interval(0, static_cast<long>(segments))
                              : closed_interval(static_cast<long>(k), static_cast<long>(k + 1));
    if (f.numerator().is_zero()) throw DomainError("the scale is 0");
    if (const auto poles = real_roots(f.denominator(), part); !poles.empty())
      throw DomainError("the scale is not finite at " + place_text("t", poles.front().at));
    if (f(*part.lower) < 0)
      throw DomainError("the scale is negative at t = " + as_written(*part.lower));
    if (const auto zeros = real_roots(f.numerator(), part); !zeros.empty())
      throw DomainError("the scale is 0 at " + place_text("t", zeros.front().at));
  }
}

double SweepScale::greatest(std::size_t segments) const {
  require_along(segments);
  if (is_constant()) return upper_double(RealBall(at_start(), 64));
  double greatest = 0;
  const auto see = [&](const RealBall& x) { greatest = std::max(greatest, upper_double(x)); };
  constexpr long parts = 256;
  const auto end = static_cast<long>(segments);
  if (is_whole_)
    for (long k = 0; k < end * parts; ++k)
      see(evaluate(on(0), hull(Rational(k, parts), Rational(k + 1, parts), 64), 64));
  else
    for (long k = 0; k < end; ++k)  // linear pieces are greatest at an end
      for (const long t : {k, k + 1}) see(RealBall(on(static_cast<std::size_t>(k))(t), 64));
  return greatest;
}

}  // namespace phrame
