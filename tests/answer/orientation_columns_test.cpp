#include "phrame/answer/orientation_columns.hpp"

#include <algorithm>
#include <cmath>

#include "io/reference.hpp"
#include "support/curves.hpp"

using namespace phrame;

namespace {

using Kind = TabulatedFrame;
using Row = std::vector<double>;

TableColumns with_quaternions(std::vector<Kind> frames) {
  TableColumns columns{std::move(frames)};
  columns.have_quaternions = true;
  return columns;
}

Row from(const Row& row, std::ptrdiff_t first, std::ptrdiff_t count) {
  return {row.begin() + first, row.begin() + first + count};
}

/// What the vectors of a row are off those of its quaternion, at `first`.
double deviation(const Row& row, std::size_t first) {
  const Quaternion<double> q{row[first + 3], row[first], row[first + 1], row[first + 2]};
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    for (const double x : {rotated_i(q)[k] - row[4 + k], rotated_j(q)[k] - row[first - 6 + k],
                           rotated_k(q)[k] - row[first - 3 + k]})
      largest = std::max(largest, std::abs(x));
  return largest;
}

}  // namespace

// As in the test of the frame table, A = 1 + i + j + k and θ = −1 at t = 1, so that the quaternion
// is A/2·(cos ½ − i sin ½) = (c + s, c − s, c − s, c + s)/2; and A = k at t = 0.
// cos ½ = 0.87758256189037271612, sin ½ = 0.47942553860420300027 by mpmath.
TEST_CASE("orientation columns: quaternions and matrices are correctly rounded") {
  TableColumns columns = with_quaternions({Kind::rmf});
  columns.have_matrices = true;
  columns.start = Angle();
  columns.scalars = {TabulatedScalar::arc_length};
  const Curve curve = test::rational_angle_curve().curve;
  const FrameTable table = frame_table(curve, columns, {Rational(0), Rational(1)});
  CHECK(from(table.rows[0], 13, 4) == Row{0, 0, 1, 0});
  const double sum = 0.67850405024728785819;
  const double difference = 0.19907851164308485793;
  CHECK(from(table.rows[1], 13, 4) == Row{difference, difference, sum, sum});
  const Row& row = table.rows[1];
  CHECK(from(row, 17, 16) == Row{row[4], row[7], row[10], row[1],  //
                                 row[5], row[8], row[11], row[2],  //
                                 row[6], row[9], row[12], row[3], 0, 0, 0, 1});
  REQUIRE(table.columns.size() == 34);
  CHECK(row.size() == 34);
  CHECK(table.columns[13] == "rmf_qx");
  CHECK(table.columns[16] == "rmf_qw");
  CHECK(table.columns[17] == "rmf_m11");
  CHECK(table.columns[20] == "rmf_m14");
  CHECK(table.columns[32] == "rmf_m44");
  CHECK(table.columns[33] == "s");
}

// A = t + k, whose frame is the rotation-minimizing one: (0, 0, 1, t)/√(t² + 1).
TEST_CASE("orientation columns: a quaternion is the one nearer to that of the row before") {
  const Curve curve({{0, 1}, {}, {}, {1}});
  const auto z_and_w = [&](const std::vector<RealAlgebraic>& at) {
    std::vector<std::pair<bool, bool>> negative;
    for (const Row& row : frame_table(curve, with_quaternions({Kind::euler_rodrigues}), at).rows)
      negative.emplace_back(row[15] < 0, row[16] < 0);
    return negative;
  };
  using Signs = std::vector<std::pair<bool, bool>>;
  const Rational t(3, 4);
  CHECK(z_and_w({t, Rational(0), -t}) == Signs{{false, false}, {false, false}, {false, true}});
  CHECK(z_and_w({-t, Rational(0), t}) == Signs{{true, false}, {true, false}, {true, true}});
  CHECK(z_and_w({-t}) == Signs{{true, false}});
  // From 3/4 to −4/3 is half a turn: both are as near.
  CHECK(z_and_w({t, Rational(-4, 3)}) == Signs{{false, false}, {true, false}});
}

TEST_CASE("orientation columns: vectors, quaternions and matrices are of one frame") {
  std::vector<RealAlgebraic> at;
  for (long k = 0; k <= 20; ++k) at.emplace_back(Rational(k, 20));
  for (const Curve& curve : {test::quintic, test::farouki_quintic().curve}) {
    const auto rows =
        frame_table(curve, with_quaternions({Kind::rmf, Kind::euler_rodrigues, Kind::frenet}), at)
            .rows;
    for (const std::size_t first : {13UL, 23UL, 33UL})
      for (std::size_t k = 0; k < rows.size(); ++k) {
        // e₁ and 2 quantities each are rounded, products of four numbers below 1 summed.
        CHECK(deviation(rows[k], first) < 0x1p-50);
        if (k == 0) continue;
        double product = 0;
        for (std::size_t i = first; i < first + 4; ++i) product += rows[k][i] * rows[k - 1][i];
        CHECK(product > 0.9);
      }
  }
}

TEST_CASE("orientation columns: a curve of any kind has them, and empty ones") {
  // r = (t, t³, t⁴) has an inflection at t = 0.
  const Path path(
      RationalCurve({Polynomial{0, 1}, Polynomial{0, 0, 0, 1}, Polynomial{0, 0, 0, 0, 1}}));
  TableColumns columns = with_quaternions({Kind::frenet, Kind::rmf});
  columns.have_matrices = true;
  columns.may_be_empty = true;
  const FrameTable table =
      frame_table(PathAngle(path), columns, {{0, Rational(0)}, {0, Rational(1, 2)}});
  REQUIRE(table.rows.size() == 2);
  for (std::size_t k = 7; k < 33; ++k) CHECK(std::isnan(table.rows[0][k]));
  for (std::size_t k = 33; k < 59; ++k) CHECK_FALSE(std::isnan(table.rows[0][k]));
  CHECK(table.rows[0].size() == table.columns.size());
  CHECK(deviation(table.rows[1], 13) < 0x1p-50);
  CHECK(deviation(table.rows[1], 39) < 0x1p-50);
}

// A long table goes another way to its frames, but for quaternions.
TEST_CASE("orientation columns: the matrices of a long table are those of short ones") {
  TableColumns columns{{Kind::rmf}};
  columns.have_matrices = true;
  std::vector<RealAlgebraic> at;
  for (long k = 0; k <= 1500; ++k) at.emplace_back(Rational(k, 1500));
  const Curve& curve = test::quintic;
  const FrameTable table = frame_table(curve, columns, at);
  for (const std::size_t k : {7UL, 1111UL})
    CHECK(table.rows[k] == frame_table(curve, columns, {at[k]}).rows[0]);
}

// i, j, k are turned into (k, j, −i) by a quarter turn about −j: √½ = 0.70710678118654752440….
TEST_CASE("orientation columns: a camera looks along e1, with f2 up") {
  const Curve line(Quaternion<Polynomial>{Polynomial{1}, {}, {}, {}});
  TableColumns columns = with_quaternions({Kind::rmf});
  columns.are_cameras = true;
  const FrameTable table = frame_table(line, columns, {Rational(1, 3)});
  const double half_root = 0.70710678118654752440;
  CHECK(from(table.rows[0], 13, 4) == Row{0, -half_root, 0, half_root});
}
