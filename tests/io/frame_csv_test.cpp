#include "phrame/io/frame_csv.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;

namespace {

std::string refusal(const std::string& text) {
  try {
    read_frames(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("frame table: numbers are read exactly, other columns are skipped") {
  const auto frames =
      read_frames("# by hand\n\nx,t,f2x,f2y,f2z\r\n?, 0.1, 1e-3,\t-2,1/3\r\n\n9,1,0,0,0x1p-1\n");
  REQUIRE(frames.size() == 2);
  CHECK(frames[0].t == Rational(1, 10));
  CHECK(frames[0].f2 == Vector<Rational>{Rational(1, 1000), -2, Rational(1, 3)});
  CHECK(frames[1].f2[2] == Rational(1, 2));
  CHECK_FALSE(frames[0].f3);
  CHECK_FALSE(frames[0].tangent);
  const auto all = read_frames("f3x,f3y,f3z,e1x,e1y,e1z,f2x,f2y,f2z,t\n1,2,3,4,5,6,7,8,9,0");
  CHECK(all[0].f3 == Vector<Rational>{1, 2, 3});
  CHECK(all[0].tangent == Vector<Rational>{4, 5, 6});
  CHECK(all[0].f2 == Vector<Rational>{7, 8, 9});
}

// q = 1 + k turns x to y, y to −x; twice as long it means the same.
TEST_CASE("frame table: quaternions mean frames by a convention") {
  const std::string text = "t,qw,qx,qy,qz\n0,2,0,0,2\n";
  const GivenFrame x = read_frames(text)[0];
  CHECK(x.tangent == Vector<Rational>{0, 1, 0});
  CHECK(x.f2 == Vector<Rational>{-1, 0, 0});
  CHECK(x.f3 == Vector<Rational>{0, 0, 1});
  const GivenFrame z = read_frames(text, {2, false})[0];
  CHECK(z.tangent == Vector<Rational>{0, 0, 1});
  CHECK(z.f2 == Vector<Rational>{0, 1, 0});
  CHECK(z.f3 == Vector<Rational>{-1, 0, 0});
  CHECK(read_frames(text, {0, true})[0].tangent == Vector<Rational>{0, -1, 0});
}

TEST_CASE("frame table: what is wrong is told with line and column") {
  CHECK(refusal("") == "line 1: a header with the names of the columns is wanted");
  CHECK(refusal("t,f2x,f2y,f2z\n") == "line 2: there are no frames");
  CHECK(refusal("f2x,f2y,f2z\n1,0,0") == "line 1: a column \"t\" is wanted");
  CHECK(refusal("t,f2x,f2y\n0,1,0") ==
        "line 1: columns f2x, f2y, f2z or qw, qx, qy, qz are wanted");
  CHECK(refusal("t,t,f2x,f2y,f2z\n") == "line 1: the column \"t\" is there twice");
  CHECK(refusal("t,f2x,f2y,f2z,qw,qx,qy,qz\n") ==
        "line 1: columns of vectors (f2x) and of quaternions (qw) exclude each other");
  CHECK(refusal("t,f2x,f2y,f2z\n\n0,1,0\n") ==
        "line 3: 4 numbers are wanted as in the header, not 3");
  CHECK(refusal("t,f2x,f2y,f2z\n0,1,nan,0\n").starts_with("line 2, f2y: "));
  CHECK(refusal("t,qw,qx,qy,qz\n0,0,0,0,0\n") == "line 2: the quaternion is 0");
}
