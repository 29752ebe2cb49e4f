#include "phrame/io/frame_table.hpp"

#include <bit>
#include <cstdint>
#include <cstdlib>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"

using namespace phrame;

namespace {

using Row = std::vector<double>;
using Kind = TabulatedFrame;

/// A = 1 + t²k: r′ = (1 − t⁴, 2t², 0), a plane curve with an inflection at t = 0.
Curve inflected() {
  return Curve({Polynomial{1}, Polynomial(), Polynomial(), Polynomial{0, 0, 1}});
}

std::string message(const Curve& curve, TabulatedFrame frame, const Rational& t) {
  try {
    frame_table(curve, {frame}, {t});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("frame table: the columns are named after the vectors, in the order asked for") {
  const FrameTable table =
      frame_table(test::farouki_quintic().curve, {Kind::frenet, Kind::rmf, Kind::erf}, {});
  CHECK(table.columns == std::vector<std::string>{"t",   "x",   "y",   "z",   "e1x", "e1y", "e1z",
                                                  "nx",  "ny",  "nz",  "bx",  "by",  "bz",  "f2x",
                                                  "f2y", "f2z", "f3x", "f3y", "f3z", "e2x", "e2y",
                                                  "e2z", "e3x", "e3y", "e3z"});
  CHECK(table.rows.empty());
}

// At t = 1, A = 1 + i + j + k turns i → j → k → i, so (e₁, e₂, e₃) = (j, k, i), and θ = −1:
// f₂ = cos 1·k − sin 1·i, f₃ = sin 1·k + cos 1·i. r(1) = ∫₀¹ A i A*: x′ = u² + v² − p² − q² = t⁴ −
// 1, y′ = 2(uq + vp) = 4t², z′ = 2(vq − up) = 2t − 2t³. The decimals of cos 1 and sin 1 are well
// known.
TEST_CASE("frame table: values are the correctly rounded doubles") {
  const double cos1 = 0.540302305868139717400936607443;
  const double sin1 = 0.841470984807896506652502321630;
  const Curve curve = test::rational_angle_curve().curve;
  const FrameTable table = frame_table(curve, {Kind::erf, Kind::rmf}, {0, 1});
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[1] == Row{1, -0.8, 4.0 / 3, 0.5, 0, 1, 0,  //
                             0, 0, 1, 1, 0, 0,                //
                             -sin1, 0, cos1, cos1, 0, sin1});
  // At t = 0, A = k: e₁ = k i k* = −i, e₂ = −j, e₃ = k, and the RMF is the ERF.
  CHECK(table.rows[0] == Row{0, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1, 0, -1, 0, 0, 0, 1});
}

// At t = 1 the tangent is j and turns to the left (its angle is 2 atan t²): n = −i, b = k.
// r(1) = (1 − 1/5, 2/3, 0).
TEST_CASE("frame table: the Frenet frame is tangent, normal, binormal") {
  const FrameTable table = frame_table(inflected(), {Kind::frenet}, {1});
  CHECK(table.rows.at(0) == Row{1, 0.8, 2.0 / 3, 0, 0, 1, 0, -1, 0, 0, 0, 0, 1});
}

TEST_CASE("frame table: where Frenet's frame is undefined, the reason and t are named") {
  CHECK_THROWS_AS(frame_table(inflected(), {Kind::frenet}, {1, 0}), DomainError);
  CHECK(message(inflected(), Kind::frenet, 0).find("t = 0 is an inflection") != std::string::npos);
  CHECK_THROWS_AS(frame_table(test::straight_line().curve, {Kind::frenet}, {1}), DomainError);
  CHECK(message(test::straight_line().curve, Kind::frenet, 1).find("straight line") !=
        std::string::npos);
  CHECK(message(inflected(), Kind::rmf, 0).empty());
}

TEST_CASE("frame table: an overflow is refused, not rounded to infinity") {
  // r = (t, 0, 0)
  CHECK(
      frame_table(test::straight_line().curve, {Kind::rmf}, {test::power_of_ten(308)}).rows[0][1] ==
      1e308);
  CHECK_THROWS_AS(frame_table(test::straight_line().curve, {Kind::rmf}, {test::power_of_ten(309)}),
                  Undecided);
  CHECK(message(test::farouki_quintic().curve, Kind::erf, test::power_of_ten(100))
            .find("x is beyond the range of doubles") != std::string::npos);
}

TEST_CASE("frame table: CSV reads back to the same doubles") {
  const FrameTable table = frame_table(test::farouki_quintic().curve, {Kind::rmf, Kind::frenet},
                                       {0, Rational(1, 3), test::power_of_ten(-30), -1000});
  std::istringstream lines(to_csv(table));
  std::string line;
  REQUIRE(std::getline(lines, line));
  CHECK(line == "t,x,y,z,e1x,e1y,e1z,f2x,f2y,f2z,f3x,f3y,f3z,nx,ny,nz,bx,by,bz");
  for (const Row& row : table.rows) {
    REQUIRE(std::getline(lines, line));
    Row read;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      char* end = nullptr;
      read.push_back(std::strtod(cell.c_str(), &end));
      CHECK(*end == '\0');
    }
    CHECK(read == row);
  }
  CHECK_FALSE(std::getline(lines, line));
}

TEST_CASE("frame table: JSON reads back to the same doubles") {
  const FrameTable table =
      frame_table(test::farouki_quintic().curve, {Kind::rmf}, {0, Rational(1, 7), 1});
  const test::Json json = test::Json::parse(to_json(table));
  CHECK(json["phrame"] == "frames/1");
  CHECK(json["columns"].get<std::vector<std::string>>() == table.columns);
  CHECK(json["rows"].get<std::vector<Row>>() == table.rows);
}

// numpy.lib.format: "\x93NUMPY", version 1.0, the length of the header in two bytes, low one first,
// the header, a Python literal that ends in a newline and pads all to a multiple of 64, then the
// data.
TEST_CASE("frame table: npy has a valid header, then the rows as little-endian doubles") {
  for (const std::size_t count : {0U, 1U, 3U, 12U, 101U}) {
    FrameTable table{{"t", "x"}, {}};
    for (std::size_t k = 0; k < count; ++k)
      table.rows.push_back({1.0 / (1.0 + static_cast<double>(k)), -2.5});
    const std::string bytes = to_npy(table);
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes.at(k)); };
    CHECK(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t length = byte(8) + 256U * byte(9);
    CHECK((10 + length) % 64 == 0);
    const std::string header = bytes.substr(10, length);
    const std::string literal =
        "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(count) + ", 2), }";
    CHECK(header.starts_with(literal));
    CHECK(header.find_first_not_of(' ', literal.size()) == length - 1);
    CHECK(header.back() == '\n');
    REQUIRE(bytes.size() == 10 + length + 16 * count);
    for (std::size_t k = 0; k < 2 * count; ++k) {
      std::uint64_t bits = 0;
      for (std::size_t b = 8; b-- > 0;) bits = bits << 8U | byte(10 + length + 8 * k + b);
      CHECK(std::bit_cast<double>(bits) == table.rows[k / 2][k % 2]);
    }
  }
}
