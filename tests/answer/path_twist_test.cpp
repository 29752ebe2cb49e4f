#include "phrame/answer/path_twist.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/construction.hpp"
#include "phrame/answer/frame_table.hpp"
#include "phrame/answer/sweep.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/sweep/sweep_turn.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace path_twist_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

const nlohmann::json& truth() {
  static const nlohmann::json json = [] {
    std::ifstream file(test::data("/poses.json"));
    return nlohmann::json::parse(file);
  }();
  return json;
}

NamedPath path_of_truth(bool is_smooth) {
  nlohmann::json path = truth()["path"];
  path["frame"]["twist"] = is_smooth ? "smooth" : "even";
  return read_any_path(path.dump());
}

/// To 25 digits of those that the other program has.
void check_near(const Real& x, const nlohmann::json& wanted) {
  const RealBall value = x.enclose(160);
  const Rational expected = parse_rational(wanted.get<std::string>());
  CAPTURE(expected);
  CHECK(abs(value.lower() - expected) < power_of_ten(-25));
  CHECK(abs(value.upper() - expected) < power_of_ten(-25));
}

double as_double(const Real& x) { return round_to_double(x); }

Orientation random_orientation(Random& random) {
  for (;;) {
    const RationalQuaternion p{random.rational(), random.rational(), random.rational(),
                               random.rational()};
    if (norm(p) != 0) return {p, 0};
  }
}

/// Poses at random points; of x that goes on, so that curves are not wild.
GivenPoints random_poses(Random& random, long count) {
  GivenPoints given;
  given.poses.emplace();
  for (long k = 0; k < count; ++k) {
    given.points.push_back({k + Rational(random.integer(-9, 9), 40),
                            Rational(random.integer(-9, 9), 10),
                            Rational(random.integer(-9, 9), 10)});
    given.poses->bodies.push_back(random_orientation(random));
  }
  return given;
}

/// The frame of a body there.
Frame<Rational> frame_of(const Orientation& body, const TangentAxis& tangent) {
  const Quaternion<Integer> q = frame_rotation(body.rotation, tangent);
  const RationalQuaternion p = each(q, [](const Integer& x) { return Rational(x); });
  const Rational scale = 1 / norm(p);
  return {scale * rotated_i(p), scale * rotated_j(p), scale * rotated_k(p)};
}

}  // namespace

// tests/data/poses.py, by mpmath.
TEST_CASE(
    "frame through orientations: turns, rates and vectors are those of an integration of its own") {
  for (const bool is_smooth : {false, true}) {
    CAPTURE(is_smooth);
    const NamedPath named = path_of_truth(is_smooth);
    const PathTwist twist(PathAngle(named.path), *named.frame);
    CHECK(twist.is_smooth() == is_smooth);
    REQUIRE(twist.legs().size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
      check_near(twist.legs()[k].twist.length(), truth()["lengths"][k]);
      check_near(twist.legs()[k].twist.twist(), truth()["turns"][k]);
    }
    const auto& wanted = truth()[is_smooth ? "smooth" : "even"];
    check_near(twist.squared_rate(), wanted["squared_rate"]);
    if (is_smooth) check_near(twist.squared_slope(), wanted["squared_slope"]);
    for (const auto& item : wanted["at"].items()) {
      const std::string& t = item.key();
      const auto& at = item.value();
      CAPTURE(t);
      const Place place = locate_inside(3, parse_rational(t));
      const Frame<Real> frame = twist.frame(place);
      for (std::size_t k = 0; k < 3; ++k) check_near(frame.e2[k], at["f2"][k]);
      check_near(twist.rate(place), at["rate"]);
      check_near(twist.rate_slope(place), at["slope"]);
    }
  }
}

TEST_CASE(
    "frame through orientations: by another reference frame, and of a path that is not PH, it is "
    "the same") {
  for (const bool is_smooth : {false, true}) {
    const NamedPath named = path_of_truth(is_smooth);
    const PathTwist twist(PathAngle(named.path), *named.frame);
    const PathTwist to_up(PathAngle(named.path, Reference::up), *named.frame);
    const PathTwist positions(PathAngle(test::by_positions(*named.path.ph())), *named.frame);
    for (const char* t : {"0", "1/3", "1", "7/4", "5/2", "3"}) {
      const Place at = locate_inside(3, parse_rational(t));
      const Frame<Real> frame = twist.frame(at);
      for (const PathTwist* other : {&to_up, &positions})
        for (std::size_t k = 0; k < 3; ++k)
          CHECK(frame.e2[k].enclose(100).overlaps(other->frame(at).e2[k].enclose(100)));
    }
    // θ goes on through the joints, with the turn that leg 2 has more.
    for (const long joint : {1, 2}) {
      const Real before = twist.value({static_cast<std::size_t>(joint - 1), Rational(1)});
      const Real behind = twist.value({static_cast<std::size_t>(joint), Rational(0)});
      CHECK(before.enclose(100).overlaps(behind.enclose(100)));
    }
  }
}

