#pragma once
#include <string>
#include <string_view>
#include <variant>

#include "phrame/export.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame::inline v0 {

/// A place in a JSON document; its definition is not public.
class JsonNode;

/// What is refused because it would take too long.
struct CurveLimits {
  long max_degree = 1001;  ///< of the curve, 2m + 1 + deg f
  /// What the caller calls the ε of read_path_near(), "--near". Where control points are refused
  /// that are near those of a PH curve, the message then says how near; that takes some time.
  std::string near_option = {};
  /// Up to where gaps between segments are closed (close_gaps()).
  std::optional<Rational> gap = {};
};

/// Reads a curve/1 file (README, "Curve files"): `preimage`, `quaternions`, `hopf` or `complex`,
/// with `basis` and optionally `name`, `start` and `multiplier` (in the same basis); or
/// `control_points` of a Bézier curve, which is identified as a PH curve or refused. Numbers are
/// read exactly. `note`, `family` and `expected` are remarks and are skipped. Throws InputError;
/// its place is a JSON pointer, or line:column where the JSON itself is broken.
PHRAME_API NamedCurve read_curve(std::string_view text, const CurveLimits& limits = {});
/// The same as a part of a document.
PHRAME_API NamedCurve read_curve(const JsonNode& node, const CurveLimits& limits = {});

/// Reads a curve/1 file, or a spline/1 file: `segments`, a list of curves, each starting where the
/// one before ends; `start` may be left out of all but those given by control points. Throws
/// InputError as read_curve, and with the segment at whose start position or tangent break.
PHRAME_API NamedPhPath read_path(std::string_view text, const CurveLimits& limits = {});
/// The same as a part of a document, where a curve may do without "phrame": "curve/1".
PHRAME_API NamedPhPath read_path(const JsonNode& node, const CurveLimits& limits = {});

/// Reads the same files, but where control points are those of no PH curve, it takes one that is at
/// most ε > 0 away (near_curve); a spline with such a segment is replaced as a whole (near_path).
PHRAME_API std::variant<NamedPhPath, NotNear> read_path_near(std::string_view text,
                                                             const Rational& epsilon,
                                                             const CurveLimits& limits = {});
/// The same as a part of a document.
PHRAME_API std::variant<NamedPhPath, NotNear> read_path_near(const JsonNode& node,
                                                             const Rational& epsilon,
                                                             const CurveLimits& limits = {});
/// "curve/1" or "spline/1", which it says that it is; "" for a file of another format. Throws
/// InputError for broken JSON.
PHRAME_API std::string curve_file_format(std::string_view text);

/// @{ Reads the same files, but does not ask whether the curve is PH: a rational curve, no value
/// for others; and r′ of a polynomial one. Throws InputError for one by formulas, the second for a
/// rational one, too.
PHRAME_API std::optional<NamedRationalCurve> read_rational_curve(std::string_view text,
                                                                 const CurveLimits& limits = {});
PHRAME_API NamedHodograph read_hodograph(std::string_view text, const CurveLimits& limits = {});
/// @}

}  // namespace phrame
