#include "phrame/io/frame_parameters.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"

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

namespace {

/// Frames of the rotation-minimizing kind at these t, which they give as others.
std::vector<GivenFrame> frames_at(const NamedPath& named, const std::vector<Rational>& t,
                                  const std::vector<Rational>& given) {
  const PathAngle angle(named.path);
  std::vector<GivenFrame> frames;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const auto exact = [](const Vector<Real>& v) {
      const Vector<double> x = round_to_double(v);
      return Vector<Rational>{exact_rational(x[0]), exact_rational(x[1]), exact_rational(x[2])};
    };
    const Frame<Real> frame = rotation_minimizing_frame(angle, locate(named.path, t[k]));
    frames.push_back({given[k], exact(frame.e2), exact(frame.e3), exact(frame.e1)});
  }
  return frames;
}

const std::vector<Rational> some{0, Rational(7, 10), Rational(3, 2), Rational(29, 10), 3};

double farthest(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  double worst = a.size() == b.size() ? 0 : 1;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    worst = std::max(worst, std::abs(round_to_double(Rational(a[k] - b[k]))));
  return worst;
}

}  // namespace

TEST_CASE("frame parameters: frames that are the curve's at their t stay there") {
  CHECK_FALSE(better_parameters({"", spline()}, frames_at({"", spline()}, some, some)));
}

TEST_CASE("frame parameters: those of the file, shares and lengths are told by the tangents") {
  const NamedPath named = read_any_path("t,x,y,z\n0,0,0,0\n1,1,1,0\n3,2,1,1\n4,4,0,1\n");
  const PathLength length(named.path);
  std::vector<Rational> lengths, shares, units;
  const Rational whole = exact_rational(round_to_double(length.total()));
  for (const Rational& t : some) {
    lengths.push_back(exact_rational(round_to_double(length.value(locate(named.path, t)))));
    shares.push_back(t == 3 ? Rational(1) : Rational(lengths.back() / whole));
    units.push_back(t / 3);
  }
  const std::vector<Rational> native{0, Rational(7, 10), 2, Rational(39, 10), 4};
  for (const auto& reading : {std::pair(native, "the parameter of the file"),
                              std::pair(units, "t over the number of segments"),
                              std::pair(shares, "the share"), std::pair(lengths, "the arc")}) {
    const auto& given = reading.first;
    const std::string what = reading.second;
    CAPTURE(what);
    const auto found = better_parameters(named, frames_at(named, some, given));
    REQUIRE(found);
    CHECK(found->what.starts_with(what));
    CHECK(farthest(found->t, some) < 1e-14);
  }
}

TEST_CASE("frame parameters: shares of the length that fit nearly are moved along the tangents") {
  const NamedPath named{"", spline()};
  const PathLength length(named.path);
  std::vector<Rational> given;
  for (const Rational& t : some) {
    const double share =
        round_to_double(length.value(locate(named.path, t))) / round_to_double(length.total());
    given.push_back(t == 0 || t == 3 ? Rational(t / 3) : exact_rational(share + 1e-3));
  }
  const auto found = better_parameters(named, frames_at(named, some, given));
  REQUIRE(found);
  CHECK(found->what.find("moved to where the tangents") != std::string::npos);
  CHECK(farthest(found->t, some) < 1e-12);
}

TEST_CASE("frame parameters: tangents that are a little off at our t are a fault of the table") {
  const NamedPath named{"", spline()};
  std::vector<Rational> moved;
  for (const Rational& t : some) moved.push_back(t == 3 ? t : Rational(t + Rational(1, 50)));
  CHECK_FALSE(better_parameters(named, frames_at(named, moved, some)));
  const NamedPath one{"", segment(spline(), 0, 1)};
  const std::vector<Rational> in_one{0, Rational(1, 3), 1};
  CHECK_FALSE(
      better_parameters(one, frames_at(one, {0, Rational(1, 2), 1}, in_one)));  // unit is t itself
}

TEST_CASE("frame parameters: of formulas the parameter is s, from and to where they are") {
  const NamedPath arc = read_any_path(R"json({"phrame": "curve/1", "from": 0, "to": "pi/4",
      "expressions": {"x": "cos(s)", "y": "sin(s)", "z": "s/3"}})json");
  REQUIRE(arc.parameters.size() == 2);
  const Real t = native_place(arc, Rational(1, 2)).t;
  CHECK(std::abs(round_to_double(t) - 2 / M_PI) < 1e-16);
  CHECK_THROWS_AS(native_place(arc, Rational(4, 5)), DomainError);
  CHECK_THROWS_AS(native_place({"", spline()}, 0), DomainError);  // it was read, but not kept
}

}  // namespace frame_parameters_test
