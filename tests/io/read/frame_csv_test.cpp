#include "phrame/io/read/frame_csv.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/frame_table.hpp"
#include "phrame/io/better_reading.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "support/curves.hpp"
#include "support/data.hpp"
#include "support/random.hpp"
#include "support/refusal.hpp"

namespace frame_csv_test {

using namespace phrame;

namespace {

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { read_frames(text); });
}

}  // namespace

TEST_CASE("frame table: lines end with a line feed, a carriage return or both") {
  const auto read = [](const std::string& end) {
    std::string text;
    for (const char* line : {"t,f2x,f2y,f2z", "0,0,1,0", "1,0,0,1"}) text += line + end;
    return read_frames(text).frames;
  };
  const auto frames = read("\n");
  REQUIRE(frames.size() == 2);
  for (const std::string end : {"\r", "\r\n"}) {
    const auto same = read(end);
    REQUIRE(same.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(same[k].t == frames[k].t);
      CHECK(same[k].f2 == frames[k].f2);
    }
  }
  // The lines are counted, whatever ends them.
  for (const std::string end : {"\n", "\r", "\r\n"})
    CHECK_THROWS_WITH_AS(read_frames("t,f2x,f2y,f2z" + end + end + "0,0,1,0" + end + "1,0" + end),
                         "line 4: 2 numbers here, but 4 in the header", InputError);
}

TEST_CASE("frame table: numbers are read exactly, other columns are skipped") {
  const GivenTable table =
      read_frames("# by hand\n\nx,t,f2x,f2y,f2z\r\n?, 0.1, 1e-3,\t-2,1/3\r\n\n9,1,0,0,0x1p-1\n");
  const auto& frames = table.frames;
  REQUIRE(frames.size() == 2);
  CHECK(frames[0].t == Rational(1, 10));
  CHECK(frames[0].f2 == Vector<Rational>{Rational(1, 1000), -2, Rational(1, 3)});
  CHECK(frames[1].f2[2] == Rational(1, 2));
  CHECK_FALSE(frames[0].f3);
  CHECK_FALSE(frames[0].tangent);
  CHECK(table.columns.empty());
  CHECK_FALSE(table.has_quaternions);
  const auto all = read_frames("f3x,f3y,f3z,e1x,e1y,e1z,f2x,f2y,f2z,t\n1,2,3,4,5,6,7,8,9,0").frames;
  CHECK(all[0].f3 == Vector<Rational>{1, 2, 3});
  CHECK(all[0].tangent == Vector<Rational>{4, 5, 6});
  CHECK(all[0].f2 == Vector<Rational>{7, 8, 9});
}

// q = 1 + k turns x to y, y to −x; twice as long it means the same.
TEST_CASE("frame table: quaternions mean frames by a convention") {
  const std::string text = "t,qw,qx,qy,qz\n0,2,0,0,2\n";
  const auto frame = [](const std::string& table, const FrameReading& reading) {
    return read_frames(table, reading).frames.at(0);
  };
  using Order = FrameReading::Quaternion;
  const GivenFrame x = frame(text, {});
  CHECK(x.tangent == Vector<Rational>{0, 1, 0});
  CHECK(x.f2 == Vector<Rational>{-1, 0, 0});
  CHECK(x.f3 == Vector<Rational>{0, 0, 1});
  const GivenFrame z = frame(text, {Order::named, 2});
  CHECK(z.tangent == Vector<Rational>{0, 0, 1});
  CHECK(z.f2 == Vector<Rational>{0, 1, 0});
  CHECK(z.f3 == Vector<Rational>{-1, 0, 0});
  const GivenFrame minus_z = frame(text, {Order::named, 2, true});  // right-handed, too
  CHECK(minus_z.tangent == Vector<Rational>{0, 0, -1});
  CHECK(minus_z.f2 == Vector<Rational>{-1, 0, 0});
  CHECK(minus_z.f3 == Vector<Rational>{0, 1, 0});
  CHECK(frame(text, {Order::named, 0, false, true}).tangent == Vector<Rational>{0, -1, 0});
  // Scalar last, named or not; with names the order is known, without it has to be said.
  CHECK(frame("t,qx,qy,qz,qw\n0,0,0,2,2\n", {}).tangent == x.tangent);
  CHECK(frame("t,qx,qy,qz,qw\n0,0,0,2,2\n", {Order::xyzw}).tangent == x.tangent);
  CHECK(frame("t,qw,qx,qy,qz\n0,0,0,2,2\n", {Order::xyzw}).tangent == x.tangent);
  CHECK(frame("0 0 0 2 2\n", {Order::xyzw}).tangent == x.tangent);
  CHECK(frame("0 2 0 0 2\n", {}).tangent == x.tangent);
}

