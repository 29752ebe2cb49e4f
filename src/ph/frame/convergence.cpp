#include "phrame/ph/frame/convergence.hpp"

#include <algorithm>
#include <set>

#include "phrame/algebra/ball_log.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long rate_bits = 64;

bool is_of_method(const StepError& x) { return x.error.lower() > rounding_level; }

std::optional<RealBall> rate(const StepError& a, const StepError& b) {
  if (!is_of_method(a) || !is_of_method(b) || b.step == 0) return std::nullopt;
  const RealBall gain = log(divide(a.error, b.error, rate_bits), rate_bits);
  return divide(gain, log(RealBall(Rational(a.step / b.step), rate_bits), rate_bits), rate_bits);
}

}  // namespace

StepError step_error(const std::vector<GivenFrame>& frames, const FrameVerdict& verdict) {
  std::set<Rational> at;
  for (const GivenFrame& frame : frames) at.insert(frame.t);
  Rational step;
  for (auto t = at.begin(); std::next(t) != at.end(); ++t)
    step = std::max(step, Rational(*std::next(t) - *t));
  return {frames.size(), step, verdict.max_error};
}

Convergence convergence(std::vector<StepError> steps) {
  Convergence found;
  std::stable_sort(steps.begin(), steps.end(),
                   [](const StepError& a, const StepError& b) { return a.step > b.step; });
  for (StepError& x : steps) {
    if (!found.steps.empty() && found.steps.back().step == x.step) found.steps.pop_back();
    found.steps.push_back(std::move(x));
  }
  for (std::size_t k = 0; k + 1 < found.steps.size(); ++k) {
    found.rates.push_back(rate(found.steps[k], found.steps[k + 1]));
    if (found.rates.back()) found.order = found.rates.back();
  }
  return found;
}

}  // namespace phrame
