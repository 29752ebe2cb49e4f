#include "phrame/ph/frame/frame_check.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

using Kind = FrameFinding::Kind;

const Path cubic(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}}));

Vector<Rational> exactly(const Vector<double>& v) {
  return {exact_rational(v[0]), exact_rational(v[1]), exact_rational(v[2])};
}

Vector<Rational> rounded(const Vector<Real>& v) { return exactly(round_to_double(v)); }

GivenFrame rounded(const Rational& t, const Frame<Real>& frame) {
  return {t, rounded(frame.e2), rounded(frame.e3), rounded(frame.e1)};
}

/// Of `count` frames on a path, at equal steps of t, those that `frame` makes.
template <class Make>
std::vector<GivenFrame> along(const Path& path, long count, Make frame) {
  std::vector<GivenFrame> frames;
  for (long k = 0; k <= count; ++k) {
    const Rational t = path.end() * Rational(k, count);
    frames.push_back(rounded(t, frame(Place(locate(path, t)))));
  }
  return frames;
}

std::vector<Kind> kinds(const FrameVerdict& verdict) {
  std::vector<Kind> list;
  for (const FrameFinding& finding : verdict.findings) list.push_back(finding.kind);
  return list;
}

bool is_near(const RealBall& x, const char* value, const char* bound) {
  const Rational middle = parse_rational(value);
  const Rational most = parse_rational(bound);
  return abs(Rational(x.lower() - middle)) < most && abs(Rational(x.upper() - middle)) < most;
}

}  // namespace

// f₂ of the solution of f₂′ = −(f₂·T′)T with f₂(0) = (0, 1, 0), by mpmath's odefun with 30 digits.
TEST_CASE("smooth check: the solution of an independent method passes") {
  const std::vector<GivenFrame> frames{
      {0, {0, 1, 0}},
      {Rational(1, 2),
       exactly({-0.9583377490235709016413, 0.1713824762533109234127, -0.2285099683377478978835})},
  };
  FrameCheckOptions options;
  options.tolerance = parse_rational("4e-16");
  CHECK(check_frames(PathAngle(cubic), frames, options).passes);
  options.tolerance = parse_rational("1e-18");
  CHECK_FALSE(check_frames(PathAngle(cubic), frames, options).passes);
}

// −∫ τ ds = −1.65740642390110110987772706379 by mpmath's quad; n and b are the frame of v at both
// ends.
TEST_CASE("smooth check: frames of other kinds are recognised, and their angle is the error") {
  const PathAngle upright(cubic, {0, 0, 1});
  const auto of_up = along(cubic, 10, [&](const Place& at) {
    return up_frame(cubic, {0, 0, 1}, at);
  });
  // By the frame of this v and by that of another one, which is found for itself.
  for (const PathAngle& angle : {upright, PathAngle(cubic, {1, 0, 3})}) {
    const FrameVerdict up = check_frames(angle, of_up);
    CHECK(kinds(up) == std::vector{Kind::fixed_up});
    CHECK(up.findings.at(0).up == Vector<Rational>{0, 0, 1});
    CHECK(is_near(up.max_error, "1.65740642390110110987772706379", "1e-15"));
    CHECK(up.worst_sample == 10);
  }
  const auto of_frenet = along(cubic, 10, [](const Place& at) { return frenet_frame(cubic, at); });
  const FrameVerdict frenet = check_frames(PathAngle(cubic, {1, 0, 3}), of_frenet);
  CHECK(kinds(frenet) == std::vector{Kind::frenet});
  CHECK_FALSE(frenet.findings.at(0).up.has_value());
  CHECK(is_near(frenet.max_error, "1.65740642390110110987772706379", "1e-15"));
  const auto backwards = along(cubic, 10, [&](const Place& at) {
    return turned(up_frame(cubic, {0, 0, 1}, at), -upright.value(at));
  });
  const FrameVerdict turned = check_frames(upright, backwards);
  CHECK(kinds(turned) == std::vector{Kind::turned_backwards});
  CHECK(turned.findings.at(0).up == Vector<Rational>{0, 0, 1});
}

