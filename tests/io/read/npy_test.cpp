// The files are NumPy's own, written by tests/data/numpy_tables.py; their numbers are those there.
#include "phrame/io/read/npy.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/frame_csv.hpp"
#include "support/data.hpp"
#include "support/refusal.hpp"

namespace npy_test {

using namespace phrame;

namespace {

std::string bytes_of(const std::string& name) {
  std::ifstream file(test::data("/numpy/" + name), std::ios::binary);
  REQUIRE(file.good());
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

using Rows = std::vector<std::vector<Rational>>;

Rows rows_of(const std::string& name) {
  const std::string bytes = bytes_of(name);
  REQUIRE(NpyTable::is_one(bytes));
  const NpyTable table(bytes);
  Rows rows;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    rows.emplace_back();
    for (std::size_t c = 0; c < table.columns(); ++c) rows.back().push_back(table.number(r, c));
  }
  return rows;
}

std::string refusal(const std::string& bytes) {
  return test::refusal_of([&] { read_frames(bytes); });
}

/// The double next to 1/10, that next to 1/3 and the least one.
const Rational tenth(Integer("3602879701896397"), Integer("36028797018963968"));
const Rational third(Integer("6004799503160661"), Integer("18014398509481984"));
const Rational least = power_of_two(-1074);

}  // namespace

TEST_CASE("npy: doubles of both byte orders, in C and Fortran order, are read exactly") {
  const Rows expected{
      {0, tenth, third, -2}, {Rational(1, 2), least, exact_rational(1e300), 0}, {-3, 1, 2, 3}};
  for (const char* name :
       {"c.npy", "fortran.npy", "big-endian.npy", "version-2.npy", "version-3.npy"}) {
    CAPTURE(name);
    CHECK(rows_of(name) == expected);
  }
}

// Computed from the bytes by Python's struct and fractions.
TEST_CASE("npy: numbers of 2 and 4 bytes and integers are read exactly") {
  CHECK(rows_of("single.npy") ==
        Rows{{0, Rational(13421773, 134217728), Rational(11184811, 33554432), -2},
             {Rational(1, 2), Rational(8444249L, 140737488355328L), 65504, 0},
             {-3, 1, 2, 3}});
  CHECK(rows_of("half.npy") == Rows{{0, Rational(819, 8192), Rational(1365, 4096), -2},
                                    {Rational(1, 2), Rational(1, 16777216), 65504, 0},
                                    {-3, 1, 2, 3}});
  CHECK(rows_of("integer.npy") == Rows{{0, -1, -128, 7}, {1, -1, 0, 127}});
  CHECK(rows_of("unsigned.npy") == Rows{{0, power_of_two(64) - 1, power_of_two(63), 7}});
}

TEST_CASE("npy: the fields of a structured array are columns") {
  const std::string bytes = bytes_of("structured.npy");
  CHECK(NpyTable(bytes).names() ==
        std::vector<std::string>{"note", "f2x", "f2y", "f2z", "t", "ok"});
  const GivenTable table = read_frames(bytes);
  REQUIRE(table.frames.size() == 3);
  CHECK(table.columns.empty());
  CHECK(table.frames[0].t == 0);
  CHECK(table.frames[0].f2 == Vector<Rational>{tenth, third, -2});
  CHECK(table.frames[1].t == Rational(1, 2));
  CHECK(table.frames[1].f2 == Vector<Rational>{least, exact_rational(1e300), 0});
  const GivenTable turned = read_frames(bytes_of("quaternions.npy"));
  CHECK(turned.frames.at(0).t == 7);
  CHECK(turned.frames.at(0).tangent == Vector<Rational>{0, 1, 0});
}

TEST_CASE("npy: what is not a table of numbers is refused in a line") {
  CHECK(refusal(bytes_of("one-dimension.npy")) ==
        "header: an array of two dimensions is wanted, or of matrices, (n, 4, 4) or (n, 3, 4), not "
        "of 1");
  CHECK(refusal(bytes_of("three-dimensions.npy")) ==
        "header: an array of two dimensions is wanted, or of matrices, (n, 4, 4) or (n, 3, 4), not "
        "of 3");
  CHECK(refusal(bytes_of("complex.npy")).starts_with("header: numbers of the type '<c16'"));
  CHECK(refusal(bytes_of("objects.npy")).starts_with("header: the array holds objects"));
  CHECK(refusal(bytes_of("nan.npy")) ==
        "row 0, f2y: \"nan\" is not a number; --skip-invalid leaves such rows out");
  CHECK(refusal(bytes_of("empty.npy")) == "data: there are no frames");
  CHECK(refusal(bytes_of("archive.npz")).find("archive") != std::string::npos);
  const std::string good = bytes_of("c.npy");
  CHECK(refusal(good).empty());
  CHECK(refusal(good + "x") == "data: wanted: 3 × 4 numbers of 8 bytes each; there: 97 bytes");
  for (std::size_t length = 6; length < good.size(); ++length)
    CHECK_FALSE(refusal(good.substr(0, length)).empty());
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string bytes = good;
    return bytes.replace(bytes.find(from), from.size(), to);
  };
  CHECK(refusal(with("\x01", "\x04")).starts_with("header: version 4"));
  // Sizes whose product is 12 modulo 2⁶⁴.
  CHECK(refusal(with("(3, 4), }" + std::string(18, ' '), "(4611686018427387907, 4), }"))
            .starts_with(
                "data: wanted: 4611686018427387907 × 4 numbers of 8 bytes each; there: 96 bytes"));
  CHECK(refusal(with("'<f8'", "'<f9'")).starts_with("header: numbers of the type '<f9'"));
  CHECK(refusal(with("'<f8'", "'<f8 ")).starts_with("header: "));
  CHECK(refusal(with("False", "0    ")).starts_with("header: "));
}

}  // namespace npy_test
