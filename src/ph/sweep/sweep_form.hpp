#pragma once
#include <optional>
#include <variant>

#include "phrame/ph/curve/curve_series.hpp"
#include "phrame/ph/curve/roll.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/sweep/mesh_numbers.hpp"
#include "phrame/ph/sweep/profile.hpp"
#include "phrame/ph/sweep/sweep_scale.hpp"

namespace phrame::inline v0 {

/// A path with its rotation-minimizing frame, as a sweep sees it.
struct SweepPath {
  CurveSeries series;      ///< the path, of PH curves or of any kind
  CompiledFrames frames;   ///< on [0, the number of segments]
  bool is_closed = false;  ///< so that it needs no caps?
  /// The segments, ascending, that begin with a corner, 0 where the ends of a closed path meet at
  /// one.
  std::vector<std::size_t> corners = {};
  std::vector<bool> are_lines = {};  ///< of each segment, where there are corners
};
/// Of this path, which frames() are of.
SweepPath sweep_path(const Path& path, CompiledFrames frames);

/// How a profile turns along some segments.
struct SweepLeg {
  std::size_t end;           ///< behind the last of them
  double turn;               ///< T, so much against the rotation-minimizing frame
  double rate_at_start = 0;  ///< what dφ/ds is at the start beyond T/S, S the length
  double rate_at_end = 0;    ///< and at the end; between them φ is a cubic polynomial of s
};

/// How a profile is swept.
struct SweepForm {
  Profile profile;        ///< what is swept
  SweepScale scale = {};  ///< the profile is λ(t) times as large there, λ > 0 on the path
  /// The angle in radians by which the profile turns against the frame, at a constant rate per
  /// length.
  double turn = 0;
  /// The greatest distance between the points of the surface and those of the mesh, both ways; or
  /// the number of sections, at equal steps of t.
  std::variant<Rational, long> tolerance_or_sections;
  /// With a distance: the greatest angle in radians, < π/2, between the normal of a triangle and
  /// those of the part of the surface that it stands for.
  std::optional<double> normal_tolerance = {};
  /// The origin of the coordinates of the mesh. Without it, a place near the body is taken.
  std::optional<Vector<Rational>> origin = Vector<Rational>{};
  Coordinates numbers = Coordinates::doubles;  ///< that the coordinates are
  /// What it turns beside that: one after the other, to the end of the path; or none.
  std::vector<SweepLeg> legs = {};
  Roll roll = {};  ///< and beside that
};

/// A part of a segment of a path.
struct SweepPart {
  std::size_t segment;  ///< of the path
  double from;          ///< in [0, 1)
  double to;            ///< in (0, 1]

  /// The parameter of the path there.
  double start() const { return static_cast<double>(segment) + from; }
  double step() const { return to - from; }  ///< > 0
};

}  // namespace phrame