TEST_CASE("frame through orientations: poses are met exactly, whatever they are") {
  long sample = 0;
  for_samples(12, [&](Random& random) {
    ++sample;
    GivenPoints given = random_poses(random, random.integer(2, 5));
    given.poses->tangent = {static_cast<std::size_t>(sample % 3), sample % 2 == 1};
    given.poses->is_smooth = random.chance(2);
    ConstructQuery query;
    if (random.chance(3)) query.points = PointRule::exact;
    query.is_closed = random.chance(3) && given.points.size() > 2;
    const ConstructionAnswer found = answer(given, query);
    const PathTwist twist(PathAngle(found.path.path), *found.path.frame);
    for (std::size_t k = 0; k < given.points.size(); ++k) {
      const std::size_t joint = found.path.frame->joints[k].joint;
      const Frame<Real> frame = twist.frame(
          locate_inside(found.path.path.segments().size(), Rational(static_cast<long>(joint))));
      const Frame<Rational> wanted = frame_of(given.poses->bodies[k], given.poses->tangent);
      CHECK(exactly(frame.e1) == wanted.e1);
      CHECK(exactly(frame.e2) == wanted.e2);
      CHECK(exactly(frame.e3) == wanted.e3);
    }
    for (const PathTwist::Leg& leg : twist.legs()) {
      const RealBall turn = leg.twist.twist().enclose(128);
      CHECK(turn.lower() > Rational(-314159266, 100000000));
      CHECK(turn.upper() < Rational(314159266, 100000000));
    }
  });
}

TEST_CASE("frame through orientations: no other way to turn has less of what is least") {
  for (const bool is_smooth : {false, true}) {
    const NamedPath named = path_of_truth(is_smooth);
    const PathTwist twist(PathAngle(named.path), *named.frame);
    // Against φ + c·sin²(πu) on a leg, by Simpson's rule: it has the same values and rates at
    // joints.
    for (std::size_t k = 0; k < 3; ++k)
      for (const double c : {0.3, -0.3, 0.01, -0.01}) {
        const double S = as_double(twist.legs()[k].twist.length());
        double more = 0;
        constexpr long steps = 400;
        const double a = as_double(twist.rate_at_start(k) + -twist.legs()[k].twist.rate());
        const double b = as_double(twist.rate_at_end(k) + -twist.legs()[k].twist.rate());
        const double even = as_double(twist.legs()[k].twist.rate());
        for (long n = 0; n <= steps; ++n) {
          const double u = static_cast<double>(n) / steps;
          const double weight = n == 0 || n == steps ? 1 : n % 2 == 1 ? 4 : 2;
          const double rate = even + a * (1 - u) * (1 - 3 * u) + b * u * (3 * u - 2);
          const double slope = (a * (6 * u - 4) + b * (6 * u - 2)) / S;
          const double change = c * M_PI * std::sin(2 * M_PI * u) / S;
          const double change2 = 2 * c * M_PI * M_PI * std::cos(2 * M_PI * u) / (S * S);
          const double now = is_smooth ? slope * slope : rate * rate;
          const double then =
              is_smooth ? (slope + change2) * (slope + change2) : (rate + change) * (rate + change);
          more += weight * (then - now) * S / (3 * steps);
        }
        CHECK(more > 0);
      }
  }
  // Of a smooth frame the rate goes on through the joints, and its derivative as well, which is 0
  // at the ends.
  const NamedPath named = path_of_truth(true);
  const PathTwist twist(PathAngle(named.path), *named.frame);
  for (const std::size_t k : {1U, 2U}) {
    const Place before(k - 1, Rational(1));
    const Place behind(k, Rational(0));
    CHECK(twist.rate(before).enclose(100).overlaps(twist.rate(behind).enclose(100)));
    CHECK(twist.rate_slope(before).enclose(100).overlaps(twist.rate_slope(behind).enclose(100)));
  }
  CHECK(std::abs(as_double(twist.rate_slope({0, Rational(0)}))) < 1e-15);
  CHECK(std::abs(as_double(twist.rate_slope({2, Rational(1)}))) < 1e-15);
}

