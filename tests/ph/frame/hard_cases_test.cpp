#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/frame_table.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "support/data.hpp"
#include "support/random.hpp"

namespace hard_cases_test {

using namespace phrame;

namespace {

struct HardCase {
  std::string curve;
  Rational t;
  std::string quantity;  ///< theta, or a column of a frame table
  double value;
  long bits;  ///< of precision, that tell it from a tie; 0 where it is one, or 0
};

std::vector<HardCase> hard_cases() {
  std::ifstream file(test::data("/hard-cases.csv"));
  std::vector<HardCase> cases;
  std::string line;
  std::getline(file, line);
  REQUIRE(line == "curve,t,quantity,value,bits,note");
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::array<std::string, 5> cell;
    for (std::string& text : cell) std::getline(cells, text, ',');
    cases.push_back({cell[0], parse_rational(cell[1]), cell[2],
                     std::strtod(cell[3].c_str(), nullptr),
                     std::strtol(cell[4].c_str(), nullptr, 10)});
  }
  return cases;
}

std::map<std::string, Curve> curves() {
  std::ifstream file(test::data("/curves.jsonl"));
  std::map<std::string, Curve> curves;
  for (std::string line; std::getline(file, line);) {
    const NamedCurve named = read_curve(line);
    curves.emplace(named.name, named.curve);
  }
  return curves;
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

Real number(const Curve& curve, RmfAngle& angle, const HardCase& hard) {
  if (hard.quantity == "theta") return angle.value(hard.t);
  const auto axis = static_cast<std::size_t>(hard.quantity.back() - 'x');
  if (hard.quantity.size() == 1) return evaluate(position(curve), hard.t)[axis];
  const Frame<Real> frame = rotation_minimizing_frame(curve, angle, hard.t);
  return (hard.quantity[1] == '2' ? frame.e2 : frame.e3)[axis];
}

}  // namespace

// The values are those of tests/data/hard_cases.py, which has nothing of this library.
TEST_CASE("hard cases: every one is rounded correctly, to the last bit") {
  const auto curve = curves();
  const auto cases = hard_cases();
  CHECK(cases.size() > 60);
  for (const HardCase& hard : cases) {
    CAPTURE(hard.curve);
    CAPTURE(hard.t);
    CAPTURE(hard.quantity);
    RmfAngle angle(curve.at(hard.curve), Reference::euler_rodrigues);
    const Real x = number(curve.at(hard.curve), angle, hard);
    CHECK(bits(round_to_double(x)) == bits(hard.value));
  }
}

TEST_CASE("hard cases: with too few bits they are undecided, not guessed") {
  const auto curve = curves();
  long undecided = 0;
  for (const HardCase& hard : hard_cases()) {
    if (hard.bits < 200) continue;  // balls of fewer than 128 are not made
    CAPTURE(hard.curve);
    CAPTURE(hard.t);
    CAPTURE(hard.quantity);
    RmfAngle angle(curve.at(hard.curve), Reference::euler_rodrigues);
    const Real known = number(curve.at(hard.curve), angle, hard);
    if (known.exact()) continue;
    // Of a number that is known to be irrational there never are too few: that is forgotten here.
    const Real x([&](long bits) { return known.enclose(bits); });
    CHECK_THROWS_AS(round_to_double(x, {0, 100}), Undecided);
    ++undecided;
  }
  CHECK(undecided > 5);
}

TEST_CASE("hard cases: tables of frames have the same doubles") {
  const auto curve = curves();
  for (const HardCase& hard : hard_cases()) {
    if (hard.quantity == "theta") continue;
    CAPTURE(hard.curve);
    CAPTURE(hard.t);
    CAPTURE(hard.quantity);
    TableColumns columns{{TabulatedFrame::rmf}};
    columns.start = Angle();
    const FrameTable table = frame_table(curve.at(hard.curve), columns, {RealAlgebraic(hard.t)});
    const auto column = std::find(table.columns.begin(), table.columns.end(), hard.quantity);
    REQUIRE(column != table.columns.end());
    const auto k = static_cast<std::size_t>(column - table.columns.begin());
    CHECK(bits(table.rows[0][k]) == bits(hard.value));
  }
}

}  // namespace hard_cases_test
