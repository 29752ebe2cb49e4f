#pragma once
#include <optional>
#include <string_view>

#include "phrame/export.hpp"
#include "phrame/ph/sweep/profile.hpp"

namespace phrame::inline v0 {

/// How near a polygon is to the curve that it stands for.
struct ProfileTolerance {
  std::optional<Rational> distance = {};  ///< > 0; none: 1/1000 of the size of the curve
  std::optional<Rational> angle = {};     ///< of its sides, in radians, > 0
};

/// "circle:R", "polygon:N,R" (regular, with a corner on the axis of f₂) or "rectangle:W,H"; no
/// value for what is none of these words with a ':'. Throws InputError.
PHRAME_API std::optional<Profile> parse_profile(std::string_view text,
                                                const ProfileTolerance& tolerance = {});

/// A polygon or outline from the bytes of a file: a table of x, y, a corner a row, an empty line
/// between two rings, or an SVG file or path data; a subpath that is not closed is closed by a
/// line. One ring or subpath goes around all others, which are holes, whatever fill-rule says. The
/// y of SVG, which is down there, is up. Throws InputError, its place line:column or "line 3".
PHRAME_API Profile read_profile(std::string_view bytes, const ProfileTolerance& tolerance = {});

}  // namespace phrame
