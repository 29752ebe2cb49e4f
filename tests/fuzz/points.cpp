// Any bytes, points/1, a table of text or .npy: points and then a curve, or an error of one line.
// The first byte chooses the kind, and whether the curve is closed and meets the points.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/construction.hpp"
#include "phrame/io/read/point_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    const std::string_view bytes{reinterpret_cast<const char*>(data) + 1, size - 1};
    const phrame::GivenPoints given = phrame::read_points(bytes);
    if (given.points.size() > 10) return 0;
    phrame::ConstructQuery query;
    query.tolerance = phrame::Rational(1, 1000);
    query.is_closed = data[0] % 2 == 1;
    if (data[0] / 2 % 8 == 7) query.points = phrame::PointRule::exact;
    const auto& kinds = phrame::curve_kinds();
    query.kind = kinds[data[0] / 16 % kinds.size()].kind;
    const phrame::ConstructionAnswer found = phrame::answer(given, query);
    const auto& [tolerance, deviation] = std::pair(found.tolerance, found.deviation);
    if (deviation.points > tolerance.points || deviation.derivatives > tolerance.derivatives ||
        deviation.accelerations > tolerance.accelerations ||
        found.path.path.closing_turn().has_value() < query.is_closed)
      std::abort();
  } catch (const phrame::Error& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
