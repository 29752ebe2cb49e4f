#include <algorithm>

#include "phrame/ph/curve/transform.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

using Points = std::vector<Vector<Rational>>;

/// The blossom of a Bézier curve: de Casteljau's algorithm with another t in every step.
Vector<Rational> blossom(Points points, const std::vector<Rational>& ts) {
  for (const Rational& t : ts) {
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      for (std::size_t j = 0; j < 3; ++j)
        points[k][j] = (1 - t) * points[k][j] + t * points[k + 1][j];
    points.pop_back();
  }
  return points.front();
}

/// The control points of the part from a to b: blossoms of n − k times a and k times b.
Points de_casteljau(const Points& points, const Rational& a, const Rational& b) {
  const std::size_t n = points.size() - 1;
  Points result;
  for (std::size_t k = 0; k <= n; ++k) {
    std::vector<Rational> ts(n, a);
    std::fill_n(ts.begin(), k, b);
    result.push_back(blossom(points, ts));
  }
  return result;
}

Rational other_than(const Rational& a, Random& random) {
  const Rational b = random.rational();
  return a == b ? Rational(b + 1) : b;
}

RationalQuaternion nonzero_quaternion(Random& random) {
  return {random.integer(1, 5), random.rational(), random.rational(), random.rational()};
}

/// U v U* by the product itself.
Vector<Rational> turned(const RationalQuaternion& u, const Vector<Rational>& v) {
  const RationalQuaternion product =
      u * RationalQuaternion{0, v[0], v[1], v[2]} * RationalQuaternion{u.u, -u.v, -u.p, -u.q};
  CHECK(product.u == 0);
  return {product.v, product.p, product.q};
}

Vector<Rational> times(const Rational& c, const Vector<Rational>& v) {
  return {c * v[0], c * v[1], c * v[2]};
}

template <class Map>
Points mapped(Points points, Map map) {
  for (auto& point : points) point = map(point);
  return points;
}

}  // namespace

TEST_CASE("transform: the right half of the cubic with A = 1 + t·k, by hand") {
  // A(1/2 + t/2) = 1 + k/2 + tk/2, r(1/2) = (1/2 − 1/24, 1/4, 0).
  const Curve half = segment(Curve({{1}, {}, {}, {0, 1}}), Rational(1, 2), 1);
  CHECK(half == Curve({{1}, {}, {}, {Rational(1, 2), Rational(1, 2)}}, {Rational(1, 2)},
                      {Rational(11, 24), Rational(1, 4), 0}));
}

TEST_CASE("transform: law: control points of a segment are those of de Casteljau") {
  for_samples(40, [](Random& random) {
    const Curve curve = random.curve(3);
    const Rational a = random.rational();
    const Rational b = other_than(a, random);
    CHECK(control_points(segment(curve, a, b)) == de_casteljau(control_points(curve), a, b));
    auto backwards = control_points(curve);
    std::reverse(backwards.begin(), backwards.end());
    CHECK(control_points(reversed(curve)) == backwards);
    CHECK(reversed(reversed(curve)) == curve);
  });
}

TEST_CASE("transform: law: segments of segments are segments; σ, h, g and θ′ follow") {
  for_samples(40, [](Random& random) {
    const Curve curve = random.curve(3);
    const Rational a = random.rational();
    const Rational b = other_than(a, random);
    const Rational c = random.rational();
    const Rational d = other_than(c, random);
    const Curve part = segment(curve, a, b);
    CHECK(segment(part, c, d) == segment(curve, a + (b - a) * c, a + (b - a) * d));
    CHECK(segment(part, -a / (b - a), (1 - a) / (b - a)) == curve);
    const Polynomial w{a, b - a};
    const Rational rate = b - a;
    const QuaternionPolynomial& old = curve.preimage();
    const QuaternionPolynomial& now = part.preimage();
    CHECK(sigma(now) == compose(sigma(old), w));
    CHECK(twist_numerator(now) == rate * compose(twist_numerator(old), w));
    CHECK(bend_numerator(now).re == rate * compose(bend_numerator(old).re, w));
    CHECK(bend_numerator(now).im == rate * compose(bend_numerator(old).im, w));
    CHECK(rho(now) == rate * rate * compose(rho(old), w));
    // The ERF stays; θ′ is multiplied.
    const Rational t = random.rational();
    const auto before = euler_rodrigues_frame(curve, w(t));
    const auto after = euler_rodrigues_frame(part, t);
    CHECK(before.e1 == after.e1);
    CHECK(before.e2 == after.e2);
    const RationalFunction theta = rate_to_erf(old);
    CHECK(rate_to_erf(now) ==
          RationalFunction(rate * compose(theta.numerator(), w), compose(theta.denominator(), w)));
  });
}

