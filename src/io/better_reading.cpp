#include "phrame/io/better_reading.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

bool has_right_tangents(const FrameVerdict& verdict) {
  return std::none_of(verdict.findings.begin(), verdict.findings.end(), [](const auto& finding) {
    return finding.kind == FrameFinding::Kind::wrong_tangent ||
           finding.kind == FrameFinding::Kind::reversed_tangent;
  });
}

/// Vectors are left out, for their columns are positions; but are they?
bool hides_vectors(const Path& path, std::string_view bytes, const GivenTable& table,
                   const FrameReading& other, const Rational& tolerance) {
  const auto has_positions = [](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), "x") != names.end();
  };
  return has_positions(other.names) && !has_positions(table.columns) &&
         !are_on_curve(path, read_positions(bytes, other), std::min(tolerance, Rational(1, 100)));
}

/// No value where it is not decided.
std::optional<FrameVerdict> verdict_of(const Path& path, const std::vector<GivenFrame>& frames,
                                       const FrameCheckOptions& options) {
  try {
    return check_frames(path, frames, options);
  } catch (const Undecided&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<BetterReading> better_reading(const Path& path, std::string_view bytes,
                                            const FrameReading& reading, const GivenTable& table,
                                            const FrameVerdict& verdict,
                                            const FrameCheckOptions& options) {
  const bool has_tangents = table.frames.front().tangent.has_value();
  if (verdict.passes || (has_tangents && has_right_tangents(verdict))) return std::nullopt;
  std::optional<BetterReading> better;
  for (const FrameReading& other : other_readings(table, reading)) {
    constexpr std::size_t few = 5;  // most readings are seen to be wrong by a few frames
    if (!are_along_curve(path, read_frames(bytes, other, few).frames, options.tolerance)) continue;
    if (hides_vectors(path, bytes, table, other, options.tolerance)) continue;
    const GivenTable all = read_frames(bytes, other);
    const auto found = verdict_of(path, all.frames, options);
    if (!found) continue;
    if (found->passes) return BetterReading{other, true};
    const bool is_better = all.frames.front().tangent && has_right_tangents(*found);
    if (is_better && !better) better = BetterReading{other, false};
  }
  return better;
}

}  // namespace phrame
