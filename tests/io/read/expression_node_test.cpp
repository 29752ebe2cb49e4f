#include "phrame/io/read/expression_node.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"

using namespace phrame;

namespace {

std::string failure(const std::string& members) {
  try {
    read_any_path(R"({"phrame": "curve/1", )" + members + "}");
  } catch (const InputError& error) {
    return error.place() + ": " + error.reason();
  }
  return "none";
}

SmoothPath smooth(const std::string& text) {
  return std::get<NamedSmoothPath>(read_any_path(text)).path;
}

}  // namespace

TEST_CASE("expressions: the variable is the only name there is, or the one that is given") {
  const auto circle = [](const std::string& name) {
  return R"({"phrame": "curve/1", "expressions": {"x": "cos()" + name + R"()",
         "y" : "sin()" + name + R"()"}, "from": 0, "to": "2*pi"})";
}
;
const SmoothPath path = smooth(circle("u"));
CHECK(path.is_closed());
const auto& curve = std::get<ExpressionCurve>(path.segments().front());
CHECK(curve.variable() == "u");
CHECK(path == smooth(circle("phi")));
CHECK(curve.position()[2] == Formula(0));
}

TEST_CASE("expressions: polynomials are a polynomial curve, and PH ones are recognised") {
  const AnyPath ph = read_any_path(
      R"({"phrame": "curve/1", "expressions": {"x": "s - s^3/3", "y": "s^2"}, "from": 0, "to": 2})");
  REQUIRE(std::holds_alternative<NamedPath>(ph));
  // s = 2t: x′ = 2 − 8t², y′ = 8t, of the speed 2 + 8t².
  CHECK(hodograph(std::get<NamedPath>(ph).path.segments().front()) ==
        Vector<Polynomial>{Polynomial{2, 0, -8}, {0, 8}, {}});
}

TEST_CASE("expressions: segments of a spline join by their values, whatever form they have") {
  const std::string line = R"({"control_points": [[1, -2, 0], [1, -1, 0], [1, 0, 0]]})";
  const std::string arc = R"({"expressions": {"x": "cos(s)", "y" : "sin(s)"
}
, "from" : 0, "to" : "pi"
})";
  const auto spline = [](const std::string& segments) {
  return R"({"phrame": "spline/1", "segments": [)" + segments + "]}";
  };
CHECK(smooth(spline(line + "," + arc)).segments().size() == 2);
try {
  read_any_path(spline(arc + "," + line));
  FAIL("no error");
} catch (const InputError& error) {
  CHECK(error.place() == "/segments/1");
  CHECK(error.reason() == "it starts at (1, -2, 0), but the spline ends at (-1, 0, 0)");
}
}

TEST_CASE("expressions: what is wrong is named with its place") {
  const std::string ends = R"(, "from": 0, "to": 1)";
  CHECK(failure(R"("expressions": {"x": "cos(s", "y": "s"})" + ends) ==
        "/expressions/x: column 4: this \"(\" is never closed");
  CHECK(failure(R"("expressions": {"x": "cos(s)", "y": "t"
})" + ends) ==
        "/expressions/y: column 1: \"t\" is not the variable \"s\"");
  CHECK(failure(R"("expressions": {"x": "cos(s)", "y": "s"
  }, "from": 0, "to": "s")") ==
        "/to: column 1: \"s\" where a number is expected");
  CHECK(failure(R"("expressions": {"x": "cos(s)", "y": "s"
  }, "from": 0)") ==
        "/: the key \"to\" is missing");
  CHECK(failure(R"("expressions": {"x": "cos(s)", "y": "1/(s - 1/2)"
  })" + ends) ==
        "/expressions: 1/(s - 1/2) is undefined at s = 1/2: s - 1/2 is 0 there");
  CHECK(failure(R"("expressions": {"x": "cos(s)", "y": "s"
  }, "basis": "power")" + ends) ==
        "/: \"expressions\" and \"basis\" exclude each other");
  CHECK(failure(R"("preimage": [[1], [0], [0], [0]], "from": 0)") ==
        "/from: this is of \"expressions\", which are missing");
  CHECK(failure(R"("expressions": {"x": "s^2", "y": "s^3", "w": "1"})" + ends) ==
        "/expressions/w: unknown key; known are \"x\", \"y\", \"z\"");
  CHECK(failure(R"("expressions": {"x": true, "y": "s^3"})" + ends) ==
        "/expressions/x: a string is wanted, not a boolean");
  }
