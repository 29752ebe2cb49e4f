#include "phrame/ph/sweep/sweep_turn.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/ph/sweep/sweep_rates.hpp"

// Along a leg of the length S, u = s/S ∈ [0, 1] (ph/twist/path_twist.cpp):
//   φ = Tu + S(a·u(1 − u)² − b·u²(1 − u)),  dφ/ds = T/S + a(1 − u)(1 − 3u) + b·u(3u − 2),
//   d²φ/ds² = (a(6u − 4) + b(6u − 2))/S,
// of which |(1 − u)(1 − 3u)| and |u(3u − 2)| are ≤ 1, |6u − 4| and |6u − 2| ≤ 4.

namespace phrame {

SweepTurn::SweepTurn(const SweepPath& path, const SweepForm& form) : even_(form.turn) {
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
  error_ = (error_ + (8 + static_cast<double>(legs_.size())) * 0x1p-52 * greatest) * sweep_slack;
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

double SweepTurn::angle(std::size_t segment, double t) const {
  if (!share_) return 0;
  double phi = even_ * (*share_)(segment, t);
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
