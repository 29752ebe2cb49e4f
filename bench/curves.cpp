#include "curves.hpp"

#include <cstdint>

namespace phrame::inline v0::bench {
namespace {

/// Knuth's 64-bit linear congruential generator; its upper bits are used.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  long coefficient() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<long>((state_ >> 33U) % 19) - 9;
  }

 private:
  std::uint64_t state_;
};

}  // namespace

std::string random_curve_text(long m) {
  Random random(2003 + static_cast<std::uint64_t>(m));
  std::string text = R"({"phrame": "curve/1", "basis": "power", "preimage": {)";
  for (const char* name : {"u", "v", "p", "q"}) {
    text += *name == 'u' ? "\"" : ", \"";
    text += name;
    text += "\": [";
    for (long k = 0; k < m; ++k) text += std::to_string(random.coefficient()) + ", ";
    const long lead = random.coefficient();
    text += std::to_string(lead == 0 ? 1 : lead) + "]";
  }
  return text + "}}";
}

Curve random_curve(long m) { return read_curve(random_curve_text(m)).curve; }

Path bezier_path(long degree) {
  Random random(2026);
  const auto next = [&random] { return Rational(random.coefficient()); };
  std::vector<Vector<Rational>> points;
  for (long k = 0; k <= degree; ++k) {
    const Rational x = next();
    const Rational y = next();
    points.push_back({x, y, next()});
  }
  return Path(bezier_curve(points));
}

}  // namespace phrame::bench