TEST_CASE("frame table: what is wrong is told with line and column") {
  CHECK(refusal("") == "line 1: a table of numbers is wanted, below the names of its columns");
  CHECK(refusal("t,f2x,f2y,f2z\n") == "line 2: there are no frames");
  CHECK(refusal("f2x,f2y,f2z\n1,0,0") ==
        "line 1: a column \"t\" is wanted; these are f2x, f2y, f2z");
  for (const std::string name : {"T", "time", "Time", "TIME"})
    CHECK(refusal("x," + name + ",f2x,f2y,f2z\n1,0,1,0,0") ==
          "line 1: missing is the column t: \"" + name + "\" is another name");
  CHECK(refusal("t,x,y,z\n0,1,0,0") ==
        "line 1: columns f2x, f2y, f2z or qw, qx, qy, qz are wanted; these are t, x, y, z");
  CHECK(refusal("t,f2x,f2y,f2z,qw,qx,qy,qz\n0,1,0,0,1,0,0,0\n") ==
        "line 1: columns of vectors (f2x) and of quaternions (qw) exclude each other");
  CHECK(refusal("t,f2x,f2y,f2z\n\n0,1,0\n") == "line 3: 3 numbers here, but 4 in the header");
  CHECK(refusal("t,f2x,f2y,f2z\n0,1,nan,0\n").starts_with("line 2, f2y: "));
  CHECK(refusal("t,qw,qx,qy,qz\n0,0,0,0,0\n") == "line 2: the quaternion is 0");
  CHECK(refusal("t;f2x;f2y;f2z\n0.5;0,5;1;0\n") ==
        "line 2, f2x: \"0,5\" is not a number: decimals elsewhere have a point, not a comma");
  CHECK(refusal(std::string("\xFF\xFEt\0", 4)).starts_with("line 1: the text is UTF-16"));
}

// Issue G, 2.3: a vector with a missing or misspelt column was skipped in silence.
TEST_CASE("frame table: vectors are given whole") {
  CHECK(refusal("t,f2x,f2y,f2z,f3x,f3y,f3Z\n0,1,0,0,0,1,0") ==
        "line 1: missing is the column f3z: \"f3Z\" is another name");
  CHECK(refusal("t,f2x,f2y,f2z,F3X,F3Y,F3Z\n0,1,0,0,0,1,0") ==
        "line 1: missing are the columns f3x, f3y, f3z: \"F3Z\" is another name");
  CHECK(refusal("t,f2x,f2y,f2z,e1y\n0,1,0,0,0") ==
        "line 1: missing are the columns e1x, e1z: e1y is there");
  CHECK(refusal("t,f2x,f2y\n0,1,0") == "line 1: missing is the column f2z: f2x, f2y are there");
  CHECK(refusal("t,qw,qx,qz\n0,1,0,0") == "line 1: missing is the column qy: qw, qx, qz are there");
  CHECK(refusal("t,qw,qx,qy,qz,e1x,e1y,e1z\n0,1,0,0,0,1,0,0") ==
        "line 1: columns of vectors (e1x) and of quaternions (qw) exclude each other");
}

TEST_CASE("frame table: a column may be there twice if it is the same") {
  const auto frames = read_frames("t,f2x,f2y,f2z,f2x,t,x,x\n1/2,1,0,0,1.0,0.5,7,8\n").frames;
  CHECK(frames.at(0).f2 == Vector<Rational>{1, 0, 0});
  CHECK(refusal("t,f2x,f2y,f2z,f2x\n0,1,0,0,1\n0,1,0,0,-1\n") ==
        "line 3, f2x: two columns have this name, one with 1, one with -1");
  CHECK(refusal("t,f2x,f2y,f2z,f2x\n0,1,0,0,one\n").starts_with("line 2, f2x: \"one\""));
}

