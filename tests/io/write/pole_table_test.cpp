#include "phrame/io/write/pole_table.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/io/write/text.hpp"

using namespace phrame;

namespace {

std::string table(const Polynomial& n, const Polynomial& d, long most = 24) {
  const auto found = pole_table(integrate({n, d}, Form::partial_fractions), most);
  return found ? to_text(*found) : "";
}

}  // namespace

TEST_CASE("pole table: a residue on an axis and a pole on an axis are proved to be") {
  // 1/(t² + 1) = Σ (−z/2)/(t − z) over z = ±i.
  CHECK(table({1}, {1, 0, 1}) ==
        "\n  pole z               residue c(z)\n"
        "  0 ± 1.00000000000i   0 ∓ 0.500000000000i\n");
  // 2t/(t² + 2): the residues are 1.
  CHECK(table({0, 2}, {2, 0, 1}).find("0 ± 1.41421356237i   1.00000000000\n") != std::string::npos);
  // 1/(t² + t + 1): c = ∓i/√3 at z = (−1 ± i√3)/2.
  CHECK(table({1}, {1, 1, 1}).find("−0.500000000000 ± 0.866025403784i   0 ∓ 0.577350269190i\n") !=
        std::string::npos);
}

TEST_CASE("pole table: proofs by counting hold where only some of the numbers lie on an axis") {
  // t⁴ − 2: two real poles, two imaginary ones; c = z/8 for 1/(t⁴ − 2) as z³·z = 2.
  CHECK(table({1}, {-2, 0, 0, 0, 1}) ==
        "\n  pole z               residue c(z)\n"
        "  −1.18920711500       −0.148650889375\n"
        "  1.18920711500        0.148650889375\n"
        "  0 ± 1.18920711500i   0 ± 0.148650889375i\n");
  // t⁴ + 10t² + 1 and t⁴ + t + 1: all roots on the imaginary axis, none on it.
  const std::string none = table({1}, {1, 1, 0, 0, 1});
  CHECK(none.find(" 0 ") == std::string::npos);
  const std::string all = table({1}, {1, 0, 10, 0, 1});
  CHECK(all.find("  0 ± 0.317837245196i   0 ∓ 0.160557") != std::string::npos);
  CHECK(all.find("  0 ± 3.14626436994i    0 ± 0.0162195") != std::string::npos);
}

TEST_CASE("pole table: a pole at 0 and rational poles") {
  // 1/(t(t − 2)) = −(1/2)/t + (1/2)/(t − 2).
  const std::string text = table({1}, {0, -2, 1});
  CHECK(text.find("  0               −0.500000000000\n") != std::string::npos);
  CHECK(text.find("  2.00000000000   0.500000000000\n") != std::string::npos);
}

// z = e ± i and c = ∓i/2, which is proved where the coefficients are not too long for it.
TEST_CASE("pole table: what cannot be told from 0 is a bound, not 0") {
  const auto near_i = [](const Rational& e) { return table({1}, {1 + e * e, -2 * e, 1}); };
  CHECK(near_i(parse_rational("1e-5000"))
            .find("\n  1.00000000000e-5000 ± 1.00000000000i   0 ∓ 0.500000000000i\n") !=
        std::string::npos);
  const std::string text = near_i(parse_rational("1e-20000"));
  CAPTURE(text);
  CHECK(text.find(" ± 1.00000000000i   (|·| < ") != std::string::npos);
  CHECK(text.find(") ∓ 0.500000000000i\n") != std::string::npos);
}

TEST_CASE("pole table: none without poles, with too many, and over residues") {
  CHECK(table({}, {1}) == "");
  const Polynomial d = Polynomial::monomial(1, 25) + Polynomial{2};
  CHECK(abridged(table({1}, d)) == "\n  ⟨25 poles and their residues⟩\n");
  // One real pole and 12 pairs, below the head line.
  const std::string all = table({1}, d, 25);
  CHECK(std::count(all.begin(), all.end(), '\n') == 15);
  CHECK_FALSE(table({1}, Polynomial::monomial(1, 24) + Polynomial{2}) == "");
  CHECK_FALSE(pole_table(integrate({{1}, {1, 0, 1}}, Form::rothstein_trager), 24));
}
