#include "phrame/ph/construct/near_plane_path.hpp"

#include <cmath>
#include <complex>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/ph/construct/bezier_points.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/curves.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace near_plane_path_test {
namespace {

using namespace phrame;
using test::Random;
using Point = std::complex<double>;

std::vector<Point> samples(const Path& path, long count) {
  std::vector<Point> points;
  for (const Segment& segment : path.segments())
    for (long k = 0; k <= count; ++k) {
      const auto p = point(*rational_curve(segment), Rational(k, count));
      points.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]));
    }
  return points;
}

double distance_to_line(Point p, Point a, Point b) {
  const Point way = b - a;
  const double square = std::norm(way);
  const double t =
      square > 0 ? std::clamp(((p - a) * std::conj(way)).real() / square, 0.0, 1.0) : 0.0;
  return std::abs(p - a - t * way);
}

/// The greatest distance of one of the points from a polyline.
double distance(const std::vector<Point>& points, const std::vector<Point>& line) {
  double greatest = 0;
  for (const Point p : points) {
    double least = 1e300;
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      least = std::min(least, distance_to_line(p, line[k], line[k + 1]));
    greatest = std::max(greatest, least);
  }
  return greatest;
}

/// ∮ x dy, by trapezoids.
double area(const std::vector<Point>& points) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    sum += (std::conj(points[k]) * points[k + 1]).imag() / 2;
  return sum;
}

Vector<Rational> random_point(Random& random) {
  const auto coordinate = [&] { return Rational(random.integer(-40, 40), 7); };
  return {coordinate(), coordinate(), 3};
}

/// Lines, cubics and conics, closed, half of the joints smooth.
Path any_path(Random& random) {
  const Vector<Rational> first = random_point(random);
  std::vector<Segment> segments;
  Vector<Rational> at = first;
  Vector<Rational> way = random_point(random) - at;
  const long count = random.integer(2, 5);
  for (long k = 0; k < count; ++k) {
    const Vector<Rational> to = k + 1 < count ? random_point(random) : first;
    // Along the tangent before, or anywhere.
    const bool is_smooth = random.integer(0, 1) == 0;
    const Vector<Rational> next = is_smooth ? at + Rational(1, 3) * way : random_point(random);
    const Vector<Rational> other = random_point(random);
    switch (random.integer(0, 2)) {
      case 0:
        segments.emplace_back(bezier_curve({at, to}));
        way = to - at;
        break;
      case 1:
        segments.emplace_back(bezier_curve({at, next, other, to}));
        way = to - other;
        break;
      default:
        segments.emplace_back(bezier_curve({at, next, to}, {1, random.integer(1, 5), 2}));
        way = to - next;
    }
    at = to;
  }
  return joined(segments);
}

/// One whose tangent turns back nowhere at a joint, which is no path.
Path random_path(Random& random) {
  for (;;) {
    try {
      return any_path(random);
    } catch (const DomainError&) {
    }
  }
}

bool is_ph(const Path& path) { return path.with_preimages().has_value(); }

}  // namespace

TEST_CASE("near_plane_path: within epsilon, closed, smooth where the path is") {
  long corners = 0;
  test::for_samples(12, [&](Random& random) {
    const Path path = random_path(random);
    const Rational epsilon(1, random.integer(0, 1) == 0 ? 10 : 5000);
    const auto within = static_cast<double>(epsilon);
    CAPTURE(within);
    const NearPath near = near_plane_path(path, epsilon);
    const Path found(near.path);
    CHECK(is_ph(found));
    CHECK(near.nearness.distance <= epsilon);
    CHECK(path.ends_meet());
    CHECK(found.ends_meet());
    // No corner is new, and none but the least is lost.
    CHECK(found.corners().size() == path.corners().size());
    corners += static_cast<long>(found.corners().size());
    const auto given = samples(path, 200);
    const auto made = samples(found, 40);
    // A polyline through samples is off by the sagitta.
    const double sagitta = 1e-2 * within + 2e-3;
    CHECK(distance(given, made) < within + sagitta);
    CHECK(distance(made, given) < within + sagitta);
    double length = 0;
    for (std::size_t k = 0; k + 1 < given.size(); ++k) length += std::abs(given[k + 1] - given[k]);
    CHECK(std::abs(area(made) - area(given)) < length * (within + sagitta));
  });
  CHECK(corners > 0);
}