// The files are NumPy's own (tests/data/numpy_tables.py), the numbers as it printed them.
TEST_CASE("frame table: what numpy.savetxt writes is read") {
  const auto decimal = [](const char* text) { return parse_rational(text); };
  for (const std::string name : {"savetxt.txt", "savetxt-header.txt", "savetxt-semicolons.csv",
                                 "savetxt-commas.csv", "savetxt-tabs.tsv"}) {
    CAPTURE(name);
    std::ifstream file(test::data("/numpy/" + name), std::ios::binary);
    REQUIRE(file.good());
    std::stringstream text;
    text << file.rdbuf();
    const GivenTable table = read_frames(text.str());
    REQUIRE(table.frames.size() == 3);
    CHECK(fmt::format("{}", fmt::join(table.columns, ", ")) ==
          (name == "savetxt.txt" ? "t, f2x, f2y, f2z" : ""));
    CHECK(table.frames[0].t == 0);
    CHECK(table.frames[0].f2 == Vector<Rational>{decimal("1.000000000000000056e-01"),
                                                 decimal("3.333333333333333148e-01"), -2});
    CHECK(table.frames[1].f2 == Vector<Rational>{decimal("4.940656458412465442e-324"),
                                                 decimal("1.000000000000000053e+300"), 0});
    CHECK(table.frames[2].t == -3);
  }
}

TEST_CASE("frame table: without a header the number of columns tells what they are") {
  const auto numbered = [](int columns) {
    std::string line;
    for (int k = 0; k < columns; ++k) line += std::to_string(k) + " ";
    return line + "\n";
  };
  const auto first = [&](int columns) { return read_frames(numbered(columns)); };
  CHECK(first(4).frames[0].f2 == Vector<Rational>{1, 2, 3});
  CHECK(first(5).has_quaternions);
  CHECK(first(7).frames[0].f3 == Vector<Rational>{4, 5, 6});
  CHECK(fmt::format("{}", fmt::join(first(8).columns, ", ")) == "t, x, y, z, qw, qx, qy, qz");
  CHECK(first(10).frames[0].tangent == Vector<Rational>{1, 2, 3});
  CHECK(first(10).frames[0].f2 == Vector<Rational>{4, 5, 6});
  for (const int columns : {13, 14, 19}) {
    const GivenTable table = first(columns);
    CHECK(table.frames[0].tangent == Vector<Rational>{4, 5, 6});
    CHECK(table.frames[0].f3 == Vector<Rational>{10, 11, 12});
    CHECK(table.skipped == static_cast<std::size_t>(columns - 13));
  }
  for (const int columns : {1, 2, 3, 6, 9, 11, 12})
    CHECK(refusal(numbered(columns)).find("there is no header") != std::string::npos);
  FrameReading named;
  named.names = {"f2x", "f2y", "f2z", "t"};
  CHECK(read_frames(numbered(4), named).frames[0].t == 3);
  CHECK_THROWS_AS(read_frames(numbered(5), named), InputError);
  CHECK_THROWS_AS(read_frames("t,f2x,f2y,f2z\n0,1,0,0\n", named), InputError);
  // A comment of as many words is taken for the header; what it does not say is not guessed.
  const std::string commented = "# time nx ny nz\n0 1 2 3\n";
  CHECK(refusal(commented) == "line 1: missing is the column t: \"time\" is another name");
  CHECK(read_frames(commented, named).frames[0].t == 3);
  CHECK(refusal("0 1 0 0\n0 1 0\n") == "line 2: 3 numbers here, but 4 in the first line of them");
}

namespace {

const std::vector<Rational> grid{0, Rational(1, 5), Rational(1, 2), Rational(4, 5), 1};

/// The table with columns of one frame under the names f2 and f3.
std::string as_given(FrameTable table, const std::string& second, const std::string& third) {
  for (std::string& name : table.columns)
    for (const auto& [from, to] : {std::pair(second, std::string("f2")), {third, "f3"}})
      if (name.size() == from.size() + 1 && name.starts_with(from))
        name.replace(0, from.size(), to);
  return to_csv(table);
}

std::vector<FrameFinding::Kind> kinds(const PhPath& path, const std::string& table) {
  std::vector<FrameFinding::Kind> list;
  for (const auto& finding : check_frames(PathAngle(path), read_frames(table).frames).findings)
    list.push_back(finding.kind);
  return list;
}

}  // namespace

