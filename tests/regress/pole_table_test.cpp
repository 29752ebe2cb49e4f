// The table of poles and residues was computed with 128 bits, and printed "0" for whatever they
// could not tell from 0.
#include "phrame/io/write/pole_table.hpp"

#include <doctest/doctest.h>

#include "phrame/ph/along/rmf_angle.hpp"

using namespace phrame;

// u = t, v = 10⁻⁴⁰, p = t², q = 2t² + t³: the poles with the tiny parts are t ≈ ±10⁻⁴⁰i. There
// σ = t² + 10⁻⁸⁰ + O(t⁴) and −2h = 2·10⁻⁴⁰ + O(t⁴), so that c ≈ −2h/(2t) = ∓i.
TEST_CASE("pole table: a tiny component is not 0") {
  const Polynomial tiny{parse_rational("1e-40")};
  const Curve curve({{0, 1}, tiny, {0, 0, 1}, {0, 0, 2, 1}});
  const std::string table =
      to_text(pole_table(RmfAngle(curve, Reference::euler_rodrigues).angle_to_erf(), 24).value());
  CAPTURE(table);
  CHECK(table.find("−0.0453753717") != std::string::npos);
  CHECK(table.find(" ∓ 0.8794724536") != std::string::npos);
  CHECK(table.find(" ± 1.00000000000e-40i") != std::string::npos);
  CHECK(table.find(" 0 ") == std::string::npos);
}
