#include "phrame/io/frame_parameters.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"

namespace frame_parameters_test {

using namespace phrame;

namespace {

/// Of segments that take 1, 2 and 1: t = 1, 2 are at other times.
Path spline() { return read_any_path("t,x,y,z\n0,0,0,0\n1,1,1,0\n3,2,1,1\n4,4,0,1\n").path; }

Vector<Rational> at(const Path& path, const Rational& t) {
  const PathParameter where = locate(path, t);
  return point(*rational_curve(path.segments()[where.segment]), where.t);
}

/// At these t, with these times, moved by (5, 0, 0).
std::vector<GivenPosition> positions(const std::vector<Rational>& t,
                                     const std::vector<Rational>& times) {
  const Path path = spline();
  std::vector<GivenPosition> list;
  for (std::size_t k = 0; k < t.size(); ++k)
    list.push_back({times[k], at(path, t[k]) + Vector<Rational>{5, 0, 0}});
  return list;
}

}  // namespace

TEST_CASE("frame parameters: joints, times and equal steps are told by the positions") {
  const FrameParameters joints = frame_parameters(spline(), positions({0, 1, 2, 3}, {0, 1, 3, 4}));
  CHECK(joints.t == std::vector<Rational>{0, 1, 2, 3});
  CHECK(joints.what.starts_with("the joints"));
  const Rational some(7, 10);
  const FrameParameters times = frame_parameters(spline(), positions({0, some, 3}, {10, 17, 40}));
  CHECK(times.t == std::vector<Rational>{0, some, 3});
  CHECK(times.what.starts_with("the times"));
  const Rational half(3, 2);
  const FrameParameters steps = frame_parameters(spline(), positions({0, half, 3}, {0, 1, 2}));
  CHECK(steps.t == std::vector<Rational>{0, half, 3});
  CHECK(steps.what.starts_with("equal steps"));
}

TEST_CASE("frame parameters: positions that fit nowhere are refused") {
  CHECK_THROWS_AS(frame_parameters(spline(), positions({0, 1, 3}, {0, 1, 2})), InputError);
  CHECK_THROWS_AS(frame_parameters(spline(), positions({0}, {0})), InputError);
}

}  // namespace frame_parameters_test
