#include "phrame/io/read/point_file.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "support/refusal.hpp"

namespace point_file_test {

using namespace phrame;

namespace {

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { read_points(text); });
}

std::string json(const std::string& rest) {
  return R"({"phrame": "points/1", "points": [[0, 0, 0], ["1/3", 0.1, 1e2], [1, 1, 1]])" + rest +
         "}";
}

const std::vector<Vector<Rational>> three{
    {0, 0, 0}, {Rational(1, 3), Rational(1, 10), 100}, {1, 1, 1}};

}  // namespace

TEST_CASE("points: JSON is read exactly, with all that it may have") {
  const GivenPoints given = read_points(json(R"(, "name": "three", "note": "!",
      "derivatives": [[1, 0, 0], [0, 1, 0], ["-1/7", 0, 0]],
      "accelerations": [[0, 0, 0], [0, 0, 1], [2, 0, 0]], "parameters": [0, "1/2", 3])"));
  CHECK(given.name == "three");
  CHECK(given.points == three);
  CHECK(given.derivatives[2] == Vector<Rational>{Rational(-1, 7), 0, 0});
  CHECK(given.accelerations[1] == Vector<Rational>{0, 0, 1});
  CHECK(given.parameters == std::vector<Rational>{0, Rational(1, 2), 3});
  CHECK(given.tangents.empty());
  CHECK_FALSE(given.is_planar);
  const GivenPoints closed = read_points(json(R"(, "parameters": [0, 1, 2, 3])"));
  CHECK(closed.parameters.size() == 4);  // the end of a closed curve
  CHECK(read_points("\xEF\xBB\xBF  " + json(R"(, "tangents": [[1,0,0],[1,0,0],[0,0,5]])"))
            .tangents[2] == Vector<Rational>{0, 0, 5});
}

TEST_CASE("points: of a plane they have z = 0") {
  const GivenPoints given = read_points(
      R"({"phrame": "points/1", "points": [[0, 1], [2, 3]], "tangents": [[1, 0], [0, 1]]})");
  CHECK(given.is_planar);
  CHECK(given.points[1] == Vector<Rational>{2, 3, 0});
  CHECK(given.tangents[1] == Vector<Rational>{0, 1, 0});
  CHECK(read_points("0 1\n2 3\n").points == given.points);
  CHECK(read_points("y;x\n1;0\n3;2\n").points == given.points);
  CHECK(read_points("y;x\n1;0\n3;2\n").is_planar);
}

TEST_CASE("points: tables with and without names, in any dress, are the same points") {
  const std::vector<std::string> rows{"0,0,0", "1/3,0.1,1e2", "1,1,1"};
  const auto table = [&](std::string_view header, char separator, std::string_view end) {
    std::string text(header);
    for (const std::string& row : rows) {
      for (const char c : row) text += c == ',' ? separator : c;
      text += end;
    }
    return text;
  };
  for (const std::string& text :
       {table("", ',', "\n"), table("", ' ', "\n"), table("", '\t', "\r\n"), table("", ';', "\r"),
        table("x,y,z\n", ',', "\n"), table("\"X\";\"Y\";\"Z\"\n", ';', "\n\n"),
        table("# a comment of several words\n\n", ',', "\n"), table("# x y z\n", ' ', "\n"),
        table("\xEF\xBB\xBFx,y,z\n", ',', "\n"), table("# one two three\n", ',', "\n")}) {
    CAPTURE(text);
    const GivenPoints given = read_points(text);
    CHECK(given.points == three);
    CHECK(given.parameters.empty());
    CHECK(given.derivatives.empty());
  }
}

TEST_CASE("points: columns have their meaning by their names; others are skipped") {
  const GivenPoints given = read_points(
      "k,t,z,y,x,dx,dy,dz,e1x,e1y,e1z\n0,0,3,2,1,7,8,9,1,0,0\n1,1/2,6,5,4,1,1,1,1,0,0\n");
  CHECK(given.points == std::vector<Vector<Rational>>{{1, 2, 3}, {4, 5, 6}});
  CHECK(given.derivatives[0] == Vector<Rational>{7, 8, 9});
  CHECK(given.parameters[1] == Rational(1, 2));
  CHECK(given.tangents.empty());  // derivatives say more
  CHECK(read_points("x y z e1x e1y e1z\n0 0 0 1 0 0\n1 0 0 0 1 0\n").tangents[1] ==
        Vector<Rational>{0, 1, 0});
}

TEST_CASE("points: a parameter of another name is taken, and what is skipped is named") {
  const GivenPoints timed = read_points("Time,x,y,z,u,label\n1,0,0,0,7,a\n3,1,2,0,6,b\n");
  CHECK(timed.parameters == std::vector<Rational>{1, 3});
  CHECK(notes_on_columns(timed) ==
        std::vector<std::string>{"the column Time is taken for the parameters t",
                                 "skipped are the columns u, label"});
  for (const char* name : {"timestamp", "parameter", "u", "s"})
    CHECK(read_points(std::string("x,y,") + name + "\n0,0,1\n1,1,4\n").parameters ==
          std::vector<Rational>{1, 4});
  // t comes before all others; and what does not increase, or is no number, means something else.
  CHECK(read_points("s,t,x,y\n1,2,0,0\n3,5,1,2\n").parameters == std::vector<Rational>{2, 5});
  const GivenPoints falling = read_points("s,x,y\n1,0,0\n1/2,1,2\n");
  CHECK(falling.parameters.empty());
  CHECK(notes_on_columns(falling) ==
        std::vector<std::string>{
            "skipped is the column s (line 3: 1/2 is not greater than that before it)"});
  CHECK(read_points("timestamp,x,y\n10:30,0,0\n10:31,1,2\n").parameters.empty());
  CHECK(read_points("s,s,x,y\n1,2,0,0\n3,5,1,2\n").parameters.empty());
  CHECK(notes_on_columns(read_points("x,y\n0,0\n1,2\n")).empty());
}

TEST_CASE("points: a point may be that before it where derivatives say how to go on") {
  const std::string points = R"({"phrame": "points/1", "points": [[0, 0], [0, 0]])";
  CHECK(refusal(points + "}") ==
        "/points/1: the point (0, 0, 0) is that before it; only with derivatives is it known how a "
        "curve goes from one to the other");
  CHECK(refusal(points + R"(, "derivatives": [[1, 0], [0, 1]]})").empty());
  CHECK(
      refusal("x,y\n0,0\n\n1,2\n1,2\n").starts_with("line 5: the point (1, 2, 0) is that before"));
}

TEST_CASE("points: what is wrong is said in a line, with its place") {
  CHECK(refusal(json(R"(, "derivatives": [[1, 0, 0]])")) == "/derivatives: 1 for 3 points");
  CHECK(refusal(json(R"(, "parameters": [0, 1, 2, 3, 4])")) == "/parameters: 5 for 3 points");
  CHECK(refusal(json(R"(, "parameters": [0, 1, 1])")) ==
        "/parameters/2: 1 is not greater than the parameter before it, 1");
  CHECK(refusal(json(R"(, "tangents": [[1, 0, 0], [0, 0, 0], [1, 0, 0]])")) ==
        "/tangents/1: the tangent is 0, which is no direction");
  CHECK(refusal(json(R"(, "tangents": [[1,0,0],[1,0,0],[1,0,0]],
                         "derivatives": [[1,0,0],[1,0,0],[1,0,0]])")) ==
        "/: \"derivatives\" and \"tangents\" exclude each other");
  CHECK(refusal(json(R"(, "tangent": [])")) ==
        "/: unknown key \"tangent\"; the nearest known key is \"tangents\"");
  CHECK(refusal(R"({"phrame": "points/1", "points": [[0, 0, 0], [1, 1]]})") ==
        "/points/1: 2 numbers here, but 3 in the first point");
  CHECK(refusal(R"({"phrame": "points/1", "points": [[0, 0, 0]]})") ==
        "/points: 1 point; a curve needs two at least");
  CHECK(refusal(R"({"phrame": "points/1", "points": [[0], [1]]})") ==
        "/points/0: a point has 2 or 3 coordinates, not 1");
  CHECK(refusal(R"({"phrame": "points/1", "points": [[0, 0], [1, "nan"]]})")
            .starts_with("/points/1/1: \"nan\" is not a number"));
  CHECK(refusal(R"({"phrame": "curve/1", "points": [[0, 0], [1, 1]]})") ==
        "/phrame: the format is \"points/1\", not \"curve/1\"");
  CHECK(refusal("1,2,3\n") == "line 1: there is one point; a curve needs two at least");
  CHECK(refusal("1,2,3\n4,5\n") == "line 2: 2 numbers here, but 3 in the first line of them");
  CHECK(refusal("x,y,z\n1,2,3\n4,nan,5\n").starts_with("line 3, y: \"nan\" is not a number"));
  CHECK(refusal("x,y,z\n") == "line 2: there are no points");
  CHECK(refusal("a,b,c\n1,2,3\n") == "line 1: columns x, y and z are wanted, or x and y");
  CHECK(refusal("x,z\n1,2\n3,4\n") == "line 1: missing is the column y");
  CHECK(refusal("x,y,x\n1,2,3\n3,4,3\n") == "line 1: two columns have the name x");
  CHECK(refusal("x,y,z,dx,dy\n1,2,3,4,5\n1,2,4,3,4\n") == "line 1: 2 columns of dx, but 3 of x");
  CHECK(
      refusal("1 2 3 4\n5 6 7 8\n") ==
      "line 1: there is no header, and of 4 columns it is not known what they are: 2 are x, y and "
      "3 are x, y, z");
  CHECK(refusal("t,x,y\n0,0,0\n0,1,1\n") ==
        "line 3: 0 is not greater than the parameter before it, 0");
  CHECK(refusal("") == "line 1: a table of numbers is wanted, below the names of its columns");
}

}  // namespace point_file_test
