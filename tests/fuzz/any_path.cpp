// Any bytes: a path of curves of any kind, or an InputError or Undecided of one line. Each segment
// of what is read begins where the one before ends.
#include "phrame/io/read/any_path.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "phrame/algebra/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace phrame;
  try {
    const NamedPath named = read_any_path({reinterpret_cast<const char*>(data), size}, {9});
    if (named.path.is_ph()) return 0;
    const auto& segments = named.path.segments();
    for (std::size_t k = 1; k < segments.size(); ++k) {
      const auto* before = std::get_if<RationalCurve>(&segments[k - 1]);
      const auto* after = std::get_if<RationalCurve>(&segments[k]);
      if (before != nullptr && after != nullptr && point(*before, 1) != point(*after, 0))
        std::abort();
    }
  } catch (const InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  } catch (const Undecided& error) {  // of formulas
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