// Issue G, 2.2: "tangent reversed" and "left-handed" were said of our own tables.
TEST_CASE("frame table: our own tables pass where the multiplier is negative or changes its sign") {
  using Kind = FrameFinding::Kind;
  long turned = 0;
  test::for_samples(20, [&](test::Random& random) {
    const Polynomial multipliers[] = {{-1}, {-1, 0, -1}, {-1, 2}, {1, -2}, {0, 0, -1}};
    const PhPath path(
        Curve(random.quaternion_polynomial(3), multipliers[random.integer(0, 4)], {}));
    const Curve& curve = path.segments().front();
    const Polynomial& f = curve.multiplier();
    const FrameTable table =
        frame_table(curve, {TabulatedFrame::rmf, TabulatedFrame::euler_rodrigues}, grid);
    CHECK(kinds(path, to_csv(table)).empty());
    CHECK(kinds(path, to_npy(table)).empty());
    // Frames of another kind are wrong in that only: their tangents and handedness are right.
    for (const Kind kind :
         kinds(path,
               as_given(frame_table(curve, {TabulatedFrame::euler_rodrigues}, grid), "e2", "e3"))) {
      CHECK(kind >= Kind::flip);  // kinds of angles
      if (kind == Kind::euler_rodrigues) ++turned;
    }
    // With e₁ = r′/|r′| and f₃ = e₁ × f₂ they pass as well; with only one of them turned, not.
    FrameTable motion = table;
    FrameTable reversed = table;
    for (std::size_t row = 0; row < grid.size(); ++row) {
      // Where f is 0, r′/|r′| is its limit.
      const Rational side = f(grid[row]) != 0 ? f(grid[row]) : f(grid[row] + Rational(1, 100));
      if (side > 0) continue;
      for (const std::size_t k : {4U, 5U, 6U}) {
        motion.rows[row][k] *= -1;
        reversed.rows[row][k] *= -1;
      }
      for (const std::size_t k : {10U, 11U, 12U}) motion.rows[row][k] *= -1;
    }
    CHECK(kinds(path, to_csv(motion)).empty());
    if (reversed.rows != table.rows)
      CHECK(kinds(path, to_csv(reversed)) == std::vector{Kind::left_handed});
  });
  CHECK(turned >= 10);
}

TEST_CASE("frame table: Frenet frames of a curve with f < 0 are recognised") {
  const Curve curve(test::quintic.preimage(), Polynomial{-1, -1}, {});
  const FrameTable table = frame_table(curve, {TabulatedFrame::frenet}, grid);
  CHECK(kinds(PhPath(curve), as_given(table, "n", "b")) == std::vector{FrameFinding::Kind::frenet});
}

namespace {

std::optional<BetterReading> better(const std::string& text, const FrameReading& reading = {},
                                    const Curve& curve = test::quintic) {
  const PhPath path(curve);
  const GivenTable table = read_frames(text, reading);
  const FrameCheckOptions options{std::nullopt, Rational(1, 1000)};
  const CheckAnswer found{NamedPhPath("", path), table.frames, options,
                          check_frames(PathAngle(path), table.frames, options)};
  return better_reading(found, text, reading, table);
}

/// A plane curve, whose Euler–Rodrigues frame A = 1 + tk is rotation-minimizing: A is the
/// quaternion.
const Curve plane({{1}, {}, {}, {0, 1}});

/// (t; A·p) for rational t, its components in the order wxyz or xyzw.
std::string poses(const RationalQuaternion& p, bool is_scalar_last, bool is_inverse) {
  std::string text;
  for (const Rational& t : grid) {
    RationalQuaternion q = RationalQuaternion{1, 0, 0, t} * p;
    if (is_inverse) q = {q.u, -q.v, -q.p, -q.q};
    const std::string vector = to_string(q.v) + " " + to_string(q.p) + " " + to_string(q.q);
    text += to_string(t) + " " +
            (is_scalar_last ? vector + " " + to_string(q.u) : to_string(q.u) + " " + vector) + "\n";
  }
  return text;
}

}  // namespace