TEST_CASE("transform: law: rotations turn points and frames, h, σ and g are multiplied by |U|²") {
  for_samples(40, [](Random& random) {
    const Curve curve = random.curve(3);
    const RationalQuaternion u = nonzero_quaternion(random);
    const Rational size = norm(u);
    const Curve now = rotated(curve, u);
    CHECK(control_points(now) ==
          mapped(control_points(curve), [&](const auto& p) { return turned(u, p); }));
    CHECK(sigma(now.preimage()) == size * sigma(curve.preimage()));
    CHECK(twist_numerator(now.preimage()) == size * twist_numerator(curve.preimage()));
    CHECK(bend_numerator(now.preimage()) == Polynomial{size} * bend_numerator(curve.preimage()));
    CHECK(rho(now.preimage()) == size * size * rho(curve.preimage()));
    CHECK(rate_to_erf(now.preimage()) == rate_to_erf(curve.preimage()));
    // A pure rotation leaves length, curvature and torsion alone, and turns the frames.
    const Curve rigid = scaled(now, 1 / size);
    CHECK(arc_length(rigid) == arc_length(curve));
    CHECK(squared_curvature(rigid) == squared_curvature(curve));
    const Rational t = random.rational();
    const auto before = euler_rodrigues_frame(curve, t);
    const auto after = euler_rodrigues_frame(rigid, t);
    CHECK(after.e1 == times(1 / size, turned(u, before.e1)));
    CHECK(after.e2 == times(1 / size, turned(u, before.e2)));
    CHECK(after.e3 == times(1 / size, turned(u, before.e3)));
  });
}

TEST_CASE("transform: law: rotations compose like quaternions") {
  for_samples(30, [](Random& random) {
    const Curve curve = random.curve(2);
    const RationalQuaternion u = nonzero_quaternion(random);
    const RationalQuaternion v = nonzero_quaternion(random);
    CHECK(rotated(rotated(curve, u), v) == rotated(curve, v * u));
  });
}

TEST_CASE("transform: law: translations and scalings move the control points") {
  for_samples(30, [](Random& random) {
    const Curve curve = random.curve(3);
    const Vector<Rational> v{random.rational(), random.rational(), random.rational()};
    const Rational c = other_than(0, random);
    CHECK(control_points(translated(curve, v)) == mapped(control_points(curve), [&](const auto& p) {
            return Vector<Rational>{p[0] + v[0], p[1] + v[1], p[2] + v[2]};
          }));
    CHECK(control_points(scaled(curve, c)) ==
          mapped(control_points(curve), [&](const auto& p) { return times(c, p); }));
    CHECK(translated(curve, v).preimage() == curve.preimage());
    CHECK(scaled(curve, c).preimage() == curve.preimage());
  });
}

TEST_CASE("transform: what would make the curve a point is refused") {
  const Curve curve({{1}, {}, {}, {0, 1}});
  CHECK_THROWS_AS(segment(curve, Rational(1, 3), Rational(1, 3)), DomainError);
  CHECK_THROWS_AS(scaled(curve, 0), DomainError);
  CHECK_THROWS_AS(rotated(curve, {}), DomainError);
}

