#include "phrame/io/frame_parameters.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

/// Increasing numbers that are not those of the rows.
bool are_times(const std::vector<GivenPosition>& positions) {
  bool is_numbered = true;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (k > 0 && positions[k].t <= positions[k - 1].t) return false;
    is_numbered = is_numbered && positions[k].t == static_cast<long>(k);
  }
  return !is_numbered;
}

std::vector<FrameParameters> candidates(const Path& path,
                                        const std::vector<GivenPosition>& positions) {
  std::vector<FrameParameters> all;
  const std::size_t count = positions.size();
  const auto steps = static_cast<long>(count) - 1;
  const auto add = [&](const std::string& what, auto parameter) {
    FrameParameters found{{}, what};
    for (std::size_t k = 0; k < count; ++k) found.t.push_back(parameter(k));
    all.push_back(std::move(found));
  };
  if (path.segments().size() + 1 == count)
    add("the joints of the curve, one after the other",
        [](std::size_t k) { return Rational(static_cast<long>(k)); });
  const Rational& first = positions.front().t;
  const Rational duration = positions.back().t - first;
  if (are_times(positions))
    add("the times, from the start of the curve to its end",
        [&](std::size_t k) { return Rational(path.end() * (positions[k].t - first) / duration); });
  add("equal steps from the start of the curve to its end",
      [&](std::size_t k) { return Rational(path.end() * Rational(static_cast<long>(k), steps)); });
  return all;
}

}  // namespace

FrameParameters frame_parameters(const Path& path, const std::vector<GivenPosition>& positions) {
  if (positions.size() < 2)
    throw InputError(
        "frames without a column t are placed on the curve by their positions, of "
        "which two at least are wanted");
  const std::vector<FrameParameters> all = candidates(path, positions);
  for (const long digits : {12, 9, 6, 3})
    for (const FrameParameters& candidate : all) {
      std::vector<GivenPosition> moved = positions;
      for (std::size_t k = 0; k < moved.size(); ++k) moved[k].t = candidate.t[k];
      if (are_on_curve(path, moved, power_of_ten(-digits))) return candidate;
    }
  throw InputError(
      "the positions of the frames are the curve's neither at its joints, nor by their "
      "times, nor at equal steps: a column t is wanted");
}

}  // namespace phrame
