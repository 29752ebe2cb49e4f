#pragma once
#include <functional>
#include <optional>
#include <string_view>

#include "phrame/io/read/svg_path.hpp"

namespace phrame::inline v0 {

/// A piece of the text of an SVG file, in quotation marks there.
struct SvgAttribute {
  std::size_t begin;
  std::size_t end;
};
/// Of an element the attribute of that name.
using SvgAttributes = std::function<std::optional<SvgAttribute>(std::string_view name)>;

/// A length that has no unit, or px; no value for "auto". `name` is that of the attribute. Throws
/// InputError, its place line:column, for other units and for what is no number.
std::optional<Rational> svg_length(std::string_view text, const SvgAttribute& attribute,
                                   std::string_view name);

/// Is it an element that is drawn: rect, circle, ellipse, line, polyline or polygon?
bool is_svg_shape(std::string_view element);

/// The outline of such an element, from where and in the direction that SVG 2, 10, has it, in the
/// plane z = 0, with lengths that have no unit or px; exact, also where corners are rounded. Empty
/// where nothing is drawn. Throws InputError, its place line:column, for other units and for what
/// is no number.
std::vector<GivenSegment> read_svg_shape(std::string_view element, std::string_view text,
                                         const SvgAttributes& attribute, const PlaneMap& map,
                                         const std::string& place);

}  // namespace phrame
