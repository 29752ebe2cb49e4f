#include "phrame/io/read/expression_node.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "support/data.hpp"

namespace expression_node_test {

using namespace phrame;

namespace {

/// What is said of a curve/1 file with these members.
std::string failure(const std::string& members) {
  try {
    read_any_path(R"json({"phrame": "curve/1", )json" + members + "}");
  } catch (const InputError& error) {
    return error.place() + ": " + error.reason();
  }
  return "none";
}

std::string formulas(const std::string& x, const std::string& y, const std::string& ends) {
  return R"json("expressions": {"x": ")json" + x + R"json(", "y": ")json" + y + R"json("}, )json" +
         ends;
}

/// Of a path that is not PH.
Path smooth(const std::string& text) {
  Path path = read_any_path(text).path;
  REQUIRE_FALSE(path.is_ph());
  return path;
}

Path smooth_curve(const std::string& members) {
  return smooth(R"json({"phrame": "curve/1", )json" + members + "}");
}

constexpr auto full_turn = R"json("from": 0, "to": "2*pi")json";
constexpr auto unit = R"json("from": 0, "to": 1)json";

}  // namespace

TEST_CASE("expressions: the variable is the only name there is, or the one that is given") {
  const Path path = smooth_curve(formulas("cos(u)", "sin(u)", full_turn));
  CHECK(path.is_closed());
  const auto& curve = std::get<ExpressionCurve>(path.segments().front());
  CHECK(curve.variable() == "u");
  CHECK(curve.position()[2] == Formula(0));
  CHECK(path == smooth_curve(formulas("cos(phi)", "sin(phi)", full_turn)));
  // e is a variable only where it is said so.
  CHECK(path ==
        smooth_curve(formulas("cos(e)", "sin(e)", full_turn) + R"json(, "variable": "e")json"));
}

TEST_CASE("expressions: their ends and variable may stand among them, but not twice") {
  const std::string among =
      R"json("expressions": {"x": "cos(e)", "y": "sin(e)", "variable": "e", "from": 0, "to": "2*pi"})json";
  CHECK(smooth_curve(among) == smooth_curve(formulas("cos(u)", "sin(u)", full_turn)));
  CHECK(failure(R"json("from": 0, )json" + among) ==
        "/expressions/from: it stands beside \"expressions\", too");
}

TEST_CASE("expressions: polynomials are a polynomial curve, and PH ones are recognised") {
  const NamedPath ph =
      read_any_path(R"json({"phrame": "curve/1", )json" +
                    formulas("s - s^3/3", "s^2", R"json("from": 0, "to": 2})json"));
  REQUIRE(ph.path.is_ph());
  // s = 2t: x′ = 2 − 8t², y′ = 8t, of the speed 2 + 8t².
  CHECK(hodograph(ph.path.ph()->segments().front()) ==
        Vector<Polynomial>{Polynomial{2, 0, -8}, {0, 8}, {}});
}

TEST_CASE("expressions: segments of a spline join by their values, whatever form they have") {
  const std::string line = R"json({"control_points": [[1, -2, 0], [1, -1, 0], [1, 0, 0]]})json";
  const std::string arc =
      "{" + formulas("cos(s)", "sin(s)", R"json("from": 0, "to": "pi")json") + "}";
  const auto spline = [](const std::string& segments) {
    return R"json({"phrame": "spline/1", "segments": [)json" + segments + "]}";
  };
  CHECK(smooth(spline(line + "," + arc)).segments().size() == 2);
  try {
    read_any_path(spline(arc + "," + line));
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK(error.place() == "/segments/1");
    CHECK(std::string(error.reason()) ==
          "it starts at (1, -2, 0), but the spline ends at (-1, 0, 0)");
  }
  // A preimage goes on where the arc ends, with r′ = −j: not along i, where q = 1 would go.
  const std::string down =
      R"json({"basis": "power", "preimage": {"u": [1], "v": [0], "p": [0], "q": [-1]}})json";
  CHECK(smooth(spline(arc + "," + down)).segments().size() == 2);
}

TEST_CASE("expressions: what is wrong is named with its place") {
  CHECK(failure(formulas("cos(s", "s", unit)) ==
        "/expressions/x: column 1: this \"(\" is never closed");
  CHECK(failure(formulas("cos(s)", "t", unit)) ==
        "/expressions/y: column 1: \"t\" is not the variable \"s\"");
  CHECK(failure(formulas("cos(s)", "s", R"json("from": 0, "to": "s")json")) ==
        "/to: column 1: \"s\" where a number is expected");
  CHECK(failure(formulas("cos(s)", "s", R"json("from": 0)json")) == "/: the key \"to\" is missing");
  CHECK(failure(formulas("cos(s)", "1/(s - 1/2)", unit)).starts_with("/expressions: "));
  CHECK(failure(formulas("cos(s)", "1", unit) + R"json(, "basis": "power")json") ==
        "/: \"expressions\" and \"basis\" exclude each other");
  CHECK(
      failure(
          R"json("basis": "power", "preimage": {"u": [1], "v": [0], "p": [0], "q": [0]}, "from": 0)json") ==
      "/from: this is of \"expressions\", which are missing");
  CHECK(failure(R"json("expressions": {"x": true, "y": "s"}, )json" + std::string(unit))
            .starts_with("/expressions/x: a string is wanted"));
}

TEST_CASE("expressions: the examples") {
  const auto read = [](const char* name) {
    std::ifstream file(test::root("/examples/any/") + name);
    std::ostringstream text;
    text << file.rdbuf();
    return smooth(text.str());
  };
  // mpmath's quad() with 45 digits
  const Real trefoil = PathAngle(read("trefoil.json"), {0, 0, 1}).value({0, Rational(1)});
  const Rational wanted = parse_rational("-3.2561931220674106839578625312073");
  CHECK(is_at_most(absolute(subtract(trefoil.enclose(110), RealBall(wanted, 128), 110)),
                   RealBall(parse_rational("1e-30"), 64)));
  // κ = 3/25, τ = 4/25 and the length is 20π: θ to the Frenet frame ends at −16π/5.
  const Real helix = PathAngle(read("helix.json"), Reference::frenet).value({0, Rational(1)});
  const RealBall turns = divide(helix.enclose(80), pi(80), 80);
  CHECK(turns.contains(Rational(-16, 5)));
}

}  // namespace expression_node_test