TEST_CASE(
    "frame through orientations: angular velocity and acceleration are the derivatives of frames") {
  using enum TabulatedScalar;
  constexpr long digits = 40;
  for (const bool is_smooth : {false, true}) {
    const NamedPath named = path_of_truth(is_smooth);
    const PathAngle rmf(named.path);
    TableColumns columns{{TabulatedFrame::exact_mtf},
                         {arc_length, twist_omega_x, twist_omega_y, twist_omega_z, twist_alpha_x,
                          twist_alpha_y, twist_alpha_z}};
    columns.exact_mtf.emplace(rmf, *named.frame);
    columns.digits = digits;
    // Also of the curve by its positions, with f ≠ 1 and a weight.
    const Rational h = power_of_two(-40);
    for (const char* t : {"1/3", "5/4", "11/4"}) {
      CAPTURE(t);
      const Rational at = parse_rational(t);
      std::vector<Place> places;
      for (const Rational& x : {Rational(at - h), at, Rational(at + h)})
        places.emplace_back(locate_inside(3, x));
      const FrameTable table = frame_table(rmf, columns, places);
      const auto cell = [&](std::size_t row, std::size_t column) {
        return parse_rational(table.decimals[row][column]);
      };
      const auto slope = [&](std::size_t column) {
        return Rational((cell(2, column) - cell(0, column)) / (cell(2, 13) - cell(0, 13)));
      };
      const auto vector = [&](std::size_t column) {
        return Vector<Rational>{cell(1, column), cell(1, column + 1), cell(1, column + 2)};
      };
      for (const std::size_t axis : {4U, 7U, 10U}) {  // e₁, f₂, f₃: their derivatives are ω × them
        const Vector<Rational> turned = cross(vector(14), vector(axis));
        for (std::size_t k = 0; k < 3; ++k)
          CHECK(abs(slope(axis + k) - turned[k]) < power_of_ten(-20));
      }
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(abs(slope(14 + k) - cell(1, 17 + k)) < power_of_ten(-20));
    }
  }
  // Of a rational curve, with |r′| that is no |H| times a constant.
  const Path arc(Segment(RationalCurve(
      {Polynomial{1, 0, -1}, Polynomial{0, 2}, Polynomial{0, 1, 3}}, Polynomial{1, 0, 1})));
  const auto turning = [&](const Rational& t) {
    const Vector<Real> bend = cross(tangent(arc, {0, t}), curvature_vector(arc, {0, t}));
    return near(bend);
  };
  const Rational h = power_of_two(-40);
  const Rational ds = near({PathLength(arc).value({0, Rational(1, 3) + h}) +
                                -PathLength(arc).value({0, Rational(1, 3) - h}),
                            Rational(0), Rational(0)})[0];
  const Vector<Rational> change = turning(Rational(1, 3) + h) - turning(Rational(1, 3) - h);
  const Vector<Rational> slope = near(turning_slope(arc, {0, Rational(1, 3)}));
  for (std::size_t k = 0; k < 3; ++k) CHECK(abs(change[k] / ds - slope[k]) < power_of_ten(-18));
}

TEST_CASE("frame through orientations: of a closed path the smooth one closes with its rate") {
  PathAngle rmf(test::closed_loop());
  FrameThrough through{{{0, {0, 0, 1}}, {1, {1, 1, 2}}, {3, {0, 2, -1}}, {4, {0, 0, 1}}}, true, {}};
  const PathTwist twist(rmf, through);
  REQUIRE(twist.legs().size() == 3);
  CHECK(twist.legs()[1].segments == 2);
  const Place start(0, Rational(0));
  const Place end(3, Rational(1));
  CHECK(twist.rate(start).enclose(100).overlaps(twist.rate(end).enclose(100)));
  CHECK(twist.rate_slope(start).enclose(100).overlaps(twist.rate_slope(end).enclose(100)));
  CHECK(std::abs(as_double(twist.rate_slope(start))) > 1e-3);
  // At the joint in the middle of a leg nothing is special.
  CHECK_FALSE(twist.is_joint({2, Rational(0)}));
  CHECK(twist.value({1, Rational(1)})
            .enclose(100)
            .overlaps(twist.value({2, Rational(0)}).enclose(100)));
}

TEST_CASE(
    "frame through orientations: what is not on the path, and along its tangent, is refused") {
  const NamedPath named = path_of_truth(false);
  const PathAngle rmf(named.path);
  CHECK_THROWS_AS(PathTwist(rmf, {{{0, {0, 0, 1}}, {2, {0, 1, 0}}}}), DomainError);
  CHECK_THROWS_AS(
      PathTwist(rmf, {{{0, {0, 0, 1}}, {2, {0, 1, 0}}, {2, {0, 1, 0}}, {3, {1, 0, 0}}}}),
      DomainError);
  const Vector<Rational> tangent = *exactly(direction(named.path, {1, Rational(0)}));
  CHECK_THROWS_WITH_AS(PathTwist(rmf, {{{0, {0, 0, 1}}, {1, tangent}, {3, {1, 0, 0}}}}),
                       doctest::Contains("the orientation at t = 1: the vector"), DomainError);
  CHECK_THROWS_AS(answer(NamedPath("", named.path), PathTwistQuery{}), DomainError);
}