namespace {

/// A PH curve in two parts, a quarter of a circle, and formulas.
Path of_three_kinds() {
  const Curve ph({{1}, {}, {}, {0, 1}});
  const Rational third(1, 3);
  return joined({PhSegment(segment(ph, 0, third)), PhSegment(segment(ph, third, 1)),
                 bezier_curve({{2 * third, 1, 0}, {2 * third, 2, 0}, {-third, 2, 0}}, {1, 1, 2}),
                 test::expression_curve({"-1/3 - sin(s)", "1 + cos(s)", "s^2"}, "0", "pi/2")});
}

/// With a cusp, after which e₁ is the opposite of the tangent.
Path with_a_cusp() {
  const Polynomial x{Rational(-1, 2), 1};
  return joined({RationalCurve({x * x, x * x * x, {}}),
                 RationalCurve({Polynomial{Rational(1, 4), 4}, Polynomial{Rational(1, 8), 3}, {}}),
                 test::expression_curve({"17/4 + 4*s", "25/8 + 3*s", "s^2"}, "0", "1")});
}

/// X/W of the segments that have them.
std::vector<std::pair<Vector<Polynomial>, Polynomial>> by_positions_of(const Path& path) {
  std::vector<std::pair<Vector<Polynomial>, Polynomial>> found;
  for (const Segment& segment : path.segments())
    if (const RationalCurve* curve = rational_curve(segment))
      found.emplace_back(curve->numerator(), curve->weight());
  return found;
}

Vector<double> near_point(const Path& path, const Rational& t) {
  return round_to_double(position(path, locate(path, t)));
}

template <class Map>
void check_is_mapped(const Path& now, const Path& path, const Map& map) {
  CHECK(now.is_ph() == path.is_ph());
  CHECK(joined(now.segments()) == now);  // joints and e₁, as they are checked
  for (long k = 0; k <= 4 * static_cast<long>(path.segments().size()); ++k) {
    const auto found = near_point(now, Rational(k, 4));
    const Vector<double> expected = map(near_point(path, Rational(k, 4)));
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(found[j] == doctest::Approx(expected[j]).epsilon(1e-14));
  }
}

}  // namespace

TEST_CASE("transform: paths of segments of every kind are moved point by point, and join") {
  for (const Path& path : {of_three_kinds(), with_a_cusp(), Path(test::closed_loop())}) {
    check_is_mapped(translated(path, {1, Rational(1, 2), -3}), path, [](const auto& r) {
      return Vector<double>{r[0] + 1, r[1] + 0.5, r[2] - 3};
    });
    for (const long c : {3, -2})
      check_is_mapped(scaled(path, c), path, [&](const auto& r) {
        const auto by = static_cast<double>(c);
        return Vector<double>{by * r[0], by * r[1], by * r[2]};
      });
    // A third of a turn about (1, 1, 1), and four times as long.
    check_is_mapped(rotated(path, {1, 1, 1, 1}), path, [](const auto& r) {
      return Vector<double>{4 * r[2], 4 * r[0], 4 * r[1]};
    });
    check_is_mapped(rotated(path, {2, 0, 0, 1}), path, [](const auto& r) {
      return Vector<double>{3 * r[0] - 4 * r[1], 4 * r[0] + 3 * r[1], 5 * r[2]};
    });
    CHECK(scaled(scaled(path, -2), Rational(-1, 2)).segments().size() == path.segments().size());
  }
}