TEST_CASE("smooth check: a frame starts at the angle or along the vector that is asked for") {
  const PathAngle angle(cubic, {0, 0, 1});
  const auto frames = along(cubic, 10, [&](const Place& at) {
    return rotation_minimizing_frame(angle, at, Rational(1, 7));
  });
  CHECK(check_frames(angle, frames).passes);
  FrameCheckOptions options;
  options.start = Angle(Rational(1, 7));
  CHECK(check_frames(angle, frames, options).passes);
  options.start = Angle();
  const FrameVerdict offset = check_frames(angle, frames, options);
  CHECK(kinds(offset) == std::vector{Kind::constant_offset});
  CHECK(is_near(offset.max_error, "0.142857142857142857", "1e-15"));
  // At t = 0 the frame of v is ((1, 0, 0), (0, 1, 0), (0, 0, 1)).
  options.start =
      StartNormal({5, exact_rational(std::cos(1.0 / 7)), exact_rational(std::sin(1.0 / 7))});
  CHECK(check_frames(angle, frames, options).passes);
  options.start = StartNormal({5, 0, 0});
  CHECK_THROWS_AS(check_frames(angle, frames, options), DomainError);
  CHECK_THROWS_AS(check_frames(angle, {{2, {0, 1, 0}}}), DomainError);
}

TEST_CASE("smooth check: vectors that are wrong are found") {
  const PathAngle angle(cubic, {0, 0, 1});
  auto frames =
      along(cubic, 10, [&](const Place& at) { return rotation_minimizing_frame(angle, at); });
  CHECK(check_frames(angle, frames).deviations[3].handedness == 1);
  frames[1].f2 = *frames[1].tangent;
  frames[2].tangent = frames[2].f2;
  frames[4].tangent = Rational(-1) * *frames[4].tangent;
  frames[4].f3 = Rational(-1) * *frames[4].f3;
  frames[6].f3 = Rational(-1) * *frames[6].f3;
  frames[8].f2 = Rational(1001, 1000) * frames[8].f2;
  const FrameVerdict verdict = check_frames(angle, frames);
  const auto samples = [&](Kind kind) {
    for (const FrameFinding& finding : verdict.findings)
      if (finding.kind == kind) return finding.samples;
    return std::vector<std::size_t>{};
  };
  using Samples = std::vector<std::size_t>;
  CHECK(samples(Kind::wrong_tangent) == Samples{2});
  CHECK(samples(Kind::reversed_tangent) == Samples{4});
  CHECK(samples(Kind::left_handed) == Samples{6});
  CHECK(samples(Kind::not_unit) == Samples{8});
  // f₂ of sample 1 is the tangent but for rounding: its angle is that of the error of rounding.
  CHECK(verdict.deviations[1].orthogonality.upper() > Rational(999, 1000));
  frames[1].f2 = Vector<Rational>{};
  CHECK(check_frames(angle, frames).findings.front().kind == Kind::undefined);
}

// x² + y² = 1 in a quarter, (1 − t², 2t)/(1 + t²): its normal and its plane's never turn.
TEST_CASE("smooth check: exact frames of a plane rational curve are off by nothing") {
  const Path arc(RationalCurve({Polynomial{1, 0, -1}, {0, 2}, {}}, Polynomial{1, 0, 1}));
  std::vector<GivenFrame> frames;
  for (long k = 0; k <= 4; ++k) {
    const Rational t(k, 4);
    const Vector<Rational> r{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t), 0};
    frames.push_back({t, r, Vector<Rational>{0, 0, 1}, Vector<Rational>{-r[1], r[0], 0}});
  }
  FrameCheckOptions none;
  none.tolerance = parse_rational("1e-30");
  const FrameVerdict verdict = check_frames(PathAngle(arc), frames, none);
  CHECK(kinds(verdict) == std::vector{Kind::left_handed});
  for (GivenFrame& frame : frames) frame.f3 = Vector<Rational>{0, 0, -1};
  CHECK(check_frames(PathAngle(arc), frames, none).passes);
}

