#include "phrame/io/sifted_frames.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/io/write/check.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/curves.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace sifted_frames_test {

using Change = std::function<void(std::size_t row, Vector<double>& f2, Vector<double>& f3,
                                  Vector<double>& e1)>;

struct Row {
  double t;
  Vector<double> e1, f2, f3;
};

/// Of a rotation-minimizing frame.
std::vector<Row> rows_of(const Path& path, long count) {
  const PathAngle angle(path);
  std::vector<Row> rows;
  for (long k = 0; k < count; ++k) {
    const Rational t = path.end() * Rational(k, count - 1);
    const Frame<Real> frame = rotation_minimizing_frame(angle, locate(path, t));
    rows.push_back({round_to_double(t), round_to_double(frame.e1), round_to_double(frame.e2),
                    round_to_double(frame.e3)});
  }
  return rows;
}

std::string table_of(std::vector<Row> rows, const Change& change) {
  std::string text = "t,x,y,z,e1x,e1y,e1z,f2x,f2y,f2z,f3x,f3y,f3z\n";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    auto& [t, e1, f2, f3] = rows[k];
    change(k, f2, f3, e1);
    text += fmt::format("{}", t);
    for (const Vector<double>& v : {Vector<double>{}, e1, f2, f3})
      text += fmt::format(",{},{},{}", v[0], v[1], v[2]);
    text += "\n";
  }
  return text;
}

std::optional<SiftedTable> sifted(const std::string& text, const NamedPath& named,
                                  const FrameCheckOptions& options) {
  const ReadBytes read = [&](std::uint64_t from, std::size_t count) {
    return text.substr(std::min<std::size_t>(from, text.size()), count);
  };
  return sifted_frames(read, text.size(), {}, named, ParameterKind::t, options);
}

/// What is printed of the few rows is what is printed of all; how many they are.
std::size_t check_same(const NamedPath& named, const std::string& text,
                       const FrameCheckOptions& options = {}) {
  const GivenTable table = read_frames(text);
  const std::string wanted = to_text(answer(named, CheckQuery{table.frames, options}), {});
  const auto few = sifted(text, named, options);
  REQUIRE(few.has_value());
  CHECK(few->rows == table.frames.size());
  const CheckAnswer found = answer(named, CheckQuery{read_frames(few->text).frames, options});
  REQUIRE(is_for_all(found, *few));
  TableReading reading;
  reading.part = {few->numbers, samples_of_all(found.verdict, *few), few->rows};
  CHECK(to_text(found, reading) == wanted);
  return few->numbers.size();
}

const NamedPath quintic{"quintic", PhPath(test::quintic)};
constexpr long rows = 350;

std::string quintic_table(const Change& change) {
  static const std::vector<Row> exact = rows_of(quintic.path, rows);
  return table_of(exact, change);
}

void keep(std::size_t, Vector<double>&, Vector<double>&, Vector<double>&) {}

/// Noise of that size in all components.
Change noise(double size) {
  const auto random = std::make_shared<test::Random>(7);
  return [=](std::size_t, Vector<double>& f2, Vector<double>& f3, Vector<double>& e1) {
    for (Vector<double>* v : {&f2, &f3, &e1})
      for (double& x : *v) x += size * 1e-6 * static_cast<double>(random->integer(-999999, 999999));
  };
}

/// Turned about the tangent by an angle that grows to this.
Change drift(double from, double to) {
  return [=](std::size_t row, Vector<double>& f2, Vector<double>& f3, Vector<double>&) {
    const double angle = from + (to - from) * static_cast<double>(row) / (rows - 1);
    const Vector<double> before = f2;
    f2 = std::cos(angle) * f2 + std::sin(angle) * f3;
    f3 = std::cos(angle) * f3 - std::sin(angle) * before;
  };
}

}  // namespace sifted_frames_test

using namespace sifted_frames_test;