// p = 1 − i − j − k turns z to x, x to y, y to z; p = 1 + j turns x to −z.
TEST_CASE("frame table: the convention that makes quaternions right is found") {
  const auto options = [](const std::string& text, const FrameReading& reading = {}) {
    const auto found = better(text, reading, plane);
    return found ? to_options(found->reading) + (found->passes ? "" : " fails") : "";
  };
  const RationalQuaternion one{1, 0, 0, 0};
  const RationalQuaternion z_to_x{1, 1, 1, 1};
  CHECK(options(poses(one, false, false)).empty());
  CHECK(options(poses(one, true, false)) == "--quaternion xyzw");
  CHECK(options(poses(one, false, true)) == "--inverse");
  CHECK(options(poses(one, false, false), {FrameReading::Quaternion::xyzw}) == "--quaternion wxyz");
  const std::string first = options(poses(z_to_x, false, false));
  const std::string second = options(poses(RationalQuaternion{1, -1, -1, -1}, false, false));
  CHECK(((first == "--tangent-axis z" && second == "--tangent-axis y") ||
         (first == "--tangent-axis y" && second == "--tangent-axis z")));
  CHECK(options(poses(RationalQuaternion{1, 0, 1, 0}, false, false)).starts_with("--tangent-axis"));
  CHECK(options(poses(RationalQuaternion{0, 0, 1, 0}, false, false)) == "--tangent-axis=-x");
  CHECK(options(poses(z_to_x, true, true)).starts_with("--quaternion xyzw --tangent-axis "));
}

TEST_CASE("frame table: the order that makes a matrix right is found") {
  const FrameTable table = frame_table(test::quintic, {TabulatedFrame::rmf}, grid);
  const auto text = [&](const std::vector<std::size_t>& columns) {
    std::string lines;
    for (const auto& row : table.rows) {
      for (const std::size_t k : columns) lines += to_string(exact_rational(row[k])) + " ";
      lines += "\n";
    }
    return lines;
  };
  CHECK_FALSE(better(text({0, 4, 5, 6, 7, 8, 9, 10, 11, 12})));
  const auto transposed = better(text({0, 4, 7, 10, 5, 8, 11, 6, 9, 12}));
  REQUIRE(transposed);
  CHECK(transposed->passes);
  CHECK(to_options(transposed->reading) == "--header t,e1x,f2x,f3x,e1y,f2y,f3y,e1z,f2z,f3z");
  const auto last = better(text({0, 7, 10, 4, 8, 11, 5, 9, 12, 6}));
  REQUIRE(last);
  CHECK(to_options(last->reading) == "--header t,f2x,f3x,e1x,f2y,f3y,e1y,f2z,f3z,e1z");
  const auto seven = better(text({0, 4, 5, 6, 7, 8, 9}));
  REQUIRE(seven);
  CHECK(to_options(seven->reading) == "--header t,e1x,e1y,e1z,f2x,f2y,f2z");
}