TEST_CASE("near_plane_path: what is PH stays, lines get rational tangents") {
  const Path path = joined({bezier_curve({{0, 0, 0}, {1, 1, 0}}),
                            bezier_curve({{1, 1, 0}, {2, 2, 0}, {3, 1, 0}}, {1, 1, 2}),
                            PhSegment(Curve({{1}, {}, {}, {-1}}, Polynomial{3}, {3, 1, 0}))});
  const NearPath near = near_plane_path(path, Rational(1, 1'000'000));
  const auto& segments = near.path.segments();
  CHECK(preimage_degree(segments.front()) == 0);
  CHECK(hodograph(segments.back()) == Vector<Polynomial>{Polynomial{}, Polynomial{-6}, {}});
  CHECK(near.path.corners().size() == path.corners().size());
}

TEST_CASE("near_plane_path: a corner that rounding makes is smooth, and closing, too") {
  const Rational k = Rational(5522847498L, 10'000'000'000L);
  const Rational off(1, 1'000'000);
  const Path circle = joined({bezier_curve({{1, 0, 0}, {1, k, 0}, {k, 1, 0}, {0, 1, 0}}),
                              bezier_curve({{0, 1, 0}, {-k, 1 + off, 0}, {-1, k, 0}, {-1, 0, 0}}),
                              bezier_curve({{-1, 0, 0}, {off - 1, -k, 0}, {0, -1, 0}, {1, 0, 0}})});
  CHECK(circle.corners().size() == 2);
  const NearPath near = near_plane_path(circle, Rational(1, 10'000));
  CHECK(near.path.corners().empty());
  CHECK(Path(near.path).closes_at_corner());
}

// A cubic that turns back at once, and one whose ends have no speed.
TEST_CASE("near_plane_path: through cusps") {
  for (const Path& path : {Path(bezier_curve({{0, 0, 0}, {4, 4, 0}, {0, 4, 0}, {4, 0, 0}})),
                           Path(bezier_curve({{0, 0, 0}, {0, 0, 0}, {3, 5, 0}, {3, 5, 0}})),
                           Path(bezier_curve({{0, 0, 0}, {0, 0, 0}, {3, 5, 0}, {4, 0, 0}})),
                           Path(bezier_curve({{0, 0, 0}, {5, 5, 0}, {1, 1, 0}}))}) {
    const Rational epsilon(1, 1000);
    const NearPath near = near_plane_path(path, epsilon);
    const auto given = samples(path, 1000);
    const auto made = samples(Path(near.path), 40);
    CHECK(distance(given, made) < 1.01e-3);
    CHECK(distance(made, given) < 1.01e-3);
  }
}

TEST_CASE("near_plane_path: what it refuses") {
  const Path line(bezier_curve({{0, 0, 0}, {1, 1, 0}}));
  CHECK_THROWS_WITH_AS(near_plane_path(line, 0), "PH path nearby: epsilon is not positive",
                       DomainError);
  CHECK_THROWS_WITH_AS(near_plane_path(Path(bezier_curve({{0, 0, 0}, {1, 1, 1}})), 1),
                       "segment 1 is not in a plane z = const", DomainError);
  CHECK_THROWS_WITH_AS(
      near_plane_path(Path(test::expression_curve({"s", "exp(s)", "0"}, "0", "1")), 1),
      "segment 1 is given by formulas", DomainError);
  CHECK_THROWS_AS(near_plane_path(line, parse_rational("1e-40")), Undecided);
}

TEST_CASE("near_ph_path: of the same degrees where there is one") {
  Curve curve({{1, 2}, {}, {}, {0, 1}});
  BezierPoints points = bezier_points(hodograph(curve), curve.start());
  points[1][0] += Rational(1, 100'000'000);
  const NamedPath named("n", Path(bezier_curve(points)));
  CHECK(near_ph_path(named, Rational(1, 1'000'000)).path.segments().size() == 1);
  CHECK(near_ph_path({"n", Path(curve)}, Rational(1, 1'000'000)).path == PhPath(curve));
  points[1][0] += 3;
  const NamedPath other("n", Path(bezier_curve(points)));
  CHECK(near_ph_path(other, Rational(1, 1'000'000)).path.segments().size() > 1);
}

}  // namespace near_plane_path_test