TEST_CASE("sifted frames: law: what is said of the rows that decide is said of all") {
  const std::string good = quintic_table(keep);
  CHECK(check_same(quintic, good) < 100);
  CHECK(check_same(quintic, good, {FrameStart(Angle(0, 0)), Rational(1, 1000)}) < 100);
  CHECK(check_same(quintic, good, {std::nullopt, Rational(15) * power_of_ten(-17)}) < 150);
  for (const double size : {1e-12, 1e-3}) {
    const std::string noisy = quintic_table(noise(size));
    CHECK(check_same(quintic, noisy) < 150);
    CHECK(check_same(quintic, noisy, {std::nullopt, Rational(1, 100)}) < 150);
    CHECK(check_same(quintic, noisy, {std::nullopt, power_of_ten(-13)}) < 150);
  }
  CHECK(check_same(quintic, quintic_table(drift(0, 0.01))) < 150);
  CHECK(check_same(quintic, quintic_table(drift(0.3, 0.3)), {FrameStart(Angle(0, 0))}) < 150);
  CHECK(check_same(quintic, quintic_table(drift(0.3, 0.5)), {FrameStart(Angle(0, 0))}) < 150);
}

TEST_CASE("sifted frames: law: faults of some and of all are found with their numbers") {
  const auto of = [](std::size_t row) { return row == 7 || row == 300 || row == 349; };
  for (const Change& change : std::vector<Change>{
           [&](std::size_t row, auto&, auto&f3, auto&) { f3 = of(row) ? -1.0 * f3 : f3; },
           [&](std::size_t row, auto&, auto&, auto&e1) { e1 = of(row) ? -1.0 * e1 : e1; },
           [&](std::size_t row, auto&f2, auto&, auto&) { f2 = of(row) ? 1.5 * f2 : f2; },
           [&](std::size_t row, auto&f2, auto&, auto&) { f2 = row > 0 ? 1.5 * f2 : f2; },
           [&](std::size_t row, auto&f2, auto&, auto&e1) { f2 = row > 90 ? f2 + 0.1 * e1 : f2; },
           [&](std::size_t row, auto&f2, auto&, auto&e1) { e1 = row > 90 ? e1 + 0.1 * f2 : e1; },
           [&](std::size_t row, auto&f2, auto&, auto&) {
             if (row == 200) f2 = {};
           }})
    check_same(quintic, quintic_table(change));
}

TEST_CASE("sifted frames: law: along other paths, too") {
  const Path spline = test::cut(test::quintic, {Rational(1, 3)});
  const Path helix =
      joined({Segment(test::expression_curve({"cos(s)", "sin(s)", "s/2"}, "0", "4"))});
  check_same({"a spline", spline}, table_of(rows_of(spline, 700), keep));
  check_same({"a helix", helix}, table_of(rows_of(helix, 310), keep));
}

TEST_CASE("sifted frames: of tables that they are not for there are none") {
  const std::string good = quintic_table(keep);
  CHECK_FALSE(sifted(good.substr(0, good.size() / 2), quintic, {}));  // few
  std::string text = good;
  CHECK_FALSE(sifted(text.insert(text.find("\n0,"), "\n1,0,0,0,1,0,0,0,1,0,0,0,1"), quintic, {}));
  text = good;
  CHECK_FALSE(sifted(text.replace(text.rfind(','), 2, ",x"), quintic, {}));
  text = good;
  CHECK_FALSE(sifted(text + "1,2\n", quintic, {}));
  CHECK_FALSE(sifted(text + "\"1\"" + text.substr(text.rfind("\n1,") + 2), quintic, {}));
  CHECK(sifted(good, quintic, {}));
  // A flip, and a frame that turns with another one, are found of all rows.
  const auto flipped = [](std::size_t row, auto& f2, auto& f3, auto&) {
    if (row == 50) f2 = -1.0 * f2, f3 = -1.0 * f3;
  };
  CHECK_FALSE(sifted(quintic_table(flipped), quintic, {}));
}
