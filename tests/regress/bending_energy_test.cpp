// Wherever the curve had a cusp on [0, 1] its bending energy was said to be infinite.
#include <doctest/doctest.h>

#include "phrame/answer/info.hpp"
#include "phrame/io/write/answers.hpp"

using namespace phrame;

namespace {

/// A = 1 + ck with c = t² − t: σ = 1 + c², g = c′ = 2t − 1, ρ = 4(2t − 1)².
InfoAnswer info(const Polynomial& multiplier) {
  return answer(NamedCurve{"", Curve({{1}, {}, {}, {0, -1, 1}}, multiplier)}, InfoQuery{20});
}

const Polynomial middle{-1, 2};

}  // namespace

TEST_CASE("bending energy: it is finite at a cusp where the bend vanishes, too") {
  // ρ/((2t − 1)²σ³) = 4/σ³ with 1 ≤ σ ≤ 17/16.
  const InfoAnswer ahead = info(pow(middle, 2));
  REQUIRE(ahead.cusps.size() == 1);
  REQUIRE(ahead.bending_energy);
  const Rational energy = parse_rational(ahead.bending_energy->value);
  CHECK(energy < 4);
  CHECK(energy > Rational(4 * 16 * 16 * 16, 17 * 17 * 17));
  const InfoAnswer back = info(-pow(middle, 2));
  REQUIRE(back.bending_energy);
  CHECK(back.bending_energy->value == ahead.bending_energy->value);
}

TEST_CASE("bending energy: it is infinite at a pole that remains") {
  const InfoAnswer infinite = info(pow(middle, 3));
  CHECK_FALSE(infinite.bending_energy);
  CHECK(to_text(infinite).find("energy ∫₀¹ κ² ds    ∞\n") != std::string::npos);
  CHECK_FALSE(info({0, 1}).bending_energy);  // at an end
  CHECK(info({1, 1}).bending_energy);
}

TEST_CASE("bending energy: it is known where the multiplier changes sign") {
  // ∫ 4|2t − 1|/σ³ dt = 8·∫ dc/(1 + c²)³ from −1/4 to 0 = 332/289 + 3·arctan(1/4).
  REQUIRE(info(middle).bending_energy);
  CHECK(info(middle).bending_energy->value == "1.8837249167162326009");
}
