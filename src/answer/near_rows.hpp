#pragma once
#include <functional>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/orientation_columns.hpp"
#include "phrame/answer/row_places.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/compiled_length.hpp"
#include "phrame/ph/frame/compiled_point.hpp"
#include "phrame/ph/frame/near_rotation.hpp"

namespace phrame::inline v0 {

/// Does it pay to compile the path for so many rows? A segment of a spline mostly is one piece,
/// where a random curve has ten or more: three segments of many are tried, with the angle that is
/// asked for then, which is not measured from the Frenet frame.
bool are_many_rows(std::size_t rows, const Path& path, bool is_by_length,
                   const std::function<PathAngle()>& angle);

/// What make() makes; nothing where the polynomials are not found: then each row goes the exact
/// way.
template <class Make>
auto where_compiled(const Make& make) -> std::optional<decltype(make())> {
  try {
    return make();
  } catch (const Undecided&) {
  } catch (const DomainError&) {
  }
  return std::nullopt;
}

/// What doubles tell of the rows of a table, each number correctly rounded: nearly all rows of
/// tables that are long enough to compile the path, and of others the rotation-minimizing frames of
/// PH curves. Any thread may ask.
class NearRows {
 public:
  /// Of these columns at these places; the rotation-minimizing frame starts at that angle.
  NearRows(const PathAngle& angle, const TableColumns& columns, const StartAngle& start,
           const RowPlaces& places);

  /// Makes `rows` those from number `first` on. The numbers of those of which any cell is not told,
  /// ascending; what is in them then is no matter.
  std::vector<std::size_t> make(std::size_t first, std::span<std::vector<double>> rows) const;
  /// The same numbers, without the rows.
  std::vector<std::size_t> untold(std::size_t first, std::size_t count) const;

  /// @{ Parts of row k.
  std::optional<NearNumber> parameter(std::size_t k) const;
  std::optional<Vector<double>> position(const NearNumber& t) const;
  std::optional<Frame<double>> frame(const NearNumber& t, const Place& at) const;
  /// @}

 private:
  struct Columns;
  void compile(const PathAngle& angle, const StartAngle& start);
  void prepare_few(const PathAngle& angle, const StartAngle& start);
  Columns made(std::size_t first, std::size_t count) const;

  const TableColumns& columns_;
  const RowPlaces& places_;
  OrientationColumns orientations_;
  bool has_rows_ = false;
  double from_ = 0;  ///< t of the polynomials
  double to_ = 0;
  std::optional<CompiledPoints> points_;
  std::optional<CompiledFrames> frames_;
  std::optional<NearRotations> rotations_;  ///< where frames are not compiled
  std::optional<CompiledLength> length_;
};

}  // namespace phrame