TEST_CASE(
    "transform: a path under any matrix is moved point by point; similarities keep what is PH") {
  const std::vector<std::pair<AffineMap, bool>> maps{
      {{{{{0, 3, 0}, {-3, 0, 0}, {0, 0, 3}}}, {1, 2, 3}}, true},         // a turn by 90°, thrice
      {{{{{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}}, {}}, true},               // 3 times a reflection
      {{{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, {0, 0, 1}}, true},         // in a plane
      {{{{{1, 0, 0}, {Rational(1, 2), 2, 0}, {0, 1, 1}}}, {}}, false},   // a shear
      {{{{{1, 0, 0}, {0, 1, 0}, {Rational(1, 3), 1, 0}}}, {}}, false}};  // a projection
  for (const auto& [map, is_similar] : maps) {
    CHECK(similarity(map).has_value() == is_similar);
    for (const Path& path : {of_three_kinds(), with_a_cusp(), Path(test::closed_loop())}) {
      const Path now = transformed(path, map);
      CHECK(joined(now.segments()) == now);
      if (is_similar) CHECK(now.is_ph() == path.is_ph());
      for (long k = 0; k <= 4 * static_cast<long>(path.segments().size()); ++k) {
        const auto found = near_point(now, Rational(k, 4));
        const auto r = near_point(path, Rational(k, 4));
        for (std::size_t j = 0; j < 3; ++j) {
          double expected = round_to_double(map.shift[j]);
          for (std::size_t i = 0; i < 3; ++i) expected += round_to_double(map.columns[i][j]) * r[i];
          CHECK(found[j] == doctest::Approx(expected).epsilon(1e-13));
        }
      }
      // A shear and back: what is PH is found again.
      if (map.columns[1][0] == Rational(1, 2)) {
        const AffineMap back{{{{1, 0, 0},
                               {Rational(-1, 4), Rational(1, 2), 0},
                               {Rational(1, 4), Rational(-1, 2), 1}}},
                             {}};
        CHECK(composed(map, back) == AffineMap{});
        CHECK(transformed(now, back).is_ph() == path.is_ph());
        CHECK(by_positions_of(transformed(now, back)) == by_positions_of(path));
      }
    }
  }
  const Path line(bezier_curve({{0, 0, 0}, {-1, -3, 3}}));
  CHECK_THROWS_AS(transformed(line, maps.back().first), DomainError);
}

TEST_CASE("transform: a map by the rows of its matrix") {
  const Vector<Rational> r{1, 10, 100};
  const std::vector<Rational> three{1, 2, 3, 4, 5, 6, 7, 8, 9};
  const std::vector<Rational> four{1, 2, 3, -1, 4, 5, 6, -2, 7, 8, 9, -3, 0, 0, 0, 1};
  CHECK(affine_map(three)(r) == Vector<Rational>{321, 654, 987});
  CHECK(affine_map(four)(r) == Vector<Rational>{320, 652, 984});
  CHECK(affine_map({four.begin(), four.begin() + 12}) == affine_map(four));
  CHECK_THROWS_AS(affine_map({four.begin(), four.begin() + 10}), DomainError);
  CHECK_THROWS_AS(affine_map(std::vector<Rational>(16, 1)), DomainError);
}

TEST_CASE("transform: a curve that goes on has parts before and behind [0, 1], too") {
  const Curve curve({{1}, {}, {}, {0, 1}});
  CHECK(segment(Path(curve), -1, 3) == Path(segment(curve, -1, 3)));
}

TEST_CASE("transform: a path runs backwards, and twice backwards is the path, with −A for A") {
  for (const Path& path : {of_three_kinds(), with_a_cusp(), Path(test::closed_loop())}) {
    const Path back = reversed(path);
    const Path again = reversed(back);
    for (std::size_t k = 0; k < path.segments().size(); ++k) {
      const Curve* ph = ph_curve(path.segments()[k]);  // turned over twice: A·j·j = −A
      CHECK(again.segments()[k] ==
            (ph == nullptr ? path.segments()[k]
                           : PhSegment(rotated(*ph, RationalQuaternion{-1, 0, 0, 0}))));
    }
    CHECK(joined(back.segments()) == back);
    for (long k = 0; k <= 8; ++k)
      CHECK(near_point(back, path.end() * Rational(k, 8)) ==
            near_point(path, path.end() * Rational(8 - k, 8)));
  }
}

TEST_CASE("transform: a part of a path has parts of its first and last segments") {
  const Path path = of_three_kinds();
  const Path part = segment(path, Rational(3, 2), Rational(7, 2));
  CHECK(joined(part.segments()) == part);
  REQUIRE(part.segments().size() == 3);
  CHECK(part.segments()[1] == path.segments()[2]);
  for (const auto& [now, before] : {std::pair<Rational, Rational>{0, {3, 2}},
                                    {{1, 2}, {7, 4}},
                                    {{3, 2}, {5, 2}},
                                    {{5, 2}, {13, 4}},
                                    {3, {7, 2}}})
    CHECK(near_point(part, now) == near_point(path, before));
  CHECK(segment(path, Rational(7, 2), Rational(3, 2)) == reversed(part));
  CHECK(segment(path, 1, 3).segments() ==
        std::vector<Segment>{path.segments()[1], path.segments()[2]});
  CHECK(segment(path, 0, 2).is_ph());
  CHECK_THROWS_AS(segment(path, 1, 1), DomainError);
  CHECK_THROWS_AS(segment(path, -1, 1), DomainError);
  CHECK_THROWS_AS(segment(path, 1, 5), DomainError);
  CHECK_THROWS_AS(scaled(path, 0), DomainError);
  CHECK_THROWS_AS(rotated(path, {}), DomainError);
}
