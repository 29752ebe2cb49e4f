// Any bytes, points/1, a table of text or .npy: points and then a curve, or an error of one line.
// The first byte chooses the kind, the tolerance, and whether the curve is closed and meets the
// points.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/construction.hpp"
#include "phrame/io/read/point_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    const std::string_view bytes{reinterpret_cast<const char*>(data) + 1, size - 1};
    const phrame::GivenPoints given = phrame::read_points(bytes);
    if (given.points.size() > 10) return 0;
    phrame::ConstructQuery query;
    query.is_closed = data[0] % 2 == 1;
    const int rule = data[0] / 2 % 8;
    if (rule == 7) query.points = phrame::PointRule::exact;
    constexpr std::array places{3, 3, 3, 15, 15, 15, 40, 15};
    query.tolerance = phrame::power_of_ten(-places[static_cast<std::size_t>(rule)]);
    const auto& kinds = phrame::curve_kinds();
    query.kind = kinds[data[0] / 16 % kinds.size()].kind;
    const phrame::ConstructionAnswer found = phrame::answer(given, query);
    const auto& [tolerance, deviation] = std::pair(found.tolerance, found.deviation);
    if (deviation.points > tolerance.points || deviation.derivatives > tolerance.derivatives ||
        deviation.accelerations > tolerance.accelerations ||
        found.path.path.closing_turn().has_value() < query.is_closed ||
        (query.points == phrame::PointRule::exact && deviation.points != 0))
      std::abort();
  } catch (const phrame::Error& error) {
    // Any other is a law that does not hold of what was made.
    if (dynamic_cast<const phrame::InputError*>(&error) == nullptr &&
        dynamic_cast<const phrame::DomainError*>(&error) == nullptr &&
        dynamic_cast<const phrame::Undecided*>(&error) == nullptr)
      std::abort();
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
