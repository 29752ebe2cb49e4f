#include "phrame/ph/sweep/sweep_turn.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/sweep/sweep_rates.hpp"

// Along a leg of the length S, u = s/S ∈ [0, 1] (ph/twist/path_twist.cpp):
//   φ = Tu + S(a·u(1 − u)² − b·u²(1 − u)),  dφ/ds = T/S + a(1 − u)(1 − 3u) + b·u(3u − 2),
//   d²φ/ds² = (a(6u − 4) + b(6u − 2))/S,
// of which |(1 − u)(1 − 3u)| and |u(3u − 2)| are ≤ 1, |6u − 4| and |6u − 2| ≤ 4.

namespace phrame::inline v0 {
namespace {

constexpr long roll_bits = 96;

}  // namespace

SweepTurn::SweepTurn(const SweepPath& path, const SweepForm& form) : even_(form.turn) {
  double roll_error = 0;
  if (const Roll& roll = form.roll; !roll.is_zero()) {
    const std::size_t segments = path.series.segments;
    const std::size_t count = &roll.on(0) == &roll.on(segments - 1) ? 1 : segments;
    for (std::size_t k = 0; k < count; ++k) {
      std::array<Roll::Piece, 3> pieces{roll.on(k)};
      for (std::size_t n = 1; n < 3; ++n)
        pieces[n] = {differentiate(pieces[n - 1].half_turns), differentiate(pieces[n - 1].radians)};
      rolls_.push_back(std::move(pieces));
    }
    // Rounded angles, of any size.
    constexpr long parts = 64;
    for (std::size_t k = 0; k < segments; ++k)
      for (long n = 0; n < parts; ++n)
        roll_error = std::max(
            roll_error,
            0x1p-50 * upper_double(absolute(roll_of(
                          0, k, hull(Rational(n, parts), Rational(n + 1, parts), roll_bits)))));
    error_ = roll_error;
  }
  // A turn that is only what rounding left of none is left out.
  if (std::abs(form.turn) <= 0x1p-44 && form.legs.empty()) return;
  share_.emplace(path.series);
  error_ = std::abs(even_) * share_->error();
  std::size_t first = 0;
  double before = 0;
  double greatest = std::abs(even_);
  for (const SweepLeg& leg : form.legs) {
    const double start = (*share_)(first, 0);
    const double part = (*share_)(leg.end - 1, 1) - start;
    legs_.push_back({leg, first, before, start, part * share_->length()});
    const double bend =
        (std::abs(leg.rate_at_start) + std::abs(leg.rate_at_end)) * legs_.back().length;
    error_ = std::max(error_, (std::abs(leg.turn) + bend) * 4 * share_->error() / part);
    before += leg.turn;
    greatest = std::max(greatest, std::abs(before) + bend);
    first = leg.end;
  }
  error_ = (error_ + roll_error + (8 + static_cast<double>(legs_.size())) * 0x1p-52 * greatest) *
           sweep_slack;
}

const SweepTurn::Leg* SweepTurn::leg_at(std::size_t segment) const {
  if (legs_.empty()) return nullptr;
  const auto after = std::upper_bound(legs_.begin(), legs_.end(), segment,
                                      [](std::size_t k, const Leg& leg) { return k < leg.first; });
  return &*std::prev(after);
}

double SweepTurn::share_of(const Leg& leg, std::size_t segment, double t) const {
  if (segment == leg.first && t == 0) return 0;
  if (segment + 1 == leg.form.end && t == 1) return 1;
  return std::clamp(((*share_)(segment, t) - leg.share) * share_->length() / leg.length, 0.0, 1.0);
}

RealBall SweepTurn::roll_of(std::size_t order, std::size_t segment, const RealBall& t) const {
  const Roll::Piece& piece = rolls_[rolls_.size() == 1 ? 0 : segment][order];
  const RealBall along = add(t, RealBall(static_cast<long>(segment), roll_bits), roll_bits);
  return add(multiply(pi(roll_bits), evaluate(piece.half_turns, along, roll_bits), roll_bits),
             evaluate(piece.radians, along, roll_bits), roll_bits);
}

double SweepTurn::roll_rate(std::size_t segment, double t) const {
  if (rolls_.empty()) return 0;
  return approximate(roll_of(1, segment, RealBall(exact_rational(t), roll_bits)));
}

double SweepTurn::roll_bound(std::size_t order, std::size_t segment, const RealBall& t) const {
  return rolls_.empty() ? 0 : upper_double(absolute(roll_of(order, segment, t)));
}

double SweepTurn::angle(std::size_t segment, double t) const {
  const double rho =
      rolls_.empty() ? 0 : approximate(roll_of(0, segment, RealBall(exact_rational(t), roll_bits)));
  if (!share_) return rho;
  double phi = rho + even_ * (*share_)(segment, t);
  if (const Leg* leg = leg_at(segment)) {
    const double u = share_of(*leg, segment, t);
    const double v = 1 - u;
    phi += leg->before + leg->form.turn * u +
           leg->length * u * v * (leg->form.rate_at_start * v - leg->form.rate_at_end * u);
  }
  return phi;
}

double SweepTurn::rate(std::size_t segment, double t) const {
  if (!share_) return 0;
  double rate = even_ / share_->length();
  if (const Leg* leg = leg_at(segment)) {
    const double u = share_of(*leg, segment, t);
    rate += leg->form.turn / leg->length + leg->form.rate_at_start * (1 - u) * (1 - 3 * u) +
            leg->form.rate_at_end * u * (3 * u - 2);
  }
  return rate;
}

double SweepTurn::rate_bound(std::size_t segment) const {
  if (!share_) return 0;
  double bound = std::abs(even_) / share_->length();
  if (const Leg* leg = leg_at(segment))
    bound += std::abs(leg->form.turn) / leg->length + std::abs(leg->form.rate_at_start) +
             std::abs(leg->form.rate_at_end);
  return bound * sweep_slack;
}

double SweepTurn::second_bound(std::size_t segment) const {
  const Leg* leg = share_ ? leg_at(segment) : nullptr;
  if (leg == nullptr) return 0;
  return 4 * (std::abs(leg->form.rate_at_start) + std::abs(leg->form.rate_at_end)) / leg->length *
         sweep_slack;
}

}  // namespace phrame
