#include "phrame/cli/given_frames.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/frame_parameters.hpp"

namespace phrame::inline v0::cli {
namespace {

/// Do they need other parameters: have they none, or some that the curve does not have, as times?
bool lacks_parameters(const GivenTable& table, const Path& path) {
  if (!table.has_parameters) return true;
  if (goes_on(path) || table.positions.size() != table.frames.size()) return false;
  return std::ranges::any_of(
      table.frames, [&](const GivenFrame& frame) { return frame.t < 0 || frame.t > path.end(); });
}

/// Are they those of the curve at the t of the table? Then that t is right.
bool has_places(const GivenTable& table, const Path& path) {
  if (!table.has_parameters || table.positions.size() != table.frames.size()) return false;
  return !lacks_parameters(table, path) &&
         are_on_curve(path, table.positions, Rational(1, 1'000'000));
}

/// Other t for the frames than those of the table, with how they are found; no value where these
/// are right, or no others.
std::optional<FrameParameters> parameters_on(const NamedPath& named, const GivenTable& table,
                                             const std::optional<ParameterKind>& by) {
  if (by == ParameterKind::t) return std::nullopt;
  if (by) {
    FrameParameters found = parameters_by(*by, named, table.frames);
    found.what.clear();  // as was asked for
    return found;
  }
  const bool may_be_others = table.has_parameters && table.frames.size() <= most_guessed_frames;
  if (may_be_others && !has_places(table, named.path))
    if (auto found = better_parameters(named, table.frames)) {
      found->what = "t is taken for " + found->what;
      return found;
    }
  if (!lacks_parameters(table, named.path)) return std::nullopt;
  FrameParameters found = frame_parameters(named.path, table.positions);
  found.what = "t is taken from the positions: " + found.what;
  return found;
}

}  // namespace

FramesOnCurve read_on_curve(const NamedPath& named, const std::string& bytes,
                            const std::string& file, const std::optional<ParameterKind>& by,
                            FrameReading& reading) {
  if (by) require_parameter(named.path, *by);
  GivenTable table = at_place(file, ":", [&] { return read_frames(bytes, reading); });
  for (const std::string& text : table.notes) note_at_end(fmt::format("{}: {}", file, text));
  auto found = at_place(file, ":", [&] { return parameters_on(named, table, by); });
  if (!found) return {std::move(table), ""};
  if (!found->what.empty()) note_at_end(fmt::format("{}: {}", file, found->what));
  reading.parameters = std::move(found->t);
  return {read_frames(bytes, reading), std::move(found->what)};
}

}  // namespace phrame::cli