TEST_CASE("frame through orientations: a body turns as the frame does") {
  for (const bool is_smooth : {false, true}) {
    const NamedPath named = path_of_truth(is_smooth);
    const PathAngle rmf(named.path);
    const PathTwist twist(rmf, *named.frame);
    const SweepPath path =
        sweep_path(named.path, CompiledFrames(rmf, twist.legs().front().twist.from()));
    SweepForm form{rectangle_profile(1, 2), {}, 0, 10L};
    for (std::size_t k = 0; k < 3; ++k) {
      form.legs.push_back({k + 1, as_double(twist.legs()[k].twist.twist())});
      if (!is_smooth) continue;
      const Real even = twist.legs()[k].twist.rate();
      form.legs.back().rate_at_start = as_double(twist.rate_at_start(k) + -even);
      form.legs.back().rate_at_end = as_double(twist.rate_at_end(k) + -even);
    }
    const SweepTurn turn(path, form);
    CHECK(turn.error() < 1e-11);
    for (std::size_t k = 0; k < 3; ++k)
      for (const double t : {0.0, 0.25, 0.7, 1.0}) {
        const Place at(k, exact_rational(t));
        const double rate = as_double(twist.rate(at));
        CHECK(turn.rate(k, t) == doctest::Approx(rate).epsilon(1e-12));
        CHECK(std::abs(rate) <= turn.rate_bound(k));
        CHECK(std::abs(as_double(twist.rate_slope(at))) <= turn.second_bound(k) + 1e-15);
        const Real phi = twist.value(at) + -twist.value({0, Rational(0)}) + -rmf.value(at);
        CHECK(std::abs(as_double(phi) - turn.angle(k, t)) <= turn.error());
      }
  }
}

TEST_CASE("roll: a constant one is a start turned by it, in tables and bodies") {
  const NamedPath named = path_of_truth(false);
  const PathAngle rmf(named.path);
  const Angle quarter(Rational(1, 2), 0);
  std::vector<Place> places;
  for (const char* t : {"0", "2/3", "3/2", "3"})
    places.emplace_back(locate_inside(3, parse_rational(t)));
  TableColumns started{{TabulatedFrame::rmf}};
  started.start = LeastRotation{quarter};
  TableColumns rolled{{TabulatedFrame::rmf, TabulatedFrame::euler_rodrigues}};
  rolled.roll = Roll(std::vector<Angle>(4, quarter));
  const FrameTable a = frame_table(rmf, started, places);
  const FrameTable b = frame_table(rmf, rolled, places);
  const FrameTable erf = frame_table(rmf, {{TabulatedFrame::euler_rodrigues}}, places);
  for (std::size_t row = 0; row < places.size(); ++row)
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(a.rows[row][7 + k] == b.rows[row][7 + k]);
      CHECK(erf.rows[row][7 + k] == b.rows[row][13 + k]);  // which is not turned
    }
  // A roll by the share of t is what a turn by the length is where the speed is constant.
  const NamedPath line("", Path(Curve({{1}, {}, {}, {}})));
  SweepQuery by_length{rectangle_profile(1, Rational(1, 2))};
  by_length.twist = quarter;
  by_length.tolerance_or_sections = 7L;
  SweepQuery by_roll{rectangle_profile(1, Rational(1, 2))};
  by_roll.roll = Roll(std::vector<Angle>{Angle(0, 0), quarter});
  by_roll.tolerance_or_sections = 7L;
  const auto one = answer(line, by_length).body.mesh.points;
  const auto other = answer(line, by_roll).body.mesh.points;
  REQUIRE(one.size() == other.size());
  for (std::size_t n = 0; n < one.size(); ++n)
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(one[n][k] - other[n][k]) < 1e-14);
  // Its rates bound what it does.
  SweepForm form{rectangle_profile(1, 2), {}, 0, 10L};
  form.roll =
      Roll(Roll::Piece{RationalFunction(Polynomial{0, 0, 1}), RationalFunction(Polynomial{1, -2})});
  const SweepTurn turn(sweep_path(named.path, CompiledFrames(rmf, StartAngle())), form);
  const RealBall all(Rational(1, 2), 64);
  CHECK(turn.angle(1, 0.5) == doctest::Approx(2.25 * M_PI - 2).epsilon(1e-14));
  CHECK(turn.roll_rate(1, 0.5) == doctest::Approx(3 * M_PI - 2).epsilon(1e-14));
  CHECK(turn.roll_bound(1, 1, all) >= 3 * M_PI - 2);
  CHECK(turn.roll_bound(2, 1, all) >= 2 * M_PI);
  CHECK_FALSE(turn.is_zero());
  by_roll.roll = Roll(std::vector<Angle>{Angle(0, 0), quarter, Angle(0, 0)});
  CHECK_THROWS_AS(answer(line, by_roll), DomainError);
}

}  // namespace path_twist_test
