#include "phrame/answer/camera_path.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/local_origin.hpp"

namespace phrame::inline v0 {
namespace {

std::vector<double> camera_times(const std::vector<Rational>& numbers,
                                 const std::optional<Rational>& duration) {
  const Rational length = numbers.back() - numbers.front();
  const bool is_scaled = duration.has_value() && length > 0;
  const Rational unit = is_scaled ? *duration / length : Rational(1);
  std::vector<double> times;
  for (const Rational& x : numbers) times.push_back(round_to_double((x - numbers.front()) * unit));
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (numbers[k] <= numbers[k - 1])
      throw InputError(
          fmt::format("a camera path needs ascending times, and row {} is not after "
                      "the one before",
                      k + 1));
    const auto time = static_cast<float>(times[k]);
    if (!(time > static_cast<float>(times[k - 1])) || std::isinf(time))
      throw InputError(fmt::format("the time {} of row {} is, as a float, {}", times[k], k + 1,
                                   std::isinf(time) ? "infinite" : "that of the row before"));
  }
  return times;
}

void require_floats(const Vector<double>& place, std::size_t row) {
  for (const double x : place)
    if (std::abs(x) > std::numeric_limits<float>::max())
      throw InputError(
          fmt::format("the place {} of row {} does not fit a float, of at most 3.4e38", x, row));
}

}  // namespace

TableColumns camera_columns(TabulatedFrame frame) {
  TableColumns columns{{frame}};
  columns.have_quaternions = true;
  columns.are_cameras = true;
  return columns;
}

CameraPath camera_path(const FrameTable& table, const std::vector<Rational>& numbers,
                       const std::optional<Rational>& duration) {
  if (numbers.size() < 2) throw InputError("a camera path needs two rows or more");
  CameraPath path{camera_times(numbers, duration), {}, {}, table.start, table.up};
  for (const std::vector<double>& row : table.rows) {
    path.places.push_back({row[1], row[2], row[3]});
    path.rotations.push_back({row[13], row[14], row[15], row[16]});
    require_floats(path.places.back(), path.places.size());
  }
  path.origin = local_origin(path.places);
  return path;
}

}  // namespace phrame
