#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace phrame::inline v0 {

/// What stands above a column: "X [mm]", "x (m)", "y/mm".
struct ColumnName {
  std::string name;       ///< "X"
  std::string unit = {};  ///< "mm"; empty where there is none
};

/// Takes the unit off: what is in brackets at the end, or in parentheses or behind a slash if it is
/// a unit.
ColumnName column_name(std::string_view header);

/// Is it a unit: "mm", "[mm]", "m/s", or "-", that of numbers without one?
bool is_unit(std::string_view text);
/// Without brackets or parentheses around it; that of numbers without one is empty.
std::string unit_in(std::string_view text);

/// A column of a position under another name than x, y or z.
struct PositionColumn {
  std::string family;  ///< what is left of the name: "pos" of pos_x, "position" of "Position X"
  std::size_t axis;    ///< 0, 1 or 2
};
/// Of pos_x, "Position X", posX, px, tx, x_pos, "Location X", pose.position.x and the like.
std::optional<PositionColumn> position_column(std::string_view name);

/// The columns x, y, z, or those of another family; no value where they are not all there, or it is
/// not clear which.
std::optional<std::array<std::size_t, 3>> position_columns(const std::vector<std::string>& names);

/// Is it what programs write where there is no number: nothing, NaN, an infinity, null?
bool is_missing_text(std::string_view field);

/// The text in lower case, of ASCII letters.
std::string lower_case(std::string_view text);

}  // namespace phrame