TEST_CASE("smooth check: on a straight line whatever does not turn is rotation-minimizing") {
  const Path line(bezier_curve({{0, 0, 0}, {1, 2, 2}, {3, 6, 6}}));
  const PathAngle angle(line);
  const Vector<Rational> normal{0, 1, -1};
  FrameCheckOptions options;
  options.tolerance = 1;  // of the length, √2
  CHECK(check_frames(angle, {{0, normal}, {Rational(1, 3), normal}, {1, normal}}, options).passes);
  const FrameVerdict turning =
      check_frames(angle, {{0, normal}, {Rational(1, 3), normal}, {1, {-4, 1, 1}}}, options);
  CHECK_FALSE(turning.passes);
  CHECK(is_near(turning.max_error, "1.5707963267948966192313", "1e-15"));
  CHECK(is_near(turning.drift.value(), "0.17453292519943295769237", "1e-15"));  // over 9
}

// Two ways to the same verdict: closed forms, and integrals of the same curve by its positions. One
// multiplier changes its sign, and one has zeros at both ends; all are > 0 at first.
TEST_CASE("smooth check: a PH path by its positions is judged as that path") {
  const Polynomial multipliers[] = {{1}, {2, -1}, {Rational(1, 3), -1}, {0, 1, -1}};
  test::for_samples(12, [&](test::Random& random) {
    const auto choice = static_cast<std::size_t>(random.integer(0, 3));
    const PhPath path(Curve(test::quintic.preimage(), multipliers[choice], {}));
    const Path smooth = by_positions(path);
    const PathAngle theta(path);
    std::vector<GivenFrame> frames;
    for (long k = 0; k <= 6; ++k) {
      const Rational t(k, 6);
      const Real error = theta.value(t) + Rational(random.integer(-20, 20), 1000);
      GivenFrame frame =
          rounded(t, turned(as_real(euler_rodrigues_frame(path.segments()[0], t)), error));
      if (random.integer(0, 3) == 0) frame.tangent = Rational(-1) * *frame.tangent;
      if (random.integer(0, 3) == 0) frame.f3 = Rational(2) * *frame.f3;
      if (random.integer(0, 3) == 0) frame.tangent.reset();
      frames.push_back(frame);
    }
    const FrameVerdict known = check_frames(PathAngle(path), frames);
    const FrameVerdict found = check_frames(PathAngle(smooth), frames);
    CHECK(found.passes == known.passes);
    CHECK(found.worst_sample == known.worst_sample);
    CHECK(found.max_error.overlaps(known.max_error));
    CHECK(found.max_error.is_accurate(60));
    CHECK(found.orthogonality.overlaps(known.orthogonality));
    CHECK(found.length.overlaps(known.length));
    REQUIRE(kinds(found) == kinds(known));
    for (std::size_t k = 0; k < found.findings.size(); ++k)
      CHECK(found.findings[k].samples == known.findings[k].samples);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      CHECK(found.deviations[k].handedness == known.deviations[k].handedness);
      CHECK(found.deviations[k].is_reversed == known.deviations[k].is_reversed);
      CHECK(found.deviations[k].tangent_sine.overlaps(known.deviations[k].tangent_sine));
    }
    if (known.drift) CHECK(found.drift.value().overlaps(*known.drift));
    CHECK(are_along_curve(smooth, frames, Rational(1, 1000)) ==
          are_along_curve(path, frames, Rational(1, 1000)));
  });
}

TEST_CASE("smooth check: are positions those of the curve?") {
  const auto at = [&](const Rational& t) {
    const auto r = position(cubic, locate(cubic, t));
    return Vector<Rational>{*r[0].exact() + 7, *r[1].exact(), *r[2].exact() - 2};
  };
  std::vector<GivenPosition> positions{
      {0, at(0)}, {Rational(1, 3), at(Rational(1, 3))}, {1, at(1)}};
  CHECK(are_on_curve(cubic, positions, 0));
  positions[1].r[2] += Rational(1, 100);
  CHECK_FALSE(are_on_curve(cubic, positions, Rational(1, 1000)));
  CHECK(are_on_curve(cubic, positions, Rational(1, 10)));
}
