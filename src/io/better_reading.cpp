#include "phrame/io/better_reading.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/frame/frame_check.hpp"

namespace phrame::inline v0 {
namespace {

bool has_right_tangents(const FrameVerdict& verdict) {
  return std::none_of(verdict.findings.begin(), verdict.findings.end(), [](const auto& finding) {
    return finding.kind == FrameFinding::Kind::wrong_tangent ||
           finding.kind == FrameFinding::Kind::reversed_tangent;
  });
}

/// Vectors are left out, for their columns are positions; but are they?
bool hides_vectors(const CheckAnswer& found, std::string_view bytes, const GivenTable& table,
                   const FrameReading& other) {
  const auto has_positions = [](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), "x") != names.end();
  };
  if (!has_positions(other.names) || has_positions(table.columns)) return false;
  const Rational tolerance = std::min(found.options.tolerance, Rational(1, 100));
  const std::vector<GivenPosition> positions = read_positions(bytes, other);
  return !are_on_curve(found.path.path, positions, tolerance);
}

/// By few frames, most readings are seen to be wrong.
bool are_along_few(const CheckAnswer& found, std::string_view bytes, const FrameReading& other) {
  constexpr std::size_t few = 5;
  const std::vector<GivenFrame> frames = read_frames(bytes, other, few).frames;
  return are_along_curve(found.path.path, frames, found.options.tolerance);
}

/// No value where it is not decided.
std::optional<FrameVerdict> verdict_of(const CheckAnswer& found,
                                       const std::vector<GivenFrame>& frames) {
  try {
    return answer(found.path, CheckQuery{frames, found.options}).verdict;
  } catch (const Undecided&) {
    return std::nullopt;
  }
}

}  // namespace

bool is_read_right(const CheckAnswer& found, const GivenTable& table) {
  const bool has_tangents = table.frames.front().tangent.has_value();
  return found.verdict.passes || (has_tangents && has_right_tangents(found.verdict));
}

std::optional<BetterReading> better_reading(const CheckAnswer& found, std::string_view bytes,
                                            const FrameReading& reading, const GivenTable& table) {
  if (is_read_right(found, table)) return std::nullopt;
  std::optional<BetterReading> better;
  for (const FrameReading& other : other_readings(table, reading)) {
    if (!are_along_few(found, bytes, other) || hides_vectors(found, bytes, table, other)) continue;
    const GivenTable all = read_frames(bytes, other);
    const auto verdict = verdict_of(found, all.frames);
    if (!verdict) continue;
    if (verdict->passes) return BetterReading{other, true};
    const bool is_better = all.frames.front().tangent && has_right_tangents(*verdict);
    if (is_better && !better) better = BetterReading{other, false};
  }
  return better;
}

}  // namespace phrame