// f₂ passes by itself, so that any three columns in front of it could be called positions.
TEST_CASE("frame table: what is wrong with f3 is not hidden by calling it a position") {
  const FrameTable table = frame_table(test::quintic, {TabulatedFrame::rmf}, grid);
  using Row = std::vector<double>;
  constexpr std::size_t r = 1;
  constexpr std::size_t f2 = 7;
  constexpr std::size_t f3 = 10;
  const auto vector = [](const Row& row, std::size_t begin, const Rational& factor = 1,
                         const Rational& shift = 0) {
    std::string text;
    for (std::size_t k = begin; k < begin + 3; ++k)
      text += " " + to_string(Rational(factor * exact_rational(row[k]) + shift));
    return text;
  };
  const auto text = [&](const auto& six) {
    std::string lines;
    for (const Row& row : table.rows) lines += to_string(exact_rational(row[0])) + six(row) + "\n";
    return lines;
  };
  const PhPath path(test::quintic);
  using Kind = FrameFinding::Kind;
  CHECK(
      kinds(path, text([&](const Row& row) { return vector(row, f2) + vector(row, f3); })).empty());
  for (const std::string& left_handed :
       {text([&](const Row& row) { return vector(row, f2) + vector(row, f3, -1); }),
        text([&](const Row& row) { return vector(row, f3) + vector(row, f2); })}) {
    CHECK(kinds(path, left_handed) == std::vector{Kind::left_handed});
    CHECK_FALSE(better(left_handed));
  }
  const auto is_position = [&](const Rational& factor, const Rational& shift) {
    const auto found = better(
        text([&](const Row& row) { return vector(row, r, factor, shift) + vector(row, f2); }));
    return found && found->passes && to_options(found->reading) == "--header t,x,y,z,f2x,f2y,f2z";
  };
  CHECK(is_position(1, 0));
  CHECK(is_position(1, 1000));
  CHECK(is_position(Rational(10'001, 10'000), 0));        // off by 1/10 of the tolerance
  CHECK_FALSE(is_position(Rational(10'020, 10'000), 0));  // by twice as much
  CHECK_FALSE(is_position(2, 0));
  CHECK_FALSE(is_position(0, 1));
}

// A quarter turn about z: the body's x is along y.
TEST_CASE("frame table: matrices without names are frames, and say where they are") {
  const GivenTable table = read_frames("0 -1 0 7 1 0 0 8 0 0 1 9\n");
  CHECK(table.has_matrices);
  CHECK_FALSE(table.has_parameters);
  CHECK(table.frames[0].tangent == Vector<Rational>{0, 1, 0});
  CHECK(table.frames[0].f2 == Vector<Rational>{-1, 0, 0});
  CHECK(table.frames[0].f3 == Vector<Rational>{0, 0, 1});
  CHECK(table.positions.at(0).r == Vector<Rational>{7, 8, 9});
  CHECK(table.notes == std::vector<std::string>{
                           "12 columns without names are taken for 3 × 4 matrices, row by row"});
  FrameReading inverse;
  inverse.is_inverse = true;
  CHECK(read_frames("0 -1 0 7 1 0 0 8 0 0 1 9\n", inverse).frames[0].tangent ==
        Vector<Rational>{0, -1, 0});
  FrameReading along_z;
  along_z.tangent_axis = 2;
  along_z.parameters = {Rational(5)};
  const GivenFrame frame = read_frames("0 1 0 0 -1 0 0 0 0 0 1 0 7 8 9 1\n", along_z).frames[0];
  CHECK(frame.t == 5);
  CHECK(frame.tangent == Vector<Rational>{0, 0, 1});
  CHECK(frame.f2 == Vector<Rational>{0, 1, 0});
  CHECK(other_readings(table, {}).size() == 11);  // six tangents, to the world or to the body
}

TEST_CASE("frame table: of frames with positions a time stands for the parameter") {
  const GivenTable tum =
      read_frames("# timestamp tx ty tz qx qy qz qw\n10 1 2 3 0 0 0 1\n12 4 5 6 0 0 0 1\n");
  CHECK(tum.has_quaternions);
  CHECK_FALSE(tum.has_parameters);
  CHECK(tum.positions[1].t == 12);
  CHECK(tum.positions[1].r == Vector<Rational>{4, 5, 6});
  CHECK(tum.frames[0].tangent == Vector<Rational>{1, 0, 0});
  CHECK(read_frames("x,y,z,f2x,f2y,f2z\n1,2,3,0,1,0\n").positions[0].t == 0);
  CHECK(read_frames("t,x,y,z,f2x,f2y,f2z\n3,,2,3,0,1,0\n").positions.empty());
}

TEST_CASE("frame table: rows that miss a number are left out if that is asked for") {
  const std::string text = "t,f2x,f2y,f2z,note\n0,1,0,0,\n1,NaN,0,1,\n2,0,1,0,\n";
  CHECK(refusal(text).starts_with("line 3, f2x: \"NaN\" is not a number"));
  FrameReading reading;
  reading.skips_invalid = true;
  const GivenTable table = read_frames(text, reading);
  CHECK(table.frames.size() == 2);
  CHECK(table.notes == std::vector<std::string>{"left out is 1 row without a number, line 3"});
}

}  // namespace frame_csv_test
